#include "percollect/finding.h"

#include "core/error.h"

namespace percollect {

std::string_view toString(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "";
}

std::string toString(const Finding& finding) {
  std::string text = core::toString(
      {.file = finding.file, .line = finding.line, .item = finding.node.empty() ? "" : "node " + finding.node});
  if (!text.empty()) text += ": ";
  text += std::string(toString(finding.severity)) + ": " + finding.text;
  if (!finding.remedy.empty()) text += " " + finding.remedy;
  return text;
}

}  // namespace percollect
