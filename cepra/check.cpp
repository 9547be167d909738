#include "cepra/check.h"

#include <algorithm>

#include "core/error.h"

namespace cepra {

namespace {

class RowCheck {
 public:
  RowCheck(const Row& row, std::vector<Finding>& findings) : row_(row), findings_(findings) {}

  void run() {
    checkScore(row_.occurrence, "occurrence");
    checkScore(row_.impact, "impact");
    checkRoles();
    if (row_.isSuspect())
      add(Severity::Warning, "suspect", row_.suspect, "Confirm or correct it, then empty the cell.");
    if (row_.causes.empty() && !row_.gone) {
      add(Severity::Note, "", "the effect '" + row_.lastEffect().title + "' has no cause.",
          "Ask whether the graph lacks one; without a cause there is nothing to vary in a test.");
    }
  }

 private:
  void checkScore(const Score& score, const std::string& column) {
    if (!score.value) {
      if (!score.rationale.empty()) {
        add(Severity::Warning, column, "there is a rationale but no score.", "Give a score from 1 to 10.");
      }
      return;
    }
    if (*score.value < 1 || *score.value > 10) {
      add(Severity::Error, column, "the score is " + std::to_string(*score.value) + ".", "Give one from 1 to 10.");
    }
    if (score.rationale.empty()) {
      add(Severity::Warning, column + "_rationale", "the score has no rationale.", "Say why it is this number.");
    }
    if (score.expert.empty()) {
      add(Severity::Warning, column + "_expert", "the score has no expert.", "Say who gave it.");
    }
  }

  void checkRoles() {
    const bool has_occurrence = row_.occurrence.value.has_value();
    const bool has_impact = row_.impact.value.has_value();
    if (has_occurrence != has_impact) {
      add(Severity::Warning, has_occurrence ? "impact" : "occurrence",
          std::string("only the ") + (has_occurrence ? "occurrence" : "impact") +
              " is scored, so the row has no relevance.",
          has_occurrence ? "Ask who knows the system under test." : "Ask who knows the sensor and its surroundings.");
    } else if (has_occurrence && !row_.impact.expert.empty() && row_.impact.expert == row_.occurrence.expert) {
      add(Severity::Note, "impact_expert", "occurrence and impact were both scored by " + row_.impact.expert + ".",
          "Sensor and system under test are best judged by those who know them; let a second person look.");
    }
  }

  void add(Severity severity, const std::string& column, const std::string& text, const std::string& remedy) {
    findings_.push_back({.severity = severity, .row = row_.key, .column = column, .text = text, .remedy = remedy});
  }

  const Row& row_;
  std::vector<Finding>& findings_;
};

}  // namespace

std::string toString(const Finding& finding) {
  std::string item = finding.row.empty() ? "" : "row " + finding.row;
  if (!finding.column.empty()) item += (item.empty() ? "column " : ", column ") + finding.column;
  std::string text = core::toString({.file = finding.file, .line = finding.line, .item = item});
  if (!text.empty()) text += ": ";
  text += std::string(percollect::toString(finding.severity)) + ": " + finding.text;
  return finding.remedy.empty() ? text : text + " " + finding.remedy;
}

std::vector<Finding> check(const Table& table) {
  std::vector<Finding> findings;
  std::set<std::string> keys;
  std::size_t open = 0;
  for (const Row& row : table.rows) {
    if (!keys.insert(row.key).second) {
      findings.push_back({.severity = Severity::Error,
                          .row = row.key,
                          .column = "key",
                          .text = "the key is used twice.",
                          .remedy = "Build the table again from its graph."});
    }
    RowCheck(row, findings).run();
    if (!row.gone && !row.isScored()) ++open;
  }
  if (open > 0) {
    findings.push_back(
        {.severity = Severity::Note,
         .text = std::to_string(open) + " of " + std::to_string(table.rows.size()) + " rows have no relevance yet.",
         .remedy = "Score their occurrence and impact."});
  }
  return findings;
}

}  // namespace cepra
