#include "gap/joined_hits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace gap {

namespace {

/// Hits of some beams joined into a copy that has sub-rays of its own, one per joined hit.
class Joined {
 public:
  Joined(model::BeamHits& into, double range_bin_m, double left_bin_rad)
      : into_(into), range_bin_m_(range_bin_m), left_bin_rad_(left_bin_rad) {}

  void add(const model::HitsOfBeam& hits, const model::SubRays& rays, std::span<const model::SecondHit> second) {
    sums_.clear();
    for (const model::Hit& hit : hits) sumOf(keyOf(hit, rays), {}).add(hit, rays, {});
    for (const Sum& s : sums_) {
      if (s.weight > 0.0) into_.hits.add(s.mean(into_.rays));
    }
    into_.hits.endBeam();
    sums_.clear();
    // What comes on a second way is weak and spread: a quarter of the pulse apart, it is one part of the echo.
    constexpr double kCoarser = 10.0;
    for (const model::SecondHit& way : second) {
      const std::span turns(way.turns.data(), way.turn_count);
      sumOf(keyOf(way.hit, rays, kCoarser), turns).add(way.hit, rays, turns);
    }
    for (const Sum& s : sums_) {
      if (s.weight > 0.0) into_.second.push_back(s.meanWay(into_.rays));
    }
    if (!into_.first_second.empty()) into_.first_second.push_back(static_cast<std::uint32_t>(into_.second.size()));
  }

 private:
  struct Key {
    std::int32_t object;
    std::int64_t range, left;
    bool operator==(const Key&) const = default;
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

  [[nodiscard]] Key keyOf(const model::Hit& hit, const model::SubRays& rays, double coarser = 1.0) const {
    return {hit.object, static_cast<std::int64_t>(std::floor(hit.range_m / (coarser * range_bin_m_))),
            static_cast<std::int64_t>(std::floor(rays.left_rad[hit.ray] / (coarser * left_bin_rad_)))};
  }
  Sum& sumOf(const Key& key, std::span<const model::Turn> way) {
    const auto found =
        std::find_if(sums_.rbegin(), sums_.rend(), [&](const Sum& s) { return s.key == key && s.cameBy(way); });
    if (found != sums_.rend()) return *found;
    Sum& sum = sums_.emplace_back(Sum{.key = key});
    std::copy(way.begin(), way.end(), sum.turns.begin());
    sum.turn_count = way.size();
    return sum;
  }

  model::BeamHits& into_;
  double range_bin_m_;
  double left_bin_rad_;
  std::vector<Sum> sums_;
};

}  // namespace

model::BeamHits joined(const model::BeamHits& hits, const std::vector<std::uint32_t>& replaced,
                       const model::BeamHits& denser, double range_bin_m, double left_bin_rad) {
  model::BeamHits result;
  result.beams = hits.beams;
  if (!hits.first_second.empty()) result.first_second.push_back(0);
  Joined into(result, range_bin_m, left_bin_rad);
  std::size_t next = 0;
  for (std::uint32_t b = 0; b < hits.beams.size(); ++b) {
    if (next < replaced.size() && replaced[next] == b) {
      into.add(denser.of(next), denser.rays, denser.secondOf(next));
      ++next;
    } else {
      into.add(hits.of(b), hits.rays, hits.secondOf(b));
    }
  }
  return result;
}

}  // namespace gap
