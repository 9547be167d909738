#include "gap/unexplained/rest.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "core/random.h"
#include "gap/report/rest_wording.h"
#include "tests/gap/measured_wall.h"

namespace {

using test_support::SmallWorld;

/// A replay of a small world, and residuals of the echo pulse width that a test makes up for its cells.
class MadeUpResiduals : public ::testing::Test {
 protected:
  static constexpr double kError_m = 0.01;

  template <typename Residual>
  gap::WhereResult residuals(const Residual& residual_m) const {
    gap::WhereResult where;
    gap::ResidualTable table{"epw", "bias", "m", 0.04, {}};
    for (std::size_t s = 0; s < replay_.samples().size(); ++s) {
      const gap::ReplaySample& sample = replay_.samples()[s];
      where.expected.push_back(sample.statistics);
      for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
        core::Random random({.sample = static_cast<std::uint32_t>(s), .beam = static_cast<std::uint32_t>(c)});
        table.rows.push_back(
            {s, c, residual_m(sample.layout->cells()[c]) + kError_m * random.normal(), kError_m, 20.0});
      }
    }
    where.tables.push_back(std::move(table));
    return where;
  }
  /// One law, proportional to the covariate but for a constant.
  static void expectLine(const gap::Rest& rest, const std::string& covariate, double slope, double tolerance) {
    EXPECT_GT(rest.systematic, 0.95);
    ASSERT_EQ(rest.laws.size(), 1U);
    const gap::Law& law = rest.laws.front();
    ASSERT_EQ(law.terms.size(), 1U);
    EXPECT_EQ(law.terms.front().covariate, covariate);
    EXPECT_EQ(law.terms.front().function, "x");
    EXPECT_NEAR(law.terms.front().coefficient, slope, tolerance);
  }
  [[nodiscard]] gap::Rest rest(const gap::WhereResult& before, const gap::WhereResult& after) const {
    return gap::restOf(replay_, gap::splitOf(replay_, 1), before, after).value();
  }

  SmallWorld world_;
  model::LidarModel model_ = SmallWorld::modelWith({});
  model::Experiment experiment_ = world_.measuredBy(model_, 0.4);
  gap::Replay replay_{experiment_, model_, {.most_beams = 1000}};
};

TEST_F(MadeUpResiduals, ALawOfTheDistanceIsFoundWithItsNumbersAndAFormula) {
  const auto where = residuals([](const gap::Cell& cell) { return 0.2 + 0.01 * cell.anchor_m; });
  const gap::Rest rest = this->rest(where, where);
  EXPECT_DOUBLE_EQ(rest.left, 1.0);
  ASSERT_NO_FATAL_FAILURE(expectLine(rest, "range_m", 0.01, 3e-4));
  EXPECT_NEAR(rest.laws.front().constant, 0.2, 0.01);
  EXPECT_GT(rest.laws.front().explained, 0.95);
}

// A counter that compresses wide pulses is a law of the echo pulse width itself.
TEST_F(MadeUpResiduals, ALawOfTheValueThatIsExpectedIsFound) {
  auto where = residuals([](const gap::Cell&) { return 0.0; });
  auto& rows = where.tables.front().rows;
  const auto width_m = [&](const auto& row) { return where.expected[row.sample][row.cell].mean(gap::kEpw); };
  double usual_m = 0.0;
  for (const auto& row : rows) usual_m += width_m(row) / static_cast<double>(rows.size());
  for (auto& row : rows) row.value -= 0.2 * (width_m(row) - usual_m);
  expectLine(rest(where, where), "epw_m", -0.2, 0.02);
}

// A counter that is interpolated unevenly errs alike in every period of its clock, and no smooth function follows that.
TEST_F(MadeUpResiduals, AWaveOverTheDistanceIsFoundWithItsPeriodAndWhereItIsZero) {
  const auto where = residuals([](const gap::Cell& cell) {
    return 0.1 + 0.05 * std::sin(2.0 * std::numbers::pi * (cell.anchor_m - 0.3) / 1.7);
  });
  const gap::Rest rest = this->rest(where, where);
  EXPECT_GT(rest.systematic, 0.9);
  ASSERT_EQ(rest.laws.size(), 1U);
  ASSERT_EQ(rest.laws.front().terms.size(), 1U);
  const gap::Law::Term& wave = rest.laws.front().terms.front();
  EXPECT_EQ(wave.covariate, "range_m");
  EXPECT_EQ(wave.function, "sin x");
  EXPECT_NEAR(wave.coefficient, 0.05, 0.003);
  EXPECT_NEAR(wave.period, 1.7, 0.01);
  EXPECT_NEAR(wave.zero, 0.3, 0.1);
}

