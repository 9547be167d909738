#include "gap/replay/transport.h"

#include <cmath>
#include <gtest/gtest.h>

#include "gap/replay/replay.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;
using Shots = std::vector<model::Shot>;

/// Twenty frames of one beam of the small world's wall at 8 m, with a scatter of ± 1 cm and ± 2 cm.
Shots wallShots(double range_m, double epw_m, double intensity_nw, int frames = 20) {
  Shots shots;
  for (int f = 0; f < frames; ++f) {
    const double part = (f % 4) / 1.5 - 1.0;  // -1 … 1
    shots.push_back({.beam = 0,
                     .frame = f,
                     .echo = 1,
                     .range_m = range_m + 0.01 * part,
                     .epw_m = epw_m + 0.02 * part,
                     .intensity_nw = intensity_nw * (1.0 + 0.01 * part)});
  }
  return shots;
}

class Transport : public ::testing::Test {
 protected:
  Transport()
      : experiment_(world_.measuredBy(SmallWorld::modelWith({}), 0.4)),
        model_(SmallWorld::modelWith({})),
        replay_(experiment_, model_),
        layout_(*replay_.samples().front().layout),
        anchor_m_(layout_.cells().front().anchor_m) {}

  [[nodiscard]] Shots transported(const Shots& foreign, const Shots& from, const Shots& to) const {
    return gap::transported(foreign, from, to, layout_, {.seed = 1});
  }
  [[nodiscard]] double mean(const Shots& shots, gap::Channel channel) const {
    return layout_.statisticsOf(shots).front().mean(channel);
  }

  SmallWorld world_;
  model::Experiment experiment_;
  model::LidarModel model_;
  gap::Replay replay_;
  const gap::CellLayout& layout_;
  double anchor_m_;
};

TEST_F(Transport, LeavesEverythingAsItIsWhereNothingChanges) {
  const Shots foreign = wallShots(anchor_m_ + 0.03, 3.0, 100), proxy = wallShots(anchor_m_, 3.2, 500);
  const Shots moved = transported(foreign, proxy, proxy);
  ASSERT_EQ(moved.size(), foreign.size());
  for (std::size_t i = 0; i < moved.size(); ++i) {
    EXPECT_EQ(moved[i].range_m, foreign[i].range_m);
    EXPECT_EQ(moved[i].epw_m, foreign[i].epw_m);
    EXPECT_EQ(moved[i].intensity_nw, foreign[i].intensity_nw);
  }
}

// Range and pulse width move by the difference of the worlds, an intensity of whatever unit by their ratio; the foreign
// model's own bias and scatter stay.
TEST_F(Transport, MovesByTheDifferenceThatTheProxySees) {
  const Shots foreign = wallShots(anchor_m_ + 0.03, 3.0, 7);
  const Shots moved = transported(foreign, wallShots(anchor_m_, 3.2, 500), wallShots(anchor_m_ + 0.1, 2.9, 250));
  EXPECT_NEAR(mean(moved, gap::kRange) - mean(foreign, gap::kRange), 0.1, 1e-9);
  EXPECT_NEAR(mean(moved, gap::kEpw) - mean(foreign, gap::kEpw), -0.3, 1e-9);
  EXPECT_NEAR(mean(moved, gap::kIntensity) / mean(foreign, gap::kIntensity), 0.5, 1e-9);
  EXPECT_NEAR(layout_.statisticsOf(moved).front().variance(gap::kRange),
              layout_.statisticsOf(foreign).front().variance(gap::kRange), 1e-9);
}

// If the foreign model is the proxy, the changed world comes out, whatever the change is.
TEST_F(Transport, OfTheProxyItselfIsTheChangedWorldItself) {
  gap::World fog = replay_.baseline();
  fog.model = SmallWorld::modelWith(
      {{"atmospheric-attenuation", {{"visibility_m", 500}}}, {"range-walk", nlohmann::json::object()}});
  gap::World with_foreign = replay_.baseline();
  const std::size_t near = 0;
  std::vector<model::ExternalRun> runs;
  for (std::size_t s = 0; s < replay_.samples().size(); ++s)
    runs.push_back({replay_.detections(replay_.baseline(), s, replay_.seed()), replay_.samples()[s].frames});
  const gap::Replay foreign(experiment_, model_, {}, runs);
  const int frames = replay_.samples()[near].frames;
  const auto direct = replay_.simulate(fog, near, frames, replay_.seed());
  const auto by_proxy = foreign.simulate(fog, near, frames, replay_.seed());
  ASSERT_EQ(direct.size(), by_proxy.size());
  for (std::size_t c = 0; c < layout_.surfaces(); ++c) {
    ASSERT_EQ(direct[c].count, by_proxy[c].count);
    if (direct[c].count == 0.0) continue;
    EXPECT_NEAR(direct[c].mean(gap::kRange), by_proxy[c].mean(gap::kRange), 1e-6);
    EXPECT_NEAR(direct[c].mean(gap::kEpw), by_proxy[c].mean(gap::kEpw), 1e-6);
  }
}

