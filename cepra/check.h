#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cepra/table.h"
#include "percollect/finding.h"

namespace cepra {

using percollect::Severity;

/// One thing to look at in a table.
struct Finding {
  Severity severity = Severity::Warning;
  std::filesystem::path file;  ///< of an import; else empty
  int line = 0;                ///< of an import; else 0
  std::string row;             ///< key; may be empty
  std::string column;          ///< as in the CSV; may be empty
  std::string text;
  std::string remedy;

  bool operator==(const Finding&) const = default;
};

/// "file:line, row r0123456789ab, column impact: warning: text remedy" on one line.
[[nodiscard]] std::string toString(const Finding& finding);

/// Completeness and sense of a table, row by row: a score out of 1 ... 10 (error), doubled keys (error); a score
/// without rationale or expert, a rationale without score, only one of occurrence and impact scored, suspect rows
/// (warnings); an effect without any cause, both scores by the same expert (notes).
[[nodiscard]] std::vector<Finding> check(const Table& table);

}  // namespace cepra
