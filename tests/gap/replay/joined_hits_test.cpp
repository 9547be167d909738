#include "gap/replay/joined_hits.h"

#include <gtest/gtest.h>

namespace {

constexpr double kRangeBin_m = 0.02;
constexpr double kLeftBin_rad = 1e-3;

/// One beam whose sub-rays, of a quarter of the power each, all met a pane at 5 m and something behind it.
model::BeamHits behindAPane(const std::vector<model::SecondHit>& second) {
  model::BeamHits hits;
  hits.beams.resize(1);
  for (std::uint32_t ray = 0; ray < 4; ++ray) {
    hits.rays.add(0.0, 0.0, 0.25);
    hits.hits.add({5.0, 1.0F, 0, ray});
  }
  hits.hits.endBeam();
  hits.second = second;
  hits.first_second = {0, static_cast<std::uint32_t>(second.size())};
  return hits;
}

model::SecondHit through(std::int32_t pane, double range_m, std::uint32_t ray, float cos_at_pane = 1.0F) {
  return {{range_m, 0.5F, 1, ray}, {model::Turn{false, pane, cos_at_pane}}, 1};
}

TEST(JoinedHits, WaysThroughTheSamePaneToTheSameSurfaceBecomeOneOfTheirPowerAndTheirMeans) {
  const model::BeamHits joined = gap::joined(behindAPane({through(0, 8.001, 0, 1.0F), through(0, 8.003, 1, 0.8F)}), {},
                                             {}, kRangeBin_m, kLeftBin_rad);
  ASSERT_EQ(joined.second.size(), 1U);
  const model::SecondHit& way = joined.second.front();
  EXPECT_DOUBLE_EQ(joined.rays.weight[way.hit.ray], 0.5);
  EXPECT_DOUBLE_EQ(way.hit.range_m, 8.002);
  EXPECT_FLOAT_EQ(way.turns[0].cos_incidence, 0.9F);
  EXPECT_EQ(way.turns[0].object, 0);
  ASSERT_EQ(joined.hits.size(), 1U);
  EXPECT_DOUBLE_EQ(joined.rays.weight[joined.hits.ray[0]], 1.0);
}

TEST(JoinedHits, WaysThroughOtherPanesOrToOtherDistancesStayApart) {
  const model::BeamHits joined = gap::joined(behindAPane({through(0, 8.0, 0), through(2, 8.0, 1), through(0, 9.0, 2)}),
                                             {}, {}, kRangeBin_m, kLeftBin_rad);
  EXPECT_EQ(joined.second.size(), 3U);
  EXPECT_EQ(joined.first_second.back(), 3U);
}

TEST(JoinedHits, ARayWithoutPowerLeavesNothing) {
  model::BeamHits hits = behindAPane({});
  hits.hits.clear();
  hits.hits.add({5.0, 1.0F, 0, 0});
  hits.hits.add({7.0, 1.0F, 1, hits.rays.add(0.01, 0.0, 0.0)});
  hits.hits.endBeam();
  const model::BeamHits joined = gap::joined(hits, {}, {}, kRangeBin_m, kLeftBin_rad);
  ASSERT_EQ(joined.hits.size(), 1U);
  EXPECT_EQ(joined.hits.object[0], 0);
}

}  // namespace
