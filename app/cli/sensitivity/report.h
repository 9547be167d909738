#pragma once

#include <string>
#include <vector>

#include "app/cli/session.h"
#include "metrics/sensitivity/sensitivity_plan.h"

namespace app {

struct IndexOptions {
  std::string first_order = "saltelli";
  std::size_t replicates = 1000;
  double confidence = 0.95;
  std::string json;  ///< file, "-" for standard output, "" for a table
};

/// One number a run, in the order of the plan; NaN where a run leaves it undefined. Then it has no indices.
struct SensitivityOutput {
  nlohmann::ordered_json name;  ///< keys that say which it is
  std::string title;
  std::vector<double> values;
};

/// Format, version, method and options: how every result begins.
[[nodiscard]] nlohmann::ordered_json headOfSensitivity(const metrics::SensitivityPlan& plan,
                                                       const IndexOptions& options, const Session& session);

/// Computes the indices of all outputs and writes them, as JSON behind `head` or as tables.
void reportSensitivity(nlohmann::ordered_json head, const metrics::SensitivityPlan& plan,
                       const std::vector<SensitivityOutput>& outputs, const IndexOptions& options,
                       const Session& session);

}  // namespace app
