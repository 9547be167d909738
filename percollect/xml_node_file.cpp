#include "percollect/xml_node_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <tinyxml2.h>

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "percollect/references.h"
#include "percollect/release_readers.h"

namespace percollect {

using tinyxml2::XMLElement;

namespace {

constexpr std::string_view kXInclude = "http://www.w3.org/2001/XInclude";
constexpr std::string_view kXIncludeAsReleased = "http://www.w3.org/2003/XInclude";  // sic, in all released files

/// Thrown and caught in this file: what makes it unusable.
struct Problem {
  int line;
  std::string text;
};

/// What tinyxml2 does not look at before or while it parses.
void checkText(const std::string& text) {
  if (const auto offset = core::findInvalidUtf8(text)) {
    throw Problem{core::lineAt(text, *offset), "is not UTF-8"};
  }
  if (const auto zero = text.find('\0'); zero != std::string::npos) {
    throw Problem{core::lineAt(text, zero), "contains a zero byte"};
  }
}

/// The element of the document, alone but for comments and declarations. tinyxml2 lets text and further elements pass.
const XMLElement& rootOf(const tinyxml2::XMLDocument& document) {
  const XMLElement* root = nullptr;
  for (const auto* node = document.FirstChild(); node; node = node->NextSibling()) {
    if (node->ToUnknown()) {
      throw Problem{node->GetLineNum(), "declares a document type (DTD), which is refused because of its entities"};
    }
    if (node->ToText()) throw Problem{node->GetLineNum(), "is not well-formed: text outside of the element"};
    if (node->ToElement() && root) throw Problem{node->GetLineNum(), "is not well-formed: a second outermost element"};
    if (node->ToElement()) root = node->ToElement();
  }
  if (document.Error()) {
    throw Problem{document.ErrorLineNum(), std::string("is not well-formed (") + document.ErrorName() + ")"};
  }
  if (!root) throw Problem{1, "is not well-formed: it has no element"};
  return *root;
}

std::string_view localName(std::string_view name) { return name.substr(name.find(':') + 1); }  // npos + 1 == 0

/// The namespace that the element's prefix stands for; "" if it is not declared.
std::string namespaceOf(const XMLElement& element) {
  const std::string name = element.Name();
  const auto colon = name.find(':');
  const std::string declaration = colon == std::string::npos ? "xmlns" : "xmlns:" + name.substr(0, colon);
  for (const tinyxml2::XMLNode* at = &element; at && at->ToElement(); at = at->Parent()) {
    if (const char* uri = at->ToElement()->Attribute(declaration.c_str())) return uri;
  }
  return "";
}

class FileReader {
 public:
  FileReader(XmlNodeFile& result, const XMLElement& root) : result_(result), node_(result.node), root_(root) {}

  void read() {
    if (localName(root_.Name()) != "basic_node") {
      throw Problem{root_.GetLineNum(),
                    std::string("is no node file: its element is <") + root_.Name() + ">, not <basic_node>"};
    }
    readId();
    node_.file = result_.file;
    node_.line = root_.GetLineNum();
    node_.title = text("title");
    node_.block = text("adBlock");
    node_.description = text("description");
    node_.references_text = text("references");
    node_.references = parseReferences(node_.references_text);
    node_.placement_parent = text("placementParentId");
    readKind();
    readTags();
    readLabels();
    readChildren();
    reportOpenEntities();
  }

 private:
  void warn(int line, const std::string& what, const std::string& remedy) {
    result_.findings.push_back({Severity::Warning, result_.file, line, node_.id, what, remedy});
  }

  [[nodiscard]] std::string fileStem() const {
    std::string stem = result_.file.stem().string();
    if (stem.ends_with("_node")) stem.resize(stem.size() - 5);
    return stem;
  }

  void readId() {
    const char* id = root_.Attribute("id");
    node_.id = id ? id : "";
    const std::string stem = fileStem();
    if (node_.id.empty()) {
      node_.id = stem;
      warn(root_.GetLineNum(), "the node has no id; that of its file name was taken.", "Write id=\"" + stem + "\".");
    } else if (node_.id != stem) {
      warn(root_.GetLineNum(), "the id does not fit the file name.",
           "Name the file " + node_.id + "_node.xml, or correct the id.");
    }
  }

  std::string text(const char* attribute) {
    if (const char* value = root_.Attribute(attribute)) return value;
    warn(root_.GetLineNum(), std::string("the attribute ") + attribute + " is missing.", "Add it, empty if need be.");
    return "";
  }

  bool flag(const char* attribute) {
    const char* value = root_.Attribute(attribute);
    if (!value) return false;
    const std::string word = value;
    if (word != "true" && word != "false") {
      throw Problem{root_.GetLineNum(), std::string("has ") + attribute + "=\"" + word + "\"; only \"true\" and " +
                                            "\"false\" have a meaning"};
    }
    return word == "true";
  }

