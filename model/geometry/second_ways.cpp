#include "model/geometry/second_ways.h"

#include <algorithm>
#include <utility>

namespace model {

namespace {

/// A way begins this far behind the surface that it left, so as not to meet it again.
constexpr double kStepOff_m = 1e-4;

Vector3 mirrored(const Vector3& d, const Vector3& normal) {
  const double along = d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2];
  return {d[0] - 2.0 * along * normal[0], d[1] - 2.0 * along * normal[1], d[2] - 2.0 * along * normal[2]};
}

}  // namespace

bool WaysOn::leadFrom(std::int32_t object) const {
  const auto index = static_cast<std::size_t>(object);
  return rules_.through[index] || rules_.mirrored[index];
}

void WaysOn::begin(const Ray& ray, const RayHit& met, std::uint32_t sub_ray) {
  begun_.push_back(ways_.size());
  Way& way = ways_.emplace_back();
  way.ray = ray;
  way.path.hit.ray = sub_ray;
  turn(begun_.back(), met);
}

void WaysOn::turn(std::size_t way, const RayHit& met) {
  const Way from = ways_[way];  // a copy: the list grows
  if (from.path.turn_count >= std::min(rules_.most_turns, SecondHit::kMostTurns)) return;
  const auto object = static_cast<std::size_t>(met.object);
  ways_[way].next = ways_.size();
  for (const bool mirror : {true, false}) {
    if (!(mirror ? rules_.mirrored : rules_.through)[object]) continue;
    Way next{from.ray, from.length_m + met.range_m + kStepOff_m, from.path, 0, 0};
    next.path.turns[next.path.turn_count++] = {mirror, met.object, static_cast<float>(met.cos_incidence)};
    if (mirror) next.ray.direction = mirrored(from.ray.direction, met.normal);
    for (std::size_t k = 0; k < 3; ++k)
      next.ray.origin_m[k] += met.range_m * from.ray.direction[k] + kStepOff_m * next.ray.direction[k];
    open_.push_back(ways_.size());
    ways_.push_back(next);
    ++ways_[way].count;
  }
}

void WaysOn::follow() {
  std::vector<Ray> rays;
  std::vector<RayHit> met;
  while (!open_.empty()) {
    const std::vector<std::size_t> traced = std::exchange(open_, {});
    rays.clear();
    for (const std::size_t way : traced) rays.push_back(ways_[way].ray);
    met.resize(rays.size());
    tracer_.trace(rays, met);
    for (std::size_t i = 0; i < traced.size(); ++i) {
      if (met[i].object < 0) continue;
      turn(traced[i], met[i]);  // before the path has a hit: what goes on from here begins without one
      Way& way = ways_[traced[i]];
      way.path.hit.range_m = way.length_m + met[i].range_m;
      way.path.hit.cos_incidence = static_cast<float>(met[i].cos_incidence);
      way.path.hit.object = met[i].object;
    }
  }
}

void WaysOn::append(const Way& way, std::vector<SecondHit>& hits) const {
  if (way.path.hit.object >= 0) hits.push_back(way.path);
  for (std::size_t i = 0; i < way.count; ++i) append(ways_[way.next + i], hits);
}

void WaysOn::finish(std::vector<SecondHit>& hits) {
  follow();
  for (const std::size_t way : begun_) append(ways_[way], hits);
  ways_.clear();
  begun_.clear();
}

}  // namespace model
