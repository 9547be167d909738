#include "gap/report/json.h"

#include "core/version.h"
#include "gap/report/rest_wording.h"
#include "gap/report/wording.h"

namespace gap {

using Json = nlohmann::ordered_json;

namespace {

Json toJson(const Interval& interval) { return Json::array({interval.low, interval.high}); }
Json toJson(const std::optional<Interval>& interval) { return interval ? toJson(*interval) : Json(nullptr); }

Json stratumJson(const WhereRow& row) { return row.numeric ? Json::array({row.low, row.high}) : Json(row.names); }

Json toJson(const WhereRow& row) {
  return {{"measurand", row.measurand},  {"component", row.component}, {"covariate", row.covariate},
          {"stratum", stratumJson(row)}, {"value", row.value},         {"unit", row.unit},
          {"share", row.share},          {"size", row.size},           {"p_value", row.p_value},
          {"text", whereSentence(row)}};
}

Json gapJson(const Diagnosis& diagnosis) {
  Json measurands = Json::array();
  for (const MeasurandGap& m : diagnosis.before.measurands) {
    const auto interval = diagnosis.bias_intervals.find(m.name);
    Json entry = {{"name", m.name}, {"unit", m.unit}, {"d_bias", m.d_bias}, {"d_cavm", m.d_cavm}};
    entry["resolution"] = m.resolution;
    entry["interval"] = Json::object();
    if (interval != diagnosis.bias_intervals.end()) entry["interval"]["d_bias"] = toJson(interval->second);
    measurands.push_back(entry);
  }
  return {
      {"present", diagnosis.present},
      {"p_value", diagnosis.p_value},
      {"measurands", measurands},
      {"existence",
       {{"missing_fraction", diagnosis.before.missing_fraction}, {"extra_fraction", diagnosis.before.extra_fraction}}},
      {"total", diagnosis.before.total}};
}

Json toJson(const FittedParameter& p) {
  return {{"value", p.value}, {"interval", toJson(p.interval)}, {"unit", p.unit}};
}

Json toJson(const Cause& cause) {
  Json parameters = Json::object();
  for (const FittedParameter& p : cause.parameters) parameters[p.name] = toJson(p);
  Json json = {{"kind", toString(cause.kind)},
               {"name", cause.name},
               {"percollect", cause.percollect},
               {"confidence", cause.confidence},
               {"parameters", parameters},
               {"shrink", {{"fraction", cause.shrink.fraction}, {"interval", toJson(cause.shrink.interval)}}},
               {"explained", cause.explained},
               {"chain", cause.chain}};
  if (!cause.chain_titles.empty()) json["chain_titles"] = cause.chain_titles;
  if (!cause.variant.empty()) json["variant"] = cause.variant;
  if (!cause.sensors.empty()) json["sensors"] = cause.sensors;
  for (const auto& [setup, p] : cause.setups) json["setups"][setup] = toJson(p);
  return json;
}

Json toJson(const Approximation& a) {
  return {{"text", a.text}, {"proxy", a.proxy}, {"proxy_gap", a.proxy_gap}, {"noise", a.noise},
          {"gap", a.gap},   {"ratio", a.ratio}, {"reliable", a.reliable()}};
}

Json shrinkJson(const Diagnosis& diagnosis) {
  Json measurands = Json::array();
  for (const MeasurandGap& before : diagnosis.before.measurands) {
    for (const MeasurandGap& after : diagnosis.after->measurands) {
      if (after.name != before.name) continue;
      measurands.push_back({{"name", before.name},
                            {"before", {{"d_bias", before.d_bias}, {"d_cavm", before.d_cavm}}},
                            {"after", {{"d_bias", after.d_bias}, {"d_cavm", after.d_cavm}}}});
    }
  }
  const auto existence = [](const TotalGap& gap) -> Json {
    return {{"missing_fraction", gap.missing_fraction}, {"extra_fraction", gap.extra_fraction}};
  };
  Json samples = Json::array();
  for (const SampleTotals& s : diagnosis.held_out_totals) {
    samples.push_back({{"id", s.sample}, {"setup", s.setup}, {"before_total", s.before}, {"after_total", s.after}});
  }
  return {{"fraction", diagnosis.shrink.fraction},
          {"interval", toJson(diagnosis.shrink.interval)},
          {"held_out_samples", diagnosis.held_out},
          {"half_of_the_beams_fitted", diagnosis.weak_hold_out},
          {"before_total", diagnosis.before.total},
          {"after_total", diagnosis.after->total},
          {"measurands", measurands},
          {"existence", {{"before", existence(diagnosis.before)}, {"after", existence(*diagnosis.after)}}},
          {"samples", samples}};
}

Json toJson(double before_total, const AsRun::Corrected& corrected) {
  return {{"fraction", corrected.shrink.fraction},
          {"interval", toJson(corrected.shrink.interval)},
          {"before_total", before_total},
          {"after_total", corrected.after_total}};
}

Json toJson(const VerdictEvidence& evidence) {
  return {{"explained", evidence.explained},
          {"total_left", evidence.total_left},
          {"lead", evidence.lead},
          {"gap_z", evidence.gap_z}};
}

Json toJson(const Law& law) {
  Json terms = Json::array();
  for (const Law::Term& term : law.terms) {
    terms.push_back({{"covariate", term.covariate}, {"function", term.function}, {"coefficient", term.coefficient}});
    if (term.period > 0.0) terms.back().update({{"period", term.period}, {"zero", term.zero}});
  }
  return {{"measurand", law.measurand}, {"component", law.component}, {"unit", law.unit},
          {"relative", law.relative},   {"constant", law.constant},   {"terms", terms},
          {"explained", law.explained}, {"text", formulaOf(law)}};
}

Json toJson(const Rest& rest) {
  Json laws = Json::array();
  for (const Law& law : rest.laws) laws.push_back(toJson(law));
  return {{"left", rest.left}, {"systematic", rest.systematic}, {"ceiling", rest.ceiling()}, {"laws", laws}};
}

Json flipsJson(const std::vector<TwiceJudgedTest>& tests) {
  Json flips = Json::array();
  for (const TwiceJudgedTest& test : tests) {
    if (!test.flips()) continue;
    flips.push_back({{"test", test.id},
                     {"title", test.title},
                     {"measurand", test.measurand},
                     {"before", test.before},
                     {"after", test.after},
                     {"text_before", test.text_before},
                     {"text_after", test.text_after}});
  }
  return flips;
}

Json predictionsJson(const NextExperiment& next) {
  Json predictions = Json::array();
  for (const Prediction& p : next.predictions) {
    predictions.push_back({{"measurand", p.measurand},
                           {"unit", p.unit},
                           {"beams", p.beams},
                           {"noise", p.noise},
                           {"model_as_it_is", p.values[0]},
                           {next.separates[0], p.values[1]},
                           {next.separates[1], p.values[2]}});
  }
  return predictions;
}

}  // namespace

Json reportJson(const Diagnosis& diagnosis) {
  Json where = Json::array();
  for (const WhereRow& row : diagnosis.where) where.push_back(toJson(row));
  if (!diagnosis.present) where = Json::array();
  for (std::size_t i = 0; i < where.size(); ++i) {
    where[i]["decomposition_block"] =
        diagnosis.verdict.kind == VerdictKind::kEffect ? diagnosis.causes.front().decomposition_block : "";
  }
  Json causes = Json::array();
  for (const Cause& cause : diagnosis.causes) causes.push_back(toJson(cause));
  Json report = {{"format", "fidelis-gap"},
                 {"version", 1},
                 {"fidelis_version", core::kVersion},
                 {"experiment", diagnosis.experiment},
                 {"model", diagnosis.model},
                 {"synthetic", diagnosis.synthetic},
                 {"gap", gapJson(diagnosis)},
                 {"where", where},
                 {"verdict",
                  {{"kind", toString(diagnosis.verdict.kind)},
                   {"names", diagnosis.verdict.names},
                   {"beside", diagnosis.verdict.beside},
                   {"confidence", diagnosis.verdict.confidence},
                   {"indistinguishable_from", diagnosis.verdict.indistinguishable_from},
                   {"evidence", toJson(diagnosis.verdict.evidence)},
                   {"limits", diagnosis.verdict.limits},
                   {"text", diagnosis.verdict.text}}},
                 {"causes", causes}};
  if (const auto& pair = diagnosis.verdict.nearest_pair)
    report["verdict"]["nearest_pair"] = {{"names", pair->names}, {"explained", pair->explained}};
  report["shrink"] = diagnosis.after ? shrinkJson(diagnosis) : Json(nullptr);
  if (const auto& as_run = diagnosis.as_run; as_run && as_run->corrected)
    report["shrink"]["as_run"] = toJson(as_run->before_total, *as_run->corrected);
  report["next_experiment"] = nullptr;
  if (diagnosis.next_experiment) {
    report["next_experiment"] = {{"text", diagnosis.next_experiment->text},
                                 {"separates", diagnosis.next_experiment->separates},
                                 {"parameters", diagnosis.next_experiment->parameters},
                                 {"predictions", predictionsJson(*diagnosis.next_experiment)}};
  }
  if (diagnosis.rest) report["rest"] = toJson(*diagnosis.rest);
  if (diagnosis.approximation) report["approximation"] = toJson(*diagnosis.approximation);
  report["notes"] = diagnosis.notes;
  if (diagnosis.acceptance_tests) report["acceptance_flips"] = flipsJson(*diagnosis.acceptance_tests);
  // Of a model that is not ours it would be the proxy's.
  const bool ours = !diagnosis.approximation && !diagnosis.proposed_model.is_null();
  if (ours) report["proposed_model"] = diagnosis.proposed_model;
  report["confusion"] = {{"names", diagnosis.confusion.names}, {"alike", diagnosis.confusion.alike}};
  report["elapsed_s"] = diagnosis.elapsed_s;
  return report;
}

}  // namespace gap
