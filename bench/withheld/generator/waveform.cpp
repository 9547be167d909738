#include "bench/withheld/generator/waveform.h"

#include <algorithm>
#include <cmath>

#include "bench/withheld/generator/vec.h"

namespace withheld {

namespace {

constexpr double kLn16 = 2.772588722239781;  // 4 ln 2: exp(-kLn16 t²/w²) has the full width w at half maximum
constexpr double kReach = 3.0;               // pulse widths to either side: 2^-36 of the peak

// Adds one flank, from the sample `k` outwards; `away_ns` is that sample's distance from the peak. Each next value
// follows from the one before: exp(-a(x+h)²) = exp(-ax²) exp(-a(2xh+h²)), and that factor falls geometrically.
void addFlank(std::vector<double>& samples, std::ptrdiff_t k, int way, double away_ns, double power_w, double width_ns,
              double step_ns, double reach_ns) {
  const double a = kLn16 / (width_ns * width_ns);
  double value = power_w * std::exp(-a * away_ns * away_ns);
  double factor = std::exp(-a * (2.0 * away_ns * step_ns + step_ns * step_ns));
  const double change = std::exp(-2.0 * a * step_ns * step_ns);
  for (double x = away_ns; x < reach_ns && k >= 0 && k < std::ssize(samples); x += step_ns, k += way) {
    samples[static_cast<std::size_t>(k)] += value;
    value *= factor;
    factor *= change;
  }
}

// Arrivals within one step become one at their mean time: what is lost is a step²/12 of variance.
std::vector<Arrival> gathered(std::vector<Arrival> arrivals, double step_m) {
  std::sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) { return a.range_m < b.range_m; });
  std::vector<Arrival> result;
  double start = -1e300;
  for (const Arrival& arrival : arrivals) {
    if (arrival.range_m - start > step_m) {
      result.push_back({arrival.range_m, 0.0, arrival.source});
      start = arrival.range_m;
    }
    Arrival& sum = result.back();
    const double power = sum.power_w + arrival.power_w;
    if (power > 0.0) sum.range_m += (arrival.range_m - sum.range_m) * arrival.power_w / power;
    sum.power_w = power;
  }
  return result;
}

double cubic(const double* y, double x) {
  const double a = y[0], b = y[1], c = y[2], d = y[3];  // at -1, 0, 1, 2
  return -a * x * (x - 1) * (x - 2) / 6 + b * (x + 1) * (x - 1) * (x - 2) / 2 - c * (x + 1) * x * (x - 2) / 2 +
         d * (x + 1) * x * (x - 1) / 6;
}

}  // namespace

double Pulse::riseFrom(double ratio) const {
  return ratio <= 1.0 ? 0.0 : 0.5 * riseWidth_ns() * std::sqrt(std::log2(ratio));
}

double Pulse::widthAt(double ratio) const { return ratio <= 1.0 ? 0.0 : fwhm_ns * std::sqrt(std::log2(ratio)); }

Waveform::Waveform(std::vector<Arrival> arrivals, const Pulse& pulse, double tail_ns) : step_ns_(pulse.fwhm_ns / 60.0) {
  const double reach = kReach * std::max(pulse.riseWidth_ns(), pulse.fallWidth_ns());
  arrivals = gathered(std::move(arrivals), 0.5 * kLight_m_ns * step_ns_);
  for (std::size_t first = 0; first < arrivals.size();) {
    const auto time = [&](std::size_t i) { return 2.0 * arrivals[i].range_m / kLight_m_ns; };
    std::size_t last = first;
    while (last + 1 < arrivals.size() && time(last + 1) - time(last) < 2.0 * reach + tail_ns) ++last;
    Piece piece;
    piece.start_ns = time(first) - reach;
    piece.power_w.assign(static_cast<std::size_t>((time(last) + reach + tail_ns - piece.start_ns) / step_ns_) + 2, 0.0);
    for (std::size_t i = first; i <= last; ++i) {
      const double place = (time(i) - piece.start_ns) / step_ns_;
      const auto before = static_cast<std::ptrdiff_t>(place);
      const double to_before = (place - static_cast<double>(before)) * step_ns_, power = arrivals[i].power_w;
      addFlank(piece.power_w, before, -1, to_before, power, pulse.riseWidth_ns(), step_ns_, reach);
      addFlank(piece.power_w, before + 1, +1, step_ns_ - to_before, power, pulse.fallWidth_ns(), step_ns_, reach);
    }
    pieces_.push_back(std::move(piece));
    first = last + 1;
  }
}

