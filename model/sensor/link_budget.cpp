#include "model/sensor/link_budget.h"

#include <boost/math/special_functions/lambert_w.hpp>
#include <cmath>
#include <numbers>

#include "core/physics.h"
#include "model/extinction.h"

namespace model {

namespace {

/// Φ(2.326) = 0.99.
constexpr double kSure = 2.3263478740408408;

/// C Γ: the power at 1 m in clear air.
double powerAtOneMetre_w(const SensorProfile& sensor, const LinkTarget& target) {
  const double diameter_m = sensor.receiver.aperture_diameter_m;
  return target.gain * sensor.emitter.peak_power_w * sensor.receiver.efficiency * diameter_m * diameter_m / 4.0 *
         target.reflectivity;
}

}  // namespace

double receivedPower_w(const SensorProfile& sensor, const LinkTarget& target, double range_m) {
  return powerAtOneMetre_w(sensor, target) * std::exp(-2.0 * target.extinction_1_m * range_m) / (range_m * range_m);
}

double rangeOfPower_m(const SensorProfile& sensor, const LinkTarget& target, double power_w) {
  const double in_clear_air_m = std::sqrt(powerAtOneMetre_w(sensor, target) / power_w);
  const double alpha = target.extinction_1_m;
  return alpha > 0.0 ? boost::math::lambert_w0(alpha * in_clear_air_m) / alpha : in_clear_air_m;
}

std::vector<LinkBudgetRow> linkBudget(const SensorProfile& sensor, std::span<const double> reflectivities,
                                      std::span<const std::optional<double>> visibilities_m) {
  const Receiver& receiver = sensor.receiver;
  std::vector<LinkBudgetRow> rows;
  for (const double reflectivity : reflectivities) {
    for (const std::optional<double>& visibility_m : visibilities_m) {
      const double extinction =
          visibility_m ? extinctionFromVisibility(*visibility_m, sensor.emitter.wavelength_nm) : 0.0;
      const LinkTarget target{.reflectivity = reflectivity, .extinction_1_m = extinction};
      rows.push_back({reflectivity, visibility_m, rangeOfPower_m(sensor, target, receiver.threshold_w),
                      rangeOfPower_m(sensor, target, receiver.threshold_w + kSure * receiver.noise_w)});
    }
  }
  return rows;
}

double falseAlarmsPerBeam(const SensorProfile& sensor) {
  const Receiver& receiver = sensor.receiver;
  if (receiver.noise_w == 0.0) return 0.0;
  const double ratio = receiver.threshold_w / receiver.noise_w;
  const double correlation_s = sensor.emitter.pulse_fwhm_ns * 1e-9 / (2.0 * std::sqrt(std::numbers::ln2));
  const double rate_1_s = std::exp(-0.5 * ratio * ratio) / (2.0 * std::numbers::pi * correlation_s);
  const double window_m = sensor.detection.max_range_m - sensor.detection.min_range_m;
  return rate_1_s * 2.0 * window_m / core::kSpeedOfLight_m_s;
}

}  // namespace model