TEST_F(MadeUpResiduals, WhatIsRandomFromCellToCellHasNoLaw) {
  const auto where = residuals([](const gap::Cell& cell) {
    core::Random random({.beam = cell.beam, .purpose = static_cast<std::uint32_t>(cell.anchor_m)});
    return 0.2 * random.normal();
  });
  const gap::Rest rest = this->rest(where, where);
  EXPECT_TRUE(rest.laws.empty());
  EXPECT_LT(rest.systematic, 0.15);
  EXPECT_LT(rest.ceiling(), 0.15);
}

TEST_F(MadeUpResiduals, AWorldThatTakesHalfOfTheResidualAwayLeavesAQuarterOfItsSquares) {
  const auto residual = [](const gap::Cell& cell) { return 0.002 * cell.anchor_m; };
  const gap::Rest rest =
      this->rest(residuals(residual), residuals([&](const gap::Cell& cell) { return 0.5 * residual(cell); }));
  EXPECT_NEAR(rest.left, 0.25, 0.05);
  EXPECT_GT(rest.ceiling(), 0.95);
}

TEST_F(MadeUpResiduals, NothingIsSaidOfAHandfulOfCells) {
  gap::WhereResult few = residuals([](const gap::Cell&) { return 0.2; });
  few.tables.front().rows.resize(20);
  EXPECT_FALSE(gap::restOf(replay_, gap::splitOf(replay_, 1), few, few).has_value());
}

TEST(Wording, AFormulaNamesItsCovariates) {
  gap::Law law;
  law.constant = 0.21;
  law.terms = {{"incidence_deg", "tan² x", 0.34}, {"range_m", "1/x", -2.0}, {"temperature_c", "x", 0.5}};
  EXPECT_EQ(gap::formulaOf(law), "0.21 + 0.34·tan²(incidence_deg) − 2/range_m + 0.5·temperature_c");
}

TEST(Wording, AWaveIsAFormulaAndASentence) {
  gap::Law law{.measurand = "range", .component = "bias", .unit = "m", .constant = 0.001};
  law.terms = {{"range_m", "sin x", 0.03, 0.9, 0.2}};
  law.explained = 0.95;
  EXPECT_EQ(gap::formulaOf(law), "0.001 + 0.03·sin(2π·(range_m − 0.2)/0.9)");
  EXPECT_EQ(gap::patternText(law),
            "The mean of the range, measured minus simulated, goes up and down by ± 0.03 m and repeats every 0.9 m of "
            "distance: 95 % of what is left there.");
}

TEST(Wording, PartsOfTheReceivedPowerAreSaidInPerCent) {
  const gap::Law law{.measurand = "intensity",
                     .component = "bias",
                     .constant = 0.002,
                     .terms = {{"azimuth_deg", "x", -0.0011}},
                     .explained = 0.95,
                     .relative = true};
  EXPECT_EQ(gap::patternText(law),
            "The mean of the intensity, measured minus simulated, follows (0.2 − 0.11·azimuth_deg) % of the received "
            "power: 95 % of what is left there.");
}

class LawLeft : public test_support::MeasuredWall {
 protected:
  /// By an offset of 2 cm, which is said to explain so much, of the cells and of the total gap.
  [[nodiscard]] bool leavesOne(double explained) const {
    gap::Candidate offset = with("range-offset", {0.02});
    offset.explained = explained;
    offset.total_left = 1.0 - explained;
    const gap::WhereResult before = gap::whereIn(*replay_, replay_->baseline(), split_.fitted.seed);
    return gap::leavesAPlainLaw(judge(), before, offset);
  }
};

// A clock that is too fast by 0.04 % makes 3 mm at 8 m and 18 mm at 46 m.
TEST_F(LawLeft, ByOneOfTwoCausesIsWhatTheOtherDoes) {
  measure({{"range-offset", {{"offset_m", 0.02}}}, {"clock-drift", {{"scale_ppm", 400}}}});
  EXPECT_TRUE(leavesOne(0.9));
  EXPECT_FALSE(leavesOne(0.97)) << "so little is no second cause";
}

TEST_F(LawLeft, ByTheOnlyCauseIsNone) {
  measure({{"range-offset", {{"offset_m", 0.02}}}});
  EXPECT_FALSE(leavesOne(0.9));
}

}  // namespace
