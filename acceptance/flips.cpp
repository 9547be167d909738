#include "acceptance/flips.h"

#include <memory>

#include "acceptance/evaluate.h"
#include "core/error.h"

namespace acceptance {

namespace {

namespace fs = std::filesystem;

/// A package that cannot be read is another's concern: its test says so when it runs.
bool names(const specs::AcceptanceTest& test, const fs::path& folder, const model::Experiment& experiment) {
  if (test.experiment.empty()) return false;
  try {
    const model::Experiment own = model::readExperiment(folder / test.experiment);
    return own.id == experiment.id || fs::weakly_canonical(own.file) == fs::weakly_canonical(experiment.file);
  } catch (const core::InputError&) {
    return false;
  }
}

}  // namespace

std::vector<specs::AcceptanceTest> testsOf(const specs::ProjectStore& store, const model::Experiment& experiment) {
  std::vector<specs::AcceptanceTest> tests = store.all<specs::AcceptanceTest>();
  std::erase_if(tests, [&](const specs::AcceptanceTest& test) {
    return test.status == specs::Status::Rejected || !names(test, store.folder(), experiment);
  });
  return tests;
}

std::vector<gap::TwiceJudgedTest> judgeTwice(const specs::ProjectStore& store, const model::Experiment& experiment,
                                             const ModelPair& models, std::optional<std::uint64_t> seed,
                                             core::Progress& progress) {
  const std::shared_ptr<const model::LidarModel> pair[] = {std::make_shared<model::LidarModel>(models.before),
                                                           std::make_shared<model::LidarModel>(models.after)};
  const std::vector<specs::AcceptanceTest> tests = testsOf(store, experiment);
  const double runs = 2.0 * static_cast<double>(tests.size());
  std::vector<gap::TwiceJudgedTest> judged;
  for (const specs::AcceptanceTest& test : tests) {
    TestResult results[2];
    for (std::size_t i = 0; i < 2; ++i) {
      core::stopIfCancelled(progress);
      const double done = 2.0 * static_cast<double>(judged.size()) + static_cast<double>(i);
      core::PartOfProgress part(progress, done / runs, (done + 1.0) / runs);
      TestTask task;
      task.test = test;
      task.folder = store.folder();
      task.lidar = pair[i];
      task.seed = seed;
      results[i] = evaluate(task, part);
    }
    judged.push_back({test.id, test.title, test.measurand, std::string(specs::name(results[0].verdict)),
                      std::string(specs::name(results[1].verdict)), results[0].text, results[1].text});
  }
  return judged;
}

}  // namespace acceptance
