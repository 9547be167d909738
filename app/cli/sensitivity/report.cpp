#include "app/cli/sensitivity/report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <ostream>

#include "core/text.h"
#include "core/version.h"
#include "metrics/sensitivity/fast_indices.h"
#include "metrics/sensitivity/sobol_indices.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using metrics::SensitivityMethod;
using metrics::SensitivityPlan;
using metrics::SensitivityResult;

SensitivityResult indicesOf(const std::vector<double>& values, const SensitivityPlan& plan, const IndexOptions& options,
                            const Session& session) {
  const std::size_t k = plan.parameters.size();
  if (plan.method == SensitivityMethod::Fast) {
    return metrics::fastIndices(values, k, plan.n, plan.curves, options.confidence);
  }
  return metrics::sobolIndices(values, k, plan.n,
                               {.first_order = options.first_order == "jansen" ? metrics::FirstOrderEstimator::Jansen
                                                                               : metrics::FirstOrderEstimator::Saltelli,
                                .replicates = options.replicates,
                                .confidence = options.confidence,
                                .seed = session.seed.value_or(1)});
}

Json jsonOf(const metrics::SensitivityIndex& index) {
  return {{"value", index.value}, {"low", index.low}, {"high", index.high}};  // NaN is written as null
}

std::string textOf(const metrics::SensitivityIndex& index) {
  if (std::isnan(index.value)) return "-";
  if (std::isnan(index.low)) return fmt::format("{:.3f}", index.value);
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", index.value, index.low, index.high);
}

/// An output with its indices; none if some runs leave it undefined.
struct Analyzed {
  const SensitivityOutput& output;
  std::size_t undefined;
  std::optional<SensitivityResult> result;
};

Analyzed analyzed(const SensitivityOutput& output, const SensitivityPlan& plan, const IndexOptions& options,
                  const Session& session) {
  const auto undefined = static_cast<std::size_t>(
      std::count_if(output.values.begin(), output.values.end(), [](double value) { return !std::isfinite(value); }));
  Analyzed all{.output = output, .undefined = undefined, .result = {}};
  if (undefined == 0) all.result = indicesOf(output.values, plan, options, session);
  return all;
}

Json jsonOf(const Analyzed& analyzed, const SensitivityPlan& plan) {
  Json entry = analyzed.output.name;
  entry["undefined_runs"] = analyzed.undefined;
  entry["parameters"] = nullptr;
  if (!analyzed.result) return entry;
  entry["mean"] = analyzed.result->mean;
  entry["variance"] = analyzed.result->variance;
  entry["parameters"] = Json::array();
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    const metrics::ParameterSensitivity& one = analyzed.result->parameters[i];
    entry["parameters"].push_back(
        {{"name", plan.parameters[i].name}, {"first", jsonOf(one.first)}, {"total", jsonOf(one.total)}});
  }
  return entry;
}

void writeTable(const Analyzed& analyzed, const SensitivityPlan& plan, std::ostream& out) {
  out << analyzed.output.title << "\n";
  if (!analyzed.result) {
    out << fmt::format("  undefined in {} of {} runs: no indices. Narrow the ranges.\n", analyzed.undefined,
                       analyzed.output.values.size());
    return;
  }
  out << fmt::format("  mean {}, standard deviation {}\n  {:<24} {:<24} {}\n",
                     core::significant(analyzed.result->mean, 4),
                     core::significant(std::sqrt(analyzed.result->variance), 3), "first order", "total", "parameter");
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
    const metrics::ParameterSensitivity& one = analyzed.result->parameters[i];
    out << fmt::format("  {:<24} {:<24} {}\n", textOf(one.first), textOf(one.total), plan.parameters[i].name);
  }
}

}  // namespace

Json headOfSensitivity(const SensitivityPlan& plan, const IndexOptions& options, const Session& session) {
  Json head{{"format", "fidelis-sensitivity"}, {"version", 1}, {"fidelis_version", core::kVersion}};
  const bool fast = plan.method == SensitivityMethod::Fast;
  head["method"] = fast ? "fast" : "sobol";
  head["n"] = plan.n;
  head["seed"] = session.seed.value_or(1);
  head["options"]["confidence"] = options.confidence;
  if (fast) {
    head["options"]["curves"] = plan.curves;
  } else {
    head["options"]["first_order"] = options.first_order;
    head["options"]["replicates"] = options.replicates;
  }
  return head;
}

void reportSensitivity(Json head, const SensitivityPlan& plan, const std::vector<SensitivityOutput>& outputs,
                       const IndexOptions& options, const Session& session) {
  head["outputs"] = Json::array();
  for (const SensitivityOutput& output : outputs) {
    const Analyzed one = analyzed(output, plan, options, session);
    if (options.json.empty()) {
      writeTable(one, plan, session.out);
    } else {
      head["outputs"].push_back(jsonOf(one, plan));
    }
  }
  if (!options.json.empty()) session.writeJsonTo(options.json, head);
}

}  // namespace app
