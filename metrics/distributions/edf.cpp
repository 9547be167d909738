#include "metrics/distributions/edf.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <string>

#include "core/error.h"
#include "metrics/distributions/sorting.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

void mustBeFinite(std::span<const double> numbers, const char* what) {
  const auto bad = std::find_if(numbers.begin(), numbers.end(), [](double x) { return !std::isfinite(x); });
  if (bad == numbers.end()) return;
  throw core::InputError({.item = fmt::format("{} {}", what, bad - numbers.begin() + 1)},
                         fmt::format("is {}; a distribution needs finite numbers.", *bad),
                         "Remove or correct it; nothing is dropped silently.");
}

void mustMatch(std::size_t values, std::size_t others, const char* what) {
  if (values == others) return;
  throw core::InputError({}, fmt::format("{} values have {} {}.", values, others, what), "Give one for each value.");
}

[[noreturn]] void throwEmpty() {
  throw core::InputError({}, "has no values; a distribution needs at least one.", "Check the gate or the file.");
}

bool ascendAndDiffer(std::span<const double> values) {
  const auto falls = [](double a, double b) { return !(a < b); };  // also if one is not a number
  return std::adjacent_find(values.begin(), values.end(), falls) == values.end();
}

/// Where a zero may be: at one place if the values ascend and differ.
std::span<double> zerosOf(std::vector<double>& values, bool ascend_and_differ) {
  if (!ascend_and_differ) return values;
  const auto [first, last] = std::equal_range(values.begin(), values.end(), 0.0);
  return {first, last};
}

/// Leaves one of each value. Returns the levels that the last of its kind reaches.
std::vector<double> mergeTies(std::vector<double>& ascending) {
  const auto n = static_cast<double>(ascending.size());
  std::vector<double> levels;
  std::size_t steps = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    if (i + 1 < ascending.size() && ascending[i] == ascending[i + 1]) continue;
    ascending[steps++] = ascending[i];
    levels.push_back(static_cast<double>(i + 1) / n);
  }
  ascending.resize(steps);
  return levels;
}

}  // namespace

Edf::Edf(std::vector<double> values, std::vector<double> levels, std::size_t n, double effective_n)
    : steps_(std::make_shared<const Steps>(std::move(values), std::move(levels))), n_(n), effective_n_(effective_n) {}

Edf::Edf(std::vector<double> values) : n_(values.size()), effective_n_(static_cast<double>(n_)) {
  if (values.empty()) throwEmpty();
  bool distinct = ascendAndDiffer(values);
  if (!distinct || !std::isfinite(values.front()) || !std::isfinite(values.back())) mustBeFinite(values, "value");
  for (double& x : zerosOf(values, distinct)) x += 0.0;  // -0 and 0 are one value
  if (!distinct) {
    sortAscending(values);
    distinct = ascendAndDiffer(values);
  }
  std::vector<double> levels = distinct ? std::vector<double>{} : mergeTies(values);
  steps_ = std::make_shared<const Steps>(std::move(values), std::move(levels));
}

std::span<const double> Edf::equalLevels() const {
  std::call_once(steps_->asked, [this] {
    std::vector<double> levels(steps_->values.size());
    for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = level(i);
    steps_->levels = std::move(levels);
  });
  return steps_->levels;
}

Edf Edf::weighted(std::span<const double> values, std::span<const double> weights) {
  mustMatch(values.size(), weights.size(), "weights");
  mustBeFinite(values, "value");
  mustBeFinite(weights, "weight");
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] < 0.0) {
      throw core::InputError({.item = fmt::format("weight {}", i + 1)},
                             fmt::format("is {}; weights must not be negative.", weights[i]), "Correct the weight.");
    }
    if (weights[i] > 0.0) order.push_back(i);
  }
  if (order.empty()) throwEmpty();
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });

  Summation total;
  Summation squares;
  for (const std::size_t i : order) {
    total.add(weights[i]);
    squares.add(weights[i] * weights[i]);
  }
  EdfBuilder builder;
  Summation sum;
  for (const std::size_t i : order) {
    sum.add(weights[i]);
    builder.step(values[i] + 0.0, i == order.back() ? 1.0 : std::min(1.0, sum.value() / total.value()));
  }
  return std::move(builder).build(order.size(), total.value() * total.value() / squares.value());
}

Edf Edf::repeated(std::span<const double> ascending, std::span<const std::uint32_t> counts) {
  mustMatch(ascending.size(), counts.size(), "counts");
  const auto n = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (n == 0) throwEmpty();
  const auto whole = static_cast<double>(n);
  std::vector<double> values(ascending.size() + 1);
  std::vector<double> levels(ascending.size() + 1);
  std::size_t steps = 0;
  std::size_t reached = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {  // without a branch: a count of 0 is overwritten by the next
    reached += counts[i];
    values[steps] = ascending[i];
    levels[steps] = static_cast<double>(reached) / whole;
    steps += counts[i] > 0 ? 1 : 0;
  }
  values.resize(steps);
  levels.resize(steps);
  return {std::move(values), std::move(levels), n, whole};
}

