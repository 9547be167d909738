#include "gap/replay/stretch.h"

#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace {

/// One beam whose sub-rays met surfaces so far away, with so much power each.
struct OneBeam {
  explicit OneBeam(const std::vector<std::pair<double, double>>& ranges_and_weights) {
    for (const auto& [range_m, weight] : ranges_and_weights) {
      hits.add({range_m, 1.0F, 0, static_cast<std::uint32_t>(rays.size())});
      rays.add(0.0, 0.0, weight);
    }
    hits.endBeam();
  }
  [[nodiscard]] model::HitsOfBeam beam() const { return {hits, 0}; }

  model::Hits hits;
  model::SubRays rays;
};

TEST(Stretch, IsHowFarTheNearestPointAndTheFarthestAreApart) {
  EXPECT_DOUBLE_EQ(gap::stretchOf_m(OneBeam({{12.0, 0.5}, {10.5, 0.0}, {11.0, 0.5}}).beam()), 1.5);
  EXPECT_DOUBLE_EQ(gap::stretchOf_m(OneBeam({{12.0, 1.0}}).beam()), 0.0);
}

TEST(Stretch, TearsABeamApartOnlyWhereNeighboursAreFarFromEachOther) {
  const OneBeam stretched({{10.0, 0.25}, {11.5, 0.25}, {10.5, 0.25}, {11.0, 0.25}});
  EXPECT_FALSE(gap::isTornApart(stretched.beam(), stretched.rays, 0.6));
  EXPECT_TRUE(gap::isTornApart(stretched.beam(), stretched.rays, 0.4));
}

TEST(Stretch, TearsNothingApartByASubRayWithoutPower) {
  const OneBeam beam({{10.0, 0.5}, {10.2, 0.5}, {14.0, 0.0}});
  EXPECT_FALSE(gap::isTornApart(beam.beam(), beam.rays, 0.6));
}

TEST(Stretch, OfABeamThatMeetsNothingTearsNothingApart) {
  const OneBeam beam({});
  EXPECT_FALSE(gap::isTornApart(beam.beam(), beam.rays, 0.6));
}

}  // namespace
