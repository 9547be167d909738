#pragma once

#include <cstddef>
#include <vector>

namespace model {

/// Refractive index over wavelength as one of the formulas of refractiveindex.info:
///
///   1 Sellmeier    n² - 1 = C1 + Σ C_i λ²/(λ² - C_{i+1}²)         6 gases        n - 1 = C1 + Σ C_i/(C_{i+1} - λ^-2)
///   2 Sellmeier-2  n² - 1 = C1 + Σ C_i λ²/(λ² - C_{i+1})          7 Herzberger   n = C1 + C2 L + C3 L² + C4 λ² + C5 λ⁴
///   3 polynomial   n² = C1 + Σ C_i λ^C_{i+1}                                         + C6 λ⁶,  L = 1/(λ² - 0.028)
///   4              n² = C1 + two terms C2 λ^C3/(λ² - C4^C5)       8 retro        (n²-1)/(n²+2) = C1 + C2 λ²/(λ² - C3)
///                       + Σ C_i λ^C_{i+1} from C10 on                                           + C4 λ²
///   5 Cauchy       n = C1 + Σ C_i λ^C_{i+1}                       9 exotic       n² = C1 + C2/(λ² - C3)
///                                                                                   + C4 (λ-C5)/((λ-C5)² + C6)
///
/// λ in micrometres. Source: refractiveindex.info, "Dispersion formulas" (part of its database, CC0).
struct Dispersion {
  int formula = 1;                   ///< 1 to 9
  std::vector<double> coefficients;  ///< C1, C2, …; those not given are zero

  static constexpr int kFormulas = 9;
  /// Most coefficients that a formula has.
  [[nodiscard]] static std::size_t largestCount(int formula);

  /// NaN where the formula has no real value.
  [[nodiscard]] double at(double wavelength_um) const;
};

}  // namespace model
