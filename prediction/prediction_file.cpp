#include "prediction/prediction_file.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"

namespace prediction {

namespace {

using Json = nlohmann::ordered_json;
using metrics::Family;
using metrics::Interval;
using metrics::Prediction;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json pair(const Interval& interval) { return Json::array({number(interval.low), number(interval.high)}); }

Json coefficientsJson(const metrics::Regression& regression) {
  Json list = Json::array();
  for (const metrics::Coefficient& c : metrics::coefficientsOf(regression)) {
    list.push_back({{"name", c.name}, {"value", number(c.value)}, {"standard_error", number(c.standard_error)}});
  }
  return list;
}

Json domainJson(const Prediction& prediction) {
  Json ranges = Json::array();
  for (std::size_t k = 0; k < prediction.domain.ranges.size(); ++k) {
    const Interval& range = prediction.domain.ranges[k];
    ranges.push_back({{"parameter", prediction.regression.parameters[k]}, {"min", range.low}, {"max", range.high}});
  }
  return {{"ranges", std::move(ranges)},
          {"largest_leverage", prediction.domain.largest_leverage},
          {"root", prediction.domain.root}};
}

Family familyNamed(core::JsonObject& object) {
  std::vector<std::string> names;
  for (const Family family : metrics::kFamilies) names.emplace_back(metrics::name(family));
  const std::string name = object.choice("family", names);
  return metrics::kFamilies[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
}

void readDomain(core::JsonObject domain, Prediction& prediction) {
  domain.eachObject("ranges", [&](core::JsonObject& range) {
    prediction.regression.parameters.push_back(range.text("parameter"));
    prediction.domain.ranges.push_back({.low = range.number("min"), .high = range.number("max")});
    range.finish();
  });
  const std::size_t p = prediction.regression.parameters.size();
  if (p == 0 || p > metrics::kMaxParameters) {
    domain.fail("ranges", fmt::format("names {} parameters.", p), "Save the prediction again.");
  }
  prediction.domain.largest_leverage = domain.number("largest_leverage", {.min = 0.0});
  prediction.domain.root = domain.numbers("root");
  if (!prediction.domain.root.empty() && prediction.domain.root.size() != (p + 1) * (p + 1)) {
    domain.fail("root", "has another size than its parameters ask for.", "Save the prediction again.");
  }
  domain.finish();
}

void readCurve(core::JsonObject curve, metrics::Regression& regression) {
  const std::size_t p = regression.parameters.size();
  const std::size_t k = metrics::coefficientCount(regression.family, p);
  regression.centre = curve.numbers("centre", p);
  regression.scale = curve.numbers("scale", p);
  for (const double scale : regression.scale) {
    if (!(scale > 0.0)) curve.fail("scale", "must be positive.", "Save the prediction again.");
  }
  regression.coefficients = curve.numbers("coefficients", k);
  regression.root = curve.numbers("root", k * k);
  curve.finish();
}

/// Reads what at() needs; the rest of the entry is for readers.
Prediction readPrediction(core::JsonObject& entry) {
  Prediction prediction{.target = entry.text("target"), .never_negative = entry.flagOr("never_negative", false)};
  prediction.regression.family = familyNamed(entry);
  readDomain(entry.object("domain"), prediction);
  metrics::Regression& regression = prediction.regression;
  readCurve(entry.object("curve"), regression);
  regression.n = static_cast<std::size_t>(entry.integer("n", {.min = 1}));
  if (regression.n < regression.coefficients.size()) {
    entry.fail("n", "is less than the number of coefficients.", "Save the prediction again.");
  }
  regression.dof = regression.n - regression.coefficients.size();
  regression.residual_sd = entry.optionalNumber("residual_sd", {.min = 0.0}).value_or(std::nan(""));
  prediction.mean_error = entry.number("mean_error");
  for (const char* key : {"bounds", "dof", "coefficients", "candidates", "held_out"}) (void)entry.has(key);
  const double level = entry.number("level");
  entry.finish();
  return metrics::atLevel(std::move(prediction), level);
}

}  // namespace

Json toJson(const Prediction& prediction) {
  const metrics::Regression& r = prediction.regression;
  Json object{{"target", prediction.target},
              {"family", metrics::name(r.family)},
              {"never_negative", prediction.never_negative},
              {"level", prediction.level},
              {"bounds", r.dof == 0           ? "none"
                         : r.boundsAreExact() ? "exact"
                                              : "approximate"},
              {"n", r.n},
              {"dof", r.dof},
              {"residual_sd", number(r.residual_sd)},
              {"mean_error", prediction.mean_error}};
  object["coefficients"] = coefficientsJson(r);
  object["domain"] = domainJson(prediction);
  object["curve"] = {{"centre", r.centre}, {"scale", r.scale}, {"coefficients", r.coefficients}, {"root", r.root}};
  return object;
}

Json toJson(const std::vector<metrics::Candidate>& candidates) {
  Json list = Json::array();
  for (const metrics::Candidate& candidate : candidates) {
    list.push_back({{"family", metrics::name(candidate.family)},
                    {"score", candidate.score ? Json(*candidate.score) : Json(nullptr)},
                    {"reason", candidate.reason}});
  }
  return list;
}

Json toJson(const metrics::HeldOutCheck& check, const Prediction& prediction) {
  return {{"n", check.n},
          {"covered", check.covered},
          {"coverage", pair(check.coverage)},
          {"level_is_credible", check.holds(prediction)},
          {"extrapolated", check.extrapolated},
          {"mean_miss", check.mean_miss},
          {"mean_absolute_miss", check.mean_absolute_miss},
          {"largest_miss", check.largest_miss},
          {"skill_over_none", number(check.skill_over_none)},
          {"skill_over_mean", number(check.skill_over_mean)}};
}

Json toJson(const metrics::PredictedError& error) {
  return {{"value", number(error.value)},
          {"confidence", pair(error.confidence)},
          {"observation", pair(error.observation)},
          {"largest", number(error.largest())}};
}

std::vector<std::string> PredictionFile::targets() const {
  std::vector<std::string> names;
  for (const Prediction& prediction : predictions) names.push_back(prediction.target);
  return names;
}

std::string PredictionFile::title() const {
  return core::join(targets()) + (measurand ? " of " + toString(*measurand) : "") + " over " + core::join(parameters());
}

PredictionFile readPredictionFile(const std::filesystem::path& file) {
  const nlohmann::json document = core::readJson(file);
  core::JsonObject object(document, file);
  object.expectFormat("fidelis-predict", 1);
  PredictionFile read{.file = file, .measurand = {}, .predictions = {}};
  if (object.has("measurand")) read.measurand = readMeasurand(object.object("measurand"));
  object.eachObject("predictions", [&](core::JsonObject& entry) { read.predictions.push_back(readPrediction(entry)); });
  for (const char* key : {"fidelis_version", "source", "options", "left_out", "queries", "boxes"})
    (void)object.has(key);
  object.finish();
  if (read.predictions.empty()) object.fail("predictions", "is empty.", "Save the prediction again.");
  for (const Prediction& prediction : read.predictions) {
    if (prediction.regression.parameters != read.parameters()) {
      object.fail("predictions", "are over different parameters.", "Save them in files of their own.");
    }
  }
  return read;
}

}  // namespace prediction
