#include "report/point_figure.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace report {

namespace {

constexpr double kRight = 24.0;
constexpr double kOnePanel = 592.0;
constexpr double kTwoPanels = 391.0;  // of each
constexpr double kLeft = 64.0;
constexpr double kTop = 42.0;
constexpr double kGap = 44.0;  // between panels
constexpr double kHeight = 260.0;
constexpr std::string_view kReference = "#b9c2cb";
constexpr std::string_view kOwn[] = {"#0072b2", "#d55e00"};

/// Points that fall on the same half pixel are one: many frames of one scene stay a small picture.
std::vector<Point> onScreen(const std::vector<Point>& points, const Scale& x, const Scale& y) {
  std::set<std::pair<long, long>> taken;
  std::vector<Point> seen;
  for (const Point& point : points) {
    const bool inside = point.x >= x.values().low && point.x <= x.values().high && point.y >= y.values().low &&
                        point.y <= y.values().high;
    if (!inside) continue;
    const Point pixel{x.pixel(point.x), y.pixel(point.y)};
    if (taken.emplace(std::lround(2.0 * pixel.x), std::lround(2.0 * pixel.y)).second) seen.push_back(pixel);
  }
  return seen;
}

double heightOf(const PointFigure& content, double width) {
  if (!content.one_scale) return kHeight;
  return std::clamp(width * (content.y.high - content.y.low) / (content.x.high - content.x.low), 80.0, 420.0);
}

}  // namespace

std::string pointFigure(const PointFigure& content) {
  const auto panels = static_cast<double>(std::max<std::size_t>(1, content.panels.size()));
  const double width = content.panels.size() < 2 ? kOnePanel : kTwoPanels;
  const double whole = kLeft + panels * width + (panels - 1.0) * kGap + kRight;
  const double height = heightOf(content, width);
  const double legend_height = 36.0;  // two rows, if the names are long
  Figure figure(whole, kTop + height + 52.0 + legend_height, content.title);
  figure.text({16.0, 22.0}, fitted(content.title, 15.0, whole - 32.0), {.size = 15.0, .bold = true});
  for (std::size_t i = 0; i < content.panels.size(); ++i) {
    const Box area = {kLeft + static_cast<double>(i) * (width + kGap), kTop, width, height};
    const Scale x(content.x, area.x, area.x + area.width);
    const Scale y(content.y, area.y + area.height, area.y);
    const std::string_view colour = kOwn[i % std::size(kOwn)];
    drawBottomAxis(figure, area, x, content.x_name);
    drawLeftAxis(figure, area, y, i == 0 ? content.y_name : "");
    const double radius = content.panels.size() < 2 ? 2.2 : 1.6;
    figure.dots(onScreen(content.reference.points, x, y), 1.9 * radius, kReference);
    figure.dots(onScreen(content.panels[i].points, x, y), radius, colour);
    const LegendEntry legend[] = {{.text = content.reference.name, .colour = kReference},
                                  {.text = content.panels[i].name, .colour = colour}};
    drawLegend(figure, {area.x, kTop + height + 44.0}, width, legend);
  }
  return figure.svg();
}

}  // namespace report
