#include "model/sensor/layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "core/parallel.h"

namespace model {

namespace {

struct Direction {
  double azimuth_rad;
  double elevation_rad;
};

/// The beams of a layer by azimuth.
struct LayerBeams {
  std::int32_t index;
  std::vector<Direction> beams;
};

std::vector<LayerBeams> layersOf(std::span<const Beam> beams) {
  std::map<std::int32_t, std::vector<Direction>> by_index;
  for (const Beam& beam : beams) by_index[beam.layer].push_back({beam.azimuth_rad, beam.elevation_rad});
  std::vector<LayerBeams> layers;
  for (auto& [index, directions] : by_index) {
    std::sort(directions.begin(), directions.end(),
              [](const Direction& a, const Direction& b) { return a.azimuth_rad < b.azimuth_rad; });
    layers.push_back({index, std::move(directions)});
  }
  return layers;
}

/// Square of the sine of half the angle between two directions (haversine): exact for small angles too.
double apart(const Direction& a, const Direction& b) {
  const double up = std::sin((a.elevation_rad - b.elevation_rad) / 2.0);
  const double left = std::sin((a.azimuth_rad - b.azimuth_rad) / 2.0);
  return up * up + std::cos(a.elevation_rad) * std::cos(b.elevation_rad) * left * left;
}

/// To the beams before and behind in azimuth, and to the layer's ends: ±180° may lie between them.
double apart(const Direction& at, const LayerBeams& layer) {
  const auto& beams = layer.beams;
  const auto behind = std::lower_bound(beams.begin(), beams.end(), at.azimuth_rad,
                                       [](const Direction& b, double azimuth) { return b.azimuth_rad < azimuth; });
  double nearest = std::min(apart(at, beams.front()), apart(at, beams.back()));
  if (behind != beams.end()) nearest = std::min(nearest, apart(at, *behind));
  if (behind != beams.begin()) nearest = std::min(nearest, apart(at, *std::prev(behind)));
  return nearest;
}

std::int32_t nearestLayer(const Direction& at, const std::vector<LayerBeams>& layers) {
  std::int32_t index = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const LayerBeams& layer : layers) {
    const double distance = apart(at, layer);
    if (distance < least) {
      least = distance;
      index = layer.index;
    }
  }
  return index;
}

}  // namespace

void addLayers(core::Detections& detections, std::span<const Beam> beams) {
  if (!detections.layer.empty() || detections.azimuth_rad.empty()) return;
  const std::vector<LayerBeams> layers = layersOf(beams);
  detections.layer.resize(detections.size());
  constexpr std::size_t kGrain = 4096;
  core::parallelFor(detections.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      detections.layer[i] = nearestLayer({detections.azimuth_rad[i], detections.elevation_rad[i]}, layers);
    }
  });
}

}  // namespace model
