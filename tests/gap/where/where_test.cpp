#include "gap/where/where.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/random.h"
#include "gap/report/wording.h"
#include "gap/where/pictures.h"
#include "tests/gap/small_world.h"

namespace {

/// Where a model without some effects differs from what one with them measured: before and after they are named.
struct OnceNamed {
  std::vector<gap::WhereRow> before, after;
};
OnceNamed rowsOnceNamed(const test_support::SmallWorld::Effects& effects, double true_reflectivity) {
  const test_support::SmallWorld world;
  const auto truth = test_support::SmallWorld::modelWith(effects);
  const auto measured = world.measuredBy(truth, true_reflectivity);
  const gap::Replay replay(measured, test_support::SmallWorld::modelWith({}));
  const gap::WhereResult without = gap::whereIn(replay, replay.baseline(), 1);
  const gap::WhereResult with = gap::whereIn(replay, {truth, {}, {}}, 1);
  return {without.rows, gap::rowsOfCause(replay, without, with)};
}

TEST(Where, TellsMissingEchoesPerShot) {
  constexpr double kLoss = 0.3;
  const test_support::SmallWorld world;
  const auto truth = test_support::SmallWorld::modelWith({{"detection-loss", {{"probability", kLoss}}}});
  const auto measured = world.measuredBy(truth, 0.4);
  const gap::Replay replay(measured, test_support::SmallWorld::modelWith({}));
  const gap::WhereResult where = gap::whereIn(replay, replay.baseline(), 1);
  std::size_t strata = 0, maps = 0;
  for (const gap::WhereRow& row : where.rows) {
    if (row.component != "missing") continue;
    EXPECT_NEAR(row.value, -kLoss, 0.06) << gap::whereSentence(row);
    ++strata;
  }
  for (const gap::ResidualMap& map : gap::residualMaps(replay, where.tables)) {
    if (map.component != "missing") continue;
    double sum = 0.0;
    for (const gap::ResidualMap::Point& point : map.points) sum += point.value;
    EXPECT_NEAR(sum / static_cast<double>(map.points.size()), -kLoss, 0.06) << map.sample;
    ++maps;
  }
  EXPECT_GT(strata, 3U);
  EXPECT_GT(maps, 0U);
}

TEST(Where, TablesOffEdgesHoldAllBeamsButThoseThatAnEdgeCuts) {
  test_support::SmallWorld world;
  world.withAWallOf(2.0);
  const auto model = test_support::SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  const auto tables = gap::whereIn(replay, replay.baseline(), 1).tables;
  const auto off_edges = gap::offEdges(replay, tables);
  const auto cut = [&](const gap::ResidualTable::Row& row) {
    return replay.samples()[row.sample].layout->cells()[row.cell].at_edge;
  };
  ASSERT_EQ(off_edges.size(), tables.size());
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const auto at_edges = std::count_if(tables[t].rows.begin(), tables[t].rows.end(), cut);
    EXPECT_GT(at_edges, 0) << tables[t].measurand << " " << tables[t].component;
    EXPECT_TRUE(std::none_of(off_edges[t].rows.begin(), off_edges[t].rows.end(), cut));
    EXPECT_EQ(std::ssize(off_edges[t].rows), std::ssize(tables[t].rows) - at_edges);
  }
}

// Echo pulse widths scatter by 0.8 m in place of 0.05 m, about the same means. Beams whose width came out
// high by chance are no stratum in which the model is wrong.
TEST(Where, AValueThatCameOutHighIsNoPlaceWhereTheModelIsTooLow) {
  const test_support::SmallWorld world;
  const auto truth = test_support::SmallWorld::modelWith({}, {{"/sensor/detection/epw_noise_m", 0.8}});
  const auto measured = world.measuredBy(truth, 0.4);
  const gap::Replay replay(measured, test_support::SmallWorld::modelWith({}));
  const gap::WhereResult where = gap::whereIn(replay, replay.baseline(), 1);
  bool scatters = false;
  for (const gap::WhereRow& row : where.rows) {
    scatters = scatters || (row.measurand == "epw" && row.component == "scatter");
    if (row.component != "bias") continue;
    EXPECT_GT(row.p_value, 1e-3) << gap::whereSentence(row);
  }
  EXPECT_TRUE(scatters);
}

