#include "specs/documents.h"

#include <nlohmann/json.hpp>

#include "core/json_object.h"
#include "specs/fields.h"
#include "specs/lists.h"

namespace specs {

namespace {

constexpr DocumentFormat kFormats[] = {
    {"html", "One self-contained, linked page", false, writeHtml},
    {"xlsx", "A workbook with one sheet a list", false, writeXlsx},
    {"csv", "A folder with one CSV a list, to edit and import again", true, writeLists},
    {"json", "Everything as one JSON file, for scripts", false, writeJsonDump},
};

template <class T>
nlohmann::ordered_json listJson(const std::vector<T>& items) {
  auto list = nlohmann::ordered_json::array();
  for (const T& item : items) {
    nlohmann::ordered_json one;
    for (const Field<T>& field : fieldsOf<T>()) one[std::string(field.name)] = field.get(item);
    list.push_back(std::move(one));
  }
  return list;
}

nlohmann::ordered_json scoreJson(const cepra::Score& score) {
  return {{"value", score.value ? nlohmann::ordered_json(*score.value) : nlohmann::ordered_json()},
          {"rationale", score.rationale},
          {"expert", score.expert}};
}

nlohmann::ordered_json rowJson(const cepra::Row& row) {
  auto effects = nlohmann::ordered_json::array();
  for (const auto& effect : row.effects) effects.push_back({{"id", effect.id}, {"title", effect.title}});
  auto causes = nlohmann::ordered_json::array();
  for (const auto& cause : row.causes) {
    causes.push_back(
        {{"id", cause.id}, {"title", cause.title}, {"kind", std::string(percollect::toString(cause.kind))}});
  }
  return {{"key", row.key},
          {"effects", effects},
          {"causes", causes},
          {"occurrence", scoreJson(row.occurrence)},
          {"impact", scoreJson(row.impact)},
          {"relevance", row.relevance() ? nlohmann::ordered_json(*row.relevance()) : nlohmann::ordered_json()},
          {"suspect", row.suspect},
          {"gone", row.gone},
          {"notes", row.notes}};
}

}  // namespace

std::span<const DocumentFormat> documentFormats() { return kFormats; }

void writeJsonDump(const Specification& specification, const std::filesystem::path& file) {
  nlohmann::ordered_json links = nlohmann::ordered_json::array();
  for (const Link& link : specification.links) {
    links.push_back({{"from", link.from}, {"to", link.to}, {"suspect", link.suspect}});
  }
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const cepra::Row& row : specification.cepra.rows) rows.push_back(rowJson(row));
  nlohmann::ordered_json verdicts = nlohmann::ordered_json::object();
  for (const auto& [test, verdict] : specification.verdicts) verdicts[test] = std::string(name(verdict.verdict));
  core::writeJson(file, nlohmann::ordered_json{{"format", "fidelis-specification"},
                                               {"version", 1},
                                               {"project", specification.project},
                                               {"requirements", listJson(specification.requirements)},
                                               {"acceptance_tests", listJson(specification.tests)},
                                               {"experiment_data", listJson(specification.experiment_data)},
                                               {"reference_data", listJson(specification.reference_data)},
                                               {"links", links},
                                               {"cepra", rows},
                                               {"latest_verdicts", verdicts}});
}

}  // namespace specs
