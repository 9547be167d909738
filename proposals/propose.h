#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "percollect/graph.h"
#include "proposals/gap_report.h"
#include "specs/project_store.h"

namespace proposals {

/// What somebody knows beside the report. Everything may be left out: then the project's acceptance tests are searched
/// for a package and a model of the ids in the report.
struct Sources {
  std::optional<std::filesystem::path> experiment;
  std::optional<std::filesystem::path> model;  ///< as it was, without the cause
};

struct Proposed {
  std::vector<specs::Proposal> proposals;  ///< rows first, those of the cause's own chain at the top; then the test
  std::vector<std::string> notes;          ///< what could not be proposed, and why
};

/// Where a project stands: what is proposed depends on it.
struct Project {
  const specs::Specification& specification;
  const percollect::Graph& graph;
  std::filesystem::path folder;
};

/// Rows of the relevance table that a cause stands for: those whose last effect or one of whose causes is a node of it;
/// if there is none, those whose path runs through one. Indices, rows that end in the report's own chain first.
[[nodiscard]] std::vector<std::size_t> rowsOf(const gap::Cause& cause, const Project& project);

/// What follows from a report for the relevance table and the specification. Only causes of kind `effect` that the
/// verdict names propose anything: a wrong parameter or reference says nothing about how often an effect occurs.
/// Throws InputError for a project without a relevance table and for files that cannot be used.
[[nodiscard]] Proposed propose(const GapReport& report, const Project& project, const Sources& sources,
                               core::Progress& progress);

/// Requirements that follow from rows, directly or by refinement, and that an acceptance test of the effect verifies:
/// those that bind the effect, else those that follow directly. Rejected ones never.
[[nodiscard]] std::vector<std::string> requirementsFor(const std::vector<std::string>& rows, const std::string& effect,
                                                       const specs::Specification& specification);

}  // namespace proposals
