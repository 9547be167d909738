#include "model/signal/waveform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace model {

namespace {

constexpr double kFourLn2 = 4.0 * std::numbers::ln2;
constexpr double kSamplesPerWidth = 16.0;
constexpr double kBinsPerWidth = 100.0;  // merging pulses within a bin changes the variance by less than 1e-5

/// How far from its peak one pulse that holds all the power is above `level_w`: nothing reaches farther.
double reachOf(double power_w, double level_w, const PulseForm& form) {
  if (power_w <= level_w) return 0.0;
  if (form.shape.isGaussian()) return form.fwhm_m / 2.0 * std::sqrt(std::log2(power_w / level_w));
  const auto crossings = form.shape.crossings(level_w / power_w);
  return crossings ? form.fwhm_m * std::max(-crossings->rise, crossings->fall) : 0.0;
}

void mergeNearPulses(std::vector<Pulse>& pulses, double bin_m) {
  std::sort(pulses.begin(), pulses.end(), [](const Pulse& a, const Pulse& b) { return a.range_m < b.range_m; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pulses.size();) {
    const double first_m = pulses[i].range_m;
    double power = 0.0, moment = 0.0;
    for (; i < pulses.size() && pulses[i].range_m - first_m < bin_m; ++i) {
      power += pulses[i].power_w;
      moment += pulses[i].power_w * (pulses[i].range_m - first_m);
    }
    if (power > 0.0) pulses[kept++] = {first_m + moment / power, power};
  }
  pulses.resize(kept);
}

}  // namespace

WaveformPart::WaveformPart(std::span<const Pulse> pulses, const PulseForm& form, double lowest_level_w)
    : form_(form), lowest_level_w_(lowest_level_w) {
  if (pulses.size() == 1) {
    lone_ = pulses.front();
    highest_w_ = lone_.power_w;
    return;
  }
  double total_w = 0.0;
  for (const Pulse& pulse : pulses) total_w += pulse.power_w;
  step_m_ = form.fwhm_m / kSamplesPerWidth;
  const double reach = reachOf(total_w, lowest_level_w, form) + 2.0 * step_m_;
  start_m_ = pulses.front().range_m - reach;
  const auto samples = static_cast<std::size_t>((pulses.back().range_m + reach - start_m_) / step_m_) + 2;
  std::vector<double> signal(samples, 0.0);
  if (form.shape.isGaussian()) {
    // A tail is followed down to a hundredth of the lowest level: cut earlier, its missing slope moves a neighbour's
    // peak.
    addGaussians(pulses, reachOf(total_w, 0.01 * lowest_level_w, form), signal);
  } else {
    addMeasured(pulses, signal);
  }
  log_signal_.resize(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    log_signal_[i] = signal[i] > 0.0 ? std::log(signal[i]) : -700.0;
    highest_w_ = std::max(highest_w_, signal[i]);
  }
  // The sampled maximum lies below the true one by at most the parabola's vertex; make it exact.
  const auto top =
      static_cast<std::size_t>(std::max_element(log_signal_.begin(), log_signal_.end()) - log_signal_.begin());
  highest_w_ = stretchAt(top, top + 1, 0.0).peak_w;
}

void WaveformPart::addGaussians(std::span<const Pulse> pulses, double cut_m, std::vector<double>& signal) const {
  // exp(-a (x + d)^2) = exp(-a x^2) · exp(-a d (2x + d)): two multiplications a sample, outwards from the pulse's
  // centre.
  const double a = kFourLn2 / (form_.fwhm_m * form_.fwhm_m);
  const double second = std::exp(-2.0 * a * step_m_ * step_m_);
  const auto cut = static_cast<std::size_t>(cut_m / step_m_) + 2;
  for (const Pulse& pulse : pulses) {
    const auto centre = static_cast<std::size_t>((pulse.range_m - start_m_) / step_m_);
    for (const int direction : {1, -1}) {
      const double x0 = start_m_ + static_cast<double>(centre) * step_m_ - pulse.range_m;
      double value = pulse.power_w * std::exp(-a * x0 * x0);
      double factor = std::exp(-a * step_m_ * (2.0 * direction * x0 + step_m_));
      std::size_t index = centre;
      for (std::size_t n = 0; n <= cut; ++n) {
        if (n > 0 || direction > 0) signal[index] += value;
        value *= factor;
        factor *= second;
        if (direction < 0 && index == 0) break;
        index += static_cast<std::size_t>(direction);
        if (index >= signal.size()) break;
      }
    }
  }
}

void WaveformPart::addMeasured(std::span<const Pulse> pulses, std::vector<double>& signal) const {
  for (const Pulse& pulse : pulses) {
    for (std::size_t i = 0; i < signal.size(); ++i) {
      const double x_m = start_m_ + static_cast<double>(i) * step_m_ - pulse.range_m;
      signal[i] += pulse.power_w * form_.shape.at(x_m / form_.fwhm_m);
    }
  }
}

/// Where the parabola through `below`, `above` and the next sample beyond `above` crosses the level.
double WaveformPart::crossing(std::size_t below, std::size_t above, double log_level) const {
  const double y0 = log_signal_[below], y1 = log_signal_[above];
  const double linear = (log_level - y0) / (y1 - y0);
  const std::size_t beyond = above > below ? above + 1 : above - 1;  // wraps to a huge index at 0
  double t = linear;
  if (beyond < log_signal_.size()) {
    // y(t) = y0 + b t + c t², t = 0 at `below`, 1 at `above`, 2 beyond.
    const double c = (log_signal_[beyond] - 2.0 * y1 + y0) / 2.0;
    const double b = y1 - y0 - c;
    for (int i = 0; i < 4; ++i) {
      const double slope = b + 2.0 * c * t;
      if (slope <= 0.0) break;
      t -= (y0 + b * t + c * t * t - log_level) / slope;
    }
    t = std::clamp(t, 0.0, 1.0);
  }
  const double direction = above > below ? 1.0 : -1.0;
  return start_m_ + (static_cast<double>(below) + direction * t) * step_m_;
}

/// Peak of the samples [begin, end), with the vertex of the parabola of log s; crossings are left at zero.
Stretch WaveformPart::stretchAt(std::size_t begin, std::size_t end, double level_w) const {
  std::size_t top = begin;
  for (std::size_t i = begin; i < end; ++i) {
    if (log_signal_[i] > log_signal_[top]) top = i;
  }
  Stretch stretch;
  double shift = 0.0, height = log_signal_[top];
  if (top > 0 && top + 1 < log_signal_.size()) {
    const double left = log_signal_[top - 1], right = log_signal_[top + 1];
    const double curvature = left - 2.0 * height + right;
    if (curvature < 0.0) {
      shift = std::clamp(0.5 * (left - right) / curvature, -0.5, 0.5);
      height -= 0.25 * (left - right) * shift;
    }
  }
  stretch.peak_m = start_m_ + (static_cast<double>(top) + shift) * step_m_;
  stretch.peak_w = std::exp(height);
  if (level_w > 0.0) {
    const double log_level = std::log(level_w);
    stretch.rise_m = begin > 0 ? crossing(begin - 1, begin, log_level) : start_m_;
    stretch.fall_m = end < log_signal_.size() ? crossing(end, end - 1, log_level)
                                              : start_m_ + static_cast<double>(end - 1) * step_m_;
  }
  return stretch;
}

void WaveformPart::stretchesAbove(double level_w, std::vector<Stretch>& out) const {
  if (highest_w_ <= level_w) return;
  if (lone_.power_w > 0.0) {
    const auto crossings = form_.shape.crossings(level_w / lone_.power_w);
    if (!crossings) return;
    out.push_back({lone_.range_m + form_.fwhm_m * crossings->rise, lone_.range_m + form_.fwhm_m * crossings->fall,
                   lone_.range_m, lone_.power_w});
    return;
  }
  const double log_level = std::log(level_w);
  std::size_t i = 0;
  const std::size_t before = out.size();
  while (i < log_signal_.size()) {
    while (i < log_signal_.size() && log_signal_[i] <= log_level) ++i;
    const std::size_t begin = i;
    while (i < log_signal_.size() && log_signal_[i] > log_level) ++i;
    if (i > begin) out.push_back(stretchAt(begin, i, level_w));
  }
  if (out.size() > before) return;
  // The level lies between the highest sample and the true peak: a stretch narrower than a sample step.
  const auto top =
      static_cast<std::size_t>(std::max_element(log_signal_.begin(), log_signal_.end()) - log_signal_.begin());
  Stretch tip = stretchAt(top, top + 1, 0.0);
  const double curvature = 2.0 * log_signal_[top] - log_signal_[top - 1] - log_signal_[top + 1];
  const double half = step_m_ * std::sqrt(2.0 * std::max(0.0, std::log(tip.peak_w) - log_level) / curvature);
  tip.rise_m = tip.peak_m - half;
  tip.fall_m = tip.peak_m + half;
  out.push_back(tip);
}

std::vector<WaveformPart> partsOf(std::vector<Pulse>& pulses, const PulseForm& form, double lowest_level_w) {
  std::vector<WaveformPart> parts;
  mergeNearPulses(pulses, form.fwhm_m / kBinsPerWidth);
  double total_w = 0.0;
  for (const Pulse& pulse : pulses) total_w += pulse.power_w;
  if (total_w <= lowest_level_w) return parts;
  const double gap = 2.0 * reachOf(total_w, lowest_level_w, form);
  for (std::size_t begin = 0; begin < pulses.size();) {
    std::size_t end = begin + 1;
    double part_w = pulses[begin].power_w;
    while (end < pulses.size() && pulses[end].range_m - pulses[end - 1].range_m <= gap) part_w += pulses[end++].power_w;
    if (part_w > lowest_level_w) {
      const std::span<const Pulse> all(pulses);
      WaveformPart part(all.subspan(begin, end - begin), form, lowest_level_w);
      if (part.peak_w() > lowest_level_w) parts.push_back(std::move(part));
    }
    begin = end;
  }
  return parts;
}

}  // namespace model
