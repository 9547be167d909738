#include "gap/distance/existence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "core/physics.h"

namespace gap {

namespace {

constexpr double kCell_deg = 2.0;
/// Scans like to stand on full degrees, and files round angles: a cell border there would split a beam's echoes.
constexpr double kBorder_deg = 0.0137;

using EchoesPerFrame = std::map<std::pair<std::int32_t, std::int64_t>, double>;

bool hasDirections(const core::Detections& detections) { return !detections.azimuth_rad.empty(); }

EchoesPerFrame echoesPerFrame(const Frames& frames, bool by_direction) {
  EchoesPerFrame cells;
  for (std::size_t i = 0; i < frames.detections.size(); ++i) {
    std::pair<std::int32_t, std::int64_t> cell = {0, 0};
    if (by_direction) {
      const double azimuth_deg = frames.detections.azimuth_rad[i] * core::kDegPerRad;
      cell = {frames.detections.layer[i], std::llround(std::floor((azimuth_deg + kBorder_deg) / kCell_deg))};
    }
    cells[cell] += 1.0 / frames.count;
  }
  return cells;
}

}  // namespace

ExistenceGap existenceGap(const Frames& simulated, const Frames& measured) {
  const bool by_direction = (hasDirections(simulated.detections) || simulated.detections.size() == 0) &&
                            (hasDirections(measured.detections) || measured.detections.size() == 0);
  EchoesPerFrame difference = echoesPerFrame(simulated, by_direction);
  double all = 0.0;
  for (const auto& [cell, echoes] : difference) all += echoes;
  if (all <= 0.0) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    return {kNothing, kNothing};
  }
  for (const auto& [cell, echoes] : echoesPerFrame(measured, by_direction)) difference[cell] -= echoes;
  double missing = 0.0;
  double extra = 0.0;
  for (const auto& [cell, echoes] : difference) (echoes > 0.0 ? missing : extra) += std::abs(echoes);
  return {missing / all, extra / all};
}

double detectionRate(const Frames& frames, std::size_t beams_per_frame) {
  const core::Detections& detections = frames.detections;
  const double fired = static_cast<double>(beams_per_frame) * frames.count;
  if (!hasDirections(detections)) {
    return static_cast<double>(std::count(detections.echo.begin(), detections.echo.end(), 1)) / fired;
  }
  // A gate may have dropped the first echo of a beam, so beams are told apart by their direction.
  std::vector<std::tuple<std::int32_t, std::int32_t, std::int64_t>> beams;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    beams.emplace_back(detections.frame[i], detections.layer[i], std::llround(1e5 * detections.azimuth_rad[i]));
  }
  std::sort(beams.begin(), beams.end());
  return static_cast<double>(std::unique(beams.begin(), beams.end()) - beams.begin()) / fired;
}

}  // namespace gap
