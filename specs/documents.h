#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "specs/project_store.h"

namespace specs {

/// A document made from a specification. The same specification gives the same bytes: no clock, no paths of this
/// machine.
struct DocumentFormat {
  std::string_view name;   ///< of the option: "html"
  std::string_view title;  ///< for the help
  bool is_folder;          ///< writes several files into a folder instead of one file
  void (*write)(const Specification& specification, const std::filesystem::path& target);
};

/// All of them; a new one is one file and one line in documents.cpp.
[[nodiscard]] std::span<const DocumentFormat> documentFormats();

/// One self-contained page: every id is an anchor, traces lead both ways, status by word and colour, made for print
/// too.
void writeHtml(const Specification& specification, const std::filesystem::path& file);
[[nodiscard]] std::string htmlText(const Specification& specification);

/// One sheet a list, with filters, frozen headings and drop-downs for the status.
void writeXlsx(const Specification& specification, const std::filesystem::path& file);

/// Everything as one JSON object, for scripts.
void writeJsonDump(const Specification& specification, const std::filesystem::path& file);

}  // namespace specs
