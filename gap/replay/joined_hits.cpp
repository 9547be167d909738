#include "gap/replay/joined_hits.h"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace gap {

namespace {

/// Sub-rays, and in which bin to the left each is.
struct BinnedRays {
  BinnedRays(const model::SubRays& of, double bin_rad) : rays(of) {
    left_bin.reserve(of.size());
    for (const double left_rad : of.left_rad)
      left_bin.push_back(static_cast<std::int32_t>(std::floor(left_rad / bin_rad)));
  }
  const model::SubRays& rays;
  std::vector<std::int32_t> left_bin;
};

/// Hits of some beams joined into a copy that has sub-rays of its own, one per joined hit.
class Joined {
 public:
  Joined(model::BeamHits& into, double range_bin_m) : into_(into), bins_per_m_(1.0 / range_bin_m) {}

  void add(const model::HitsOfBeam& hits, const BinnedRays& binned, std::span<const model::SecondHit> second) {
    begin(hits.size());
    for (const model::Hit& hit : hits) sumOf(keyOf(hit, binned), {}).add(hit, binned.rays, {});
    for (const Sum& s : sums_) {
      if (s.weight > 0.0) into_.hits.add(s.mean(into_.rays));
    }
    into_.hits.endBeam();
    begin(second.size());
    // What comes on a second way is weak and spread: a quarter of the pulse apart, it is one part of the echo.
    constexpr std::int32_t kCoarser = 10;
    for (const model::SecondHit& way : second) {
      const std::span turns(way.turns.data(), way.turn_count);
      sumOf(keyOf(way.hit, binned, kCoarser), turns).add(way.hit, binned.rays, turns);
    }
    for (const Sum& s : sums_) {
      if (s.weight > 0.0) into_.second.push_back(s.meanWay(into_.rays));
    }
    if (!into_.first_second.empty()) into_.first_second.push_back(static_cast<std::uint32_t>(into_.second.size()));
  }

 private:
  struct Key {
    std::int32_t object, range, left;
    bool operator==(const Key&) const = default;
    [[nodiscard]] std::size_t hash() const noexcept {
      std::size_t hash = 0;
      for (const std::int32_t part : {object, range, left}) boost::hash_combine(hash, part);
      return hash;
    }
  };
  /// Weighted sums over hits that came on the same way.
  struct Sum {
    Key key;
    double weight = 0.0, range = 0.0, cosine = 0.0, left = 0.0, up = 0.0;
    std::array<model::Turn, model::SecondHit::kMostTurns> turns{};
    std::array<double, model::SecondHit::kMostTurns> turn_cosine{};
    std::size_t turn_count = 0;

    void add(const model::Hit& hit, const model::SubRays& rays, std::span<const model::Turn> way) {
      const double share = rays.weight[hit.ray];
      weight += share;
      range += share * hit.range_m;
      cosine += share * static_cast<double>(hit.cos_incidence);
      left += share * rays.left_rad[hit.ray];
      up += share * rays.up_rad[hit.ray];
      for (std::size_t t = 0; t < way.size(); ++t) turn_cosine[t] += share * static_cast<double>(way[t].cos_incidence);
    }
    [[nodiscard]] bool cameBy(std::span<const model::Turn> way) const {
      return std::equal(
          turns.begin(), turns.begin() + static_cast<std::ptrdiff_t>(turn_count), way.begin(), way.end(),
          [](const model::Turn& a, const model::Turn& b) { return a.mirrored == b.mirrored && a.object == b.object; });
    }
    /// Adds its sub-ray to the others.
    [[nodiscard]] model::Hit mean(model::SubRays& rays) const {
      return {range / weight, static_cast<float>(cosine / weight), key.object,
              rays.add(left / weight, up / weight, weight)};
    }
    [[nodiscard]] model::SecondHit meanWay(model::SubRays& rays) const {
      model::SecondHit way{mean(rays), turns, turn_count};
      for (std::size_t t = 0; t < turn_count; ++t)
        way.turns[t].cos_incidence = static_cast<float>(turn_cosine[t] / weight);
      return way;
    }
  };

  [[nodiscard]] Key keyOf(const model::Hit& hit, const BinnedRays& binned, std::int32_t coarser = 1) const {
    const std::int32_t left = binned.left_bin[hit.ray];
    return {hit.object, static_cast<std::int32_t>(hit.range_m * bins_per_m_ / coarser),  // ranges are positive
            left >= 0 ? left / coarser : (left + 1) / coarser - 1};
  }
  /// Forgets the sums; `most` are to come.
  void begin(std::size_t most) {
    sums_.clear();
    slots_.assign(std::bit_ceil(2 * most + 1), kFree);
  }
  /// Found by open addressing: a dense beam has thousands of hits and hundreds of sums.
  Sum& sumOf(const Key& key, std::span<const model::Turn> way) {
    const std::size_t last = slots_.size() - 1;
    std::size_t slot = key.hash() & last;
    for (; slots_[slot] != kFree; slot = (slot + 1) & last) {
      Sum& known = sums_[slots_[slot]];
      if (known.key == key && known.cameBy(way)) return known;
    }
    slots_[slot] = static_cast<std::uint32_t>(sums_.size());
    Sum& sum = sums_.emplace_back(Sum{.key = key});
    std::copy(way.begin(), way.end(), sum.turns.begin());
    sum.turn_count = way.size();
    return sum;
  }

  static constexpr std::uint32_t kFree = 0xffffffff;
  model::BeamHits& into_;
  double bins_per_m_;
  std::vector<Sum> sums_;             ///< in the order of their first hits
  std::vector<std::uint32_t> slots_;  ///< places in sums_; at most half of them are taken
};

}  // namespace

model::BeamHits joined(const model::BeamHits& hits, const std::vector<std::uint32_t>& replaced,
                       const model::BeamHits& denser, double range_bin_m, double left_bin_rad) {
  model::BeamHits result;
  result.beams = hits.beams;
  if (!hits.first_second.empty()) result.first_second.push_back(0);
  const BinnedRays rays(hits.rays, left_bin_rad), denser_rays(denser.rays, left_bin_rad);
  Joined into(result, range_bin_m);
  std::size_t next = 0;
  for (std::uint32_t b = 0; b < hits.beams.size(); ++b) {
    if (next < replaced.size() && replaced[next] == b) {
      into.add(denser.of(next), denser_rays, denser.secondOf(next));
      ++next;
    } else {
      into.add(hits.of(b), rays, hits.secondOf(b));
    }
  }
  // Thousands of these are remembered: what they grew by for hits that did not come would be as much again.
  const auto fit = [](auto&... columns) { (columns.shrink_to_fit(), ...); };
  fit(result.hits.first, result.hits.range_m, result.hits.cos_incidence, result.hits.object, result.hits.ray,
      result.rays.left_rad, result.rays.up_rad, result.rays.weight, result.second, result.first_second);
  return result;
}

}  // namespace gap
