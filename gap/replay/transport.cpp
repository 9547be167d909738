#include "gap/replay/transport.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/grouped.h"
#include "core/random.h"

namespace gap {

namespace {

using Indices = std::vector<std::uint32_t>;

core::Grouped byCell(const std::vector<model::Shot>& shots, const CellLayout& layout) {
  return {layout.cellsOf(shots), layout.cells().size()};
}

constexpr double model::Shot::*kValues[] = {&model::Shot::range_m, &model::Shot::epw_m, &model::Shot::intensity_nw};

std::vector<double> sortedValues(const std::vector<model::Shot>& shots, std::span<const std::uint32_t> of,
                                 double model::Shot::*value) {
  std::vector<double> values;
  values.reserve(of.size());
  for (const std::uint32_t i : of) values.push_back(shots[i].*value);
  std::sort(values.begin(), values.end());
  return values;
}

/// Linear between the middles of the steps of the empirical distribution.
double quantile(const std::vector<double>& sorted, double p) {
  const double place = p * static_cast<double>(sorted.size()) - 0.5;
  if (place <= 0.0) return sorted.front();
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

double shiftedBy(Channel channel, double value, double from, double to) {
  if (channel == kIntensity && from > 0.0 && to > 0.0) return value * (to / from);
  return std::max(0.0, value + (to - from));
}

bool sameShot(const model::Shot& a, const model::Shot& b) {
  return a.beam == b.beam && a.frame == b.frame && a.range_m == b.range_m && a.epw_m == b.epw_m &&
         a.intensity_nw == b.intensity_nw;
}

/// One cell of the three; writes what becomes of the foreign one.
class CellTransport {
 public:
  CellTransport(const std::vector<model::Shot>& foreign, const std::vector<model::Shot>& from,
                const std::vector<model::Shot>& to, TransportNoise noise, std::vector<model::Shot>& out)
      : foreign_(foreign), from_(from), to_(to), noise_(noise), out_(out) {}

  void run(std::span<const std::uint32_t> theirs, std::span<const std::uint32_t> from,
           std::span<const std::uint32_t> to, bool on_a_surface) {
    const bool same = from.size() == to.size() &&
                      std::equal(from.begin(), from.end(), to.begin(),
                                 [&](std::uint32_t a, std::uint32_t b) { return sameShot(from_[a], to_[b]); });
    const std::size_t begin = out_.size();
    const double kept =
        to.size() < from.size() ? static_cast<double>(to.size()) / static_cast<double>(from.size()) : 1.0;
    for (const std::uint32_t i : theirs) {
      if (kept >= 1.0 || chance(foreign_[i]) < kept) out_.push_back(foreign_[i]);
    }
    if (same) return;
    if (on_a_surface && !from.empty() && !to.empty()) move(begin, from, to);
    if (to.size() > from.size()) add(theirs, from, to);
  }

 private:
  /// The same number for the same detection in every world.
  [[nodiscard]] double chance(const model::Shot& shot) const {
    core::Random random({.seed = noise_.seed,
                         .sample = noise_.sample,
                         .frame = static_cast<std::uint32_t>(shot.frame),
                         .beam = shot.beam,
                         .purpose = core::purposeOf("transport loss") + static_cast<std::uint32_t>(shot.echo)});
    return random.uniform();
  }

  void move(std::size_t begin, std::span<const std::uint32_t> from, std::span<const std::uint32_t> to) {
    const std::size_t n = out_.size() - begin;
    Indices rank(n);
    for (const Channel channel : {kRange, kEpw, kIntensity}) {
      const auto value = kValues[channel];
      const auto of_from = sortedValues(from_, from, value), of_to = sortedValues(to_, to, value);
      for (std::uint32_t i = 0; i < n; ++i) rank[i] = i;
      std::stable_sort(rank.begin(), rank.end(), [&](std::uint32_t a, std::uint32_t b) {
        return out_[begin + a].*value < out_[begin + b].*value;
      });
      for (std::size_t r = 0; r < n; ++r) {
        const double p = (static_cast<double>(r) + 0.5) / static_cast<double>(n);
        double& moved = out_[begin + rank[r]].*value;
        moved = shiftedBy(channel, moved, quantile(of_from, p), quantile(of_to, p));
      }
    }
  }

  /// The surplus, spread evenly over the shots of `to`.
  void add(std::span<const std::uint32_t> theirs, std::span<const std::uint32_t> from,
           std::span<const std::uint32_t> to) {
    const std::size_t surplus = to.size() - from.size();
    for (std::size_t k = 0; k < surplus; ++k) {
      model::Shot shot = to_[to[(2 * k + 1) * to.size() / (2 * surplus)]];
      if (!theirs.empty() && !from.empty()) {
        for (const Channel channel : {kRange, kEpw, kIntensity})
          shot.*kValues[channel] =
              shiftedBy(channel, shot.*kValues[channel], mean(from_, from, channel), mean(foreign_, theirs, channel));
      }
      out_.push_back(shot);
    }
  }

  static double mean(const std::vector<model::Shot>& shots, std::span<const std::uint32_t> of, Channel channel) {
    double sum = 0.0;
    for (const std::uint32_t i : of) sum += shots[i].*kValues[channel];
    return sum / static_cast<double>(of.size());
  }

  const std::vector<model::Shot>& foreign_;
  const std::vector<model::Shot>& from_;
  const std::vector<model::Shot>& to_;
  TransportNoise noise_;
  std::vector<model::Shot>& out_;
};

}  // namespace

std::vector<model::Shot> framesFrom(const ForeignFrames& recording, int wanted, std::uint64_t seed) {
  std::vector<std::size_t> first(static_cast<std::size_t>(recording.frames) + 1, 0);
  for (const model::Shot& shot : recording.shots) ++first[static_cast<std::size_t>(shot.frame) + 1];
  for (std::size_t f = 0; f + 1 < first.size(); ++f) first[f + 1] += first[f];

  core::Random random({.seed = seed, .purpose = core::purposeOf("foreign frames")});
  const auto count = static_cast<std::uint32_t>(recording.frames);
  std::vector<std::uint32_t> drawn(count);
  for (std::uint32_t& frame : drawn) frame = random.below(count);
  std::vector<model::Shot> shots;
  for (int f = 0; f < wanted; ++f) {
    const std::size_t frame = seed == 0 ? static_cast<std::size_t>(f) % count : drawn[random.below(count)];
    for (std::size_t i = first[frame]; i < first[frame + 1]; ++i) {
      shots.push_back(recording.shots[i]);
      shots.back().frame = f;
    }
  }
  return shots;
}

std::vector<model::Shot> transported(const std::vector<model::Shot>& foreign, const std::vector<model::Shot>& from,
                                     const std::vector<model::Shot>& to, const CellLayout& layout,
                                     TransportNoise noise) {
  const core::Grouped of_foreign = byCell(foreign, layout), of_from = byCell(from, layout), of_to = byCell(to, layout);
  std::vector<model::Shot> out;
  out.reserve(foreign.size());
  CellTransport transport(foreign, from, to, noise, out);
  for (std::size_t c = 0; c < layout.cells().size(); ++c) {
    transport.run(of_foreign.of(c), of_from.of(c), of_to.of(c), c < layout.surfaces());
  }
  return out;
}

}  // namespace gap
