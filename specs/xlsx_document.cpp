// The specification as a workbook.

#include <unistd.h>
#include <utility>
#include <xlsxwriter.h>

#include "core/error.h"
#include "core/file.h"
#include "specs/documents.h"
#include "specs/fields.h"

namespace specs {

namespace {

constexpr std::size_t kLongestCell = 32'000;  // Excel takes 32 767 UTF-16 units

std::string shortened(const std::string& text) {
  if (text.size() <= kLongestCell) return text;
  std::size_t end = kLongestCell;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not within a letter
  return text.substr(0, end) + " […]";
}

/// A workbook under way. Everything in it belongs to the library and goes with it.
class Workbook {
 public:
  explicit Workbook(const std::string& file) : book_(workbook_new(file.c_str())) {
    heading_ = workbook_add_format(book_);
    format_set_bold(heading_);
    format_set_bg_color(heading_, 0xE6ECF2);
    format_set_bottom(heading_, LXW_BORDER_THIN);
    cell_ = workbook_add_format(book_);
    format_set_text_wrap(cell_);
    format_set_align(cell_, LXW_ALIGN_VERTICAL_TOP);
    for (const auto& [word, colour] :
         {std::pair{"accepted", 0xDDF2E3u}, {"rejected", 0xF8DADAu}, {"under review", 0xFFF3CFu}}) {
      lxw_format* format = workbook_add_format(book_);
      format_set_bg_color(format, colour);
      status_.emplace_back(word, format);
    }
  }
  ~Workbook() {
    if (book_) lxw_workbook_free(book_);
  }
  Workbook(const Workbook&) = delete;
  Workbook& operator=(const Workbook&) = delete;

  void setProperties(std::string title) {
    lxw_doc_properties properties = {};
    properties.title = title.data();
    // The day on which the format's clock begins: the same specification must give the same bytes.
    properties.created = 315'532'800;  // 1980-01-01
    workbook_set_properties(book_, &properties);
  }

  /// One list; small whole numbers go in as numbers. Two columns stay in sight when scrolling.
  void addSheet(const char* sheet_name, const std::vector<std::string>& header,
                const std::vector<std::vector<std::string>>& rows, const std::vector<double>& widths) {
    lxw_worksheet* sheet = workbook_add_worksheet(book_, sheet_name);
    for (std::size_t column = 0; column < header.size(); ++column) {
      const auto place = static_cast<lxw_col_t>(column);
      worksheet_set_column(sheet, place, place, widths[column], nullptr);
      worksheet_write_string(sheet, 0, place, header[column].c_str(), heading_);
    }
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (std::size_t column = 0; column < rows[row].size(); ++column) {
        write(sheet, static_cast<lxw_row_t>(row + 1), static_cast<lxw_col_t>(column), rows[row][column]);
      }
    }
    const auto last_row = static_cast<lxw_row_t>(rows.size());
    const auto last_column = static_cast<lxw_col_t>(header.size() - 1);
    worksheet_autofilter(sheet, 0, 0, last_row, last_column);
    worksheet_freeze_panes(sheet, 1, 2);
    worksheet_set_landscape(sheet);
    worksheet_fit_to_pages(sheet, 1, 0);
    worksheet_repeat_rows(sheet, 0, 0);
    for (std::size_t column = 0; column < header.size(); ++column) {
      if (header[column] == "Status" && last_row > 0) dressStatus(sheet, static_cast<lxw_col_t>(column), last_row);
    }
  }

  /// Throws InputError if the file cannot be written.
  void close() {
    lxw_workbook* book = std::exchange(book_, nullptr);  // the library frees it in any case
    const lxw_error error = workbook_close(book);
    if (error != LXW_NO_ERROR) throw std::runtime_error(lxw_strerror(error));
  }

 private:
  void write(lxw_worksheet* sheet, lxw_row_t row, lxw_col_t column, const std::string& text) {
    const bool is_number =
        !text.empty() && text.size() <= 3 && text.find_first_not_of("0123456789") == std::string::npos;
    if (is_number) {
      worksheet_write_number(sheet, row, column, std::stod(text), cell_);
    } else {
      worksheet_write_string(sheet, row, column, shortened(text).c_str(), cell_);
    }
  }

