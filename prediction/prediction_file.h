#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/json_object.h"
#include "metrics/prediction/held_out.h"
#include "metrics/prediction/model_choice.h"
#include "metrics/prediction/prediction.h"
#include "prediction/measurand.h"

namespace prediction {

/// Parts of "fidelis-predict" (docs/formats.md). Numbers are written so that they read back as the same doubles;
/// infinite and undefined ones are null.
[[nodiscard]] nlohmann::ordered_json toJson(const metrics::Prediction& prediction);
[[nodiscard]] nlohmann::ordered_json toJson(const std::vector<metrics::Candidate>& candidates);
[[nodiscard]] nlohmann::ordered_json toJson(const metrics::HeldOutCheck& check, const metrics::Prediction& prediction);
[[nodiscard]] nlohmann::ordered_json toJson(const metrics::PredictedError& error);

/// What `fidelis predict` saved; its predictions say the same as those that were saved.
struct PredictionFile {
  std::filesystem::path file;
  std::optional<Measurand> measurand;            ///< whose errors these are; absent if it was not recorded
  std::vector<metrics::Prediction> predictions;  ///< one a kind of error, all over the same parameters

  [[nodiscard]] const std::vector<std::string>& parameters() const { return predictions.front().regression.parameters; }
  [[nodiscard]] std::vector<std::string> targets() const;
  /// "d_bias, d_cavm of range (range_m, m) over range_m".
  [[nodiscard]] std::string title() const;
};

/// Throws InputError if the file is of another format or its numbers do not fit together.
[[nodiscard]] PredictionFile readPredictionFile(const std::filesystem::path& file);

}  // namespace prediction
