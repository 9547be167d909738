#include "percollect/write_graph.h"

#include <algorithm>
#include <regex>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/json_object.h"
#include "core/text.h"
#include "percollect/release_readers.h"

namespace percollect {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

bool isPhenomenon(const Graph& graph, std::size_t index) {
  const auto& phenomena = graph.phenomena();
  return std::find(phenomena.begin(), phenomena.end(), index) != phenomena.end();
}

template <std::size_t size>
bool contains(const std::array<std::string_view, size>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Labels and extra values whose keys satisfy `take`, as JSON.
template <typename Take>
ordered_json labelsOf(const Node& node, Take take) {
  ordered_json object = ordered_json::object();
  for (const auto& [key, text] : node.labels) {
    if (take(key, true)) object[key] = text;
  }
  for (const auto& [key, value] : node.extra) {
    if (take(key, false)) object[key] = ordered_json::parse(value);
  }
  return object;
}

ordered_json toJson(const Graph& graph, std::size_t index) {
  const Node& node = graph.node(index);
  ordered_json parents = ordered_json::array();
  for (const std::size_t parent : graph.parents(index)) parents.push_back(graph.node(parent).id);
  ordered_json object{{"id", node.id},
                      {"parentIds", parents},
                      {"title", node.title},
                      {"decomBlock", node.block},
                      {"description", node.description},
                      {"references", node.references_text},
                      {"nodeType", toString(node.kind)},
                      {"tags", node.tags}};
  if (isPhenomenon(graph, index) != parents.empty()) object["phenomenon"] = parents.empty() ? "false" : "true";
  if (!node.placement_parent.empty()) object["placementParentId"] = node.placement_parent;
  object.update(labelsOf(node, [](const std::string& key, bool) { return !contains(kJsonKeys, key); }));
  const ordered_json taken = labelsOf(node, [](const std::string& key, bool) { return contains(kJsonKeys, key); });
  if (!taken.empty()) object["labels"] = taken;
  return object;
}

/// Writes the files of one folder.
class XmlWriter {
 public:
  XmlWriter(const Graph& graph, fs::path folder) : graph_(graph), folder_(std::move(folder)) {}

  void write() {
    // Everything that can be refused is refused before the first file is touched.
    std::vector<std::pair<std::string, std::string>> files{{"root_node.xml", rootFile()}};
    for (std::size_t i = 0; i < graph_.size(); ++i) files.emplace_back(fileNameOf(i), nodeFile(i));
    refuseForeignFiles(files);
    for (const auto& [name, content] : files) core::writeFile(folder_ / name, content);
  }

 private:
  [[nodiscard]] std::string fileNameOf(std::size_t index) const {
    static const std::regex allowed("[A-Za-z0-9_-][A-Za-z0-9_. -]{0,199}");
    const std::string& id = graph_.node(index).id;
    if (id == "root" || !std::regex_match(id, allowed)) {
      fail(index, "the id cannot be the name of a node file.",
           "Use letters, digits, '_', '-', '.' and blanks, and not the word root.");
    }
    return id + "_node.xml";
  }

  [[noreturn]] void fail(std::size_t index, const std::string& problem, const std::string& remedy) const {
    const Node& node = graph_.node(index);
    throw core::InputError({.file = node.file, .line = node.line, .item = "node " + node.id}, problem, remedy);
  }

  void refuseForeignFiles(const std::vector<std::pair<std::string, std::string>>& files) const {
    std::error_code cannot;
    fs::create_directories(folder_, cannot);
    if (cannot) {
      throw core::InputError({.file = folder_}, "cannot be made a folder: " + cannot.message() + ".",
                             "Choose another folder.");
    }
    std::set<std::string> names;
    for (const auto& file : files) names.insert(file.first);
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with("_node.xml") || names.count(name) > 0) continue;
      throw core::InputError({.file = entry.path()}, "is no node of this graph but would become part of it.",
                             "Choose an empty folder, or remove the file.");
    }
  }

  /// Escapes an attribute so that every XML parser gives the same text back. Line breaks stay as they are where other
  /// programs expect blanks instead of them, as the releases do in their references.
  [[nodiscard]] std::string escaped(const std::string& text, bool keeps_line_breaks, std::size_t index) const {
    std::string result;
    for (const char c : core::escapeMarkup(text)) {
      const auto code = static_cast<unsigned char>(c);
      const bool is_break = c == '\n' || c == '\t';
      if (c == '\r' || (is_break && !keeps_line_breaks)) {
        result += "&#" + std::to_string(code) + ";";
      } else if (code < 0x20 && !is_break) {
        fail(index, "a text contains the control character " + std::to_string(code) + ", which XML forbids.",
             "Remove the character, or write the JSON format.");
      } else {
        result += c;
      }
    }
    return result;
  }

  void add(std::string& file, const std::string& name, const std::string& value, std::size_t index,
           bool keeps_line_breaks = false) const {
    file += "            " + name + "=\"" + escaped(value, keeps_line_breaks, index) + "\"\n";
  }

  static std::string opening() { return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<basic_node\n"; }

  /// The namespace is that of the releases, so that programs written for them find the includes.
  void addIncludes(std::string& file, std::span<const std::size_t> nodes) const {
    file += "            xmlns:xi=\"http://www.w3.org/2003/XInclude\">\n";
    for (const std::size_t i : nodes) file += "    <xi:include href=\"./" + fileNameOf(i) + "\" />\n";
    file += "</basic_node>\n";
  }

  [[nodiscard]] std::string rootFile() const {
    std::string file = opening();
    for (const char* name : {"id", "title", "adBlock", "description", "references", "placementParentId"}) {
      add(file, name, std::string(name) == "id" ? "root" : "", 0);
    }
    addIncludes(file, graph_.phenomena());
    return file;
  }

  [[nodiscard]] std::string nodeFile(std::size_t index) const {
    static const std::regex attribute_name("[A-Za-z_][A-Za-z0-9_.-]*");
    const Node& node = graph_.node(index);
    const auto fits = [](const std::string& key, bool is_text) {
      return is_text && std::regex_match(key, attribute_name) && !core::lowerCase(key).starts_with("xml") &&
             key != "noNamespaceSchemaLocation" && !contains(kXmlAttributes, key);
    };
    std::string file = opening();
    add(file, "id", node.id, index);
    add(file, "title", node.title, index);
    add(file, "adBlock", node.block, index);
    add(file, "description", node.description, index);
    add(file, "references", node.references_text, index, true);
    if (node.kind == NodeKind::DesignParameter) add(file, "designParameterCause", "true", index);
    if (node.kind == NodeKind::SystemIndependent) add(file, "systemIndependentCause", "true", index);
    add(file, "placementParentId", node.placement_parent, index);
    if (!node.tags.empty()) add(file, "tags", nlohmann::json(node.tags).dump(), index);
    const ordered_json attributes = labelsOf(node, fits);
    for (const auto& [key, value] : attributes.items()) {
      add(file, key, value.get<std::string>(), index);
    }
    const ordered_json others = labelsOf(node, [&](const std::string& key, bool text) { return !fits(key, text); });
    if (!others.empty()) add(file, "labels", others.dump(), index);
    addIncludes(file, graph_.children(index));
    return file;
  }

  const Graph& graph_;
  fs::path folder_;
};

}  // namespace

void writeJsonRelease(const Graph& graph, const fs::path& file) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < graph.size(); ++i) list.push_back(toJson(graph, i));
  core::writeJson(file, list);
}

void writeXmlRelease(const Graph& graph, const fs::path& folder) { XmlWriter(graph, folder).write(); }

}  // namespace percollect
