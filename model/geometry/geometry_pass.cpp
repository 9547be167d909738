#include "model/geometry/geometry_pass.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace model {

namespace {

/// A surface nearer than this touches the sensor: the beam is lost in it, and 1/r² means nothing there.
constexpr double kNearest_m = 1e-3;
/// A second way begins this far behind the surface that it left, so as not to meet it again.
constexpr double kStepOff_m = 1e-4;
constexpr std::size_t kLanes = RayPacket::kRays;

enum Axis : std::size_t { kForwardX, kForwardY, kForwardZ, kLeftX, kLeftY, kUpX, kUpY, kUpZ, kAxes };
enum Part : std::size_t { kForward, kLeft, kUp, kParts };

std::vector<float> axesOf(std::span<const Beam> beams) {
  std::vector<float> axes;
  axes.reserve(kAxes * beams.size());
  for (const Beam& beam : beams) {
    const double ca = std::cos(beam.azimuth_rad), sa = std::sin(beam.azimuth_rad);
    const double ce = std::cos(beam.elevation_rad), se = std::sin(beam.elevation_rad);
    for (const double component : {ce * ca, ce * sa, se, -sa, ca, -se * ca, -se * sa, ce}) {
      axes.push_back(static_cast<float>(component));
    }
  }
  return axes;
}

std::vector<float> offsetsOf(const SubRays& rays) {
  std::vector<float> offsets;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double l = std::tan(rays.left_rad[i]), u = std::tan(rays.up_rad[i]);
    const double length = std::sqrt(1.0 + l * l + u * u);
    for (const double part : {1.0 / length, l / length, u / length}) offsets.push_back(static_cast<float>(part));
  }
  return offsets;
}

/// Unit direction of one sub-ray into a lane.
void aimLane(RayPacket& packet, std::size_t lane, const float* axis, const float* part) {
  packet.direction_x[lane] = part[kForward] * axis[kForwardX] + part[kLeft] * axis[kLeftX] + part[kUp] * axis[kUpX];
  packet.direction_y[lane] = part[kForward] * axis[kForwardY] + part[kLeft] * axis[kLeftY] + part[kUp] * axis[kUpY];
  packet.direction_z[lane] = part[kForward] * axis[kForwardZ] + part[kUp] * axis[kUpZ];
}

/// |cos| of the incidence angles of a packet: d and the normal, which is not of unit length.
void cosinesOf(const RayPacket& p, float* cosines) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float along =
        p.direction_x[i] * p.normal_x[i] + p.direction_y[i] * p.normal_y[i] + p.direction_z[i] * p.normal_z[i];
    const float square = p.normal_x[i] * p.normal_x[i] + p.normal_y[i] * p.normal_y[i] + p.normal_z[i] * p.normal_z[i];
    cosines[i] = std::min(1.0F, std::abs(along) / std::sqrt(square));
  }
}

Vector3 mirrored(const Vector3& d, const Vector3& normal) {
  const double along = d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2];
  return {d[0] - 2.0 * along * normal[0], d[1] - 2.0 * along * normal[1], d[2] - 2.0 * along * normal[2]};
}

}  // namespace

GeometryPass::GeometryPass(const RayTracer& tracer, std::span<const Beam> beams, SubRays rays, const Vector3& origin_m,
                           SecondWays second)
    : tracer_(tracer),
      beams_(beams),
      rays_(std::move(rays)),
      origin_m_(origin_m),
      second_(std::move(second)),
      axes_(axesOf(beams)),
      offsets_(offsetsOf(rays_)) {
  timed_ = std::any_of(beams.begin(), beams.end(), [](const Beam& beam) { return beam.scene_time_s != 0.0; });
}

Ray GeometryPass::rayOf(std::size_t beam, std::size_t ray) const {
  return {origin_m_, directionOf(beams_[beam], rays_.left_rad[ray], rays_.up_rad[ray]), beams_[beam].scene_time_s};
}

