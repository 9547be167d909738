#include "gap/unexplained/frame_mode.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/detection_files/detection_file.h"
#include "gap/diagnosis.h"
#include "tests/gap/small_world.h"

// Frames that do not repeat each other: whatever causes that, no effect of the library does.
namespace {

using test_support::SmallWorld;

class Frames : public testing::Test {
 protected:
  /// What the model itself measures, every second frame of it farther than the others by twice this, as of a scanner
  /// whose mirror has two facets.
  [[nodiscard]] model::Experiment alternating(double deviation_m) const {
    model::Experiment experiment = world_.measuredBy(model_, 0.4);
    for (const model::Sample& sample : experiment.samples) {
      core::Detections detections = model::readMeasurements(experiment, sample);
      for (std::size_t i = 0; i < detections.size(); ++i)
        detections.range_m[i] += detections.frame[i] % 2 == 0 ? -deviation_m : deviation_m;
      core::writeDetections(sample.measurements, detections);
    }
    return experiment;
  }
  /// Beside a cause of these effects.
  [[nodiscard]] std::optional<gap::FrameMode> modeOf(const model::Experiment& experiment,
                                                     const SmallWorld::Effects& cause = {}) const {
    const gap::Replay replay(experiment, model_);
    const gap::Split split = gap::splitOf(replay, 1);
    std::optional<gap::World> with_cause;
    if (!cause.empty()) with_cause.emplace(replay.baseline()).model = SmallWorld::modelWith(cause);
    return gap::frameModeOf({replay, split, gap::yardstickOf(replay, split.held_out)}, with_cause);
  }

  SmallWorld world_;
  model::LidarModel model_ = SmallWorld::modelWith({});
};

TEST_F(Frames, ThatAlternateAreSeenWithTheirDeviationAndAreTheWholeGap) {
  const auto mode = modeOf(alternating(0.03));
  ASSERT_TRUE(mode);
  EXPECT_EQ(mode->channel, gap::kRange);
  // Twenty frames of ±0.03 m have a standard deviation of 0.03 √(20/19) m.
  EXPECT_NEAR(mode->stddev, 0.0308, 0.001);
  EXPECT_GT(mode->share_of_gap, 0.9);
}

// A twelfth of the noise: each of the 164 detections of a frame tells next to nothing, and so do the two samples held
// out, with 4.5 standard deviations; all six have 7.8 on average.
TEST_F(Frames, ThatAlternateALittleAreSeenInAllSamplesTogether) { EXPECT_TRUE(modeOf(alternating(0.0013))); }

// Half as much in square: no sample shows it by itself, but frames of one number are alike in all.
TEST_F(Frames, ThatAreAlikeInAllSamplesAreSeenThoughNoneShowsThemByItself) {
  const auto mode = modeOf(alternating(0.0009));
  ASSERT_TRUE(mode);
  EXPECT_GT(mode->span_in_all_samples, 0.0009);
  EXPECT_LT(mode->span_in_all_samples, 0.0036);  // with what the noise adds
}

// Clouds of spray hang elsewhere in every frame, between the sensor and a low vehicle that drives away at 100 km/h, and
// take more of the wall's light in one frame than in the next. Random losses are alike in all.
TEST_F(Frames, ThatACauseMakesUnlikeEachOtherAreNot) {
  model::Experiment experiment = world_.measuredBy(model_, 0.4);
  nlohmann::json vehicle = experiment.json["scene"][0];
  vehicle["id"] = "vehicle";
  vehicle["shape"] = {{"type", "box"}, {"size_m", {1.0, 1.8, 1.0}}};
  vehicle["pose"]["position_m"] = {6.0, 0.0, -1.5};
  vehicle["velocity_m_s"] = {27.8, 0.0, 0.0};
  experiment.json["scene"].push_back(vehicle);
  for (const model::Sample& sample : experiment.samples) {
    core::Detections detections = model::readMeasurements(experiment, sample);
    for (std::size_t i = 0; i < detections.size(); ++i)
      detections.intensity[i] *= detections.frame[i] % 2 == 0 ? 0.95 : 1.05;
    core::writeDetections(sample.measurements, detections);
  }
  const auto beside_losses = modeOf(experiment, {{"detection-loss", {{"probability", 0.1}}}});
  ASSERT_TRUE(beside_losses);
  EXPECT_EQ(beside_losses->channel, gap::kIntensity);
  EXPECT_FALSE(modeOf(experiment, {{"road-spray", {{"plume_length_m", 4.0}, {"plume_height_m", 4.0}}}}));
}

TEST_F(Frames, ThatRepeatEachOtherAreNot) {
  EXPECT_FALSE(modeOf(world_.measuredBy(model_, 0.4)));
  const auto noisy = SmallWorld::modelWith({}, {{"/sensor/detection/range_noise_m", 0.045}});
  EXPECT_FALSE(modeOf(world_.measuredBy(noisy, 0.4)));
}

// A counter of coarse steps tells one value for all; what rounding leaves of their mean is no deviation of frames.
TEST_F(Frames, ThatAllTellOneValueAreNot) {
  model::Experiment experiment = world_.measuredBy(model_, 0.4);
  for (const model::Sample& sample : experiment.samples) {
    core::Detections detections = model::readMeasurements(experiment, sample);
    std::fill(detections.range_m.begin(), detections.range_m.end(), 58.425);
    core::writeDetections(sample.measurements, detections);
  }
  EXPECT_FALSE(modeOf(experiment));
}

// They scatter as range noise of 0.034 m does, detection by detection.
TEST_F(Frames, ThatAlternateAreNoNoise) {
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis = gap::diagnose(alternating(0.03), model_, {}, progress);
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kUnknown);
  EXPECT_THAT(diagnosis.verdict.text, testing::StartsWith("They differ from frame to frame"));
  EXPECT_THAT(diagnosis.notes, testing::Contains(testing::HasSubstr("All detections of a frame deviate together")));
}

