#include "metrics/objects/trajectory_metric.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.h"
#include "metrics/objects/gospa.h"
#include "tests/metrics/objects/random_objects.h"

namespace {

using metrics::Track;
using metrics::TrajectoryDistance;
using metrics::trajectoryDistance;
using metrics::TrajectoryOptions;
using metrics_test::RandomObjects;
using metrics_test::trackAlongX;
using metrics_test::TrackList;

TrajectoryDistance between(const TrackList& measured, const TrackList& simulated, const TrajectoryOptions& options) {
  return trajectoryDistance({.simulated = simulated, .measured = measured}, options);
}

// The examples that accompany Garcia-Fernandez et al. 2020: p = 1, c = 5, gamma = 1, five steps on a line.
constexpr TrajectoryOptions kExample{.set = {.order = 1.0, .cutoff_m = 5.0}, .switch_m = 1.0};
const std::vector<double> kAtOne(5, 1.0);

TEST(TrajectoryDistance, OfAShiftedTrackIsTheShiftAtEveryStep) {
  const TrajectoryDistance d = between({trackAlongX(0, kAtOne, 5)}, {trackAlongX(0, {2, 2, 2, 2, 2}, 5)}, kExample);
  EXPECT_DOUBLE_EQ(d.distance, 5.0);
  EXPECT_DOUBLE_EQ(d.localisation, 5.0);
}

TEST(TrajectoryDistance, ChargesHalfTheCutOffForALateEnd) {
  const TrajectoryDistance d = between({trackAlongX(0, kAtOne, 5)}, {trackAlongX(0, {2, 2, 2, 2}, 5)}, kExample);
  EXPECT_DOUBLE_EQ(d.distance, 4.0 + 2.5);
  EXPECT_DOUBLE_EQ(d.missed, 1.0);
  EXPECT_DOUBLE_EQ(d.false_objects, 0.0);
  EXPECT_DOUBLE_EQ(d.switches, 0.0);
}

TEST(TrajectoryDistance, ChargesOneSwitchForABrokenTrack) {
  const TrackList pieces{trackAlongX(0, {1.1, 1.1, 1.1}, 5), trackAlongX(3, {1.1, 1.1}, 5)};
  const TrajectoryDistance d = between({trackAlongX(0, kAtOne, 5)}, pieces, kExample);
  EXPECT_NEAR(d.distance, 0.5 + 1.0, 1e-12);
  EXPECT_NEAR(d.switches, 1.0, 1e-12);
}

// Two tracks 1.2 m apart; the simulated ones lie 0.2 m inside and exchange their roles after two of four steps: two
// switches, or the wrong partner, 1 m away, for half of the time.
TEST(TrajectoryDistance, ChargesTwoSwitchesForAnExchange) {
  const TrackList measured{trackAlongX(0, {1, 1, 1, 1}, 4), trackAlongX(0, {2.2, 2.2, 2.2, 2.2}, 4)};
  const TrackList simulated{trackAlongX(0, {2, 2, 1.2, 1.2}, 4), trackAlongX(0, {1.2, 1.2, 2, 2}, 4)};
  const TrajectoryDistance cheap = between(measured, simulated, kExample);
  EXPECT_NEAR(cheap.distance, 8 * 0.2 + 2.0, 1e-12);
  EXPECT_NEAR(cheap.switches, 2.0, 1e-12);
  const TrajectoryDistance dear = between(measured, simulated, {.set = kExample.set, .switch_m = 5.0});
  EXPECT_NEAR(dear.distance, 4 * 0.2 + 4 * 1.0, 1e-12);
  EXPECT_NEAR(dear.switches, 0.0, 1e-12);
}

// On one side the measured track is broken, on the other the simulated one: either costs a switch.
TEST(TrajectoryDistance, ChargesBrokenTracksOfBothSidesAlike) {
  const TrackList measured{trackAlongX(0, kAtOne, 5), trackAlongX(0, {2.2, 2.2, 2.2}, 5),
                           trackAlongX(3, {2.2, 2.2}, 5)};
  const TrackList simulated{trackAlongX(0, {1.1, 1.1, 1.1}, 5), trackAlongX(3, {1.1, 1.1}, 5),
                            trackAlongX(0, {2.1, 2.1, 2.1, 2.1, 2.1}, 5)};
  EXPECT_NEAR(between(measured, simulated, kExample).distance, 10 * 0.1 + 2.0, 1e-12);
}

TEST(TrajectoryDistance, OfOneEmptySetChargesEveryStep) {
  RandomObjects cases(80);
  const TrackList tracks = {cases.track(6), cases.track(6)};
  double steps = 0.0;
  for (const Track& t : tracks)
    steps += static_cast<double>(std::ranges::count_if(t.positions, [](auto& p) { return p.has_value(); }));
  EXPECT_DOUBLE_EQ(between(tracks, {}, kExample).distance, 2.5 * steps);
  EXPECT_DOUBLE_EQ(between(tracks, {}, kExample).missed, steps);
  EXPECT_DOUBLE_EQ(between({}, tracks, kExample).false_objects, steps);
  EXPECT_EQ(between({}, {}, kExample).distance, 0.0);
}

/// The multi-dimensional assignment itself: W whole, by dynamic programming over all partial assignments of a step.
class Exact {
 public:
  Exact(const TrackList& measured, const TrackList& simulated, const TrajectoryOptions& options)
      : measured_(measured), simulated_(simulated), options_(options) {
    partners_.resize(measured.size());
    enumerate(0);
  }

