#include "app/desktop/diagnosis/diagnosis_runner.h"

#include "acceptance/flips.h"
#include "core/json_object.h"
#include "gap/chain.h"
#include "gap/report/json.h"

namespace desktop {

namespace {

constexpr const char* kRemedy = "Nothing was stored. Please report it, with the file if you may.";
constexpr double kDiagnosis = 0.85;  // of the time; the acceptance tests take the rest

void writeDiagnosis(const DiagnosisTask& task, core::Progress& progress) {
  const auto experiment = model::readExperiment(task.experiment);
  const auto lidar = model::readModel(task.model);
  const auto project = specs::ProjectStore::open(task.project, specs::Access::ReadOnly);
  core::PartOfProgress diagnosing(progress, 0.0, kDiagnosis);
  gap::Diagnosis diagnosis =
      gap::diagnose(experiment, lidar, {.proxy = gap::chosenProxy(task.proxy, lidar)}, diagnosing);
  if (const auto graph = project.graph()) gap::addChains(diagnosis, *graph);
  core::PartOfProgress judging(progress, kDiagnosis, 1.0);
  if (!diagnosis.approximation && !diagnosis.proposed_model.is_null()) {
    diagnosis.acceptance_tests = acceptance::judgeTwice(
        project, experiment, {lidar, model::parseModel(diagnosis.proposed_model, lidar.file)}, {}, judging);
  }
  core::stopIfCancelled(progress);
  std::error_code ignored;
  std::filesystem::create_directories(task.report.parent_path(), ignored);  // writing says what is wrong
  core::writeJson(task.report, gap::reportJson(diagnosis));
}

}  // namespace

void DiagnosisRunner::diagnose(const DiagnosisTask& task) {
  start([task](core::Progress& progress) { writeDiagnosis(task, progress); },
        [this, task] { emit diagnosed(task.report); }, task.experiment, kRemedy);
}

void DiagnosisRunner::propose(const ProposeTask& task) {
  auto outcome = std::make_shared<proposals::Proposed>();
  start(
      [task, outcome](core::Progress& progress) {
        *outcome = proposals::propose(task.report, {task.specification, task.graph, task.folder}, {}, progress);
        core::stopIfCancelled(progress);
      },
      [this, outcome] { emit proposed(*outcome); }, task.report.file, kRemedy);
}

}  // namespace desktop