/// Sub-rays of neighbouring beams fill the packets one after the other; spare lanes at the end repeat the last one.
void GeometryPass::aimPackets(std::size_t begin, std::size_t end, std::vector<RayPacket>& packets) const {
  const std::size_t per_beam = rays_.size(), count = (end - begin) * per_beam;
  const std::size_t needed = (count + kLanes - 1) / kLanes;
  const std::size_t had = packets.size();
  packets.resize(needed);
  for (std::size_t p = 0; p < needed; ++p) p < had ? packets[p].rewind() : packets[p].reset(origin_m_);
  std::size_t at = 0;
  const auto aim = [&](std::size_t beam, std::size_t ray) {
    RayPacket& packet = packets[at / kLanes];
    aimLane(packet, at % kLanes, &axes_[kAxes * beam], &offsets_[kParts * ray]);
    if (timed_) packet.time[at % kLanes] = tracer_.timeOf(beams_[beam].scene_time_s);
    ++at;
  };
  for (std::size_t b = begin; b < end; ++b) {
    for (std::size_t r = 0; r < per_beam; ++r) aim(b, r);
  }
  while (at < needed * kLanes) aim(end - 1, per_beam - 1);
}

void GeometryPass::collect(std::size_t begin, std::size_t end, Tile& tile) const {
  const std::size_t per_beam = rays_.size();
  Hits& hits = tile.hits;
  const std::size_t most = (end - begin) * per_beam;
  hits.range_m.resize(most);
  hits.cos_incidence.resize(most);
  hits.object.resize(most);
  hits.ray.resize(most);
  std::size_t kept = 0, at = 0;
  alignas(64) float cosines[kLanes];
  for (std::size_t b = begin; b < end; ++b) {
    for (std::size_t r = 0; r < per_beam; ++r, ++at) {
      const RayPacket& packet = tile.packets[at / kLanes];
      const std::size_t lane = at % kLanes;
      if (lane == 0) cosinesOf(packet, cosines);
      // Written in any case, kept if something was met: no branch that a processor could guess wrongly.
      hits.range_m[kept] = static_cast<double>(packet.range_m[lane]);
      hits.cos_incidence[kept] = cosines[lane];
      hits.object[kept] = tracer_.objectOf(packet, lane);
      hits.ray[kept] = static_cast<std::uint32_t>(r);
      kept += static_cast<std::size_t>(packet.geometry[lane] != RayPacket::kNothing &&
                                       packet.range_m[lane] >= static_cast<float>(kNearest_m));
    }
    hits.first.push_back(static_cast<std::uint32_t>(kept));
  }
  hits.range_m.resize(kept);
  hits.cos_incidence.resize(kept);
  hits.object.resize(kept);
  hits.ray.resize(kept);
}

void GeometryPass::collectExactly(std::size_t begin, std::size_t end, Tile& tile) const {
  std::size_t at = 0;
  alignas(64) float cosines[kLanes];
  for (std::size_t b = begin; b < end; ++b) {
    for (std::size_t r = 0; r < rays_.size(); ++r, ++at) {
      const RayPacket& packet = tile.packets[at / kLanes];
      const std::size_t lane = at % kLanes;
      if (lane == 0) cosinesOf(packet, cosines);
      const std::int32_t object = tracer_.objectOf(packet, lane);
      if (object < 0) continue;
      Hit hit{packet.range_m[lane], cosines[lane], object, static_cast<std::uint32_t>(r)};
      if (!tracer_.isFaceted(object)) {
        const RayHit exact = tracer_.exactly(rayOf(b, r), packet, lane);
        hit.range_m = exact.range_m;
        hit.cos_incidence = static_cast<float>(exact.cos_incidence);
      }
      if (hit.range_m >= kNearest_m) tile.hits.add(hit);
    }
    tile.hits.endBeam();
  }
}

