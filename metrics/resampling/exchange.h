#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "metrics/distributions/edf.h"
#include "metrics/resampling/unit_sample.h"

namespace metrics {

/// Several samples thrown into one urn and dealt out again, each with its number of units: what they would be if they
/// came from one distribution. Sorted once; a deal is linear in the number of values.
/// Immutable; safe to share.
class Exchange {
 public:
  /// Every value of sample k is moved by shifts[k]. Throws InputError if a sample is empty or has a value that is not
  /// finite, or if some samples have units and others have none.
  Exchange(std::span<const UnitSample> samples, std::span<const double> shifts);

  /// One random deal, in the order of the samples.
  [[nodiscard]] std::vector<Edf> dealt(core::Random& random) const;

 private:
  std::vector<double> ascending_;
  std::vector<std::uint32_t> unit_of_;    // of each value
  std::vector<std::uint32_t> sample_of_;  // of each unit, before dealing
  std::size_t samples_ = 0;
};

}  // namespace metrics
