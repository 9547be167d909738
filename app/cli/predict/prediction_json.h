#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/json_object.h"
#include "metrics/prediction/held_out.h"
#include "metrics/prediction/model_choice.h"
#include "metrics/prediction/prediction.h"

namespace app {

/// Parts of "fidelis-predict" (docs/formats.md). Numbers are written so that they read back as the same doubles;
/// infinite and undefined ones are null.
[[nodiscard]] nlohmann::ordered_json toJson(const metrics::Prediction& prediction);
[[nodiscard]] nlohmann::ordered_json toJson(const std::vector<metrics::Candidate>& candidates);
[[nodiscard]] nlohmann::ordered_json toJson(const metrics::HeldOutCheck& check, const metrics::Prediction& prediction);
[[nodiscard]] nlohmann::ordered_json toJson(const metrics::PredictedError& error);

/// The predictions of a file that `fidelis predict` saved; they say the same as those that were saved. Throws
/// InputError if the file is of another format or its numbers do not fit together.
[[nodiscard]] std::vector<metrics::Prediction> readPredictions(const std::filesystem::path& file);

}  // namespace app
