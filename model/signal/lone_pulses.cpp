#include "model/signal/lone_pulses.h"

#include <algorithm>
#include <cmath>

#include "core/bulk_math.h"
#include "core/multiversion.h"
#include "core/physics.h"
#include "model/sensor/saturation_knee.h"

namespace model {

namespace {

/// The noise, and the output that it leaves to the signal to exceed.
FIDELIS_FOR_EVERY_PROCESSOR void outputsOf(std::size_t count, double threshold_w,
                                           const double* __restrict noise_stddev_w, const float* __restrict noise,
                                           double* __restrict noise_w, double* __restrict output_w) {
  const double most_w = kLargestNoise * threshold_w;
  for (std::size_t i = 0; i < count; ++i) {
    const double drawn_w = noise_stddev_w[i] * static_cast<double>(noise[i]);
    noise_w[i] = drawn_w < most_w ? drawn_w : most_w;
    output_w[i] = threshold_w - noise_w[i];
  }
}

/// The same, as received powers.
void levelsOf(std::size_t count, const Receiver& receiver, const double* noise_stddev_w, const float* noise,
              double* noise_w, double* level_w) {
  outputsOf(count, receiver.threshold_w, noise_stddev_w, noise, noise_w, level_w);
  if (!receiver.knee_sharpness) return;
  for (std::size_t i = 0; i < count; ++i) level_w[i] = receivedFor_w(level_w[i], receiver);
}

/// Power over the level that it must exceed, and the noisy peak.
FIDELIS_FOR_EVERY_PROCESSOR void ratiosOf(std::size_t count, const double* __restrict level_w,
                                          const double* __restrict power_w, const double* __restrict gain,
                                          const double* __restrict noise_w, double* __restrict ratio,
                                          double* __restrict peak_w, double* __restrict log_argument) {
  for (std::size_t i = 0; i < count; ++i) {
    peak_w[i] = gain[i] * power_w[i];
    ratio[i] = peak_w[i] / level_w[i];
    peak_w[i] += noise_w[i];
    log_argument[i] = ratio[i] > 1.0 ? ratio[i] : 1.0;
  }
}

FIDELIS_FOR_EVERY_PROCESSOR void widthsOf(std::size_t count, double width_m, double edge, const double* __restrict log,
                                          const double* __restrict pulse_range_m, double* __restrict range_m,
                                          double* __restrict epw_m) {
  for (std::size_t i = 0; i < count; ++i) {
    const double half_m = 0.5 * width_m * std::sqrt(log[i]);
    range_m[i] = pulse_range_m[i] - edge * half_m;
    epw_m[i] = 4.0 * half_m;
  }
}

FIDELIS_FOR_EVERY_PROCESSOR void toSteps(std::size_t count, double step, double* __restrict values) {
  for (std::size_t i = 0; i < count; ++i) values[i] = std::floor(values[i] / step + 0.5) * step;
}

FIDELIS_FOR_EVERY_PROCESSOR void blurred(std::size_t count, double scale, double offset, double stddev,
                                         const float* __restrict noise, double* __restrict values) {
  for (std::size_t i = 0; i < count; ++i)
    values[i] = scale * values[i] + offset + stddev * static_cast<double>(noise[i]);
}

FIDELIS_FOR_EVERY_PROCESSOR void scale(std::size_t count, double factor, double* __restrict values) {
  for (std::size_t i = 0; i < count; ++i) values[i] *= factor;
}

/// Full width at half maximum on the one-way axis.
double widthOf_m(const ChainSettings& settings) {
  return core::kMetresPerNanosecond * settings.emitter.pulse_fwhm_ns / 2.0;
}

double edgeOf(const ChainSettings& settings) {
  return settings.detection.range_mode == RangeMode::kLeadingEdge ? 1.0 : 0.0;
}

}  // namespace

double toStep(double value, double step) { return step > 0.0 ? std::floor(value / step + 0.5) * step : value; }

std::optional<Echo> loneEcho(const Pulse& pulse, const Receiver& receiver, const ChainSettings& settings, double gain,
                             const ShotNoise& noise) {
  double level_w = 0.0, ratio = 0.0, log = 0.0;
  Echo echo;
  levelsOf(1, receiver, &receiver.noise_w, &noise.power, &echo.noise_w, &level_w);
  ratiosOf(1, &level_w, &pulse.power_w, &gain, &echo.noise_w, &ratio, &echo.peak_w, &log);
  if (!(ratio > 1.0)) return std::nullopt;
  core::log2Of(std::span(&log, 1), std::span(&log, 1));
  widthsOf(1, widthOf_m(settings), edgeOf(settings), &log, &pulse.range_m, &echo.range_m, &echo.epw_m);
  echo.epw_per_width_m = echo.epw_m;
  return echo;
}

void LonePulses::fire(const ChainSettings& settings, const core::Random::Key& frame, const std::vector<double>& gain) {
  const std::size_t count = size();
  for (auto* column : {&power_noise_w_, &level_w_, &ratio_, &log_, &range_m_, &epw_m_, &peak_w_}) column->resize(count);
  for (auto& column : noise_) column.resize(count);
  core::normalsOf(frame, beam_, 0, {noise_[0], noise_[1], noise_[2], noise_[3]});
  levelsOf(count, settings.receiver, noise_w_.data(), noise_[0].data(), power_noise_w_.data(), level_w_.data());
  ratiosOf(count, level_w_.data(), power_w_.data(), gain.data(), power_noise_w_.data(), ratio_.data(), peak_w_.data(),
           log_.data());
  core::log2Of(log_, log_);
  widthsOf(count, widthOf_m(settings), edgeOf(settings), log_.data(), pulse_range_m_.data(), range_m_.data(),
           epw_m_.data());
}

void LonePulses::blur(const ChainSettings& settings) {
  const DetectionStage& stage = settings.detection;
  blurred(size(), settings.range_scale, settings.range_offset_m, stage.range_noise_m, noise_[1].data(),
          range_m_.data());
  blurred(size(), 1.0, 0.0, stage.epw_noise_m, noise_[2].data(), epw_m_.data());
}

void blur(Echo& echo, const ChainSettings& settings, const ShotNoise& noise) {
  const DetectionStage& stage = settings.detection;
  blurred(1, settings.range_scale, settings.range_offset_m, stage.range_noise_m, &noise.range, &echo.range_m);
  blurred(1, 1.0, 0.0, stage.epw_noise_m, &noise.epw, &echo.epw_m);
}

void LonePulses::roundTo(double range_m, double epw_m, double intensity_nw) {
  if (range_m > 0.0) toSteps(size(), range_m, range_m_.data());
  if (epw_m > 0.0) toSteps(size(), epw_m, epw_m_.data());
  if (intensity_nw > 0.0) toSteps(size(), intensity_nw, peak_w_.data());
}

void LonePulses::count(const ChainSettings& settings) {
  const DetectionStage& stage = settings.detection;
  const CounterSteps& counters = settings.counters;
  scale(size(), kWattToNanowatt, peak_w_.data());
  if (std::isfinite(counters.intensity_full_scale_nw))
    for (double& peak_nw : peak_w_) peak_nw = std::min(peak_nw, counters.intensity_full_scale_nw);
  roundTo(counters.range_m, counters.epw_m, counters.intensity_nw);
  roundTo(stage.range_resolution_m, stage.epw_resolution_m, stage.intensity_resolution_nw);
  for (double& epw_m : epw_m_) epw_m = epw_m > 0.0 ? epw_m : 0.0;
  for (double& peak_w : peak_w_) peak_w /= kWattToNanowatt;
}

}  // namespace model
