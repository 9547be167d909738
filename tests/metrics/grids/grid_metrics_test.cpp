#include "metrics/grids/grid_metrics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "core/json_object.h"
#include "tests/metrics/grids/random_grids.h"
#include "tests/support/paths.h"

namespace {

using metrics::GridInput;
using metrics::gridMetrics;
using metrics::MetricOf;
using metrics::OccupancyGrid;
using metrics::RangeImage;
using metrics::RangeImageInput;
using metrics::rangeImageMetrics;
using metrics_test::grid;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

nlohmann::json references(const char* kind) {
  return core::readJson(test_support::testData("metrics/grids/reference.json")).at(kind);
}

/// Every metric of the list has its value in the reference. Tolerance: rounding of sums over up to 180 cells.
template <typename Input>
void expectReference(std::span<const MetricOf<Input>> list, const Input& input, const nlohmann::json& expected) {
  for (const MetricOf<Input>& metric : list) {
    const std::string key(metric.info.name);
    ASSERT_TRUE(expected.contains(key)) << key;
    EXPECT_NEAR(metric.compute(input).at(0), expected[key].get<double>(), 1e-11) << key;
  }
}

template <typename Input>
void expectWholeList(std::span<const MetricOf<Input>> list, const Input& input) {
  std::set<std::string_view> names;
  for (const MetricOf<Input>& metric : list) {
    EXPECT_TRUE(names.insert(metric.info.name).second) << metric.info.name;
    EXPECT_EQ(metric.compute(input).size(), 1u) << metric.info.name;
    EXPECT_EQ(metric.info.data.size(), 1u) << metric.info.name;
    for (const std::string_view text : {metric.info.title, metric.info.meaning, metric.info.formula, metric.info.best,
                                        metric.info.worst, metric.info.source}) {
      EXPECT_FALSE(text.empty()) << metric.info.name;
    }
  }
}

double ofGrids(int number, const GridInput& input) {
  for (const MetricOf<GridInput>& metric : gridMetrics()) {
    if (metric.info.number == number) return metric.compute(input).at(0);
  }
  throw std::out_of_range("no metric of this number");
}

// tests/data/metrics/grids/make_reference.py: numpy 1.24.2, scipy 1.10.1.
TEST(GridMetrics, ReproduceNumpyAndScipy) {
  const nlohmann::json cases = references("grids");
  ASSERT_EQ(cases.size(), 4u);
  for (const auto& [name, expected] : cases.items()) {
    SCOPED_TRACE(name);
    const auto side = [&expected = expected](const char* key) {
      return grid(expected.at("rows"), expected.at("columns"), expected.at(key).get<std::vector<double>>());
    };
    const OccupancyGrid simulated = side("simulated");
    const OccupancyGrid measured = side("measured");
    expectReference<GridInput>(gridMetrics(),
                               {.simulated = simulated, .measured = measured, .clip = expected.at("clip")}, expected);
  }
}

TEST(RangeImageMetrics, ReproduceNumpyAndScipy) {
  const nlohmann::json cases = references("range_images");
  ASSERT_EQ(cases.size(), 1u);
  for (const auto& [name, expected] : cases.items()) {
    SCOPED_TRACE(name);
    const auto side = [&expected = expected](const char* key) {
      RangeImage image = {.rows = expected.at("rows"), .columns = expected.at("columns"), .range_m = {}};
      for (const nlohmann::json& range : expected.at(key)) {
        image.range_m.push_back(range.is_null() ? kNone : range.get<double>());
      }
      return image;
    };
    const RangeImage simulated = side("simulated");
    const RangeImage measured = side("measured");
    expectReference<RangeImageInput>(rangeImageMetrics(), {.simulated = simulated, .measured = measured}, expected);
  }
}

TEST(GridMetrics, OfEqualCertainGridsAreAtTheirBest) {
  const OccupancyGrid cells = grid(2, 3, {0.0, 1.0, 1.0, 0.0, 0.0, 1.0});
  const GridInput input = {.simulated = cells, .measured = cells, .clip = 0.0};
  for (const MetricOf<GridInput>& metric : gridMetrics()) {
    const char best = metric.info.best.front();
    const double expected = best == 'n' ? 6.0 : static_cast<double>(best - '0');  // n: number of cells
    EXPECT_NEAR(metric.compute(input).at(0), expected, 1e-15) << metric.info.name;
  }
}

TEST(GridMetrics, CorrelationsOfAConstantGridAreUndefined) {
  const OccupancyGrid unknown = grid(1, 3, {0.5, 0.5, 0.5});
  const OccupancyGrid known = grid(1, 3, {0.1, 0.5, 0.9});
  EXPECT_TRUE(std::isnan(ofGrids(19, {.simulated = unknown, .measured = known})));
  EXPECT_TRUE(std::isnan(ofGrids(20, {.simulated = known, .measured = unknown})));
}

TEST(GridMetrics, LimitsReachTheirMetrics) {
  const OccupancyGrid simulated = grid(1, 3, {0.6, 0.4, 0.9});
  const OccupancyGrid measured = grid(1, 3, {0.9, 0.1, 0.6});
  const GridInput usual = {.simulated = simulated, .measured = measured};
  const GridInput strict = {
      .simulated = simulated, .measured = measured, .limits = {.occupied_above = 0.8, .free_below = 0.2}};
  EXPECT_EQ(ofGrids(15, usual), 1.0);
  EXPECT_EQ(ofGrids(15, strict), 0.0);
  EXPECT_EQ(ofGrids(16, usual), 0.0);
  EXPECT_EQ(ofGrids(16, strict), 4.0);
  EXPECT_EQ(ofGrids(24, usual), 0.0);
  EXPECT_EQ(ofGrids(24, strict), 1.0);
}

TEST(RangeImageMetrics, WithoutASharedPixelAreUndefinedWhereTheyReadRanges) {
  const RangeImage simulated = {.rows = 1, .columns = 2, .range_m = {3.0, kNone}};
  const RangeImage measured = {.rows = 1, .columns = 2, .range_m = {kNone, 3.0}};
  for (const MetricOf<RangeImageInput>& metric : rangeImageMetrics()) {
    const double value = metric.compute({.simulated = simulated, .measured = measured}).at(0);
    const bool reads_existence_only = metric.info.scale == metrics::Scale::Nominal;
    EXPECT_EQ(std::isnan(value), !reads_existence_only) << metric.info.name;
  }
}

TEST(GridMetrics, AreDescribedAndNamedOnce) {
  const OccupancyGrid cells = grid(1, 2, {0.1, 0.9});
  const RangeImage image = {.rows = 1, .columns = 2, .range_m = {3.0, kNone}};
  expectWholeList<GridInput>(gridMetrics(), {.simulated = cells, .measured = cells});
  expectWholeList<RangeImageInput>(rangeImageMetrics(), {.simulated = image, .measured = image});
}

}  // namespace
