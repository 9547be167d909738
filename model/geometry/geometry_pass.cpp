#include "model/geometry/geometry_pass.h"

#include <algorithm>
#include <cmath>

#include "core/multiversion.h"
#include "core/parallel.h"

namespace model {

namespace {

/// A surface nearer than this touches the sensor: the beam is lost in it, and 1/r² means nothing there.
constexpr double kNearest_m = 1e-3;
constexpr std::size_t kLanes = RayPacket::kRays;

std::vector<BeamAxes> axesOf(std::span<const Beam> beams) {
  std::vector<BeamAxes> axes;
  axes.reserve(beams.size());
  for (const Beam& beam : beams) {
    const double ca = std::cos(beam.azimuth_rad), sa = std::sin(beam.azimuth_rad);
    const double ce = std::cos(beam.elevation_rad), se = std::sin(beam.elevation_rad);
    const auto f = [](double component) { return static_cast<float>(component); };
    axes.push_back({{f(ce * ca), f(ce * sa), f(se)}, {f(-sa), f(ca)}, {f(-se * ca), f(-se * sa), f(ce)}});
  }
  return axes;
}

RayOffsets offsetsOf(const SubRays& rays) {
  RayOffsets offsets;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double l = std::tan(rays.left_rad[i]), u = std::tan(rays.up_rad[i]);
    const double length = std::sqrt(1.0 + l * l + u * u);
    offsets.forward.push_back(static_cast<float>(1.0 / length));
    offsets.left.push_back(static_cast<float>(l / length));
    offsets.up.push_back(static_cast<float>(u / length));
    offsets.left_slope.push_back(l);
    offsets.up_slope.push_back(u);
  }
  return offsets;
}

/// Unit directions of `count` sub-rays of one beam, from sub-ray `ray` on, into the lanes from `lane` on.
void aimLanes(RayPacket& packet, std::size_t lane, std::size_t count, const BeamAxes& axes, const RayOffsets& offsets,
              std::size_t ray) {
  const float* forward = &offsets.forward[ray];
  const float* left = &offsets.left[ray];
  const float* up = &offsets.up[ray];
  float* x = packet.direction_x + lane;
  float* y = packet.direction_y + lane;
  float* z = packet.direction_z + lane;
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = forward[i] * axes.forward[0] + left[i] * axes.left[0] + up[i] * axes.up[0];
    y[i] = forward[i] * axes.forward[1] + left[i] * axes.left[1] + up[i] * axes.up[1];
    z[i] = forward[i] * axes.forward[2] + up[i] * axes.up[2];
  }
}

/// |cos| of the incidence angles of a packet: d and the normal, which is not of unit length.
FIDELIS_FOR_EVERY_PROCESSOR void cosinesOf(const RayPacket& p, float* __restrict cosines) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float along =
        p.direction_x[i] * p.normal_x[i] + p.direction_y[i] * p.normal_y[i] + p.direction_z[i] * p.normal_z[i];
    const float square = p.normal_x[i] * p.normal_x[i] + p.normal_y[i] * p.normal_y[i] + p.normal_z[i] * p.normal_z[i];
    const float cosine = std::fabs(along) / std::sqrt(square);
    cosines[i] = cosine < 1.0F ? cosine : 1.0F;
  }
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

Ray GeometryPass::rayOf(std::size_t beam, const BeamTurn& turn, std::size_t ray) const {
  return {origin_m_, turn.directionAt(offsets_.left_slope[ray], offsets_.up_slope[ray]), beams_[beam].scene_time_s};
}

/// Sub-rays of neighbouring beams fill the packets one after the other; spare lanes at the end repeat the last one.
void GeometryPass::aimPackets(std::size_t begin, std::size_t end, std::vector<RayPacket>& packets) const {
  const std::size_t per_beam = rays_.size(), count = (end - begin) * per_beam;
  const std::size_t needed = (count + kLanes - 1) / kLanes;
  const std::size_t had = packets.size();
  packets.resize(needed);
  for (std::size_t p = 0; p < needed; ++p) p < had ? packets[p].rewind() : packets[p].reset(origin_m_);
  std::size_t at = 0;
  for (std::size_t b = begin; b < end; ++b) {
    const float time = timed_ ? tracer_.timeOf(beams_[b].scene_time_s) : 0.0F;
    for (std::size_t r = 0; r < per_beam;) {
      RayPacket& packet = packets[at / kLanes];
      const std::size_t lane = at % kLanes, run = std::min(kLanes - lane, per_beam - r);
      aimLanes(packet, lane, run, axes_[b], offsets_, r);
      if (timed_) std::fill_n(packet.time + lane, run, time);
      r += run;
      at += run;
    }
  }
  for (; at < needed * kLanes; ++at) {
    aimLanes(packets[at / kLanes], at % kLanes, 1, axes_[end - 1], offsets_, per_beam - 1);
  }
}

namespace {

/// Which lanes of a packet met something, one bit each.
std::uint32_t metLanes(const RayPacket& packet) {
  std::uint32_t met = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const bool counts =
        packet.geometry[lane] != RayPacket::kNothing && packet.range_m[lane] >= static_cast<float>(kNearest_m);
    met |= static_cast<std::uint32_t>(counts) << lane;
  }
  return met;
}

