#include "report/edf_figure.h"

#include <cmath>
#include <gmock/gmock.h>

#include "core/random.h"
#include "metrics/area/area_metric.h"
#include "tests/report/svg_reader.h"

namespace report {
namespace {

using metrics::Edf;
using metrics::PBox;
using report_test::areaOf;
using report_test::polygonsOf;
using testing::HasSubstr;

constexpr const char* kTooSmall = "#e69f00";
constexpr const char* kTooLarge = "#a3387c";

Edf normal(double mean, double deviation, std::size_t n, std::uint32_t stream) {
  core::Random random({.seed = 7, .sample = stream});
  std::vector<double> values(n);
  for (double& value : values) value = mean + deviation * random.normal();
  return Edf(values);
}

EdfFigureText rangeText() { return {.title = "Range at 10 m", .quantity = "range", .unit = "m"}; }

double shaded(const std::string& svg, const char* colour) {
  double area = 0.0;
  for (const auto& outline : polygonsOf(svg, colour)) area += areaOf(outline);
  return area;
}

// The ratio of the two shaded areas on the paper is the ratio of the numbers: nothing is drawn that was not computed.
TEST(EdfFigure, ShadesAreasInTheRatioOfDPlusAndDMinus) {
  const PBox measured = normal(10.0, 0.03, 400, 1);
  const PBox simulated = normal(10.005, 0.05, 300, 2);
  const std::string svg = edfFigure({.simulated = simulated, .measured = measured}, rangeText());
  const metrics::AreaPortions areas = metrics::areaPortions({.simulated = simulated, .measured = measured});
  EXPECT_NEAR(shaded(svg, kTooSmall) / shaded(svg, kTooLarge), areas.d_plus / areas.d_minus,
              0.01 * areas.d_plus / areas.d_minus);
}

TEST(EdfFigure, ShadesOnlyOneSideOfAPureOffset) {
  const Edf measured = normal(10.0, 0.03, 400, 1);
  const std::string high = edfFigure({.simulated = measured.shifted(0.02), .measured = measured}, rangeText());
  EXPECT_TRUE(polygonsOf(high, kTooSmall).empty());
  EXPECT_FALSE(polygonsOf(high, kTooLarge).empty());
  const std::string low = edfFigure({.simulated = measured.shifted(-0.02), .measured = measured}, rangeText());
  EXPECT_FALSE(polygonsOf(low, kTooSmall).empty());
  EXPECT_TRUE(polygonsOf(low, kTooLarge).empty());
}

TEST(EdfFigure, ShadesNothingWhereTheBoxCoversTheMeasurement) {
  const Edf measured = normal(10.0, 0.03, 200, 1);
  const Edf runs[] = {measured.shifted(-0.01), measured, measured.shifted(0.01)};
  const PBox box = PBox::envelope(runs);
  EdfFigureText text = rangeText();
  text.simulated_n = {200, 200, 200};
  const std::string svg = edfFigure({.simulated = box, .measured = measured}, text);
  EXPECT_DOUBLE_EQ(shaded(svg, kTooSmall) + shaded(svg, kTooLarge), 0.0);
  EXPECT_THAT(svg, HasSubstr("p-box of 3 runs (n = 200 each)"));
  EXPECT_THAT(svg, HasSubstr("measurement (n = 200)"));
}

TEST(EdfFigure, StaysSmallForAMillionValues) {
  const PBox measured = normal(10.0, 0.03, 1'000'000, 1);
  const PBox simulated = normal(10.01, 0.05, 1'000'000, 2);
  const std::string svg = edfFigure({.simulated = simulated, .measured = measured}, rangeText());
  report_test::expectSvgTiny(svg);
  EXPECT_LT(svg.size(), 40'000u);
}

TEST(EdfFigure, DrawsDegenerateSamples) {
  const Edf one({5.0});
  report_test::expectSvgTiny(edfFigure({.simulated = one, .measured = one}, rangeText()));
  const Edf zero({0.0, 0.0, 0.0});
  report_test::expectSvgTiny(edfFigure({.simulated = one, .measured = zero}, rangeText()));
  const Edf huge({-1e12, 1e12});
  report_test::expectSvgTiny(edfFigure({.simulated = huge, .measured = one}, rangeText()));
}

TEST(EdfFigure, SaysThatOutliersLieBeyondTheAxis) {
  std::vector<double> values(1000, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 10.0 + 1e-4 * static_cast<double>(i);
  values.back() = 180.0;
  const Edf measured(values);
  const Edf simulated = normal(10.05, 0.02, 500, 3);
  const std::string svg = edfFigure({.simulated = simulated, .measured = measured}, rangeText());
  EXPECT_THAT(svg, HasSubstr("further values"));
  EXPECT_THAT(svg, testing::Not(HasSubstr(">180<")));
  report_test::expectSvgTiny(svg);
}

TEST(EdfFigure, ShowsTheAcceptedBias) {
  const Edf measured = normal(10.0, 0.03, 200, 1);
  EdfFigureText text = rangeText();
  text.bias_limit = 0.05;
  text.note = "d_bias = 0.02 m (limit 0.05 m)";
  const std::string svg = edfFigure({.simulated = measured.shifted(0.02), .measured = measured}, text);
  EXPECT_THAT(svg, HasSubstr("accepted d_bias: ±0.05 m"));
  EXPECT_THAT(svg, HasSubstr(text.note));
}

TEST(EdfFigure, IsTheSameBytesEveryTime) {
  const PBox measured = normal(10.0, 0.03, 500, 1);
  const PBox simulated = normal(10.01, 0.05, 500, 2);
  EXPECT_EQ(edfFigure({.simulated = simulated, .measured = measured}, rangeText()),
            edfFigure({.simulated = simulated, .measured = measured}, rangeText()));
}

}  // namespace
}  // namespace report