  void readKind() {
    const bool is_design = flag("designParameterCause");
    const bool is_independent = flag("systemIndependentCause");
    if (is_design && is_independent) {
      throw Problem{root_.GetLineNum(), "is both a design parameter and a system-independent cause"};
    }
    node_.kind = is_design        ? NodeKind::DesignParameter
                 : is_independent ? NodeKind::SystemIndependent
                                  : NodeKind::Effect;
  }

  /// Tags are this program's addition to the format: a JSON list of texts.
  void readTags() {
    const char* value = root_.Attribute("tags");
    if (!value) return;
    const auto list = nlohmann::json::parse(value, nullptr, false);
    const bool is_list =
        list.is_array() && std::all_of(list.begin(), list.end(), [](const auto& tag) { return tag.is_string(); });
    node_.tags = is_list ? list.get<std::vector<std::string>>() : std::vector<std::string>{value};
  }

  /// Further attributes are labels; the attribute "labels" holds those that cannot be attributes, as a JSON object.
  void readLabels() {
    for (const auto* attribute = root_.FirstAttribute(); attribute; attribute = attribute->Next()) {
      const std::string name = attribute->Name();
      const bool is_syntax = name.starts_with("xmlns") || localName(name) == "noNamespaceSchemaLocation";
      const bool is_known = std::find(kXmlAttributes.begin(), kXmlAttributes.end(), name) != kXmlAttributes.end();
      if (!is_syntax && !is_known) node_.labels[name] = attribute->Value();
    }
    const char* value = root_.Attribute("labels");
    if (!value) return;
    const auto object = nlohmann::json::parse(value, nullptr, false);
    if (!object.is_object()) {
      node_.labels["labels"] = value;
      return;
    }
    for (const auto& [key, label] : object.items()) {
      if (label.is_string()) {
        node_.labels[key] = label.template get<std::string>();
      } else {
        node_.extra[key] = label.dump();
      }
    }
  }

  void readChildren() {
    for (const auto* child = root_.FirstChild(); child; child = child->NextSibling()) {
      if (child->ToComment()) continue;
      const XMLElement* element = child->ToElement();
      if (element && localName(element->Name()) == "include") {
        readInclude(*element);
      } else {
        const std::string what = element ? std::string("the element <") + element->Name() + ">" : "the text";
        warn(child->GetLineNum(), what + " has no meaning in a node file and was left out.",
             "Remove it, or write it as an attribute.");
      }
    }
  }

  void readInclude(const XMLElement& element) {
    const int line = element.GetLineNum();
    const std::string uri = namespaceOf(element);
    if (uri != kXInclude && uri != kXIncludeAsReleased) {
      warn(line, "the include is in the namespace '" + uri + "'; it was read as XInclude.",
           "Declare xmlns:xi=\"" + std::string(kXInclude) + "\".");
    }
    const char* href = element.Attribute("href");
    if (!href) throw Problem{line, "has an include without href"};
    for (const auto* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next()) {
      const std::string name = attribute->Name();
      if (name == "href" || name.starts_with("xmlns")) continue;
      warn(line, "the attribute " + name + " of the include was left out.", "Remove it.");
    }
    if (!element.NoChildren()) warn(line, "the content of the include was left out.", "Remove it.");
    result_.includes.push_back({href, line});
  }

  /// tinyxml2 keeps what it cannot resolve as written, so nothing is lost; but another program would stop here.
  void reportOpenEntities() {
    static const std::regex resolved("&(amp|lt|gt|quot|apos|#[0-9]+|#x[0-9a-fA-F]+);");
    for (std::size_t at = result_.content.find('&'); at != std::string::npos; at = result_.content.find('&', at + 1)) {
      const std::size_t comment = result_.content.rfind("<!--", at);
      const bool in_comment = comment != std::string::npos && result_.content.find("-->", comment) > at;
      const auto begin = result_.content.begin() + static_cast<std::ptrdiff_t>(at);
      if (in_comment ||
          std::regex_search(begin, result_.content.end(), resolved, std::regex_constants::match_continuous)) {
        continue;
      }
      warn(core::lineAt(result_.content, at), "an '&' begins no known entity; it was kept as written.",
           "Write '&amp;' for the character itself.");
      return;
    }
  }

  XmlNodeFile& result_;
  Node& node_;
  const XMLElement& root_;
};

}  // namespace

XmlNodeFile readXmlNodeFile(const std::filesystem::path& file) {
  XmlNodeFile result;
  result.file = file;
  result.content = core::readFile(file);
  try {
    checkText(result.content);
    tinyxml2::XMLDocument document;
    document.Parse(result.content.data(), result.content.size());
    FileReader(result, rootOf(document)).read();
  } catch (const Problem& problem) {
    result.problem = problem.text;
    result.problem_line = problem.line;
  }
  return result;
}

}  // namespace percollect
