#include "model/effects/soft_target.h"

#include <algorithm>
#include <cmath>

#include "core/physics.h"
#include "model/overlap.h"

namespace model::effects {

namespace {

constexpr double kNegligible = 1e-3;        ///< of the threshold
constexpr double kAreaOfGaussian = 1.0645;  ///< of unit peak and unit width at half maximum, sqrt(π / (4 ln 2))
constexpr double kNearestAir_m = 0.1;       ///< 1/r² has no end, and no profile says what the optics make of it there
constexpr double kLeastCells = 8.0;      ///< or a cloud shorter than a pulse would be one pulse, too high and too short
constexpr double kShortestCells = 4.0;   ///< so many are as long as the longest: what is shorter the pulse blurs
constexpr double kGrowthOfCells = 1.15;  ///< near the sensor, where 1/r² and the overlap change within a pulse

/// Mean of openShare over a stretch, so that a surface within it cuts the right share off.
double meanOpenShare(const BeamView& view, double from_m, double to_m) {
  double open = 1.0;
  for (const Hit& hit : view.hits) {
    open -= view.rays.weight[hit.ray] * std::clamp((to_m - hit.range_m) / (to_m - from_m), 0.0, 1.0);
  }
  return std::max(0.0, open);
}

/// Cells of a stretch of air: growing with the range as long as they are shorter than the longest, then all alike.
class Cells {
 public:
  Cells(double from_m, double to_m, double longest_m)
      : to_m_(to_m),
        even_from_m_(std::clamp(longest_m / (kGrowthOfCells - 1.0), from_m, to_m)),
        shortest_m_(longest_m / kShortestCells) {
    const double even_m = to_m_ - even_from_m_;
    step_m_ = even_m / std::max(1.0, std::ceil(even_m / longest_m));
  }

  /// Where the cell ends that begins there. The last one ends at the end, whatever its steps add up to.
  [[nodiscard]] double endOf(double begin_m) const {
    if (begin_m < even_from_m_) {
      return std::min(begin_m + std::max(shortest_m_, begin_m * (kGrowthOfCells - 1.0)), even_from_m_);
    }
    const double end_m = begin_m + step_m_;
    return end_m <= begin_m || to_m_ - begin_m < 1.5 * step_m_ ? to_m_ : end_m;  // a step may be less than rounding
  }

 private:
  double to_m_, even_from_m_, shortest_m_, step_m_ = 0.0;
};

}  // namespace

double pulseLength_m(const Emitter& emitter) { return core::kMetresPerNanosecond * emitter.pulse_fwhm_ns / 2.0; }

double openShare(const BeamView& view, double range_m) {
  double open = 1.0;
  for (const Hit& hit : view.hits) {
    if (hit.range_m < range_m) open -= view.rays.weight[hit.ray];
  }
  return open > 1e-9 ? open : 0.0;  // the weights sum to one but for rounding
}

void addSoftTarget(const BeamView& view, SoftTarget target, std::vector<Pulse>& pulses) {
  const ChainSettings& settings = view.settings;
  target.from_m = std::max({target.from_m, settings.detection.min_range_m, kNearestAir_m});
  target.to_m = std::min(target.to_m, settings.detection.max_range_m);
  if (target.to_m <= target.from_m || target.backscatter_1_m_sr <= 0.0) return;
  const double width_m = pulseLength_m(settings.emitter);
  const double longest_m = std::min(width_m / 2.0, (target.to_m - target.from_m) / kLeastCells);
  const Cells cells(target.from_m, target.to_m, longest_m);
  const double constant_w_m = view.power_constant_w_m2 * target.backscatter_1_m_sr;
  const double least_w_1_m = kNegligible * settings.receiver.threshold_w / (kAreaOfGaussian * width_m);
  for (double begin_m = target.from_m, end_m = 0.0; begin_m < target.to_m; begin_m = end_m) {
    end_m = cells.endOf(begin_m);
    const double of_square_1_m = (end_m - begin_m) / (begin_m * end_m);  // ∫ dr / r², and where its weight lies:
    const double range_m = std::log1p((end_m - begin_m) / begin_m) / of_square_1_m;
    const double passed = std::exp(-2.0 * target.extinction_1_m * (range_m - target.extinction_from_m));
    const double in_the_open_w = constant_w_m * passed * of_square_1_m;
    const double open = meanOpenShare(view, begin_m, end_m);
    if (in_the_open_w < least_w_1_m * (end_m - begin_m) || open <= 1e-9) break;
    const double seen = overlap(settings.emitter, settings.receiver, range_m);
    if (seen > 0.0) pulses.push_back({range_m, in_the_open_w * open * seen, false});
  }
}

double Passage::lengthBefore_m(double range_m) const { return std::clamp(range_m, enter_m, leave_m) - enter_m; }

Passage passageThroughSphere(const Vector3& origin, const Vector3& direction, const Vector3& centre, double radius_m) {
  double along = 0.0, distance2 = 0.0;
  for (std::size_t k = 0; k < 3; ++k) along += (centre[k] - origin[k]) * direction[k];
  for (std::size_t k = 0; k < 3; ++k) {
    const double aside = centre[k] - origin[k] - along * direction[k];
    distance2 += aside * aside;
  }
  const double half2 = radius_m * radius_m - distance2;
  if (half2 <= 0.0) return {};
  const double half = std::sqrt(half2);
  return {std::max(0.0, along - half), std::max(0.0, along + half)};
}

}  // namespace model::effects
