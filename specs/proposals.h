#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cepra/table.h"
#include "specs/items.h"

namespace specs {

enum class ProposalState { Open, Accepted, Dismissed };

[[nodiscard]] std::string_view name(ProposalState state);  ///< "open", "accepted", "dismissed"
[[nodiscard]] std::optional<ProposalState> proposalStateOf(std::string_view name);

/// What a diagnosis of the gap says about one row of the relevance table, or the acceptance test that would have caught
/// the gap. A program proposes, a person accepts or dismisses; until then nothing else in the project changes.
struct Proposal {
  std::string id;  ///< "P1", given by the store
  ProposalState state = ProposalState::Open;
  std::string cause;       ///< effect that the diagnosis names
  std::string experiment;  ///< id
  std::string model;       ///< id of the model that lacks the effect
  std::string report;      ///< file of the gap report
  std::string report_sha256;
  std::string evidence;  ///< SHA-256 of the report's content; the same evidence proposes the same thing once
  std::string rationale;

  std::string row;                ///< key; empty if a test is proposed
  std::optional<int> occurrence;  ///< proposed for the row, 1 ... 10
  cepra::Score before;            ///< the row's occurrence when this was proposed

  std::optional<AcceptanceTest> test;
  std::vector<std::string> requirements;  ///< that the test would verify, by shown ids

  std::string proposed_by;
  std::string proposed_at;
  std::string decided_by;  ///< empty while open
  std::string decided_at;
  std::string reason;  ///< why it was dismissed

  [[nodiscard]] bool isOpen() const noexcept { return state == ProposalState::Open; }
  bool operator==(const Proposal&) const = default;
};

/// The one with this id, or nullptr.
[[nodiscard]] const Proposal* findProposal(const std::vector<Proposal>& proposals, std::string_view id);

}  // namespace specs
