#include "gap/pictures.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/physics.h"

namespace gap {

namespace {

constexpr double kWorthAMap = 0.1;  // mean residual in resolution steps
constexpr std::size_t kMostCurves = 3;

std::size_t worstSample(const Replay& replay, const ResidualTable& table) {
  std::vector<double> sums(replay.samples().size(), 0.0), weights(replay.samples().size(), 0.0);
  for (const ResidualTable::Row& row : table.rows) {
    sums[row.sample] += row.weight * std::abs(row.value);
    weights[row.sample] += row.weight;
  }
  std::size_t worst = 0;
  for (std::size_t s = 0; s < sums.size(); ++s) {
    if (sums[s] * weights[worst] > sums[worst] * weights[s]) worst = s;
  }
  return worst;
}

}  // namespace

std::vector<ResidualMap> residualMaps(const Replay& replay, const std::vector<ResidualTable>& tables) {
  std::vector<ResidualMap> maps;
  for (const ResidualTable& table : tables) {
    if (table.component != "bias" && table.component != "missing") continue;
    if (table.excess() < kWorthAMap || replay.samples().front().layout->pooled()) continue;
    const std::size_t worst = worstSample(replay, table);
    const ReplaySample& sample = replay.samples()[worst];
    ResidualMap map{table.measurand, table.unit, sample.sample->id, azimuthStep_deg(replay), {}};
    for (const ResidualTable::Row& row : table.rows) {
      if (row.sample != worst) continue;
      const model::Beam& beam = sample.beams[sample.layout->cells()[row.cell].beam];
      map.points.push_back({beam.azimuth_rad * core::kDegPerRad, static_cast<double>(beam.layer), row.value});
    }
    maps.push_back(std::move(map));
  }
  return maps;
}

std::vector<BeforeAfterValues> beforeAfterValues(const Replay& replay, const std::vector<ResidualTable>& tables,
                                                 const std::vector<std::size_t>& held_out, const World* after,
                                                 std::uint64_t seed) {
  const ResidualTable* worst = nullptr;
  for (const ResidualTable& table : tables) {
    if (table.component == "bias" && (!worst || table.excess() > worst->excess())) worst = &table;
  }
  std::vector<BeforeAfterValues> curves;
  if (!worst) return curves;
  const model::Measurand& measurand = replay.experiment().measurand(worst->measurand);
  for (const std::size_t s : held_out) {
    if (curves.size() >= kMostCurves) break;
    const ReplaySample& sample = replay.samples()[s];
    const core::Detections before = replay.detections(replay.baseline(), s, seed);
    const auto* real = sample.measured.values(measurand.column);
    const auto* simulated = before.values(measurand.column);
    if (!real || !simulated || real->empty() || simulated->empty()) continue;
    BeforeAfterValues values{measurand.name, measurand.unit, sample.sample->id, *real, *simulated, {}};
    if (after) {
      const core::Detections then = replay.detections(*after, s, seed);
      if (const auto* list = then.values(measurand.column)) values.after = *list;
    }
    curves.push_back(std::move(values));
  }
  return curves;
}

}  // namespace gap
