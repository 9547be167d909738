#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace metrics {

/// Empirical distribution function: the step function that a sample of values makes.
///
///   p 1 |        ____          values()[i]   where it steps, ascending, distinct
///       |    ___|              levels()[i]   its height after the step, the last is 1
///     0 |___|
///        ------------- x  [unit of the measurand]
///
/// Levels are correctly rounded quotients i/n. Equal fractions i/n = j/m are therefore equal doubles, and levels of two
/// sample sizes merge without slivers, as if compared by integer cross products.
/// Immutable; safe to share. A copy costs nothing: it refers to the same steps.
class Edf {
 public:
  /// From a sample in any order; ties are welcome. One that already ascends is only read through, not sorted or copied:
  /// move it in. Throws InputError if it is empty or a value is not finite.
  explicit Edf(std::vector<double> values);

  /// From a weighted sample: weights >= 0, normalised to sum 1; values of weight 0 are dropped. Throws InputError if a
  /// number is not finite, a weight is negative, none is positive or the lengths differ.
  static Edf weighted(std::span<const double> values, std::span<const double> weights);

  /// From distinct ascending values, the i-th of them `counts[i]` times: what a bootstrap draws, without sorting again.
  /// The order is the caller's promise. Throws InputError if all counts are 0 or the lengths differ.
  static Edf repeated(std::span<const double> ascending, std::span<const std::uint32_t> counts);

  /// From the table of a CDF: its height at and after each value. Values ascend, heights do not fall and end at 1.
  /// Throws InputError otherwise. Such a function has no sample: n() is 0.
  static Edf fromSteps(std::span<const double> values, std::span<const double> levels);

  /// Size of the sample; 0 if there is none (edge of an envelope, table).
  [[nodiscard]] std::size_t n() const noexcept { return n_; }
  /// Kish's size of a weighted sample, (sum w)^2 / sum w^2; n() if unweighted. Used where a formula needs n.
  [[nodiscard]] double effectiveN() const noexcept { return effective_n_; }

  [[nodiscard]] std::span<const double> values() const noexcept { return steps_->values; }
  /// Of equal steps, (i + 1)/n is written down when this is first called.
  [[nodiscard]] std::span<const double> levels() const { return steps_->equal ? equalLevels() : steps_->levels; }
  /// Height after step i: levels()[i], without writing down the array.
  [[nodiscard]] double level(std::size_t i) const noexcept {
    return steps_->equal ? static_cast<double>(i + 1) / static_cast<double>(steps_->values.size()) : steps_->levels[i];
  }
  /// Every step has the same height: a sample without ties or weights.
  [[nodiscard]] bool hasEqualSteps() const noexcept { return steps_->equal; }
  [[nodiscard]] double min() const noexcept { return steps_->values.front(); }
  [[nodiscard]] double max() const noexcept { return steps_->values.back(); }

  /// Share of the sample that is <= x.
  [[nodiscard]] double cdf(double x) const noexcept;
  /// Left-continuous inverse: smallest value with cdf(value) >= p; min() for p <= 0. Never interpolates.
  [[nodiscard]] double quantile(double p) const noexcept;

  [[nodiscard]] double mean() const noexcept;
  /// The middle value; halfway between the two middle ones of an even sample.
  [[nodiscard]] double median() const noexcept;
  /// With n - 1 in the denominator (effectiveN() - 1 if weighted). NaN for fewer than two values.
  [[nodiscard]] double standardDeviation() const noexcept;

  /// Every value moved by `offset` along x. [unit of x]
  [[nodiscard]] Edf shifted(double offset) const;

  bool operator==(const Edf& other) const;  // the same function, whatever it was made from

 private:
  friend class EdfBuilder;

  /// What copies share. The levels of equal steps are empty until somebody asks for the array.
  struct Steps {
    Steps(std::vector<double> x, std::vector<double> p)
        : values(std::move(x)), equal(p.empty()), levels(std::move(p)) {}

    std::vector<double> values;
    bool equal;
    mutable std::vector<double> levels;
    mutable std::once_flag asked;
  };

  /// No levels: equal steps.
  Edf(std::vector<double> values, std::vector<double> levels, std::size_t n = 0, double effective_n = 0.0);
  [[nodiscard]] std::span<const double> equalLevels() const;
  [[nodiscard]] std::size_t stepReaching(double p) const noexcept;
  template <typename Term>
  [[nodiscard]] double meanOf(Term term) const noexcept;

  std::shared_ptr<const Steps> steps_;
  std::size_t n_ = 0;
  double effective_n_ = 0.0;
};

/// Builds a step function from left to right; equal neighbours become one step. For code that walks levels in order.
class EdfBuilder {
 public:
  void reserve(std::size_t steps);
  /// The function rises to `level` at `value`. Neither may fall from one call to the next.
  void step(double value, double level);
  /// `n` and `effective_n`: of the sample, if there is one.
  [[nodiscard]] Edf build(std::size_t n = 0, double effective_n = 0.0) &&;

  /// All steps at once: values ascend and differ, levels rise to 1; no levels mean equal steps.
  [[nodiscard]] static Edf fromSteps(std::vector<double> values, std::vector<double> levels = {});

 private:
  std::vector<double> values_;
  std::vector<double> levels_;
};

}  // namespace metrics