Edf Edf::fromSteps(std::span<const double> values, std::span<const double> levels) {
  mustMatch(values.size(), levels.size(), "levels");
  if (values.empty()) throwEmpty();
  mustBeFinite(values, "value");
  mustBeFinite(levels, "level");
  if (!std::is_sorted(values.begin(), values.end()) || !std::is_sorted(levels.begin(), levels.end()) ||
      levels.front() < 0.0 || levels.back() != 1.0) {
    throw core::InputError({}, "is no distribution function: values must ascend and levels rise from 0 to 1.",
                           "Sort the table by value; give cumulative shares that end at 1.");
  }
  EdfBuilder builder;
  for (std::size_t i = 0; i < values.size(); ++i) builder.step(values[i] + 0.0, levels[i]);
  return std::move(builder).build();
}

double Edf::cdf(double x) const noexcept {
  const auto above = std::upper_bound(values().begin(), values().end(), x) - values().begin();
  return above == 0 ? 0.0 : level(static_cast<std::size_t>(above) - 1);
}

/// The first step whose level is not below p; their number if there is none.
std::size_t Edf::stepReaching(double p) const noexcept {
  const std::size_t steps = values().size();
  if (!steps_->equal) {
    const std::vector<double>& levels = steps_->levels;
    return static_cast<std::size_t>(std::lower_bound(levels.begin(), levels.end(), p) - levels.begin());
  }
  if (!(p > 0.0)) return 0;
  if (p > 1.0) return steps;
  auto i = static_cast<std::size_t>(p * static_cast<double>(steps));  // rounding leaves it a step beside, at most
  while (i > 0 && level(i - 1) >= p) --i;
  while (level(i) < p) ++i;
  return i;
}

double Edf::quantile(double p) const noexcept { return values()[std::min(stepReaching(p), values().size() - 1)]; }

/// int_0^1 term(quantile(p)) dp
template <typename Term>
double Edf::meanOf(Term term) const noexcept {
  const std::span<const double> x = values();
  if (steps_->equal) {
    return blockSums<1>(x.size(), [=](std::size_t i) { return std::array{term(x[i])}; })[0] /
           static_cast<double>(x.size());
  }
  const std::vector<double>& p = steps_->levels;
  const auto later =
      blockSums<1>(x.size() - 1, [&](std::size_t i) { return std::array{term(x[i + 1]) * (p[i + 1] - p[i])}; });
  return term(x[0]) * p[0] + later[0];
}

double Edf::mean() const noexcept {
  // Relative to the smallest value, so that a small spread far from zero keeps its digits.
  return min() + meanOf([this](double x) { return x - min(); });
}

double Edf::median() const noexcept {
  const std::size_t i = stepReaching(0.5);
  return level(i) == 0.5 ? std::midpoint(values()[i], values()[i + 1]) : values()[i];
}

double Edf::standardDeviation() const noexcept {
  if (n_ < 2) return std::numeric_limits<double>::quiet_NaN();
  const double variance = meanOf([centre = mean()](double x) { return (x - centre) * (x - centre); });
  return std::sqrt(variance * effective_n_ / (effective_n_ - 1.0));
}

Edf Edf::shifted(double offset) const {
  std::vector<double> moved(values().size());
  std::transform(values().begin(), values().end(), moved.begin(), [offset](double x) { return x + offset; });
  if (ascendAndDiffer(moved)) {
    return {std::move(moved), steps_->equal ? std::vector<double>{} : steps_->levels, n_, effective_n_};
  }
  EdfBuilder builder;  // two values were rounded to one
  for (std::size_t i = 0; i < moved.size(); ++i) builder.step(moved[i], level(i));
  return std::move(builder).build(n_, effective_n_);
}

bool Edf::operator==(const Edf& other) const {
  if (steps_ == other.steps_) return true;
  if (steps_->values != other.steps_->values) return false;
  return (steps_->equal && other.steps_->equal) || std::ranges::equal(levels(), other.levels());
}

void EdfBuilder::reserve(std::size_t steps) {
  values_.reserve(steps);
  levels_.reserve(steps);
}

void EdfBuilder::step(double value, double level) {
  const double reached = levels_.empty() ? 0.0 : levels_.back();
  assert(level >= reached && (values_.empty() || value >= values_.back()));
  if (level == reached) return;
  if (!values_.empty() && values_.back() == value) {
    levels_.back() = level;
    return;
  }
  values_.push_back(value);
  levels_.push_back(level);
}

Edf EdfBuilder::build(std::size_t n, double effective_n) && {
  assert(!levels_.empty() && levels_.back() == 1.0);
  return {std::move(values_), std::move(levels_), n, effective_n};
}

Edf EdfBuilder::fromSteps(std::vector<double> values, std::vector<double> levels) {
  assert(ascendAndDiffer(values) && (levels.empty() ? !values.empty() : levels.back() == 1.0));
  return {std::move(values), std::move(levels)};
}

}  // namespace metrics
