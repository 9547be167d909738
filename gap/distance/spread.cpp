#include "gap/distance/spread.h"

#include <algorithm>
#include <cmath>

#include "gap/distance/discrepancy.h"
#include "gap/replay/statistics.h"

namespace gap {

namespace {

constexpr std::size_t kGroups = 6;        // of like power
constexpr double kSpreadFloor = 0.05;     // of the logarithm of a variance
constexpr double kMostOfUsual = 10.0;     // variance of a cell
constexpr double kPriorDetections = 6.0;  // weight of what is usual in a cell's variance

/// Of a χ² variable over its degrees of freedom (Wilson & Hilferty 1931, PNAS 17, 684): of few numbers most variances
/// come out too small.
double medianOfChiSquared(double freedom) {
  const double root = 1.0 - 2.0 / (9.0 * std::max(1.0, freedom));
  return root * root * root;
}

PooledSpread spreadWithin(std::span<const std::size_t> cells, std::span<const CellStatistics> statistics,
                          Channel channel, double prior) {
  std::vector<double> variances;
  for (const std::size_t c : cells) variances.push_back(statistics[c].variance(channel));
  std::vector<double> sorted = variances;
  const double median = sorted.empty() ? 0.0 : medianOf(sorted);
  const double most = kMostOfUsual * std::max(prior, median);
  PooledSpread pooled;
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double freedom = statistics[cells[i]].count - 1.0;
    pooled.degrees_of_freedom += freedom;
    sum += freedom * std::min(most, variances[i]);
  }
  pooled.variance = sum / std::max(1.0, pooled.degrees_of_freedom);
  const double of_one = pooled.degrees_of_freedom / std::max(1.0, static_cast<double>(cells.size()));
  pooled.usual = median / medianOfChiSquared(of_one);
  return pooled;
}

}  // namespace

double priorVariance(const Replay& replay, const ReplaySample& sample, Channel channel) {
  const model::SensorProfile& sensor = replay.baseline().model.sensor(sample.sample->sensor);
  const double step = replay.resolution(channel);
  double noise = step;
  if (channel == kRange) noise = sensor.detection.range_noise_m;
  if (channel == kEpw) noise = sensor.detection.epw_noise_m;
  if (channel == kIntensity) noise = 1e9 * sensor.receiver.noise_w;
  return noise * noise + step * step / 12.0;
}

std::vector<GroupSpread> spreadsOf(const std::vector<std::size_t>& cells, const Comparison& comparison, Channel channel,
                                   double prior) {
  std::vector<GroupSpread> groups;
  for (const auto& [begin, end] : evenParts(cells.size(), kGroups)) {
    GroupSpread group;
    group.cells.assign(cells.begin() + static_cast<std::ptrdiff_t>(begin),
                       cells.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<std::size_t> scattering = group.cells;
    std::erase_if(scattering, [&](std::size_t c) {
      return comparison.measured[c].count < 2.0 || comparison.simulated[c].count < 2.0;
    });
    group.measured = spreadWithin(scattering, comparison.measured, channel, prior);
    group.simulated = spreadWithin(scattering, comparison.simulated, channel, prior);
    groups.push_back(std::move(group));
  }
  return groups;
}

double spreadDiscrepancy(const std::vector<GroupSpread>& groups, double prior) {
  std::size_t cells = 0;
  for (const GroupSpread& group : groups) cells += group.cells.size();
  // A group stands for many cells; weigh it with the square root of their number, as their joint mean would be.
  const double weight = std::sqrt(static_cast<double>(cells) / static_cast<double>(groups.size()));
  const double small = 0.02 * prior;  // quantised outputs may not scatter at all
  double result = 0.0;
  for (const auto& [in_group, m, s] : groups) {
    if (!m.known() || !s.known()) continue;
    const double error =
        std::sqrt(2.0 / m.degrees_of_freedom + 2.0 / s.degrees_of_freedom + kSpreadFloor * kSpreadFloor);
    result += weight * groupLoss(std::log((m.variance + small) / (s.variance + small)) / error);
  }
  return result;
}

double pooledVariance(const CellStatistics& a, const CellStatistics& b, Channel channel, double prior) {
  const double dof_a = std::max(0.0, a.count - 1.0), dof_b = std::max(0.0, b.count - 1.0);
  return (dof_a * a.variance(channel) + dof_b * b.variance(channel) + kPriorDetections * prior) /
         (dof_a + dof_b + kPriorDetections);
}

double varianceIn(const PooledSpread& group, const CellStatistics& cell, Channel channel, double prior) {
  const double usual = group.known() ? group.usual : prior;
  const double freedom = std::max(0.0, cell.count - 1.0);
  return (freedom * cell.variance(channel) + kPriorDetections * usual) / (freedom + kPriorDetections);
}

}  // namespace gap
