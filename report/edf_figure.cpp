#include "report/edf_figure.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

#include "core/text.h"
#include "metrics/area/area_metric.h"
#include "report/axis.h"
#include "report/figure.h"

namespace report {

namespace {

using metrics::Comparison;
using metrics::Edf;
using metrics::PBox;

constexpr double kWidth = 680.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 20.0;
constexpr double kCurveHeight = 240.0;
constexpr double kBoxPlotHeight = 74.0;
constexpr double kBoxOpacity = 0.25;
constexpr double kAreaOpacity = 0.75;

bool isSingle(const PBox& box) { return box.left() == box.right(); }

Range axisRange(const Comparison& boxes, double limit) {
  double low = boxes.measured.left().min();
  double high = boxes.measured.right().max();
  double middle_low = boxes.measured.left().quantile(0.005);
  double middle_high = boxes.measured.right().quantile(0.995);
  low = std::min(low, boxes.simulated.left().min());
  high = std::max(high, boxes.simulated.right().max());
  middle_low = std::min(middle_low, boxes.simulated.left().quantile(0.005));
  middle_high = std::max(middle_high, boxes.simulated.right().quantile(0.995));
  const double reach = 1.5 * (middle_high - middle_low);
  if (reach > 0.0) {
    low = std::max(low, middle_low - reach);
    high = std::min(high, middle_high + reach);
  }
  // The limit is shown where it can be, but one that is far off must not squeeze the curves either.
  const double mean = boxes.measured.left().mean();
  const double length = std::max(high - low, 1e-12);
  if (limit > 0.0 && limit < 2.0 * length) {
    low = std::min(low, mean - limit);
    high = std::max(high, mean + limit);
  }
  return widened({low, high}, 0.04);
}

/// Upper and lower height of two curves over one stretch of the axis. All pixels.
struct Column {
  double x_from;
  double x_to;
  double measured_high, measured_low;    // CDF of the left and of the right edge
  double simulated_high, simulated_low;  // all as probabilities
};

/// The axis cut wherever a curve steps, to a tenth of a pixel. Each curve is constant over a column, so whatever is
/// drawn from columns clips and thins itself.
std::vector<Column> columnsOf(const Comparison& boxes, const Scale& x) {
  std::vector<double> cuts = {x.pixel(x.values().low), x.pixel(x.values().high)};
  for (const Edf* edge :
       {&boxes.measured.left(), &boxes.measured.right(), &boxes.simulated.left(), &boxes.simulated.right()}) {
    for (const double value : edge->values()) {
      const double cut = std::round(10.0 * x.pixelWithin(value)) / 10.0;
      if (cuts.back() != cut) cuts.push_back(cut);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<Column> columns;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = x.value(0.5 * (cuts[i] + cuts[i + 1]));
    columns.push_back({.x_from = cuts[i],
                       .x_to = cuts[i + 1],
                       .measured_high = boxes.measured.left().cdf(middle),
                       .measured_low = boxes.measured.right().cdf(middle),
                       .simulated_high = boxes.simulated.left().cdf(middle),
                       .simulated_low = boxes.simulated.right().cdf(middle)});
  }
  return columns;
}

using Height = std::function<double(const Column&)>;

std::vector<Point> staircase(std::span<const Column> columns, const Scale& y, const Height& height) {
  std::vector<Point> points;
  for (const Column& column : columns) {
    const double level = y.pixel(height(column));
    points.push_back({column.x_from, level});
    points.push_back({column.x_to, level});
  }
  return simplified(points);
}

void fillBetween(Figure& figure, std::span<const Column> columns, const Scale& y, const Height& upper,
                 const Height& lower, const Fill& fill) {
  std::vector<Point> outline = staircase(columns, y, upper);
  const std::vector<Point> back = staircase(columns, y, lower);
  outline.insert(outline.end(), back.rbegin(), back.rend());
  figure.polygon(outline, fill);
}

/// Fills every stretch in which `upper` runs above `lower`, each as an area of its own.
void fillWhereAbove(Figure& figure, std::span<const Column> columns, const Scale& y, const Height& upper,
                    const Height& lower, const Fill& fill) {
  std::size_t i = 0;
  while (i < columns.size()) {
    std::size_t end = i;
    while (end < columns.size() && upper(columns[end]) > lower(columns[end])) ++end;
    if (end > i) fillBetween(figure, columns.subspan(i, end - i), y, upper, lower, fill);
    i = end + 1;
  }
}

void drawCurves(Figure& figure, const Comparison& boxes, const Scale& x, const Scale& y) {
  const std::vector<Column> columns = columnsOf(boxes, x);
  const Height measured_high = [](const Column& c) { return c.measured_high; };
  const Height measured_low = [](const Column& c) { return c.measured_low; };
  const Height simulated_high = [](const Column& c) { return c.simulated_high; };
  const Height simulated_low = [](const Column& c) { return c.simulated_low; };
  fillWhereAbove(figure, columns, y, simulated_low, measured_high, {colour::kTooSmall, kAreaOpacity});
  fillWhereAbove(figure, columns, y, measured_low, simulated_high, {colour::kTooLarge, kAreaOpacity});
  if (!isSingle(boxes.simulated)) {
    fillBetween(figure, columns, y, simulated_high, simulated_low, {colour::kSimulated, kBoxOpacity});
    figure.polyline(staircase(columns, y, simulated_low), {.colour = colour::kSimulated, .width = 1.4});
  }
  figure.polyline(staircase(columns, y, simulated_high), {.colour = colour::kSimulated, .width = 1.4});
  if (!isSingle(boxes.measured)) {
    fillBetween(figure, columns, y, measured_high, measured_low, {colour::kMeasured, 0.15});
    figure.polyline(staircase(columns, y, measured_low), {.colour = colour::kMeasured, .width = 1.8});
  }
  figure.polyline(staircase(columns, y, measured_high), {.colour = colour::kMeasured, .width = 1.8});
}

/// Says at the border that values lie beyond it.
void markOutliers(Figure& figure, const Comparison& boxes, const Box& area, const Range& shown) {
  const double y = area.y + 12.0;
  const TextStyle style = {.size = 10.0, .colour = colour::kMuted};
  if (std::min(boxes.measured.left().min(), boxes.simulated.left().min()) < shown.low) {
    figure.text({area.x + 3.0, y}, "◂ further values", style);
  }
  if (std::max(boxes.measured.right().max(), boxes.simulated.right().max()) > shown.high) {
    TextStyle right = style;
    right.anchor = Anchor::End;
    figure.text({area.x + area.width - 3.0, area.y + area.height - 6.0}, "further values ▸", right);
  }
}

/// Smallest and largest value that a whisker reaches: within 1.5 interquartile ranges of the quartiles (Tukey 1977).
double whiskerEnd(const Edf& edf, double fence, bool upper) {
  const auto values = edf.values();
  if (upper) {
    const auto after = std::upper_bound(values.begin(), values.end(), fence);
    return after == values.begin() ? values.front() : *(after - 1);
  }
  const auto at = std::lower_bound(values.begin(), values.end(), fence);
  return at == values.end() ? values.back() : *at;
}

/// A value that is an interval of the p-box: a line if it has no width on the screen.
void drawInterval(Figure& figure, double from, double to, double top, double height, std::string_view colour) {
  const double width = std::max(2.0, to - from);
  figure.rectangle({0.5 * (from + to - width), top, width, height}, {.colour = colour});
}

void drawBoxPlot(Figure& figure, const PBox& box, const Scale& x, double middle, std::string_view colour) {
  constexpr double kHeight = 18.0;
  const double lower_quartile = box.left().quantile(0.25);
  const double upper_quartile = box.right().quantile(0.75);
  const double reach = 1.5 * (upper_quartile - lower_quartile);
  const double whisker_low = std::min(lower_quartile, whiskerEnd(box.left(), lower_quartile - reach, false));
  const double whisker_high = std::max(upper_quartile, whiskerEnd(box.right(), upper_quartile + reach, true));
  const double top = middle - kHeight / 2.0;
  const Stroke stroke = {.colour = colour, .width = 1.4};
  figure.line({x.pixelWithin(whisker_low), middle}, {x.pixelWithin(lower_quartile), middle}, stroke);
  figure.line({x.pixelWithin(upper_quartile), middle}, {x.pixelWithin(whisker_high), middle}, stroke);
  for (const double end : {whisker_low, whisker_high}) {
    const double at = x.pixelWithin(end);
    figure.line({at, middle - 5.0}, {at, middle + 5.0}, stroke);
  }
  const double from = x.pixelWithin(lower_quartile);
  const Box quartiles = {from, top, std::max(1.0, x.pixelWithin(upper_quartile) - from), kHeight};
  figure.rectangle(quartiles, {.colour = colour, .opacity = 0.18});
  figure.frame(quartiles, stroke);
  drawInterval(figure, x.pixelWithin(box.left().median()), x.pixelWithin(box.right().median()), top, kHeight, colour);
  // Diamond: mean, stretched to the interval of the means.
  const double mean_low = x.pixelWithin(box.left().mean());
  const double mean_high = x.pixelWithin(box.right().mean());
  const Point diamond[] = {{mean_low - 4.5, middle},  {mean_low, middle - 4.5},  {mean_high, middle - 4.5},
                           {mean_high + 4.5, middle}, {mean_high, middle + 4.5}, {mean_low, middle + 4.5}};
  figure.polygon(diamond, {.colour = "#ffffff"});
  figure.polyline(diamond, stroke);
  figure.line(diamond[5], diamond[0], stroke);
}

void drawBoxPlots(Figure& figure, const Comparison& boxes, const Box& area, const Scale& x, double limit) {
  if (limit > 0.0) {
    // Around the means of the measurement (the outer ones of a box): where a simulation's mean may lie.
    const double from = x.pixelWithin(boxes.measured.left().mean() - limit);
    const double to = x.pixelWithin(boxes.measured.right().mean() + limit);
    figure.rectangle({from, area.y, to - from, area.height}, {.colour = "#2e7d32", .opacity = 0.10});
    for (const double at : {from, to}) {
      figure.line({at, area.y}, {at, area.y + area.height}, {.colour = "#2e7d32", .dashes = "4 3"});
    }
  }
  const double row = area.height / 2.0;
  const struct {
    const PBox& box;
    std::string_view colour;
    std::string_view name;
  } rows[] = {{boxes.measured, colour::kMeasured, "measured"}, {boxes.simulated, colour::kSimulated, "simulated"}};
  double middle = area.y + row / 2.0;
  for (const auto& [box, colour, name] : rows) {
    drawBoxPlot(figure, box, x, middle, colour);
    figure.text({area.x - 6.0, middle + 4.0}, name, {.size = 10.5, .anchor = Anchor::End, .colour = colour});
    middle += row;
  }
}

std::string countOf(std::size_t n) { return n == 0 ? std::string() : fmt::format(" (n = {})", n); }

std::string simulatedLegend(const PBox& box, const std::vector<std::size_t>& n) {
  if (n.empty()) return isSingle(box) ? "simulation" : "simulation, p-box";
  const auto [least, most] = std::minmax_element(n.begin(), n.end());
  const std::string size = *least == *most ? fmt::format("{}", *least) : fmt::format("{} to {}", *least, *most);
  if (n.size() == 1) return fmt::format("simulation (n = {})", size);
  return fmt::format("simulation, p-box of {} runs (n = {} each)", n.size(), size);
}

std::vector<LegendEntry> legendOf(const Comparison& boxes, const EdfFigureText& text) {
  const metrics::AreaPortions areas = metrics::areaPortions(boxes);
  const std::string unit = text.unit.empty() ? "" : " " + text.unit;
  const bool single = isSingle(boxes.simulated);
  std::vector<LegendEntry> entries = {
      {.text = "measurement" + countOf(boxes.measured.left().n()), .colour = colour::kMeasured, .is_line = true},
      {.text = simulatedLegend(boxes.simulated, text.simulated_n),
       .colour = colour::kSimulated,
       .opacity = single ? 1.0 : 0.45,
       .is_line = single},
      {.text = fmt::format("d+ = {}{}: simulated too small", core::significant(areas.d_plus), unit),
       .colour = colour::kTooSmall,
       .opacity = kAreaOpacity},
      {.text = fmt::format("d− = {}{}: simulated too large", core::significant(areas.d_minus), unit),
       .colour = colour::kTooLarge,
       .opacity = kAreaOpacity}};
  if (text.bias_limit) {
    entries.push_back({.text = fmt::format("accepted d_bias: ±{}{}", core::significant(*text.bias_limit), unit),
                       .colour = "#2e7d32",
                       .opacity = 0.25});
  }
  return entries;
}

}  // namespace

std::string edfFigure(const Comparison& boxes, const EdfFigureText& text) {
  const double limit = text.bias_limit.value_or(0.0);
  const std::vector<LegendEntry> legend = legendOf(boxes, text);
  const double head = text.note.empty() ? 34.0 : 52.0;
  const double legend_height = 18.0 * static_cast<double>((legend.size() + 1) / 2) + 12.0;
  const Box curves = {kLeft, head + legend_height, kWidth - kLeft - kRight, kCurveHeight};
  const Box plots = {curves.x, curves.y + curves.height + 8.0, curves.width, kBoxPlotHeight};
  Figure figure(kWidth, plots.y + plots.height + 44.0, text.title);
  figure.text({kLeft, 22.0}, fitted(text.title, 15.0, kWidth - kLeft - kRight), {.size = 15.0, .bold = true});
  if (!text.note.empty()) {
    figure.text({kLeft, 42.0}, fitted(text.note, 12.0, kWidth - kLeft - kRight), {.colour = colour::kMuted});
  }
  drawLegend(figure, {kLeft, head}, kWidth - kLeft - kRight, legend);

  const Scale x(axisRange(boxes, limit), curves.x, curves.x + curves.width);
  const Scale y({0.0, 1.0}, curves.y + curves.height, curves.y);
  const Box both = {curves.x, curves.y, curves.width, plots.y + plots.height - curves.y};
  drawBottomAxis(figure, both, x, withUnit(text.quantity, text.unit));
  drawLeftAxis(figure, curves, y, "cumulative probability");
  figure.line({curves.x, curves.y + curves.height}, {curves.x + curves.width, curves.y + curves.height});
  drawCurves(figure, boxes, x, y);
  markOutliers(figure, boxes, curves, x.values());
  drawBoxPlots(figure, boxes, plots, x, limit);
  return figure.svg();
}

}  // namespace report