  [[nodiscard]] double distance() const {
    const std::size_t steps = measured_.front().positions.size();
    std::vector<double> cost(assignments_.size(), 0.0);
    for (std::size_t k = 0; k < steps; ++k) {
      std::vector<double> next(cost.size(), std::numeric_limits<double>::infinity());
      for (std::size_t to = 0; to < cost.size(); ++to) {
        for (std::size_t from = 0; from < cost.size(); ++from) {
          const double change = k == 0 ? 0.0 : switchCost(assignments_[from], assignments_[to]);
          next[to] = std::min(next[to], cost[from] + change);
        }
        next[to] += stepCost(assignments_[to], k);
      }
      cost = next;
    }
    return std::pow(*std::min_element(cost.begin(), cost.end()), 1.0 / options_.set.order);
  }

 private:
  using Assignment = std::vector<int>;  // of each measured track: index of the simulated one, -1 for none

  void enumerate(std::size_t i) {
    if (i == partners_.size()) return assignments_.push_back(partners_);
    for (int j = -1; j < static_cast<int>(simulated_.size()); ++j) {
      if (j >= 0 && std::find(partners_.begin(), partners_.begin() + static_cast<std::ptrdiff_t>(i), j) !=
                        partners_.begin() + static_cast<std::ptrdiff_t>(i)) {
        continue;
      }
      partners_[i] = j;
      enumerate(i + 1);
    }
  }

  [[nodiscard]] double stepCost(const Assignment& assignment, std::size_t k) const {
    const double alone = 0.5 * std::pow(options_.set.cutoff_m, options_.set.order);
    double sum = 0.0;
    for (const TrackList* tracks : {&measured_, &simulated_}) {
      for (const Track& track : *tracks) sum += track.existsAt(k) ? alone : 0.0;
    }
    for (std::size_t i = 0; i < assignment.size(); ++i) {
      if (assignment[i] < 0 || !measured_[i].existsAt(k)) continue;
      const Track& other = simulated_[static_cast<std::size_t>(assignment[i])];
      if (!other.existsAt(k)) continue;
      const double d =
          std::min(options_.set.cutoff_m, metrics::distance(*measured_[i].positions[k], *other.positions[k]));
      sum += std::pow(d, options_.set.order) - 2.0 * alone;
    }
    return sum;
  }

  [[nodiscard]] double switchCost(const Assignment& from, const Assignment& to) const {
    double switches = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i] != to[i]) switches += from[i] < 0 || to[i] < 0 ? 0.5 : 1.0;
    }
    return std::pow(options_.switch_m, options_.set.order) * switches;
  }

  const TrackList& measured_;
  const TrackList& simulated_;
  const TrajectoryOptions& options_;
  Assignment partners_;
  std::vector<Assignment> assignments_;
};

