#include "metrics/distributions/p_box.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <vector>

#include "core/error.h"
#include "metrics/distributions/level_walk.h"

namespace metrics {

namespace {

/// The function whose quantile at every level is chosen from those of a and b.
template <typename Choose>
Edf combined(const Edf& a, const Edf& b, Choose choose) {
  if (stepTogether(a, b)) {  // rank by rank; as the values of a and of b differ, so do the chosen ones
    std::vector<double> chosen(a.values().size());
    std::transform(a.values().begin(), a.values().end(), b.values().begin(), chosen.begin(), choose);
    return EdfBuilder::fromSteps(std::move(chosen));
  }
  std::vector<double> values(a.values().size() + b.values().size());  // at most
  std::vector<double> levels(values.size());
  std::size_t steps = 0;
  double last = std::numeric_limits<double>::quiet_NaN();  // differs from every value
  eachCommonLevel<2>({&a, &b}, [&](const CommonLevel<2>& at) {
    const double value = choose(at.quantiles[0], at.quantiles[1]);
    steps += static_cast<std::size_t>(value != last);  // without a branch: at the same value the step grows
    values[steps - 1] = value;
    levels[steps - 1] = at.level;
    last = value;
  });
  values.resize(steps);
  levels.resize(steps);
  return EdfBuilder::fromSteps(std::move(values), std::move(levels));
}

/// Folds pairs, pairs of pairs, …: n log k steps where one after the other would take n k. Minimum and maximum do
/// not round, so the order cannot change the result.
template <typename Choose>
Edf folded(std::span<const Edf> runs, Choose choose) {
  if (runs.size() == 1) return runs.front();
  if (runs.size() == 2) return combined(runs[0], runs[1], choose);
  const std::size_t half = runs.size() / 2;
  return combined(folded(runs.first(half), choose), folded(runs.subspan(half), choose), choose);
}

}  // namespace

PBox::PBox(Edf edf) : left_(std::move(edf)) {}

PBox::PBox(Edf left, std::optional<Edf> right) : left_(std::move(left)), right_(std::move(right)) {}

PBox PBox::envelope(std::span<const Edf> runs) {
  if (runs.empty()) {
    throw core::InputError({}, "no run to make a p-box of.", "Give at least one simulated sample.");
  }
  if (runs.size() == 1) return PBox(runs.front());
  // The largest CDF has the smallest quantiles, and the left-continuous inverse makes both views identical.
  return {folded(runs, [](double a, double b) { return std::min(a, b); }),
          folded(runs, [](double a, double b) { return std::max(a, b); })};
}

PBox PBox::fromEdges(Edf left, Edf right) {
  eachCommonLevel<2>({&left, &right}, [](const CommonLevel<2>& at) {
    if (at.quantiles[0] <= at.quantiles[1]) return;
    throw core::InputError({.item = fmt::format("level {}", at.level)},
                           fmt::format("the left edge of the p-box, {}, lies right of its right edge, {}.",
                                       at.quantiles[0], at.quantiles[1]),
                           "Exchange the edges, or take the envelope of both.");
  });
  return {std::move(left), std::move(right)};
}

PBox PBox::fromInterval(double low, double high) { return fromEdges(Edf({low}), Edf({high})); }

double PBox::area() const {
  if (!right_) return 0.0;
  return levelIntegrals<1>(left_, *right_, [](double left, double right) { return std::array{right - left}; })[0];
}

PBox PBox::shifted(double offset) const {
  return {left_.shifted(offset), right_ ? std::optional(right_->shifted(offset)) : std::nullopt};
}

}  // namespace metrics
