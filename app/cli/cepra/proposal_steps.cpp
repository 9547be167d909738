#include "app/cli/cepra/proposal_steps.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/session.h"
#include "app/cli/signature.h"
#include "core/error.h"
#include "core/text.h"
#include "proposals/decide.h"
#include "proposals/propose.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string report;
  std::string project;
  std::string experiment;
  std::string model;
  std::string json;
  std::string author;
  std::string state = "open";
  std::string reason;
  std::vector<std::string> ids;
  bool confirm = false;
};

Json scoreJson(const cepra::Score& score) {
  return {{"value", score.value ? Json(*score.value) : Json(nullptr)},
          {"rationale", score.rationale},
          {"expert", score.expert}};
}

Json testJson(const specs::Proposal& proposal) {
  const specs::AcceptanceTest& test = *proposal.test;
  return {{"title", test.title},
          {"experiment", test.experiment},
          {"model", test.model},
          {"measurand", test.measurand},
          {"expression", test.expression},
          {"samples", test.samples},
          {"requirements", proposal.requirements}};
}

Json proposalJson(const specs::Proposal& proposal, const specs::Specification& specification) {
  Json json = {{"id", proposal.id},
               {"kind", proposal.test ? "acceptance test" : "occurrence"},
               {"state", std::string(specs::name(proposal.state))},
               {"cause", proposal.cause},
               {"experiment", proposal.experiment},
               {"model", proposal.model}};
  if (proposal.test) {
    json["test"] = testJson(proposal);
  } else {
    const cepra::Row* row = specification.cepra.find(proposal.row);
    json["row"] = proposal.row;
    json["row_title"] = row ? specs::rowTitle(*row) : "";
    json["occurrence"] = *proposal.occurrence;
    json["before"] = scoreJson(proposal.before);
    const auto change = row ? proposals::changeSince(proposal, *row) : std::optional<std::string>("the row is gone");
    json["changed_since"] = change && proposal.isOpen() ? Json(*change) : Json(nullptr);
    json["requirements"] = proposals::requirementsFor({proposal.row}, proposal.cause, specification);
  }
  json["rationale"] = proposal.rationale;
  json["report"] = {{"file", proposal.report}, {"sha256", proposal.report_sha256}};
  json["proposed"] = {{"who", proposal.proposed_by}, {"when", proposal.proposed_at}};
  json["decided"] = nullptr;
  if (!proposal.isOpen()) {
    json["decided"] = {{"who", proposal.decided_by}, {"when", proposal.decided_at}, {"reason", proposal.reason}};
  }
  return json;
}

Json listJson(const std::vector<specs::Proposal>& proposals, const specs::Specification& specification) {
  Json list = Json::array();
  for (const specs::Proposal& proposal : proposals) list.push_back(proposalJson(proposal, specification));
  return {{"format", "fidelis-proposals"}, {"version", 1}, {"proposals", list}};
}

/// "occurrence 4 -> 6", "occurrence none -> 6" or "occurrence stays 6".
std::string changeText(const specs::Proposal& proposal) {
  if (proposal.before.value == proposal.occurrence) return fmt::format("occurrence stays {}", *proposal.occurrence);
  const std::string before = proposal.before.value ? std::to_string(*proposal.before.value) : "none";
  return fmt::format("occurrence {} -> {}", before, *proposal.occurrence);
}

void printRow(const specs::Proposal& proposal, const specs::Specification& specification, std::ostream& out) {
  const cepra::Row* row = specification.cepra.find(proposal.row);
  out << fmt::format("{:<5} {:<9}  {}  {}  {}\n", proposal.id, specs::name(proposal.state), changeText(proposal),
                     proposal.row, row ? specs::rowTitle(*row) : "(the row is gone)");
  if (!row || !proposal.isOpen()) return;
  if (const auto change = proposals::changeSince(proposal, *row)) out << "      changed since: " << *change << "\n";
  const auto requirements = proposals::requirementsFor({proposal.row}, proposal.cause, specification);
  if (!requirements.empty()) out << "      requirements: " << core::join(requirements) << "\n";
}

void printTest(const specs::Proposal& proposal, std::ostream& out) {
  out << fmt::format("{:<5} {:<9}  acceptance test on {}: {}\n", proposal.id, specs::name(proposal.state),
                     proposal.test->measurand, proposal.test->expression);
  if (!proposal.requirements.empty()) out << "      verifies: " << core::join(proposal.requirements) << "\n";
}

void print(const specs::Proposal& proposal, const specs::Specification& specification, bool verbose,
           std::ostream& out) {
  if (proposal.test) {
    printTest(proposal, out);
  } else {
    printRow(proposal, specification, out);
  }
  if (verbose || proposal.test) out << "      " << proposal.rationale << "\n";
  if (proposal.isOpen()) return;
  out << fmt::format("      {} by {} on {}{}\n", specs::name(proposal.state), proposal.decided_by, proposal.decided_at,
                     proposal.reason.empty() ? "" : ": " + proposal.reason);
}

void show(const std::vector<specs::Proposal>& proposals, const specs::ProjectStore& store, const Options& options,
          Session& session) {
  const specs::Specification specification = store.specification();
  if (!options.json.empty()) session.writeJsonTo(options.json, listJson(proposals, specification));
  if (options.json == "-") return;
  for (const specs::Proposal& proposal : proposals) print(proposal, specification, session.verbose, session.out);
}