  /// A list to choose from, and a colour for each word.
  void dressStatus(lxw_worksheet* sheet, lxw_col_t column, lxw_row_t last_row) {
    std::string words[] = {"under review", "accepted", "rejected"};
    char* word_list[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
    lxw_data_validation choice = {};
    choice.validate = LXW_VALIDATION_TYPE_LIST;
    choice.value_list = word_list;
    worksheet_data_validation_range(sheet, 1, column, last_row, column, &choice);
    for (const auto& [word, format] : status_) {
      std::string quoted = "\"" + word + "\"";
      lxw_conditional_format condition = {};
      condition.type = LXW_CONDITIONAL_TYPE_CELL;
      condition.criteria = LXW_CONDITIONAL_CRITERIA_EQUAL_TO;
      condition.value_string = quoted.data();
      condition.format = format;
      worksheet_conditional_format_range(sheet, 1, column, last_row, column, &condition);
    }
  }

  lxw_workbook* book_;
  lxw_format* heading_ = nullptr;
  lxw_format* cell_ = nullptr;
  std::vector<std::pair<std::string, lxw_format*>> status_;
};

/// Id and title first: they stay in sight. Internal ids are for the CSV lists.
template <class T>
void addItems(Workbook& book, const char* sheet, const std::vector<T>& items) {
  std::vector<std::string> header;
  std::vector<double> widths;
  for (const Field<T>& field : fieldsOf<T>().subspan(1)) {
    header.emplace_back(field.title);
    const bool is_long = field.name == "text" || field.name == "rationale" || field.name == "id";
    widths.push_back(is_long ? 45.0 : field.name == "title" || field.name == "expression" ? 32.0 : 16.0);
  }
  std::vector<std::vector<std::string>> rows;
  for (const T& item : items) {
    std::vector<std::string>& row = rows.emplace_back();
    for (const Field<T>& field : fieldsOf<T>().subspan(1)) row.push_back(field.get(item));
  }
  book.addSheet(sheet, header, rows, widths);
}

void addRelevance(Workbook& book, const cepra::Table& table) {
  const auto titles = [](const std::vector<cepra::Cause>& causes) {
    std::string text;
    for (const cepra::Cause& cause : causes) text += (text.empty() ? "" : "; ") + cause.title;
    return text;
  };
  const auto number = [](const std::optional<int>& value) { return value ? std::to_string(*value) : ""; };
  std::vector<std::vector<std::string>> rows;
  for (const cepra::Row& row : table.rows) {
    std::string path;
    for (const cepra::Effect& effect : row.effects) path += (path.empty() ? "" : " ← ") + effect.title;
    rows.push_back({row.key, row.effects.empty() ? "" : row.phenomenon().title, path,
                    titles(row.causesOfKind(percollect::NodeKind::DesignParameter)),
                    titles(row.causesOfKind(percollect::NodeKind::SystemIndependent)), number(row.occurrence.value),
                    row.occurrence.rationale, row.occurrence.expert, number(row.impact.value), row.impact.rationale,
                    row.impact.expert, number(row.relevance()), row.suspect, row.notes});
  }
  book.addSheet("Relevance (CEPRA)",
                {"Row", "Phenomenon", "Effect path", "Design parameters", "System-independent causes", "Occurrence",
                 "Rationale of occurrence", "Expert", "Impact", "Rationale of impact", "Expert (impact)", "Relevance",
                 "Suspect", "Notes"},
                rows, {15, 24, 60, 32, 32, 10, 36, 12, 10, 36, 12, 10, 24, 24});
}

void addLinks(Workbook& book, const std::vector<Link>& links) {
  std::vector<std::vector<std::string>> rows;
  for (const Link& link : links) rows.push_back({link.from, link.to, link.suspect ? "yes" : ""});
  book.addSheet("Links", {"From", "To", "Suspect"}, rows, {45, 45, 10});
}

/// A name beside nothing of the user's; removed at the end.
struct TemporaryFile {
  std::string name = (std::filesystem::temp_directory_path() / "fidelis-XXXXXX").string();
  TemporaryFile() {
    const int handle = ::mkstemp(name.data());
    if (handle >= 0) ::close(handle);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(name, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
};

}  // namespace

void writeXlsx(const Specification& specification, const std::filesystem::path& file) {
  const TemporaryFile temporary;  // the library cannot write all or nothing; core::writeFile can
  try {
    Workbook book(temporary.name);
    book.setProperties(specification.project);
    addItems(book, "Requirements", specification.requirements);
    addItems(book, "Acceptance tests", specification.tests);
    addItems(book, "Experiment data", specification.experiment_data);
    addItems(book, "Reference data", specification.reference_data);
    addLinks(book, specification.links);
    addRelevance(book, specification.cepra);
    book.close();
  } catch (const std::runtime_error& error) {
    throw core::InputError({.file = file}, std::string("the workbook could not be made: ") + error.what() + ".",
                           "Make room in the folder for temporary files, then try again.");
  }
  core::writeFile(file, core::readFile(temporary.name));
}

}  // namespace specs
