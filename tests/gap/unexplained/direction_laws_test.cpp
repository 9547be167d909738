#include "gap/unexplained/direction_laws.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

#include "core/detection_files/detection_file.h"
#include "core/physics.h"
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
  /// What the model itself measures, but for a gain that grows by so much a degree of azimuth: a Gaussian pulse stays
  /// above the threshold for c·FWHM·√(log₂ of how often it exceeds it).
  [[nodiscard]] model::Experiment withAGainOverAzimuth() const {
    const double pulse_m = core::kMetresPerNanosecond * model_.sensor("").emitter.pulse_fwhm_ns;
    model::Experiment experiment = world_.measuredBy(model_, 0.4);
    for (const model::Sample& sample : experiment.samples) {
      core::Detections detections = model::readMeasurements(experiment, sample);
      for (std::size_t i = 0; i < detections.size(); ++i)
        detections.epw_m[i] = std::sqrt(
            detections.epw_m[i] * detections.epw_m[i] +
            pulse_m * pulse_m * std::log2(1.0 + kPerDegree * detections.azimuth_rad[i] * 180.0 / std::numbers::pi));
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
  [[nodiscard]] std::vector<gap::Law> lawsIn(const model::Experiment& experiment, const std::string& cause,
                                             const std::vector<double>& values) const {
    const gap::Replay replay(experiment, model_);
    const gap::Split split = gap::splitOf(replay, 1);
    const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
    const gap::Candidate candidate{hypothesisNamed(gap::hypothesesFor(replay, {}), cause), values};
    const gap::WhereResult before = gap::whereIn(replay, replay.baseline(), 1);
    const gap::WhereResult after = gap::whereIn(replay, gap::worldOf(replay, candidate.hypothesis, values), 1);
    return gap::directionLawsIn(judge, candidate, before, after);
  }

  SmallWorld world_;
  model::LidarModel model_ = SmallWorld::modelWith({});
};

TEST_F(Directions, ThatChangeAGainEvenlyAreALawOfPartsOfThePower) {
  const auto laws = lawsIn(withAGainOverAzimuth(), "cover-contamination", {0.1, 0.0, 40.0});
  ASSERT_EQ(laws.size(), 1U);
  const gap::Law& law = laws.front();
  EXPECT_EQ(law.measurand, "epw");
  EXPECT_TRUE(law.relative);
  ASSERT_EQ(law.terms.size(), 1U);
  EXPECT_EQ(law.terms.front().covariate, "azimuth_deg");
  EXPECT_EQ(law.terms.front().function, "x");
  EXPECT_NEAR(law.terms.front().coefficient, kPerDegree, 0.1 * kPerDegree);
  EXPECT_NEAR(law.constant, 0.0, 0.01);
}

TEST_F(Directions, DescribeASectorWorseThanTheSector) {
  EXPECT_TRUE(lawsIn(dirtyOnOneSide(), "cover-contamination", {0.5, 3.0, 40.0}).empty());
}

// Another sector than the true one leaves what a straight line leaves, or more.
TEST_F(Directions, DescribeASectorBetterThanAWrongOne) {
  EXPECT_FALSE(lawsIn(dirtyOnOneSide(), "cover-contamination", {0.5, -40.0, -3.0}).empty());
}

// Four layers have four gains, and a formula of three numbers describes most of that.
TEST_F(Directions, OfTheLayersAreNotAsked) {
  const auto uneven = world_.measuredBy(
      SmallWorld::modelWith({{"photo-response-nonuniformity", {{"gain_per_layer", {1.1, 0.95, 0.97, 1.1}}}}}), 0.4);
  EXPECT_TRUE(lawsIn(uneven, "range-offset", {0.0}).empty());
}

// A cloud of five numbers that leaves nothing of the widths, where a line of two does as much. That ranges scatter
// otherwise in a few beams with the cloud is no more than chance makes of sums over hundreds; in all beams it would be
// the cloud's doing.
TEST_F(Directions, ReckonWithChanceInHowValuesScatter) {
  const auto experiment = withAGainOverAzimuth();
  const gap::Replay replay(experiment, model_);
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const gap::Candidate cloud{hypothesisNamed(gap::hypothesesFor(replay, {}), "exhaust-cloud", "of another albedo"),
                             {0.1, 2.0, 0.5, 5.0, 0.0}};
  for (const std::size_t every : {100U, 1U}) {
    gap::WhereResult before = gap::whereIn(replay, replay.baseline(), 1);
    const auto valuesOf = [](gap::WhereResult& where, const char* measurand, const char* component, auto value) {
      for (gap::ResidualTable& table : where.tables)
        if (table.isOf(measurand, component))
          for (std::size_t i = 0; i < table.rows.size(); ++i) table.rows[i].value = value(i, table.rows[i].error);
    };
    gap::WhereResult after = before;
    valuesOf(after, "epw", "bias", [](std::size_t, double) { return 0.0; });
    valuesOf(before, "range", "scatter",
             [&](std::size_t i, double error) { return i % every == 0 ? 3.0 * error : error; });
    valuesOf(after, "range", "scatter", [](std::size_t, double error) { return error; });
    EXPECT_EQ(gap::directionLawsIn(judge, cloud, before, after).empty(), every == 1) << "one of " << every << " beams";
  }
}

TEST_F(Directions, ThatChangeAGainEvenlyAreNoCauseOfTheLibrary) {
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis = gap::diagnose(withAGainOverAzimuth(), model_, {}, progress);
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kUnknown);
  const gap::Law* pattern = gap::patternIn(diagnosis.verdict, diagnosis.rest);
  ASSERT_NE(pattern, nullptr);
  EXPECT_THAT(gap::patternText(*pattern), testing::HasSubstr("azimuth_deg) % of the received power"));
}

}  // namespace
