#include "metrics/distributions/edf.h"

#include <algorithm>
#include <boost/sort/spreadsort/float_sort.hpp>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <string>

#include "core/error.h"
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

}  // namespace

Edf::Edf(std::vector<double> values) : values_(std::move(values)), n_(values_.size()) {
  if (values_.empty()) throwEmpty();
  mustBeFinite(values_, "value");
  for (double& x : values_) x += 0.0;  // -0 and 0 are one value
  boost::sort::spreadsort::float_sort(values_.begin(), values_.end());
  effective_n_ = static_cast<double>(n_);
  levels_.resize(n_);
  std::size_t last = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    if (i > 0 && values_[i] != values_[last]) ++last;
    values_[last] = values_[i];
    levels_[last] = static_cast<double>(i + 1) / effective_n_;  // a tie: the last of the equal values counts
  }
  values_.resize(last + 1);
  levels_.resize(last + 1);
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
  Edf edf = std::move(builder).build();
  edf.n_ = order.size();
  edf.effective_n_ = total.value() * total.value() / squares.value();
  return edf;
}

Edf Edf::repeated(std::span<const double> ascending, std::span<const std::uint32_t> counts) {
  mustMatch(ascending.size(), counts.size(), "counts");
  const auto n = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (n == 0) throwEmpty();
  Edf edf;
  edf.n_ = n;
  edf.effective_n_ = static_cast<double>(n);
  edf.values_.resize(ascending.size() + 1);
  edf.levels_.resize(ascending.size() + 1);
  std::size_t steps = 0;
  std::size_t reached = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {  // without a branch: a count of 0 is overwritten by the next
    reached += counts[i];
    edf.values_[steps] = ascending[i];
    edf.levels_[steps] = static_cast<double>(reached) / edf.effective_n_;
    steps += counts[i] > 0 ? 1 : 0;
  }
  edf.values_.resize(steps);
  edf.levels_.resize(steps);
  return edf;
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
  const auto above = std::upper_bound(values_.begin(), values_.end(), x);
  return above == values_.begin() ? 0.0 : levels_[static_cast<std::size_t>(above - values_.begin()) - 1];
}

double Edf::quantile(double p) const noexcept {
  const auto reached = std::lower_bound(levels_.begin(), levels_.end(), p);
  return reached == levels_.end() ? values_.back() : values_[static_cast<std::size_t>(reached - levels_.begin())];
}

double Edf::mean() const noexcept {
  // Relative to the smallest value, so that a small spread far from zero keeps its digits.
  Summation sum;
  double below = 0.0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    sum.add((values_[i] - values_.front()) * (levels_[i] - below));
    below = levels_[i];
  }
  return values_.front() + sum.value();
}

double Edf::median() const noexcept {
  const auto i = static_cast<std::size_t>(std::lower_bound(levels_.begin(), levels_.end(), 0.5) - levels_.begin());
  return levels_[i] == 0.5 ? std::midpoint(values_[i], values_[i + 1]) : values_[i];
}

double Edf::standardDeviation() const noexcept {
  if (n_ < 2) return std::numeric_limits<double>::quiet_NaN();
  const double centre = mean();
  Summation sum;
  double below = 0.0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    sum.add((values_[i] - centre) * (values_[i] - centre) * (levels_[i] - below));
    below = levels_[i];
  }
  return std::sqrt(sum.value() * effective_n_ / (effective_n_ - 1.0));
}

Edf Edf::shifted(double offset) const {
  EdfBuilder builder;  // two values may round to one
  builder.reserve(values_.size());
  for (std::size_t i = 0; i < values_.size(); ++i) builder.step(values_[i] + offset, levels_[i]);
  Edf edf = std::move(builder).build();
  edf.n_ = n_;
  edf.effective_n_ = effective_n_;
  return edf;
}

void EdfBuilder::reserve(std::size_t steps) {
  edf_.values_.reserve(steps);
  edf_.levels_.reserve(steps);
}

void EdfBuilder::step(double value, double level) {
  const double reached = edf_.levels_.empty() ? 0.0 : edf_.levels_.back();
  assert(level >= reached && (edf_.values_.empty() || value >= edf_.values_.back()));
  if (level == reached) return;
  if (!edf_.values_.empty() && edf_.values_.back() == value) {
    edf_.levels_.back() = level;
    return;
  }
  edf_.values_.push_back(value);
  edf_.levels_.push_back(level);
}

Edf EdfBuilder::build() && {
  assert(!edf_.levels_.empty() && edf_.levels_.back() == 1.0);
  return std::move(edf_);
}

}  // namespace metrics
