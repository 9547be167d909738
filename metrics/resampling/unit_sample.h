#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace metrics {

/// A sample, and which of its values hang together.
///
///   values  22.01 22.03 | 21.98 22.00 22.02 | 22.05      [unit of the measurand]
///   units       0     0 |     1     1     1 |     2      frame, or set-up, of each value
///
/// Detections of one frame share its errors, frames of one set-up share more. Chance acts on the unit: drawn singly,
/// dependent detections give intervals that are far too narrow. Numbers of units ascend with time where neighbours
/// are to stay together (blocks); they need not be without gaps, and their order in the sample does not matter.
struct UnitSample {
  std::span<const double> values;
  std::span<const std::uint32_t> units;  ///< as long as values; empty: each value is a unit of its own
};

/// The two sides of a comparison. Refers to the values: they must outlive it.
struct UnitComparison {
  std::vector<UnitSample> simulated;  ///< several runs make a p-box
  UnitSample measured;
};

}  // namespace metrics
