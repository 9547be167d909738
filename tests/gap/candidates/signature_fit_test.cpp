#include "gap/candidates/signature_fit.h"

#include <gtest/gtest.h>

#include "gap/causes/fit.h"
#include "gap/causes/split.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

// Fog took a part of the light, and whoever calibrated the emitter's power to the mean put nearly all of it back.
namespace {

using test_support::SmallWorld;

class SignatureFit : public testing::Test {
 protected:
  SignatureFit()
      : measured_(
            world_.measuredBy(SmallWorld::modelWith({{"atmospheric-attenuation", {{"visibility_m", 1000}}}}), 0.4)),
        replay_(measured_, SmallWorld::modelWith({}, {{"/sensor/emitter/peak_power_w", 46}})),
        space_(replay_, gap::splitOf(replay_, 1).fitted.samples, 4, 1, 100.0),
        both_(gap::together(hypothesis("atmospheric-attenuation"), hypothesis("/sensor/emitter/peak_power_w"))) {}

  [[nodiscard]] gap::Hypothesis hypothesis(const std::string& name) const {
    return test_support::hypothesisNamed(gap::hypothesesFor(replay_, {"atmospheric-attenuation"}), name);
  }

  SmallWorld world_;
  model::Experiment measured_;
  gap::Replay replay_;
  gap::SignatureSpace space_;
  gap::Hypothesis both_;
};

TEST_F(SignatureFit, FollowsTheValleyBetweenACauseAndTheCalibrationThatHidesIt) {
  const auto fitted = gap::signatureFitFrom(replay_, space_, both_, {3000.0, 47.5}, core::SilentProgress());
  EXPECT_NEAR(fitted[0], 1000.0, 150.0);
  EXPECT_NEAR(fitted[1], 50.0, 0.8);
}

TEST_F(SignatureFit, LeavesEndsOfASectorAndCountsWhereTheyAre) {
  gap::Hypothesis stepwise = both_;
  stepwise.parameters[0].whole = true;
  stepwise.parameters[1].azimuth = true;
  const std::vector<double> start{3000.0, 47.5};
  EXPECT_EQ(gap::signatureFitFrom(replay_, space_, stepwise, start, core::SilentProgress()), start);
}

}  // namespace
