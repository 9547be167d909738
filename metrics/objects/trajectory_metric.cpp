#include "metrics/objects/trajectory_metric.h"

#include <algorithm>
#include <cmath>
#include <coin/ClpSimplex.hpp>
#include <coin/CoinPackedMatrix.hpp>
#include <fmt/format.h>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

/// Two tracks that are nearer than c at some step. Only such a pair can be worth more together than alone.
struct ClosePair {
  std::size_t measured;
  std::size_t simulated;
  std::vector<double> gain;   ///< per step: c^p - d^p where both exist nearer than c, else 0
  std::vector<double> share;  ///< per step: W, the solution
};

/// What solving needs of the options.
struct Prices {
  double order;
  double cutoff_m;
  double pair;           ///< c^p
  double half_a_switch;  ///< gamma^p / 2
};

std::vector<ClosePair> closePairs(const TrackSets& sets, const Prices& prices) {
  std::vector<ClosePair> pairs;
  for (std::size_t i = 0; i < sets.measured.size(); ++i) {
    for (std::size_t j = 0; j < sets.simulated.size(); ++j) {
      std::vector<double> gain(sets.steps(), 0.0);
      bool close = false;
      for (std::size_t k = 0; k < gain.size(); ++k) {
        if (!sets.measured[i].existsAt(k) || !sets.simulated[j].existsAt(k)) continue;
        const double d = distance(*sets.measured[i].positions[k], *sets.simulated[j].positions[k]);
        if (d >= prices.cutoff_m) continue;
        gain[k] = prices.pair - std::pow(d, prices.order);
        close = close || gain[k] > 0.0;  // just below c rounding may leave no gain
      }
      if (close) pairs.push_back({.measured = i, .simulated = j, .gain = std::move(gain), .share = {}});
    }
  }
  return pairs;
}

/// Pairs that share a track, directly or by others, compete; groups of them do not.
std::vector<std::vector<ClosePair*>> groupsOf(std::vector<ClosePair>& pairs, const TrackSets& sets) {
  std::vector<std::size_t> parent(sets.measured.size() + sets.simulated.size());  // union-find over all tracks
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t track) {
    while (parent[track] != track) track = parent[track] = parent[parent[track]];
    return track;
  };
  for (const ClosePair& pair : pairs) parent[root(sets.measured.size() + pair.simulated)] = root(pair.measured);
  std::vector<std::vector<ClosePair*>> of_root(parent.size());
  for (ClosePair& pair : pairs) of_root[root(pair.measured)].push_back(&pair);
  std::erase_if(of_root, [](const auto& group) { return group.empty(); });
  return of_root;
}

/// The simplex method is right to about 1e-7; whole shares should be whole.
double withoutSolverNoise(double share) {
  const double whole = std::round(share);
  return std::abs(share - whole) < 1e-7 ? whole : share;
}

/// The linear program of one group: maximise what pairs gain, less what changes of W cost.
///
///   columns  W(pair, k) in [0, 1]; rise(pair, k), fall(pair, k) >= 0 for all steps but the first
///   rows     W(pair, k) - W(pair, k-1) - rise + fall = 0;   at each step the W of a track sum to at most 1
///
/// Steps at which nothing is gained are left out: W may stay as it was, so they cost nothing.
class GroupProgram {
 public:
  GroupProgram(const std::vector<ClosePair*>& group, const Prices& prices) : group_(group) {
    for (std::size_t k = 0; k < group.front()->gain.size(); ++k) {
      if (std::ranges::any_of(group, [k](const ClosePair* pair) { return pair->gain[k] > 0.0; })) steps_.push_back(k);
    }
    mustNotBeTooLarge();
    addShares();
    addChanges(prices.half_a_switch);
    addSums(&ClosePair::measured);
    addSums(&ClosePair::simulated);
  }

  /// Writes W into the pairs.
  void solve() {
    const CoinPackedMatrix matrix(false, row_of_.data(), column_of_.data(), element_.data(),
                                  static_cast<CoinBigIndex>(element_.size()));
    ClpSimplex simplex;
    simplex.setLogLevel(0);
    simplex.scaling(0);  // all elements are 1 or -1
    simplex.setPrimalTolerance(1e-9);
    simplex.setDualTolerance(1e-9);
    simplex.loadProblem(matrix, column_low_.data(), column_high_.data(), objective_.data(), row_low_.data(),
                        row_high_.data());
    simplex.primal();  // W = 0 is feasible
    if (!simplex.isProvenOptimal()) {
      throw core::InputError({.item = "tracks"}, "made a linear program that the simplex method did not solve.",
                             "Compare fewer tracks or a shorter time at once.");
    }
    const double* solution = simplex.getColSolution();
    for (std::size_t p = 0; p < group_.size(); ++p) keepShares(*group_[p], solution + p * steps_.size());
  }

 private:
  void mustNotBeTooLarge() const {
    if (group_.size() * steps_.size() <= kMostSharesOfTrackMetric) return;
    throw core::InputError(
        {.item = "tracks"},
        fmt::format("come near each other in {} pairs over {} steps; the track metric takes at most {} pair-steps.",
                    group_.size(), steps_.size(), kMostSharesOfTrackMetric),
        "Take a smaller cut-off, fewer steps at once, or OSPA-T.");
  }