// The relaxation is a lower bound of the assignment; in all but a few of such small cases it is the same.
TEST(TrajectoryDistance, NeverExceedsTheMultiDimensionalAssignmentAndMostlyEqualsIt) {
  RandomObjects cases(81);
  int equal = 0;
  constexpr int kCases = 200;
  for (int k = 0; k < kCases; ++k) {
    TrackList measured = cases.tracks(3, 5, 1.0);
    const TrackList simulated = cases.tracks(3, 5, 1.0);
    if (measured.empty()) measured.push_back(cases.track(5));
    const TrajectoryOptions options{.set = {.order = k % 2 == 0 ? 1.0 : 2.0, .cutoff_m = 3.0},
                                    .switch_m = cases.uniform(0.0, 3.0)};
    const double exact = Exact(measured, simulated, options).distance();
    const double relaxed = between(measured, simulated, options).distance;
    EXPECT_LE(relaxed, exact + 1e-9);
    equal += std::abs(relaxed - exact) < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(equal, kCases * 9 / 10);
}

TEST(TrajectoryDistance, IsAMetricOnSetsOfTracks) {
  RandomObjects cases(82);
  for (int k = 0; k < 200; ++k) {
    const TrackList a = cases.tracks(3, 5, 1.0);
    const TrackList b = cases.tracks(3, 5, 1.0);
    const TrackList c = cases.tracks(3, 5, 1.0);
    const TrajectoryOptions options{.set = {.order = k % 2 == 0 ? 1.0 : 2.0, .cutoff_m = 3.0},
                                    .switch_m = cases.uniform(0.1, 3.0)};
    EXPECT_NEAR(between(a, a, options).distance, 0.0, 1e-9);
    EXPECT_NEAR(between(a, b, options).distance, between(b, a, options).distance, 1e-9);
    EXPECT_LE(between(a, c, options).distance,
              between(a, b, options).distance + between(b, c, options).distance + 1e-9);
  }
}

TEST(TrajectoryDistance, WithFreeSwitchesIsGospaAtEveryStep) {
  RandomObjects cases(83);
  for (int k = 0; k < 50; ++k) {
    const TrackList measured = cases.tracks(4, 6);
    const TrackList simulated = cases.tracks(4, 6);
    const metrics::SetOptions set{.order = 2.0, .cutoff_m = 3.0};
    double sum = 0.0;
    for (std::size_t step = 0; step < 6; ++step) {
      metrics_test::ObjectList lists[2];
      for (const Track& t : simulated) {
        if (t.existsAt(step)) lists[0].push_back({.position = *t.positions[step]});
      }
      for (const Track& t : measured) {
        if (t.existsAt(step)) lists[1].push_back({.position = *t.positions[step]});
      }
      sum += std::pow(gospa({.simulated = lists[0], .measured = lists[1]}, set).distance, 2.0);
    }
    EXPECT_NEAR(between(measured, simulated, {.set = set, .switch_m = 0.0}).distance, std::sqrt(sum), 1e-9);
  }
}

TEST(TrajectoryDistance, GrowsWithTheSwitchingPenalty) {
  RandomObjects cases(84);
  for (int k = 0; k < 50; ++k) {
    const TrackList measured = cases.tracks(4, 6);
    const TrackList simulated = cases.tracks(4, 6);
    double before = 0.0;
    for (const double switch_m : {0.0, 0.5, 1.0, 4.0}) {
      const double d =
          between(measured, simulated, {.set = {.order = 1.0, .cutoff_m = 3.0}, .switch_m = switch_m}).distance;
      EXPECT_GE(d, before - 1e-9);
      before = d;
    }
  }
}

TEST(TrajectoryDistance, PartsAddUpAsPowers) {
  RandomObjects cases(85);
  for (int k = 0; k < 100; ++k) {
    const TrajectoryOptions options{.set = {.order = 2.0, .cutoff_m = 3.0}, .switch_m = 0.7};
    const TrajectoryDistance d = between(cases.tracks(4, 6), cases.tracks(4, 6), options);
    EXPECT_NEAR(d.distance * d.distance,
                d.localisation * d.localisation + 4.5 * (d.missed + d.false_objects) + 0.49 * d.switches, 1e-9);
  }
}

TEST(TrajectoryDistance, PairAtTheCutOffOrOneRoundingBelowIsNone) {
  for (const double d : {5.0, std::nextafter(5.0, 0.0)}) {
    for (const double order : {1.0, 1.1, 2.0, 7.0}) {
      const TrajectoryDistance result =
          between({trackAlongX(0, {0, 0}, 2)}, {trackAlongX(0, {d, d}, 2)}, {.set = {.order = order, .cutoff_m = 5.0}});
      EXPECT_NEAR(result.distance, 5.0 * std::pow(2.0, 1.0 / order), 1e-12);
    }
  }
}

TEST(TrajectoryDistance, RefusesACrowdThatIsTooLarge) {
  const std::size_t steps = metrics::kMostSharesOfTrackMetric / 4 + 1;
  const TrackList two(2, trackAlongX(0, std::vector<double>(steps, 0.0), steps));
  EXPECT_THROW((void)between(two, two, kExample), core::InputError);
}

TEST(TrajectoryDistance, RefusesANegativePenalty) {
  EXPECT_THROW((void)trajectoryDistance({}, {.switch_m = -1.0}), core::InputError);
}

}  // namespace
