#include "model/signal/waveform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/bulk_math.h"
#include "core/multiversion.h"

namespace model {

namespace {

constexpr double kFourLn2 = 4.0 * std::numbers::ln2;
constexpr double kSamplesPerWidth = 10.0;
constexpr double kSamplesPerMeasuredWidth = 16.0;  // its corners are no curve that a polynomial follows
constexpr int kLanes = 8;
/// Of the lowest level, down to which a pulse's tail is followed: cut earlier, its missing slope moves a neighbour's
/// peak.
constexpr double kTail = 0.01;
constexpr double kLogOfNothing = -700.0;
/// No edge moves by more than so many widths per relative width: where the level touches a summit that overlapping
/// pulses make, the derivative knows no bound, and the sensor a last echo.
constexpr double kMostPerWidth = 2.0;
constexpr double kBinsPerWidth = 100.0;  // merging pulses within a bin changes the variance by less than 1e-5

double totalOf(std::span<const Pulse> pulses) {
  return std::accumulate(pulses.begin(), pulses.end(), 0.0,
                         [](double sum_w, const Pulse& pulse) { return sum_w + pulse.power_w; });
}

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
    bool of_surface = false;
    for (; i < pulses.size() && pulses[i].range_m - first_m < bin_m; ++i) {
      power += pulses[i].power_w;
      moment += pulses[i].power_w * (pulses[i].range_m - first_m);
      of_surface = of_surface || pulses[i].of_surface;
    }
    if (power > 0.0) pulses[kept++] = {first_m + moment / power, power, of_surface};
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

/// Whether anything between a pulse and the next one may be above the lowest level: at most what the pulses up to the
/// one make at its place, and those from the other on at its own. exp(-a (x + y)²) is at most exp(-a x²) exp(-a y²), so
/// a pulse may hand on what it was handed. (A fog's tail is long and silent.)
std::vector<bool> audibleBetween(std::span<const Pulse> pulses, const PulseForm& form, double lowest_level_w) {
  const double a = kFourLn2 / (form.fwhm_m * form.fwhm_m);
  std::vector<double> handed_on(pulses.size() - 1), from_here_w(pulses.size());
  for (std::size_t i = 0; i < handed_on.size(); ++i) {
    const double apart_m = pulses[i + 1].range_m - pulses[i].range_m;
    handed_on[i] = -a * apart_m * apart_m;
  }
  core::expOf(handed_on, handed_on);
  from_here_w.back() = pulses.back().power_w;
  for (std::size_t i = handed_on.size(); i-- > 0;)
    from_here_w[i] = pulses[i].power_w + handed_on[i] * from_here_w[i + 1];
  std::vector<bool> audible;
  double up_to_here_w = 0.0;
  for (std::size_t i = 0; i < handed_on.size(); ++i) {
    up_to_here_w += pulses[i].power_w;
    audible.push_back(up_to_here_w + from_here_w[i + 1] > lowest_level_w);
    up_to_here_w *= handed_on[i];
  }
  return audible;
}

/// Of pulses that follow each other closely, the stretches in which they may be heard, each with the pulses that reach
/// into it.
std::vector<PartOfPulses> audibleParts(std::span<const Pulse> pulses, const PulseForm& form, double lowest_level_w) {
  const double total_w = totalOf(pulses);
  if (total_w <= lowest_level_w) return {};
  const double reach_m = reachOf(total_w, lowest_level_w, form);
  const double tail_m = reachOf(total_w, kTail * lowest_level_w, form);
  const double front_m = pulses.front().range_m - reach_m, back_m = pulses.back().range_m + reach_m;
  if (pulses.size() == 1 || !form.shape.isGaussian()) return {{pulses, front_m, back_m, tail_m}};
  const std::vector<bool> audible = audibleBetween(pulses, form, lowest_level_w);
  const auto rangeAt = [&](auto gap) { return pulses[static_cast<std::size_t>(gap - audible.begin())].range_m; };
  std::vector<PartOfPulses> parts;
  for (auto first = std::find(audible.begin(), audible.end(), true); first != audible.end();) {
    const auto last = std::find(first, audible.end(), false);
    const double from_m = first == audible.begin() ? front_m : rangeAt(first);
    const double to_m = last == audible.end() ? back_m : rangeAt(last);
    const auto begin = std::partition_point(pulses.begin(), pulses.end(),
                                            [&](const Pulse& pulse) { return pulse.range_m < from_m - tail_m; });
    const auto end =
        std::partition_point(begin, pulses.end(), [&](const Pulse& pulse) { return pulse.range_m <= to_m + tail_m; });
    parts.push_back({{begin, end}, from_m, to_m, tail_m});
    first = std::find(last, audible.end(), true);
  }
  return parts;
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

WaveformPart::WaveformPart(const PartOfPulses& part, const PulseForm& form, double lowest_level_w)
    : form_(form), tail_m_(part.tail_m), lowest_level_w_(lowest_level_w) {
  const auto of_surface = [](const Pulse& pulse) { return pulse.of_surface; };
  of_surface_ = std::any_of(part.pulses.begin(), part.pulses.end(), of_surface);
  if (part.pulses.size() == 1) {
    lone_ = part.pulses.front();
    highest_w_ = lone_.power_w;
    return;
  }
  step_m_ = form.fwhm_m / (form.shape.isGaussian() ? kSamplesPerWidth : kSamplesPerMeasuredWidth);
  start_m_ = part.from_m - 2.0 * step_m_;
  const auto samples = static_cast<std::size_t>((part.to_m - start_m_) / step_m_ + 2.0) + 2;
  signal_.resize(samples, 0.0);
  log_.resize(samples, std::numeric_limits<double>::quiet_NaN());
  if (of_surface_ && !std::all_of(part.pulses.begin(), part.pulses.end(), of_surface)) {
    std::copy_if(part.pulses.begin(), part.pulses.end(), std::back_inserter(among_others_), of_surface);
  }
  add(part.pulses);
  runsAbove(lowest_level_w_, signal_, 0, signal_.size(),
            [&](std::size_t begin, std::size_t end) { audible_.emplace_back(begin, end); });
  findHighest();
}

/// The sampled maximum lies below the true one by at most the parabola's vertex; makes it exact.
void WaveformPart::findHighest() {
  const std::size_t top = highestSample();
  highest_w_ = stretchAt(top, top + 1, 0.0).peak_w;
}

WaveformPart WaveformPart::withSurfacesAt(double gain) const {
  WaveformPart changed = *this;
  std::vector<Pulse> surplus = among_others_;
  for (Pulse& pulse : surplus) pulse.power_w *= gain - 1.0;
  changed.add(surplus);
  std::fill(changed.log_.begin(), changed.log_.end(), std::numeric_limits<double>::quiet_NaN());
  changed.summit_ = {};
  changed.findHighest();
  return changed;
}

void WaveformPart::add(std::span<const Pulse> pulses) {
  if (form_.shape.isGaussian()) {
    addGaussians(pulses, tail_m_);
  } else {
    addMeasured(pulses);
  }
}

std::size_t WaveformPart::highestSample() const {
  return static_cast<std::size_t>(std::max_element(signal_.begin(), signal_.end()) - signal_.begin());
}

double WaveformPart::logAt(std::size_t sample) const {
  double& log = log_[sample];
  if (std::isnan(log)) log = signal_[sample] > 0.0 ? std::log(signal_[sample]) : kLogOfNothing;
  return log;
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
    if (begin >= end) continue;
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

/// How much ln s gains per relative width of all pulses, by its slope and bend per step. Of s = Σ P_i exp(-a (r -
/// r_i)²) with a = 4 ln 2 / w² it is w ∂s/∂w / s = Σ P_i 2a (r - r_i)² exp(…) / s = 1 + s''/(2a s), whatever the P_i
/// and r_i are.
double WaveformPart::logPerWidth(double slope, double bend) const {
  const double a = kFourLn2 / (form_.fwhm_m * form_.fwhm_m);
  return 1.0 + (bend + slope * slope) / (2.0 * a * step_m_ * step_m_);
}

/// Where log s crosses the level between two samples, by the cubic through these and the next one on either side. The
/// cubic is taken as its chord and what it is above that (Newton's form), and the crossing found as a fixed point.
WaveformPart::Crossing WaveformPart::crossing(std::size_t below, std::size_t above, double log_level) const {
  const double y0 = logAt(below), y1 = logAt(above);
  const bool forwards = above > below;
  const std::size_t beyond = forwards ? above + 1 : above - 1, before = forwards ? below - 1 : below + 1;
  double t = (log_level - y0) / (y1 - y0), second = 0.0, third = 0.0;
  // y(t) = y0 + t (y1 - y0) + t (t - 1) (second + third (t - 2)), t = -1, 0, 1, 2 at the four samples.
  const auto bendAt = [&](double at) { return second + third * (at - 2.0); };
  const auto slopeAt = [&](double at) { return y1 - y0 + (2.0 * at - 1.0) * bendAt(at) + at * (at - 1.0) * third; };
  if (beyond < signal_.size() && before < signal_.size()) {  // an index before the first one wraps
    const double y2 = logAt(beyond), y_1 = logAt(before);
    second = 0.5 * (y2 - 2.0 * y1 + y0);
    third = y_1 > kLogOfNothing ? (y2 - 3.0 * y1 + 3.0 * y0 - y_1) / 6.0 : 0.0;
    for (int i = 0; i < 4; ++i) {
      const double slope = slopeAt(t);
      if (slope <= 0.0) break;
      t -= (y0 + t * (y1 - y0) + t * (t - 1.0) * bendAt(t) - log_level) / slope;
    }
    t = std::clamp(t, 0.0, 1.0);
  }
  const double direction = forwards ? 1.0 : -1.0;
  const double slope = slopeAt(t);
  const double gains = logPerWidth(slope, 2.0 * (bendAt(t) + (2.0 * t - 1.0) * third));
  const double most_m = kMostPerWidth * form_.fwhm_m;
  return {start_m_ + (static_cast<double>(below) + direction * t) * step_m_,
          slope > 0.0 ? std::clamp(-direction * gains / slope * step_m_, -most_m, most_m) : 0.0};
}

/// How far from a sample that is higher than its neighbours log s is highest, in steps, and how high: by the quartic
/// through five samples, by Newton's method from the vertex of the parabola through three.
WaveformPart::Summit WaveformPart::summitAt(std::size_t top) const {
  const double height = logAt(top);
  const auto summit = [&](double steps, double log, double per_width) {
    return Summit{top, steps, log, std::exp(log), per_width};
  };
  if (top == 0 || top + 1 >= signal_.size()) return summit(0.0, height, 0.0);
  const double left = logAt(top - 1), right = logAt(top + 1);
  // y(t) = height + slope t + curve t² + third t³ + fourth t⁴
  double slope = 0.5 * (right - left), curve = 0.5 * (left - 2.0 * height + right), third = 0.0, fourth = 0.0;
  if (curve >= 0.0) return summit(0.0, height, 0.0);
  double t = std::clamp(-0.5 * slope / curve, -0.5, 0.5);
  if (top >= 2 && top + 2 < signal_.size()) {
    const double far_left = logAt(top - 2), far_right = logAt(top + 2);
    third = (far_right - far_left - 2.0 * (right - left)) / 12.0;
    fourth = (far_right + far_left - 4.0 * (right + left) + 6.0 * height) / 24.0;
    slope -= third;
    curve -= fourth;
    for (int i = 0; i < 3; ++i) {
      const double bend = 2.0 * curve + t * (6.0 * third + 12.0 * fourth * t);
      if (bend >= 0.0) break;
      t = std::clamp(t - (slope + t * (2.0 * curve + t * (3.0 * third + 4.0 * fourth * t))) / bend, -1.0, 1.0);
    }
  }
  const double bend = 2.0 * curve + t * (6.0 * third + 12.0 * fourth * t);
  return summit(t, height + t * (slope + t * (curve + t * (third + t * fourth))), logPerWidth(0.0, bend));
}

const WaveformPart::Summit& WaveformPart::knownSummitAt(std::size_t top) const {
  if (summit_.top != top) summit_ = summitAt(top);
  return summit_;
}

/// The highest of the samples [begin, end), and where they cross the level; with a level of zero, crossings are left
/// at zero.
Stretch WaveformPart::stretchAt(std::size_t begin, std::size_t end, double level_w) const {
  std::size_t top = begin;
  for (std::size_t i = begin; i < end; ++i) {
    if (signal_[i] > signal_[top]) top = i;
  }
  const Summit& summit = knownSummitAt(top);
  Stretch stretch;
  stretch.peak_m = start_m_ + (static_cast<double>(top) + summit.steps) * step_m_;
  stretch.peak_w = summit.power_w;
  stretch.peak_per_width = summit.power_per_width;
  if (level_w > 0.0) {
    const double log_level = std::log(level_w);
    const Crossing rise = begin > 0 ? crossing(begin - 1, begin, log_level) : Crossing{.at_m = start_m_};
    const Crossing fall = end < signal_.size() ? crossing(end, end - 1, log_level)
                                               : Crossing{.at_m = start_m_ + static_cast<double>(end - 1) * step_m_};
    stretch.rise_m = rise.at_m;
    stretch.rise_per_width_m = rise.per_width_m;
    stretch.fall_m = fall.at_m;
    stretch.fall_per_width_m = fall.per_width_m;
  }
  if (!form_.shape.isGaussian()) {  // as a lone pulse
    stretch.rise_per_width_m = stretch.rise_m - stretch.peak_m;
    stretch.fall_per_width_m = stretch.fall_m - stretch.peak_m;
    stretch.peak_per_width = 0.0;
  }
  return stretch;
}

void WaveformPart::stretchesAbove(double level_w, std::vector<Stretch>& out) const {
  if (highest_w_ <= level_w) return;
  if (lone_.power_w > 0.0) {
    const auto crossings = form_.shape.crossings(level_w / lone_.power_w);
    if (!crossings) return;
    const double rise_m = form_.fwhm_m * crossings->rise, fall_m = form_.fwhm_m * crossings->fall;
    out.push_back({.rise_m = lone_.range_m + rise_m,
                   .fall_m = lone_.range_m + fall_m,
                   .peak_m = lone_.range_m,
                   .peak_w = lone_.power_w,
                   .rise_per_width_m = rise_m,
                   .fall_per_width_m = fall_m});
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
  tip.rise_per_width_m = -half;
  tip.fall_per_width_m = half;
  out.push_back(tip);
}

std::vector<WaveformPart> partsOf(std::vector<Pulse>& pulses, const PulseForm& form, double lowest_level_w) {
  std::vector<WaveformPart> parts;
  mergeNearPulses(pulses, form.fwhm_m / kBinsPerWidth);
  const double total_w = totalOf(pulses);
  if (total_w <= lowest_level_w) return parts;
  const double gap_m = 2.0 * reachOf(total_w, lowest_level_w, form);
  for (std::size_t begin = 0; begin < pulses.size();) {
    std::size_t end = begin + 1;
    while (end < pulses.size() && pulses[end].range_m - pulses[end - 1].range_m <= gap_m) ++end;
    const std::span<const Pulse> group = std::span<const Pulse>(pulses).subspan(begin, end - begin);
    for (const PartOfPulses& of_group : audibleParts(group, form, lowest_level_w)) {
      WaveformPart part(of_group, form, lowest_level_w);
      if (part.peak_w() > lowest_level_w) parts.push_back(std::move(part));
    }
    begin = end;
  }
  return parts;
}

}  // namespace model
