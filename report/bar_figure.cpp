#include "report/bar_figure.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "report/figure.h"

namespace report {

namespace {

constexpr double kWidth = 680.0;
constexpr double kRow = 24.0;
constexpr double kBar = 14.0;
constexpr std::string_view kQuiet = "#9fb8c9";

Range rangeOf(const BarFigure& content) {
  if (content.range) return *content.range;
  Range range = {0.0, 0.0};
  for (const auto& bar : content.bars) {
    for (const double end :
         {bar.value, bar.interval ? bar.interval->low : bar.value, bar.interval ? bar.interval->high : bar.value}) {
      if (!std::isfinite(end)) continue;
      range.low = std::min(range.low, end);
      range.high = std::max(range.high, end);
    }
  }
  if (range.low == range.high) return {0.0, 1.0};
  const double margin = 0.04 * (range.high - range.low);
  return {range.low < 0.0 ? range.low - margin : 0.0, range.high > 0.0 ? range.high + margin : 0.0};
}

double nameWidth(const BarFigure& content) {
  double widest = 60.0;
  constexpr double kBold = 1.12;  // times as wide
  for (const auto& bar : content.bars)
    widest = std::max(widest, textWidth(bar.name, 12.0) * (bar.emphasised ? kBold : 1.0));
  return std::min(widest, 300.0);
}

void drawBar(Figure& figure, const BarFigure::Bar& bar, const Scale& x, double top) {
  const double zero = x.pixelWithin(0.0);
  const double end = x.pixelWithin(bar.value);
  const double middle = top + kBar / 2.0;
  figure.rectangle({std::min(zero, end), top, std::max(0.8, std::abs(end - zero)), kBar},
                   {.colour = bar.emphasised ? colour::kSimulated : kQuiet});
  if (!bar.interval) return;
  const double from = x.pixelWithin(bar.interval->low);
  const double to = x.pixelWithin(bar.interval->high);
  figure.line({from, middle}, {to, middle}, {.width = 1.4});
  for (const double at : {from, to}) figure.line({at, middle - 4.0}, {at, middle + 4.0}, {.width = 1.4});
}

}  // namespace

std::string barFigure(const BarFigure& content) {
  constexpr double kNumber = 74.0;  // the column of numbers at the right
  const double names = nameWidth(content);
  const double height = kRow * static_cast<double>(std::max<std::size_t>(content.bars.size(), 1));
  const Box area = {names + 24.0, 42.0, kWidth - names - 24.0 - kNumber, height};
  Figure figure(kWidth, area.y + area.height + 46.0, content.title);
  figure.text({16.0, 22.0}, fitted(content.title, 15.0, kWidth - 32.0), {.size = 15.0, .bold = true});
  const Scale x(rangeOf(content), area.x, area.x + area.width);
  drawBottomAxis(figure, area, x, content.value_name);
  double top = area.y + (kRow - kBar) / 2.0;
  for (const auto& bar : content.bars) {
    figure.text({area.x - 8.0, top + kBar - 3.0}, fitted(bar.name, 12.0, names),
                {.anchor = Anchor::End, .bold = bar.emphasised});
    if (std::isfinite(bar.value)) {
      drawBar(figure, bar, x, top);
      figure.text({kWidth - 16.0, top + kBar - 3.0}, bar.label.empty() ? core::significant(bar.value) : bar.label,
                  {.anchor = Anchor::End});
    }
    top += kRow;
  }
  const double zero = x.pixelWithin(0.0);
  figure.line({zero, area.y}, {zero, area.y + area.height});
  return figure.svg();
}

}  // namespace report
