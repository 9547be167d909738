#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace report {

/// What a badge says at a glance: the word carries it, the colour only helps.
enum class Tone { Good, Bad, Warning, Neutral };

/// A piece of HTML that is known to be well-formed and escaped. Only the functions below make it.
class Html {
 public:
  [[nodiscard]] const std::string& markup() const noexcept { return markup_; }
  Html& operator+=(const Html& other) {
    markup_ += other.markup_;
    return *this;
  }

 private:
  explicit Html(std::string markup) : markup_(std::move(markup)) {}
  friend Html rawHtml(std::string markup);
  std::string markup_;
};

/// Everything below escapes; this does not. For markup that the caller has built well-formed, such as an SVG figure.
[[nodiscard]] Html rawHtml(std::string markup);

[[nodiscard]] Html text(std::string_view text);
[[nodiscard]] Html code(std::string_view text);  ///< fixed width: hashes, expressions, paths
[[nodiscard]] Html strong(std::string_view text);
[[nodiscard]] Html badge(std::string_view word, Tone tone);
[[nodiscard]] Html link(std::string_view address, std::string_view text);  ///< "#anchor" or a relative path
/// A small bar for a share between 0 and 1, with the percentage behind it.
[[nodiscard]] Html shareBar(double share);
/// A number on a ground that is the darker the nearer `share` is to 1: for matrices. The number carries the meaning.
[[nodiscard]] Html shaded(std::string_view number, double share);
[[nodiscard]] Html orderedList(const std::vector<Html>& items);
/// Terms with their explanations.
struct Definition {
  std::string term;
  std::string anchor;  ///< "": none
  Html meaning;
};
[[nodiscard]] Html definitions(const std::vector<Definition>& entries);
[[nodiscard]] Html operator+(Html left, const Html& right);

enum class Align { Left, Right };

struct TableColumn {
  std::string name;
  Align align = Align::Left;  ///< numbers: Right
  bool heads_row = false;     ///< its cells say what their row is about
};

struct KeyValue {
  std::string key;
  Html value;
};

/// A self-contained HTML page: one file that can be mailed, printed and archived. Style is embedded, nothing is loaded
/// from elsewhere, no script is needed; every text is escaped. Written as XHTML (well-formed XML), so that any XML tool
/// reads it. The same calls give the same bytes.
///
///   Page page("Acceptance report");
///   page.banner("Synthetic data: made by a program, not measured.", Tone::Warning);
///   page.section("Verdict", "verdict");
///   page.keyValues({{"requirement", text("RangeError_1")}, {"verdict", badge("passed", Tone::Good)}});
///   page.figure(edfFigure(…), "Range at 10 m");
///   core::writeFile(file, page.html());
class Page {
 public:
  explicit Page(std::string_view title, std::string_view subtitle = "");

  /// A line across the page that nobody overlooks.
  void banner(std::string_view text, Tone tone);
  /// A box before the contents that answers the reader's question: a heading, one sentence in large letters, and facts.
  void answer(std::string_view heading, const Html& badge, std::string_view sentence,
              const std::vector<KeyValue>& facts);
  /// A heading of level 2 with an anchor for links ("": none); listed in the contents if there are three or more.
  void section(std::string_view title, std::string_view anchor = "");
  void subsection(std::string_view title, std::string_view anchor = "");
  /// A heading with a badge behind it.
  void section(std::string_view title, std::string_view anchor, const Html& after);
  void subsection(std::string_view title, std::string_view anchor, const Html& after);
  void paragraph(std::string_view text);
  void paragraph(const Html& content);
  /// The sentence below a heading that says what the section shows and how to read it.
  void lead(std::string_view text);
  void block(const Html& content);  ///< a list, definitions: what is no paragraph
  void keyValues(const std::vector<KeyValue>& rows);
  /// Every row must be as long as the header. Large numbers of rows are fine.
  void table(const std::vector<TableColumn>& header, const std::vector<std::vector<Html>>& rows,
             std::string_view caption = "");
  /// `svg` stands inside the page as it is.
  void figure(std::string_view svg, std::string_view caption = "");
  void preformatted(std::string_view text);
  /// What follows, until endDetails(), is folded away behind `summary` (open when `open`; printed if open).
  void beginDetails(std::string_view summary, bool open = false);
  void endDetails();

  [[nodiscard]] std::string html() const;

 private:
  struct Entry {
    std::string anchor;
    std::string title;
  };
  void heading(int level, std::string_view title, std::string_view anchor, const Html& after);

  std::string title_;
  std::string subtitle_;
  std::string banners_;
  std::string answer_;
  std::string body_;
  std::vector<Entry> contents_;
  int open_details_ = 0;
};

}  // namespace report
