#include "proposals/propose.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "core/error.h"
#include "core/json_object.h"
#include "core/text.h"
#include "gap/chain.h"
#include "model/experiment.h"
#include "proposals/occurrence.h"
#include "proposals/separating_test.h"
#include "specs/trace.h"

namespace proposals {

namespace {

namespace fs = std::filesystem;

std::string percent(double share) { return core::significant(100.0 * share, 3) + " %"; }

/// Ids of the nodes that a cause stands for in the project's graph. A chain in the report helps only if it comes from
/// the same graph: id and title of its first node agree.
std::set<std::string> nodesFor(const gap::Cause& cause, const percollect::Graph& graph) {
  std::set<std::string> ids;
  for (const std::size_t node : gap::nodesOf(graph, cause.name, cause.percollect)) ids.insert(graph.node(node).id);
  if (!ids.empty() || cause.chain.empty() || cause.chain_titles.empty()) return ids;
  const auto node = graph.find(cause.chain.front());
  if (node && graph.node(*node).title == cause.chain_titles.front()) ids.insert(cause.chain.front());
  return ids;
}

bool endsAt(const cepra::Row& row, const std::set<std::string>& nodes) {
  return nodes.contains(row.lastEffect().id) ||
         std::ranges::any_of(row.causes, [&](const cepra::Cause& cause) { return nodes.contains(cause.id); });
}

bool runsThrough(const cepra::Row& row, const std::set<std::string>& nodes) {
  return std::ranges::any_of(row.effects, [&](const cepra::Effect& effect) { return nodes.contains(effect.id); });
}

/// The report's chain runs from the cause up to the phenomenon, a row's path down.
bool isChain(const cepra::Row& row, const std::vector<std::string>& chain) {
  return std::ranges::equal(row.effects, std::vector(chain.rbegin(), chain.rend()), {}, &cepra::Effect::id);
}

std::string evidenceText(const GapReport& report, const gap::Cause& cause) {
  std::string text =
      fmt::format("Diagnosis of {} with model {}: {}", report.experiment, report.model, report.verdict.text);
  text += fmt::format(" Held-out shrink {}", percent(cause.shrink.fraction));
  const gap::Interval& interval = cause.shrink.interval;
  if (interval.low < interval.high) text += fmt::format(" [{}, {}]", percent(interval.low), percent(interval.high));
  for (const gap::FittedParameter& p : cause.parameters) {
    text += fmt::format("; {} = {}", p.name, core::significant(p.value, 4));
    if (p.interval) {
      text += fmt::format(" [{}, {}]", core::significant(p.interval->low, 4), core::significant(p.interval->high, 4));
    }
    if (!p.unit.empty()) text += " " + p.unit;
  }
  text += ".";
  if (!report.verdict.indistinguishable_from.empty()) {
    text += " Not to be told from " + core::join(report.verdict.indistinguishable_from, " or ") + ".";
  }
  if (report.synthetic) text += " Synthetic data.";
  return text;
}

std::string sourceText(const GapReport& report) {
  constexpr std::size_t kShown = 16;  // of 64 digits; the proposal keeps all
  const std::string name = report.file.filename().generic_string();
  return report.sha256.empty() ? "" : fmt::format(" Report {}, SHA-256 {}….", name, report.sha256.substr(0, kShown));
}

specs::Proposal emptyProposal(const GapReport& report, const std::string& cause) {
  specs::Proposal proposal;
  proposal.cause = cause;
  proposal.experiment = report.experiment;
  proposal.model = report.model;
  proposal.report = report.file.generic_string();
  proposal.report_sha256 = report.sha256;
  proposal.evidence = report.evidence;
  return proposal;
}

specs::Proposal rowProposal(const GapReport& report, const gap::Cause& cause, const cepra::Row& row) {
  const ProposedOccurrence occurrence = occurrenceFor(report, cause, row);
  specs::Proposal proposal = emptyProposal(report, cause.name);
  proposal.row = row.key;
  proposal.occurrence = occurrence.value;
  proposal.before = row.occurrence;
  proposal.rationale = evidenceText(report, cause) + " " + occurrence.text() + sourceText(report);
  return proposal;
}

/// A path as tests hold it: relative to the project where it lies beside or below it.
std::string storedPath(const fs::path& path, const fs::path& folder) {
  const fs::path whole = fs::weakly_canonical(fs::absolute(path));
  const fs::path relative = whole.lexically_relative(fs::weakly_canonical(fs::absolute(folder)));
  return relative.empty() || *relative.begin() == ".." ? whole.generic_string() : relative.generic_string();
}

/// The `id` in a JSON file, or "" if it cannot be read: then another file is looked at.
std::string idOf(const fs::path& file) {
  try {
    return core::readJson(file).value("id", "");
  } catch (const std::exception&) {
    return "";
  }
}

std::string knownExperiment(const GapReport& report, const Project& project) {
  std::vector<std::string> packages;
  for (const auto& test : project.specification.tests) packages.push_back(test.experiment);
  for (const auto& data : project.specification.experiment_data) packages.push_back(data.experiment);
  for (const std::string& package : packages) {
    const fs::path path = project.folder / package;
    if (package.empty()) continue;
    if (idOf(fs::is_directory(path) ? path / "experiment.json" : path) == report.experiment) return package;
  }
  return "";
}

std::string knownModel(const GapReport& report, const Project& project) {
  for (const auto& test : project.specification.tests) {
    if (!test.model.empty() && idOf(project.folder / test.model) == report.model) return test.model;
  }
  return "";
}

/// A file that somebody named must be the one of the report.
void requireId(const std::string& wanted, const std::string& found, const fs::path& file, const char* what) {
  if (wanted == found) return;
  throw core::InputError({.file = file}, fmt::format("the {} is '{}', the report is of '{}'.", what, found, wanted),
                         "Name the one that was diagnosed.");
}

/// What is missing to propose a test, or "".
std::string findSources(const GapReport& report, const Project& project, const Sources& sources, Bound& bound) {
  bound.folder = project.folder;
  bound.experiment =
      sources.experiment ? storedPath(*sources.experiment, project.folder) : knownExperiment(report, project);
  bound.model = sources.model ? storedPath(*sources.model, project.folder) : knownModel(report, project);
  if (sources.experiment) {
    requireId(report.experiment, model::readExperiment(*sources.experiment).id, *sources.experiment, "experiment");
  }
  if (sources.model) requireId(report.model, model::readModel(*sources.model).id, *sources.model, "model");
  if (bound.experiment.empty()) {
    return fmt::format("no acceptance test of the project names an experiment '{}'; name its package",
                       report.experiment);
  }
  if (bound.model.empty()) {
    return fmt::format("no acceptance test of the project names a model '{}'; name its file", report.model);
  }
  if (!report.proposed_model.is_null()) {
    bound.after = model::parseModel(report.proposed_model, project.folder / bound.model);
  }
  return "";
}

/// What a test speaks about: a measurand, or which echoes there are.
std::string subjectOf(const specs::AcceptanceTest& test) {
  return test.expression.find("_fraction") == std::string::npos ? test.measurand : "existence";
}

/// Those of the requirements that a test of the same subject verifies already; all if there is none.
std::vector<std::string> ofSameSubject(const std::set<std::string>& requirements, const specs::AcceptanceTest& test,
                                       const specs::Specification& specification) {
  std::vector<std::string> same;
  for (const std::string& requirement : requirements) {
    const bool verified = std::ranges::any_of(specification.tests, [&](const specs::AcceptanceTest& other) {
      const auto links = [&](const specs::Link& link) { return link.from == requirement && link.to == other.id; };
      return subjectOf(other) == subjectOf(test) && std::ranges::any_of(specification.links, links);
    });
    if (verified) same.push_back(requirement);
  }
  return same.empty() ? std::vector(requirements.begin(), requirements.end()) : same;
}

std::string alreadyCaught(const GapReport& report) {
  std::vector<std::string> tests;
  for (const gap::TwiceJudgedTest& flip : report.flips) {
    if (flip.before == "failed" && flip.after == "passed") tests.push_back(flip.id);
  }
  return tests.empty() ? "" : " Of the project's own tests, " + core::join(tests) + " caught it too.";
}

void proposeTest(const GapReport& report, const Project& project, const Sources& sources, core::Progress& progress,
                 Proposed& proposed) {
  Bound bound;
  const std::string missing = findSources(report, project, sources, bound);
  if (!missing.empty()) {
    proposed.notes.push_back("no acceptance test is proposed: " + missing + ".");
    return;
  }
  const auto separating = separatingTest(report, bound, progress);
  if (!separating) {
    proposed.notes.emplace_back(
        "no acceptance test is proposed: no limit separates the model as it was from the model with the cause on the "
        "held-out samples.");
    return;
  }
  std::set<std::string> requirements;
  for (const gap::Cause* cause : report.namedEffects()) {
    std::vector<std::string> rows;
    for (const std::size_t row : rowsOf(*cause, project)) rows.push_back(project.specification.cepra.rows[row].key);
    for (std::string& id : requirementsFor(rows, cause->name, project.specification))
      requirements.insert(std::move(id));
  }
  specs::Proposal proposal = emptyProposal(report, core::join(report.verdict.names, ", "));
  proposal.test = separating->test;
  proposal.requirements = ofSameSubject(requirements, *proposal.test, project.specification);
  proposal.rationale = separating->test.rationale + alreadyCaught(report) + sourceText(report);
  proposal.test->rationale = proposal.rationale;
  proposed.proposals.push_back(std::move(proposal));
}

}  // namespace

std::vector<std::size_t> rowsOf(const gap::Cause& cause, const Project& project) {
  const auto& rows = project.specification.cepra.rows;
  const std::set<std::string> nodes = nodesFor(cause, project.graph);
  std::vector<std::size_t> found;
  for (const auto holds : {endsAt, runsThrough}) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!rows[i].gone && holds(rows[i], nodes)) found.push_back(i);
    }
    if (!found.empty()) break;
  }
  std::ranges::stable_partition(found, [&](std::size_t i) { return isChain(rows[i], cause.chain); });
  return found;
}

