#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "metrics/prediction/error_samples.h"
#include "tests/support/paths.h"

namespace test_prediction {

/// An experiment package without anything to hit; measurands range (range_m) and epw (epw_m), both in m.
[[nodiscard]] nlohmann::json emptyExperiment();

/// Adds a sample whose measurement is this text, and writes both.
void addSample(const test_support::TemporaryFolder& folder, nlohmann::json& experiment, const std::string& id,
               const nlohmann::json& parameters, const std::string& measurement);

/// Errors 0.1 + 0.01 x, off by -r, +2r, -r at 10, 20 and 30 (`residual` r). The residuals are orthogonal to 1 and x, so
/// the line is the one of least squares, with s^2 = 6 r^2, one degree of freedom and h(x) = 1/3 + (x - 20)^2 / 200.
[[nodiscard]] metrics::ErrorSamples aroundLine(const std::string& parameter, double residual);

/// Saves linear predictions of these samples as `fidelis predict --save` does; without measurand if it is "".
std::filesystem::path savePrediction(const std::filesystem::path& file,
                                     const std::vector<metrics::ErrorSamples>& samples, const std::string& measurand);

}  // namespace test_prediction