  void addShares() {
    for (const ClosePair* pair : group_) {
      for (const std::size_t k : steps_) addColumn(1.0, -pair->gain[k]);
    }
  }

  void addChanges(double half_a_switch) {
    for (std::size_t p = 0; p < group_.size(); ++p) {
      for (std::size_t s = 1; s < steps_.size(); ++s) {
        const int row = addRow(0.0, 0.0);
        addElement(row, share(p, s), 1.0);
        addElement(row, share(p, s - 1), -1.0);
        addElement(row, addColumn(COIN_DBL_MAX, half_a_switch), -1.0);
        addElement(row, addColumn(COIN_DBL_MAX, half_a_switch), 1.0);
      }
    }
  }

  void addSums(std::size_t ClosePair::*track) {
    std::vector<std::size_t> tracks;
    for (const ClosePair* pair : group_) tracks.push_back(pair->*track);
    std::ranges::sort(tracks);
    const auto repeated = std::ranges::unique(tracks);
    tracks.erase(repeated.begin(), repeated.end());
    for (const std::size_t one : tracks) {
      for (std::size_t s = 0; s < steps_.size(); ++s) {
        const int row = addRow(-COIN_DBL_MAX, 1.0);
        for (std::size_t p = 0; p < group_.size(); ++p) {
          if (group_[p]->*track == one) addElement(row, share(p, s), 1.0);
        }
      }
    }
  }

  void keepShares(ClosePair& pair, const double* shares) {
    pair.share.assign(pair.gain.size(), 0.0);
    std::size_t s = 0;
    for (std::size_t k = 0; k < pair.share.size(); ++k) {
      if (s < steps_.size() && steps_[s] == k) ++s;
      pair.share[k] = withoutSolverNoise(shares[s == 0 ? 0 : s - 1]);
    }
  }

  [[nodiscard]] int share(std::size_t pair, std::size_t step) const {
    return static_cast<int>(pair * steps_.size() + step);
  }

  int addColumn(double high, double cost) {
    column_low_.push_back(0.0);
    column_high_.push_back(high);
    objective_.push_back(cost);
    return static_cast<int>(objective_.size()) - 1;
  }

  int addRow(double low, double high) {
    row_low_.push_back(low);
    row_high_.push_back(high);
    return static_cast<int>(row_low_.size()) - 1;
  }

  void addElement(int row, int column, double value) {
    row_of_.push_back(row);
    column_of_.push_back(column);
    element_.push_back(value);
  }

  const std::vector<ClosePair*>& group_;
  std::vector<std::size_t> steps_;  // those at which something can be gained
  std::vector<double> column_low_;
  std::vector<double> column_high_;
  std::vector<double> objective_;
  std::vector<double> row_low_;
  std::vector<double> row_high_;
  std::vector<int> row_of_;
  std::vector<int> column_of_;
  std::vector<double> element_;
};

double existingSteps(std::span<const Track> tracks) {
  std::size_t count = 0;
  for (const Track& track : tracks) {
    count +=
        static_cast<std::size_t>(std::ranges::count_if(track.positions, [](const auto& p) { return p.has_value(); }));
  }
  return static_cast<double>(count);
}

/// The parts of the distance that the solution W has.
TrajectoryDistance distanceOf(const TrackSets& sets, const std::vector<ClosePair>& pairs, const Prices& prices) {
  Summation localisation;
  Summation together;
  Summation changes;
  for (const ClosePair& pair : pairs) {
    for (std::size_t k = 0; k < pair.gain.size(); ++k) {
      if (pair.gain[k] > 0.0) {
        together.add(pair.share[k]);
        localisation.add(pair.share[k] * (prices.pair - pair.gain[k]));
      }
      if (k > 0) changes.add(std::abs(pair.share[k] - pair.share[k - 1]));
    }
  }
  const double missed = existingSteps(sets.measured) - together.value();
  const double false_objects = existingSteps(sets.simulated) - together.value();
  const double sum =
      localisation.value() + 0.5 * prices.pair * (missed + false_objects) + prices.half_a_switch * changes.value();
  const auto root = [&](double power) { return std::pow(std::max(0.0, power), 1.0 / prices.order); };
  return {.distance = root(sum),
          .localisation = root(localisation.value()),
          .missed = missed,
          .false_objects = false_objects,
          .switches = 0.5 * changes.value()};
}

}  // namespace

TrajectoryDistance trajectoryDistance(const TrackSets& sets, const TrajectoryOptions& options) {
  mustBeValid(sets);
  mustBeValid(options.set);
  mustBePenalty(options.switch_m, "switching penalty");
  const Prices prices{.order = options.set.order,
                      .cutoff_m = options.set.cutoff_m,
                      .pair = std::pow(options.set.cutoff_m, options.set.order),
                      .half_a_switch = 0.5 * std::pow(options.switch_m, options.set.order)};
  std::vector<ClosePair> pairs = closePairs(sets, prices);
  for (const std::vector<ClosePair*>& group : groupsOf(pairs, sets)) GroupProgram(group, prices).solve();
  return distanceOf(sets, pairs, prices);
}

}  // namespace metrics
