#include "gap/which/direction_law.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

#include "core/detection_files/detection_file.h"
#include "gap/diagnosis.h"
#include "gap/report/rest_wording.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

// A gain that changes evenly over the scan is no effect of the library, though one of enough numbers makes nearly as
// much of it.
namespace {

using test_support::hypothesisNamed;
using test_support::SmallWorld;

constexpr double kPerDegree = 0.004;

class Directions : public testing::Test {
 protected:
  /// What the model itself measures, its widths stretched by so much a degree of azimuth.
  [[nodiscard]] model::Experiment stretchedOverAzimuth() const {
    model::Experiment experiment = world_.measuredBy(model_, 0.4);
    for (const model::Sample& sample : experiment.samples) {
      core::Detections detections = model::readMeasurements(experiment, sample);
      for (std::size_t i = 0; i < detections.size(); ++i)
        detections.epw_m[i] *= 1.0 + kPerDegree * detections.azimuth_rad[i] * 180.0 / std::numbers::pi;
      core::writeDetections(sample.measurements, detections);
    }
    return experiment;
  }
  [[nodiscard]] model::Experiment dirtyOnOneSide() const {
    return world_.measuredBy(
        SmallWorld::modelWith(
            {{"cover-contamination", {{"attenuation", 0.5}, {"azimuth_from_deg", 3.0}, {"azimuth_to_deg", 40.0}}}}),
        0.4);
  }
  /// Beside a cause with these values.
  [[nodiscard]] std::optional<gap::Law> lawIn(const model::Experiment& experiment, const std::string& cause,
                                              const std::vector<double>& values) const {
    const gap::Replay replay(experiment, model_);
    const gap::Split split = gap::splitOf(replay, 1);
    const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
    const gap::Candidate candidate{hypothesisNamed(gap::hypothesesFor(replay, {}), cause), values};
    const gap::WhereResult before = gap::whereIn(replay, replay.baseline(), 1);
    const gap::WhereResult after = gap::whereIn(replay, gap::worldOf(replay, candidate.hypothesis, values), 1);
    return gap::directionLawIn(judge, candidate, before, after);
  }

  SmallWorld world_;
  model::LidarModel model_ = SmallWorld::modelWith({});
};

TEST_F(Directions, ThatStretchWidthsEvenlyAreALawOfPartsOfTheWidth) {
  const auto law = lawIn(stretchedOverAzimuth(), "cover-contamination", {0.1, 0.0, 40.0});
  ASSERT_TRUE(law);
  EXPECT_EQ(law->measurand, "epw");
  EXPECT_TRUE(law->relative);
  ASSERT_EQ(law->terms.size(), 1U);
  EXPECT_EQ(law->terms.front().covariate, "azimuth_deg");
  EXPECT_EQ(law->terms.front().function, "x");
  EXPECT_NEAR(law->terms.front().coefficient, kPerDegree, 0.1 * kPerDegree);
  EXPECT_NEAR(law->constant, 0.0, 0.01);
}

TEST_F(Directions, DescribeASectorWorseThanTheSector) {
  EXPECT_FALSE(lawIn(dirtyOnOneSide(), "cover-contamination", {0.5, 3.0, 40.0}));
}

// Another sector than the true one leaves what a straight line leaves, or more.
TEST_F(Directions, DescribeASectorBetterThanAWrongOne) {
  EXPECT_TRUE(lawIn(dirtyOnOneSide(), "cover-contamination", {0.5, -40.0, -3.0}));
}

TEST_F(Directions, ThatStretchWidthsEvenlyAreNoCauseOfTheLibrary) {
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis = gap::diagnose(stretchedOverAzimuth(), model_, {}, progress);
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kUnknown);
  const gap::Law* pattern = gap::patternIn(diagnosis.verdict, diagnosis.rest);
  ASSERT_NE(pattern, nullptr);
  EXPECT_THAT(gap::patternText(*pattern), testing::HasSubstr("azimuth_deg) % of the expected value"));
}

}  // namespace
