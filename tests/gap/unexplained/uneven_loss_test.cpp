#include "gap/unexplained/uneven_loss.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "core/detection_files/detection_file.h"
#include "gap/diagnosis.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

// A random loss takes echoes from every shot alike. What is lost in some directions only, it does not explain.
namespace {

using test_support::hypothesisNamed;
using test_support::SmallWorld;

class Losses : public testing::Test {
 protected:
  /// What the model itself measures, without so many of a hundred echoes of every third two degrees of azimuth.
  [[nodiscard]] model::Experiment lostInStripes(unsigned of_hundred = 30) const {
    model::Experiment experiment = world_.measuredBy(model_, 0.4);
    std::mt19937 random(1);
    for (const model::Sample& sample : experiment.samples) {
      const core::Detections whole = model::readMeasurements(experiment, sample);
      std::vector<std::size_t> kept;
      for (std::size_t i = 0; i < whole.size(); ++i) {
        const double azimuth_deg = whole.azimuth_rad[i] * 180.0 / std::numbers::pi;
        const bool in_stripe = static_cast<int>(std::floor(azimuth_deg / 2.0 + 300.0)) % 3 == 0;
        if (!in_stripe || random() % 100 >= of_hundred) kept.push_back(i);
      }
      core::writeDetections(sample.measurements, core::selected(whole, kept));
    }
    return experiment;
  }
  [[nodiscard]] model::Experiment lostAnywhere() const {
    return world_.measuredBy(SmallWorld::modelWith({{"detection-loss", {{"probability", 0.1}}}}), 0.4);
  }
  /// In the eyes of a cause with these values.
  [[nodiscard]] std::optional<gap::UnevenLoss> seenIn(const model::Experiment& experiment, const std::string& cause,
                                                      const std::vector<double>& values) const {
    const gap::Replay replay(experiment, model_);
    const gap::Split split = gap::splitOf(replay, 1);
    const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
    return gap::unevenLossIn(judge, {hypothesisNamed(gap::hypothesesFor(replay, {}), cause), values});
  }

  SmallWorld world_;
  model::LidarModel model_ = SmallWorld::modelWith({});
};

TEST_F(Losses, InStripesAreUneven) {
  const auto loss = seenIn(lostInStripes(), "detection-loss", {0.1});
  ASSERT_TRUE(loss);
  EXPECT_NEAR(loss->mean, 0.1, 0.01);
  EXPECT_NEAR(loss->stddev, 0.3 * std::sqrt(2.0 / 9.0), 0.02);  // of 0.3 in a third of the beams
  EXPECT_NEAR(loss->unhurt, 2.0 / 3.0, 0.05);
  EXPECT_NEAR(loss->period_deg.value_or(0.0), 6.0, 0.2);
}

// No beam loses enough to stand out; six degrees from stripe to stripe do.
TEST_F(Losses, ThatAreRareShowInStripes) {
  const auto loss = seenIn(lostInStripes(3), "detection-loss", {0.01});
  ASSERT_TRUE(loss);
  EXPECT_LT(loss->z, 6.0);
  ASSERT_TRUE(loss->period_deg);
  EXPECT_NEAR(*loss->period_deg, 6.0, 0.3);
}

TEST_F(Losses, AtRandomAreEven) { EXPECT_FALSE(seenIn(lostAnywhere(), "detection-loss", {0.1})); }

// Were only half as many lost as the cause says, that would be a wrong number and no pattern.
TEST_F(Losses, OfAnotherNumberAreStillEven) { EXPECT_FALSE(seenIn(lostAnywhere(), "detection-loss", {0.2})); }

// A model that loses echoes at random has the number that would be wrong if it lost too few of them.
TEST_F(Losses, InStripesAreNoWrongRateOfALossThatTheModelHas) {
  model_ = SmallWorld::modelWith({{"detection-loss", {{"probability", 0.02}}}});
  const auto loss = seenIn(lostInStripes(), "/effects/detection-loss/probability", {0.12});
  ASSERT_TRUE(loss);
  EXPECT_NEAR(loss->mean, 0.12, 0.01);
  EXPECT_NEAR(loss->period_deg.value_or(0.0), 6.0, 0.2);
}

TEST_F(Losses, OfACauseThatDoesNotTakeThemEverywhereAreNotAsked) {
  EXPECT_FALSE(seenIn(lostInStripes(), "range-offset", {0.1}));
}

TEST_F(Losses, InStripesAreNoRandomLoss) {
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis = gap::diagnose(lostInStripes(), model_, {}, progress);
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kUnknown);
  EXPECT_THAT(diagnosis.verdict.text, testing::StartsWith("They differ in what is lost"));
  EXPECT_THAT(diagnosis.notes, testing::Contains(testing::HasSubstr("Echoes are lost unevenly")));
}

}  // namespace
