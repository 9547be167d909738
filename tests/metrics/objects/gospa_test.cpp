#include "metrics/objects/gospa.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "tests/metrics/objects/random_objects.h"

namespace {

using metrics::Gospa;
using metrics::gospa;
using metrics::ObjectPair;
using metrics::SetOptions;
using metrics_test::ObjectList;
using metrics_test::objectsAt;
using metrics_test::RandomObjects;
using testing::ElementsAre;

double gospaOf(const ObjectList& a, const ObjectList& b, const SetOptions& options = {}) {
  return gospa({.simulated = a, .measured = b}, options).distance;
}

/// The definition with alpha = 2: every object of `a` in turn stays alone or takes a free one of `b`.
double bruteForce(const ObjectList& a, const ObjectList& b, const SetOptions& options) {
  const double alone = 0.5 * std::pow(options.cutoff_m, options.order);
  std::vector<bool> taken(b.size(), false);
  const std::function<double(std::size_t)> least = [&](std::size_t i) {
    if (i == a.size()) return alone * static_cast<double>(std::count(taken.begin(), taken.end(), false));
    double best = alone + least(i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (taken[j]) continue;
      taken[j] = true;
      best = std::min(best, std::pow(distance(a[i].position, b[j].position), options.order) + least(i + 1));
      taken[j] = false;
    }
    return best;
  };
  return std::pow(least(0), 1.0 / options.order);
}

TEST(Gospa, IsTheLeastOverAllAssignments) {
  RandomObjects cases(60);
  for (int k = 0; k < 200; ++k) {
    const ObjectList a = cases.list(5);
    const ObjectList b = cases.list(5);
    const SetOptions options{.order = k % 2 == 0 ? 1.0 : 2.5, .cutoff_m = cases.uniform(1.0, 8.0)};
    EXPECT_NEAR(gospaOf(a, b, options), bruteForce(a, b, options), 1e-12);
  }
}

TEST(Gospa, IsAMetricOnFiniteSets) {
  RandomObjects cases(61);
  for (int k = 0; k < 500; ++k) {
    const ObjectList a = cases.list(5);
    const ObjectList b = cases.list(5);
    const ObjectList c = cases.list(5);
    const SetOptions options{.order = k % 2 == 0 ? 1.0 : 2.0, .cutoff_m = 4.0};
    EXPECT_EQ(gospaOf(a, a, options), 0.0);
    EXPECT_NEAR(gospaOf(a, b, options), gospaOf(b, a, options), 1e-12);
    EXPECT_LE(gospaOf(a, c, options), gospaOf(a, b, options) + gospaOf(b, c, options) + 1e-12);
  }
}

// With alpha = 2 every missed and every false object costs c^p / 2, whatever else there is (Rahmathullah et al. 2017).
TEST(Gospa, EveryObjectAloneCostsHalfThePowerOfTheCutOff) {
  RandomObjects cases(62);
  const ObjectList three = objectsAt(cases.cloud(3));
  const Gospa missed = gospa({.simulated = {}, .measured = three}, {.order = 2.0, .cutoff_m = 4.0});
  EXPECT_NEAR(missed.distance, std::sqrt(3.0 * 8.0), 1e-14);
  EXPECT_EQ(missed.missed, 3U);
  EXPECT_EQ(missed.false_objects, 0U);
  const Gospa spurious = gospa({.simulated = three, .measured = {}}, {.order = 2.0, .cutoff_m = 4.0});
  EXPECT_EQ(spurious.missed, 0U);
  EXPECT_EQ(spurious.false_objects, 3U);
}

// Unlike OSPA: a false object far away is as dear as one nearby, and not dearer than a missed and a false object.
TEST(Gospa, TellsMissedFromFalseAndPairsTheRest) {
  const ObjectList measured = objectsAt({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}});
  const ObjectList simulated = objectsAt({{40, 0, 0}, {10, 3, 4}, {0, 0, 1}});
  const Gospa result = gospa({.simulated = simulated, .measured = measured}, {.order = 1.0, .cutoff_m = 6.0});
  EXPECT_THAT(result.pairs, ElementsAre(ObjectPair{0, 2}, ObjectPair{1, 1}));
  EXPECT_EQ(result.missed, 1U);
  EXPECT_EQ(result.false_objects, 1U);
  EXPECT_DOUBLE_EQ(result.localisation, 6.0);
  EXPECT_DOUBLE_EQ(result.distance, 6.0 + 3.0 + 3.0);
}

TEST(Gospa, PairAtTheCutOffIsAMissedAndAFalseObject) {
  const Gospa result =
      gospa({.simulated = objectsAt({{5, 0, 0}}), .measured = objectsAt({{0, 0, 0}})}, {.cutoff_m = 5});
  EXPECT_TRUE(result.pairs.empty());
  EXPECT_DOUBLE_EQ(result.distance, 5.0);
}

TEST(Gospa, PartsAddUpAsPowers) {
  RandomObjects cases(63);
  for (int k = 0; k < 100; ++k) {
    const ObjectList a = cases.list(6);
    const ObjectList b = cases.list(6);
    const Gospa all = gospa({.simulated = a, .measured = b}, {.order = 2.0, .cutoff_m = 4.0});
    EXPECT_NEAR(all.distance * all.distance,
                all.localisation * all.localisation + 8.0 * static_cast<double>(all.missed + all.false_objects), 1e-11);
    EXPECT_EQ(all.pairs.size() + all.missed, b.size());
    EXPECT_EQ(all.pairs.size() + all.false_objects, a.size());
  }
}

}  // namespace