// Warming up the sensor reads short by 0.03 m at first and by 0.016 after twenty frames. An offset explains their mean,
// but is the same in all frames.
TEST_F(Frames, ThatDriftAreNoConstantOffset) {
  model::Experiment experiment = world_.measuredBy(model_, 0.4);
  for (const model::Sample& sample : experiment.samples) {
    core::Detections detections = model::readMeasurements(experiment, sample);
    for (std::size_t i = 0; i < detections.size(); ++i)
      detections.range_m[i] -= 0.03 * std::exp(-detections.frame[i] / 30.0);
    core::writeDetections(sample.measurements, detections);
  }
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis = gap::diagnose(experiment, model_, {}, progress);
  EXPECT_THAT(diagnosis.notes, testing::Contains(testing::HasSubstr("All detections of a frame deviate together")));
  EXPECT_EQ(diagnosis.verdict.kind, gap::VerdictKind::kUnknown);
}

// A constant offset of 0.2 m is named, if with less confidence, where frames deviate by a hundredth of that.
TEST_F(Frames, ThatDeviateByLittleDoNotTakeALargeOffsetAway) {
  model::Experiment experiment = alternating(0.002);
  for (const model::Sample& sample : experiment.samples) {
    core::Detections detections = model::readMeasurements(experiment, sample);
    for (double& range_m : detections.range_m) range_m += 0.2;
    core::writeDetections(sample.measurements, detections);
  }
  core::SilentProgress progress;
  const gap::Diagnosis diagnosis = gap::diagnose(experiment, model_, {}, progress);
  EXPECT_EQ(diagnosis.verdict.names, std::vector<std::string>{"range-offset"});
  EXPECT_LE(diagnosis.verdict.confidence, 0.7);
  EXPECT_THAT(diagnosis.notes, testing::Contains(testing::HasSubstr("All detections of a frame deviate together")));
}

}  // namespace
