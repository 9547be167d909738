#include "app/desktop/test_runner.h"

#include "acceptance/run.h"
#include "app/desktop/guarded_work.h"
#include "app/desktop/window_progress.h"
#include "specs/project_store.h"

namespace desktop {

namespace {

/// What the thread leaves behind; one of them, or neither if it was cancelled.
struct Outcome {
  std::optional<acceptance::RunResult> result;
  std::optional<core::InputError> error;
};

}  // namespace

TestRunner::TestRunner(QObject* parent) : QObject(parent) {}

TestRunner::~TestRunner() {
  cancel();
  if (thread_) thread_->wait();
}

void TestRunner::cancel() {
  if (stop_) *stop_ = true;
}

void TestRunner::start(const std::filesystem::path& project, const std::vector<std::string>& tests) {
  if (isRunning()) return;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  auto outcome = std::make_shared<Outcome>();
  const auto tell = [this](double fraction, const QString& doing) {
    QMetaObject::invokeMethod(
        this, [this, fraction, doing] { emit progressed(fraction, doing); }, Qt::QueuedConnection);
  };
  thread_.reset(QThread::create([project, tests, outcome, tell, stop = stop_] {
    WindowProgress progress(stop, tell);
    const auto run = [&] {
      const auto store = specs::ProjectStore::open(project, specs::Access::ReadOnly);
      outcome->result = acceptance::runTests(store, {.tests = tests, .model = {}, .seed = {}}, progress);
    };
    outcome->error = errorOf(run, project, "Nothing was stored. Please report it, with the project if you may.");
  }));
  connect(thread_.get(), &QThread::finished, this, [this, outcome] {
    thread_.release()->deleteLater();
    if (outcome->error) {
      emit failed(*outcome->error);
    } else if (outcome->result) {
      emit finished(*outcome->result);
    } else {
      emit cancelled();
    }
  });
  thread_->start();
}

}  // namespace desktop
