#include "report/beam_figure.h"

#include <gmock/gmock.h>

#include "tests/report/svg_reader.h"

namespace report {
namespace {

using testing::HasSubstr;
using testing::Not;

BeamFigure fan(std::size_t rows, std::size_t columns) {
  BeamFigure beams{.title = "fan <of> beams", .note = "note", .width_deg = 0.3, .height_deg = 0.2};
  beams.rows.resize(rows);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c)
      beams.rows[r].push_back({10.0 - static_cast<double>(c), static_cast<double>(r)});
  }
  return beams;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(BeamFigure, DrawsADotABeamAndItsFootprint) {
  const std::string svg = beamFigure(fan(2, 21));
  report_test::expectSvgTiny(svg);
  EXPECT_GE(count(svg, "<circle"), 42u);  // and those of the window
  EXPECT_GT(count(svg, "<polygon"), 0u);
  EXPECT_THAT(svg, HasSubstr("fan &lt;of&gt; beams"));
  EXPECT_THAT(svg, HasSubstr("azimuth in °"));
  EXPECT_THAT(svg, Not(HasSubstr("gain")));
}

TEST(BeamFigure, StaysSmallHoweverManyBeams) { EXPECT_LT(beamFigure(fan(64, 3000)).size(), 200'000u); }

TEST(BeamFigure, SaysWhatItsShadesMean) {
  BeamFigure beams = fan(1, 21);
  beams.rows[0][3].gain = 0.3;
  EXPECT_THAT(beamFigure(beams), HasSubstr("0.2 to 0.4"));
}

TEST(BeamFigure, SurvivesOneBeamNoWidthAndNoBeams) {
  BeamFigure one = fan(1, 1);
  one.width_deg = one.height_deg = 0.0;
  report_test::expectSvgTiny(beamFigure(one));
  report_test::expectSvgTiny(beamFigure({.title = "none"}));
  BeamFigure empty_row = fan(1, 5);
  empty_row.rows.push_back({});
  report_test::expectSvgTiny(beamFigure(empty_row));
}

}  // namespace
}  // namespace report
