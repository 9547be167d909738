#include "percollect/references.h"

#include <algorithm>
#include <span>
#include <string>

#include "core/text.h"

namespace percollect {

namespace {

std::vector<std::string> splitAtCommas(std::string_view group) {
  std::vector<std::string> fields;
  while (true) {
    const std::size_t comma = group.find(',');
    fields.push_back(core::trimmed(group.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    group.remove_prefix(comma + 1);
  }
}

bool isAddress(const std::string& field) { return field.starts_with("http://") || field.starts_with("https://"); }

Reference parseGroup(std::string_view group) {
  Reference reference;
  reference.raw = std::string(group);
  const std::vector<std::string> fields = splitAtCommas(group);
  reference.parent = fields.front();
  const std::span rest = std::span(fields).subspan(1);
  const auto url = static_cast<std::size_t>(std::find_if(rest.begin(), rest.end(), isAddress) - rest.begin());
  const std::span before = rest.first(url);
  if (!before.empty()) {
    reference.author = before[0];
    reference.title = core::join(before.subspan(1));
  }
  if (url < rest.size()) {
    reference.url = rest[url];
    reference.note = core::join(rest.subspan(url + 1));
  }
  return reference;
}

/// Calls `group` for every bracketed group and `stray` for text outside; returns false if the last bracket is missing.
template <typename Group, typename Stray>
bool scanGroups(std::string_view text, Group group, Stray stray) {
  while (true) {
    const std::size_t open = text.find('[');
    if (!core::trimmed(text.substr(0, open)).empty()) stray(core::trimmed(text.substr(0, open)));
    if (open == std::string_view::npos) return true;
    text.remove_prefix(open + 1);
    const std::size_t close = text.find(']');
    const std::string_view content = text.substr(0, close);
    if (!core::trimmed(content).empty()) group(content);
    if (close == std::string_view::npos) return false;
    text.remove_prefix(close + 1);
  }
}

/// Collects the notes on one node.
class ReferenceCheck {
 public:
  ReferenceCheck(const Graph& graph, std::vector<Finding>& findings) : graph_(graph), findings_(findings) {}

  void node(std::size_t index) {
    at_ = &graph_.node(index);
    const bool closed = scanGroups(
        at_->references_text, [](std::string_view) {},
        [this](const std::string& text) {
          add("text outside of brackets in the references: '" + text + "'.", "Put it into a [parent, ...] group.");
        });
    if (!closed) add("the references lack their last bracket ']'.", "Add it; the text was read as if it were there.");
    for (const Reference& reference : at_->references) checkParent(index, reference);
    for (const std::size_t parent : graph_.parents(index)) checkEdge(graph_.node(parent).id);
  }

 private:
  void checkParent(std::size_t index, const Reference& reference) {
    const auto parent = graph_.find(reference.parent);
    const auto parents = graph_.parents(index);
    if (!parent) {
      add("a reference names '" + reference.parent + "', which is no node.", "Correct the id in the reference.");
    } else if (std::find(parents.begin(), parents.end(), *parent) == parents.end()) {
      add("a reference names " + reference.parent + " ('" + graph_.node(*parent).title +
              "'), which is no direct effect.",
          "Correct the id in the reference, or add the edge.");
    }
  }

  void checkEdge(const std::string& parent) {
    const bool has = std::any_of(at_->references.begin(), at_->references.end(),
                                 [&](const Reference& reference) { return reference.parent == parent; });
    if (!has) add("the edge to its effect " + parent + " has no reference.", "Add a [" + parent + ", ...] group.");
  }

  void add(const std::string& text, const std::string& remedy) {
    const Finding finding{Severity::Note, at_->file, at_->line, at_->id, text, remedy};
    if (std::find(findings_.begin(), findings_.end(), finding) == findings_.end()) findings_.push_back(finding);
  }

  const Graph& graph_;
  std::vector<Finding>& findings_;
  const Node* at_ = nullptr;
};

}  // namespace

std::vector<Reference> parseReferences(std::string_view text) {
  std::vector<Reference> references;
  scanGroups(
      text, [&](std::string_view group) { references.push_back(parseGroup(group)); }, [](const std::string&) {});
  return references;
}

std::vector<Finding> checkReferences(const Graph& graph) {
  std::vector<Finding> findings;
  ReferenceCheck check(graph, findings);
  for (std::size_t i = 0; i < graph.size(); ++i) check.node(i);
  return findings;
}

}  // namespace percollect
