#include "metrics/samples/sample_values.h"

#include <cmath>
#include <span>
#include <string>

#include "core/error.h"

namespace metrics {

bool isPlainSample(const Edf& edf) { return edf.n() > 0 && edf.effectiveN() == static_cast<double>(edf.n()); }

std::vector<double> sampleValues(const Edf& edf, std::string_view side) {
  if (!isPlainSample(edf)) {
    throw core::InputError({.item = std::string(side) + " sample"}, "is weighted or a table; this test counts values.",
                           "Give the values themselves, without weights.");
  }
  std::vector<double> values;
  values.reserve(edf.n());
  const std::span<const double> levels = edf.levels();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto reached = static_cast<std::size_t>(std::llround(levels[i] * edf.effectiveN()));
    values.resize(reached, edf.values()[i]);
  }
  return values;
}

}  // namespace metrics
