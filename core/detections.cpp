#include "core/detections.h"

namespace core {

namespace {

constexpr DetectionColumn kColumns[] = {
    {"frame", nullptr, &Detections::frame},
    {"time_s", &Detections::time_s, nullptr},
    {"layer", nullptr, &Detections::layer},
    {"azimuth_rad", &Detections::azimuth_rad, nullptr},
    {"elevation_rad", &Detections::elevation_rad, nullptr},
    {"echo", nullptr, &Detections::echo},
    {"range_m", &Detections::range_m, nullptr},
    {"epw_m", &Detections::epw_m, nullptr},
    {"intensity", &Detections::intensity, nullptr},
};

}  // namespace

std::span<const DetectionColumn> detectionColumns() { return kColumns; }

const std::vector<double>* Detections::values(const std::string& column) const {
  for (const DetectionColumn& candidate : kColumns) {
    if (candidate.real && column == candidate.name) {
      const std::vector<double>& list = this->*candidate.real;
      return list.size() == size() ? &list : nullptr;
    }
  }
  return nullptr;
}

Detections selected(const Detections& detections, std::span<const std::size_t> indices) {
  Detections chosen;
  const auto copy = [&](const auto& from, auto& to) {
    if (from.empty()) return;  // not recorded
    to.reserve(indices.size());
    for (const std::size_t i : indices) to.push_back(from[i]);
  };
  for (const DetectionColumn& column : kColumns) {
    if (column.real) copy(detections.*column.real, chosen.*column.real);
    if (column.whole) copy(detections.*column.whole, chosen.*column.whole);
  }
  return chosen;
}

}  // namespace core
