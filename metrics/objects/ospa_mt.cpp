#include "metrics/objects/ospa_mt.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "core/error.h"

namespace metrics {

namespace {

struct Prices {
  double order;
  double cutoff_m;
  double alone;  ///< c^p
  double piece;  ///< Delta^p
};

/// What a piece saves against none, step by step, if it is assigned to one whole track.
struct Alternative {
  std::size_t whole;
  std::vector<double> gain;  ///< c^p - d^p where both exist nearer than c, else 0
  double total;
  double most;  ///< that it can add to any assignment: what it saves, and the price of those whose steps it takes over
};

std::vector<Alternative> alternativesOf(const Track& piece, std::span<const Track> wholes, const Prices& prices) {
  std::vector<Alternative> alternatives;
  for (std::size_t i = 0; i < wholes.size(); ++i) {
    Alternative one{.whole = i, .gain = std::vector<double>(piece.positions.size(), 0.0), .total = 0.0, .most = 0.0};
    for (std::size_t k = 0; k < one.gain.size(); ++k) {
      if (!piece.existsAt(k) || !wholes[i].existsAt(k)) continue;
      const double d = distance(*piece.positions[k], *wholes[i].positions[k]);
      if (d >= prices.cutoff_m) continue;
      one.gain[k] = prices.alone - std::pow(d, prices.order);
      one.total += one.gain[k];
      one.most += one.gain[k] + prices.piece;
    }
    if (one.total > 0.0) alternatives.push_back(std::move(one));
  }
  return alternatives;
}

/// The pieces that are assigned to one whole track.
class Wholes {
 public:
  Wholes(std::size_t count, const Prices& prices) : assigned_(count), prices_(prices) {}

  void add(const Alternative& piece) { assigned_[piece.whole].push_back(&piece); }
  void removeFrom(std::size_t whole) { assigned_[whole].pop_back(); }

  /// What all pieces of a track save: the nearest at each step, less the price of all but the longest.
  [[nodiscard]] double saved(std::size_t whole) const {
    const auto& pieces = assigned_[whole];
    if (pieces.empty()) return 0.0;
    double sum = 0.0;
    std::vector<std::size_t> matched(pieces.size(), 0);
    for (std::size_t k = 0; k < pieces.front()->gain.size(); ++k) {
      std::size_t nearest = 0;
      for (std::size_t p = 1; p < pieces.size(); ++p) {
        if (pieces[p]->gain[k] > pieces[nearest]->gain[k]) nearest = p;
      }
      if (pieces[nearest]->gain[k] <= 0.0) continue;
      sum += pieces[nearest]->gain[k];
      ++matched[nearest];
    }
    std::size_t further = 0;
    for (const std::size_t steps : matched) further += steps;
    further -= *std::max_element(matched.begin(), matched.end());
    return sum - prices_.piece * static_cast<double>(further);
  }

  [[nodiscard]] std::size_t furtherPieces() const {
    std::size_t count = 0;
    for (const auto& pieces : assigned_) count += pieces.size() > 1 ? pieces.size() - 1 : 0;
    return count;
  }

 private:
  std::vector<std::vector<const Alternative*>> assigned_;
  const Prices& prices_;
};

struct Best {
  double saved = 0.0;
  std::size_t pieces = 0;
};

/// Depth first over the pieces: each belongs to one of its alternatives or to none. A branch ends where even the best
/// of all that is left cannot catch up.
class Search {
 public:
  Search(const TrackSets& sets, const Prices& prices) : wholes_(sets.measured.size(), prices) {
    for (const Track& piece : sets.simulated) {
      alternatives_.push_back(alternativesOf(piece, sets.measured, prices));
      std::ranges::sort(alternatives_.back(), [](auto& a, auto& b) { return a.total > b.total; });
    }
    hope_.assign(alternatives_.size() + 1, 0.0);
    for (std::size_t j = alternatives_.size(); j-- > 0;) {
      double most = 0.0;
      for (const Alternative& one : alternatives_[j]) most = std::max(most, one.most);
      hope_[j] = hope_[j + 1] + most;
    }
  }

  Best run() {
    visit(0, 0.0);
    return best_;
  }

 private:
  void visit(std::size_t j, double saved) {
    if (++tried_ > kMostAssignmentsOfOspaMt) {
      throw core::InputError({.item = "tracks"}, "come near each other in too many ways for OSPA-MT.",
                             "Take a smaller cut-off, fewer tracks or a shorter time at once, or OSPA(2).");
    }
    if (saved > best_.saved) best_ = {.saved = saved, .pieces = wholes_.furtherPieces()};
    if (j == alternatives_.size() || saved + hope_[j] <= best_.saved) return;
    for (const Alternative& one : alternatives_[j]) {
      const double before = wholes_.saved(one.whole);
      wholes_.add(one);
      visit(j + 1, saved - before + wholes_.saved(one.whole));
      wholes_.removeFrom(one.whole);
    }
    visit(j + 1, saved);
  }

  std::vector<std::vector<Alternative>> alternatives_;
  std::vector<double> hope_;  ///< most that the pieces from j on can add
  Wholes wholes_;
  Best best_;
  std::size_t tried_ = 0;
};

std::size_t existingAt(std::size_t step, std::span<const Track> tracks) {
  return static_cast<std::size_t>(std::ranges::count_if(tracks, [step](const Track& t) { return t.existsAt(step); }));
}

void mustBeValid(const MultiTrackOptions& options) {
  metrics::mustBeValid(options.set);
  mustBePenalty(options.piece_m, "penalty of a piece");
  if (options.piece_m <= options.set.cutoff_m) return;
  throw core::InputError(
      {.item = "penalty of a piece"},
      fmt::format("is {} m; it must not exceed the cut-off {} m.", options.piece_m, options.set.cutoff_m),
      "Take at most the cut-off: as much as a missing object.");
}

}  // namespace

MultiTrackOspa ospaMt(const TrackSets& sets, const MultiTrackOptions& options) {
  metrics::mustBeValid(sets);
  mustBeValid(options);
  const Prices prices{.order = options.set.order,
                      .cutoff_m = options.set.cutoff_m,
                      .alone = std::pow(options.set.cutoff_m, options.set.order),
                      .piece = std::pow(options.piece_m, options.set.order)};
  std::size_t objects = 0;
  for (std::size_t k = 0; k < sets.steps(); ++k) {
    objects += std::max(existingAt(k, sets.simulated), existingAt(k, sets.measured));
  }
  if (objects == 0) return {};
  const Best broken_simulation = Search(sets, prices).run();
  const Best broken_measurement = Search({.simulated = sets.measured, .measured = sets.simulated}, prices).run();
  const Best& best = broken_measurement.saved > broken_simulation.saved ? broken_measurement : broken_simulation;
  const double mean = prices.alone - best.saved / static_cast<double>(objects);
  return {.distance = std::pow(std::max(0.0, mean), 1.0 / prices.order), .pieces = best.pieces};
}

}  // namespace metrics
