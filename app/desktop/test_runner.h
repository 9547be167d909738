#pragma once

#include <string>
#include <vector>

#include "acceptance/result.h"
#include "app/desktop/background_work.h"

namespace desktop {

/// Runs acceptance tests in a thread of its own, on a connection of its own that only reads. What came out is handed
/// back in the thread of the window, which stores it.
class TestRunner final : public BackgroundWork {
  Q_OBJECT

 public:
  explicit TestRunner(QObject* parent = nullptr) : BackgroundWork(parent) {}

  /// `tests`: shown ids; empty: all that are not rejected. Does nothing while a run is under way.
  void start(const std::filesystem::path& project, const std::vector<std::string>& tests);

 signals:
  void finished(const acceptance::RunResult& result);
};

}  // namespace desktop
