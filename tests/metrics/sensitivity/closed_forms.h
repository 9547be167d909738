#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "metrics/sensitivity/sensitivity_plan.h"

namespace metrics_test {

using Model = std::function<double(const std::vector<double>&)>;

/// Outputs of a model for every row of a plan.
inline std::vector<double> outputsOf(const metrics::SensitivityPlan& plan, const Model& model) {
  std::vector<double> outputs;
  for (const std::vector<double>& row : plan.rows) outputs.push_back(model(row));
  return outputs;
}

inline std::vector<metrics::UncertainParameter> parameters(std::size_t count, double min, double max) {
  std::vector<metrics::UncertainParameter> all;
  for (std::size_t i = 1; i <= count; ++i) all.push_back({.name = "x" + std::to_string(i), .min = min, .max = max});
  return all;
}

/// Ishigami & Homma 1990, doi:10.1109/ISUMA.1990.151285, with a = 7, b = 0.1 on [-pi, pi]^3.
/// V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2, V1 = (1 + b pi^4/5)^2 / 2, V2 = a^2/8, V13 = b^2 pi^8 (1/18 - 1/50).
inline double ishigami(const std::vector<double>& x) {
  return std::sin(x[0]) + 7.0 * std::pow(std::sin(x[1]), 2.0) + 0.1 * std::pow(x[2], 4.0) * std::sin(x[0]);
}
inline std::vector<metrics::UncertainParameter> ishigamiParameters() {
  return parameters(3, -std::numbers::pi, std::numbers::pi);
}
inline const std::vector<double> kIshigamiFirst{0.3139, 0.4424, 0.0};
inline const std::vector<double> kIshigamiTotal{0.5576, 0.4424, 0.2437};

/// Sobol's G function, product of (|4 x_i - 2| + a_i) / (1 + a_i) on [0, 1]^k: V_i = 1 / (3 (1 + a_i)^2),
/// V = prod (1 + V_i) - 1, S_i = V_i / V, S_Ti = V_i prod_{j != i} (1 + V_j) / V. Saltelli & Sobol' 1995.
struct GFunction {
  std::vector<double> a;

  double operator()(const std::vector<double>& x) const {
    double product = 1.0;
    for (std::size_t i = 0; i < a.size(); ++i) product *= (std::abs(4.0 * x[i] - 2.0) + a[i]) / (1.0 + a[i]);
    return product;
  }
  [[nodiscard]] double part(std::size_t i) const { return 1.0 / (3.0 * std::pow(1.0 + a[i], 2.0)); }
  [[nodiscard]] double product() const {
    double all = 1.0;
    for (std::size_t i = 0; i < a.size(); ++i) all *= 1.0 + part(i);
    return all;
  }
  [[nodiscard]] double first(std::size_t i) const { return part(i) / (product() - 1.0); }
  [[nodiscard]] double total(std::size_t i) const { return part(i) * product() / (1.0 + part(i)) / (product() - 1.0); }
};

}  // namespace metrics_test
