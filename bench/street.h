#pragma once

#include <cstdint>
#include <filesystem>

#include "model/scene/triangles.h"

namespace bench {

/// What a street is made of; the defaults are the street of docs/ and of every benchmark.
struct StreetOptions {
  double length_m = 200.0;  ///< along x, the sensor at half of it; at least 40
  double sensor_height_m = 1.8;
  std::size_t triangles = 207'000;  ///< exactly so many: the trees' leaves take what the rest leaves over
  std::uint64_t seed = 1;
};

/// A city street to time ray tracers on: everything near, far, big, thin and jagged that a roof lidar meets.
///
///        | facades: storeys of bays, windows set back, mullions, sills, balconies, roofs
///   y=+10 ── pavement, kerb, lamp posts, bollards, trees ── parked cars ──
///        <- oncoming cars                      street's centre line at y = +1.75
///   y=0  o  sensor, in the right lane ->       cars ahead and behind
///        ── parked cars ── kerb, trees, pavement
///   y=-7 | facades
///
/// Frame ISO 8855 (x forward, y left, z up) [m], the sensor in the origin, the road sensor_height_m below it; nothing
/// within 1.5 m of the sensor except the road. Same options, same triangles. No face is degenerate.
/// Throws std::invalid_argument if `triangles` is too few for the street without leaves.
[[nodiscard]] model::Triangles street(const StreetOptions& options = {});

/// Writes triangles for other tools: OBJ if the name ends in .obj, else binary PLY (little-endian, float vertices).
void writeMesh(const model::Triangles& triangles, const std::filesystem::path& file);

}  // namespace bench