void runPropose(const Options& options, Session& session) {
  const proposals::GapReport report = proposals::readGapReport(options.report);
  auto store = specs::ProjectStore::open(options.project);
  const specs::Specification specification = store.specification();
  const percollect::Graph graph = store.graph().value_or(percollect::Graph());
  proposals::Sources sources;
  if (!options.experiment.empty()) sources.experiment = options.experiment;
  if (!options.model.empty()) sources.model = options.model;
  const proposals::Proposed proposed =
      proposals::propose(report, {specification, graph, store.folder()}, sources, session.progress);
  const auto added = store.addProposals(proposed.proposals, signatureOf(options.author));
  show(added, store, options, session);
  for (const std::string& note : proposed.notes) session.messages << "fidelis: " << note << "\n";
  if (session.quiet) return;
  const std::size_t known = proposed.proposals.size() - added.size();
  session.messages << fmt::format("{} proposed{}\n", added.size(),
                                  known > 0 ? fmt::format(", {} known from this report already", known) : "");
}

void runList(const Options& options, Session& session) {
  const auto store = specs::ProjectStore::open(options.project, specs::Access::ReadOnly);
  std::vector<specs::Proposal> proposals = store.proposals();
  const std::size_t all = proposals.size();
  const auto wanted = specs::proposalStateOf(options.state);
  std::erase_if(proposals, [&](const specs::Proposal& proposal) { return wanted && proposal.state != *wanted; });
  show(proposals, store, options, session);
  if (!proposals.empty() || session.quiet) return;
  if (all == 0) {
    session.messages << "no proposals; 'fidelis cepra propose REPORT' makes them from a diagnosis\n";
  } else {
    session.messages << fmt::format("none of {} proposals is {}; --state all shows them\n", all, options.state);
  }
}

void tell(const std::vector<std::string>& done, const specs::ProjectStore& store, const Options& options,
          Session& session) {
  if (!options.json.empty()) {
    std::vector<specs::Proposal> decided = store.proposals();
    std::erase_if(decided, [&](const auto& proposal) { return std::ranges::count(options.ids, proposal.id) == 0; });
    session.writeJsonTo(options.json, listJson(decided, store.specification()));
  }
  if (options.json == "-" || session.quiet) return;
  for (const std::string& sentence : done) session.out << sentence << "\n";
}

void runAccept(const Options& options, Session& session) {
  auto store = specs::ProjectStore::open(options.project);
  const auto changed = options.confirm ? proposals::Changed::Confirmed : proposals::Changed::Refuse;
  std::vector<std::string> done;
  store.inOneAction([&] {
    for (const std::string& id : options.ids) {
      done.push_back(proposals::accept(store, id, changed, signatureOf(options.author)));
    }
  });
  tell(done, store, options, session);
}

void runDismiss(const Options& options, Session& session) {
  auto store = specs::ProjectStore::open(options.project);
  std::vector<std::string> done;
  store.inOneAction([&] {
    for (const std::string& id : options.ids) {
      done.push_back(proposals::dismiss(store, id, options.reason, signatureOf(options.author)));
    }
  });
  tell(done, store, options, session);
}

CLI::App* addStep(CLI::App& cepra, const char* name, const char* help, const std::shared_ptr<Options>& options,
                  Session& session, void (*run)(const Options&, Session&)) {
  CLI::App* step = cepra.add_subcommand(name, help);
  step->add_option("--project", options->project, "Project file")->required();
  step->add_option("--json", options->json, "Write the proposals as JSON to this file (-: standard output)");
  step->callback([options, &session, run] { run(*options, session); });
  return step;
}

void addAuthor(CLI::App* step, const std::shared_ptr<Options>& options) {
  step->add_option("--author", options->author, "Who does this, for the history (default: the login name)");
}

}  // namespace

void addProposalSteps(CLI::App& cepra, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* propose = addStep(cepra, "propose", "Propose occurrences and an acceptance test from a diagnosis", options,
                              session, runPropose);
  propose->add_option("REPORT", options->report, "Gap report that 'fidelis gap --json' wrote")->required();
  propose->add_option("--experiment", options->experiment, "Its package (default: the one that a test names)");
  propose->add_option("--model", options->model, "Model file that was diagnosed (default: the one that a test names)");
  addAuthor(propose, options);
  propose->footer(
      "A person decides: nothing but the list of proposals changes.\n"
      "Example:\n"
      "  fidelis gap foggy-sweep --model model.json --project demo.fidelis --json gap.json\n"
      "  fidelis cepra propose gap.json --project demo.fidelis");

  CLI::App* list =
      addStep(cepra, "proposals", "List what is proposed (--verbose: with the evidence)", options, session, runList);
  list->add_option("--state", options->state, "Only these: open (default), accepted, dismissed, or all")
      ->check(CLI::IsMember({"open", "accepted", "dismissed", "all"}));

  CLI::App* accept =
      addStep(cepra, "accept", "Write a proposal into the table or the specification", options, session, runAccept);
  accept->add_option("ID", options->ids, "Proposals: P1 P2 …")->required();
  accept->add_flag("--confirm", options->confirm, "Although the row has changed since it was proposed");
  addAuthor(accept, options);
  accept->footer(
      "The occurrence and its evidence are written into the row, a test is added for review; impacts are not touched.\n"
      "Example: fidelis cepra accept P1 P4 --project demo.fidelis --author eve");

  CLI::App* dismiss = addStep(cepra, "dismiss", "Set a proposal aside, with the reason", options, session, runDismiss);
  dismiss->add_option("ID", options->ids, "Proposals: P1 P2 …")->required();
  dismiss->add_option("--because", options->reason, "Why; kept in the history")->required();
  addAuthor(dismiss, options);
  dismiss->footer(
      "Example: fidelis cepra dismiss P2 --project demo.fidelis --because \"the chamber's fog is denser than any "
      "here\"");
}

}  // namespace app
