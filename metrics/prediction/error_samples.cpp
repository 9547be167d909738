#include "metrics/prediction/error_samples.h"

#include <cmath>
#include <fmt/format.h>
#include <set>

#include "core/error.h"

namespace metrics {

namespace {

void checkNames(const ErrorSamples& samples) {
  if (samples.parameters.empty() || samples.parameters.size() > kMaxParameters) {
    throw core::InputError(
        {.item = "parameters"},
        fmt::format("{} are given; an error is predicted over 1 to {}.", samples.parameters.size(), kMaxParameters),
        "Name the parameters that matter most.");
  }
  std::set<std::string> seen;
  for (const std::string& name : samples.parameters) {
    if (name.empty() || !seen.insert(name).second) {
      throw core::InputError({.item = "parameters"}, "the name '" + name + "' is empty or given twice.",
                             "Give every parameter once.");
    }
  }
}

void checkLengths(const ErrorSamples& samples) {
  const std::size_t n = samples.size();
  if (n == 0) {
    throw core::InputError({.item = samples.target}, "there are no samples; nothing can be learnt.",
                           "Give validation results, one row a sample.");
  }
  const auto demand = [&](const char* what, std::size_t given, std::size_t wanted) {
    if (given != wanted) {
      throw core::InputError({.item = what}, fmt::format("has {} entries; {} are needed.", given, wanted),
                             "Give one for each row.");
    }
  };
  demand("points", samples.points.size(), n * samples.parameters.size());
  if (!samples.weights.empty()) demand("weights", samples.weights.size(), n);
  if (!samples.setups.empty()) demand("setups", samples.setups.size(), n);
}

void checkNumber(double value, const std::string& name, std::size_t row) {
  if (!std::isfinite(value)) {
    throw core::InputError({.item = fmt::format("{}, row {}", name, row + 1)},
                           fmt::format("{} is not a finite number.", value), "Leave the row out, or repair it.");
  }
}

}  // namespace

void check(const ErrorSamples& samples) {
  checkNames(samples);
  checkLengths(samples);
  for (std::size_t row = 0; row < samples.size(); ++row) {
    for (std::size_t k = 0; k < samples.parameters.size(); ++k) {
      checkNumber(samples.point(row)[k], samples.parameters[k], row);
    }
    checkNumber(samples.errors[row], samples.target, row);
    checkNumber(samples.weight(row), "weight", row);
    if (samples.weight(row) <= 0.0) {
      throw core::InputError({.item = fmt::format("weight, row {}", row + 1)},
                             fmt::format("{} is not positive.", samples.weight(row)),
                             "Leave the row out if it should not count.");
    }
  }
}

ErrorSamples rowsOf(const ErrorSamples& samples, std::span<const std::size_t> rows) {
  ErrorSamples part{.target = samples.target, .parameters = samples.parameters, .points = {}, .errors = {}};
  for (const std::size_t row : rows) {
    const auto point = samples.point(row);
    part.points.insert(part.points.end(), point.begin(), point.end());
    part.errors.push_back(samples.errors[row]);
    if (!samples.weights.empty()) part.weights.push_back(samples.weights[row]);
    if (!samples.setups.empty()) part.setups.push_back(samples.setups[row]);
  }
  return part;
}

}  // namespace metrics
