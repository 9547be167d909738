#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/detections.h"
#include "model/experiment.h"

namespace prediction {

/// Where a coordinate of a detection in the parameter space is taken from, the first that knows the name:
///
///   Sample       `parameters` of the samples: the coordinates that validation results are filed under
///   Detection    what the detection itself reports (detection_quantities.h)
///   Environment  a key of the experiment's environment, after the sample's patch
///
/// One place for a whole package: if one sample names a parameter, the others must too, or their coordinate is not
/// known. It is never filled in from another place, which would mean something else (the set-up's true range is not
/// the range that a detection reports).
enum class CoordinateSource { Sample, Detection, Environment };
[[nodiscard]] std::string toString(CoordinateSource source);  ///< "sample" …

struct Coordinate {
  std::string parameter;  ///< of the prediction
  CoordinateSource source;
  std::string key;  ///< there
};

/// One for each parameter, in order. `chosen` overrides the rule above: "NAME=sample", "NAME=detection:range_m",
/// "NAME=environment:visibility_m". Throws InputError for a parameter that nobody knows, with the nearest name and all
/// that there are, and for a choice that is none.
[[nodiscard]] std::vector<Coordinate> coordinatesFor(std::span<const std::string> parameters,
                                                     const model::Experiment& experiment,
                                                     std::span<const std::string> chosen = {});

/// The coordinates of all detections of one sample.
class SamplePoints {
 public:
  SamplePoints(std::span<const Coordinate> coordinates, const model::Experiment& experiment,
               const model::Sample& sample, const core::Detections& detections);

  /// Fills `point` with the coordinates of this detection; false if one is not known.
  bool at(std::size_t detection, std::span<double> point) const;

 private:
  struct Column {
    std::optional<double> constant;  ///< the same for all detections of the sample
    std::vector<double> values;      ///< else one for each detection; empty if it is not known
  };
  std::vector<Column> columns_;
};

}  // namespace prediction
