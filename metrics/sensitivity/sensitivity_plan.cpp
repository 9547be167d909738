#include "metrics/sensitivity/sensitivity_plan.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <set>

#include "core/error.h"
#include "core/random.h"

namespace metrics {

namespace {

constexpr std::size_t kMostParameters = 1800;  // the table of directions has 3667 dimensions, two a parameter

void check(const UncertainParameter& parameter) {
  const core::Place place{.item = "parameter '" + parameter.name + "'"};
  if (!std::isfinite(parameter.min) || !std::isfinite(parameter.max) || !(parameter.min < parameter.max)) {
    throw core::InputError(place, fmt::format("has the range {} to {}.", parameter.min, parameter.max),
                           "Give the smaller end first; a parameter that does not vary is left out.");
  }
  if (parameter.logarithmic && parameter.min <= 0.0) {
    throw core::InputError(place, fmt::format("is logarithmic and begins at {}.", parameter.min),
                           "Begin above 0, or vary it linearly.");
  }
}

void check(const std::vector<UncertainParameter>& parameters) {
  if (parameters.empty() || parameters.size() > kMostParameters) {
    throw core::InputError({}, fmt::format("{} parameters to vary.", parameters.size()),
                           fmt::format("Give 1 to {}.", kMostParameters));
  }
  std::set<std::string> seen{"A", "B"};
  for (const UncertainParameter& parameter : parameters) {
    check(parameter);
    if (seen.insert(parameter.name).second) continue;
    throw core::InputError({.item = "parameter '" + parameter.name + "'"},
                           "is given twice, or has the name of a block.", "Choose another name.");
  }
}

std::uint64_t bits64(core::Random& random) {
  const auto half = [&random] { return static_cast<std::uint64_t>(random.uniform() * 0x1.0p32); };
  const std::uint64_t high = half();
  return high << 32 | half();
}

/// Shares of the ranges: n points in `dimensions` dimensions.
std::vector<std::vector<double>> shiftedSobolPoints(std::size_t dimensions, std::size_t n, std::uint64_t seed) {
  core::Random random({.seed = seed, .purpose = core::purposeOf("sobol plan")});
  std::vector<std::uint64_t> shifts(dimensions);
  for (std::uint64_t& shift : shifts) shift = bits64(random);

  boost::random::sobol sequence(dimensions);
  std::vector<std::vector<double>> points(n, std::vector<double>(dimensions));
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t d = 0; d < dimensions; ++d) {
      // Boost leaves out the origin, which belongs to the first 2^m points.
      const std::uint64_t bits = (row == 0 ? 0 : sequence()) ^ shifts[d];
      points[row][d] = (static_cast<double>(bits >> 12) + 0.5) * 0x1.0p-52;
    }
  }
  return points;
}

/// How fast the parameters of block `fastest` swing.
std::vector<std::size_t> frequencies(std::size_t count, std::size_t fastest, std::size_t n) {
  const std::size_t highest = std::max<std::size_t>(1, fastFrequency(n) / (2 * kFastHarmonics));
  std::vector<std::size_t> result(count, fastFrequency(n));
  std::size_t other = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == fastest) continue;
    // Spread over 1 … highest; again from 1 if there are more parameters than frequencies.
    const bool room = count > 2 && highest >= count - 1;
    result[i] = room ? 1 + other * (highest - 1) / (count - 2) : 1 + other % highest;
    ++other;
  }
  return result;
}

}  // namespace

double UncertainParameter::at(double u) const {
  if (!logarithmic) return std::lerp(min, max, u);
  return std::clamp(std::exp(std::lerp(std::log(min), std::log(max), u)), min, max);
}

std::string SensitivityPlan::blockOf(std::size_t row) const {
  const std::size_t block = row / n;
  if (method == SensitivityMethod::Fast) return parameters[block % parameters.size()].name;
  if (block < 2) return block == 0 ? "A" : "B";
  return parameters[block - 2].name;
}

std::size_t SensitivityPlan::curveOf(std::size_t row) const {
  return method == SensitivityMethod::Fast ? 1 + row / (n * parameters.size()) : 1;
}

std::size_t rowCount(const SensitivityPlan& plan) {
  const std::size_t k = plan.parameters.size();
  return plan.n * (plan.method == SensitivityMethod::Sobol ? k + 2 : k * plan.curves);
}

SensitivityPlan sobolPlan(std::vector<UncertainParameter> parameters, std::size_t n, std::uint64_t seed) {
  check(parameters);
  if (n < 2) throw core::InputError({.item = "n"}, fmt::format("is {}.", n), "Give 64 or more, a power of two.");
  const std::size_t k = parameters.size();
  const auto points = shiftedSobolPoints(2 * k, n, seed);
  SensitivityPlan plan{
      .method = SensitivityMethod::Sobol, .parameters = std::move(parameters), .n = n, .curves = 1, .rows = {}};
  const auto addBlock = [&](auto from_b) {
    for (const std::vector<double>& point : points) {
      std::vector<double>& row = plan.rows.emplace_back();
      for (std::size_t i = 0; i < k; ++i) row.push_back(plan.parameters[i].at(point[from_b(i) ? k + i : i]));
    }
  };
  addBlock([](std::size_t) { return false; });
  addBlock([](std::size_t) { return true; });
  for (std::size_t changed = 0; changed < k; ++changed) {
    addBlock([changed](std::size_t i) { return i == changed; });
  }
  return plan;
}

SensitivityPlan fastPlan(std::vector<UncertainParameter> parameters, std::size_t n, std::size_t curves,
                         std::uint64_t seed) {
  check(parameters);
  if (n < 4 * kFastHarmonics * kFastHarmonics + 1) {
    throw core::InputError({.item = "n"}, fmt::format("is {}; a curve with four harmonics needs 65 points.", n),
                           "Give 65 or more, better some hundreds.");
  }
  if (curves == 0) throw core::InputError({.item = "curves"}, "are none.", "Give 2 or more for intervals.");
  SensitivityPlan plan{
      .method = SensitivityMethod::Fast, .parameters = std::move(parameters), .n = n, .curves = curves, .rows = {}};
  const std::size_t k = plan.parameters.size();
  for (std::size_t curve = 0; curve < curves; ++curve) {
    for (std::size_t block = 0; block < k; ++block) {
      core::Random random({.seed = seed,
                           .sample = static_cast<std::uint32_t>(curve),
                           .frame = static_cast<std::uint32_t>(block),
                           .purpose = core::purposeOf("fast plan")});
      std::vector<double> phases(k);
      for (double& phase : phases) phase = 2.0 * std::numbers::pi * random.uniform();
      const std::vector<std::size_t> speeds = frequencies(k, block, n);
      for (std::size_t j = 0; j < n; ++j) {
        const double s = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
        std::vector<double>& row = plan.rows.emplace_back();
        for (std::size_t i = 0; i < k; ++i) {
          const double swing = std::asin(std::sin(static_cast<double>(speeds[i]) * s + phases[i]));
          row.push_back(plan.parameters[i].at(0.5 + swing / std::numbers::pi));
        }
      }
    }
  }
  return plan;
}

}  // namespace metrics