void Waveform::saturate(double level_w, double recovery_ns) {
  const double keep = recovery_ns > 0.0 ? std::exp(-step_ns_ / recovery_ns) : 0.0;
  double tail = 0.0;
  for (Piece& piece : pieces_) {
    for (double& power : piece.power_w) {
      const double ratio = power / level_w, clipped = power / std::pow(1.0 + std::pow(ratio, 4.0), 0.25);
      tail = ratio >= 1.0 ? clipped : tail * keep;
      power = std::max(clipped, tail);
    }
    tail = 0.0;
  }
}

// The time between two samples at which the level is passed.
double Waveform::crossing(const Piece& piece, std::size_t before, double level_w) const {
  const std::vector<double>& y = piece.power_w;
  double low = 0.0, high = 1.0;
  if (before < 1 || before + 2 >= y.size()) {
    low = (level_w - y[before]) / (y[before + 1] - y[before]);
  } else {
    const bool rising = y[before + 1] > y[before];
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      ((cubic(&y[before - 1], middle) < level_w) == rising ? low : high) = middle;
    }
  }
  return piece.start_ns + (static_cast<double>(before) + low) * step_ns_;
}

Waveform::Stretch Waveform::stretch(const Piece& piece, std::size_t first, std::size_t last, double level_w,
                                    double noise_w) const {
  const std::vector<double>& y = piece.power_w;
  Stretch result;
  result.rise_ns = first == 0 ? piece.start_ns : crossing(piece, first - 1, level_w);
  result.fall_ns =
      last + 1 >= y.size() ? piece.start_ns + static_cast<double>(last) * step_ns_ : crossing(piece, last, level_w);
  const auto top = static_cast<std::size_t>(std::max_element(y.begin() + static_cast<std::ptrdiff_t>(first),
                                                             y.begin() + static_cast<std::ptrdiff_t>(last) + 1) -
                                            y.begin());
  double shift = 0.0, height = y[top];
  if (top > 0 && top + 1 < y.size()) {  // the parabola through three samples
    const double bend = y[top - 1] - 2.0 * y[top] + y[top + 1], slope = 0.5 * (y[top + 1] - y[top - 1]);
    if (bend < 0.0) shift = std::clamp(-slope / bend, -0.5, 0.5), height -= 0.5 * slope * slope / bend;
  }
  result.peak_ns = piece.start_ns + (static_cast<double>(top) + shift) * step_ns_;
  result.peak_w = height + noise_w;
  return result;
}

std::vector<Waveform::Stretch> Waveform::above(const std::function<double(double)>& threshold_w,
                                               const std::function<double(double)>& noise_w) const {
  std::vector<Stretch> found;
  for (const Piece& piece : pieces_) {
    const std::vector<double>& y = piece.power_w;
    const auto thresholdAt = [&](std::size_t k) {
      return threshold_w(0.5 * kLight_m_ns * (piece.start_ns + static_cast<double>(k) * step_ns_));
    };
    for (std::size_t k = 0; k < y.size(); ++k) {
      if (y[k] <= 0.1 * thresholdAt(k)) continue;
      std::size_t end = k, top = k;
      for (; end < y.size() && y[end] > 0.1 * thresholdAt(end); ++end) {
        if (y[end] > y[top]) top = end;
      }
      const double threshold = thresholdAt(top), noise = noise_w(threshold), level = threshold - noise;
      for (std::size_t i = k; i < end; ++i) {
        if (y[i] <= level) continue;
        std::size_t last = i;
        while (last + 1 < end && y[last + 1] > level) ++last;
        found.push_back(stretch(piece, i, last, level, noise));
        i = last;
      }
      k = end;
    }
  }
  return found;
}

}  // namespace withheld
