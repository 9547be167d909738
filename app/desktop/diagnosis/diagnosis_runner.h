#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/progress.h"
#include "proposals/propose.h"

namespace desktop {

/// What is diagnosed, and where its report goes.
struct DiagnosisTask {
  std::filesystem::path experiment;
  std::filesystem::path model;
  std::filesystem::path proxy;    ///< built-in model that stands for one that is not; empty: as the model file says
  std::filesystem::path project;  ///< its graph and its acceptance tests are looked at
  std::filesystem::path report;   ///< JSON that is written
};

/// What is proposed from a report; everything is a copy, so that the window may change its own meanwhile.
struct ProposeTask {
  proposals::GapReport report;
  specs::Specification specification;
  percollect::Graph graph;
  std::filesystem::path folder;
};

/// Diagnoses and proposes in a thread of its own, one thing at a time. What came out is handed back in the thread of
/// the window.
class DiagnosisRunner final : public QObject {
  Q_OBJECT

 public:
  explicit DiagnosisRunner(QObject* parent = nullptr);
  ~DiagnosisRunner() override;  ///< cancels and waits

  /// Do nothing while something is under way.
  void diagnose(const DiagnosisTask& task);
  void propose(const ProposeTask& task);
  void cancel();
  [[nodiscard]] bool isRunning() const noexcept { return thread_ != nullptr; }

 signals:
  void progressed(double fraction, const QString& doing);
  void diagnosed(const std::filesystem::path& report);  ///< the file is written
  void proposed(const proposals::Proposed& proposed);   ///< nothing is stored
  void failed(const core::InputError& error);
  void cancelled();

 private:
  /// `work` runs in the thread, `done` in the window's if nothing went wrong.
  void start(std::function<void(core::Progress&)> work, std::function<void()> done, const std::filesystem::path& file);

  std::unique_ptr<QThread> thread_;
  std::shared_ptr<std::atomic<bool>> stop_;
};

}  // namespace desktop
