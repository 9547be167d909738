#include "gap/hypotheses.h"

#include <gtest/gtest.h>
#include <map>

#include "tests/gap/small_world.h"

// A number of the model file is searched in the unit that the ending of its name says.
namespace {

using test_support::SmallWorld;

TEST(Hypotheses, AWrongNumberOfTheModelHasTheUnitOfItsKey) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({{"mounting-error", {{"yaw_deg", 0.3}}},
                                            {"atmospheric-attenuation", {{"visibility_m", 400}}},
                                            {"detection-loss", {{"probability", 0.1}}}});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  std::map<std::string, std::string> units;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {})) {
    if (hypothesis.kind == gap::CauseKind::kParameter) units[hypothesis.name] = hypothesis.parameters.at(0).unit;
  }
  const std::map<std::string, std::string> expected = {{"/sensor/emitter/peak_power_w", "W"},
                                                       {"/sensor/emitter/pulse_fwhm_ns", "ns"},
                                                       {"/sensor/emitter/divergence_rad/horizontal", "rad"},
                                                       {"/sensor/emitter/divergence_rad/vertical", "rad"},
                                                       {"/sensor/receiver/noise_w", "W"},
                                                       {"/sensor/receiver/threshold_w", "W"},
                                                       {"/sensor/detection/range_noise_m", "m"},
                                                       {"/sensor/detection/epw_noise_m", "m"},
                                                       {"/effects/mounting-error/yaw_deg", "deg"},
                                                       {"/effects/atmospheric-attenuation/visibility_m", "m"},
                                                       {"/effects/detection-loss/probability", ""}};
  for (const auto& [pointer, unit] : expected) {
    ASSERT_TRUE(units.contains(pointer)) << pointer;
    EXPECT_EQ(units.at(pointer), unit) << pointer;
  }
}

}  // namespace
