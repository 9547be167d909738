#include "percollect/difference.h"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <unordered_map>

#include "core/text.h"

namespace percollect {

namespace {

std::set<std::string> wordsOf(const std::string& title) {
  std::string text = core::lowerCase(title);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::string_view("/-,()[].").find(c) != std::string::npos; }, ' ');
  std::istringstream stream(text);
  std::set<std::string> words;
  for (std::string word; stream >> word;) words.insert(word);
  return words;
}

/// At least half of all words in common, or the first three quarters of either (an ending changed).
bool resemble(const std::string& a, const std::string& b) {
  const std::set<std::string> words_a = wordsOf(a);
  const std::set<std::string> words_b = wordsOf(b);
  std::size_t common = 0;
  for (const std::string& word : words_a) common += words_b.count(word);
  const std::size_t all = words_a.size() + words_b.size() - common;
  if (2 * common >= all) return true;
  const std::string stem_a = core::lowerCase(a).substr(0, a.size() * 3 / 4);
  const std::string stem_b = core::lowerCase(b).substr(0, b.size() * 3 / 4);
  return core::lowerCase(b).starts_with(stem_a) || core::lowerCase(a).starts_with(stem_b);
}

/// Which node of the new release is which node of the old one.
class Matching {
 public:
  Matching(const Graph& before, const Graph& after)
      : before_(before), after_(after), new_of_(before.size()), old_of_(after.size()) {
    match([&](const Node& node) {
      return sameId(node, [](const Node& a, const Node& b) { return a.title == b.title; });
    });
    matchByTitle();
    match([&](const Node& node) {
      return sameId(node, [](const Node& a, const Node& b) { return resemble(a.title, b.title); });
    });
  }

  [[nodiscard]] std::optional<std::size_t> newOf(std::size_t old_index) const { return new_of_[old_index]; }
  [[nodiscard]] std::optional<std::size_t> oldOf(std::size_t new_index) const { return old_of_[new_index]; }

 private:
  template <typename Fits>
  [[nodiscard]] std::optional<std::size_t> sameId(const Node& node, Fits fits) const {
    const auto other = after_.find(node.id);
    return other && fits(node, after_.node(*other)) ? other : std::nullopt;
  }

  template <typename Candidate>
  void match(Candidate candidate) {
    for (std::size_t i = 0; i < before_.size(); ++i) {
      if (new_of_[i]) continue;
      const auto other = candidate(before_.node(i));
      if (other && !old_of_[*other]) join(i, *other);
    }
  }

  /// Titles that several of the remaining nodes share prove nothing.
  void matchByTitle() {
    const auto remaining = [](const Graph& graph, const auto& partner) {
      std::unordered_map<std::string, std::vector<std::size_t>> by_title;
      for (std::size_t i = 0; i < graph.size(); ++i) {
        if (!partner[i] && !graph.node(i).title.empty()) by_title[graph.node(i).title].push_back(i);
      }
      return by_title;
    };
    const auto olds = remaining(before_, new_of_);
    const auto news = remaining(after_, old_of_);
    for (const auto& [title, old_nodes] : olds) {
      const auto found = news.find(title);
      if (found != news.end() && old_nodes.size() == 1 && found->second.size() == 1) {
        join(old_nodes.front(), found->second.front());
      }
    }
  }

  void join(std::size_t old_index, std::size_t new_index) {
    new_of_[old_index] = new_index;
    old_of_[new_index] = old_index;
  }

  const Graph& before_;
  const Graph& after_;
  std::vector<std::optional<std::size_t>> new_of_;
  std::vector<std::optional<std::size_t>> old_of_;
};

std::string quoted(const std::string& text) { return "'" + text + "'"; }

std::string listed(const std::set<std::string>& items) {
  const std::vector<std::string> list(items.begin(), items.end());
  return list.empty() ? "none" : core::join(list);
}

class Comparison {
 public:
  Comparison(const Graph& before, const Graph& after) : before_(before), after_(after), matching_(before, after) {}

