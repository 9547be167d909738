#include "bench/withheld/generator/footprint.h"

#include <array>
#include <cmath>

namespace withheld {

namespace {

double radicalInverse(int base, int index) {
  double value = 0.0, place = 1.0;
  for (; index > 0; index /= base) {
    place /= base;
    value += place * (index % base);
  }
  return value;
}

double normalBelow(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

constexpr double kEdge = 3.0;  // 1.5 a in standard deviations: exp(-2 x²/a²) has the deviation a/2

// Quantiles of the normal distribution cut off at ±3 standard deviations, by bisection.
std::array<double, 4097> cutNormalQuantiles() {
  std::array<double, 4097> table{};
  const double below = normalBelow(-kEdge), inside = 1.0 - 2.0 * below;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double wanted = below + inside * static_cast<double>(i) / (table.size() - 1.0);
    double low = -kEdge, high = kEdge;
    for (int step = 0; step < 50; ++step) {
      const double middle = 0.5 * (low + high);
      (normalBelow(middle) < wanted ? low : high) = middle;
    }
    table[i] = low;
  }
  return table;
}

double cutNormal(double probability) {
  static const auto table = cutNormalQuantiles();
  const double place = probability * (static_cast<double>(table.size()) - 1.0);
  const auto i = std::min(static_cast<std::size_t>(place), table.size() - 2);
  return table[i] + (place - static_cast<double>(i)) * (table[i + 1] - table[i]);
}

}  // namespace

Offset Footprint::at(int index) const {
  const double u = std::fmod(radicalInverse(2, index) + turn_u_, 1.0);
  const double v = std::fmod(radicalInverse(3, index) + turn_v_, 1.0);
  if (!profile_.gaussian_beam) return {(u - 0.5) * profile_.divergence_h_rad, (v - 0.5) * profile_.divergence_v_rad};
  return {cutNormal(u) * profile_.divergence_h_rad / 4, cutNormal(v) * profile_.divergence_v_rad / 4};
}

Offset Footprint::corner(int index) const {
  const double reach = profile_.gaussian_beam ? 0.75 : 0.5;
  return {(index & 1 ? reach : -reach) * profile_.divergence_h_rad,
          (index & 2 ? reach : -reach) * profile_.divergence_v_rad};
}

}  // namespace withheld
