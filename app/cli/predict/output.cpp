#include "app/cli/predict/output.h"

#include <cmath>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/predict/box_output.h"
#include "core/file.h"
#include "core/text.h"
#include "core/version.h"
#include "prediction/prediction_file.h"

namespace app {

namespace {

using metrics::PredictedError;
using metrics::Prediction;

std::vector<std::string> outsideOf(const Outcome& outcome, const PredictedError& error) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < outcome.parameters().size(); ++k) {
    if (error.outside & (1u << k)) names.push_back(outcome.parameters()[k]);
  }
  return names;
}

/// "" where samples were.
std::string extrapolationOf(const Outcome& outcome, const PredictedError& error) {
  if (error.outside != 0) return "outside " + core::join(outsideOf(outcome, error));
  return error.outside_joint ? "no sample near this combination" : "";
}

/// Where, and whether samples were there.
nlohmann::ordered_json pointJson(const Outcome& outcome, const Query& query) {
  nlohmann::ordered_json object;
  for (std::size_t k = 0; k < query.point.size(); ++k) object["at"][outcome.parameters()[k]] = query.point[k];
  const PredictedError& any = query.errors.front();  // where samples were is the same for all
  object["extrapolation"] = any.extrapolated();
  object["outside"] = outsideOf(outcome, any);
  object["outside_joint"] = any.outside_joint;
  return object;
}

nlohmann::ordered_json queryJson(const Outcome& outcome, const Query& query) {
  nlohmann::ordered_json object = pointJson(outcome, query);
  for (std::size_t t = 0; t < query.errors.size(); ++t) {
    object["errors"][outcome.answers[t].prediction.target] = prediction::toJson(query.errors[t]);
  }
  return object;
}

nlohmann::ordered_json fileJson(const std::string& file) {
  return {{"path", file}, {"sha256", core::sha256OfFile(file)}};
}

nlohmann::ordered_json sourceJson(const PredictRequest& request) {
  nlohmann::ordered_json source = fileJson(request.with.empty() ? request.results : request.with);
  if (!request.test.empty()) source["test"] = request.test;
  if (!request.held_out.empty()) source["held_out"] = fileJson(request.held_out);
  for (const std::string& file : request.boxes.simulated) source["simulated"].push_back(fileJson(file));
  return source;
}

std::string shown(double value) { return std::isfinite(value) ? core::significant(value, 4) : "-"; }
std::string shown(const metrics::Interval& interval) {
  return "[" + shown(interval.low) + ", " + shown(interval.high) + "]";
}

void writePrediction(const Answer& answer, std::ostream& out) {
  const Prediction& p = answer.prediction;
  const metrics::Regression& r = p.regression;
  out << fmt::format("{} over {}: {}, n = {}, {} degrees of freedom, residual sd {}\n", p.target,
                     core::join(r.parameters), metrics::name(r.family), r.n, r.dof, shown(r.residual_sd));
  for (const metrics::Coefficient& c : metrics::coefficientsOf(r)) {
    out << fmt::format("  {:<24} {:>12} +- {}\n", c.name, shown(c.value), shown(c.standard_error));
  }
  for (const metrics::Candidate& candidate : answer.candidates) {
    out << fmt::format("  tried {:<18} {}\n", metrics::name(candidate.family),
                       candidate.score ? "misses what was left out by " + shown(*candidate.score)
                                       : "not considered: " + candidate.reason);
  }
  if (r.dof == 0) out << "  no degrees of freedom: the function runs through every sample; there are no bounds\n";
  if (!r.boundsAreExact()) out << "  bounds are approximate (delta method)\n";
  if (const auto& check = answer.held_out) {
    out << fmt::format(
        "  held out: {} of {} inside their {:g} % interval (credible share {}), mean miss {}, largest {}\n",
        check->covered, check->n, 100.0 * p.level, shown(check->coverage), shown(check->mean_miss),
        shown(check->largest_miss));
    out << fmt::format("  skill over no prediction {}, over the mean error {}\n", shown(check->skill_over_none),
                       shown(check->skill_over_mean));
  }
}

std::string pointForReader(const Outcome& outcome, const Query& query) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < query.point.size(); ++k) {
    parts.push_back(outcome.parameters()[k] + "=" + core::significant(query.point[k], 6));
  }
  return core::join(parts, ",");
}