std::vector<std::string> requirementsFor(const std::vector<std::string>& rows, const std::string& effect,
                                         const specs::Specification& specification) {
  const specs::LinkIndex index(specification);
  std::set<std::string> direct, binding;
  for (const std::string& row : rows) {
    for (const specs::Link& link : index.followersOf(row)) direct.insert(link.to);
    for (const std::string& id : index.allFollowersOf(row)) {
      const auto requirement = std::ranges::find(specification.requirements, id, &specs::Requirement::id);
      if (requirement == specification.requirements.end()) continue;
      const bool binds = std::ranges::find(requirement->effects, effect) != requirement->effects.end();
      if (binds && requirement->level == specs::Level::DetectionModel) binding.insert(id);
    }
  }
  std::set<std::string>& chosen = binding.empty() ? direct : binding;
  std::erase_if(chosen, [&](const std::string& id) {
    const auto requirement = std::ranges::find(specification.requirements, id, &specs::Requirement::id);
    return requirement == specification.requirements.end() || requirement->status == specs::Status::Rejected;
  });
  return {chosen.begin(), chosen.end()};
}

Proposed propose(const GapReport& report, const Project& project, const Sources& sources, core::Progress& progress) {
  if (project.specification.cepra.rows.empty()) {
    throw core::InputError({.item = "relevance table"}, "the project has no relevance table yet.",
                           "Import a graph first: fidelis import GRAPH --project FILE.");
  }
  Proposed proposed;
  const auto causes = report.namedEffects();
  if (causes.empty()) {
    proposed.notes.push_back(fmt::format(
        "nothing is proposed: the verdict is '{}', and only a missing effect says how often something occurs.",
        gap::toString(report.verdict.kind)));
    return proposed;
  }
  for (const gap::Cause* cause : causes) {
    const std::vector<std::size_t> rows = rowsOf(*cause, project);
    for (const std::size_t row : rows) {
      proposed.proposals.push_back(rowProposal(report, *cause, project.specification.cepra.rows[row]));
    }
    if (rows.empty()) {
      proposed.notes.push_back(fmt::format(
          "no row of the relevance table stands for {0}: the graph has no node with the tag 'fidelis-effect:{0}'.",
          cause->name));
    }
  }
  proposeTest(report, project, sources, progress, proposed);
  return proposed;
}

}  // namespace proposals
