#include "specs/rules.h"

#include <algorithm>
#include <set>

#include "cepra/check.h"
#include "specs/shown_id.h"
#include "specs/trace.h"

namespace specs {

namespace {

/// What a rule sees, and how it reports.
struct Check {
  const Specification& spec;
  const LinkIndex& index;
  const RuleOptions& options;
  const Rule& rule;
  std::vector<RuleFinding>& findings;

  void report(const std::string& item, const std::string& text, const std::string& remedy) const {
    findings.push_back({std::string(rule.uid), rule.severity, item, text, remedy});
  }
  [[nodiscard]] bool hasFollower(std::string_view id, Kind kind) const {
    const auto followers = index.allFollowersOf(id);
    return std::any_of(followers.begin(), followers.end(), [&](const std::string& follower) {
      const Entry* entry = index.find(follower);
      return entry && entry->kind == kind && entry->status != Status::Rejected;
    });
  }
  [[nodiscard]] bool hasOrigin(std::string_view id, Kind kind) const {
    const auto& origins = index.originsOf(id);
    return std::any_of(origins.begin(), origins.end(), [&](const Link& link) {
      const Entry* entry = index.find(link.from);
      return entry && entry->kind == kind;
    });
  }
  void eachItem(const auto& see) const {
    for (const Item& item : spec.requirements) see(item);
    for (const Item& item : spec.tests) see(item);
    for (const Item& item : spec.experiment_data) see(item);
    for (const Item& item : spec.reference_data) see(item);
  }
};

bool counts(const Item& item) { return item.status != Status::Rejected; }

// Identity and links. The project file admits none of these breaches; lists that people edit do.

void idIsValid(const Check& check) {
  check.eachItem([&](const Item& item) {
    if (!isShownId(item.id)) check.report(item.id, "is no valid id.", "Use <Phenomenon>_<Causes>_<No.>.");
  });
}

void idIsUnique(const Check& check) {
  std::set<std::string> seen;
  check.eachItem([&](const Item& item) {
    if (!seen.insert(item.id).second) check.report(item.id, "is the id of two items.", "Give one the next number.");
  });
}

void linkHasTwoEnds(const Check& check) {
  for (const Link& link : check.spec.links) {
    const std::string name = link.from + " -> " + link.to;
    for (const std::string& end : {link.from, link.to}) {
      if (!check.index.find(end))
        check.report(name, "'" + end + "' does not exist.", "Correct the id or remove the link.");
    }
  }
}

void linkLeadsOn(const Check& check) {
  for (const Link& link : check.spec.links) {
    const Entry* from = check.index.find(link.from);
    const Entry* to = check.index.find(link.to);
    if (from && to && !mayLink(from->kind, to->kind)) {
      check.report(link.from + " -> " + link.to,
                   "leads from " + std::string(name(from->kind)) + " to " + std::string(name(to->kind)) + ".",
                   "Turn it round or remove it.");
    }
  }
}

void linksFormNoCircle(const Check& check) {
  for (const Link& link : check.spec.links) {
    const auto back = check.index.allFollowersOf(link.to);
    if (link.from == link.to || std::find(back.begin(), back.end(), link.from) != back.end()) {
      check.report(link.from + " -> " + link.to, "is part of a circle.", "Remove one of its links.");
    }
  }
}

// Completeness.

void acceptedRequirementIsTested(const Check& check) {
  for (const Requirement& requirement : check.spec.requirements) {
    if (requirement.status == Status::Accepted && !check.hasFollower(requirement.id, Kind::AcceptanceTest)) {
      check.report(requirement.id, "is accepted, but no test that counts follows from it.",
                   "Link an acceptance test to it or to a requirement that refines it.");
    }
  }
}

void testHasRequirement(const Check& check) {
  for (const AcceptanceTest& test : check.spec.tests) {
    if (counts(test) && !check.hasOrigin(test.id, Kind::Requirement)) {
      check.report(test.id, "is a test that no requirement asks for.", "Link it to the requirement that it verifies.");
    }
  }
}

void testHasExperimentData(const Check& check) {
  for (const AcceptanceTest& test : check.spec.tests) {
    if (counts(test) && !test.experiment.empty() && !check.hasFollower(test.id, Kind::ExperimentData)) {
      check.report(test.id, "uses measured data, but nothing says what the experiment must deliver.",
                   "Link an experiment data requirement.");
    }
  }
}

void testHasReferenceData(const Check& check) {
  for (const AcceptanceTest& test : check.spec.tests) {
    if (counts(test) && !test.experiment.empty() && !check.hasFollower(test.id, Kind::ReferenceData)) {
      check.report(test.id, "uses measured data, but nothing says what must be known of the truth, and how well.",
                   "Link a reference data requirement.");
    }
  }
}

void acceptedTestCanBeDecided(const Check& check) {
  for (const AcceptanceTest& test : check.spec.tests) {
    if (test.status == Status::Accepted && !test.experiment.empty() &&
        (test.expression.empty() || test.measurand.empty())) {
      check.report(test.id, "is accepted, but lacks its measurand or the expression that decides.",
                   "Fill in both, e.g. measurand range, accepted if abs(d_bias) <= 0.005 * range_m.");
    }
  }
}

void filesOfTestsExist(const Check& check) {
  if (check.options.folder.empty()) return;
  for (const AcceptanceTest& test : check.spec.tests) {
    for (const std::string& path : {test.experiment, test.model}) {
      if (counts(test) && !path.empty() && !std::filesystem::exists(check.options.folder / path)) {
        check.report(test.id, "names '" + path + "', which is not there.", "Paths begin at the folder of the project.");
      }
    }
  }
}

void textIsWritten(const Check& check) {
  check.eachItem([&](const Item& item) {
    if (counts(item) && item.text.empty()) check.report(item.id, "has no text.", "Write down what must hold.");
  });
}

void deviceIsNamed(const Check& check) {
  const auto see = [&](const auto& items) {
    for (const auto& item : items) {
      if (counts(item) && item.device.empty()) {
        check.report(item.id, "names no measurement device.", "Say with what it is measured.");
      }
    }
  };
  see(check.spec.experiment_data);
  see(check.spec.reference_data);
}

void uncertaintyIsNamed(const Check& check) {
  for (const ReferenceData& reference : check.spec.reference_data) {
    if (counts(reference) && reference.uncertainty.empty()) {
      check.report(reference.id, "does not say how well the truth must be known.",
                   "Give the uncertainty with its unit.");
    }
  }
}

// Agreement.

void acceptedDoesNotRestOnRejected(const Check& check) {
  for (const Link& link : check.spec.links) {
    const Entry* from = check.index.find(link.from);
    const Entry* to = check.index.find(link.to);
    if (!from || !to) continue;
    if (from->status == Status::Accepted && to->status == Status::Rejected) {
      check.report(link.from, "is accepted, but " + link.to + ", which follows from it, is rejected.",
                   "Replace or remove the link.");
    } else if (from->status == Status::Rejected && to->status == Status::Accepted) {
      check.report(link.to, "is accepted, but follows from " + link.from + ", which is rejected.",
                   "Reject it too, or link it to what it now follows from.");
    }
  }
}

void linkIsReviewed(const Check& check) {
  for (const Link& link : check.spec.links) {
    if (link.suspect) {
      check.report(link.from + " -> " + link.to, "is suspect: one end has changed.",
                   "Look at both ends and confirm it.");
    }
  }
}

// Relevance.

void relevantRowHasRequirement(const Check& check) {
  for (const cepra::Row& row : check.spec.cepra.rows) {
    const auto relevance = row.relevance();
    if (relevance && *relevance >= check.options.relevant_from && !row.gone &&
        check.index.followersOf(row.key).empty()) {
      check.report(row.key, rowTitle(row) + " has relevance " + std::to_string(*relevance) + ", but no requirement.",
                   "Write one, or lower the scores and say why.");
    }
  }
}

void requirementIsOfALivingRow(const Check& check) {
  for (const cepra::Row& row : check.spec.cepra.rows) {
    if (!row.gone) continue;
    for (const Link& link : check.index.followersOf(row.key)) {
      check.report(link.to, "follows from row " + row.key + " (" + rowTitle(row) + "), which the graph no longer has.",
                   "Link it to a row of the present release.");
    }
  }
}

void detectionRequirementHasOrigin(const Check& check) {
  for (const Requirement& requirement : check.spec.requirements) {
    if (counts(requirement) && requirement.level != Level::General && check.index.originsOf(requirement.id).empty()) {
      check.report(requirement.id, "does not say why it matters.", "Link it to a CEPRA row or a requirement above it.");
    }
  }
}

void scoresAreComplete(const Check& check) {
  for (const cepra::Finding& finding : cepra::check(check.spec.cepra)) {
    if (finding.severity == Severity::Note) continue;
    check.findings.push_back({std::string(check.rule.uid), finding.severity, finding.row,
                              (finding.column.empty() ? "" : finding.column + ": ") + finding.text, finding.remedy});
  }
}

struct CheckedRule {
  Rule rule;
  void (*run)(const Check&);
};

// A rule is one function and one line here.
constexpr CheckedRule kRules[] = {
    {{"id-format", Severity::Error, "ids are <Phenomenon>_<Causes>_<No.>"}, idIsValid},
    {{"id-doubled", Severity::Error, "every id is used once"}, idIsUnique},
    {{"link-dangling", Severity::Error, "both ends of a link exist"}, linkHasTwoEnds},
    {{"link-direction", Severity::Error, "links lead from row to requirement to test to data"}, linkLeadsOn},
    {{"link-circle", Severity::Error, "nothing follows from itself"}, linksFormNoCircle},
    {{"requirement-untested", Severity::Error, "an accepted requirement has a test"}, acceptedRequirementIsTested},
    {{"test-without-requirement", Severity::Error, "a test verifies a requirement"}, testHasRequirement},
    {{"test-without-experiment-data", Severity::Error, "a test on measured data says what must be measured"},
     testHasExperimentData},
    {{"test-without-reference-data", Severity::Error, "a test on measured data says what the truth is"},
     testHasReferenceData},
    {{"test-undecidable", Severity::Error, "an accepted test can be decided"}, acceptedTestCanBeDecided},
    {{"test-file-missing", Severity::Error, "the files of a test are there"}, filesOfTestsExist},
    {{"accepted-on-rejected", Severity::Warning, "nothing accepted rests on something rejected"},
     acceptedDoesNotRestOnRejected},
    {{"text-missing", Severity::Warning, "every item has a text"}, textIsWritten},
    {{"device-missing", Severity::Warning, "data requirements name the measurement device"}, deviceIsNamed},
    {{"uncertainty-missing", Severity::Warning, "reference data have an uncertainty"}, uncertaintyIsNamed},
    {{"link-suspect", Severity::Warning, "links are reviewed after a change"}, linkIsReviewed},
    {{"row-without-requirement", Severity::Warning, "a relevant row has a requirement"}, relevantRowHasRequirement},
    {{"row-gone", Severity::Warning, "requirements follow from rows of the present graph"}, requirementIsOfALivingRow},
    {{"requirement-without-origin", Severity::Warning, "a requirement says why it matters"},
     detectionRequirementHasOrigin},
    {{"score", Severity::Warning, "scores have a rationale and an expert"}, scoresAreComplete},
};

}  // namespace

std::string toString(const RuleFinding& finding) {
  return finding.item + ": " + std::string(percollect::toString(finding.severity)) + ": " + finding.text + " " +
         finding.remedy + " [" + finding.rule + "]";
}

std::span<const Rule> allRules() {
  static const std::vector<Rule> kPlain = [] {
    std::vector<Rule> rules;
    for (const CheckedRule& checked : kRules) rules.push_back(checked.rule);
    return rules;
  }();
  return kPlain;
}

std::vector<RuleFinding> checkSpecification(const Specification& specification, const RuleOptions& options) {
  const LinkIndex index(specification);
  std::vector<RuleFinding> findings;
  for (const CheckedRule& checked : kRules) checked.run({specification, index, options, checked.rule, findings});
  return findings;
}

}  // namespace specs
