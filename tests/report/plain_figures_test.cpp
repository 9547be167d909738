#include <cmath>
#include <gmock/gmock.h>

#include "report/bar_figure.h"
#include "report/curve_figure.h"
#include "report/map_figure.h"
#include "report/point_figure.h"
#include "tests/report/svg_reader.h"

namespace report {
namespace {

using testing::HasSubstr;

TEST(DivergingColour, IsBlueBelowWhiteAtAndRedAboveZero) {
  EXPECT_EQ(divergingColour(0.0), "#f7f7f7");
  EXPECT_EQ(divergingColour(-1.0), "#2166ac");
  EXPECT_EQ(divergingColour(1.0), "#b2182b");
  EXPECT_EQ(divergingColour(7.0), divergingColour(1.0));
}

TEST(MapFigure, ColoursEachCellByItsValueAndLeavesUnknownOnesGrey) {
  MapFigure map{.title = "EPW bias",
                .x_name = "azimuth in °",
                .y_name = "layer",
                .value_name = "in m",
                .cell_width = 2.0,
                .full_scale = 1.0};
  map.cells = {{0.0, 0.0, 1.0}, {2.0, 0.0, 0.0}, {4.0, 1.0, std::nan("")}};
  const std::string svg = mapFigure(map);
  report_test::expectSvgTiny(svg);
  EXPECT_THAT(svg, HasSubstr(divergingColour(1.0)));
  EXPECT_THAT(svg, HasSubstr("#d0d4d9"));
  EXPECT_THAT(svg, HasSubstr("azimuth in °"));
}

TEST(MapFigure, WithoutCellsSaysSo) {
  const std::string svg = mapFigure({.title = "EPW bias"});
  report_test::expectSvgTiny(svg);
  EXPECT_THAT(svg, HasSubstr("no cell has a value"));
}

TEST(BarFigure, DrawsBarsIntervalsAndNumbersInTheGivenOrder) {
  BarFigure bars{.title = "Causes", .value_name = "shrink"};
  bars.bars = {{"attenuation", 0.93, Range{0.90, 0.95}, true}, {"range <walk>", -0.12, std::nullopt, false}};
  const std::string svg = barFigure(bars);
  report_test::expectSvgTiny(svg);
  EXPECT_LT(svg.find("attenuation"), svg.find("range &lt;walk&gt;"));
  EXPECT_THAT(svg, HasSubstr(">0.93<"));
}

TEST(BarFigure, WritesALabelInPlaceOfTheNumberWhereThereIsOne) {
  BarFigure bars{.title = "Causes"};
  bars.bars = {{.name = "cloud", .value = -12417.0, .interval = std::nullopt, .label = "grows 125×"}};
  const std::string svg = barFigure(bars);
  EXPECT_THAT(svg, HasSubstr(">grows 125×<"));
  EXPECT_THAT(svg, testing::Not(HasSubstr(">-12417<")));
}

TEST(BarFigure, SurvivesNoBarsAndNumbersThatAreNone) {
  report_test::expectSvgTiny(barFigure({.title = "none"}));
  BarFigure bars{.title = "Causes"};
  bars.bars = {{"a", std::numeric_limits<double>::infinity(), std::nullopt, false}, {"b", 0.0, std::nullopt, false}};
  report_test::expectSvgTiny(barFigure(bars));
}

TEST(CurveFigure, DrawsALineForEveryStretchOfFiniteValues) {
  const double none = std::nan("");
  CurveFigure curves{.title = "Return", .x_name = "angle in °", .y_name = "dB", .x = {0, 1, 2, 3, 4}};
  curves.curves = {{"paint <red>", {1, 2, none, 2, 1}}, {"glass", {5, 5, 5, 5, 5}}};
  const std::string svg = curveFigure(curves);
  report_test::expectSvgTiny(svg);
  std::size_t lines = 0;
  for (std::size_t at = svg.find("<polyline"); at != std::string::npos; at = svg.find("<polyline", at + 1)) ++lines;
  EXPECT_EQ(lines, 3u);
  EXPECT_THAT(svg, HasSubstr("paint &lt;red&gt;"));
}

TEST(CurveFigure, SurvivesNothing) {
  report_test::expectSvgTiny(curveFigure({.title = "none"}));
  report_test::expectSvgTiny(curveFigure({.title = "none", .x = {1}, .curves = {{"a", {std::nan("")}}}}));
}

// A dot is a move and a stroke of no length: one per point inside the ranges.
TEST(PointFigure, DrawsTheReferenceInEveryPanelAndLeavesOutWhatLiesOutside) {
  PointFigure figure{.title = "Street", .x_name = "x in m", .y_name = "y in m", .x = {0.0, 10.0}, .y = {-5.0, 5.0}};
  figure.reference = {"off", {{1.0, 0.0}, {2.0, 0.0}, {11.0, 0.0}}};
  figure.panels = {{"a <little>", {{1.0, 0.0}}}, {"much", {{1.0, 6.0}}}};
  const std::string svg = pointFigure(figure);
  report_test::expectSvgTiny(svg);
  std::size_t dots = 0;
  for (std::size_t at = svg.find("h.1"); at != std::string::npos; at = svg.find("h.1", at + 1)) ++dots;
  EXPECT_EQ(dots, 2u * 2u + 1u);
  EXPECT_THAT(svg, HasSubstr("a &lt;little&gt;"));
}

TEST(PointFigure, SurvivesNoPoints) { report_test::expectSvgTiny(pointFigure({.title = "none"})); }

}  // namespace
}  // namespace report
