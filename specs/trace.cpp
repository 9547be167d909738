#include "specs/trace.h"

#include <algorithm>
#include <set>

#include "core/error.h"
#include "core/text.h"
#include "specs/shown_id.h"

namespace specs {

namespace {

const std::vector<Link> kNone;

template <class Links>
const std::vector<Link>& at(const Links& links, std::string_view id) {
  const auto found = links.find(id);
  return found == links.end() ? kNone : found->second;
}

/// Breadth first along `next`, which returns links; `end` says which end of them to go on from.
template <class Next>
std::vector<std::string> reach(std::string_view id, const Next& next, std::string Link::*end) {
  std::vector<std::string> found = {std::string(id)};
  std::set<std::string> seen = {found.front()};
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const Link& link : next(found[i])) {
      if (seen.insert(link.*end).second) found.push_back(link.*end);
    }
  }
  found.erase(found.begin());
  return found;
}

/// Writes the tree on one side of an item.
class TreeWriter {
 public:
  TreeWriter(const Specification& specification, const LinkIndex& index, bool back)
      : specification_(specification), index_(index), back_(back) {}

  void write(const std::string& id, int depth) {
    for (const Link& link : back_ ? index_.originsOf(id) : index_.followersOf(id)) {
      const std::string& other = back_ ? link.from : link.to;
      const bool again = !shown_.insert(other).second;
      text += std::string(static_cast<std::size_t>(depth) * 2, ' ') + line(other) +
              (link.suspect ? "  [suspect link]" : "") + (again ? "  (see above)" : "") + "\n";
      if (!again) write(other, depth + 1);
    }
  }

  [[nodiscard]] std::string line(const std::string& id) const {
    const Entry* entry = index_.find(id);
    if (!entry) return id + "  (missing)";
    std::string words(name(entry->kind));
    if (entry->status) words += ", " + std::string(name(*entry->status));
    if (const auto verdict = specification_.verdicts.find(id); verdict != specification_.verdicts.end()) {
      words += ", " + std::string(name(verdict->second.verdict));
    }
    return id + "  " + words + ": " + entry->title;
  }

  std::string text;

 private:
  const Specification& specification_;
  const LinkIndex& index_;
  bool back_;
  std::set<std::string> shown_;
};

}  // namespace

LinkIndex::LinkIndex(const Specification& specification) {
  const auto enter = [&](Kind kind, const auto& items) {
    for (const Item& item : items) {
      entries_[item.id] = {.kind = kind, .id = item.id, .title = item.title, .status = item.status};
    }
  };
  enter(Kind::Requirement, specification.requirements);
  enter(Kind::AcceptanceTest, specification.tests);
  enter(Kind::ExperimentData, specification.experiment_data);
  enter(Kind::ReferenceData, specification.reference_data);
  for (const cepra::Row& row : specification.cepra.rows) {
    entries_[row.key] = {.kind = Kind::CepraRow, .id = row.key, .title = rowTitle(row), .status = std::nullopt};
  }
  for (const Link& link : specification.links) {
    followers_[link.from].push_back(link);
    origins_[link.to].push_back(link);
  }
  for (auto& [id, links] : followers_) {
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return naturallyLess(a.to, b.to); });
  }
  for (auto& [id, links] : origins_) {
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return naturallyLess(a.from, b.from); });
  }
}

const Entry* LinkIndex::find(std::string_view id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second;
}

const std::vector<Link>& LinkIndex::originsOf(std::string_view id) const { return at(origins_, id); }
const std::vector<Link>& LinkIndex::followersOf(std::string_view id) const { return at(followers_, id); }

std::vector<std::string> LinkIndex::allOriginsOf(std::string_view id) const {
  return reach(
      id, [&](const std::string& here) { return originsOf(here); }, &Link::from);
}

std::vector<std::string> LinkIndex::allFollowersOf(std::string_view id) const {
  return reach(
      id, [&](const std::string& here) { return followersOf(here); }, &Link::to);
}

std::string traceText(const Specification& specification, const std::string& id) {
  const LinkIndex index(specification);
  if (!index.find(id)) {
    std::vector<std::string> ids;
    for (const auto& item : specification.requirements) ids.push_back(item.id);
    for (const auto& item : specification.tests) ids.push_back(item.id);
    for (const auto& item : specification.experiment_data) ids.push_back(item.id);
    for (const auto& item : specification.reference_data) ids.push_back(item.id);
    const std::string nearest = core::nearestName(id, ids);
    throw core::InputError(
        {.item = id}, "there is no such item in the project.",
        nearest.empty() ? "'fidelis spec export' lists what there is." : "Did you mean '" + nearest + "'?");
  }
  TreeWriter back(specification, index, true);
  TreeWriter on(specification, index, false);
  back.write(id, 1);
  on.write(id, 1);
  const auto side = [](const char* heading, const std::string& tree) {
    return std::string(heading) + (tree.empty() ? ": nothing\n" : "\n" + tree);
  };
  return on.line(id) + "\n" + side("follows from", back.text) + side("leads to", on.text);
}

}  // namespace specs
