#pragma once

#include <string_view>
#include <vector>

#include "metrics/distributions/edf.h"

namespace metrics {

/// Whether the function is that of a sample in which every value counts the same: not weighted, not from a table.
[[nodiscard]] bool isPlainSample(const Edf& edf);

/// The values of a plain sample, ascending, each as often as it occurred. For tests that count values; exact, since
/// levels are correctly rounded i/n. Throws InputError that names `side` if the sample is not plain.
[[nodiscard]] std::vector<double> sampleValues(const Edf& edf, std::string_view side);

}  // namespace metrics
