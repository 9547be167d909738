#include "specs/proposals.h"

#include <algorithm>

namespace specs {

std::string_view name(ProposalState state) {
  switch (state) {
    case ProposalState::Open:
      return "open";
    case ProposalState::Accepted:
      return "accepted";
    case ProposalState::Dismissed:
      return "dismissed";
  }
  return "";
}

std::optional<ProposalState> proposalStateOf(std::string_view text) {
  for (const ProposalState state : {ProposalState::Open, ProposalState::Accepted, ProposalState::Dismissed}) {
    if (name(state) == text) return state;
  }
  return std::nullopt;
}

const Proposal* findProposal(const std::vector<Proposal>& proposals, std::string_view id) {
  const auto found = std::ranges::find(proposals, id, &Proposal::id);
  return found == proposals.end() ? nullptr : &*found;
}

}  // namespace specs