// A wall that stands 0.2 m farther than recorded in two set-ups, and 0.15 m nearer in another: together they are no
// place at which a range is 0.08 m too short.
TEST(Where, SetUpsThatDeviateInOppositeWaysAreNoOnePlace) {
  const test_support::SmallWorld world;
  const auto model = test_support::SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4, {{"r13", 0.2}, {"r27", 0.2}, {"r46", -0.15}});
  const gap::Replay replay(measured, model);
  const gap::WhereResult where = gap::whereIn(replay, replay.baseline(), 1);
  const auto row = std::find_if(where.rows.begin(), where.rows.end(), [](const gap::WhereRow& one) {
    return one.measurand == "range" && one.component == "bias" && one.covariate == "setup";
  });
  ASSERT_NE(row, where.rows.end());
  EXPECT_EQ(row->names, (std::vector<std::string>{"r13", "r27"}));
  EXPECT_NEAR(row->value, 0.2, 0.01);
}

// The wall is half as bright again as recorded, which is most of the gap; the offset that the verdict names moves
// ranges. Where it acts is said first, what it leaves after that.
TEST(Where, ShowsFirstWhatTheNamedCauseChanges) {
  const auto [before, rows] = rowsOnceNamed({{"range-offset", {{"offset_m", 0.05}}}}, 0.6);
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(before.front().measurand, "intensity");
  ASSERT_EQ(rows.size(), before.size());
  EXPECT_EQ(rows.front().measurand, "range");
  EXPECT_NEAR(rows.front().value, 0.05, 0.005);
}

// The wall is a quarter brighter than recorded, most of all where it is met head-on; dirt takes a few per cent from the
// beams between -8° and 3°. What the dirt changes has no noise and nothing else in it, so it says where the dirt is.
TEST(Where, AStratumEndsWhereTheNamedCauseDoes) {
  const auto rows =
      rowsOnceNamed(
          {{"cover-contamination", {{"attenuation", 0.02}, {"azimuth_from_deg", -8.0}, {"azimuth_to_deg", 3.0}}}}, 0.5)
          .after;
  const auto sector = std::find_if(rows.begin(), rows.end(), [](const gap::WhereRow& row) {
    return row.measurand == "intensity" && row.component == "bias" && row.covariate == "azimuth_deg";
  });
  ASSERT_NE(sector, rows.end());
  EXPECT_NEAR(sector->low, -8.0, 1.0);
  EXPECT_NEAR(sector->high, 3.0, 1.0);
}

/// The first row once a cause is named that makes every intensity a step larger, and does something else to the first
/// surface.
template <class Change>
gap::WhereRow firstRowBeside(Change change) {
  const test_support::SmallWorld world;
  const auto model = test_support::SmallWorld::modelWith({});
  const auto truth = test_support::SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.05}}}});
  const auto measured = world.measuredBy(truth, 0.6);
  const gap::Replay replay(measured, model);
  const gap::WhereResult without = gap::whereIn(replay, replay.baseline(), 1);
  gap::WhereResult with = without;
  for (gap::CellsOfSamples* simulated : {&with.expected, &with.once_more}) {
    for (auto& cells : *simulated) {
      for (gap::CellStatistics& cell : cells) cell.moveMean(gap::kIntensity, replay.resolution(gap::kIntensity));
    }
    change(simulated->front().front());
  }
  const std::vector<gap::WhereRow> rows = gap::rowsOfCause(replay, without, with);
  return rows.empty() ? gap::WhereRow{} : rows.front();
}

// Where a pane and a board behind it are one echo or two by a hair, ranges of one beam may scatter without bounds (by a
// kilometre here). It is the intensity that the cause acts on.
TEST(Where, AStepInEveryBeamComesBeforeAScatterOfMetresInOne) {
  const gap::WhereRow first = firstRowBeside([](gap::CellStatistics& merging) {
    ASSERT_GE(merging.count, 5.0);
    merging.sum_of_squares[gap::kRange] += merging.count * 1e6;
  });
  EXPECT_EQ(first.measurand, "intensity");
}

