#include "acceptance/result_json.h"

#include <cmath>

namespace acceptance {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::map<std::string, double>& values) {
  Json object = Json::object();
  for (const auto& [name, value] : values) object[name] = number(value);
  return object;
}

Json relationJson(const Relation& relation) {
  return {{"left", relation.left},           {"order", symbol(relation.order)}, {"right", relation.right},
          {"value", number(relation.value)}, {"limit", number(relation.limit)}, {"margin", number(relation.margin())},
          {"holds", relation.holds}};
}

Json sampleJson(const SampleResult& sample, Figures figures) {
  Json object = {{"id", sample.id}, {"verdict", specs::name(sample.verdict)}, {"text", sample.text}};
  object["parameters"] = numbers(sample.parameters);
  object["n_real"] = sample.n_real;
  object["n_sim"] = sample.n_sim;
  object["values"] = numbers(sample.values);
  object["relations"] = Json::array();
  for (const Relation& relation : sample.relations) object["relations"].push_back(relationJson(relation));
  if (!sample.remarks.empty()) object["remarks"] = sample.remarks;
  if (figures == Figures::Included) object["figure"] = sample.figure;
  return object;
}

}  // namespace

Json toJson(const TestResult& test, Figures figures) {
  Json object = {{"id", test.test.id}, {"title", test.test.title}, {"requirements", Json::array()}};
  for (const specs::Requirement& requirement : test.requirements) object["requirements"].push_back(requirement.id);
  object["verdict"] = specs::name(test.verdict);
  object["text"] = test.text;
  object["experiment"] = {{"id", test.experiment_id},
                          {"title", test.experiment_title},
                          {"source", test.experiment_source},
                          {"synthetic", test.synthetic},
                          {"path", test.test.experiment}};
  object["model"] = {{"id", test.model_id}, {"path", test.model_file}};
  object["seed"] = test.seed;
  object["measurand"] = test.test.measurand;
  object["unit"] = test.unit;
  object["column"] = test.column;
  object["gate"] = test.test.gate;
  object["metric"] = test.test.metric;
  object["expression"] = test.test.expression;
  object["samples"] = Json::array();
  for (const SampleResult& sample : test.samples) object["samples"].push_back(sampleJson(sample, figures));
  object["used"] = Json::array();
  for (const specs::UsedFile& file : test.used)
    object["used"].push_back({{"path", file.path}, {"sha256", file.sha256}});
  return object;
}

Json toJson(const RunResult& run, Figures figures) {
  Json object = {{"format", "fidelis-acceptance"}, {"version", 1},
                 {"project", run.project},         {"program_version", run.program_version},
                 {"counts", Json::object()},       {"tests", Json::array()}};
  for (const specs::Verdict verdict :
       {specs::Verdict::Passed, specs::Verdict::Failed, specs::Verdict::Error, specs::Verdict::Skipped}) {
    object["counts"][std::string(specs::name(verdict))] = run.count(verdict);
  }
  for (const TestResult& test : run.tests) object["tests"].push_back(toJson(test, figures));
  return object;
}

}  // namespace acceptance
