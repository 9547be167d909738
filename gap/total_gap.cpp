#include "gap/total_gap.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/physics.h"
#include "metrics/double_validation_metric.h"

namespace gap {

namespace {

constexpr double kExistenceWeight = 100.0;  // formats.md section 6
constexpr double kCell_deg = 2.0;
constexpr double kFileRounding = 1e-3;  // of a cell: azimuths in files are rounded, beams often lie on a border

using EchoesByCell = std::map<std::pair<std::int32_t, long>, double>;

EchoesByCell echoesPerFrame(const core::Detections& detections, int frames) {
  EchoesByCell cells;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const double column_of = detections.azimuth_rad[i] * core::kDegPerRad / kCell_deg;
    const long column = std::lround(std::floor(column_of + kFileRounding));
    cells[{detections.layer[i], column}] += 1.0 / frames;
  }
  return cells;
}

void addExistence(TotalGap& gap, const core::Detections& measured, const core::Detections& simulated, int frames) {
  EchoesByCell difference = echoesPerFrame(simulated, frames);
  double all = 0.0;
  for (const auto& [cell, echoes] : difference) all += echoes;
  for (const auto& [cell, echoes] : echoesPerFrame(measured, frames)) difference[cell] -= echoes;
  double missing = 0.0, extra = 0.0;
  for (const auto& [cell, echoes] : difference) (echoes > 0.0 ? missing : extra) += std::abs(echoes);
  if (all <= 0.0) all = std::max(1e-12, extra);  // nothing simulated: everything measured is extra
  gap.missing_fraction = missing / all;
  gap.extra_fraction = extra / all;
  gap.total += kExistenceWeight * (gap.missing_fraction + gap.extra_fraction);
}

template <typename T>
void pick(std::vector<T>& to, const std::vector<T>& from, std::size_t i) {
  if (!from.empty()) to.push_back(from[i]);
}

}  // namespace

TotalGap totalGap(const std::vector<model::Measurand>& measurands, const core::Detections& measured,
                  const core::Detections& simulated, int frames) {
  TotalGap gap;
  for (const model::Measurand& measurand : measurands) {
    const std::vector<double>* real = measured.values(measurand.column);
    const std::vector<double>* sim = simulated.values(measurand.column);
    if (!real || !sim || real->empty() || sim->empty()) continue;
    const metrics::PBox real_box{metrics::Edf(*real)}, sim_box{metrics::Edf(*sim)};
    const auto dvm = metrics::doubleValidationMetric({.simulated = sim_box, .measured = real_box});
    gap.measurands.push_back({measurand.name, measurand.unit, dvm.bias, dvm.scatter, measurand.resolution});
    gap.total += (std::abs(dvm.bias) + dvm.scatter) / measurand.resolution;
  }
  if (measured.hasDirections() && simulated.hasDirections()) addExistence(gap, measured, simulated, frames);
  return gap;
}

TotalGap meanOf(const std::vector<TotalGap>& gaps) {
  TotalGap mean;
  std::map<std::string, double> counts;
  for (const TotalGap& gap : gaps) {
    for (const MeasurandGap& m : gap.measurands) {
      auto known = std::find_if(mean.measurands.begin(), mean.measurands.end(),
                                [&](const MeasurandGap& other) { return other.name == m.name; });
      if (known == mean.measurands.end()) known = mean.measurands.insert(mean.measurands.end(), {m.name, m.unit, 0, 0, m.resolution});
      known->d_bias += m.d_bias;
      known->d_cavm += m.d_cavm;
      counts[m.name] += 1.0;
    }
    mean.missing_fraction += gap.missing_fraction / static_cast<double>(gaps.size());
    mean.extra_fraction += gap.extra_fraction / static_cast<double>(gaps.size());
    mean.total += gap.total / static_cast<double>(gaps.size());
  }
  for (MeasurandGap& m : mean.measurands) {
    m.d_bias /= counts[m.name];
    m.d_cavm /= counts[m.name];
  }
  return mean;
}

core::Detections framesOf(const core::Detections& detections, const std::vector<int>& frames) {
  std::vector<std::vector<std::size_t>> by_frame;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const auto frame = static_cast<std::size_t>(detections.frame[i]);
    if (frame >= by_frame.size()) by_frame.resize(frame + 1);
    by_frame[frame].push_back(i);
  }
  core::Detections chosen;
  for (const int frame : frames) {
    if (static_cast<std::size_t>(frame) >= by_frame.size()) continue;
    for (const std::size_t i : by_frame[static_cast<std::size_t>(frame)]) {
      pick(chosen.frame, detections.frame, i);
      pick(chosen.layer, detections.layer, i);
      pick(chosen.azimuth_rad, detections.azimuth_rad, i);
      pick(chosen.elevation_rad, detections.elevation_rad, i);
      pick(chosen.echo, detections.echo, i);
      pick(chosen.range_m, detections.range_m, i);
      pick(chosen.epw_m, detections.epw_m, i);
      pick(chosen.intensity, detections.intensity, i);
    }
  }
  return chosen;
}

}  // namespace gap
