#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>

#include "app/cli/predict/outcome.h"

namespace app {

/// "fidelis-predict", as docs/formats.md tells it.
[[nodiscard]] nlohmann::ordered_json documentOf(const Outcome& outcome, const PredictRequest& request);

/// For people: each prediction, then a table of the points that were asked for, then the boxes at the only one.
void writeTable(const Outcome& outcome, const PredictRequest& request, std::ostream& out);

/// What a reader should know before believing it: samples left out, rows that are not independent, boxes that
/// cannot be told.
void writeRemarks(const Outcome& outcome, const PredictRequest& request, std::ostream& messages);

}  // namespace app
