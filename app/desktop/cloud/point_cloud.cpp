#include "app/desktop/cloud/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace desktop {

namespace {

constexpr double kSameAzimuth_rad = 2e-6;  // files round to a microradian
constexpr double kLargestMiss_rad = 0.5 * std::numbers::pi / 180.0;

double mean(const std::vector<double>& values, const std::vector<std::size_t>& chosen) {
  double sum = 0.0;
  for (const std::size_t i : chosen) sum += values[i];
  return sum / static_cast<double>(chosen.size());
}

double around(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

/// One beam of a cloud, with its mean range by echo number.
struct BeamMean {
  std::int32_t layer;
  double azimuth_rad;
  std::map<std::int32_t, double> range_m;
};

bool before(const BeamMean& beam, const std::pair<std::int32_t, double>& place) {
  return std::pair(beam.layer, beam.azimuth_rad) < place;
}

/// By layer and azimuth.
std::vector<BeamMean> beamMeansOf(const core::Detections& d) {
  std::vector<std::size_t> order(d.hasDirections() ? d.size() : 0);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place = [&](std::size_t i) { return std::pair(d.layer.empty() ? 0 : d.layer[i], d.azimuth_rad[i]); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  std::vector<BeamMean> beams;
  std::map<std::int32_t, int> counts;
  for (const std::size_t i : order) {
    const auto [layer, azimuth] = place(i);
    if (beams.empty() || beams.back().layer != layer || azimuth - beams.back().azimuth_rad > kSameAzimuth_rad) {
      beams.push_back({layer, azimuth, {}});
      counts.clear();
    }
    double& mean = beams.back().range_m[d.echo[i]];
    mean += (d.range_m[i] - mean) / ++counts[d.echo[i]];
  }
  return beams;
}

/// Of the layer; nullptr if none is at most half a degree away, around the circle.
const BeamMean* nearestBeam(const std::vector<BeamMean>& beams, std::int32_t layer, double azimuth_rad) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto first = std::lower_bound(beams.begin(), beams.end(), std::pair(layer, -kInfinite), before);
  const auto last = std::lower_bound(first, beams.end(), std::pair(layer, kInfinite), before);
  if (first == last) return nullptr;
  const auto behind = std::lower_bound(first, last, std::pair(layer, azimuth_rad), before);
  const BeamMean* nearest = nullptr;
  double least = kLargestMiss_rad;
  const auto consider = [&](const BeamMean& beam) {
    const double miss = std::abs(around(beam.azimuth_rad - azimuth_rad));
    if (miss > least) return;
    least = miss;
    nearest = &beam;
  };
  consider(*first);  // +-180 degrees may lie between
  consider(*std::prev(last));
  if (behind != last) consider(*behind);
  if (behind != first) consider(*std::prev(behind));
  return nearest;
}

/// Directions spread evenly over the sphere: a Fibonacci lattice.
std::vector<Point3> outlineOf(const PointCloud& cloud) {
  constexpr int kDirections = 100;
  constexpr double kGoldenAngle = std::numbers::pi * (3.0 - 2.23606797749979);
  std::vector<Point3> outline{{}};
  for (int k = 0; k < kDirections && cloud.size() > 0; ++k) {
    const double up = 1.0 - (2.0 * k + 1.0) / kDirections;
    const double ground = std::sqrt(1.0 - up * up);
    const auto dx = static_cast<float>(ground * std::cos(k * kGoldenAngle));
    const auto dy = static_cast<float>(ground * std::sin(k * kGoldenAngle));
    const auto dz = static_cast<float>(up);
    std::size_t farthest = 0;
    float most = -std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const float along = dx * cloud.x[i] + dy * cloud.y[i] + dz * cloud.z[i];
      if (along <= most) continue;
      most = along;
      farthest = i;
    }
    outline.push_back({cloud.x[farthest], cloud.y[farthest], cloud.z[farthest]});
  }
  return outline;
}

}  // namespace

