#include "gap/where/residual_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gap/distance/discrepancy.h"

namespace gap {

namespace {

constexpr double kExistenceScale = 0.01;  // the total gap counts existence in per cent of the simulated echoes

}  // namespace

double ResidualTable::Row::beyondError() const { return std::sqrt(std::max(0.0, value * value - 4.0 * error * error)); }

double ResidualTable::sumBeyondErrors() const {
  double sum = 0.0;
  for (const Row& row : rows) sum += row.weight * row.beyondError();
  return sum;
}

double ResidualTable::weightOf(std::span<const Row* const> some) const {
  const bool of_shots = sign() != 0.0;
  double weight = 0.0;
  std::vector<std::vector<bool>> counted;  // beams of every sample
  for (const Row* row : some) {
    if (of_shots) {
      if (counted.size() <= row->sample) counted.resize(row->sample + 1);
      std::vector<bool>& beams = counted[row->sample];
      if (beams.size() <= row->beam) beams.resize(row->beam + std::size_t{1});
      if (beams[row->beam]) continue;
      beams[row->beam] = true;
    }
    weight += row->weight;
  }
  return weight;
}

double ResidualTable::weight() const {
  std::vector<const Row*> all;
  for (const Row& row : rows) all.push_back(&row);
  return weightOf(all);
}

double ResidualTable::excess() const {
  const double all = weight();
  return all > 0.0 ? sumBeyondErrors() / all / scale : 0.0;
}

double ResidualTable::sign() const { return component == "missing" ? -1.0 : component == "extra" ? 1.0 : 0.0; }

double ResidualTable::meanOfNoise(const Row& row) const {
  constexpr double kDensity = 0.0539910;  // of the standard normal distribution at kBeyondNoise
  static_assert(kBeyondNoise == 2.0);
  return sign() == 0.0 ? 0.0 : kDensity * row.error;
}

double ResidualTable::commonShift() const {
  double sum = 0.0, variance = 0.0, noise = 0.0;
  for (const Row& row : rows) {
    sum += row.weight * row.value;
    noise += row.weight * meanOfNoise(row);
    variance += row.weight * row.weight * row.error * row.error;
  }
  if (sign() * sum < 0.0) return 0.0;
  return std::abs(sum) - noise > 5.0 * std::sqrt(variance) ? std::abs(sum) / weight() / scale : 0.0;
}

std::vector<ResidualTable> offEdges(const Replay& replay, std::vector<ResidualTable> tables) {
  for (ResidualTable& table : tables) {
    std::erase_if(table.rows, [&](const ResidualTable::Row& row) {
      return replay.samples()[row.sample].layout->cells()[row.cell].at_edge;
    });
  }
  return tables;
}

const ResidualTable* sameOf(const std::vector<ResidualTable>& tables, const ResidualTable& table) {
  const auto same = std::find_if(tables.begin(), tables.end(),
                                 [&](const ResidualTable& t) { return t.isOf(table.measurand, table.component); });
  return same == tables.end() ? nullptr : &*same;
}

const model::Measurand& measurandOf(const Replay& replay, Channel channel) {
  const auto& measurands = replay.experiment().measurands;
  const auto carried = std::find_if(measurands.begin(), measurands.end(), [&](const model::Measurand& m) {
    return m.name == nameOf(channel) || m.column == columnOf(channel);
  });
  return *carried;  // a replay has no other channels
}

namespace {

/// What the steps q in which values are reported add to the standard error of the difference of two standard
/// deviations, where the noise σ is less than about half a step. By the place in a step where a mean lies the same
/// noise scatters by nothing or by half a step: the variance of normal values, rounded to q, is
///
///   σ² + q²/12 - (q²/π² + 4 σ²) w cos(2 π μ/q) - …   with w = exp(-2 π² σ²/q²)
///
/// (Widrow & Kollár 2008, Quantization Noise, ch. 4; below 0.3 q further terms are as large, and this one alone is an
/// upper bound as far as simulated values tell). Means that are the same lie at the same place; others may lie
/// anywhere.
double errorOfPlace(double variance_of_noise, double means_apart, double step) {
  constexpr double kPi = std::numbers::pi;
  const double w = std::exp(-2.0 * kPi * kPi * variance_of_noise / (step * step));
  const double wave = (step * step / (kPi * kPi) + 4.0 * variance_of_noise) * w;
  const double middle = variance_of_noise + step * step / 12.0;
  const double most = std::sqrt(middle + wave), least = std::sqrt(std::max(0.0, middle - wave));
  const double apart = std::min(0.25, means_apart / step);
  return 0.5 * (most - least) * std::sqrt(1.0 - std::cos(2.0 * kPi * apart));
}

/// Values at one of two steps, with the shares p and 1 - p, have the standard deviation q √(p (1 - p)), of which n
/// values tell no more than q |1 - 2 p|/(2 √n); √w stands for |1 - 2 p|, which is near 1 where there is hardly any
/// noise. `inverse_counts`: the sum of 1/n of both sides.
double errorOfFew(double variance_of_noise, double inverse_counts, double step) {
  const double root_w = std::exp(-std::numbers::pi * std::numbers::pi * variance_of_noise / (step * step));
  return 0.5 * step * root_w * std::sqrt(inverse_counts);
}

double errorOfSteps(const CellStatistics& m, const CellStatistics& x, Channel channel, double step) {
  const double of_noise = std::max(0.0, 0.5 * (m.variance(channel) + x.variance(channel)) - step * step / 12.0);
  return std::hypot(errorOfPlace(of_noise, std::abs(m.mean(channel) - x.mean(channel)), step),
                    errorOfFew(of_noise, 1.0 / m.count + 1.0 / x.count, step));
}

void addValues(const Replay& replay, const Sides& sides, Channel channel, std::vector<ResidualTable>& tables) {
  const model::Measurand& measurand = measurandOf(replay, channel);
  ResidualTable bias{measurand.name, "bias", measurand.unit, measurand.resolution, {}};
  ResidualTable scatter{measurand.name, "scatter", measurand.unit, measurand.resolution, {}};
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    for (std::size_t c = 0; c < replay.samples()[s].layout->surfaces(); ++c) {
      const CellStatistics &m = sides.measured[s][c], &x = sides.simulated[s][c];
      if (m.count == 0.0 || x.count == 0.0) continue;
      bias.rows.push_back(
          {s, c, m.mean(channel) - x.mean(channel), meanError(replay, replay.samples()[s], c, channel, m, x), m.count});
      if (m.count < 5.0 || x.count < 5.0) continue;
      const double sm = std::sqrt(m.variance(channel)), sx = std::sqrt(x.variance(channel));
      const double of_steps = errorOfSteps(m, x, channel, measurand.resolution);
      const double error =
          std::sqrt(m.variance(channel) / (2.0 * (m.count - 1.0)) + x.variance(channel) / (2.0 * (x.count - 1.0)) +
                    std::pow(0.1 * measurand.resolution, 2.0) + of_steps * of_steps);
      scatter.rows.push_back({s, c, sm - sx, error, m.count});
    }
  }
  tables.push_back(std::move(bias));
  tables.push_back(std::move(scatter));
}

void addExistence(const Replay& replay, const Sides& sides, std::vector<ResidualTable>& tables) {
  ResidualTable missing{"existence", "missing", "1/shot", kExistenceScale, {}};
  ResidualTable extra{"existence", "extra", "1/shot", kExistenceScale, {}};
  double echoes = 0.0;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    if (sample.layout->pooled()) continue;
    const double of_measured = sides.measured_frames[s], of_simulated = sides.simulated_frames[s];
    for (std::size_t c = 0; c < sample.layout->cells().size(); ++c) {
      const double measured = sides.measured[s][c].count / of_measured;
      const double expected = sides.simulated[s][c].count / of_simulated;
      const double rate = std::clamp(0.5 * (measured + expected), 0.01, 0.99);
      const double error = std::sqrt(rate * (1.0 - rate) * (1.0 / of_measured + 1.0 / of_simulated) + 1e-4);
      const double value = measured - expected;
      echoes += expected * of_measured;
      // What may be noise stays in both with its sign, so that it averages out: a half of it would look like a loss.
      const bool noise = std::abs(value) < kBeyondNoise * error;
      const std::uint32_t beam = sample.layout->cells()[c].beam;
      missing.rows.push_back({s, c, noise ? value : std::min(0.0, value), error, of_measured, beam});
      extra.rows.push_back({s, c, noise ? value : std::max(0.0, value), error, of_measured, beam});
    }
  }
  for (ResidualTable* table : {&missing, &extra}) {
    if (table->rows.empty()) continue;
    if (echoes > 0.0) table->scale = kExistenceScale * echoes / table->weight();
    tables.push_back(std::move(*table));
  }
}

}  // namespace

std::vector<ResidualTable> residualTables(const Replay& replay, const Sides& sides) {
  std::vector<ResidualTable> tables;
  for (const Channel channel : replay.channels()) addValues(replay, sides, channel, tables);
  addExistence(replay, sides, tables);
  return tables;
}

}  // namespace gap
