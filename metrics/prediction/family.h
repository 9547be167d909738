#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/prediction/error_samples.h"

namespace metrics {

/// Shape of the function that an error follows over its parameters x1 … xp, simplest first:
///
///   constant      a
///   linear        a + b1 x1 + … + bp xp
///   quadratic     linear + every square and product of two parameters
///   exponential   a + b exp(c1 x1 + … + cp xp)
///   sigmoid       a + b / (1 + exp(-(s + c1 x1 + … + cp xp))),  c1 >= 0
///
/// The first three are linear in their coefficients: least squares has one exact solution. Over several parameters the
/// last two follow one weighted sum of them; that is our choice.
enum class Family { Constant, Linear, Quadratic, Exponential, Sigmoid };

inline constexpr std::array<Family, 5> kFamilies{Family::Constant, Family::Linear, Family::Quadratic,
                                                 Family::Exponential, Family::Sigmoid};

/// 1 + p + p (p + 1) / 2 of a quadratic over kMaxParameters.
inline constexpr std::size_t kMaxCoefficients = 1 + kMaxParameters + kMaxParameters * (kMaxParameters + 1) / 2;

[[nodiscard]] std::string_view name(Family family);
[[nodiscard]] constexpr bool isLinearInCoefficients(Family family) { return family <= Family::Quadratic; }
[[nodiscard]] std::size_t coefficientCount(Family family, std::size_t parameters);

/// "intercept", "range_m", "range_m^2", "range_m*angle_deg" …, in the order of the coefficients.
[[nodiscard]] std::vector<std::string> coefficientNames(Family family, std::span<const std::string> parameters);

/// The function at x and its derivatives by each coefficient; `gradient` has room for all of them. Allocates nothing.
double valueAndGradient(Family family, std::span<const double> coefficients, std::span<const double> x,
                        std::span<double> gradient);

}  // namespace metrics
