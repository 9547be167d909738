#include "acceptance/flips.h"

#include <gtest/gtest.h>

#include "tests/acceptance/small_project.h"

namespace acceptance {
namespace {

using acceptance_test::SmallProject;

class Flips : public ::testing::Test {
 protected:
  std::vector<gap::TwiceJudgedTest> judged() {
    core::SilentProgress progress;
    const auto before = model::readModel(project.folder() / "model.json");
    const auto after = model::withEffect(before, {"range-offset", {.numbers = {{"offset_m", 0.2}}}, {}});
    return judgeTwice(project.open(), experiment(), {before, after}, {}, progress);
  }
  [[nodiscard]] model::Experiment experiment() const { return model::readExperiment(project.folder() / "wall"); }

  // Measured ranges lie 0.2 m too far; the second model knows it.
  SmallProject project{{.offset_m = 0.2}};
};

TEST_F(Flips, ATestThatTheMissingOffsetFailsPassesWithIt) {
  project.addTest("RangeError_Wall_1", "abs(d_bias) <= 0.05");
  project.addTest("RangeError_Wall_2", "abs(d_bias) <= 5");
  const auto tests = judged();
  ASSERT_EQ(tests.size(), 2u);
  EXPECT_EQ(tests[0].before, "failed");
  EXPECT_EQ(tests[0].after, "passed");
  EXPECT_TRUE(tests[0].flips());
  EXPECT_EQ(tests[1].before, "passed");
  EXPECT_FALSE(tests[1].flips());
}

TEST_F(Flips, NothingIsStored) {
  project.addTest("RangeError_Wall_1", "abs(d_bias) <= 0.05");
  (void)judged();
  EXPECT_TRUE(project.open().latestRuns().empty());
}

TEST_F(Flips, OnlyTestsOfTheExperimentCount) {
  specs::ProjectStore store = project.open();
  auto test = SmallProject::rangeTest("RangeError_Wall_1", "abs(d_bias) <= 0.05");
  test.experiment = "nowhere";
  store.add(test, acceptance_test::kSomebody);
  test.id = "RangeError_Wall_2";
  test.experiment = "wall/experiment.json";
  store.add(test, acceptance_test::kSomebody);
  test.id = "RangeError_Wall_3";
  test.status = specs::Status::Rejected;
  store.add(test, acceptance_test::kSomebody);
  ASSERT_EQ(testsOf(store, experiment()).size(), 1u);
  EXPECT_EQ(testsOf(store, experiment())[0].id, "RangeError_Wall_2");
}

}  // namespace
}  // namespace acceptance
