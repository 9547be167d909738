#include "report/panel_figure.h"

#include <cmath>
#include <gmock/gmock.h>

#include "tests/report/svg_reader.h"

namespace report {
namespace {

using testing::HasSubstr;
using testing::Not;

PanelFigure twoPanels() {
  PanelFigure figure;
  figure.title = "EPW <measured> − simulated";
  figure.x_name = "azimuth in °";
  figure.value_name = "in m";
  figure.low_end = "smaller";
  figure.high_end = "larger";
  figure.panels.push_back({"mean", {"-1°", "1°"}, {{0.0, 0.0, 2.0}, {1.0, 1.0, std::nan("")}}, 1.0});
  figure.panels.push_back({"scatter", {"-1°", "1°"}, {{0.0, 0.0, 1.0}, {1.0, 1.0, 0.0}}, 1.0});
  return figure;
}

// On one scale to 2: a value of 1 is half red in its own panel, though it is the largest there.
TEST(PanelFigure, AllPanelsShareOneScale) {
  PanelFigure figure = twoPanels();
  figure.full_scale = 2.0;
  const std::string svg = panelFigure(figure);
  report_test::expectSvgTiny(svg);
  EXPECT_THAT(svg, HasSubstr(divergingColour(1.0)));
  EXPECT_THAT(svg, HasSubstr(divergingColour(0.5)));
}

TEST(PanelFigure, SaysWhatItsColoursMeanAndShowsBeamsWithoutData) {
  const std::string svg = panelFigure(twoPanels());
  for (const char* word : {"smaller", "larger", "no data", "#c8ccd1", "in m"}) EXPECT_THAT(svg, HasSubstr(word));
  EXPECT_THAT(svg, Not(HasSubstr("<measured>")));
}

TEST(PanelFigure, SurvivesNoPanelsAndPanelsWithoutCells) {
  report_test::expectSvgTiny(panelFigure({}));
  PanelFigure figure;
  figure.panels.push_back({"nothing", {}, {}, 1.0});
  const std::string svg = panelFigure(figure);
  report_test::expectSvgTiny(svg);
  EXPECT_THAT(svg, HasSubstr("no data"));
}

}  // namespace
}  // namespace report
