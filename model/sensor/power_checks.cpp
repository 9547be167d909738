#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/physics.h"
#include "model/sensor/beams.h"
#include "model/sensor/checks.h"
#include "model/sensor/link_budget.h"

namespace model::checks {

namespace {

/// Extent of the pulse on the range axis.
double pulseLength_m(const SensorProfile& sensor) {
  return core::kMetresPerNanosecond * sensor.emitter.pulse_fwhm_ns / 2.0;
}

struct Side {
  const char* name;
  double beam_rad;
  double view_rad;
};

std::vector<Side> sides(const SensorProfile& sensor) {
  const AngularSize& beam = sensor.emitter.divergence;
  const AngularSize& view = sensor.receiver.field_of_view;
  return {{"horizontal", beam.horizontal_rad, view.horizontal_rad}, {"vertical", beam.vertical_rad, view.vertical_rad}};
}

}  // namespace

void beamWidth(const SensorProfile& sensor, std::vector<Finding>& findings) {
  constexpr double kWide_rad = 0.2;
  const AngularSize& beam = sensor.emitter.divergence;
  if (beam.horizontal_rad == 0.0) {
    findings.push_back({Severity::kNote, "/emitter/divergence_rad", "is not given.",
                        "The effect beam-divergence has nothing to spread: no partial hits, no broadened echoes.",
                        "Give the full widths, or the effect's horizontal_rad and vertical_rad."});
  } else if (std::max(beam.horizontal_rad, beam.vertical_rad) > kWide_rad) {
    findings.push_back({Severity::kWarning, "/emitter/divergence_rad",
                        fmt::format("is {:.3g} rad ({:.3g}°) wide.", std::max(beam.horizontal_rad, beam.vertical_rad),
                                    core::kDegPerRad * std::max(beam.horizontal_rad, beam.vertical_rad)),
                        "No lidar beam is so wide: degrees may stand where radians belong. (The pixels of a flash are "
                        "beams of their own.)",
                        "Give the full width of one beam in rad."});
  }
}

void fieldOfView(const SensorProfile& sensor, std::vector<Finding>& findings) {
  constexpr double kMuchWider = 10.0;
  for (const Side& side : sides(sensor)) {
    if (side.view_rad == 0.0 || side.beam_rad == 0.0) continue;
    const std::string pointer = fmt::format("/receiver/field_of_view_rad/{}", side.name);
    if (side.view_rad < side.beam_rad) {
      findings.push_back({Severity::kWarning, pointer,
                          fmt::format("is {:.3g} rad, the beam {:.3g} rad.", side.view_rad, side.beam_rad),
                          "The receiver does not see all that the emitter lights; aperture-offset takes that away.",
                          "Make it at least as wide as emitter/divergence_rad."});
    } else if (side.view_rad > kMuchWider * side.beam_rad) {
      findings.push_back({Severity::kNote, pointer,
                          fmt::format("is {:.2g} times as wide as the beam.", side.view_rad / side.beam_rad),
                          "It lets in background light and foreign pulses from where no echo can come.",
                          "Nothing to do if the sensor is so."});
    }
  }
}

void overlap(const SensorProfile& sensor, std::vector<Finding>& findings) {
  const Side side = sides(sensor)[0];
  const double beside_m = std::abs(sensor.receiver.axis_offset_m) - sensor.receiver.aperture_diameter_m / 2.0;
  if (beside_m <= 0.0 || side.view_rad == 0.0) return;
  // The spot (radius r φ/2) meets the view (radius D/2 + r Ψ/2) first, then lies in it (aperture_offset.cpp).
  const double meets_m = beside_m / (0.5 * (side.view_rad + side.beam_rad));
  const double near_m = sensor.detection.min_range_m;
  if (meets_m <= near_m && side.view_rad > side.beam_rad &&
      beside_m / (0.5 * (side.view_rad - side.beam_rad)) <= near_m)
    return;
  const std::string whole =
      side.view_rad > side.beam_rad
          ? fmt::format("wholly from {:.3g} m on", beside_m / (0.5 * (side.view_rad - side.beam_rad)))
          : std::string("never wholly");
  findings.push_back(
      {Severity::kNote, "/receiver/axis_offset_m",
       fmt::format("the receiver sees the beam from {:.3g} m on, {}; min_range_m is {:g} m.", meets_m, whole, near_m),
       "With aperture-offset on, near echoes are weak or missing.", "Nothing to do if the sensor is so."});
}

void noise(const SensorProfile& sensor, std::vector<Finding>& findings) {
  constexpr double kManyFalseAlarms = 1e-3;
  const Receiver& receiver = sensor.receiver;
  if (receiver.noise_w == 0.0) {
    findings.push_back({Severity::kNote, "/receiver/noise_w", "is 0.",
                        "Every echo above the threshold is detected in every frame, and intensity does not scatter.",
                        "Give the standard deviation of the noise at the input."});
    return;
  }
  const double ratio = receiver.threshold_w / receiver.noise_w;
  const double false_alarms = falseAlarmsPerBeam(sensor);
  if (ratio <= 1.0) {
    findings.push_back(
        {Severity::kError, "/receiver/threshold_w",
         fmt::format("is {:.3g} W, not above the noise of {:.3g} W.", receiver.threshold_w, receiver.noise_w),
         "Such a receiver reports noise.", "Set it to five to ten times noise_w."});
  } else if (false_alarms > kManyFalseAlarms) {
    const double beams = beamCount(sensor.scan);
    findings.push_back(
        {Severity::kWarning, "/receiver/threshold_w",
         fmt::format("is {:.2g} times the noise: {:.2g} noise crossings a beam are to be expected, {:.2g} a frame.",
                     ratio, false_alarms, beams * false_alarms),
         "The chain itself draws none: simulated point clouds would be cleaner than real ones.",
         fmt::format("Raise it, or switch on false-alarm with rate_per_beam {:.2g}.", std::min(false_alarms, 0.1))});
  }
}

void saturation(const SensorProfile& sensor, std::vector<Finding>& findings) {
  const std::optional<double>& saturation_w = sensor.receiver.saturation_w;
  if (!saturation_w) return;
  if (*saturation_w <= sensor.receiver.threshold_w) {
    findings.push_back(
        {Severity::kError, "/receiver/saturation_w",
         fmt::format("is {:.3g} W, not above the threshold of {:.3g} W.", *saturation_w, sensor.receiver.threshold_w),
         "With saturation on, nothing would ever be detected.", "Give the power at which it clips."});
    return;
  }
  const double from_m = rangeOfPower_m(sensor, {.reflectivity = 0.1}, *saturation_w);
  if (from_m > 0.25 * sensor.detection.max_range_m) {
    findings.push_back({Severity::kWarning, "/receiver/saturation_w",
                        fmt::format("is reached by a target of 10 % already at {:.3g} m.", from_m),
                        "With saturation on, most echoes are clipped: intensity says little.",
                        "Check it against peak_power_w and the aperture."});
  }
}

void reach(const SensorProfile& sensor, std::vector<Finding>& findings) {
  const double window_m = sensor.detection.max_range_m;
  const double dark_m = rangeOfPower_m(sensor, {.reflectivity = 0.1}, sensor.receiver.threshold_w);
  const double bright_m = rangeOfPower_m(sensor, {.reflectivity = 0.8}, sensor.receiver.threshold_w);
  if (bright_m <= sensor.detection.min_range_m) {
    findings.push_back({Severity::kError, "/receiver/threshold_w",
                        fmt::format("a target of 80 % is seen up to {:.2g} m, but min_range_m is {:g} m.", bright_m,
                                    sensor.detection.min_range_m),
                        "The sensor never detects a diffuse target.",
                        "Check units: powers in W, aperture in m; an efficiency of 0 receives nothing."});
  } else if (bright_m < 0.5 * window_m) {
    findings.push_back({Severity::kWarning, "/detection/max_range_m",
                        fmt::format("is {:g} m, but a target of 80 % is seen up to {:.3g} m only.", window_m, bright_m),
                        "Nothing but retroreflectors is ever reported from the rest of the window.",
                        "Lower it, or check peak_power_w, aperture_diameter_m and threshold_w."});
  } else if (dark_m > 3.0 * window_m) {
    findings.push_back(
        {Severity::kNote, "/receiver/threshold_w",
         fmt::format("would show a target of 10 % at {:.3g} m; the window ends at {:g} m.", dark_m, window_m),
         "Detection is decided by the window, not by power: effects that weaken echoes hardly show.",
         "Raise it if the real sensor loses dark targets earlier."});
  }
}

void pulse(const SensorProfile& sensor, std::vector<Finding>& findings) {
  const double length_m = pulseLength_m(sensor);
  const double separation_m = sensor.detection.echo_separation_m;
  if (sensor.emitter.pulse_fwhm_ns < 0.05 || sensor.emitter.pulse_fwhm_ns > 100.0) {
    findings.push_back({Severity::kWarning, "/emitter/pulse_fwhm_ns",
                        fmt::format("is {:g} ns, {:.3g} m of range.", sensor.emitter.pulse_fwhm_ns, length_m),
                        "Pulsed lidars have 0.5 ns to 20 ns.", "Give the full width at half maximum in ns."});
  }
  if (sensor.detection.max_echoes < 2) return;
  if (separation_m < length_m) {
    findings.push_back({Severity::kNote, "/detection/echo_separation_m",
                        fmt::format("is {:g} m, shorter than the pulse ({:.2g} m).", separation_m, length_m),
                        "Two surfaces nearer than the pulse make one stretch of signal anyway.",
                        "Nothing to do; two echoes are at least a pulse apart."});
  } else if (separation_m > 10.0 * length_m) {
    findings.push_back({Severity::kNote, "/detection/echo_separation_m",
                        fmt::format("is {:g} m, {:.2g} pulse lengths.", separation_m, separation_m / length_m),
                        "Surfaces that the signal shows apart are reported as one wide echo.",
                        "Nothing to do if the sensor is so."});
  }
}

void steps(const SensorProfile& sensor, std::vector<Finding>& findings) {
  const DetectionStage& stage = sensor.detection;
  if (stage.range_resolution_m > pulseLength_m(sensor)) {
    findings.push_back(
        {Severity::kWarning, "/detection/range_resolution_m",
         fmt::format("is {:g} m, longer than the pulse ({:.2g} m).", stage.range_resolution_m, pulseLength_m(sensor)),
         "The output is coarser than the echo that it describes.", "Give the step of the output in m."});
  }
  const double rounding_m = stage.range_resolution_m / std::sqrt(12.0);
  if (stage.range_noise_m < rounding_m || stage.range_noise_m == 0.0) {
    findings.push_back(
        {Severity::kNote, "/detection/range_noise_m",
         fmt::format("is {:g} m, below what rounding makes ({:.2g} m).", stage.range_noise_m, rounding_m),
         "A distribution of ranges has one or two steps: its scatter says little.",
         "Nothing to do if the sensor is so."});
  }
}

}  // namespace model::checks
