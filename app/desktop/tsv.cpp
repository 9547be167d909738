#include "app/desktop/tsv.h"

namespace desktop {

namespace {

std::string quoted(const std::string& cell) {
  if (cell.find_first_of("\t\"\r\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

/// The cell in quotes that begins at `at`; moves `at` behind its closing quote.
std::string quotedCell(std::string_view text, std::size_t& at) {
  std::string cell;
  for (++at; at < text.size(); ++at) {
    if (text[at] != '"') {
      cell += text[at];
    } else if (at + 1 < text.size() && text[at + 1] == '"') {
      cell += text[++at];
    } else {
      ++at;
      break;
    }
  }
  return cell;
}

}  // namespace

std::string toTsv(const CellBlock& block) {
  std::string text;
  for (const auto& row : block) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "\t" : "") + quoted(row[i]);
    text += '\n';
  }
  return text;
}

CellBlock fromTsv(std::string_view text) {
  CellBlock block;
  std::size_t at = 0;
  while (at < text.size()) {
    auto& row = block.emplace_back();
    for (;;) {
      std::string cell = text.substr(at, 1) == "\"" ? quotedCell(text, at) : std::string();
      const std::size_t end = std::min(text.find_first_of("\t\n", at), text.size());
      cell += text.substr(at, end - at);
      const bool last = end == text.size() || text[end] == '\n';
      if (last && !cell.empty() && cell.back() == '\r') cell.pop_back();
      row.push_back(std::move(cell));
      at = end + 1;
      if (last) break;
    }
  }
  return block;
}

}  // namespace desktop