// A world that loses 60 of 100 loses the share of the foreign detections too, of which there are only half as many;
// binomial: 0.4 · 50 ± 4 · sqrt(50 · 0.4 · 0.6).
TEST_F(Transport, LossesMultiply) {
  const Shots proxy = wallShots(anchor_m_, 3.0, 100, 100), lossy = wallShots(anchor_m_, 3.0, 100, 40);
  const double left = static_cast<double>(transported(wallShots(anchor_m_, 3.0, 100, 50), proxy, lossy).size());
  EXPECT_NEAR(left, 20.0, 4.0 * std::sqrt(50 * 0.4 * 0.6));
}

// Rates are pooled over samples: were the same frames lost in each of them, chance would not average out.
TEST_F(Transport, EverySampleLosesOtherDetections) {
  const Shots foreign = wallShots(anchor_m_, 3.0, 100, 50);
  const Shots proxy = wallShots(anchor_m_, 3.0, 100, 100), lossy = wallShots(anchor_m_, 3.0, 100, 40);
  const auto framesLeft = [&](std::uint32_t sample) {
    std::vector<int> frames;
    for (const model::Shot& shot : gap::transported(foreign, proxy, lossy, layout_, {.seed = 1, .sample = sample}))
      frames.push_back(shot.frame);
    return frames;
  };
  EXPECT_EQ(framesLeft(0), framesLeft(0));
  EXPECT_NE(framesLeft(0), framesLeft(1));
}

TEST_F(Transport, DetectionsThatTheChangedWorldHasMoreAreAddedWithTheForeignModelsOwnBias) {
  const Shots few = wallShots(anchor_m_, 3.0, 100, 8), more = wallShots(anchor_m_, 3.0, 100, 20);
  const Shots out = transported(wallShots(anchor_m_ + 0.05, 3.0, 100, 8), few, more);
  EXPECT_EQ(out.size(), 20U);
  EXPECT_NEAR(mean(out, gap::kRange), 0.05, 0.003);  // about the anchor
}

TEST_F(Transport, WhatAppearsWhereTheSceneHasNothingIsAddedAsItIs) {
  const Shots foreign = wallShots(anchor_m_, 3.0, 100);
  Shots ghost = foreign;
  ghost.push_back({.beam = 0, .frame = 3, .echo = 2, .range_m = anchor_m_ + 30.0, .epw_m = 1.0, .intensity_nw = 20});
  const Shots out = transported(foreign, foreign, ghost);
  ASSERT_EQ(out.size(), foreign.size() + 1);
  EXPECT_EQ(out.back().range_m, anchor_m_ + 30.0);
}

TEST(ForeignFrames, ComeInOrderAndFromTheStartAgain) {
  const gap::ForeignFrames recording{.shots = wallShots(8.0, 3.0, 100, 3), .frames = 3};
  const Shots shots = gap::framesFrom(recording, 5, 0);
  ASSERT_EQ(shots.size(), 5U);
  EXPECT_EQ(shots[4].frame, 4);
  EXPECT_EQ(shots[4].range_m, recording.shots[1].range_m);
}

// Two recordings of n frames differ in their means with the variance 2 σ²/n. The bootstrap loses a part of 1/n in each
// of its two stages; the tolerance is four standard errors of a variance from 4000 draws.
TEST(ForeignFrames, UnderAnotherSeedDifferAsTwoRecordingsWould) {
  constexpr int kFrames = 40, kDraws = 4000;
  const gap::ForeignFrames recording{.shots = wallShots(8.0, 3.0, 100, kFrames), .frames = kFrames};
  double mean = 0.0, variance = 0.0, squares = 0.0;
  for (const model::Shot& shot : recording.shots) mean += shot.range_m / kFrames;
  for (const model::Shot& shot : recording.shots) variance += std::pow(shot.range_m - mean, 2) / kFrames;
  for (int draw = 1; draw <= kDraws; ++draw) {
    double drawn = 0.0;
    for (const model::Shot& shot : gap::framesFrom(recording, kFrames, static_cast<std::uint64_t>(draw)))
      drawn += shot.range_m / kFrames;
    squares += std::pow(drawn - mean, 2) / kDraws;
  }
  const double expected = 2.0 * variance / kFrames;
  EXPECT_NEAR(squares, expected, expected * (1.0 / kFrames + 4.0 * std::sqrt(2.0 / kDraws)));
}

}  // namespace
