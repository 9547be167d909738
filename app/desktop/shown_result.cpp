#include "app/desktop/shown_result.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.h"

namespace desktop {

namespace {

constexpr int kDigits = 4;

std::string number(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? core::significant(found->get<double>(), kDigits) : "";
}

double room(const nlohmann::json& relation) {
  const auto value = [&](const char* key) {
    const auto found = relation.find(key);
    return found != relation.end() && found->is_number() ? found->get<double>() : -1.0;
  };
  return value("margin") / std::max(std::abs(value("limit")), 1e-12);
}

std::string word(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

void readSample(const nlohmann::json& json, ShownResult& result) {
  const std::size_t index = result.samples.size();
  result.samples.push_back({.id = word(json, "id"),
                            .verdict = specs::verdictOf(word(json, "verdict")).value_or(specs::Verdict::Error),
                            .text = word(json, "text"),
                            .figure = word(json, "figure")});
  for (const auto& relation : json.value("relations", nlohmann::json::array())) {
    result.relations.push_back(
        {.sample = index,
         .text = word(relation, "left") + " " + word(relation, "order") + " " + word(relation, "right"),
         .value = number(relation, "value"),
         .limit = number(relation, "limit"),
         .margin = number(relation, "margin"),
         .holds = relation.value("holds", false),
         .room = room(relation)});
  }
}

/// What the store knows without the evaluation.
ShownResult plainResult(const specs::TestVerdict& verdict) {
  ShownResult result;
  for (const specs::SampleVerdict& sample : verdict.samples) {
    result.relations.push_back({.sample = result.samples.size(),
                                .value = sample.value ? core::significant(*sample.value, kDigits) : "",
                                .limit = sample.limit ? core::significant(*sample.limit, kDigits) : "",
                                .holds = sample.verdict == specs::Verdict::Passed});
    result.samples.push_back({.id = sample.sample, .verdict = sample.verdict, .text = sample.text});
  }
  return result;
}

}  // namespace

std::size_t ShownResult::decisive() const {
  const auto least = std::ranges::min_element(relations, {}, &ShownRelation::room);
  return least == relations.end() ? 0 : std::size_t(least - relations.begin());
}

ShownResult shownResult(const specs::TestVerdict& verdict) {
  const auto json = nlohmann::json::parse(verdict.evaluation, nullptr, false);
  if (!json.is_object() || !json.contains("samples")) return plainResult(verdict);
  try {
    ShownResult result;
    const auto experiment = json.value("experiment", nlohmann::json::object());
    result.experiment = word(experiment, "title");
    result.synthetic = experiment.value("synthetic", false);
    result.unit = word(json, "unit");
    for (const auto& sample : json.at("samples")) readSample(sample, result);
    return result;
  } catch (const nlohmann::json::exception&) {
    return plainResult(verdict);  // another version's keys
  }
}

}  // namespace desktop
