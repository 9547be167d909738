#include "app/desktop/cloud/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace desktop {

namespace {

constexpr double kSameAzimuth_rad = 2e-6;  // files round to a microradian
constexpr double kLargestMiss_rad = 0.5 * std::numbers::pi / 180.0;

double mean(const std::vector<double>& values, const std::vector<std::size_t>& chosen) {
  double sum = 0.0;
  for (const std::size_t i : chosen) sum += values[i];
  return sum / static_cast<double>(chosen.size());
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
  const auto miss = [&](std::size_t i) { return std::abs(d.azimuth_rad[i] - from.azimuth_rad[picked]); };
  double nearest_miss = std::numeric_limits<double>::infinity();
  double azimuth = 0.0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (d.layer[i] != from.layer[picked] || miss(i) >= nearest_miss) continue;
    nearest_miss = miss(i);
    azimuth = d.azimuth_rad[i];
  }
  std::vector<std::size_t> mates;
  for (std::size_t i = 0; i < d.size() && nearest_miss <= kLargestMiss_rad; ++i) {
    const bool same = d.layer[i] == from.layer[picked] && d.echo[i] == from.echo[picked] &&
                      std::abs(d.azimuth_rad[i] - azimuth) <= kSameAzimuth_rad;
    if (same) mates.push_back(i);
  }
  if (mates.empty()) return std::nullopt;
  BeamSummary summary{.count = mates.size(), .range_m = mean(d.range_m, mates), .epw_m = {}, .intensity_nw = {}};
  if (!d.epw_m.empty()) summary.epw_m = mean(d.epw_m, mates);
  if (!d.intensity.empty()) summary.intensity_nw = mean(d.intensity, mates);
  return summary;
}

}  // namespace desktop