/// Goes on behind panes and by way of mirrors, one ray at a time: such surfaces are few.
void GeometryPass::follow(std::size_t begin, std::size_t end, Tile& tile) const {
  tile.second.clear();
  tile.first_second.assign(1, 0);
  struct Open {
    Ray ray;
    double length_m;
    SecondHit path;
  };
  std::vector<Open> open;
  const auto turnAt = [&](const Open& from, const RayHit& met) {
    if (from.path.turn_count >= std::min(second_.most_turns, SecondHit::kMostTurns)) return;
    const auto object = static_cast<std::size_t>(met.object);
    for (const bool mirror : {false, true}) {
      if (!(mirror ? second_.mirrored : second_.through)[object]) continue;
      Open next = from;
      next.path.turns[next.path.turn_count++] = {mirror, met.object, static_cast<float>(met.cos_incidence)};
      next.length_m += met.range_m;
      if (mirror) next.ray.direction = mirrored(from.ray.direction, met.normal);
      for (std::size_t k = 0; k < 3; ++k) {
        next.ray.origin_m[k] += met.range_m * from.ray.direction[k] + kStepOff_m * next.ray.direction[k];
      }
      next.length_m += kStepOff_m;
      open.push_back(next);
    }
  };
  for (std::size_t b = begin; b < end; ++b) {
    for (const Hit& first : HitsOfBeam(tile.hits, b - begin)) {
      const auto object = static_cast<std::size_t>(first.object);
      if (!second_.through[object] && !second_.mirrored[object]) continue;
      Open start{rayOf(b, first.ray), 0.0, {}};
      start.path.hit.ray = first.ray;
      RayHit met;
      tracer_.trace(std::span(&start.ray, 1), std::span(&met, 1));
      if (met.object >= 0) turnAt(start, met);
      while (!open.empty()) {
        Open way = open.back();
        open.pop_back();
        tracer_.trace(std::span(&way.ray, 1), std::span(&met, 1));
        if (met.object < 0) continue;
        turnAt(way, met);
        way.path.hit.range_m = way.length_m + met.range_m;
        way.path.hit.cos_incidence = static_cast<float>(met.cos_incidence);
        way.path.hit.object = met.object;
        tile.second.push_back(way.path);
      }
    }
    tile.first_second.push_back(static_cast<std::uint32_t>(tile.second.size()));
  }
}

void GeometryPass::trace(std::size_t begin, std::size_t end, Tile& tile) const {
  aimPackets(begin, end, tile.packets);
  tracer_.trace(tile.packets);
  tile.hits.clear();
  tracer_.allFaceted() ? collect(begin, end, tile) : collectExactly(begin, end, tile);
  if (second_.most_turns > 0) follow(begin, end, tile);
}

BeamHits traceBeams(const RayTracer& tracer, std::vector<Beam> beams, const SubRays& rays, const Vector3& origin_m,
                    const SecondWays& second) {
  constexpr std::size_t kBeamsPerTile = 128;
  BeamHits result;
  result.beams = std::move(beams);
  result.rays = rays;
  const GeometryPass pass(tracer, result.beams, rays, origin_m, second);
  std::vector<GeometryPass::Tile> tiles((result.beams.size() + kBeamsPerTile - 1) / kBeamsPerTile);
  core::parallelFor(result.beams.size(), kBeamsPerTile, [&](std::size_t begin, std::size_t end) {
    GeometryPass::Tile& tile = tiles[begin / kBeamsPerTile];
    pass.trace(begin, end, tile);
    tile.packets = {};
  });
  if (second.most_turns > 0) result.first_second.push_back(0);
  for (const GeometryPass::Tile& tile : tiles) {
    result.hits.append(tile.hits);
    const auto before = static_cast<std::uint32_t>(result.second.size());
    result.second.insert(result.second.end(), tile.second.begin(), tile.second.end());
    for (std::size_t b = 1; b < tile.first_second.size(); ++b) {
      result.first_second.push_back(before + tile.first_second[b]);
    }
  }
  return result;
}

TimeSpan timesOf(std::span<const Beam> beams) {
  TimeSpan times;
  if (beams.empty()) return times;
  times = {beams.front().scene_time_s, beams.front().scene_time_s};
  for (const Beam& beam : beams) {
    times.from_s = std::min(times.from_s, beam.scene_time_s);
    times.to_s = std::max(times.to_s, beam.scene_time_s);
  }
  return times;
}

}  // namespace model
