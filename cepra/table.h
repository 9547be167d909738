#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "percollect/graph.h"

namespace cepra {

/// An expert's estimate on a scale from 1 to 10 (scales.h), never without why and by whom.
struct Score {
  std::optional<int> value;
  std::string rationale;
  std::string expert;

  [[nodiscard]] bool isEmpty() const noexcept { return !value && rationale.empty() && expert.empty(); }
  bool operator==(const Score&) const = default;
};

struct Effect {
  std::string id;
  std::string title;

  bool operator==(const Effect&) const = default;
};

struct Cause {
  std::string id;
  std::string title;
  percollect::NodeKind kind = percollect::NodeKind::SystemIndependent;  ///< or DesignParameter

  bool operator==(const Cause&) const = default;
};

/// One line of the relevance table: how a phenomenon comes about, how often, and how much it matters.
struct Row {
  std::string key;              ///< see rowKey
  std::vector<Effect> effects;  ///< the path, from the phenomenon to the last effect; never empty
  std::vector<Cause> causes;    ///< direct causes of the last effect; may be empty
  Score occurrence;             ///< how often: 1 hardly ever ... 10 always
  Score impact;                 ///< how bad for the system under test: 1 not at all ... 10 safety goal violated
  std::string suspect;          ///< why somebody has to look at the scores again; empty: nothing to do
  bool gone = false;            ///< the current release of the graph has no such path
  std::string notes;

  [[nodiscard]] const Effect& phenomenon() const { return effects.front(); }
  [[nodiscard]] const Effect& lastEffect() const { return effects.back(); }
  [[nodiscard]] bool isSuspect() const noexcept { return !suspect.empty(); }
  [[nodiscard]] bool isScored() const noexcept { return occurrence.value && impact.value; }
  [[nodiscard]] bool hasInput() const noexcept { return !occurrence.isEmpty() || !impact.isEmpty() || !notes.empty(); }
  /// Occurrence plus impact, 2 ... 20; nothing unless both are given.
  [[nodiscard]] std::optional<int> relevance() const;
  [[nodiscard]] std::vector<Cause> causesOfKind(percollect::NodeKind kind) const;

  bool operator==(const Row&) const = default;
};

/// Cause, effect, phenomenon relevance analysis: the relevance table of one tree.
/// Source: Rosenberger 2022, doi:10.26083/tuprints-00023034, ch. 7 (CEPRA, Tab. 7-1).
struct Table {
  std::string tree;
  std::string graph_sha256;  ///< of the release that the rows come from
  std::vector<Row> rows;     ///< depth first, phenomena in their order; gone rows at the end

  [[nodiscard]] const Row* find(std::string_view key) const;
  bool operator==(const Table&) const = default;
};

/// Identity of a row through releases and spreadsheets: "r" and 12 hexadecimal digits of the SHA-256 of the tree's name
/// and the ids along the path. The letter keeps spreadsheets from reading a key as a number.
[[nodiscard]] std::string rowKey(std::string_view tree, std::span<const std::string> effect_ids);

/// One row for every path over effects only, from a phenomenon to an effect that has a direct cause or no further
/// effect below it. Throws InputError if two keys collide (rename the tree).
[[nodiscard]] Table buildTable(const percollect::Graph& graph);

/// The number of rows that buildTable gives, by dynamic programming; saturates at the largest size_t.
[[nodiscard]] std::size_t countRows(const percollect::Graph& graph);

}  // namespace cepra
