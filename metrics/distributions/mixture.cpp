#include "metrics/distributions/mixture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <vector>

#include "core/error.h"

namespace metrics {

namespace {

void mustBeWeights(std::size_t parts, std::span<const double> weights) {
  if (parts != weights.size()) {
    throw core::InputError({}, fmt::format("{} parts of a mixture have {} weights.", parts, weights.size()),
                           "Give one for each part.");
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (std::isfinite(weights[i]) && weights[i] >= 0.0) continue;
    throw core::InputError({.item = fmt::format("weight {}", i + 1)},
                           fmt::format("is {}; weights are finite and not negative.", weights[i]),
                           "Correct the weight.");
  }
  if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0.0; })) {
    throw core::InputError({}, "a mixture needs at least one part of positive weight.", "Check the weights.");
  }
}

/// Sum of terms that change one at a time. Always added in the same pairs, so that it never falls when a term rises:
/// rounding cannot make a distribution function fall, nor the edges of a box cross.
class RunningSum {
 public:
  explicit RunningSum(std::size_t terms) : leaves_(std::bit_ceil(terms)), nodes_(2 * leaves_, 0.0) {}

  void set(std::size_t term, double value) {
    nodes_[leaves_ + term] = value;
    for (std::size_t k = (leaves_ + term) / 2; k > 0; k /= 2) nodes_[k] = nodes_[2 * k] + nodes_[2 * k + 1];
  }
  [[nodiscard]] double value() const { return nodes_[1]; }

 private:
  std::size_t leaves_;
  std::vector<double> nodes_;  // nodes_[1] is the root, children of k are 2 k and 2 k + 1
};

struct Step {
  double value;
  double level;
  std::size_t part;
};

std::vector<Step> pooledSteps(std::span<const Edf* const> parts, std::span<const double> weights) {
  std::vector<Step> steps;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (weights[part] == 0.0) continue;
    const Edf& edf = *parts[part];
    for (std::size_t i = 0; i < edf.values().size(); ++i) {
      steps.push_back({.value = edf.values()[i], .level = edf.level(i), .part = part});
    }
  }
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.value < b.value; });
  return steps;
}

Edf mixtureOf(std::span<const Edf* const> parts, std::span<const double> weights) {
  // Scaled by a power of two, which does not round, so that the sum cannot overflow.
  const int scale = -std::ilogb(*std::max_element(weights.begin(), weights.end()));
  const auto weighted = [&](std::size_t part, double level) { return std::ldexp(weights[part], scale) * level; };

  RunningSum total(parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part) total.set(part, weighted(part, 1.0));

  const std::vector<Step> steps = pooledSteps(parts, weights);
  RunningSum height(parts.size());
  EdfBuilder builder;
  builder.reserve(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    height.set(steps[i].part, weighted(steps[i].part, steps[i].level));
    const bool last_of_value = i + 1 == steps.size() || steps[i + 1].value != steps[i].value;
    if (last_of_value) builder.step(steps[i].value, height.value() / total.value());
  }
  return std::move(builder).build();
}

}  // namespace

Edf mixture(std::span<const Edf> parts, std::span<const double> weights) {
  mustBeWeights(parts.size(), weights);
  std::vector<const Edf*> edfs;
  for (const Edf& part : parts) edfs.push_back(&part);
  return mixtureOf(edfs, weights);
}

PBox mixture(std::span<const PBox> parts, std::span<const double> weights) {
  mustBeWeights(parts.size(), weights);
  std::vector<const Edf*> left;
  std::vector<const Edf*> right;
  bool single = true;
  for (const PBox& part : parts) {
    left.push_back(&part.left());
    right.push_back(&part.right());
    single = single && part.isSingleDistribution();
  }
  if (single) return mixtureOf(left, weights);
  return PBox::fromEdges(mixtureOf(left, weights), mixtureOf(right, weights));
}

}  // namespace metrics