/// Room for hits that are written one packet at a time.
struct Rows {
  explicit Rows(Hits& hits, std::size_t most) {
    hits.range_m.resize(most);
    hits.cos_incidence.resize(most);
    hits.object.resize(most);
    hits.ray.resize(most);
    range_m = hits.range_m.data();
    cosine = hits.cos_incidence.data();
    object = hits.object.data();
    ray = hits.ray.data();
  }
  double* range_m;
  float* cosine;
  std::int32_t* object;
  std::uint32_t* ray;
  std::size_t kept = 0;

  void take(const RayPacket& packet, const float* cosines, std::size_t lane, std::size_t count, std::size_t first_ray) {
    for (std::size_t i = 0; i < count; ++i) range_m[kept + i] = static_cast<double>(packet.range_m[lane + i]);
    for (std::size_t i = 0; i < count; ++i) cosine[kept + i] = cosines[lane + i];
    for (std::size_t i = 0; i < count; ++i) object[kept + i] = static_cast<std::int32_t>(packet.geometry[lane + i]);
    for (std::size_t i = 0; i < count; ++i) ray[kept + i] = static_cast<std::uint32_t>(first_ray + i);
    kept += count;
  }
};

}  // namespace

void GeometryPass::collect(std::size_t begin, std::size_t end, Tile& tile) const {
  const std::size_t per_beam = rays_.size();
  Rows rows(tile.hits, (end - begin) * per_beam);
  alignas(64) float cosines[kLanes];
  std::uint32_t met = 0;
  std::size_t at = 0;
  for (std::size_t b = begin; b < end; ++b) {
    for (std::size_t r = 0; r < per_beam;) {
      const RayPacket& packet = tile.packets[at / kLanes];
      const std::size_t lane = at % kLanes, run = std::min(kLanes - lane, per_beam - r);
      if (lane == 0) {
        cosinesOf(packet, cosines);
        met = metLanes(packet);
      }
      const std::uint32_t wanted = ((1U << run) - 1U) << lane;
      if ((met & wanted) == wanted) {
        rows.take(packet, cosines, lane, run, r);
      } else if ((met & wanted) != 0) {
        for (std::size_t i = 0; i < run; ++i) {
          if (met >> (lane + i) & 1U) rows.take(packet, cosines, lane + i, 1, r + i);
        }
      }
      r += run;
      at += run;
    }
    tile.hits.first.push_back(static_cast<std::uint32_t>(rows.kept));
  }
  tile.hits.truncate(rows.kept);
}

void GeometryPass::collectExactly(std::size_t begin, std::size_t end, Tile& tile) const {
  std::size_t at = 0;
  alignas(64) float cosines[kLanes];
  for (std::size_t b = begin; b < end; ++b) {
    const BeamTurn turn(beams_[b]);
    for (std::size_t r = 0; r < rays_.size(); ++r, ++at) {
      const RayPacket& packet = tile.packets[at / kLanes];
      const std::size_t lane = at % kLanes;
      if (lane == 0) cosinesOf(packet, cosines);
      const std::int32_t object = tracer_.objectOf(packet, lane);
      if (object < 0) continue;
      Hit hit{packet.range_m[lane], cosines[lane], object, static_cast<std::uint32_t>(r)};
      if (!tracer_.isFaceted(object)) {
        const RayHit exact = tracer_.exactly(rayOf(b, turn, r), packet, lane);
        hit.range_m = exact.range_m;
        hit.cos_incidence = static_cast<float>(exact.cos_incidence);
      }
      if (hit.range_m >= kNearest_m) tile.hits.add(hit);
    }
    tile.hits.endBeam();
  }
}

void GeometryPass::follow(std::size_t begin, std::size_t end, Tile& tile) const {
  tile.first_second.assign(1, 0);
  WaysOn ways(tracer_, second_);
  for (std::size_t b = begin; b < end; ++b) {
    const BeamTurn turn(beams_[b]);
    for (const Hit& first : HitsOfBeam(tile.hits, b - begin)) {
      if (!ways.leadFrom(first.object)) continue;
      const std::size_t at = (b - begin) * rays_.size() + first.ray;
      const Ray ray = rayOf(b, turn, first.ray);
      ways.begin(ray, tracer_.exactly(ray, tile.packets[at / kLanes], at % kLanes), first.ray);
    }
    ways.finish(tile.second);
    tile.first_second.push_back(static_cast<std::uint32_t>(tile.second.size()));
  }
}

void GeometryPass::trace(std::size_t begin, std::size_t end, Tile& tile) const {
  aimPackets(begin, end, tile.packets);
  tracer_.trace(tile.packets);
  if (tracer_.allFaceted()) {
    tile.hits.first.assign(1, 0);  // the rest is overwritten: clearing it first would cost a tenth of the time
    collect(begin, end, tile);
  } else {
    tile.hits.clear();
    collectExactly(begin, end, tile);
  }
  tile.second.clear();
  tile.first_second.clear();  // what another scene left in a tile that is used again
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
  std::size_t second_hits = 0;
  for (const GeometryPass::Tile& tile : tiles) second_hits += tile.second.size();
  result.second.reserve(second_hits);  // they are many: neither spare room nor two copies of all
  for (GeometryPass::Tile& tile : tiles) {
    result.hits.append(tile.hits);
    const auto before = static_cast<std::uint32_t>(result.second.size());
    result.second.insert(result.second.end(), tile.second.begin(), tile.second.end());
    for (std::size_t b = 1; b < tile.first_second.size(); ++b) {
      result.first_second.push_back(before + tile.first_second[b]);
    }
    tile = {};
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
