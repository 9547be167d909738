#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "percollect/release_readers.h"
#include "percollect/xml_node_file.h"

namespace percollect {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRootFile = "root_node.xml";

/// "sp2" before "sp10": runs of digits compare as numbers, everything else byte by byte.
bool naturallyLess(const std::string& a, const std::string& b) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const auto run = [&](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0') ++at;
      const std::size_t begin = at;
      while (at < text.size() && isDigit(text[at])) ++at;
      return text.substr(begin, at - begin);
    };
    const std::string left = run(a, i);
    const std::string right = run(b, j);
    if (left.size() != right.size()) return left.size() < right.size();
    if (left != right) return left < right;
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;  // differ in leading zeros only
}

/// Names of the node files in the folder, without root_node.xml.
std::vector<std::string> nodeFilesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with("_node.xml") && name != kRootFile && entry.is_regular_file()) names.push_back(name);
  }
  std::sort(names.begin(), names.end(), naturallyLess);
  return names;
}

/// Joins the files of one folder.
class Joiner {
 public:
  explicit Joiner(const fs::path& folder) : folder_(folder), root_(readXmlNodeFile(folder / kRootFile)) {
    if (!root_.problem.empty()) {
      throw core::InputError({.file = root_.file, .line = root_.problem_line}, root_.problem + ".",
                             "Mend the file; it says where the chains begin.");
    }
    for (const std::string& name : nodeFilesIn(folder)) {
      names_.push_back(name);
      files_.push_back(readXmlNodeFile(folder / name));
    }
  }

  Release join() {
    release_.data.source = folder_;
    release_.data.sha256 = hash();
    takeNodes();
    for (const XmlNodeFile& file : files_) {
      if (file.problem.empty()) connect(file);
    }
    for (const auto& [index, include] : targets(root_)) release_.data.phenomena.push_back(index);
    return std::move(release_);
  }

 private:
  using Target = std::pair<std::size_t, const XmlNodeFile::Include*>;

  [[nodiscard]] std::string hash() const {
    std::string list = core::sha256(root_.content) + " " + kRootFile + "\n";
    for (std::size_t i = 0; i < files_.size(); ++i) list += core::sha256(files_[i].content) + " " + names_[i] + "\n";
    return core::sha256(list);
  }

  void takeNodes() {
    for (std::size_t i = 0; i < files_.size(); ++i) {
      XmlNodeFile& file = files_[i];
      release_.findings.insert(release_.findings.end(), file.findings.begin(), file.findings.end());
      if (file.problem.empty()) {
        index_[names_[i]] = release_.data.nodes.size();
        release_.data.nodes.push_back(file.node);
      } else {
        broken_[names_[i]] = &file;
        release_.findings.push_back({Severity::Warning, file.file, file.problem_line, idOfFile(names_[i]),
                                     "the file " + file.problem + "; it was skipped.",
                                     "Mend or remove it; no other file includes it."});
      }
    }
  }

  static std::string idOfFile(const std::string& name) { return name.substr(0, name.rfind("_node.xml")); }

  void connect(const XmlNodeFile& file) {
    const std::size_t parent = index_.at(file.file.filename().string());
    for (const auto& [child, include] : targets(file)) {
      if (child != parent) {
        release_.data.edges.push_back({parent, child});
      } else {
        warn(file, include->line, "the node includes itself; the edge was left out.", "Remove this include.");
      }
    }
  }

  /// The nodes that a file includes, each once.
  std::vector<Target> targets(const XmlNodeFile& file) {
    std::vector<Target> list;
    std::set<std::size_t> seen;
    for (const XmlNodeFile::Include& include : file.includes) {
      const std::size_t index = resolve(file, include);
      if (seen.insert(index).second) {
        list.emplace_back(index, &include);
      } else {
        warn(file, include.line, "'" + include.href + "' is included twice.", "Remove one of the two includes.");
      }
    }
    return list;
  }

  void warn(const XmlNodeFile& file, int line, const std::string& text, const std::string& remedy) {
    release_.findings.push_back({Severity::Warning, file.file, line, file.node.id, text, remedy});
  }

  /// The node behind an href. Only a file in the same folder is ever looked up, and only by name.
  [[nodiscard]] std::size_t resolve(const XmlNodeFile& file, const XmlNodeFile::Include& include) const {
    const core::Place place{.file = file.file, .line = include.line, .item = "node " + file.node.id};
    const std::string& href = include.href;
    const std::string name = href.starts_with("./") ? href.substr(2) : href;
    if (name.find_first_of("/\\:") != std::string::npos || name == "..") {
      throw core::InputError(place, "includes '" + href + "', which does not lie in the same folder.",
                             "Write './<id>_node.xml'; other folders and addresses are refused.");
    }
    if (const auto found = index_.find(name); found != index_.end()) return found->second;
    if (name == kRootFile) {
      throw core::InputError(place, "includes root_node.xml: a cycle.", "Remove this include.");
    }
    if (const auto broken = broken_.find(name); broken != broken_.end()) {
      throw core::InputError(place,
                             "includes '" + href + "', which " + broken->second->problem + " (line " +
                                 std::to_string(broken->second->problem_line) + ").",
                             "Mend that file, or remove this include; the graph would lack its part.");
    }
    std::vector<std::string> names;
    for (const auto& [known, index] : index_) names.push_back(known);
    const std::string nearest = core::nearestName(name, names);
    throw core::InputError(place, "includes '" + href + "', which does not exist.",
                           nearest.empty() ? "Add the file, or remove this include."
                                           : "Add the file, remove this include, or did you mean './" + nearest + "'?");
  }

  fs::path folder_;
  XmlNodeFile root_;
  std::vector<std::string> names_;
  std::vector<XmlNodeFile> files_;
  std::map<std::string, std::size_t> index_;  ///< of the node in a file
  std::map<std::string, const XmlNodeFile*> broken_;
  Release release_;
};

}  // namespace

Release readXmlRelease(const fs::path& folder) { return Joiner(folder).join(); }

}  // namespace percollect
