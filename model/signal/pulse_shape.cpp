#include "model/signal/pulse_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/csv.h"
#include "core/error.h"
#include "core/npy.h"
#include "core/text.h"

namespace model {

namespace {

constexpr double kNothing = 1e-6;  ///< share of the peak below which the ends of a record are cut off

using Curve = std::vector<double>;

/// Where the line between samples i and i + 1 reaches `level`.
double crossingBetween(const Curve& x, const Curve& y, std::size_t i, double level) {
  return x[i] + (level - y[i]) / (y[i + 1] - y[i]) * (x[i + 1] - x[i]);
}

/// First rise and last fall of a curve whose ends lie at or below the level; an end above it counts as crossing.
PulseShape::Crossings outermost(const Curve& x, const Curve& y, double level) {
  std::size_t first = 0, last = y.size() - 1;
  while (y[first] <= level) ++first;
  while (y[last] <= level) --last;
  return {first == 0 ? x.front() : crossingBetween(x, y, first - 1, level),
          last + 1 == y.size() ? x.back() : crossingBetween(x, y, last, level)};
}

[[noreturn]] void refuse(const core::Place& place, const std::string& problem) {
  throw core::InputError(place, problem, "Give the pulse from before its rise to after its fall.");
}

/// What PulseShape asks of its samples.
void check(const std::filesystem::path& file, const Curve& powers) {
  if (powers.size() < 3) refuse({.file = file}, "has fewer than three samples.");
  const double peak = *std::max_element(powers.begin(), powers.end());
  if (peak <= 0.0) refuse({.file = file}, "holds no positive power.");
  if (powers.front() >= 0.5 * peak || powers.back() >= 0.5 * peak) {
    refuse({.file = file}, "begins or ends above half of its peak.");
  }
}

PulseShape fromCsv(const std::filesystem::path& file) {
  const core::CsvTable table = core::readCsvTable(file);
  const std::size_t columns[] = {table.column("time_ns"), table.column("power")};
  Curve values[2];
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const core::Place place{.file = file, .line = table.lines[row]};
    for (std::size_t k = 0; k < 2; ++k) {
      double value = 0.0;
      const std::string& cell = table.rows[row][columns[k]];
      if (!core::parseNumber(cell, value) || !std::isfinite(value)) refuse(place, "'" + cell + "' is not a number.");
      values[k].push_back(value);
    }
    if (row > 0 && values[0][row] <= values[0][row - 1]) refuse(place, "time_ns does not ascend.");
  }
  check(file, values[1]);
  return {std::move(values[0]), std::move(values[1])};
}

PulseShape fromHistogram(const std::filesystem::path& file, double step_ns) {
  Curve powers = core::readNpy(file);
  if (powers.size() < 3) refuse({.file = file}, "has fewer than three samples.");
  const auto peak = std::max_element(powers.begin(), powers.end()) - powers.begin();
  const auto size = static_cast<std::ptrdiff_t>(powers.size());
  std::rotate(powers.begin(), powers.begin() + (peak - size / 2 + size) % size, powers.end());
  check(file, powers);
  Curve times(powers.size());
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = step_ns * static_cast<double>(i);
  return {std::move(times), std::move(powers)};
}

}  // namespace

PulseShape::PulseShape(std::vector<double> times, std::vector<double> powers) {
  assert(times.size() == powers.size() && times.size() >= 3);
  const auto top = std::max_element(powers.begin(), powers.end());
  const double peak = *top, peak_time = times[static_cast<std::size_t>(top - powers.begin())];
  assert(peak > 0.0);
  for (double& power : powers) power = std::max(0.0, power / peak);
  const Crossings half = outermost(times, powers, 0.5);
  width_ = half.fall - half.rise;
  Samples samples;
  // One sample of nothing stays at either end, so that the pulse begins and ends at zero if it did so in the record.
  const auto something = [](double g) { return g > kNothing; };
  const auto size = static_cast<std::ptrdiff_t>(powers.size());
  const auto first = std::find_if(powers.begin(), powers.end(), something) - powers.begin();
  const auto last = powers.rend() - std::find_if(powers.rbegin(), powers.rend(), something) - 1;
  for (auto i = std::max<std::ptrdiff_t>(0, first - 1); i <= std::min(size - 1, last + 1); ++i) {
    samples.u.push_back((times[static_cast<std::size_t>(i)] - peak_time) / width_);
    samples.g.push_back(powers[static_cast<std::size_t>(i)]);
  }
  samples_ = std::make_shared<const Samples>(std::move(samples));
}

double PulseShape::at(double u) const {
  if (isGaussian()) return std::exp2(-4.0 * u * u);
  const Curve& x = samples_->u;
  if (u < x.front() || u > x.back()) return 0.0;
  const auto upper = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), u) - x.begin());
  if (upper == x.size()) return samples_->g.back();
  const double share = (u - x[upper - 1]) / (x[upper] - x[upper - 1]);
  return samples_->g[upper - 1] + share * (samples_->g[upper] - samples_->g[upper - 1]);
}

std::optional<PulseShape::Crossings> PulseShape::crossings(double level) const {
  assert(level > 0.0);
  if (level >= 1.0) return std::nullopt;
  if (!isGaussian()) return outermost(samples_->u, samples_->g, level);
  const double half = 0.5 * std::sqrt(-std::log2(level));
  return Crossings{-half, half};
}

double PulseShape::begin() const noexcept {
  return isGaussian() ? -std::numeric_limits<double>::infinity() : samples_->u.front();
}

double PulseShape::end() const noexcept {
  return isGaussian() ? std::numeric_limits<double>::infinity() : samples_->u.back();
}

PulseShape readPulseShape(const std::filesystem::path& file, std::optional<double> step_ns) {
  if (core::lowerCase(file.extension().string()) != ".npy") return fromCsv(file);
  if (!step_ns) {
    throw core::InputError({.file = file}, "holds no times.", R"(Say how long a bin is: "step_ns" beside "file".)");
  }
  return fromHistogram(file, *step_ns);
}

}  // namespace model
