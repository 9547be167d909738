#include "report/curve_figure.h"

#include <algorithm>
#include <cmath>

#include "report/figure.h"

namespace report {

namespace {

constexpr double kWidth = 680.0;
constexpr double kHeight = 300.0;

/// Colours for any colour vision (Okabe & Ito 2008); a second round is dashed.
constexpr std::string_view kColours[] = {"#0072b2", "#d55e00", "#009e73", "#a3387c", "#e69f00", "#56b4e9", "#1f2328"};
constexpr std::size_t kColourCount = std::size(kColours);

Range rangeOf(const CurveFigure& content) {
  if (content.y_range) return *content.y_range;
  std::optional<Range> range;
  for (const auto& curve : content.curves) {
    for (const double y : curve.y) {
      if (!std::isfinite(y)) continue;
      if (!range) range = Range{y, y};
      range->low = std::min(range->low, y);
      range->high = std::max(range->high, y);
    }
  }
  return range ? widened(*range, 0.04) : Range{0.0, 1.0};
}

std::string_view colourOf(const CurveFigure& content, std::size_t index) {
  const std::string& own = content.curves[index].colour;
  return own.empty() ? kColours[index % kColourCount] : std::string_view(own);
}

void drawCurve(Figure& figure, const CurveFigure& content, std::size_t index, const Scale& x, const Scale& y) {
  const auto& values = content.curves[index].y;
  const std::string_view round = index >= kColourCount ? "5 3" : "";
  const std::string& own = content.curves[index].dashes;
  const Stroke stroke{.colour = colourOf(content, index), .width = 2.0, .dashes = own.empty() ? round : own};
  std::vector<Point> line;
  const auto draw = [&] {
    if (line.size() > 1) figure.polyline(simplified(line), stroke);
    line.clear();
  };
  for (std::size_t i = 0; i < std::min(values.size(), content.x.size()); ++i) {
    if (std::isfinite(values[i])) {
      line.push_back({x.pixelWithin(content.x[i]), y.pixelWithin(values[i])});
    } else {
      draw();
    }
  }
  draw();
}

}  // namespace

std::string curveFigure(const CurveFigure& content) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < content.curves.size(); ++i) {
    legend.push_back({.text = content.curves[i].name,
                      .colour = colourOf(content, i),
                      .is_line = true,
                      .dashes = content.curves[i].dashes});
  }
  const double legend_height = 18.0 * static_cast<double>((legend.size() + 1) / 2);
  const Box area = {74.0, 42.0, kWidth - 74.0 - 24.0, kHeight};
  Figure figure(kWidth, area.y + area.height + 52.0 + legend_height, content.title);
  figure.text({16.0, 22.0}, fitted(content.title, 15.0, kWidth - 32.0), {.size = 15.0, .bold = true});
  const Range across = content.x.empty() ? Range{0.0, 1.0} : Range{content.x.front(), content.x.back()};
  const Scale x(across, area.x, area.x + area.width);
  const Scale y(rangeOf(content), area.y + area.height, area.y);
  drawBottomAxis(figure, area, x, content.x_name);
  drawLeftAxis(figure, area, y, content.y_name);
  for (std::size_t i = 0; i < content.curves.size(); ++i) drawCurve(figure, content, i, x, y);
  drawLegend(figure, {area.x, area.y + area.height + 44.0}, area.width, legend);
  return figure.svg();
}

}  // namespace report
