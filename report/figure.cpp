#include "report/figure.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "core/text.h"

namespace report {

namespace {

constexpr double kTickLabelSize = 11.0;
constexpr double kAxisNameSize = 12.0;

/// A coordinate to a tenth of a pixel, as short as possible: "12", "12.5"; never "-0".
std::string px(double value) {
  const double tenths = std::round(10.0 * value);
  if (tenths == 0.0) return "0";
  return fmt::format("{:.10g}", tenths / 10.0);
}

std::string attributes(const Stroke& stroke) {
  std::string text = fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"", stroke.colour, px(stroke.width));
  if (!stroke.dashes.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes);
  return text;
}

std::string attributes(const Fill& fill) {
  std::string text = fmt::format("fill=\"{}\"", fill.colour);
  if (fill.opacity < 1.0) text += fmt::format(" fill-opacity=\"{:.2g}\"", fill.opacity);
  return text;
}

std::string attributes(const Box& box) {
  return fmt::format("x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", px(box.x), px(box.y), px(box.width),
                     px(box.height));
}

std::string pointList(std::span<const Point> points) {
  std::string text;
  for (const Point& point : points) {
    if (!text.empty()) text += ' ';
    text += px(point.x) + ',' + px(point.y);
  }
  return text;
}

double distanceToSegment(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length_2 = dx * dx + dy * dy;
  const double t = length_2 > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length_2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Start of each UTF-8 character counts; its continuation bytes do not.
bool startsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }

double characterWidth(char c) {
  constexpr std::string_view kNarrow = "iljtfI.,:;!|'()[] ";
  constexpr std::string_view kWide = "mwMW@%";
  if (kNarrow.find(c) != std::string_view::npos) return 0.34;
  if (kWide.find(c) != std::string_view::npos) return 0.88;
  return c >= 'A' && c <= 'Z' ? 0.69 : 0.57;
}

}  // namespace

Figure::Figure(double width, double height, std::string_view title) : width_(width), height_(height), title_(title) {}

void Figure::line(Point from, Point to, const Stroke& stroke) {
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", px(from.x), px(from.y), px(to.x),
                       px(to.y), attributes(stroke));
}

void Figure::polyline(std::span<const Point> points, const Stroke& stroke) {
  if (points.size() < 2) return;
  body_ +=
      fmt::format("<polyline points=\"{}\" {} stroke-linejoin=\"round\"/>\n", pointList(points), attributes(stroke));
}

void Figure::polygon(std::span<const Point> points, const Fill& fill) {
  if (points.size() < 3) return;
  body_ += fmt::format("<polygon points=\"{}\" {}/>\n", pointList(points), attributes(fill));
}

void Figure::rectangle(const Box& box, const Fill& fill) {
  body_ += fmt::format("<rect {} {}/>\n", attributes(box), attributes(fill));
}

void Figure::frame(const Box& box, const Stroke& stroke) {
  body_ += fmt::format("<rect {} {}/>\n", attributes(box), attributes(stroke));
}

void Figure::circle(Point centre, double radius, const Fill& fill) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", px(centre.x), px(centre.y), px(radius),
                       attributes(fill));
}

void Figure::dots(std::span<const Point> centres, double radius, std::string_view colour) {
  if (centres.empty()) return;
  // Strokes of next to no length with round ends; of none at all, some renderers draw nothing.
  std::string path;
  for (const Point& centre : centres) path += fmt::format("M{} {}h.1", px(centre.x), px(centre.y));
  body_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"/>\n",
                       path, colour, px(2.0 * radius));
}

void Figure::text(Point at, std::string_view text, const TextStyle& style) {
  constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
  body_ += fmt::format("<text x=\"{0}\" y=\"{1}\" font-size=\"{2}\" fill=\"{3}\"", px(at.x), px(at.y), px(style.size),
                       style.colour);
  if (style.anchor != Anchor::Start) {
    body_ += fmt::format(" text-anchor=\"{}\"", kAnchors[static_cast<int>(style.anchor)]);
  }
  if (style.bold) body_ += " font-weight=\"bold\"";
  if (style.upwards) body_ += fmt::format(" transform=\"rotate(-90 {} {})\"", px(at.x), px(at.y));
  body_ += fmt::format(">{}</text>\n", core::escapeMarkup(text));
}

std::string Figure::svg() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.2\" baseProfile=\"tiny\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" role=\"img\">\n<title>{2}</title>\n"
      "<rect x=\"0\" y=\"0\" width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{3}</svg>\n",
      px(width_), px(height_), core::escapeMarkup(title_), body_);
}

