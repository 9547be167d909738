#include "model/signal/waveform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "core/multiversion.h"

namespace model {

namespace {

constexpr double kFourLn2 = 4.0 * std::numbers::ln2;
constexpr double kSamplesPerWidth = 16.0;
constexpr int kLanes = 8;
constexpr double kBinsPerWidth = 100.0;  // merging pulses within a bin changes the variance by less than 1e-5

/// How far from its peak one pulse that holds all the power is above `level_w`: nothing reaches farther.
double reachOf(double power_w, double level_w, const PulseForm& form) {
  if (power_w <= level_w) return 0.0;
  if (form.shape.isGaussian()) return form.fwhm_m / 2.0 * std::sqrt(std::log2(power_w / level_w));
  const auto crossings = form.shape.crossings(level_w / power_w);
  return crossings ? form.fwhm_m * std::max(-crossings->rise, crossings->fall) : 0.0;
}

/// Pulses mostly come as two runs that are in order: those of surfaces, and behind them those of a fog or a cloud.
void sortByRange(std::vector<Pulse>& pulses) {
  const auto nearer = [](const Pulse& a, const Pulse& b) { return a.range_m < b.range_m; };
  const auto second = std::is_sorted_until(pulses.begin(), pulses.end(), nearer);
  if (std::is_sorted(second, pulses.end(), nearer)) {
    std::inplace_merge(pulses.begin(), second, pulses.end(), nearer);
  } else {
    std::stable_sort(pulses.begin(), pulses.end(), nearer);
  }
}

void mergeNearPulses(std::vector<Pulse>& pulses, double bin_m) {
  sortByRange(pulses);
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

/// Reports every run of samples above a level, [first, end) of `signal`, in order.
template <typename Report>
void runsAbove(double level, const std::vector<double>& signal, std::size_t first, std::size_t end,
               const Report& report) {
  for (std::size_t i = first; i < end;) {
    while (i < end && signal[i] <= level) ++i;
    const std::size_t begin = i;
    while (i < end && signal[i] > level) ++i;
    if (i > begin) report(begin, i);
  }
}

using Lanes = std::array<double, kLanes>;

/// Adds `value` to blocks of kLanes samples, one block after the other, growing by `factor`, and that by `second`.
/// Leaves what is to be added to the next block. (Of loops over eight numbers the compiler makes no vectors.)
FIDELIS_FOR_EVERY_PROCESSOR void addBlocks(double* __restrict sample, std::ptrdiff_t blocks, double second,
                                           const Lanes& factor, Lanes& value) {
  using Four [[gnu::vector_size(4 * sizeof(double))]] = double;
  static_assert(kLanes == 8);
  Four value_a, value_b, factor_a, factor_b, sum_a, sum_b;
  std::memcpy(&value_a, value.data(), sizeof(Four));
  std::memcpy(&value_b, value.data() + 4, sizeof(Four));
  std::memcpy(&factor_a, factor.data(), sizeof(Four));
  std::memcpy(&factor_b, factor.data() + 4, sizeof(Four));
  for (std::ptrdiff_t b = 0; b < blocks; ++b, sample += kLanes) {
    std::memcpy(&sum_a, sample, sizeof(Four));
    std::memcpy(&sum_b, sample + 4, sizeof(Four));
    sum_a += value_a;
    sum_b += value_b;
    std::memcpy(sample, &sum_a, sizeof(Four));
    std::memcpy(sample + 4, &sum_b, sizeof(Four));
    value_a *= factor_a;
    value_b *= factor_b;
    factor_a *= second;
    factor_b *= second;
  }
  std::memcpy(value.data(), &value_a, sizeof(Four));
  std::memcpy(value.data() + 4, &value_b, sizeof(Four));
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
  signal_.resize(samples, 0.0);
  if (form.shape.isGaussian()) {
    // A tail is followed down to a hundredth of the lowest level: cut earlier, its missing slope moves a neighbour's
    // peak.
    addGaussians(pulses, reachOf(total_w, 0.01 * lowest_level_w, form));
  } else {
    addMeasured(pulses);
  }
  runsAbove(lowest_level_w_, signal_, 0, signal_.size(),
            [&](std::size_t begin, std::size_t end) { audible_.emplace_back(begin, end); });
  // The sampled maximum lies below the true one by at most the parabola's vertex; make it exact.
  const std::size_t top = highestSample();
  highest_w_ = stretchAt(top, top + 1, 0.0).peak_w;
}

std::size_t WaveformPart::highestSample() const {
  return static_cast<std::size_t>(std::max_element(signal_.begin(), signal_.end()) - signal_.begin());
}

double WaveformPart::logAt(std::size_t sample) const {
  constexpr double kLogOfNothing = -700.0;
  return signal_[sample] > 0.0 ? std::log(signal_[sample]) : kLogOfNothing;
}

void WaveformPart::addGaussians(std::span<const Pulse> pulses, double cut_m) {
  // exp(-a (x + d)^2) = exp(-a x^2) · exp(-a d (2x + d)): a sample takes two multiplications, and those that stand
  // kLanes apart do not wait for each other.
  const double a = kFourLn2 / (form_.fwhm_m * form_.fwhm_m);
  const double second = std::exp(-2.0 * a * step_m_ * step_m_);
  const double next_lane = std::pow(second, kLanes), second_of_lanes = std::pow(next_lane, kLanes);
  // kLanes steps from the first sample: exp(-a s (2x + s)) for each, and each smaller by `second` than the one before.
  const double between_lanes = std::pow(second, kLanes * (kLanes - 1) / 2);
  const auto samples = static_cast<std::ptrdiff_t>(signal_.size());
  const auto cut = static_cast<std::ptrdiff_t>(cut_m / step_m_) + 2;
  for (const Pulse& pulse : pulses) {
    const auto centre = static_cast<std::ptrdiff_t>((pulse.range_m - start_m_) / step_m_);
    const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(0, centre - cut), end = std::min(samples, centre + cut + 1);
    const double x_m = start_m_ + static_cast<double>(begin) * step_m_ - pulse.range_m;
    Lanes value{pulse.power_w * std::exp(-a * x_m * x_m)};
    double one_step = std::exp(-a * step_m_ * (2.0 * x_m + step_m_));
    const double two_steps = one_step * one_step, four_steps = two_steps * two_steps;
    Lanes factor{four_steps * four_steps * between_lanes};
    for (std::size_t j = 1; j < kLanes; ++j, one_step *= second) {
      value[j] = value[j - 1] * one_step;
      factor[j] = factor[j - 1] * next_lane;
    }
    const std::ptrdiff_t blocks = (end - begin) / kLanes;
    addBlocks(signal_.data() + begin, blocks, second_of_lanes, factor, value);
    for (std::ptrdiff_t i = begin + blocks * kLanes, j = 0; i < end; ++i, ++j)
      signal_[static_cast<std::size_t>(i)] += value[static_cast<std::size_t>(j)];
  }
}

void WaveformPart::addMeasured(std::span<const Pulse> pulses) {
  for (const Pulse& pulse : pulses) {
    for (std::size_t i = 0; i < signal_.size(); ++i) {
      const double x_m = start_m_ + static_cast<double>(i) * step_m_ - pulse.range_m;
      signal_[i] += pulse.power_w * form_.shape.at(x_m / form_.fwhm_m);
    }
  }
}

/// Where the parabola through `below`, `above` and the next sample beyond `above` crosses the level.
double WaveformPart::crossing(std::size_t below, std::size_t above, double log_level) const {
  const double y0 = logAt(below), y1 = logAt(above);
  const double linear = (log_level - y0) / (y1 - y0);
  const std::size_t beyond = above > below ? above + 1 : above - 1;  // wraps to a huge index at 0
  double t = linear;
  if (beyond < signal_.size()) {
    // y(t) = y0 + b t + c t², t = 0 at `below`, 1 at `above`, 2 beyond.
    const double c = (logAt(beyond) - 2.0 * y1 + y0) / 2.0;
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
    if (signal_[i] > signal_[top]) top = i;
  }
  Stretch stretch;
  double shift = 0.0, height = logAt(top);
  if (top > 0 && top + 1 < signal_.size()) {
    const double left = logAt(top - 1), right = logAt(top + 1);
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
    stretch.fall_m =
        end < signal_.size() ? crossing(end, end - 1, log_level) : start_m_ + static_cast<double>(end - 1) * step_m_;
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
  const std::size_t before = out.size();
  for (const auto& [first, last] : audible_) {
    runsAbove(level_w, signal_, first, last,
              [&](std::size_t begin, std::size_t end) { out.push_back(stretchAt(begin, end, level_w)); });
  }
  if (out.size() > before) return;
  // The level lies between the highest sample and the true peak: a stretch narrower than a sample step.
  const std::size_t top = highestSample();
  Stretch tip = stretchAt(top, top + 1, 0.0);
  const double curvature = 2.0 * logAt(top) - logAt(top - 1) - logAt(top + 1);
  const double half = step_m_ * std::sqrt(2.0 * std::max(0.0, std::log(tip.peak_w / level_w)) / curvature);
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
