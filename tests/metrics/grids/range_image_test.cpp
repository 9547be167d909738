#include "metrics/grids/range_image.h"

#include <gtest/gtest.h>
#include <limits>
#include <utility>

#include "tests/support/thrown_message.h"

namespace {

using metrics::echoPictureDistance;
using metrics::ExistenceShares;
using metrics::existenceShares;
using metrics::RangeImage;
using metrics::requireComparable;
using metrics::SharedPixels;
using test_support::thrownMessage;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

RangeImage image(std::size_t rows, std::size_t columns, std::vector<double> range_m) {
  return {.rows = rows, .columns = columns, .range_m = std::move(range_m)};
}

TEST(RangeImage, PairsOnlyPixelsWithAnEchoOnBothSides) {
  const RangeImage simulated = image(2, 2, {1.0, kNone, 3.0, kNone});
  const RangeImage measured = image(2, 2, {5.0, 6.0, kNone, kNone});
  const SharedPixels shared({.simulated = simulated, .measured = measured});
  EXPECT_EQ(shared.simulated_m, std::vector<double>{1.0});
  EXPECT_EQ(shared.measured_m, std::vector<double>{5.0});
}

TEST(RangeImage, CountsMissingAndExtraPixelsAsSharesOfAll) {
  const RangeImage simulated = image(1, 8, {1.0, kNone, kNone, kNone, 5.0, 5.0, kNone, 1.0});
  const RangeImage measured = image(1, 8, {1.0, 2.0, 2.0, 3.0, kNone, 5.0, kNone, 1.0});
  const ExistenceShares shares = existenceShares({.simulated = simulated, .measured = measured});
  EXPECT_EQ(shares.measured_only, 3.0 / 8.0);
  EXPECT_EQ(shares.simulated_only, 1.0 / 8.0);
  const ExistenceShares exchanged = existenceShares({.simulated = measured, .measured = simulated});
  EXPECT_EQ(exchanged.measured_only, shares.simulated_only);
  EXPECT_EQ(exchanged.simulated_only, shares.measured_only);
}

TEST(RangeImage, PictureDistanceIsOfThePixelsWithAnEcho) {
  const RangeImage simulated = image(1, 5, {9.0, kNone, kNone, kNone, kNone});
  const RangeImage measured = image(1, 5, {kNone, kNone, kNone, 2.0, kNone});
  const RangeImage dark = image(1, 5, std::vector<double>(5, kNone));
  EXPECT_EQ(echoPictureDistance({.simulated = simulated, .measured = measured}), 6.0);
  EXPECT_EQ(echoPictureDistance({.simulated = simulated, .measured = dark}), kInfinite);
  EXPECT_EQ(echoPictureDistance({.simulated = dark, .measured = dark}), 0.0);
}

TEST(RangeImage, RefusesWhatIsNoRangeAndSaysWhere) {
  const RangeImage good = image(2, 2, {1.0, 2.0, kNone, 4.0});
  const auto message = [&](const RangeImage& other) {
    return thrownMessage([&] { requireComparable({.simulated = other, .measured = good}); });
  };
  EXPECT_EQ(message(good), "");
  EXPECT_EQ(
      message(image(2, 2, {1.0, 2.0, 3.0, kInfinite})).rfind("simulated range image, row 2, column 2: has the", 0), 0u);
  EXPECT_NE(message(image(2, 2, {1.0, 0.0, 3.0, 4.0})).find("Write NaN for a beam without an echo"), std::string::npos);
  EXPECT_NE(message(image(2, 2, {-1.0, 2.0, 3.0, 4.0})).find("row 1, column 1"), std::string::npos);
  EXPECT_NE(message(image(2, 3, std::vector<double>(6, 1.0))).find("2 x 3 and 2 x 2"), std::string::npos);
}

TEST(RangeImage, EveryMetricRefusesImagesThatDoNotCompare) {
  const RangeImage four = image(2, 2, {1.0, 2.0, kNone, 4.0});
  const RangeImage two = image(1, 2, {1.0, 2.0});
  EXPECT_NE(thrownMessage([&] { SharedPixels({.simulated = four, .measured = two}); }), "");
  EXPECT_NE(thrownMessage([&] { (void)existenceShares({.simulated = four, .measured = two}); }), "");
  EXPECT_NE(thrownMessage([&] { (void)echoPictureDistance({.simulated = four, .measured = two}); }), "");
}

}  // namespace
