#include "report/figure.h"

#include <cmath>
#include <gmock/gmock.h>

#include "tests/report/svg_reader.h"

namespace report {
namespace {

using testing::HasSubstr;

TEST(Figure, EscapesEveryText) {
  Figure figure(100, 50, "a < b & \"c\"");
  figure.text({1, 2}, "<script>");
  report_test::expectSvgTiny(figure.svg());
  EXPECT_THAT(figure.svg(), HasSubstr("&lt;script&gt;"));
}

TEST(Figure, WritesCoordinatesToATenthOfAPixelWithoutNegativeZero) {
  Figure figure(100, 50, "");
  figure.line({-0.01, 1.0 / 3.0}, {12.0, 99.96});
  EXPECT_THAT(figure.svg(), HasSubstr("x1=\"0\" y1=\"0.3\" x2=\"12\" y2=\"100\""));
}

TEST(Simplified, KeepsEveryPointWithinTheTolerance) {
  std::vector<Point> points;
  for (int i = 0; i <= 5000; ++i) points.push_back({0.1 * i, 100.0 * std::sin(0.004 * i)});
  const std::vector<Point> few = simplified(points, 0.1);
  EXPECT_LT(few.size(), 200u);
  std::size_t segment = 0;
  for (const Point& point : points) {
    while (few[segment + 1].x < point.x) ++segment;
    const Point& a = few[segment];
    const Point& b = few[segment + 1];
    const double t = (point.x - a.x) / (b.x - a.x);
    EXPECT_NEAR(a.y + t * (b.y - a.y), point.y, 0.1 * std::hypot(1.0, 4.0) + 1e-9);  // slope at most 4
  }
}

TEST(Simplified, LeavesACornerAlone) {
  const std::vector<Point> step = {{0, 0}, {5, 0}, {10, 0}, {10, 8}, {20, 8}};
  EXPECT_EQ(simplified(step).size(), 4u);
}

TEST(Fitted, ShortensAtWholeCharacters) {
  EXPECT_EQ(fitted("short", 12, 200), "short");
  const std::string cut = fitted("größenwahnsinnige Überschrift über alles", 12, 60);
  EXPECT_LE(textWidth(cut, 12), 60.0);
  EXPECT_THAT(cut, testing::EndsWith("…"));
  EXPECT_THAT(cut, testing::StartsWith("grö"));
}

TEST(WithUnit, LeavesOutTheUnitOfANumber) {
  EXPECT_EQ(withUnit("range", "m"), "range in m");
  EXPECT_EQ(withUnit("missing fraction", ""), "missing fraction");
}

}  // namespace
}  // namespace report
