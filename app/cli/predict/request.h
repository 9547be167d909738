#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/predict/validation_results.h"

namespace app {

/// The boxes that are to be made of the values simulated at the point of --at.
struct BoxRequest {
  std::vector<std::string> simulated;  ///< files; empty: no boxes
  std::string column;                  ///< of the simulated values
  double numerical = 0.0;              ///< U_num >= 0 [unit of the column]
  std::string bounds = "confidence";   ///< or "observation"
  std::string model_form;              ///< "portions", "area"; empty: portions, if they were predicted
  std::string csv;                     ///< file for the edges
};

/// What `fidelis predict` was asked for.
struct PredictRequest {
  std::string results;  ///< to learn from; empty if a saved prediction is asked
  std::string with;     ///< the saved prediction
  ResultColumns columns;
  std::string test;       ///< of an acceptance report
  std::string measurand;  ///< whose errors these are: name or column; empty: as the file says
  std::string family = "auto";
  std::size_t folds = 0;
  std::optional<double> level;  ///< absent: 0.95, or as saved
  std::vector<std::string> at;  ///< "range_m=12.4,angle_deg=30"
  std::string at_file;
  std::string held_out;
  BoxRequest boxes;
  std::string save;
  std::string json;
};

/// Throws InputError for options that contradict each other or leave nothing to do.
void check(const PredictRequest& request);

/// The points of --at and --at-file, in this order. Throws InputError that names the nearest parameter.
[[nodiscard]] std::vector<std::vector<double>> queryPoints(const PredictRequest& request,
                                                           const std::vector<std::string>& parameters);

}  // namespace app
