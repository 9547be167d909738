#include "metrics/points/point_wasserstein.h"

#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "metrics/distributions/edf.h"
#include "metrics/distributions/level_walk.h"
#include "metrics/distributions/summation.h"
#include "metrics/points/transport.h"

namespace metrics {

namespace {

void mustBeAnOrder(double order) {
  if (std::isfinite(order) && order >= 1.0) return;
  throw core::InputError({.item = "order of the Wasserstein distance"},
                         fmt::format("is {}; it must be finite and at least 1.", order),
                         "Take 1 (mean way to carry) or 2 (dearer the farther).");
}

void mustBeFew(std::size_t n, const char* side) {
  if (n <= kMostPointsOfExactWasserstein) return;
  throw core::InputError(
      {.item = fmt::format("{} points", side)},
      fmt::format("are {}; the exact Wasserstein distance takes at most {}.", n, kMostPointsOfExactWasserstein),
      "Take the sliced Wasserstein distance, or gate the point cloud to one object.");
}

Position uniformDirection(core::Random& random) {
  for (;;) {
    const Position u{random.normal(), random.normal(), random.normal()};
    const double length = std::hypot(u.x_m, u.y_m, u.z_m);
    if (length > 1e-6) return {u.x_m / length, u.y_m / length, u.z_m / length};
  }
}

Edf projected(std::span<const Position> cloud, const Position& u) {
  std::vector<double> along;
  along.reserve(cloud.size());
  for (const Position& p : cloud) along.push_back(p.x_m * u.x_m + p.y_m * u.y_m + p.z_m * u.z_m);
  return Edf(std::move(along));
}

/// W_p^p on a line: the optimal plan there keeps the order.
double powerOnLine(const Edf& simulated, const Edf& measured, double order) {
  Summation sum;
  eachCommonLevel<2>({&simulated, &measured}, [&](const CommonLevel<2>& at) {
    sum.add(at.width() * std::pow(std::abs(at.quantiles[0] - at.quantiles[1]), order));
  });
  return sum.value();
}

}  // namespace

double pointWassersteinDistance(const CloudPair& clouds, double order) {
  mustBeAnOrder(order);
  mustBeFew(clouds.simulated.size(), "simulated");
  mustBeFew(clouds.measured.size(), "measured");
  mustHavePoints(clouds);
  const auto n = static_cast<std::int64_t>(clouds.simulated.size());
  const auto m = static_cast<std::int64_t>(clouds.measured.size());
  const CostTable costs(clouds.simulated.size(), clouds.measured.size(), [&](std::size_t i, std::size_t j) {
    return std::pow(distance(clouds.simulated[i], clouds.measured[j]), order);
  });
  // Each point holds lcm(n, m) / (its side's number) units: whole numbers, so that the plan is exact.
  const std::int64_t units = std::lcm(n, m);
  const auto plan = cheapestTransport(costs, std::vector<std::int64_t>(clouds.simulated.size(), units / n),
                                      std::vector<std::int64_t>(clouds.measured.size(), units / m));
  Summation sum;
  for (const Shipment& part : plan) sum.add(static_cast<double>(part.units) * costs(part.row, part.column));
  return std::pow(sum.value() / static_cast<double>(units), 1.0 / order);
}

double slicedWassersteinDistance(const CloudPair& clouds, double order, const Slices& slices) {
  mustBeAnOrder(order);
  mustHavePoints(clouds);
  if (slices.lines == 0) {
    throw core::InputError({.item = "lines of the sliced Wasserstein distance"}, "are none.", "Take about 100.");
  }
  std::vector<double> powers(slices.lines);
  core::parallelFor(slices.lines, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      core::Random random({.seed = slices.seed,
                           .sample = static_cast<std::uint32_t>(k),
                           .purpose = core::purposeOf("sliced_wasserstein")});
      const Position u = uniformDirection(random);
      powers[k] = powerOnLine(projected(clouds.simulated, u), projected(clouds.measured, u), order);
    }
  });
  Summation sum;
  for (const double power : powers) sum.add(power);
  return std::pow(sum.value() / static_cast<double>(slices.lines), 1.0 / order);
}

}  // namespace metrics
