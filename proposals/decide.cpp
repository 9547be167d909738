#include "proposals/decide.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "core/error.h"
#include "core/text.h"
#include "specs/shown_id.h"

namespace proposals {

namespace {

std::string worded(const cepra::Score& score) {
  std::string text = score.value ? std::to_string(*score.value) : "not scored";
  if (!score.expert.empty()) text += " by " + score.expert;
  return text;
}

void requireOpen(const specs::Proposal& proposal) {
  if (proposal.isOpen()) return;
  throw core::InputError({.item = proposal.id},
                         fmt::format("was {} by {} already.", specs::name(proposal.state), proposal.decided_by),
                         "Edit the row itself if you think otherwise; a decision is not taken twice.");
}

const specs::Proposal& needed(const std::vector<specs::Proposal>& all, const std::string& id,
                              const specs::ProjectStore& store) {
  if (const specs::Proposal* found = specs::findProposal(all, id)) return *found;
  std::vector<std::string> open;
  for (const specs::Proposal& proposal : all) {
    if (proposal.isOpen()) open.push_back(proposal.id);
  }
  throw core::InputError({.file = store.file(), .item = id}, "there is no such proposal.",
                         open.empty() ? "None is open. 'fidelis cepra propose REPORT' makes them from a diagnosis."
                                      : "Open are " + core::join(open) + ".");
}

std::string acceptRow(specs::ProjectStore& store, const specs::Proposal& proposal, Changed changed,
                      const specs::Signature& by) {
  cepra::Table table = store.cepra();
  const cepra::Row& row = rowFor(proposal, table);
  const auto change = changeSince(proposal, row);
  if (change && changed == Changed::Refuse) {
    throw core::InputError({.file = store.file(), .item = proposal.id + ", row " + proposal.row},
                           "the row has changed since this was proposed: " + *change + ".",
                           "Look at the row, then accept with --confirm, or dismiss the proposal.");
  }
  const auto writable = table.rows.begin() + (&row - table.rows.data());
  const cepra::Score before = writable->occurrence;
  writable->occurrence = acceptedScore(proposal, before, by.who);
  store.saveCepra(table, by);
  return fmt::format("{} accepted: occurrence of {} is {} now (was {})", proposal.id, specs::rowTitle(*writable),
                     *proposal.occurrence, worded(before));
}

std::string acceptTest(specs::ProjectStore& store, const specs::Proposal& proposal, const specs::Signature& by) {
  const specs::Specification specification = store.specification();
  const specs::AcceptanceTest test = store.add(acceptedTest(proposal, specification, by.who), by);
  for (const std::string& requirement : proposal.requirements) store.link({.from = requirement, .to = test.id}, by);
  for (const std::string& data : dataFor(proposal, specification)) store.link({.from = test.id, .to = data}, by);
  const std::string of = proposal.requirements.empty() ? "; link it to the requirement that it verifies"
                                                       : "; it verifies " + core::join(proposal.requirements);
  return fmt::format("{} accepted: acceptance test {} added, under review{}", proposal.id, test.id, of);
}

}  // namespace

std::optional<std::string> changeSince(const specs::Proposal& proposal, const cepra::Row& now) {
  if (proposal.before == now.occurrence) return std::nullopt;
  const std::string was = worded(proposal.before), is = worded(now.occurrence);
  if (was == is) return "the rationale of the occurrence is another";
  return fmt::format("occurrence was {}, is {} now", was, is);
}

cepra::Score acceptedScore(const specs::Proposal& proposal, const cepra::Score& now, const std::string& who) {
  cepra::Score score{.value = proposal.occurrence, .rationale = proposal.rationale, .expert = who};
  if (!now.rationale.empty()) score.rationale = now.rationale + "\n" + proposal.rationale;
  return score;
}

specs::Proposal accepted(const specs::Proposal& proposal, const specs::Signature& by) {
  requireOpen(proposal);
  specs::Proposal decided = proposal;
  decided.state = specs::ProposalState::Accepted;
  decided.decided_by = by.who;
  decided.decided_at = by.when;
  return decided;
}

specs::Proposal dismissed(const specs::Proposal& proposal, const std::string& reason, const specs::Signature& by) {
  requireOpen(proposal);
  if (core::trimmed(reason).empty()) {
    throw core::InputError({.item = proposal.id}, "a dismissal needs a reason.",
                           "Say in one sentence why the evidence does not count; it is kept in the history.");
  }
  specs::Proposal decided = proposal;
  decided.state = specs::ProposalState::Dismissed;
  decided.decided_by = by.who;
  decided.decided_at = by.when;
  decided.reason = core::trimmed(reason);
  return decided;
}

specs::AcceptanceTest acceptedTest(const specs::Proposal& proposal, const specs::Specification& specification,
                                   const std::string& who) {
  std::vector<std::string> taken;
  for (const auto& item : specification.requirements) taken.push_back(item.id);
  for (const auto& item : specification.tests) taken.push_back(item.id);
  for (const auto& item : specification.experiment_data) taken.push_back(item.id);
  for (const auto& item : specification.reference_data) taken.push_back(item.id);
  specs::AcceptanceTest test = *proposal.test;
  test.uid.clear();
  test.author = who;
  test.status = specs::Status::UnderReview;
  if (proposal.requirements.empty()) {
    test.id = specs::proposeId(proposal.experiment, proposal.cause, taken);
    return test;
  }
  const std::string& requirement = proposal.requirements.front();
  const std::string stem = requirement.substr(0, requirement.rfind('_'));
  for (int number = 1; test.id.empty(); ++number) {
    const std::string id = stem + "_" + std::to_string(number);
    if (std::ranges::find(taken, id) == taken.end()) test.id = id;
  }
  return test;
}

std::vector<std::string> dataFor(const specs::Proposal& proposal, const specs::Specification& specification) {
  std::set<std::string> data;
  for (const specs::AcceptanceTest& test : specification.tests) {
    if (test.experiment != proposal.test->experiment) continue;
    for (const specs::Link& link : specification.links) {
      if (link.from == test.id) data.insert(link.to);
    }
  }
  return {data.begin(), data.end()};
}

const cepra::Row& rowFor(const specs::Proposal& proposal, const cepra::Table& table) {
  const cepra::Row* row = table.find(proposal.row);
  if (row && !row->gone) return *row;
  throw core::InputError({.item = proposal.id + ", row " + proposal.row},
                         "the row is gone: the graph has no such path any more.",
                         "Dismiss the proposal, and propose from the report again if a new row took its place.");
}

std::string accept(specs::ProjectStore& store, const std::string& id, Changed changed, const specs::Signature& by) {
  std::string written;
  store.inOneAction([&] {
    const auto all = store.proposals();
    const specs::Proposal& proposal = needed(all, id, store);
    const specs::Proposal decided = accepted(proposal, by);
    written = proposal.test ? acceptTest(store, proposal, by) : acceptRow(store, proposal, changed, by);
    store.decide(decided, by);
  });
  return written;
}

std::string dismiss(specs::ProjectStore& store, const std::string& id, const std::string& reason,
                    const specs::Signature& by) {
  store.inOneAction([&] {
    const auto all = store.proposals();
    store.decide(dismissed(needed(all, id, store), reason, by), by);
  });
  return id + " dismissed: " + core::trimmed(reason);
}

}  // namespace proposals
