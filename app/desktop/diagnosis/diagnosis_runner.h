#pragma once

#include "app/desktop/background_work.h"
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
class DiagnosisRunner final : public BackgroundWork {
  Q_OBJECT

 public:
  explicit DiagnosisRunner(QObject* parent = nullptr) : BackgroundWork(parent) {}

  /// Do nothing while something is under way.
  void diagnose(const DiagnosisTask& task);
  void propose(const ProposeTask& task);

 signals:
  void diagnosed(const std::filesystem::path& report);  ///< the file is written
  void proposed(const proposals::Proposed& proposed);   ///< nothing is stored
};

}  // namespace desktop
