#include "prediction/detection_quantities.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <numbers>

namespace prediction {

namespace {

using core::Detections;

/// Whole numbers are exact as doubles; angles are stored in radians and asked for in degrees too.
struct Quantity {
  std::string name;
  std::function<std::vector<double>(const Detections&)> values;
};

Quantity real(const char* name, std::vector<double> Detections::*column, double factor = 1.0) {
  return {name, [column, factor](const Detections& detections) {
            std::vector<double> values = detections.*column;
            if (factor != 1.0) std::for_each(values.begin(), values.end(), [factor](double& v) { v *= factor; });
            return values;
          }};
}

Quantity whole(const char* name, std::vector<std::int32_t> Detections::*column) {
  return {name, [column](const Detections& detections) {
            return std::vector<double>((detections.*column).begin(), (detections.*column).end());
          }};
}

const std::vector<Quantity>& quantities() {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  static const std::vector<Quantity> all{real("range_m", &Detections::range_m),
                                         real("azimuth_deg", &Detections::azimuth_rad, kDegrees),
                                         real("azimuth_rad", &Detections::azimuth_rad),
                                         real("elevation_deg", &Detections::elevation_rad, kDegrees),
                                         real("elevation_rad", &Detections::elevation_rad),
                                         whole("layer", &Detections::layer),
                                         whole("echo", &Detections::echo),
                                         real("epw_m", &Detections::epw_m),
                                         real("intensity", &Detections::intensity),
                                         whole("frame", &Detections::frame),
                                         real("time_s", &Detections::time_s)};
  return all;
}

}  // namespace

const std::vector<std::string>& detectionQuantities() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Quantity& quantity : quantities()) list.push_back(quantity.name);
    return list;
  }();
  return names;
}

std::optional<std::vector<double>> valuesOf(const Detections& detections, const std::string& quantity) {
  const auto& all = quantities();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Quantity& q) { return q.name == quantity; });
  assert(found != all.end());
  std::vector<double> values = found->values(detections);
  if (values.size() != detections.size()) return std::nullopt;  // not recorded
  return values;
}

}  // namespace prediction
