// What diagnoses propose, and what became of it, in a project file.

#include <charconv>

#include "specs/connection.h"
#include "specs/fields.h"

namespace specs {

namespace {

std::string listOfUids(const ProjectStore::Connection& connection, const std::vector<std::string>& ids) {
  std::vector<std::string> uids;
  for (const std::string& id : ids) uids.push_back(connection.needUid(id));
  return joinList(uids);
}

/// Present ids of those that are still there.
std::vector<std::string> shownIds(const ProjectStore::Connection& connection, const std::string& uids) {
  std::vector<std::string> ids;
  for (const std::string& uid : splitList(uids)) {
    if (auto id = connection.text("SELECT id FROM item WHERE uid = ?", {uid})) ids.push_back(std::move(*id));
  }
  return ids;
}

std::int64_t numberOf(const ProjectStore::Connection& connection, const std::string& id) {
  std::int64_t number = 0;
  const char* end = id.data() + id.size();
  const bool read = id.size() > 1 && id[0] == 'P' && std::from_chars(id.data() + 1, end, number).ptr == end;
  if (!read || !connection.integer("SELECT 1 FROM proposal WHERE number = ?", {number})) {
    connection.fail(id, "there is no such proposal.", "'fidelis cepra proposals' lists them.");
  }
  return number;
}

void storeFields(ProjectStore::Connection& connection, std::int64_t number, const AcceptanceTest& test) {
  for (const auto& field : fieldsOf<AcceptanceTest>()) {
    connection.run("INSERT INTO proposal_field VALUES (?, ?, ?)", {number, std::string(field.name), field.get(test)});
  }
}

AcceptanceTest loadTest(const ProjectStore::Connection& connection, std::int64_t number) {
  AcceptanceTest test;
  for (const auto& field : fieldsOf<AcceptanceTest>()) {
    const auto value = connection.text("SELECT value FROM proposal_field WHERE proposal = ? AND name = ?",
                                       {number, std::string(field.name)});
    if (!value) continue;  // a field that is younger than the proposal
    const std::string problem = field.set(test, *value);
    if (!problem.empty()) {
      connection.fail("P" + std::to_string(number), problem + ".", "Restore a copy: somebody else wrote to the file.");
    }
  }
  return test;
}

/// The history of the row, or of the requirements that a test would verify, says what became of the proposal.
void tellHistory(ProjectStore::Connection& connection, const Proposal& proposal, const Signature& by) {
  const std::string_view what = proposal.isOpen() ? "open again" : name(proposal.state);
  std::string text =
      (proposal.test ? "proposed acceptance test " : "proposal ") + proposal.id + " " + std::string(what);
  if (!proposal.reason.empty()) text += ": " + proposal.reason;
  const std::vector<std::string> told = proposal.test ? proposal.requirements : std::vector{proposal.row};
  for (const std::string& id : told) {
    if (const auto uid = connection.uidOf(id)) connection.record(*uid, id, by, text);
  }
}

}  // namespace

std::vector<Proposal> ProjectStore::addProposals(const std::vector<Proposal>& proposals, const Signature& by) {
  std::vector<Proposal> added;
  connection_->action([&] {
    for (const Proposal& proposal : proposals) {
      const bool known =
          connection_
              ->integer("SELECT 1 FROM proposal WHERE evidence = ? AND row_key = ?", {proposal.evidence, proposal.row})
              .has_value();
      if (known) continue;
      Proposal& stored = added.emplace_back(proposal);
      stored.proposed_by = by.who;
      stored.proposed_at = by.when;
      connection_->run(
          "INSERT INTO proposal (state, row_key, cause, experiment, model, report, report_sha256, evidence, "
          "occurrence, "
          "before, before_rationale, before_expert, rationale, requirements, proposed_by, proposed_at, decided_by, "
          "decided_at, reason) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
          {std::string(name(stored.state)), stored.row, stored.cause, stored.experiment, stored.model, stored.report,
           stored.report_sha256, stored.evidence, orNull(stored.occurrence), orNull(stored.before.value),
           stored.before.rationale, stored.before.expert, stored.rationale,
           listOfUids(*connection_, stored.requirements), stored.proposed_by, stored.proposed_at, stored.decided_by,
           stored.decided_at, stored.reason});
      const std::int64_t number = connection_->lastRowId();
      stored.id = "P" + std::to_string(number);
      if (stored.test) storeFields(*connection_, number, *stored.test);
    }
  });
  return added;
}

std::vector<Proposal> ProjectStore::proposals() const {
  std::vector<Proposal> found;
  const auto number = [](const Record& record, int column) -> std::optional<int> {
    if (const auto value = record.optionalInteger(column)) return static_cast<int>(*value);
    return std::nullopt;
  };
  connection_->snapshot([&] {
    connection_->each(
        "SELECT number, state, row_key, cause, experiment, model, report, report_sha256, evidence, occurrence, before, "
        "before_rationale, before_expert, rationale, requirements, proposed_by, proposed_at, decided_by, decided_at, "
        "reason FROM proposal ORDER BY number",
        {}, [&](const Record& record) {
          Proposal& proposal = found.emplace_back();
          proposal.id = "P" + std::to_string(record.integer(0));
          proposal.state = proposalStateOf(record.text(1)).value_or(ProposalState::Open);
          proposal.row = record.text(2);
          proposal.cause = record.text(3);
          proposal.experiment = record.text(4);
          proposal.model = record.text(5);
          proposal.report = record.text(6);
          proposal.report_sha256 = record.text(7);
          proposal.evidence = record.text(8);
          proposal.occurrence = number(record, 9);
          proposal.before = {.value = number(record, 10), .rationale = record.text(11), .expert = record.text(12)};
          proposal.rationale = record.text(13);
          proposal.requirements = shownIds(*connection_, record.text(14));
          proposal.proposed_by = record.text(15);
          proposal.proposed_at = record.text(16);
          proposal.decided_by = record.text(17);
          proposal.decided_at = record.text(18);
          proposal.reason = record.text(19);
          if (proposal.row.empty()) proposal.test = loadTest(*connection_, record.integer(0));
        });
  });
  return found;
}

void ProjectStore::decide(const Proposal& decided, const Signature& by) {
  connection_->action([&] {
    const std::int64_t number = numberOf(*connection_, decided.id);
    const auto before = connection_->text("SELECT state FROM proposal WHERE number = ?", {number});
    if (before == name(decided.state)) return;
    connection_->run(
        "UPDATE proposal SET state = ?, decided_by = ?, decided_at = ?, reason = ? WHERE number = ?",
        {std::string(name(decided.state)), decided.decided_by, decided.decided_at, decided.reason, number});
    tellHistory(*connection_, decided, by);
  });
}

}  // namespace specs
