#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "specs/project_store.h"

namespace specs {

/// The specification as CSV lists for git and spreadsheets, one file a kind:
///
///   requirements.csv  acceptance_tests.csv  experiment_data.csv  reference_data.csv  links.csv  cepra.csv
///
/// UTF-8 with byte order mark (so that spreadsheets see the umlauts), columns as in fields.h. A text that a spreadsheet
/// would take for a formula (it begins with = + - @) gets an apostrophe in front, which reading removes. Nothing is
/// lost. cepra.csv is cepra::exportCsv's. Creates the folder.
void writeLists(const Specification& specification, const std::filesystem::path& folder);

/// What the files of a folder say, on top of `before`: items are found by uid, else by id; columns left out keep what
/// the item has; a list whose file is absent stays as it is. Items and links that a list lacks are in `missing`.
struct ReadLists {
  Specification specification;
  std::vector<std::string> files;    ///< names of the lists that were read
  std::vector<std::string> missing;  ///< ids, or "from -> to", that the project has and the lists have not
};

/// All or nothing: throws InputError that names file, line and column for an unknown column, status or level, a doubled
/// id, or a folder without any list.
[[nodiscard]] ReadLists readLists(const std::filesystem::path& folder, const Specification& before);

/// How many items and links were touched.
struct ListChanges {
  std::size_t added = 0;
  std::size_t changed = 0;
  std::size_t removed = 0;
};

/// Makes the store hold what the lists say, in one action. What they lack is removed only if `remove_missing`.
ListChanges applyLists(ProjectStore& store, const ReadLists& lists, bool remove_missing, const Signature& by);

/// A cell as a spreadsheet takes it for text, and back.
[[nodiscard]] std::string guardedCell(const std::string& text);
[[nodiscard]] std::string unguardedCell(const std::string& cell);

}  // namespace specs
