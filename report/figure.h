#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/axis.h"

namespace report {

/// Colours that people with any colour vision can tell apart, and a printer in grey too (after Okabe & Ito 2008).
namespace colour {
inline constexpr std::string_view kInk = "#1f2328";
inline constexpr std::string_view kMuted = "#59636e";
inline constexpr std::string_view kGrid = "#e3e6ea";
inline constexpr std::string_view kMeasured = "#1f2328";
inline constexpr std::string_view kSimulated = "#0072b2";
inline constexpr std::string_view kTooSmall = "#e69f00";  ///< d+: simulated values too small
inline constexpr std::string_view kTooLarge = "#a3387c";  ///< d-: simulated values too large
inline constexpr std::string_view kLimit = "#b3261e";
}  // namespace colour

/// Pixels; x to the right, y downwards.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Box {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

struct Stroke {
  std::string_view colour = colour::kInk;
  double width = 1.0;
  std::string_view dashes = "";  ///< as in SVG: "4 3"
};

struct Fill {
  std::string_view colour = colour::kGrid;
  double opacity = 1.0;
};

enum class Anchor { Start, Middle, End };

struct TextStyle {
  double size = 12.0;
  Anchor anchor = Anchor::Start;
  std::string_view colour = colour::kInk;
  bool bold = false;
  bool upwards = false;  ///< turned by 90°, read from below
};

/// A drawing of fixed size that becomes SVG Tiny 1.2: what browsers, printers and QtSvg all show alike (attributes
/// only; no style sheets, clip paths or filters). Coordinates are written to a tenth of a pixel, text is escaped, and
/// the same calls give the same bytes.
class Figure {
 public:
  /// `title` is what screen readers say.
  Figure(double width, double height, std::string_view title);

  void line(Point from, Point to, const Stroke& stroke = {});
  void polyline(std::span<const Point> points, const Stroke& stroke = {});
  void polygon(std::span<const Point> points, const Fill& fill);
  void rectangle(const Box& box, const Fill& fill);
  void frame(const Box& box, const Stroke& stroke = {});
  void circle(Point centre, double radius, const Fill& fill);
  /// Many circles of one colour in a few bytes each.
  void dots(std::span<const Point> centres, double radius, std::string_view colour);
  /// `at` is on the base line of the text.
  void text(Point at, std::string_view text, const TextStyle& style = {});

  [[nodiscard]] double width() const noexcept { return width_; }
  [[nodiscard]] double height() const noexcept { return height_; }
  /// The whole document, without XML declaration, so that it can stand inside HTML.
  [[nodiscard]] std::string svg() const;

 private:
  double width_;
  double height_;
  std::string title_;
  std::string body_;
};

/// The line through `points` with the fewest points that stays within `tolerance` pixels of it (Douglas & Peucker
/// 1973). First and last point are kept.
[[nodiscard]] std::vector<Point> simplified(std::span<const Point> points, double tolerance = 0.1);

/// Width of a text in pixels, estimated for a sans-serif face (there is no screen to ask).
[[nodiscard]] double textWidth(std::string_view text, double size);

/// `text`, shortened with an ellipsis to at most `width` pixels.
[[nodiscard]] std::string fitted(std::string_view text, double size, double width);

/// Vertical grid lines, marks and labels of a horizontal axis along the lower edge of `area`, with its name below.
void drawBottomAxis(Figure& figure, const Box& area, const Scale& scale, std::string_view name);
/// Likewise at the left edge.
void drawLeftAxis(Figure& figure, const Box& area, const Scale& scale, std::string_view name);

/// One entry of a legend: a sample of the colour (a line or an area) and its meaning.
struct LegendEntry {
  std::string text;
  std::string_view colour;
  double opacity = 1.0;
  bool is_line = false;
  std::string_view dashes = "";  ///< of a line
};

/// Draws the entries in columns, row by row, from the upper left corner `at` over `width`; returns the height used.
double drawLegend(Figure& figure, Point at, double width, std::span<const LegendEntry> entries);

/// "range in m"; "count" without a unit.
[[nodiscard]] std::string withUnit(std::string_view name, std::string_view unit);

}  // namespace report