int PointCloud::frames() const noexcept {
  if (detections.frame.empty()) return 0;
  return 1 + *std::max_element(detections.frame.begin(), detections.frame.end());
}

PointCloud pointCloudOf(core::Detections detections) {
  PointCloud cloud{.detections = std::move(detections), .x = {}, .y = {}, .z = {}, .outline = {{}}};
  const core::Detections& d = cloud.detections;
  if (!d.hasDirections()) return cloud;
  cloud.x.reserve(d.size());
  cloud.y.reserve(d.size());
  cloud.z.reserve(d.size());
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double ground = d.range_m[i] * std::cos(d.elevation_rad[i]);
    cloud.x.push_back(static_cast<float>(ground * std::cos(d.azimuth_rad[i])));
    cloud.y.push_back(static_cast<float>(ground * std::sin(d.azimuth_rad[i])));
    cloud.z.push_back(static_cast<float>(d.range_m[i] * std::sin(d.elevation_rad[i])));
  }
  cloud.outline = outlineOf(cloud);
  return cloud;
}

std::vector<double> valuesFor(const PointCloud& cloud, ColourBy by) {
  const core::Detections& d = cloud.detections;
  switch (by) {
    case ColourBy::Source:
    case ColourBy::Difference:
      return {};
    case ColourBy::Range:
      return d.range_m;
    case ColourBy::Intensity:
      return d.intensity;
    case ColourBy::EchoPulseWidth:
      return d.epw_m;
    case ColourBy::Layer:
      return {d.layer.begin(), d.layer.end()};
    case ColourBy::Echo:
      return {d.echo.begin(), d.echo.end()};
  }
  return {};
}

std::optional<BeamSummary> sameBeam(const PointCloud& cloud, const PointCloud& of, std::size_t picked) {
  const core::Detections& d = cloud.detections;
  const core::Detections& from = of.detections;
  if (cloud.size() == 0 || of.size() <= picked) return std::nullopt;
  const bool layers = !d.layer.empty() && !from.layer.empty();
  const auto sameLayer = [&](std::size_t i) { return !layers || d.layer[i] == from.layer[picked]; };
  const std::int32_t echo = std::max(1, from.echo[picked]);
  double nearest_miss = std::numeric_limits<double>::infinity();
  double azimuth = 0.0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double miss = std::abs(around(d.azimuth_rad[i] - from.azimuth_rad[picked]));
    if (!sameLayer(i) || miss >= nearest_miss) continue;
    nearest_miss = miss;
    azimuth = d.azimuth_rad[i];
  }
  std::vector<std::size_t> mates;
  for (std::size_t i = 0; i < d.size() && nearest_miss <= kLargestMiss_rad; ++i) {
    if (sameLayer(i) && d.echo[i] == echo && std::abs(around(d.azimuth_rad[i] - azimuth)) <= kSameAzimuth_rad) {
      mates.push_back(i);
    }
  }
  if (mates.empty()) return std::nullopt;
  BeamSummary summary{.count = mates.size(), .range_m = mean(d.range_m, mates), .epw_m = {}, .intensity_nw = {}};
  if (!d.epw_m.empty()) summary.epw_m = mean(d.epw_m, mates);
  if (!d.intensity.empty()) summary.intensity_nw = mean(d.intensity, mates);
  return summary;
}

std::vector<double> rangeDifferences(const PointCloud& own, const PointCloud& other) {
  const std::vector<BeamMean> beams = beamMeansOf(other.detections);
  const core::Detections& d = own.detections;
  std::vector<double> differences(own.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const std::int32_t layer = d.layer.empty() ? 0 : d.layer[i];
    if (const BeamMean* beam = nearestBeam(beams, layer, d.azimuth_rad[i])) {
      const auto mean = beam->range_m.find(d.echo[i]);
      if (mean != beam->range_m.end()) differences[i] = mean->second - d.range_m[i];
    }
  }
  return differences;
}

}  // namespace desktop