std::vector<Point> simplified(std::span<const Point> points, double tolerance) {
  if (points.size() < 3) return {points.begin(), points.end()};
  std::vector<bool> keep(points.size(), false);
  keep.front() = keep.back() = true;
  // Open stretches on a stack of our own: a recursion could be as deep as the line is long.
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distanceToSegment(points[i], points[first], points[last]);
      if (distance > farthest) {
        farthest = distance;
        at = i;
      }
    }
    if (at == 0) continue;
    keep[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<Point> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i]) kept.push_back(points[i]);
  }
  return kept;
}

double textWidth(std::string_view text, double size) {
  double width = 0.0;
  for (const char c : text) {
    if (startsCharacter(c)) width += characterWidth(c);
  }
  return width * size;
}

std::string fitted(std::string_view text, double size, double width) {
  if (textWidth(text, size) <= width) return std::string(text);
  const double available = width - textWidth("…", size);
  double used = 0.0;
  std::size_t end = 0;
  while (end < text.size()) {
    const double next = used + size * characterWidth(text[end]);
    if (next > available) break;
    used = next;
    do ++end;
    while (end < text.size() && !startsCharacter(text[end]));
  }
  return std::string(text.substr(0, end)) + "…";
}

void drawBottomAxis(Figure& figure, const Box& area, const Scale& scale, std::string_view name) {
  const double bottom = area.y + area.height;
  const Ticks ticks = niceTicks(scale.values(), std::max(2, static_cast<int>(area.width / 60.0)));
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double x = scale.pixel(ticks.at[i]);
    figure.line({x, area.y}, {x, bottom}, {.colour = colour::kGrid});
    figure.line({x, bottom}, {x, bottom + 4.0});
    figure.text({x, bottom + 16.0}, ticks.labels[i], {.size = kTickLabelSize, .anchor = Anchor::Middle});
  }
  figure.line({area.x, bottom}, {area.x + area.width, bottom});
  figure.text({area.x + area.width / 2.0, bottom + 34.0}, name, {.size = kAxisNameSize, .anchor = Anchor::Middle});
}

void drawLeftAxis(Figure& figure, const Box& area, const Scale& scale, std::string_view name) {
  const Ticks ticks = niceTicks(scale.values(), std::max(2, static_cast<int>(area.height / 45.0)));
  double widest = 0.0;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double y = scale.pixel(ticks.at[i]);
    figure.line({area.x, y}, {area.x + area.width, y}, {.colour = colour::kGrid});
    figure.line({area.x - 4.0, y}, {area.x, y});
    figure.text({area.x - 7.0, y + 4.0}, ticks.labels[i], {.size = kTickLabelSize, .anchor = Anchor::End});
    widest = std::max(widest, textWidth(ticks.labels[i], kTickLabelSize));
  }
  figure.line({area.x, area.y}, {area.x, area.y + area.height});
  figure.text({area.x - 16.0 - widest, area.y + area.height / 2.0}, name,
              {.size = kAxisNameSize, .anchor = Anchor::Middle, .upwards = true});
}

double drawLegend(Figure& figure, Point at, double width, std::span<const LegendEntry> entries) {
  constexpr double kRow = 18.0;
  constexpr double kSample = 22.0;
  if (entries.empty()) return 0.0;
  double widest = 0.0;
  for (const LegendEntry& entry : entries)
    widest = std::max(widest, kSample + 8.0 + textWidth(entry.text, 12.0) + 16.0);
  const auto fitting = static_cast<std::size_t>(std::max(1.0, std::floor(width / widest)));
  const std::size_t columns = std::min({fitting, entries.size(), std::size_t{2}});
  const double column_width = width / static_cast<double>(columns);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LegendEntry& entry = entries[i];
    const double x = at.x + static_cast<double>(i % columns) * column_width;
    const double y = at.y + static_cast<double>(i / columns) * kRow + kRow / 2.0;
    if (entry.is_line) {
      figure.line({x, y}, {x + kSample, y}, {.colour = entry.colour, .width = 2.0, .dashes = entry.dashes});
    } else {
      figure.rectangle({x, y - 5.0, kSample, 10.0}, {.colour = entry.colour, .opacity = entry.opacity});
    }
    figure.text({x + kSample + 8.0, y + 4.0}, fitted(entry.text, 12.0, column_width - kSample - 12.0));
  }
  return kRow * static_cast<double>((entries.size() + columns - 1) / columns);
}

std::string withUnit(std::string_view name, std::string_view unit) {
  if (unit.empty() || unit == "1") return std::string(name);
  return std::string(name) + " in " + std::string(unit);
}

}  // namespace report
