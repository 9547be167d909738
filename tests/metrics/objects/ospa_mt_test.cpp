#include "metrics/objects/ospa_mt.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "metrics/objects/ospa.h"
#include "tests/metrics/objects/random_objects.h"

namespace {

using metrics::MultiTrackOptions;
using metrics::MultiTrackOspa;
using metrics::ospaMt;
using metrics::TrackSets;
using metrics_test::RandomObjects;
using metrics_test::trackAlongX;
using metrics_test::TrackList;

constexpr MultiTrackOptions kPlain{.set = {.order = 1.0, .cutoff_m = 5.0}, .piece_m = 2.0};

TEST(OspaMt, OfEqualSetsIsNothingInAnyOrder) {
  RandomObjects cases(300);
  for (int k = 0; k < 50; ++k) {
    const TrackList tracks = cases.tracks(4, 6);
    const TrackList turned(tracks.rbegin(), tracks.rend());
    EXPECT_NEAR(ospaMt({.simulated = turned, .measured = tracks}).distance, 0.0, 1e-7);
  }
}

// One measured track over five steps; it is simulated without error in two pieces. The shorter one, of two steps, pays.
TEST(OspaMt, ABrokenTrackPaysForEachStepOfItsShorterPiece) {
  const TrackList measured = {trackAlongX(0, {0, 1, 2, 3, 4}, 5)};
  const TrackList simulated = {trackAlongX(0, {0, 1}, 5), trackAlongX(2, {2, 3, 4}, 5)};
  const MultiTrackOspa broken = ospaMt({.simulated = simulated, .measured = measured}, kPlain);
  EXPECT_DOUBLE_EQ(broken.distance, 2.0 * 2.0 / 5.0);
  EXPECT_EQ(broken.pieces, 1U);
  // A piece that costs nothing makes the track whole again; one that costs c is as bad as none.
  EXPECT_DOUBLE_EQ(ospaMt({.simulated = simulated, .measured = measured}, {kPlain.set, 0.0}).distance, 0.0);
  EXPECT_DOUBLE_EQ(ospaMt({.simulated = simulated, .measured = measured}, {kPlain.set, 5.0}).distance, 5.0 * 2.0 / 5.0);
}

// Two simulated tracks on the same measured one at the same time: one is right, the other one object too many.
TEST(OspaMt, ATrackBesideAnotherOneIsFalseAndNoPiece) {
  const TrackList measured = {trackAlongX(0, {0, 1, 2}, 3)};
  const TrackList simulated = {trackAlongX(0, {0, 1, 2}, 3), trackAlongX(0, {1, 2, 3}, 3)};
  EXPECT_DOUBLE_EQ(ospaMt({.simulated = simulated, .measured = measured}, kPlain).distance, 5.0 * 3.0 / 6.0);
}

TEST(OspaMt, MissedFalseAndNoTracksCostTheCutOff) {
  const TrackList one = {trackAlongX(0, {0, 1, 2}, 3)};
  EXPECT_DOUBLE_EQ(ospaMt({.simulated = {}, .measured = one}, kPlain).distance, 5.0);
  EXPECT_DOUBLE_EQ(ospaMt({.simulated = one, .measured = {}}, kPlain).distance, 5.0);
  EXPECT_EQ(ospaMt({}).distance, 0.0);
}

// At one step there is nothing to break: the same pairs as in OSPA are best.
TEST(OspaMt, AtOneStepIsOspa) {
  RandomObjects cases(301);
  for (int k = 0; k < 200; ++k) {
    const TrackList measured = cases.tracks(5, 1);
    const TrackList simulated = cases.tracks(5, 1);
    metrics_test::ObjectList x, y;
    for (const auto& track : measured) x.push_back({.position = *track.positions[0]});
    for (const auto& track : simulated) y.push_back({.position = *track.positions[0]});
    const metrics::SetOptions set{.order = 2.0, .cutoff_m = 3.0};
    EXPECT_NEAR(ospaMt({.simulated = simulated, .measured = measured}, {set, 1.0}).distance,
                ospa({.simulated = y, .measured = x}, set).distance, 1e-7);
  }
}

TEST(OspaMt, IsSymmetricAndNeverAboveTheCutOff) {
  RandomObjects cases(302);
  for (int k = 0; k < 100; ++k) {
    const TrackList a = cases.tracks(4, 5);
    const TrackList b = cases.tracks(4, 5);
    const double there = ospaMt({.simulated = a, .measured = b}, kPlain).distance;
    EXPECT_NEAR(there, ospaMt({.simulated = b, .measured = a}, kPlain).distance, 1e-12);
    EXPECT_LE(there, 5.0 + 1e-12);
  }
}

/// All assignments of simulated tracks, each to one measured track or to none, tried one by one.
double leastByEnumeration(const TrackSets& sets, const MultiTrackOptions& options) {
  const double c = options.set.cutoff_m, p = options.set.order;
  const std::size_t choices = sets.measured.size() + 1;
  double objects = 0.0;
  for (std::size_t k = 0; k < sets.steps(); ++k) {
    double n = 0, m = 0;
    for (const auto& t : sets.simulated) n += t.existsAt(k) ? 1 : 0;
    for (const auto& t : sets.measured) m += t.existsAt(k) ? 1 : 0;
    objects += std::max(n, m);
  }
  double least = objects * std::pow(c, p);
  std::vector<std::size_t> of(sets.simulated.size(), 0);
  for (;;) {
    double cost = objects * std::pow(c, p);
    for (std::size_t i = 0; i + 1 < choices; ++i) {
      std::vector<double> steps(sets.simulated.size(), 0.0);
      for (std::size_t k = 0; k < sets.steps(); ++k) {
        double nearest = c;
        std::size_t by = 0;
        for (std::size_t j = 0; j < of.size(); ++j) {
          if (of[j] != i || !sets.simulated[j].existsAt(k) || !sets.measured[i].existsAt(k)) continue;
          const double d = distance(*sets.simulated[j].positions[k], *sets.measured[i].positions[k]);
          if (d < nearest) nearest = d, by = j;
        }
        if (nearest >= c) continue;
        cost += std::pow(nearest, p) - std::pow(c, p);
        steps[by] += 1.0;
      }
      double all = 0.0, longest = 0.0;
      for (const double s : steps) all += s, longest = std::max(longest, s);
      cost += std::pow(options.piece_m, p) * (all - longest);
    }
    least = std::min(least, cost);
    std::size_t j = 0;
    while (j < of.size() && ++of[j] == choices) of[j++] = 0;
    if (j == of.size()) break;
  }
  return objects == 0.0 ? 0.0 : std::pow(std::max(0.0, least / objects), 1.0 / p);
}

TEST(OspaMt, IsTheLeastOverAllAssignmentsBothWays) {
  RandomObjects cases(303);
  for (int k = 0; k < 100; ++k) {
    const TrackList a = cases.tracks(4, 6);
    const TrackList b = cases.tracks(3, 6);
    const MultiTrackOptions options{.set = {.order = 2.0, .cutoff_m = 3.0}, .piece_m = 0.5 * (k % 7)};
    const double expected = std::min(leastByEnumeration({.simulated = a, .measured = b}, options),
                                     leastByEnumeration({.simulated = b, .measured = a}, options));
    EXPECT_NEAR(ospaMt({.simulated = a, .measured = b}, options).distance, expected, 1e-9);
  }
}

// Everybody near everybody: more assignments than can be tried.
TEST(OspaMt, RefusesACrowd) {
  RandomObjects cases(304);
  TrackList a, b;
  for (int k = 0; k < 12; ++k) {
    a.push_back(cases.track(4));
    b.push_back(cases.track(4));
  }
  EXPECT_THAT([&] { (void)ospaMt({.simulated = a, .measured = b}, {.set = {.order = 1.0, .cutoff_m = 50.0}}); },
              testing::ThrowsMessage<core::InputError>(testing::HasSubstr("smaller cut-off")));
}

TEST(OspaMt, RefusesAPriceAboveTheCutOff) {
  EXPECT_THAT([] { (void)ospaMt({}, {.set = {.order = 1.0, .cutoff_m = 1.0}, .piece_m = 2.0}); },
              testing::ThrowsMessage<core::InputError>(testing::HasSubstr("must not exceed the cut-off")));
}

}  // namespace
