#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace metrics {

/// How far a curve may be off: k s + absolute + relative |mean|, with s the deviation of the repetitions.
struct Tolerance {
  double deviations = 0.0;  ///< k
  double absolute = 0.0;    ///< [unit of the measurand]
  double relative = 0.0;    ///< 0.05 for 5 per cent
};

/// Bounds over a parameter (range, time, lateral acceleration).
///
///   y |      ___________ high
///     |   __/  .  .  .        . the curve to be checked: one point outside
///     |  / .  ________ low
///     |__.__/____________ parameter
struct ToleranceBand {
  std::vector<double> parameter;  ///< ascending
  std::vector<double> low;
  std::vector<double> high;
};

/// Around the mean of repeated curves, each with one value at every parameter. With one curve and deviations = 0 it is
/// a band around that curve: around the simulation, as ISO 19364 draws it, to lay measured runs into.
/// Throws InputError if there are no curves or parameters, lengths differ, parameters do not ascend, a number is not
/// finite, a tolerance is negative, or deviations > 0 with a single curve.
[[nodiscard]] ToleranceBand toleranceBand(std::span<const double> parameter,
                                          std::span<const std::vector<double>> curves, const Tolerance& tolerance);

struct Violation {
  std::size_t index;  ///< from 0
  double parameter;
  double excess;  ///< beyond the bound; > 0: above, < 0: below [unit of the measurand]
};

struct ToleranceCheck {
  double share_inside;  ///< of the points, bounds included
  std::optional<Violation> first;
  std::optional<Violation> worst;  ///< with the largest |excess|

  [[nodiscard]] bool passed() const noexcept { return !first; }
};

/// Is the curve inside the band at every parameter? Values between the parameters are not looked at.
/// Throws InputError unless the curve has one finite value at every parameter.
/// In the style of ISO 19364:2016 and ISO 19365:2016 (vehicle dynamics simulation and validation); which quantities
/// and which tolerances is theirs, and is not repeated here.
[[nodiscard]] ToleranceCheck checkTolerance(const ToleranceBand& band, std::span<const double> curve);

}  // namespace metrics
