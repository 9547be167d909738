#include <gtest/gtest.h>

#include "core/json_object.h"
#include "gap/diagnosis.h"
#include "model/lidar_model.h"
#include "tests/support/paths.h"

// The visible cases of an independent generator: what was withheld must be named.
namespace {

class SharedCase : public testing::TestWithParam<const char*> {};

TEST_P(SharedCase, WithheldCauseIsNamed) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto folder = shared / "experiments" / GetParam();
  const auto experiment = model::readExperiment(folder);
  const auto model = model::readModel(folder / "model.json");
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis = gap::diagnose(experiment, model, {}, progress);
  const auto truth = core::readJson(shared / "experiments" / "truth.json");
  bool known = false;
  for (const auto& item : truth["cases"]) {
    if (item["id"] != GetParam()) continue;
    known = true;
    EXPECT_EQ(gap::toString(diagnosis.verdict.kind), item["kind"].get<std::string>()) << diagnosis.verdict.text;
    EXPECT_EQ(diagnosis.verdict.names, item["names"].get<std::vector<std::string>>());
    // Same definition of the total gap, other noise and other sub-ray grids: within a tenth, plus the noise floor.
    const double expected = item["gap"]["before"]["total"].get<double>();
    EXPECT_NEAR(diagnosis.before.total, expected, 0.1 * expected + 0.3);
    if (diagnosis.after) {
      EXPECT_NEAR(diagnosis.shrink.fraction, item["gap"]["shrink"].get<double>(), 0.08);
    }
    // An effect outside the library that repeats itself: what is left is described, though nothing is named.
    if (const auto& parameters = item["parameters"]; parameters.contains("period_m")) {
      ASSERT_TRUE(diagnosis.rest && !diagnosis.rest->laws.empty());
      const gap::Law::Term& wave = diagnosis.rest->laws.front().terms.front();
      EXPECT_EQ(wave.covariate, "range_m");
      EXPECT_NEAR(wave.period, parameters["period_m"].get<double>(), 0.005);
      EXPECT_NEAR(wave.coefficient, parameters["amplitude_m"].get<double>(), 0.0015);
    }
  }
  EXPECT_TRUE(known) << "truth.json has no case " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Visible, SharedCase, testing::Values("v01", "v02", "v03", "v04", "v05", "v06"),
                         [](const auto& which) { return std::string(which.param); });

}  // namespace