void writeQueries(const Outcome& outcome, std::ostream& out) {
  if (outcome.queries.empty()) return;
  out << fmt::format("\n  {:<30} {:<10} {:>10}  {:<24} {:<24} {}\n", "at", "error", "value",
                     fmt::format("{:g} % of the mean", 100.0 * outcome.answers.front().prediction.level),
                     "of one more sample", "remark");
  for (const Query& query : outcome.queries) {
    for (std::size_t t = 0; t < query.errors.size(); ++t) {
      const PredictedError& error = query.errors[t];
      out << fmt::format("  {:<30} {:<10} {:>10}  {:<24} {:<24} {}\n", pointForReader(outcome, query),
                         outcome.answers[t].prediction.target, shown(error.value), shown(error.confidence),
                         shown(error.observation), extrapolationOf(outcome, error));
    }
  }
}

nlohmann::ordered_json boxesJson(const Outcome& outcome, const PredictRequest& request) {
  nlohmann::ordered_json object = pointJson(outcome, outcome.queries.front());
  object["level"] = outcome.answers.front().prediction.level;
  object.update(toJson(*outcome.boxes, request.boxes));
  return object;
}

void writeBoxes(const Outcome& outcome, const PredictRequest& request, std::ostream& out) {
  if (!outcome.boxes) return;
  const Query& query = outcome.queries.front();
  const std::string extrapolation = extrapolationOf(outcome, query.errors.front());
  const std::string where =
      pointForReader(outcome, query) + (extrapolation.empty() ? "" : ", extrapolated: " + extrapolation);
  writeBoxTable(*outcome.boxes, request.boxes, {.where = where, .level = outcome.answers.front().prediction.level},
                out);
}

}  // namespace

nlohmann::ordered_json documentOf(const Outcome& outcome, const PredictRequest& request) {
  nlohmann::ordered_json document{{"format", "fidelis-predict"}, {"version", 1}, {"fidelis_version", core::kVersion}};
  document["source"] = sourceJson(request);
  document["options"] = {{"over", outcome.parameters()}, {"family", request.family}, {"folds", request.folds}};
  if (!request.columns.weight.empty()) document["options"]["weight"] = request.columns.weight;
  if (outcome.measurand) document["measurand"] = prediction::toJson(*outcome.measurand);
  document["left_out"] = nlohmann::ordered_json::array();
  for (const UnusedSample& sample : outcome.left_out) {
    document["left_out"].push_back({{"where", sample.where}, {"why", sample.why}});
  }
  document["predictions"] = nlohmann::ordered_json::array();
  for (const Answer& answer : outcome.answers) {
    nlohmann::ordered_json entry = prediction::toJson(answer.prediction);
    if (!answer.candidates.empty()) entry["candidates"] = prediction::toJson(answer.candidates);
    if (answer.held_out) entry["held_out"] = prediction::toJson(*answer.held_out, answer.prediction);
    document["predictions"].push_back(std::move(entry));
  }
  document["queries"] = nlohmann::ordered_json::array();
  for (const Query& query : outcome.queries) document["queries"].push_back(queryJson(outcome, query));
  if (outcome.boxes) document["boxes"] = boxesJson(outcome, request);
  return document;
}

void writeTable(const Outcome& outcome, const PredictRequest& request, std::ostream& out) {
  for (const Answer& answer : outcome.answers) writePrediction(answer, out);
  writeQueries(outcome, out);
  writeBoxes(outcome, request, out);
}

void writeRemarks(const Outcome& outcome, const PredictRequest& request, std::ostream& messages) {
  if (!request.save.empty() && !outcome.measurand) {
    messages << "fidelis: the saved prediction does not record whose errors it predicts; add --measurand, e.g. "
                "--measurand range.\n";
  }
  for (const UnusedSample& sample : outcome.left_out) {
    messages << fmt::format("fidelis: {} is left out: {}.\n", sample.where, sample.why);
  }
  const std::size_t n = outcome.answers.front().prediction.regression.n;
  if (outcome.setups > 0 && outcome.setups < n) {
    messages << fmt::format(
        "fidelis: {} rows are of {} set-ups; bounds take rows as independent, so they are too narrow.\n", n,
        outcome.setups);
  }
  if (outcome.boxes) writeBoxRemarks(*outcome.boxes, messages);
}

}  // namespace app
