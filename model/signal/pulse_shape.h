#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace model {

/// The form of the transmitted pulse as the receiver sees it: g(u), unit peak at u = 0, time in units of its full
/// width at half maximum, so that one width in seconds (Emitter::pulse_fwhm_ns) stretches every form.
///
///   1 |     _           Gaussian (default): g = 2^-(2u)²
///     |    / \          measured: straight lines between samples, zero outside of them
///   ½ |___|_  \___      first rise and last fall through ½ lie one width apart
///   0 |__/|    |  \___  u
///
/// Immutable and cheap to copy; safe to share.
class PulseShape {
 public:
  /// Gaussian.
  PulseShape() = default;
  /// From samples at strictly ascending times of any unit. Values below zero (noise) count as zero. The largest value
  /// must be positive and lie inside, and both ends below half of it (asserted: readPulseShape checks).
  PulseShape(std::vector<double> times, std::vector<double> powers);

  [[nodiscard]] bool isGaussian() const noexcept { return samples_ == nullptr; }
  [[nodiscard]] double at(double u) const;

  /// First rise and last fall through `level`, in widths. Closed form for the Gaussian.
  struct Crossings {
    double rise;
    double fall;
  };
  /// Nothing for levels of 1 and above; `level` must be positive.
  [[nodiscard]] std::optional<Crossings> crossings(double level) const;

  /// Full width at half maximum in the unit of the times that it was made from; 1 for the Gaussian.
  [[nodiscard]] double width() const noexcept { return width_; }
  /// Beyond these g is zero (Gaussian: infinite).
  [[nodiscard]] double begin() const noexcept;
  [[nodiscard]] double end() const noexcept;

 private:
  struct Samples {
    std::vector<double> u;
    std::vector<double> g;
  };
  std::shared_ptr<const Samples> samples_;
  double width_ = 1.0;
};

/// Reads a measured pulse; width() is its FWHM in ns.
///   CSV    columns `time_ns`, `power` (any unit)
///   .npy   one-dimensional histogram of a time-correlated detector with bins of `step_ns`; it counts as periodic, and
///          is turned so that its peak stands in the middle
/// Throws InputError with the line.
[[nodiscard]] PulseShape readPulseShape(const std::filesystem::path& file, std::optional<double> step_ns);

}  // namespace model
