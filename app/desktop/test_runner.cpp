#include "app/desktop/test_runner.h"

#include "acceptance/run.h"
#include "specs/project_store.h"

namespace desktop {

void TestRunner::start(const std::filesystem::path& project, const std::vector<std::string>& tests) {
  auto result = std::make_shared<acceptance::RunResult>();
  BackgroundWork::start(
      [project, tests, result](core::Progress& progress) {
        const auto store = specs::ProjectStore::open(project, specs::Access::ReadOnly);
        *result = acceptance::runTests(store, {.tests = tests, .model = {}, .seed = {}}, progress);
      },
      [this, result] { emit finished(*result); }, project,
      "Nothing was stored. Please report it, with the project if you may.");
}

}  // namespace desktop
