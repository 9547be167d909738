#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/predict/point_boxes.h"
#include "app/cli/predict/request.h"
#include "app/cli/predict/validation_results.h"
#include "metrics/prediction/held_out.h"
#include "metrics/prediction/model_choice.h"
#include "metrics/prediction/prediction.h"

namespace app {

/// A prediction with what was seen when it was made or checked.
struct Answer {
  metrics::Prediction prediction;
  std::vector<metrics::Candidate> candidates;  ///< empty: the family was given
  std::optional<metrics::HeldOutCheck> held_out;
};

struct Query {
  std::vector<double> point;
  std::vector<metrics::PredictedError> errors;  ///< parallel to the answers
};

/// What `fidelis predict` shows.
struct Outcome {
  std::vector<Answer> answers;  ///< one a target, all over the same parameters
  std::vector<Query> queries;
  std::optional<PointBoxes> boxes;  ///< at the only query
  std::vector<UnusedSample> left_out;
  std::optional<prediction::Measurand> measurand;  ///< whose errors these are, if that is known
  std::size_t setups = 0;                          ///< fewer than n: rows share errors; 0: not known

  [[nodiscard]] const std::vector<std::string>& parameters() const {
    return answers.front().prediction.regression.parameters;
  }
};

/// Learns from the results, or reads the saved prediction; checks it on held-out rows; asks it at every point;
/// makes boxes of what was simulated there.
[[nodiscard]] Outcome outcomeOf(const PredictRequest& request);

}  // namespace app
