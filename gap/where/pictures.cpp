#include "gap/where/pictures.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numeric>

#include "core/physics.h"

namespace gap {

namespace {

constexpr double kWorthAMap = 0.1;  // mean residual in resolution steps
constexpr std::size_t kMostCurves = 3;
constexpr std::size_t kMostMaps = 3;       // samples of a measurand
constexpr double kNotable = 0.1;           // of what the worst sample deviates
constexpr std::size_t kMostColumns = 160;  // of a map; finer scans are averaged
constexpr std::size_t kMostRows = 40;

/// Samples by the mean size of their residuals in these tables, in steps; the largest first.
std::vector<std::size_t> worstSamples(const Replay& replay, const std::vector<const ResidualTable*>& tables) {
  std::vector<double> sums(replay.samples().size(), 0.0), weights(replay.samples().size(), 0.0);
  for (const ResidualTable* table : tables) {
    std::vector<std::vector<const ResidualTable::Row*>> rows(sums.size());
    for (const ResidualTable::Row& row : table->rows) {
      sums[row.sample] += row.weight * std::max(0.0, std::abs(row.value) - 2.0 * row.error);
      rows[row.sample].push_back(&row);
    }
    for (std::size_t s = 0; s < rows.size(); ++s) weights[s] += table->weightOf(rows[s]);
  }
  std::vector<std::size_t> samples(sums.size());
  std::iota(samples.begin(), samples.end(), std::size_t{0});
  std::erase_if(samples, [&](std::size_t s) { return weights[s] == 0.0; });
  std::stable_sort(samples.begin(), samples.end(),
                   [&](std::size_t a, std::size_t b) { return sums[a] * weights[b] > sums[b] * weights[a]; });
  if (samples.size() > kMostMaps) samples.resize(kMostMaps);
  // Beside the worst sample one that hardly deviates would only be a white field.
  const std::size_t worst = samples.empty() ? 0 : samples.front();
  std::erase_if(samples, [&](std::size_t s) { return sums[s] * weights[worst] < kNotable * sums[worst] * weights[s]; });
  return samples;
}

/// Rows (layers, or groups of them) and columns (azimuths, or groups of them) of a map.
class MapGrid {
 public:
  MapGrid(const std::vector<model::Beam>& beams, double step_deg) {
    std::map<int, std::pair<double, double>> elevations;  // sum and count by layer
    double low = 1e9, high = -1e9;
    for (const model::Beam& beam : beams) {
      auto& [sum, count] = elevations[static_cast<int>(beam.layer)];
      sum += beam.elevation_rad * core::kDegPerRad;
      count += 1.0;
      low = std::min(low, beam.azimuth_rad * core::kDegPerRad);
      high = std::max(high, beam.azimuth_rad * core::kDegPerRad);
    }
    std::vector<std::pair<double, int>> layers;
    for (const auto& [layer, sum] : elevations) layers.emplace_back(sum.first / sum.second, layer);
    std::sort(layers.begin(), layers.end());
    const std::size_t rows_together = (layers.size() + kMostRows - 1) / kMostRows;
    for (std::size_t i = 0; i < layers.size(); ++i) {
      row_of_[layers[i].second] = i / rows_together;
      if (i % rows_together == 0) names_.push_back(fmt::format("{:.1f}°", layers[i].first));
    }
    const double columns = std::floor((high - low) / step_deg + 0.5) + 1.0;
    step_deg_ = step_deg * std::ceil(columns / static_cast<double>(kMostColumns));
    low_deg_ = low;
  }

  struct Place {
    std::size_t row;
    long column;
    auto operator<=>(const Place&) const = default;
  };
  [[nodiscard]] Place placeOf(const model::Beam& beam) const {
    const double azimuth_deg = beam.azimuth_rad * core::kDegPerRad;
    return {row_of_.at(static_cast<int>(beam.layer)),
            std::lround(std::floor((azimuth_deg - low_deg_) / step_deg_ + 0.5))};
  }
  [[nodiscard]] double azimuthOf(const Place& place) const {
    return low_deg_ + static_cast<double>(place.column) * step_deg_;
  }
  [[nodiscard]] double step_deg() const { return step_deg_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::map<int, std::size_t> row_of_;
  std::vector<std::string> names_;
  double low_deg_ = 0.0;
  double step_deg_ = 1.0;
};

ResidualMap mapOf(const Replay& replay, const ResidualTable& table, std::size_t s) {
  const ReplaySample& sample = replay.samples()[s];
  const MapGrid grid(sample.beams, azimuthStep_deg(replay));
  std::map<MapGrid::Place, std::vector<const ResidualTable::Row*>> rows;
  long first = std::numeric_limits<long>::max(), last = std::numeric_limits<long>::min();
  std::size_t lowest = std::numeric_limits<std::size_t>::max(), highest = 0;
  for (const ResidualTable::Row& row : table.rows) {
    if (row.sample != s) continue;
    const auto place = grid.placeOf(sample.beams[sample.layout->cells()[row.cell].beam]);
    rows[place].push_back(&row);
    first = std::min(first, place.column);
    last = std::max(last, place.column);
    lowest = std::min(lowest, place.row);
    highest = std::max(highest, place.row);
  }
  ResidualMap map{table.measurand, table.component, table.unit, sample.sample->id, grid.step_deg(), {}, {}};
  if (rows.empty()) return map;
  // Beams without data stay on the map, but a scan is not shown where nobody saw anything.
  const std::size_t bottom = lowest == 0 ? 0 : lowest - 1, top = std::min(highest + 1, grid.names().size() - 1);
  for (const model::Beam& beam : sample.beams) {
    const auto place = grid.placeOf(beam);
    if (place.column >= first - 1 && place.column <= last + 1 && place.row >= bottom && place.row <= top)
      rows.try_emplace(place);
  }
  map.rows.assign(grid.names().begin() + static_cast<std::ptrdiff_t>(bottom),
                  grid.names().begin() + static_cast<std::ptrdiff_t>(top) + 1);
  for (const auto& [place, of_place] : rows) {
    double sum = 0.0;
    for (const ResidualTable::Row* row : of_place) sum += row->weight * row->value;
    const double weight = table.weightOf(of_place);
    map.points.push_back({grid.azimuthOf(place), place.row - bottom, weight > 0.0 ? sum / weight : NAN});
  }
  return map;
}

}  // namespace

std::vector<ResidualMap> residualMaps(const Replay& replay, const std::vector<ResidualTable>& tables) {
  std::vector<ResidualMap> maps;
  if (replay.samples().front().layout->pooled()) return maps;
  std::vector<std::string> measurands;
  for (const ResidualTable& table : tables) {
    if (std::find(measurands.begin(), measurands.end(), table.measurand) == measurands.end())
      measurands.push_back(table.measurand);
  }
  for (const std::string& measurand : measurands) {
    std::vector<const ResidualTable*> own;
    double excess = 0.0;
    for (const ResidualTable& table : tables) {
      if (table.measurand != measurand) continue;
      own.push_back(&table);
      excess = std::max({excess, table.excess(), table.commonShift()});
    }
    if (excess < kWorthAMap) continue;
    for (const std::size_t s : worstSamples(replay, own)) {
      for (const ResidualTable* table : own) maps.push_back(mapOf(replay, *table, s));
    }
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
