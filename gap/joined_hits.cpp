#include "gap/joined_hits.h"

#include <algorithm>
#include <cmath>

namespace gap {

namespace {

/// Hits of some beams joined into a copy that has sub-rays of its own, one per joined hit.
class Joined {
 public:
  Joined(model::BeamHits& into, double range_bin_m, double left_bin_rad)
      : into_(into), range_bin_m_(range_bin_m), left_bin_rad_(left_bin_rad) {}

  void add(const model::HitsOfBeam& hits, const model::SubRays& rays, std::span<const model::SecondHit> second) {
    sums_.clear();
    for (const model::Hit& hit : hits) {
      const double left = rays.left_rad[hit.ray], weight = rays.weight[hit.ray];
      Sum& sum = sumOf({hit.object, static_cast<std::int64_t>(std::floor(hit.range_m / range_bin_m_)),
                        static_cast<std::int64_t>(std::floor(left / left_bin_rad_))});
      sum.weight += weight;
      sum.range += weight * hit.range_m;
      sum.cosine += weight * static_cast<double>(hit.cos_incidence);
      sum.left += weight * left;
      sum.up += weight * rays.up_rad[hit.ray];
    }
    for (const Sum& s : sums_) {
      if (s.weight <= 0.0) continue;
      into_.hits.add({s.range / s.weight, static_cast<float>(s.cosine / s.weight), s.key.object,
                      into_.rays.add(s.left / s.weight, s.up / s.weight, s.weight)});
    }
    into_.hits.endBeam();
    for (model::SecondHit hit : second) {
      const std::uint32_t ray = hit.hit.ray;
      hit.hit.ray = into_.rays.add(rays.left_rad[ray], rays.up_rad[ray], rays.weight[ray]);
      into_.second.push_back(hit);
    }
    if (!into_.first_second.empty()) into_.first_second.push_back(static_cast<std::uint32_t>(into_.second.size()));
  }

 private:
  struct Key {
    std::int32_t object;
    std::int64_t range, left;
    bool operator==(const Key&) const = default;
  };
  struct Sum {
    Key key;
    double weight = 0.0, range = 0.0, cosine = 0.0, left = 0.0, up = 0.0;
  };
  Sum& sumOf(const Key& key) {
    const auto found = std::find_if(sums_.rbegin(), sums_.rend(), [&](const Sum& s) { return s.key == key; });
    return found == sums_.rend() ? sums_.emplace_back(Sum{key}) : *found;
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
