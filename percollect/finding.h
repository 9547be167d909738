#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace percollect {

enum class Severity {
  Note,     ///< worth knowing; nothing was changed
  Warning,  ///< something was left out or looks wrong; the graph is usable
  Error,    ///< must be repaired
};

[[nodiscard]] std::string_view toString(Severity severity);  // "note", "warning", "error"

/// One thing that a reader should know about a graph: what, where, and what to do about it.
/// Whatever makes a graph unusable is no finding but an InputError.
struct Finding {
  Severity severity = Severity::Warning;
  std::filesystem::path file;
  int line = 0;      ///< 1-based; 0: not known
  std::string node;  ///< id; may be empty
  std::string text;
  std::string remedy;

  bool operator==(const Finding&) const = default;
};

/// "file:line, node id: warning: text remedy" on one line.
[[nodiscard]] std::string toString(const Finding& finding);

}  // namespace percollect
