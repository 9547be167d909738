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

constexpr double kExistenceWeight = 100.0;  // formats.md section 6

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

std::optional<Range> rangeOf(JsonObject& object, const std::string& key) {
  if (!object.has(key)) return std::nullopt;
  const std::vector<double> ends = object.numbers(key, 2);
  return Range{ends[0], ends[1]};
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
    gap.bias_interval = rangeOf(interval, "d_bias");
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

std::string stratumText(const nlohmann::json& stratum) {
  std::vector<std::string> parts;
  bool numeric = true;
  for (const nlohmann::json& part : stratum) {
    numeric = numeric && part.is_number();
    parts.push_back(part.is_number() ? core::significant(part.get<double>(), 4) : part.get<std::string>());
  }
  if (numeric && parts.size() == 2) return parts[0] == parts[1] ? parts[0] : parts[0] + " to " + parts[1];
  return core::join(parts);
}

ReportedPlace readPlace(JsonObject& json) {
  ReportedPlace place;
  place.measurand = json.text("measurand");
  place.component = json.text("component");
  place.covariate = json.text("covariate");
  try {
    place.stratum = stratumText(json.raw("stratum"));
  } catch (const nlohmann::json::exception&) {
    json.fail("stratum", "is neither two numbers nor names.", "Write the report again with 'fidelis gap'.");
  }
  place.value = json.number("value");
  place.unit = json.textOr("unit", "");
  place.share = json.numberOr("share", 0.0);
  place.block = json.textOr("decomposition_block", "");
  place.text = json.textOr("text", "");
  return place;
}

void readParameters(JsonObject json, std::vector<ReportedParameter>& parameters) {
  for (const std::string& name : json.keys()) {
    JsonObject parameter = json.object(name);
    parameters.push_back(
        {name, parameter.textOr("unit", ""), parameter.number("value"), rangeOf(parameter, "interval")});
  }
}

ReportedCause readCause(JsonObject& json) {
  ReportedCause cause;
  cause.kind = json.text("kind");
  cause.name = json.text("name");
  cause.percollect = json.texts("percollect");
  cause.chain = json.texts("chain");
  cause.chain_titles = json.texts("chain_titles");
  cause.confidence = json.numberOr("confidence", 0.0);
  cause.explained = json.numberOr("explained", 0.0);
  if (json.has("parameters")) readParameters(json.object("parameters"), cause.parameters);
  if (json.has("setups")) readParameters(json.object("setups"), cause.parameters);
  if (json.has("shrink")) {
    JsonObject shrink = json.object("shrink");
    cause.shrink = shrink.numberOr("fraction", 0.0);
    cause.shrink_interval = rangeOf(shrink, "interval");
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
  report.shrink = json.number("fraction");
  report.shrink_interval = rangeOf(json, "interval");
  report.held_out = json.texts("held_out_samples");
  if (json.has("before_total") && json.has("after_total")) {
    report.totals = Range{json.number("before_total"), json.number("after_total")};
  }
  eachOf(json, "samples", [&](JsonObject& sample) {
    report.samples.push_back({sample.text("id"), sample.textOr("setup", sample.text("id")),
                              sample.number("before_total"), sample.number("after_total")});
  });
  readAfter(json, report);
}

void readVerdict(JsonObject json, GapReport& report) {
  report.verdict = json.choice("kind", {"none", "effect", "parameter", "reference", "unknown"});
  report.names = json.texts("names");
  report.confidence = json.numberOr("confidence", 0.0);
  report.indistinguishable_from = json.texts("indistinguishable_from");
  report.text = json.textOr("text", "");
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
  if (isExistence(name)) return kExistenceWeight * bias;
  return resolution > 0.0 ? (std::abs(bias) + scatter) / resolution : 0.0;
}

std::vector<const ReportedCause*> GapReport::namedEffects() const {
  std::vector<const ReportedCause*> named;
  if (verdict != "effect") return named;
  for (const ReportedCause& cause : causes) {
    if (cause.kind == "effect" && std::ranges::find(names, cause.name) != names.end()) named.push_back(&cause);
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
  if (object.has("next_experiment")) {
    JsonObject next = object.object("next_experiment");
    report.next_experiment = next.textOr("text", "");
  }
  eachOf(object, "acceptance_flips", [&](JsonObject& flip) {
    report.flips.push_back({flip.text("test"), flip.textOr("title", ""), flip.text("before"), flip.text("after"),
                            flip.textOr("text_after", "")});
  });
  if (object.has("proposed_model")) report.proposed_model = object.raw("proposed_model");
  return report;
}

}  // namespace proposals
