#pragma once

#include <optional>
#include <string>
#include <vector>

#include "specs/project_store.h"

namespace proposals {

/// Whether a person has seen that the row is not what it was when the proposal was made.
enum class Changed { Refuse, Confirmed };

/// How the row's occurrence differs from what it was when this was proposed: "occurrence was 4, is 6 by eve now";
/// nothing if it does not.
[[nodiscard]] std::optional<std::string> changeSince(const specs::Proposal& proposal, const cepra::Row& now);

/// The score that acceptance writes: the proposed value, the old rationale followed by the evidence, and whoever
/// accepts.
[[nodiscard]] cepra::Score acceptedScore(const specs::Proposal& proposal, const cepra::Score& now,
                                         const std::string& who);

/// The proposal after a decision. Dismissal needs a reason. Throws InputError if it is decided already.
[[nodiscard]] specs::Proposal accepted(const specs::Proposal& proposal, const specs::Signature& by);
[[nodiscard]] specs::Proposal dismissed(const specs::Proposal& proposal, const std::string& reason,
                                        const specs::Signature& by);

/// The test that acceptance adds: under review, with an id of the family of its first requirement or row.
[[nodiscard]] specs::AcceptanceTest acceptedTest(const specs::Proposal& proposal,
                                                 const specs::Specification& specification, const std::string& who);

/// What that test needs of experiment and reference: what the other tests of its experiment need. Ids.
[[nodiscard]] std::vector<std::string> dataFor(const specs::Proposal& proposal,
                                               const specs::Specification& specification);

/// The row that a proposal is for. Throws InputError if it is no more, or gone from the graph.
[[nodiscard]] const cepra::Row& rowFor(const specs::Proposal& proposal, const cepra::Table& table);

/// In a project file, each as one action. Return what was written, in one sentence. An unknown id throws InputError
/// with the ids that are open.
std::string accept(specs::ProjectStore& store, const std::string& id, Changed changed, const specs::Signature& by);
std::string dismiss(specs::ProjectStore& store, const std::string& id, const std::string& reason,
                    const specs::Signature& by);

}  // namespace proposals
