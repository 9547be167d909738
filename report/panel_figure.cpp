#include "report/panel_figure.h"

#include <algorithm>
#include <cmath>

#include "report/axis.h"
#include "report/figure.h"

namespace report {

namespace {

constexpr double kWidth = 930.0;
constexpr double kLeft = 74.0;   // of a panel: names of the rows
constexpr double kRight = 16.0;  // of a panel
constexpr double kHead = 26.0;   // of a panel: its title
constexpr double kFoot = 46.0;   // of a panel: the axis
constexpr double kColourBar = 62.0;
constexpr std::string_view kNoData = "#c8ccd1";

double fullScaleOf(const PanelFigure& content) {
  if (content.full_scale) return *content.full_scale;
  std::vector<double> magnitudes;
  for (const auto& panel : content.panels) {
    for (const auto& cell : panel.cells) {
      if (std::isfinite(cell.value)) magnitudes.push_back(std::abs(cell.value));
    }
  }
  if (magnitudes.empty()) return 1.0;
  std::sort(magnitudes.begin(), magnitudes.end());
  const double usual = magnitudes[static_cast<std::size_t>(0.98 * static_cast<double>(magnitudes.size() - 1))];
  return usual > 0.0 ? usual : std::max(magnitudes.back(), 1e-12);
}

double rowsHeight(const PanelFigure::Panel& panel) {
  return std::clamp(24.0 * static_cast<double>(panel.row_names.size()), 48.0, 240.0);
}

void drawRowNames(Figure& figure, const Box& area, const PanelFigure::Panel& panel) {
  const double row = area.height / static_cast<double>(std::max<std::size_t>(1, panel.row_names.size()));
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(12.0 / row)));
  for (std::size_t i = 0; i < panel.row_names.size(); i += stride) {
    const double y = area.y + area.height - (static_cast<double>(i) + 0.5) * row;
    figure.text({area.x - 6.0, y + 4.0}, panel.row_names[i], {.size = 11.0, .anchor = Anchor::End});
  }
}

void drawPanel(Figure& figure, const Box& area, const PanelFigure& content, const PanelFigure::Panel& panel,
               double full_scale) {
  figure.text({area.x, area.y - 8.0}, fitted(panel.title, 12.5, area.width + 10.0), {.size = 12.5, .bold = true});
  figure.rectangle(area, {.colour = "#ffffff"});
  if (panel.cells.empty()) {
    figure.text({area.x + 8.0, area.y + 20.0}, "no data", {.colour = colour::kMuted});
    figure.frame(area, {.colour = colour::kMuted, .width = 0.8});
    return;
  }
  const auto [low, high] =
      std::minmax_element(panel.cells.begin(), panel.cells.end(), [](auto& a, auto& b) { return a.x < b.x; });
  const Range range = {low->x - panel.cell_width / 2.0, high->x + panel.cell_width / 2.0};
  const double right = area.x + area.width;
  const Scale x(range, content.x_grows_leftwards ? right : area.x, content.x_grows_leftwards ? area.x : right);
  drawBottomAxis(figure, area, x, content.x_name);
  const double row = area.height / static_cast<double>(std::max<std::size_t>(1, panel.row_names.size()));
  const double width = std::abs(x.pixel(panel.cell_width) - x.pixel(0.0));
  for (const auto& cell : panel.cells) {
    const std::string fill =
        std::isfinite(cell.value) ? divergingColour(cell.value / full_scale) : std::string(kNoData);
    figure.rectangle(
        {x.pixel(cell.x) - width / 2.0, area.y + area.height - (cell.y + 1.0) * row, width + 0.1, row + 0.1},
        {.colour = fill});
  }
  drawRowNames(figure, area, panel);
  figure.frame(area, {.colour = colour::kMuted, .width = 0.8});
  figure.text({area.x - 58.0, area.y + area.height / 2.0}, content.y_name,
              {.size = 11.0, .anchor = Anchor::Middle, .upwards = true});
}

void drawColourBar(Figure& figure, Point at, const PanelFigure& content, double full_scale) {
  constexpr int kSteps = 60;
  const Box bar = {at.x + 170.0, at.y, 320.0, 14.0};
  for (int i = 0; i < kSteps; ++i) {
    const double step = bar.width / kSteps;
    figure.rectangle({bar.x + i * step, bar.y, step + 0.3, bar.height},
                     {.colour = divergingColour(2.0 * (i + 0.5) / kSteps - 1.0)});
  }
  figure.frame(bar, {.colour = colour::kMuted, .width = 0.8});
  const Scale scale({-full_scale, full_scale}, bar.x, bar.x + bar.width);
  const Ticks ticks = niceTicks(scale.values(), 5);
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double x = scale.pixel(ticks.at[i]);
    figure.line({x, bar.y + bar.height}, {x, bar.y + bar.height + 4.0});
    figure.text({x, bar.y + bar.height + 16.0}, ticks.labels[i], {.size = 11.0, .anchor = Anchor::Middle});
  }
  figure.text({bar.x + bar.width / 2.0, bar.y + bar.height + 33.0}, content.value_name,
              {.size = 12.0, .anchor = Anchor::Middle});
  figure.text({bar.x - 10.0, bar.y + 11.0}, content.low_end, {.anchor = Anchor::End});
  figure.text({bar.x + bar.width + 10.0, bar.y + 11.0}, content.high_end);
  const double swatch = kWidth - 110.0;
  figure.rectangle({swatch, bar.y, 22.0, bar.height}, {.colour = kNoData});
  figure.text({swatch + 29.0, bar.y + 11.0}, "no data");
}

}  // namespace

std::string panelFigure(const PanelFigure& content) {
  double height = 40.0;
  for (std::size_t i = 0; i < content.panels.size(); i += 2) {
    const double second = i + 1 < content.panels.size() ? rowsHeight(content.panels[i + 1]) : 0.0;
    height += kHead + std::max(rowsHeight(content.panels[i]), second) + kFoot;
  }
  Figure figure(kWidth, height + kColourBar, content.title);
  figure.text({16.0, 22.0}, fitted(content.title, 15.0, kWidth - 32.0), {.size = 15.0, .bold = true});
  const double full_scale = fullScaleOf(content);
  double top = 36.0;
  for (std::size_t i = 0; i < content.panels.size(); i += 2) {
    double tallest = 0.0;
    for (std::size_t p = i; p < std::min(i + 2, content.panels.size()); ++p) {
      const Box area = {static_cast<double>(p - i) * kWidth / 2.0 + kLeft, top + kHead, kWidth / 2.0 - kLeft - kRight,
                        rowsHeight(content.panels[p])};
      drawPanel(figure, area, content, content.panels[p], full_scale);
      tallest = std::max(tallest, area.height);
    }
    top += kHead + tallest + kFoot;
  }
  drawColourBar(figure, {16.0, top + 6.0}, content, full_scale);
  return figure.svg();
}

}  // namespace report
