#include "report/map_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"
#include "report/axis.h"
#include "report/figure.h"

namespace report {

namespace {

constexpr double kWidth = 680.0;
constexpr double kColourBar = 96.0;  // with its labels
constexpr std::string_view kUnknown = "#d0d4d9";

double largestMagnitude(const std::vector<MapFigure::Cell>& cells) {
  std::vector<double> magnitudes;
  for (const auto& cell : cells) {
    if (std::isfinite(cell.value)) magnitudes.push_back(std::abs(cell.value));
  }
  if (magnitudes.empty()) return 1.0;
  const auto rank = static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(magnitudes.size() - 1));
  std::nth_element(magnitudes.begin(), magnitudes.begin() + rank, magnitudes.end());
  return magnitudes[static_cast<std::size_t>(rank)] > 0.0
             ? magnitudes[static_cast<std::size_t>(rank)]
             : std::max(*std::max_element(magnitudes.begin(), magnitudes.end()), 1e-12);
}

struct Extent {
  Range x;
  Range y;
};

Extent extentOf(const MapFigure& map) {
  const auto [x_low, x_high] =
      std::minmax_element(map.cells.begin(), map.cells.end(), [](auto& a, auto& b) { return a.x < b.x; });
  const auto [y_low, y_high] =
      std::minmax_element(map.cells.begin(), map.cells.end(), [](auto& a, auto& b) { return a.y < b.y; });
  return {{x_low->x - map.cell_width / 2.0, x_high->x + map.cell_width / 2.0},
          {y_low->y - map.cell_height / 2.0, y_high->y + map.cell_height / 2.0}};
}

void drawColourBar(Figure& figure, const Box& area, double full_scale, const std::string& name) {
  constexpr int kSteps = 40;
  const Box bar = {area.x + area.width + 26.0, area.y, 14.0, area.height};
  const double step = bar.height / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double share = 1.0 - 2.0 * (i + 0.5) / kSteps;
    figure.rectangle({bar.x, bar.y + i * step, bar.width, step + 0.3}, {.colour = divergingColour(share)});
  }
  figure.frame(bar, {.colour = colour::kMuted, .width = 0.8});
  const Scale scale({-full_scale, full_scale}, bar.y + bar.height, bar.y);
  const Ticks ticks = niceTicks(scale.values(), bar.height > 120.0 ? 6 : 3);
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double y = scale.pixel(ticks.at[i]);
    figure.line({bar.x + bar.width, y}, {bar.x + bar.width + 4.0, y});
    figure.text({bar.x + bar.width + 7.0, y + 4.0}, ticks.labels[i], {.size = 11.0});
  }
  figure.text({bar.x + bar.width + 40.0, bar.y - 10.0}, name, {.size = 11.0, .anchor = Anchor::End});
}

}  // namespace

std::string divergingColour(double share) {
  // Blue to red over near white (ColorBrewer RdBu, Harrower & Brewer 2003), linear between its steps.
  constexpr std::array<std::array<double, 3>, 7> kSteps = {{{33, 102, 172},
                                                            {103, 169, 207},
                                                            {209, 229, 240},
                                                            {247, 247, 247},
                                                            {253, 219, 199},
                                                            {239, 138, 98},
                                                            {178, 24, 43}}};
  const double place = 3.0 * (std::clamp(share, -1.0, 1.0) + 1.0);
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), 5);
  const double part = place - static_cast<double>(below);
  std::array<int, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    rgb[i] = static_cast<int>(std::lround(kSteps[below][i] + part * (kSteps[below + 1][i] - kSteps[below][i])));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

std::string mapFigure(const MapFigure& map) {
  Figure blank(kWidth, 60.0, map.title);
  if (map.cells.empty()) {
    blank.text({20.0, 34.0}, map.title + ": no cell has a value", {.colour = colour::kMuted});
    return blank.svg();
  }
  const Extent extent = extentOf(map);
  const double rows = (extent.y.high - extent.y.low) / map.cell_height;
  const Box area = {70.0, 64.0, kWidth - 70.0 - kColourBar, std::clamp(22.0 * rows, 90.0, 320.0)};
  Figure figure(kWidth, area.y + area.height + 46.0, map.title);
  figure.text({area.x, 22.0}, fitted(map.title, 15.0, kWidth - area.x - 20.0), {.size = 15.0, .bold = true});
  const double left = area.x;
  const double right = area.x + area.width;
  const Scale x(extent.x, map.x_grows_leftwards ? right : left, map.x_grows_leftwards ? left : right);
  const Scale y(extent.y, area.y + area.height, area.y);
  figure.rectangle(area, {.colour = "#f2f3f5"});
  drawBottomAxis(figure, area, x, map.x_name);
  drawLeftAxis(figure, area, y, map.y_name);
  const double full_scale = map.full_scale.value_or(largestMagnitude(map.cells));
  const double width = std::abs(x.pixel(map.cell_width) - x.pixel(0.0));
  const double height = std::abs(y.pixel(map.cell_height) - y.pixel(0.0));
  for (const auto& cell : map.cells) {
    const std::string fill =
        std::isfinite(cell.value) ? divergingColour(cell.value / full_scale) : std::string(kUnknown);
    figure.rectangle({x.pixel(cell.x) - width / 2.0, y.pixel(cell.y) - height / 2.0, width, height}, {.colour = fill});
  }
  figure.frame(area, {.colour = colour::kMuted, .width = 0.8});
  drawColourBar(figure, area, full_scale, map.value_name);
  return figure.svg();
}

}  // namespace report
