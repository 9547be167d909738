#include "objects/box_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace objects {

namespace {

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double size() const { return high - low; }
  [[nodiscard]] double middle() const { return (low + high) / 2; }
  [[nodiscard]] double toNearerEnd(double value) const { return std::min(value - low, high - value); }
};

/// Points along a direction and across it, and the rectangle that encloses them.
struct Turned {
  std::vector<double> along, across;
  Interval along_range, across_range;

  Turned(std::span<const Vector3> points, std::span<const std::size_t> of, double angle_rad) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    along.reserve(of.size());
    across.reserve(of.size());
    for (const std::size_t i : of) {
      along.push_back(c * points[i][0] + s * points[i][1]);
      across.push_back(-s * points[i][0] + c * points[i][1]);
      along_range.include(along.back());
      across_range.include(across.back());
    }
  }
};

double closeness(const Turned& turned, double closest_m) {
  double sum = 0.0;
  for (std::size_t i = 0; i < turned.along.size(); ++i) {
    const double d =
        std::min(turned.along_range.toNearerEnd(turned.along[i]), turned.across_range.toNearerEnd(turned.across[i]));
    sum += 1.0 / std::max(d, closest_m);
  }
  return sum;
}

class Variance {
 public:
  void add(double value) {
    ++n_;
    const double step = value - mean_;
    mean_ += step / n_;
    sum_ += step * (value - mean_);
  }
  [[nodiscard]] double value() const { return n_ > 0.0 ? sum_ / n_ : 0.0; }

 private:
  double n_ = 0.0, mean_ = 0.0, sum_ = 0.0;
};

double straightness(const Turned& turned) {
  Variance first, second;
  for (std::size_t i = 0; i < turned.along.size(); ++i) {
    const double d1 = turned.along_range.toNearerEnd(turned.along[i]);
    const double d2 = turned.across_range.toNearerEnd(turned.across[i]);
    d1 < d2 ? first.add(d1) : second.add(d2);
  }
  return -first.value() - second.value();
}

double score(const Turned& turned, const BoxFit& options) {
  switch (options.criterion) {
    case FitCriterion::kArea:
      return -turned.along_range.size() * turned.across_range.size();
    case FitCriterion::kCloseness:
      return closeness(turned, options.closest_m);
    case FitCriterion::kVariance:
      return straightness(turned);
  }
  return 0.0;
}

/// The best of `steps` directions from `from` on; of neighbours that share the largest score, the middle. They may lie
/// outside the stretch that was searched: directions repeat after a right angle.
double bestDirection(std::span<const Vector3> points, std::span<const std::size_t> of, const BoxFit& options,
                     double from_rad, double step_rad, int steps) {
  const auto at = [&](int i) { return score(Turned(points, of, from_rad + i * step_rad), options); };
  double best = at(0);
  int first = 0;
  for (int i = 1; i < steps; ++i) {
    const double value = at(i);
    if (value > best + 1e-12 * std::abs(best)) {
      best = value;
      first = i;
    }
  }
  int last = first;
  const auto as_good = [&](int i) { return std::abs(at(i) - best) <= 1e-12 * std::abs(best); };
  while (last - first < steps && as_good(first - 1)) --first;
  while (last - first < steps && as_good(last + 1)) ++last;
  return from_rad + step_rad * (first + last) / 2.0;
}

}  // namespace

Box fitBox(std::span<const Vector3> points, std::span<const std::size_t> of, const BoxFit& options) {
  constexpr double kRightAngle = std::numbers::pi / 2;
  constexpr int kFiner = 20;
  const int steps = std::max(1, static_cast<int>(std::ceil(kRightAngle / options.step_rad - 1e-9)));
  const double step = kRightAngle / steps;
  const double coarse = bestDirection(points, of, options, 0.0, step, steps);
  const double yaw = bestDirection(points, of, options, coarse - step, step / kFiner, 2 * kFiner + 1);
  const Turned turned(points, of, yaw);
  Interval heights;
  for (const std::size_t i : of) heights.include(points[i][2]);
  Box box{.centre_m = {0.0, 0.0, heights.middle()},
          .length_m = turned.along_range.size(),
          .width_m = turned.across_range.size(),
          .height_m = heights.size(),
          .yaw_rad = yaw};
  const double along = turned.along_range.middle(), across = turned.across_range.middle();
  box.centre_m[0] = std::cos(yaw) * along - std::sin(yaw) * across;
  box.centre_m[1] = std::sin(yaw) * along + std::cos(yaw) * across;
  return withLongerSideAhead(box);
}

}  // namespace objects
