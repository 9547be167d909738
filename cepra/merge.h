#pragma once

#include <set>
#include <string>
#include <vector>

#include "cepra/table.h"

namespace cepra {

/// What became of a scored table when the graph got a new release.
struct Merge {
  Table table;
  std::size_t kept = 0;              ///< rows with input whose key, titles and causes agree: untouched
  std::vector<std::string> suspect;  ///< keys of rows that this merge marked
  std::vector<std::string> added;    ///< keys that are new
  std::vector<std::string> dropped;  ///< keys of rows that are gone and held nothing
};

/// Carries scores over to the rows of a new release, `fresh`, and never binds one silently to something else:
///
///   key and titles agree               scores stay
///   key agrees, a title or cause not   scores stay, row is suspect and says what changed
///   titles agree, ids do not           scores are copied, new row is suspect; the old row stays as gone
///   path is no more                    row stays at the end, gone and suspect, if it holds input or is in `linked`
///
/// `linked`: keys that others refer to. Throws InputError if the tables are of different trees.
[[nodiscard]] Merge merge(const Table& scored, Table fresh, const std::set<std::string>& linked = {});

}  // namespace cepra
