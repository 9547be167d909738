#include "model/effects/soft_target.h"

#include <algorithm>
#include <cmath>

#include "core/physics.h"
#include "model/overlap.h"

namespace model::effects {

namespace {

constexpr double kNegligible = 1e-3;        ///< of the threshold
constexpr double kAreaOfGaussian = 1.0645;  ///< of unit peak and unit width at half maximum, sqrt(π / (4 ln 2))

/// Mean of openShare over a stretch, so that a surface within it cuts the right share off.
double meanOpenShare(const BeamView& view, double from_m, double to_m) {
  double open = 1.0;
  for (const Hit& hit : view.hits) {
    open -= view.rays.weight[hit.ray] * std::clamp((to_m - hit.range_m) / (to_m - from_m), 0.0, 1.0);
  }
  return std::max(0.0, open);
}

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
  target.from_m = std::max(target.from_m, settings.detection.min_range_m);
  target.to_m = std::min(target.to_m, settings.detection.max_range_m);
  const double length_m = target.to_m - target.from_m;
  if (length_m <= 0.0 || target.backscatter_1_m_sr <= 0.0) return;
  const double width_m = pulseLength_m(settings.emitter);
  const double cells = std::ceil(length_m / (width_m / 2.0));
  const double step_m = length_m / cells;
  const double constant_w_m = view.power_constant_w_m2 * target.backscatter_1_m_sr;
  const double least_w_1_m = kNegligible * settings.receiver.threshold_w / (kAreaOfGaussian * width_m);
  const double first_m = target.from_m + step_m / 2.0, of_step = std::exp(-2.0 * target.extinction_1_m * step_m);
  double passed = std::exp(-2.0 * target.extinction_1_m * (first_m - target.extinction_from_m));  // there and back
  for (double k = 0.0; k < cells; k += 1.0, passed *= of_step) {
    const double begin_m = target.from_m + k * step_m, range_m = begin_m + step_m / 2.0;
    const double in_the_open_w_1_m = constant_w_m * passed / (range_m * range_m);
    const double open = meanOpenShare(view, begin_m, begin_m + step_m);
    if (in_the_open_w_1_m < least_w_1_m || open <= 1e-9) break;
    const double seen = overlap(settings.emitter, settings.receiver, range_m);
    if (seen > 0.0) pulses.push_back({range_m, in_the_open_w_1_m * open * seen * step_m});
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
