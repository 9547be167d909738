#include "proposals/gap_report.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/file.h"
#include "core/json_object.h"
#include "core/text.h"

namespace proposals {

namespace {

using core::JsonObject;

bool isExistence(const std::string& name) { return name == "missing" || name == "extra"; }

/// Every object of an array (absent: none); unlike JsonObject::eachObject it passes over keys that nobody asks for.
void eachOf(JsonObject& object, const std::string& key, const std::function<void(JsonObject&)>& read) {
  if (!object.has(key)) return;
  const nlohmann::json& list = object.raw(key);
  if (!list.is_array()) object.fail(key, "is not a list.", "Write the report again with 'fidelis gap'.");
  for (std::size_t i = 0; i < list.size(); ++i) {
    JsonObject element(list[i], object.file(), object.pointer() + "/" + key + "/" + std::to_string(i));
    read(element);
  }
}

std::optional<gap::Interval> intervalOf(JsonObject& object, const std::string& key) {
  if (!object.has(key)) return std::nullopt;
  const std::vector<double> ends = object.numbers(key, 2);
  return gap::Interval{ends[0], ends[1]};
}

/// Of the values of an enumeration the one with this word.
template <typename Kind, std::size_t n>
Kind kindOf(JsonObject& object, const Kind (&kinds)[n]) {
  std::vector<std::string> words;
  for (const Kind kind : kinds) words.push_back(toString(kind));
  const std::string word = object.choice("kind", words);
  return kinds[std::ranges::find(words, word) - words.begin()];
}

ReportedGap readMeasurand(JsonObject& json) {
  ReportedGap gap;
  gap.name = json.text("name");
  gap.unit = json.textOr("unit", "");
  gap.resolution = json.numberOr("resolution", 0.0);
  gap.bias = json.number("d_bias");
  gap.scatter = json.number("d_cavm");
  if (json.has("interval")) {
    JsonObject interval = json.object("interval");
    gap.bias_interval = intervalOf(interval, "d_bias");
  }
  return gap;
}

void readGap(JsonObject json, GapReport& report) {
  report.present = json.flagOr("present", false);
  eachOf(json, "measurands", [&](JsonObject& measurand) { report.gaps.push_back(readMeasurand(measurand)); });
  if (!json.has("existence")) return;
  JsonObject existence = json.object("existence");
  for (const std::string name : {"missing", "extra"}) {
    ReportedGap gap;
    gap.name = name;
    gap.bias = existence.numberOr(name + "_fraction", 0.0);
    report.gaps.push_back(gap);
  }
}

void readStratum(const nlohmann::json& stratum, gap::WhereRow& row) {
  row.numeric = stratum.size() == 2 && stratum[0].is_number();
  if (!row.numeric) {
    row.names = stratum.get<std::vector<std::string>>();
    return;
  }
  row.low = stratum[0].get<double>();
  row.high = stratum[1].get<double>();
}

gap::WhereRow readPlace(JsonObject& json) {
  gap::WhereRow row;
  row.measurand = json.text("measurand");
  row.component = json.text("component");
  row.covariate = json.text("covariate");
  try {
    readStratum(json.raw("stratum"), row);
  } catch (const nlohmann::json::exception&) {
    json.fail("stratum", "is neither two numbers nor names.", "Write the report again with 'fidelis gap'.");
  }
  row.value = json.number("value");
  row.unit = json.textOr("unit", "");
  row.share = json.numberOr("share", 0.0);
  row.size = json.numberOr("size", 0.0);
  return row;
}

std::vector<gap::FittedParameter> parametersOf(JsonObject& cause, const std::string& key) {
  std::vector<gap::FittedParameter> parameters;
  if (!cause.has(key)) return parameters;
  JsonObject json = cause.object(key);
  for (const std::string& name : json.keys()) {
    JsonObject parameter = json.object(name);
    parameters.push_back(
        {name, parameter.textOr("unit", ""), parameter.number("value"), intervalOf(parameter, "interval"), {}, {}});
  }
  return parameters;
}

/// A shrink without interval is as sure as it says.
gap::Shrink shrinkOf(JsonObject& json) {
  const double fraction = json.numberOr("fraction", 0.0);
  return {fraction, intervalOf(json, "interval").value_or(gap::Interval{fraction, fraction})};
}

gap::Cause readCause(JsonObject& json) {
  gap::Cause cause;
  cause.kind = kindOf(json, {gap::CauseKind::kEffect, gap::CauseKind::kParameter, gap::CauseKind::kReference});
  cause.name = json.text("name");
  cause.variant = json.textOr("variant", "");
  cause.sensors = json.texts("sensors");
  cause.percollect = json.texts("percollect");
  cause.chain = json.texts("chain");
  cause.chain_titles = json.texts("chain_titles");
  cause.confidence = json.numberOr("confidence", 0.0);
  cause.explained = json.numberOr("explained", 0.0);
  cause.parameters = parametersOf(json, "parameters");
  for (const gap::FittedParameter& p : parametersOf(json, "setups")) cause.setups[p.name] = p;
  if (json.has("shrink")) {
    JsonObject shrink = json.object("shrink");
    cause.shrink = shrinkOf(shrink);
  }
  return cause;
}

void readAfter(JsonObject& json, GapReport& report) {
  const auto gapNamed = [&](const std::string& name) {
    return std::ranges::find(report.gaps, name, &ReportedGap::name);
  };
  eachOf(json, "measurands", [&](JsonObject& measurand) {
    const auto gap = gapNamed(measurand.text("name"));
    if (gap == report.gaps.end()) return;
    JsonObject after = measurand.object("after");
    gap->bias_after = after.number("d_bias");
    gap->scatter_after = after.number("d_cavm");
  });
  if (!json.has("existence")) return;
  JsonObject existence = json.object("existence");
  JsonObject after = existence.object("after");
  for (const std::string name : {"missing", "extra"}) {
    const auto gap = gapNamed(name);
    if (gap != report.gaps.end()) gap->bias_after = after.numberOr(name + "_fraction", 0.0);
  }
}

void readShrink(JsonObject json, GapReport& report) {
  report.shrink = shrinkOf(json);
  report.held_out = json.texts("held_out_samples");
  report.half_of_the_beams_fitted = json.flagOr("half_of_the_beams_fitted", false);
  if (json.has("before_total") && json.has("after_total")) {
    report.totals = {json.number("before_total"), json.number("after_total")};
  }
  eachOf(json, "samples", [&](JsonObject& sample) {
    report.samples.push_back({sample.text("id"), sample.textOr("setup", sample.text("id")),
                              sample.number("before_total"), sample.number("after_total")});
  });
  readAfter(json, report);
}

void readVerdict(JsonObject json, GapReport& report) {
  using enum gap::VerdictKind;
  report.verdict = {.kind = kindOf(json, {kNone, kEffect, kParameter, kReference, kUnknown}),
                    .names = json.texts("names"),
                    .confidence = json.numberOr("confidence", 0.0),
                    .indistinguishable_from = json.texts("indistinguishable_from"),
                    .beside = json.texts("beside"),
                    .limits = json.texts("limits"),
                    .text = json.textOr("text", "")};
}

gap::Law readLaw(JsonObject& json) {
  gap::Law law;
  law.measurand = json.text("measurand");
  law.component = json.text("component");
  law.unit = json.textOr("unit", "");
  law.relative = json.flagOr("relative", false);
  law.constant = json.numberOr("constant", 0.0);
  law.explained = json.numberOr("explained", 0.0);
  eachOf(json, "terms", [&](JsonObject& term) {
    law.terms.push_back({term.text("covariate"), term.text("function"), term.number("coefficient"),
                         term.numberOr("period", 0.0), term.numberOr("zero", 0.0)});
  });
  return law;
}

gap::Rest readRest(JsonObject json) {
  gap::Rest rest{.left = json.number("left"), .systematic = json.number("systematic"), .laws = {}};
  eachOf(json, "laws", [&](JsonObject& law) { rest.laws.push_back(readLaw(law)); });
  return rest;
}

gap::Approximation readApproximation(JsonObject json) {
  return {.proxy = json.textOr("proxy", ""),
          .proxy_gap = json.numberOr("proxy_gap", 0.0),
          .noise = json.numberOr("noise", 0.0),
          .gap = json.numberOr("gap", 0.0),
          .ratio = json.number("ratio"),
          .text = json.text("text")};
}

}  // namespace

double ReportedGap::weight() const {
  if (isExistence(name)) return gap::kExistenceWeight * bias;
  return resolution > 0.0 ? (std::abs(bias) + scatter) / resolution : 0.0;
}

std::vector<const gap::Cause*> GapReport::namedEffects() const {
  std::vector<const gap::Cause*> named;
  if (verdict.kind != gap::VerdictKind::kEffect) return named;
  for (const gap::Cause& cause : causes) {
    const bool is_named = std::ranges::find(verdict.names, cause.name) != verdict.names.end();
    if (cause.kind == gap::CauseKind::kEffect && is_named) named.push_back(&cause);
  }
  return named;
}

GapReport readGapReport(const std::filesystem::path& file) { return parseGapReport(core::readJson(file), file); }

GapReport parseGapReport(const nlohmann::json& json, const std::filesystem::path& file) {
  GapReport report;
  report.file = file;
  if (std::filesystem::exists(file)) report.sha256 = core::sha256OfFile(file);
  JsonObject object(json, file);
  object.expectFormat("fidelis-gap", 1);
  nlohmann::json content = json;
  content.erase("elapsed_s");
  report.evidence = core::sha256(content.dump());
  report.experiment = object.text("experiment");
  report.model = object.text("model");
  report.synthetic = object.flagOr("synthetic", false);
  readGap(object.object("gap"), report);
  eachOf(object, "where", [&](JsonObject& place) { report.where.push_back(readPlace(place)); });
  readVerdict(object.object("verdict"), report);
  if (object.has("approximation")) report.approximation = readApproximation(object.object("approximation"));
  report.notes = object.texts("notes");
  eachOf(object, "causes", [&](JsonObject& cause) { report.causes.push_back(readCause(cause)); });
  if (object.has("shrink")) readShrink(object.object("shrink"), report);
  if (object.has("rest")) report.rest = readRest(object.object("rest"));
  if (object.has("next_experiment")) {
    JsonObject next = object.object("next_experiment");
    report.next_experiment = next.textOr("text", "");
  }
  eachOf(object, "acceptance_flips", [&](JsonObject& flip) {
    report.flips.push_back({.id = flip.text("test"),
                            .title = flip.textOr("title", ""),
                            .measurand = flip.textOr("measurand", ""),
                            .before = flip.text("before"),
                            .after = flip.text("after"),
                            .text_before = flip.textOr("text_before", ""),
                            .text_after = flip.textOr("text_after", "")});
  });
  if (object.has("proposed_model")) report.proposed_model = object.raw("proposed_model");
  return report;
}

}  // namespace proposals
