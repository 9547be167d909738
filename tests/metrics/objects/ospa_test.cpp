#include "metrics/objects/ospa.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "tests/metrics/objects/random_objects.h"

namespace {

using metrics::Ospa;
using metrics::ospa;
using metrics::SetOptions;
using metrics_test::ObjectList;
using metrics_test::objectsAt;
using metrics_test::RandomObjects;

double ospaOf(const ObjectList& a, const ObjectList& b, const SetOptions& options = {}) {
  return ospa({.simulated = a, .measured = b}, options).distance;
}

/// The definition: every permutation of the larger list.
double bruteForce(ObjectList a, ObjectList b, const SetOptions& options) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.empty()) return 0.0;
  std::vector<std::size_t> order(b.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      sum += std::pow(std::min(options.cutoff_m, distance(a[i].position, b[order[i]].position)), options.order);
    }
    least = std::min(least, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  const double rest = std::pow(options.cutoff_m, options.order) * static_cast<double>(b.size() - a.size());
  return std::pow((least + rest) / static_cast<double>(b.size()), 1.0 / options.order);
}

TEST(Ospa, IsTheLeastOverAllPermutations) {
  RandomObjects cases(50);
  for (int k = 0; k < 200; ++k) {
    const ObjectList a = cases.list(6);
    const ObjectList b = cases.list(6);
    const SetOptions options{.order = k % 2 == 0 ? 1.0 : 2.5, .cutoff_m = cases.uniform(1.0, 8.0)};
    EXPECT_NEAR(ospaOf(a, b, options), bruteForce(a, b, options), 1e-12);
  }
}

TEST(Ospa, IsAMetricOnFiniteSets) {
  RandomObjects cases(51);
  for (int k = 0; k < 500; ++k) {
    const ObjectList a = cases.list(5);
    const ObjectList b = cases.list(5);
    const ObjectList c = cases.list(5);
    const SetOptions options{.order = k % 2 == 0 ? 1.0 : 2.0, .cutoff_m = 4.0};
    EXPECT_EQ(ospaOf(a, a, options), 0.0);
    EXPECT_NEAR(ospaOf(a, b, options), ospaOf(b, a, options), 1e-12);
    EXPECT_LE(ospaOf(a, c, options), ospaOf(a, b, options) + ospaOf(b, c, options) + 1e-12);
  }
}

// Schuhmacher et al. 2008: one empty set is c away from any other, however many objects that has.
TEST(Ospa, OfOneEmptySetIsTheCutOff) {
  RandomObjects cases(52);
  for (const std::size_t n : {1, 2, 7}) {
    EXPECT_DOUBLE_EQ(ospaOf({}, objectsAt(cases.cloud(n)), {.order = 2.0, .cutoff_m = 7.0}), 7.0);
  }
  EXPECT_EQ(ospaOf({}, {}), 0.0);
}

// n - m of n objects missing, the others exact: c ((n - m) / n)^(1/p). The larger p, the dearer.
TEST(Ospa, PenaltyOfCardinalityFollowsCutOffAndOrder) {
  RandomObjects cases(53);
  const ObjectList all = objectsAt(cases.cloud(5));
  const ObjectList three(all.begin(), all.begin() + 3);
  EXPECT_NEAR(ospaOf(three, all, {.order = 1.0, .cutoff_m = 10.0}), 4.0, 1e-14);
  EXPECT_NEAR(ospaOf(three, all, {.order = 2.0, .cutoff_m = 10.0}), 10.0 * std::sqrt(0.4), 1e-14);
}

TEST(Ospa, GrowsWithOrderAndWithCutOffAndNeverExceedsIt) {
  RandomObjects cases(54);
  for (int k = 0; k < 100; ++k) {
    const ObjectList a = cases.list(5);
    const ObjectList b = cases.list(5);
    const double plain = ospaOf(a, b, {.order = 1.0, .cutoff_m = 3.0});
    EXPECT_LE(plain, ospaOf(a, b, {.order = 2.0, .cutoff_m = 3.0}) + 1e-12);
    EXPECT_LE(plain, ospaOf(a, b, {.order = 1.0, .cutoff_m = 5.0}) + 1e-12);
    EXPECT_LE(plain, 3.0 + 1e-12);
  }
}

TEST(Ospa, PartsAddUpAsPowers) {
  RandomObjects cases(55);
  for (int k = 0; k < 100; ++k) {
    const ObjectList a = cases.list(5);
    const ObjectList b = cases.list(5);
    const Ospa all = ospa({.simulated = a, .measured = b}, {.order = 2.0, .cutoff_m = 4.0});
    EXPECT_NEAR(all.distance * all.distance, all.localisation * all.localisation + all.cardinality * all.cardinality,
                1e-12);
  }
}

TEST(Ospa, RefusesWhatIsNoNumberOrNoOption) {
  ObjectList bad(3);
  bad[1].position.z_m = std::nan("");
  try {
    (void)ospaOf({}, bad);
    FAIL() << "took NaN";
  } catch (const core::InputError& error) {
    EXPECT_EQ(error.place().item, "measured object 2");
  }
  EXPECT_THROW((void)ospaOf({}, {}, {.order = 0.5}), core::InputError);
  EXPECT_THROW((void)ospaOf({}, {}, {.cutoff_m = 0.0}), core::InputError);
  EXPECT_THROW((void)ospaOf({{.existence = 1.5}}, {}), core::InputError);
  EXPECT_THROW((void)ospaOf({{.footprint = {{.length_m = -1.0}}}}, {}), core::InputError);
}

}  // namespace