// Air that sends light back makes the noise of a beam another one, not a larger one: widths scatter otherwise here and
// there, and under other noise in other places. All intensities are a little larger.
TEST(Where, NoiseThatACauseMakesAnotherOneIsNoChangeOfIt) {
  const test_support::SmallWorld world;
  const auto model = test_support::SmallWorld::modelWith({});
  const auto measured =
      world.measuredBy(test_support::SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.05}}}}), 0.6);
  const gap::Replay replay(measured, model);
  const gap::WhereResult without = gap::whereIn(replay, replay.baseline(), 1);
  gap::WhereResult with = without;
  core::Random random({.seed = 3});
  for (gap::CellsOfSamples* simulated : {&with.expected, &with.once_more}) {
    for (auto& cells : *simulated) {
      for (gap::CellStatistics& cell : cells) {
        const double mean = cell.count > 0.0 ? cell.mean(gap::kEpw) : 0.0, centre = cell.count * mean * mean;
        const double spread = 0.2 + 1.6 * random.uniform();
        cell.sum_of_squares[gap::kEpw] += (cell.sum_of_squares[gap::kEpw] - centre) * (spread * spread - 1.0);
        cell.moveMean(gap::kIntensity, 0.3 * replay.resolution(gap::kIntensity));
      }
    }
  }
  const std::vector<gap::WhereRow> rows = gap::rowsOfCause(replay, without, with);
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front().measurand, "intensity") << gap::whereSentence(rows.front());
  EXPECT_EQ(rows.front().component, "bias") << gap::whereSentence(rows.front());
}

// A false target takes the place of one beam's echo, a kilometre away from it: no noise, but one beam.
TEST(Where, AStepInEveryBeamComesBeforeAMoveOfMetresInOne) {
  const gap::WhereRow first = firstRowBeside([](gap::CellStatistics& moved) {
    ASSERT_GE(moved.count, 5.0);
    moved.moveMean(gap::kRange, 1000.0);
  });
  EXPECT_EQ(first.measurand, "intensity");
}

// One false echo in five hundred shots: no cell has more than noise may give it, all of them together have.
TEST(Where, EchoesTooRareForAnyCellAreShownOnceTheirCauseIsNamed) {
  const auto rows = rowsOnceNamed({{"false-alarm", {{"rate_per_beam", 0.002}}}}, 0.4).after;
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front().measurand, "existence");
  EXPECT_EQ(rows.front().component, "extra");
}

TEST(Where, MissingEchoesAreNeverExtra) {
  const auto rows = rowsOnceNamed({{"false-alarm", {{"rate_per_beam", 0.03}}}}, 0.4).after;
  for (const gap::WhereRow& row : rows) {
    if (row.component == "extra") {
      EXPECT_GE(row.value, 0.0) << gap::whereSentence(row);
    }
    if (row.component == "missing") {
      EXPECT_LE(row.value, 0.0) << gap::whereSentence(row);
    }
  }
}

// Beams are 1° apart from -20° to 20°, so a sixteenth of the data spans two or three of them.
TEST(Where, AStratumOfFewBeamsEndsWhereItsGapDoes) {
  const auto rows =
      rowsOnceNamed({{"spoofing", {{"azimuth_deg", 5.0}, {"width_deg", 1.0}, {"range_m", 4.0}}}}, 0.4).before;
  const auto sector = std::find_if(rows.begin(), rows.end(), [](const gap::WhereRow& row) {
    return row.component == "extra" && row.covariate == "azimuth_deg";
  });
  ASSERT_NE(sector, rows.end());
  EXPECT_NEAR(sector->low, 5.0, 1e-6);
  EXPECT_NEAR(sector->high, 5.0, 1e-6);
  EXPECT_NEAR(sector->share, 1.0, 1e-9);
}

TEST(Wording, StratumSentenceSaysWhatIsLargerAndWhere) {
  gap::WhereRow row{.measurand = "epw",
                    .component = "bias",
                    .covariate = "range_m",
                    .low = 28.1,
                    .high = 69.0,
                    .value = -0.27,
                    .unit = "m",
                    .share = 0.62,
                    .size = 0.4};
  EXPECT_EQ(
      gap::whereSentence(row),
      "The simulated echo pulse width is 0.27 m too large at ranges from 28.1 to 69 m: 62 % of this gap, in 40 % of "
      "the data.");
}

TEST(Wording, OneEchoIsNotSeveral) {
  gap::WhereRow row{.measurand = "existence",
                    .component = "missing",
                    .covariate = "range_m",
                    .low = 30.0,
                    .high = 60.0,
                    .value = -1.0,
                    .unit = "1/shot"};
  EXPECT_NE(gap::whereSentence(row).find("lacks 1 echo per shot"), std::string::npos);
  row.value = -0.5;
  EXPECT_NE(gap::whereSentence(row).find("lacks 0.5 echoes per shot"), std::string::npos);
}

}  // namespace