  Difference run() {
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const Node& node = before_.node(i);
      if (const auto other = matching_.newOf(i)) {
        result_.new_ids[node.id] = after_.node(*other).id;
      } else {
        result_.changes.push_back({ChangeKind::Removed, node.id, "", node.title, quoted(node.title) + " was removed."});
      }
    }
    for (std::size_t i = 0; i < after_.size(); ++i) {
      const Node& node = after_.node(i);
      if (const auto other = matching_.oldOf(i)) {
        compare(*other, i);
      } else {
        result_.changes.push_back({ChangeKind::Added, "", node.id, node.title, quoted(node.title) + " was added."});
      }
    }
    return std::move(result_);
  }

 private:
  void compare(std::size_t old_index, std::size_t new_index) {
    const Node& a = before_.node(old_index);
    const Node& b = after_.node(new_index);
    const auto add = [&](ChangeKind kind, const std::string& text) {
      result_.changes.push_back({kind, a.id, b.id, b.title, text});
    };
    if (a.id != b.id) add(ChangeKind::Renumbered, "The id was " + a.id + " and is " + b.id + ".");
    if (a.title != b.title) {
      add(ChangeKind::Renamed, "The title was " + quoted(a.title) + " and is " + quoted(b.title) + ".");
    }
    compareParents(old_index, new_index, add);
    if (a.kind != b.kind) {
      add(ChangeKind::KindChanged,
          "The kind was " + std::string(toString(a.kind)) + " and is " + std::string(toString(b.kind)) + ".");
    }
    if (a.block != b.block) {
      add(ChangeKind::BlockChanged, "The block was " + quoted(a.block) + " and is " + quoted(b.block) + ".");
    }
    if (a.description != b.description) {
      add(ChangeKind::DescriptionChanged,
          "The description was " + quoted(a.description) + " and is " + quoted(b.description) + ".");
    }
    compareReferences(a, b, add);
    const std::set<std::string> old_tags(a.tags.begin(), a.tags.end());
    const std::set<std::string> new_tags(b.tags.begin(), b.tags.end());
    if (old_tags != new_tags) {
      add(ChangeKind::TagsChanged, "The tags were " + listed(old_tags) + " and are " + listed(new_tags) + ".");
    }
    if (a.labels != b.labels || a.extra != b.extra || newIdOf(a.placement_parent) != b.placement_parent) {
      add(ChangeKind::LabelsChanged, "The labels or the placement hint changed.");
    }
  }

  /// Parents are compared as nodes, so a parent that was renumbered is no change of its children.
  template <typename Add>
  void compareParents(std::size_t old_index, std::size_t new_index, Add add) const {
    std::set<std::string> lost;
    std::set<std::string> won;
    const auto new_parents = after_.parents(new_index);
    for (const std::size_t parent : before_.parents(old_index)) {
      const auto now = matching_.newOf(parent);
      if (!now || std::find(new_parents.begin(), new_parents.end(), *now) == new_parents.end()) {
        lost.insert(quoted(before_.node(parent).title));
      }
    }
    const auto old_parents = before_.parents(old_index);
    for (const std::size_t parent : new_parents) {
      const auto was = matching_.oldOf(parent);
      if (!was || std::find(old_parents.begin(), old_parents.end(), *was) == old_parents.end()) {
        won.insert(quoted(after_.node(parent).title));
      }
    }
    const bool was_start = isPhenomenon(before_, old_index);
    const bool is_start = isPhenomenon(after_, new_index);
    if (lost.empty() && won.empty() && was_start == is_start) return;
    std::string text = "Direct effects lost: " + listed(lost) + "; gained: " + listed(won) + ".";
    if (was_start != is_start) text += is_start ? " It is now a phenomenon." : " It is no longer a phenomenon.";
    add(ChangeKind::Reparented, text);
  }

  static bool isPhenomenon(const Graph& graph, std::size_t index) {
    return std::find(graph.phenomena().begin(), graph.phenomena().end(), index) != graph.phenomena().end();
  }

  [[nodiscard]] std::string newIdOf(const std::string& old_id) const {
    const auto index = before_.find(old_id);
    const auto now = index ? matching_.newOf(*index) : std::nullopt;
    return now ? after_.node(*now).id : old_id;
  }

  template <typename Add>
  void compareReferences(const Node& a, const Node& b, Add add) const {
    const auto identity = [](const Reference& r, const std::string& parent) {
      return parent + ", " + core::join(std::vector<std::string>{r.author, r.title, r.url, r.note});
    };
    std::multiset<std::string> olds;
    std::multiset<std::string> news;
    for (const Reference& reference : a.references) olds.insert(identity(reference, newIdOf(reference.parent)));
    for (const Reference& reference : b.references) news.insert(identity(reference, reference.parent));
    if (olds == news) return;
    add(ChangeKind::ReferencesChanged,
        "The references changed: " + std::to_string(olds.size()) + " before, " + std::to_string(news.size()) + " now.");
  }

  const Graph& before_;
  const Graph& after_;
  Matching matching_;
  Difference result_;
};

}  // namespace

std::string_view toString(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::Added:
      return "added";
    case ChangeKind::Removed:
      return "removed";
    case ChangeKind::Renumbered:
      return "renumbered";
    case ChangeKind::Renamed:
      return "renamed";
    case ChangeKind::Reparented:
      return "re-parented";
    case ChangeKind::KindChanged:
      return "kind changed";
    case ChangeKind::BlockChanged:
      return "block changed";
    case ChangeKind::DescriptionChanged:
      return "description changed";
    case ChangeKind::ReferencesChanged:
      return "references changed";
    case ChangeKind::TagsChanged:
      return "tags changed";
    case ChangeKind::LabelsChanged:
      return "labels changed";
  }
  return "";
}

Difference difference(const Graph& before, const Graph& after) { return Comparison(before, after).run(); }

}  // namespace percollect
