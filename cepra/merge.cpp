#include "cepra/merge.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/error.h"

namespace cepra {

namespace {

std::vector<std::string> titlesOf(const Row& row) {
  std::vector<std::string> titles;
  for (const Effect& effect : row.effects) titles.push_back(effect.title);
  return titles;
}

/// Which causes only `a` has, as "'title', 'title'".
std::string causesMissingIn(const Row& b, const Row& a) {
  std::string list;
  for (const Cause& cause : a.causes) {
    if (std::find(b.causes.begin(), b.causes.end(), cause) != b.causes.end()) continue;
    list += (list.empty() ? "'" : ", '") + cause.title + "' (" + cause.id + ", " +
            std::string(percollect::toString(cause.kind)) + ")";
  }
  return list;
}

/// What differs between the row that was scored and the row of the new release; empty: nothing.
std::string changesBetween(const Row& before, const Row& now) {
  std::string text;
  const std::size_t count = std::min(before.effects.size(), now.effects.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (before.effects[i].title == now.effects[i].title) continue;
    text += "Effect " + now.effects[i].id + " was '" + before.effects[i].title + "' and is '" + now.effects[i].title +
            "'. ";
  }
  if (const std::string lost = causesMissingIn(now, before); !lost.empty()) text += "Causes gone: " + lost + ". ";
  if (const std::string won = causesMissingIn(before, now); !won.empty()) text += "Causes new: " + won + ". ";
  if (!text.empty()) text.pop_back();
  return text;
}

/// Adds a reason unless it is already there (a merge may be repeated).
void addReason(Row& row, const std::string& reason) {
  if (row.suspect.find(reason) != std::string::npos) return;
  row.suspect += (row.suspect.empty() ? "" : " ") + reason;
}

void takeInput(Row& to, const Row& from) {
  to.occurrence = from.occurrence;
  to.impact = from.impact;
  to.notes = from.notes;
  to.suspect = from.suspect;
}

class Merger {
 public:
  Merger(const Table& scored, Table fresh, const std::set<std::string>& linked)
      : scored_(scored), linked_(linked), bound_(fresh.rows.size(), false), done_(scored.rows.size(), false) {
    merge_.table = std::move(fresh);
    for (std::size_t i = 0; i < rows().size(); ++i) {
      by_key_[rows()[i].key] = i;
      by_titles_[titlesOf(rows()[i])].push_back(i);
    }
  }

  Merge run() {
    reportAdded();
    // Strongest evidence first: what agrees in ids and titles must not be taken by what agrees in one of them.
    bindUnchanged();
    bindRenumbered();
    bindChanged();
    keepGone();
    return std::move(merge_);
  }

 private:
  std::vector<Row>& rows() { return merge_.table.rows; }
  [[nodiscard]] bool matters(const Row& row) const {
    return row.hasInput() || row.isSuspect() || linked_.count(row.key) > 0;
  }
  void markSuspect(Row& row, const std::string& reason) {
    addReason(row, reason);
    if (std::find(merge_.suspect.begin(), merge_.suspect.end(), row.key) == merge_.suspect.end()) {
      merge_.suspect.push_back(row.key);
    }
  }

  std::optional<std::size_t> sameKey(const Row& row) {
    const auto found = by_key_.find(row.key);
    return found == by_key_.end() ? std::nullopt : std::optional(found->second);
  }

  void reportAdded() {
    for (const Row& row : rows()) {
      if (!scored_.find(row.key)) merge_.added.push_back(row.key);
    }
  }

  void bindUnchanged() {
    for (std::size_t i = 0; i < scored_.rows.size(); ++i) {
      const Row& before = scored_.rows[i];
      const auto now = sameKey(before);
      if (!now || titlesOf(before) != titlesOf(rows()[*now])) continue;
      Row& row = rows()[*now];
      const std::string changes = changesBetween(before, row);
      takeInput(row, before);
      if (before.gone && matters(before)) markSuspect(row, "The path was gone and is back.");
      if (!changes.empty() && matters(before)) markSuspect(row, changes);
      if (changes.empty() && !before.gone && before.hasInput()) ++merge_.kept;
      bound_[*now] = done_[i] = true;
    }
  }

  /// The only free row with the same titles. Ids are not stable between releases; titles nearly are.
  std::optional<std::size_t> sameTitles(const Row& row) {
    std::optional<std::size_t> only;
    const auto found = by_titles_.find(titlesOf(row));
    if (found == by_titles_.end()) return std::nullopt;
    for (const std::size_t i : found->second) {
      if (bound_[i]) continue;
      if (only) return std::nullopt;
      only = i;
    }
    return only;
  }

  void bindRenumbered() {
    for (std::size_t i = 0; i < scored_.rows.size(); ++i) {
      const Row& before = scored_.rows[i];
      if (done_[i] || before.gone || !matters(before)) continue;
      const auto now = sameTitles(before);
      if (!now) continue;
      Row& row = rows()[*now];
      takeInput(row, before);
      markSuspect(row, "The scores come from row " + before.key + ", which had the same titles but other ids.");
      bound_[*now] = true;
      moved_to_[i] = row.key;
    }
  }

  void bindChanged() {
    for (std::size_t i = 0; i < scored_.rows.size(); ++i) {
      const Row& before = scored_.rows[i];
      const auto now = sameKey(before);
      if (done_[i] || !now) continue;
      Row& row = rows()[*now];
      const auto moved = moved_to_.find(i);
      if (moved != moved_to_.end()) {
        // The ids now mean another path. Whoever refers to this key must hear of it.
        markSuspect(row, "The key meant another path; its scores went to row " + moved->second + ".");
        done_[i] = true;
      } else if (!bound_[*now]) {
        takeInput(row, before);
        if (matters(before)) markSuspect(row, changesBetween(before, row));
        bound_[*now] = done_[i] = true;
      }
    }
  }

  void keepGone() {
    for (std::size_t i = 0; i < scored_.rows.size(); ++i) {
      if (done_[i]) continue;
      if (!matters(scored_.rows[i])) {
        merge_.dropped.push_back(scored_.rows[i].key);
        continue;
      }
      Row row = scored_.rows[i];
      // Its key may by now belong to a row that was bound by its titles; then the titles make the key.
      if (sameKey(row)) row.key = rowKey(scored_.tree, titlesOf(row));
      row.gone = true;
      const auto moved = moved_to_.find(i);
      markSuspect(row, moved == moved_to_.end()
                           ? "The graph no longer has this path."
                           : "The path has new ids; its scores were copied to row " + moved->second + ".");
      rows().push_back(std::move(row));
    }
  }

  const Table& scored_;
  const std::set<std::string>& linked_;
  Merge merge_;
  std::map<std::string, std::size_t> by_key_;
  std::map<std::vector<std::string>, std::vector<std::size_t>> by_titles_;
  std::vector<bool> bound_;                      ///< row of the new release has got its input
  std::vector<bool> done_;                       ///< old row needs nothing more
  std::map<std::size_t, std::string> moved_to_;  ///< old row -> key of the row with its scores
};

}  // namespace

Merge merge(const Table& scored, Table fresh, const std::set<std::string>& linked) {
  if (scored.tree != fresh.tree && !scored.rows.empty()) {
    throw core::InputError({.item = "CEPRA table"},
                           "the table is of the tree '" + scored.tree + "', the graph of '" + fresh.tree + "'.",
                           "Give the tree's name on import if it is the same tree, or begin a new table.");
  }
  return Merger(scored, std::move(fresh), linked).run();
}

}  // namespace cepra
