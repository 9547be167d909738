#include "gap/replay/geometry_cache.h"

#include <gtest/gtest.h>

namespace gap {
namespace {

GeometryCache::Geometry geometryOfHits(std::size_t hits) {
  auto traced = std::make_shared<model::TracedSample>();
  for (std::size_t i = 0; i < hits; ++i) traced->hits.hits.add({});
  return traced;
}

constexpr std::size_t kHits = 1000;
constexpr std::size_t kBytes = kHits * sizeof(model::Hit);

TEST(GeometryCacheTest, ForgetsWhatWasAskedForLongestAgo) {
  GeometryCache cache(3 * kBytes);
  for (const char* key : {"a", "b", "c"}) cache.remember(key, geometryOfHits(kHits));
  const auto a = cache.find("a");
  ASSERT_NE(a, nullptr);
  cache.remember("d", geometryOfHits(kHits));
  EXPECT_EQ(cache.find("a"), a);
  EXPECT_EQ(cache.find("b"), nullptr) << "nobody asked for b since it came";
  EXPECT_NE(cache.find("c"), nullptr);
  EXPECT_NE(cache.find("d"), nullptr);
}

TEST(GeometryCacheTest, ALargeOneTakesThePlaceOfSeveral) {
  GeometryCache cache(3 * kBytes);
  for (const char* key : {"a", "b", "c"}) cache.remember(key, geometryOfHits(kHits));
  cache.remember("large", geometryOfHits(2 * kHits));
  EXPECT_EQ(cache.find("a"), nullptr);
  EXPECT_EQ(cache.find("b"), nullptr);
  EXPECT_NE(cache.find("c"), nullptr);
  EXPECT_NE(cache.find("large"), nullptr);
}

TEST(GeometryCacheTest, WhatIsLargerThanTheCacheLeavesItAsItIs) {
  GeometryCache cache(3 * kBytes);
  cache.remember("a", geometryOfHits(kHits));
  cache.remember("whole town", geometryOfHits(4 * kHits));
  EXPECT_EQ(cache.find("whole town"), nullptr);
  EXPECT_NE(cache.find("a"), nullptr);
}

TEST(GeometryCacheTest, KeepsTheFirstOfTwoThatTracedTheSame) {
  GeometryCache cache(3 * kBytes);
  const auto first = geometryOfHits(kHits);
  cache.remember("a", first);
  cache.remember("a", geometryOfHits(kHits));
  EXPECT_EQ(cache.find("a"), first);
  cache.remember("b", geometryOfHits(kHits));
  cache.remember("c", geometryOfHits(kHits));
  EXPECT_EQ(cache.find("a"), first) << "the second was not counted";
}

}  // namespace
}  // namespace gap
