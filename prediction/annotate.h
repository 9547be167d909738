#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "metrics/prediction/predicted_box.h"
#include "model/experiment.h"
#include "prediction/coordinates.h"
#include "prediction/prediction_file.h"

namespace prediction {

/// Whether samples were where a detection lies in the parameter space; the number in the column `…_extrapolated`.
enum class Extrapolation {
  Inside = 0,   ///< interpolated; the ends of the ranges count as inside
  Outside = 1,  ///< a coordinate is beyond the range of the samples
  Joint = 2,    ///< each is in range, but no sample is near their combination
  Unknown = 3,  ///< a coordinate is not known, or the measurand itself was not reported: nothing is predicted
};

/// How a package is annotated.
struct AnnotateOptions {
  std::string measurand;                 ///< of files that do not record it: name or column; empty: they must
  std::vector<std::string> coordinates;  ///< overrides, see coordinatesFor()
  metrics::BoundOf bounds = metrics::BoundOf::Confidence;
};

/// What the detections of a package got from one prediction file.
struct AnnotatedCounts {
  std::string measurand;
  std::vector<std::string> columns;  ///< that were added
  std::size_t detections = 0;
  std::size_t outside = 0;  ///< Outside or Joint
  std::size_t unknown = 0;
  std::size_t unreported = 0;  ///< of these, for want of the measurand itself
};

/// Tells with each detection of an experiment package how wrong it probably is:
///
///   …,range_m,…,range_m_bias,range_m_bias_low,range_m_bias_high,range_m_extrapolated
///
/// for each predicted error (d_bias -> bias, d_cavm -> cavm …) of each file, at the detection's point of the parameter
/// space (coordinates.h). Values in the unit of the measurand; an empty cell: nothing is known. What is read are the
/// numbers of the file, as rounded there, so that anybody can do the sum again.
///
/// The constructor finds out everything that can be wrong before a long simulation.
class Annotation {
 public:
  /// Throws InputError: a measurand that is not recorded, not the experiment's or predicted twice, a unit that differs,
  /// a coordinate that nobody knows.
  Annotation(const model::Experiment& experiment, std::vector<PredictionFile> files, const AnnotateOptions& options);

  /// Adds the columns to every measurement of the package in `folder`, which has the samples of the experiment, and
  /// the key "x-prediction" to its experiment.json: which file, what, from where each coordinate. Without files that
  /// key is removed: nothing is predicted any more. Not all or nothing: work on a copy or a folder of your own.
  [[nodiscard]] std::vector<AnnotatedCounts> apply(const std::filesystem::path& folder) const;

 private:
  struct Job {
    PredictionFile file;
    std::string sha256;
    model::Measurand measurand;
    std::vector<Coordinate> coordinates;
    std::vector<std::string> columns;
  };
  std::vector<Job> jobs_;
  metrics::BoundOf bounds_;

  class Rows;
  void annotate(const model::Experiment& package, const model::Sample& sample,
                std::vector<AnnotatedCounts>& counts) const;
  [[nodiscard]] nlohmann::json provenance() const;
};

}  // namespace prediction
