#include <algorithm>
#include <set>
#include <unordered_map>

#include "core/error.h"
#include "core/file.h"
#include "core/json_object.h"
#include "core/text.h"
#include "percollect/references.h"
#include "percollect/release_readers.h"

namespace percollect {

using nlohmann::json;

namespace {

/// The line on which each element of the outermost array begins. The text is known to be valid JSON.
std::vector<int> elementLines(std::string_view text) {
  std::vector<int> lines;
  int line = 1;
  int depth = 0;
  bool in_string = false;
  bool expects_element = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++line;
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    const bool is_space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (depth == 1 && expects_element && !is_space && c != ']') {
      lines.push_back(line);
      expects_element = false;
    }
    if (c == '"') in_string = true;
    if (c == '[' || c == '{') expects_element = ++depth == 1;
    if (c == ']' || c == '}') --depth;
    if (c == ',' && depth == 1) expects_element = true;
  }
  return lines;
}

/// Reads one object into a node, and remembers what it says about edges for when all nodes are known.
class NodeReader {
 public:
  NodeReader(const json& object, const std::filesystem::path& file, int line, std::vector<Finding>& findings)
      : object_(object), findings_(findings) {
    node_.file = file;
    node_.line = line;
    if (!object.is_object()) {
      fail("is a " + std::string(object.type_name()) + "; a node, { ... }, was expected.", "Remove it.");
    }
    node_.id = readId();
  }

  void read() {
    node_.title = textOf("title");
    node_.kind = readKind();
    node_.block = optionalText("decomBlock");
    checkBlock();
    node_.description = optionalText("description");
    node_.references_text = optionalText("references");
    node_.references = parseReferences(node_.references_text);
    if (object_.contains("tags")) node_.tags = textsOf("tags");
    if (object_.contains("placementParentId")) node_.placement_parent = textOf("placementParentId");
    readParents();
    readLabels();
  }

  [[nodiscard]] Node& node() { return node_; }
  [[nodiscard]] const std::vector<std::string>& parents() const { return parents_; }

  [[nodiscard]] bool isPhenomenon() const {
    if (!object_.contains("phenomenon")) return parents_.empty();
    const std::string word = textOf("phenomenon");
    if (word != "true" && word != "false") fail("\"phenomenon\" is '" + word + "'.", "Write \"true\" or \"false\".");
    return word == "true";
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw core::InputError({.file = node_.file, .line = node_.line, .item = node_.id.empty() ? "" : "node " + node_.id},
                           problem, remedy);
  }

 private:
  void warn(const std::string& text, const std::string& remedy) {
    findings_.push_back({Severity::Warning, node_.file, node_.line, node_.id, text, remedy});
  }

  std::string readId() {
    const auto found = object_.find("id");
    if (found == object_.end()) fail("the node has no \"id\".", "Add an id that no other node has.");
    if (found->is_string()) return found->get<std::string>();
    if (!found->is_number_integer()) fail("the \"id\" is no text.", "Write it in quotes.");
    node_.id = found->dump();
    warn("the \"id\" is a number.", "Write it in quotes, as text.");
    return node_.id;
  }

  [[nodiscard]] std::string textOf(const std::string& key) const {
    const auto found = object_.find(key);
    if (found == object_.end()) fail("\"" + key + "\" is missing.", "Add it.");
    if (!found->is_string()) fail("\"" + key + "\" is no text.", "Write it in quotes.");
    return found->get<std::string>();
  }

  std::string optionalText(const std::string& key) {
    if (object_.contains(key)) return textOf(key);
    warn("\"" + key + "\" is missing.", "Add it, empty if need be.");
    return "";
  }

  [[nodiscard]] std::vector<std::string> textsOf(const std::string& key) const {
    const auto found = object_.find(key);
    if (found == object_.end()) fail("\"" + key + "\" is missing.", "Add it; [] stands for none.");
    const bool is_list = found->is_array() && std::all_of(found->begin(), found->end(),
                                                          [](const json& element) { return element.is_string(); });
    if (!is_list) fail("\"" + key + "\" is no list of texts.", "Write [\"...\", \"...\"].");
    return found->get<std::vector<std::string>>();
  }

  NodeKind readKind() {
    const std::string word = textOf("nodeType");
    const auto kind = nodeKindOf(word);
    if (!kind) {
      fail("\"nodeType\" is '" + word + "'; known are effect, designParameter and systemIndependent.",
           "Choose one of them.");
    }
    if (word != toString(*kind)) {
      warn("\"nodeType\" is '" + word + "'.", "Write it '" + std::string(toString(*kind)) + "'.");
    }
    return *kind;
  }

  void checkBlock() {
    if (node_.block.empty() || std::find(kBlocks.begin(), kBlocks.end(), node_.block) != kBlocks.end()) return;
    const std::vector<std::string> known(kBlocks.begin(), kBlocks.end());
    warn("the block '" + node_.block + "' is none of the signal chain's: " + core::join(known) + ".",
         "Correct it, or leave it if the tree has blocks of its own.");
  }

  void readParents() {
    std::set<std::string> seen;
    for (const std::string& parent : textsOf("parentIds")) {
      if (parent == node_.id) {
        warn("the node names itself as its parent; the edge was left out.", "Remove it from \"parentIds\".");
      } else if (!seen.insert(parent).second) {
        warn("the parent " + parent + " is named twice.", "Remove one of the two from \"parentIds\".");
      } else {
        parents_.push_back(parent);
      }
    }
  }

  void readLabels() {
    for (const auto& [key, value] : object_.items()) {
      if (std::find(kJsonKeys.begin(), kJsonKeys.end(), key) == kJsonKeys.end()) addLabel(key, value);
    }
    const auto labels = object_.find("labels");  // those whose names the format itself uses
    if (labels == object_.end()) return;
    if (!labels->is_object()) return addLabel("labels", *labels);
    for (const auto& [key, value] : labels->items()) addLabel(key, value);
  }

  void addLabel(const std::string& key, const json& value) {
    if (value.is_string()) {
      node_.labels[key] = value.get<std::string>();
    } else {
      node_.extra[key] = value.dump();
    }
  }

  const json& object_;
  std::vector<Finding>& findings_;
  Node node_;
  std::vector<std::string> parents_;
};

}  // namespace

Release readJsonRelease(const std::filesystem::path& file) {
  const json list = core::readJson(file);
  const std::string text = core::readFile(file);
  if (!list.is_array()) {
    throw core::InputError({.file = file, .line = 1},
                           "is no cause-effect graph: a list of nodes, [ ... ], was expected.",
                           "Give the data.json of a PerCollECT release.");
  }
  Release release;
  release.data.source = file;
  release.data.sha256 = core::sha256OfFile(file);
  const std::vector<int> lines = elementLines(text);
  std::vector<NodeReader> readers;
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < list.size(); ++i) {
    readers.emplace_back(list[i], file, lines[i], release.findings).read();
    index.emplace(readers.back().node().id, i);
    if (readers.back().isPhenomenon()) release.data.phenomena.push_back(i);
  }
  for (std::size_t i = 0; i < readers.size(); ++i) {
    for (const std::string& parent : readers[i].parents()) {
      const auto found = index.find(parent);
      if (found == index.end()) {
        readers[i].fail("its parent " + parent + " does not exist.",
                        "Correct \"parentIds\", or add the node that is missing.");
      }
      release.data.edges.push_back({found->second, i});
    }
    release.data.nodes.push_back(std::move(readers[i].node()));
  }
  return release;
}

}  // namespace percollect
