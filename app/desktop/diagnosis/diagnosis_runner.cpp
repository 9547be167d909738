#include "app/desktop/diagnosis/diagnosis_runner.h"

#include "acceptance/flips.h"
#include "app/desktop/guarded_work.h"
#include "app/desktop/window_progress.h"
#include "core/json_object.h"
#include "gap/chain.h"
#include "gap/report_json.h"

namespace desktop {

namespace {

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

DiagnosisRunner::DiagnosisRunner(QObject* parent) : QObject(parent) {}

DiagnosisRunner::~DiagnosisRunner() {
  cancel();
  if (thread_) thread_->wait();
}

void DiagnosisRunner::cancel() {
  if (stop_) *stop_ = true;
}

void DiagnosisRunner::diagnose(const DiagnosisTask& task) {
  start([task](core::Progress& progress) { writeDiagnosis(task, progress); },
        [this, task] { emit diagnosed(task.report); }, task.experiment);
}

void DiagnosisRunner::propose(const ProposeTask& task) {
  auto outcome = std::make_shared<proposals::Proposed>();
  start(
      [task, outcome](core::Progress& progress) {
        *outcome = proposals::propose(task.report, {task.specification, task.graph, task.folder}, {}, progress);
        core::stopIfCancelled(progress);
      },
      [this, outcome] { emit proposed(*outcome); }, task.report.file);
}

void DiagnosisRunner::start(std::function<void(core::Progress&)> work, std::function<void()> done,
                            const std::filesystem::path& file) {
  if (isRunning()) return;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  auto error = std::make_shared<std::optional<core::InputError>>();
  const auto tell = [this](double fraction, const QString& doing) {
    QMetaObject::invokeMethod(
        this, [this, fraction, doing] { emit progressed(fraction, doing); }, Qt::QueuedConnection);
  };
  auto finished = std::make_shared<bool>(false);
  thread_.reset(QThread::create([work = std::move(work), file, error, finished, tell, stop = stop_] {
    WindowProgress progress(stop, tell);
    const auto run = [&] {
      work(progress);
      *finished = true;
    };
    *error = errorOf(run, file, "Nothing was stored. Please report it, with the file if you may.");
  }));
  connect(thread_.get(), &QThread::finished, this, [this, error, finished, done = std::move(done)] {
    thread_.release()->deleteLater();
    if (*error) {
      emit failed(**error);
    } else if (*finished) {
      done();
    } else {
      emit cancelled();
    }
  });
  thread_->start();
}

}  // namespace desktop
