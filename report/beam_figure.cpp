#include "report/beam_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "report/axis.h"
#include "report/figure.h"

namespace report {

namespace {

constexpr double kWidth = 720.0;
constexpr double kLeft = 78.0;
constexpr double kRight = 24.0;
constexpr std::size_t kMostDots = 1200;
constexpr double kRadPerDeg = std::numbers::pi / 180.0;

/// The colour of the simulation over white, in five steps that differ in grey too.
constexpr std::array<std::string_view, 5> kShades = {"#b8d8e9", "#8cc0dc", "#61a8cf", "#308dc1", "#0072b2"};
constexpr std::array<std::string_view, 5> kShadeNames = {"gain up to 0.2", "0.2 to 0.4", "0.4 to 0.6", "0.6 to 0.8",
                                                         "0.8 to 1"};

std::size_t shadeOf(const BeamFigure::Beam& beam) {
  return static_cast<std::size_t>(std::clamp(std::ceil(beam.gain * 5.0) - 1.0, 0.0, 4.0));
}

struct Extent {
  Range azimuth{1e300, -1e300};
  Range elevation{1e300, -1e300};
  double least_gain = 1.0;
  std::size_t count = 0;
};

Extent extentOf(const BeamFigure& beams) {
  Extent extent;
  for (const auto& row : beams.rows) {
    for (const auto& beam : row) {
      extent.azimuth = {std::min(extent.azimuth.low, beam.azimuth_deg),
                        std::max(extent.azimuth.high, beam.azimuth_deg)};
      extent.elevation = {std::min(extent.elevation.low, beam.elevation_deg),
                          std::max(extent.elevation.high, beam.elevation_deg)};
      extent.least_gain = std::min(extent.least_gain, beam.gain);
      ++extent.count;
    }
  }
  return extent;
}

/// What a panel shows: values on both axes, and where they lie.
struct Panel {
  Box area;
  Scale x;
  Scale y;

  Panel(const Box& box, Range azimuth, Range elevation)
      : area(box), x(azimuth, box.x + box.width, box.x), y(elevation, box.y + box.height, box.y) {}
  [[nodiscard]] Point at(const BeamFigure::Beam& beam) const {
    return {x.pixel(beam.azimuth_deg), y.pixel(beam.elevation_deg)};
  }
};

/// Values of an axis: at least a degree on both sides of the middle, or a single row would be seen through a
/// microscope.
Range shown(Range range, double margin) {
  const double middle = 0.5 * (range.low + range.high);
  return widened({std::min(range.low, middle - 1.0), std::max(range.high, middle + 1.0)}, margin);
}

void drawAxes(Figure& figure, const Panel& panel) {
  drawBottomAxis(figure, panel.area, panel.x, "azimuth in ° (left is positive)");
  drawLeftAxis(figure, panel.area, panel.y, "elevation in °");
}

/// A row as lines of one shade each; neighbours share their point, so that nothing gapes.
void drawRow(Figure& figure, const Panel& panel, const std::vector<BeamFigure::Beam>& row) {
  for (std::size_t begin = 0; begin + 1 < row.size();) {
    std::size_t end = begin + 1;
    while (end + 1 < row.size() && shadeOf(row[end]) == shadeOf(row[begin])) ++end;
    std::vector<Point> points;
    for (std::size_t i = begin; i <= end; ++i) points.push_back(panel.at(row[i]));
    figure.polyline(simplified(points), {.colour = kShades[shadeOf(row[begin])], .width = 1.2});
    begin = end;
  }
}

void drawFrame(Figure& figure, const Panel& panel, const BeamFigure& beams, std::size_t count) {
  drawAxes(figure, panel);
  for (const auto& row : beams.rows) {
    if (count > kMostDots && row.size() > 1) {
      drawRow(figure, panel, row);
      continue;
    }
    for (const auto& beam : row) figure.circle(panel.at(beam), 1.4, {.colour = kShades[shadeOf(beam)]});
  }
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

const BeamFigure::Beam& nearest(const std::vector<BeamFigure::Beam>& row, double azimuth_deg) {
  return *std::min_element(row.begin(), row.end(), [azimuth_deg](const auto& a, const auto& b) {
    return std::abs(a.azimuth_deg - azimuth_deg) < std::abs(b.azimuth_deg - azimuth_deg);
  });
}

struct Window {
  BeamFigure::Beam centre{0.0, 0.0};
  double width_deg = 1.0;
};

/// Around the row in the middle: some eight columns, two rows and four beams wide, whichever is most.
Window windowOf(const BeamFigure& beams, const Extent& extent, double aspect) {
  const double middle_deg = std::clamp(0.0, extent.azimuth.low, extent.azimuth.high);
  std::vector<BeamFigure::Beam> column;
  std::vector<double> steps, spacings;
  for (const auto& row : beams.rows) {
    if (row.empty()) continue;
    column.push_back(nearest(row, middle_deg));
    for (std::size_t i = 1; i < row.size(); ++i) steps.push_back(std::abs(row[i].azimuth_deg - row[i - 1].azimuth_deg));
  }
  std::sort(column.begin(), column.end(), [](auto& a, auto& b) { return a.elevation_deg < b.elevation_deg; });
  for (std::size_t i = 1; i < column.size(); ++i)
    spacings.push_back(column[i].elevation_deg - column[i - 1].elevation_deg);
  Window window;
  window.centre = column[column.size() / 2];
  window.width_deg = std::max({8.0 * medianOf(steps), 4.0 * beams.width_deg, aspect * 1.5 * beams.height_deg,
                               aspect * 2.4 * medianOf(spacings), 0.1});
  return window;
}

/// The part of a footprint that lies inside the panel; nothing if it lies beside it.
std::vector<Point> footprint(const Panel& panel, const BeamFigure::Beam& beam, const BeamFigure& beams) {
  constexpr int kCorners = 24;
  // A beam off the horizon spans more azimuth than it is wide.
  const double half_width = 0.5 * beams.width_deg / std::max(0.05, std::cos(beam.elevation_deg * kRadPerDeg));
  const double half_height = 0.5 * beams.height_deg;
  const Range x = panel.x.values(), y = panel.y.values();
  if (beam.azimuth_deg + half_width <= x.low || beam.azimuth_deg - half_width >= x.high) return {};
  if (beam.elevation_deg + half_height <= y.low || beam.elevation_deg - half_height >= y.high) return {};
  std::vector<Point> corners;
  const int count = beams.elliptic ? kCorners : 4;
  const double reach = beams.elliptic ? 1.0 : std::numbers::sqrt2;
  for (int i = 0; i <= count; ++i) {  // closed
    const double turn = 2.0 * std::numbers::pi * (i + 0.5) / count;
    corners.push_back({panel.x.pixelWithin(beam.azimuth_deg + half_width * reach * std::cos(turn)),
                       panel.y.pixelWithin(beam.elevation_deg + half_height * reach * std::sin(turn))});
  }
  return corners;
}

void drawWindow(Figure& figure, const Panel& panel, const BeamFigure& beams) {
  drawAxes(figure, panel);
  const auto inside = [](const Range& range, double value) { return range.low <= value && value <= range.high; };
  for (const auto& row : beams.rows) {
    for (const auto& beam : row) {
      if (beams.width_deg > 0.0) {
        const std::vector<Point> corners = footprint(panel, beam, beams);
        figure.polygon(corners, {.colour = kShades[shadeOf(beam)], .opacity = 0.6});
        figure.polyline(corners, {.colour = kShades.back(), .width = 0.5});
      }
      if (inside(panel.x.values(), beam.azimuth_deg) && inside(panel.y.values(), beam.elevation_deg))
        figure.circle(panel.at(beam), 0.8, {.colour = colour::kInk});
    }
  }
}

}  // namespace

std::string beamFigure(const BeamFigure& beams) {
  const Extent extent = extentOf(beams);
  if (extent.count == 0) {
    Figure blank(kWidth, 60.0, beams.title);
    blank.text({20.0, 34.0}, beams.title + ": no beams", {.colour = colour::kMuted});
    return blank.svg();
  }
  const bool shaded = extent.least_gain < 1.0;
  const double top = shaded ? 104.0 : 64.0;
  const double width = kWidth - kLeft - kRight;
  const Box whole = {kLeft, top, width, 190.0};
  const Box part = {kLeft, top + whole.height + 84.0, width, 230.0};
  Figure figure(kWidth, part.y + part.height + 46.0, beams.title);
  figure.text({20.0, 24.0}, fitted(beams.title, 15.0, kWidth - 40.0), {.size = 15.0, .bold = true});
  figure.text({20.0, 44.0}, fitted(beams.note, 12.0, kWidth - 40.0), {.colour = colour::kMuted});
  if (shaded) {
    double x = kLeft;
    for (std::size_t i = 0; i < kShades.size(); ++i) {
      const LegendEntry entry{.text = std::string(kShadeNames[i]), .colour = kShades[i]};
      const double room = 46.0 + textWidth(entry.text, 12.0);
      (void)drawLegend(figure, {x, 62.0}, room, std::span(&entry, 1));
      x += room + 6.0;
    }
  }
  drawFrame(figure, Panel(whole, shown(extent.azimuth, 0.03), shown(extent.elevation, 0.08)), beams, extent.count);
  const double aspect = part.width / part.height;
  const Window window = windowOf(beams, extent, aspect);
  const double half_width = 0.5 * window.width_deg, half_height = half_width / aspect;
  figure.text({part.x, part.y - 12.0},
              beams.width_deg > 0.0 ? "A part of it, beams as wide as they are" : "A part of it", {.bold = true});
  const BeamFigure::Beam& c = window.centre;
  drawWindow(figure,
             Panel(part, {c.azimuth_deg - half_width, c.azimuth_deg + half_width},
                   {c.elevation_deg - half_height, c.elevation_deg + half_height}),
             beams);
  return figure.svg();
}

}  // namespace report
