#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "metrics/area/area_metric.h"
#include "metrics/area/area_over_values.h"
#include "metrics/area/white_west_metric.h"

// The vectors of the Credibility Assessment Framework (virtual-vehicle, BSD-2-Clause), level_3/test/uncertainty.test.js
// at 6eea45b: tables of cumulative heights, EDFs and p-boxes on either side. Its expected AVM is d+ + d-; the portions
// were added by an independent computation. White & West's variant is published there as "NASA AVM".
namespace {

struct Side {
  std::vector<double> x;
  std::vector<double> left;   // upper CDF bound
  std::vector<double> right;  // lower CDF bound; empty: a single distribution

  [[nodiscard]] metrics::PBox box() const {
    const auto edge = metrics::Edf::fromSteps(x, left);
    return right.empty() ? metrics::PBox(edge) : metrics::PBox::fromEdges(edge, metrics::Edf::fromSteps(x, right));
  }
};

struct Case {
  std::string name;
  Side sim;
  Side real;
  double d_plus;
  double d_minus;
  double white_west;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {.name = "C1",
       .sim = {.x = {1020}, .left = {1}},
       .real = {.x = {1020}, .left = {1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 0},
      {.name = "C2",
       .sim = {.x = {1000}, .left = {1}},
       .real = {.x = {1010}, .left = {1}},
       .d_plus = 10,
       .d_minus = 0,
       .white_west = 10},
      {.name = "C3",
       .sim = {.x = {-1000}, .left = {1}},
       .real = {.x = {-1010}, .left = {1}},
       .d_plus = 0,
       .d_minus = 10,
       .white_west = 10},
      {.name = "C4",
       .sim = {.x = {1020}, .left = {1}},
       .real = {.x = {1000}, .left = {1}},
       .d_plus = 0,
       .d_minus = 20,
       .white_west = 20},
      {.name = "C5",
       .sim = {.x = {960, 1020}, .left = {0.4, 1}},
       .real = {.x = {960}, .left = {1}},
       .d_plus = 0,
       .d_minus = 36,
       .white_west = 36},
      {.name = "C6",
       .sim = {.x = {960, 1020}, .left = {0.4, 1}},
       .real = {.x = {960, 970, 1020, 1030}, .left = {0.2, 0.4, 0.9, 1}},
       .d_plus = 3,
       .d_minus = 0,
       .white_west = 3},
      {.name = "C7",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0, 0.2, 0.2, 0.4, 0.7, 0.9, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0, 0, 0, 0, 0.3, 0.7, 0.7, 1}},
       .real = {.x = {1020}, .left = {1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 0},
      {.name = "C8",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0, 0.2, 0.2, 0.4, 0.7, 0.9, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0, 0, 0, 0, 0.3, 0.7, 0.7, 1}},
       .real = {.x = {1050}, .left = {1}},
       .d_plus = 17,
       .d_minus = 0,
       .white_west = 17},
      {.name = "C9",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0.2, 0.2, 0.3, 0.5, 0.8, 0.9, 1, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0.1, 0.3, 0.3, 0.5, 0.7, 0.8, 1, 1}},
       .real = {.x = {1000}, .left = {1}},
       .d_plus = 4,
       .d_minus = 1,
       .white_west = 5},
      {.name = "C10",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0.2, 0.2, 0.3, 0.5, 0.8, 0.9, 1, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0.1, 0.3, 0.3, 0.5, 0.7, 0.8, 1, 1}},
       .real = {.x = {960, 990, 1000, 1025, 1030, 1040}, .left = {0.3, 0.4, 0.6, 0.7, 0.9, 1}},
       .d_plus = 0.5,
       .d_minus = 1,
       .white_west = 1.5},
      {.name = "C11",
       .sim = {.x = {950, 970, 980, 990, 1000, 1010}, .left = {0.2, 0.3, 0.5, 0.8, 0.9, 1}},
       .real = {.x = {980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
                .left = {0.2, 0.2, 0.6, 0.8, 1, 1, 1, 1},
                .right = {0, 0.1, 0.1, 0.1, 0.5, 0.5, 0.9, 1}},
       .d_plus = 21,
       .d_minus = 0,
       .white_west = 47},
      {.name = "C12",
       .sim = {.x = {980, 1010, 1030}, .left = {0.15, 0.7, 1}},
       .real = {.x = {980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
                .left = {0.2, 0.2, 0.6, 0.8, 1, 1, 1, 1},
                .right = {0, 0.1, 0.1, 0.1, 0.5, 0.5, 0.9, 1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 26},
      {.name = "C13",
       .sim = {.x = {960, 1010, 1060}, .left = {0.1, 0.9, 1}},
       .real = {.x = {980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
                .left = {0.2, 0.2, 0.6, 0.8, 1, 1, 1, 1},
                .right = {0, 0.1, 0.1, 0.1, 0.5, 0.5, 0.9, 1}},
       .d_plus = 3,
       .d_minus = 1,
       .white_west = 30},
      {.name = "C14",
       .sim = {.x = {950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
               .left = {0.2, 0.2, 0.3, 0.5, 0.5, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0.1, 0.1, 0.1, 0.5, 0.8, 0.8, 1}},
       .real = {.x = {960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
                .left = {0.1, 0.3, 0.3, 0.5, 0.8, 1, 1, 1, 1},
                .right = {0, 0, 0.2, 0.2, 0.2, 0.7, 0.9, 0.9, 1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 0},
      {.name = "C15",
       .sim = {.x = {960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
               .left = {0.1, 0.3, 0.3, 0.5, 0.8, 1, 1, 1, 1},
               .right = {0, 0, 0.2, 0.2, 0.2, 0.7, 0.9, 0.9, 1}},
       .real = {.x = {950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
                .left = {0.2, 0.2, 0.3, 0.5, 0.5, 0.9, 1, 1, 1, 1},
                .right = {0, 0, 0, 0.1, 0.1, 0.1, 0.5, 0.8, 0.8, 1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 13},
      {.name = "C16",
       .sim = {.x = {950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
               .left = {0.2, 0.2, 0.3, 0.5, 0.5, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0.1, 0.1, 0.1, 0.5, 0.8, 0.8, 1}},
       .real = {.x = {960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
                .left = {0.1, 0.3, 0.3, 0.8, 0.8, 1, 1, 1, 1},
                .right = {0, 0, 0.2, 0.2, 0.2, 0.7, 0.9, 0.9, 1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 3},
      {.name = "C17",
       .sim = {.x = {950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
               .left = {0.2, 0.2, 0.3, 0.5, 0.5, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0.1, 0.1, 0.1, 0.5, 0.8, 0.8, 1}},
       .real = {.x = {960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
                .left = {0.1, 0.3, 0.3, 0.8, 0.8, 1, 1, 1, 1},
                .right = {0, 0, 0.2, 0.2, 0.7, 0.7, 0.9, 0.9, 1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 3},
      {.name = "C18",
       .sim = {.x = {950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
               .left = {0.2, 0.2, 0.3, 0.5, 0.5, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0.1, 0.1, 0.1, 0.5, 0.8, 0.8, 1}},
       .real = {.x = {960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
                .left = {0.1, 0.3, 0.3, 0.8, 0.8, 1, 1, 1, 1},
                .right = {0, 0, 0.2, 0.2, 0.2, 0.2, 0.2, 0.9, 1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 12},
      {.name = "C19",
       .sim = {.x = {950, 970, 980, 1010, 1020, 1030, 1040},
               .left = {0.2, 0.3, 0.5, 1, 1, 1, 1},
               .right = {0, 0, 0.1, 0.5, 0.8, 0.8, 1}},
       .real = {.x = {960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040},
                .left = {0.1, 0.3, 0.3, 0.8, 0.8, 1, 1, 1, 1},
                .right = {0, 0, 0.2, 0.2, 0.7, 0.7, 0.9, 0.9, 1}},
       .d_plus = 0,
       .d_minus = 2,
       .white_west = 6},
      {.name = "C20",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020},
               .left = {0.2, 0.3, 0.5, 0.5, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0.1, 0.3, 0.3, 0.5, 0.8, 0.8, 1}},
       .real = {.x = {980, 990, 1000, 1010, 1020, 1030, 1040},
                .left = {0.2, 0.4, 0.8, 0.8, 0.8, 1, 1},
                .right = {0, 0, 0.3, 0.7, 0.7, 0.7, 1}},
       .d_plus = 8,
       .d_minus = 0,
       .white_west = 24},
      {.name = "C21",
       .sim = {.x = {48, 50, 52, 54, 56, 58, 60, 62},
               .left = {0, 0.2, 0.4, 0.6, 0.9, 1, 1, 1},
               .right = {0, 0.1, 0.2, 0.5, 0.8, 0.8, 1, 1}},
       .real = {.x = {50, 51, 52, 53, 54, 56, 62}, .left = {0, 0, 0.4, 0.6, 0.8, 1, 1}},
       .d_plus = 0.2,
       .d_minus = 0.8,
       .white_west = 1},
      {.name = "C22",
       .sim = {.x = {48, 50, 52, 54, 56, 58, 60, 62},
               .left = {0, 0.2, 0.4, 0.6, 0.9, 1, 1, 1},
               .right = {0, 0.1, 0.2, 0.5, 0.8, 0.8, 1, 1}},
       .real = {.x = {50, 51, 52, 53, 54, 56, 62}, .left = {0.1, 0.2, 0.4, 0.6, 0.8, 1, 1}},
       .d_plus = 0,
       .d_minus = 0.8,
       .white_west = 0.8},
      {.name = "C23",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0, 0.2, 0.2, 0.4, 0.7, 0.9, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0, 0, 0, 0, 0.3, 0.7, 0.7, 1}},
       .real = {.x = {980}, .left = {1}},
       .d_plus = 0,
       .d_minus = 11,
       .white_west = 11},
      {.name = "C24",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0, 0.2, 0.2, 0.4, 0.7, 0.9, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0, 0, 0, 0, 0.3, 0.7, 0.7, 1}},
       .real = {.x = {1020}, .left = {1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 0},
      {.name = "C25",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0, 0.2, 0.2, 0.4, 0.7, 0.9, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0, 0, 0, 0, 0.3, 0.7, 0.7, 1}},
       .real = {.x = {1050}, .left = {1}},
       .d_plus = 17,
       .d_minus = 0,
       .white_west = 17},
      {.name = "C26",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0, 0.2, 0.2, 0.4, 0.7, 0.9, 0.9, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0, 0, 0, 0, 0.3, 0.7, 0.7, 1}},
       .real = {.x = {950}, .left = {1}},
       .d_plus = 0,
       .d_minus = 37,
       .white_west = 37},
      {.name = "C27",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0.2, 0.2, 0.3, 0.5, 0.8, 0.9, 1, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0.1, 0.3, 0.3, 0.5, 0.7, 0.8, 1, 1}},
       .real = {.x = {1000}, .left = {1}},
       .d_plus = 4,
       .d_minus = 1,
       .white_west = 5},
      {.name = "C28",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0.2, 0.2, 0.3, 0.5, 0.8, 0.9, 1, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0.1, 0.3, 0.3, 0.5, 0.7, 0.8, 1, 1}},
       .real = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
                .left = {0, 0.2, 0.2, 0.3, 0.5, 1, 1, 1, 1, 1, 1, 1},
                .right = {0, 0, 0, 0, 0.1, 0.3, 0.3, 0.5, 0.8, 0.8, 1, 1}},
       .d_plus = 0,
       .d_minus = 0,
       .white_west = 3},
      {.name = "C29",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0.2, 0.2, 0.3, 0.5, 0.8, 0.9, 1, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0.1, 0.3, 0.3, 0.5, 0.7, 0.8, 1, 1}},
       .real = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
                .left = {0, 0.6, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
                .right = {0, 0, 0.4, 0.5, 1, 1, 1, 1, 1, 1, 1, 1}},
       .d_plus = 0,
       .d_minus = 12,
       .white_west = 27},
      {.name = "C30",
       .sim = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
               .left = {0, 0.2, 0.2, 0.3, 0.5, 0.8, 0.9, 1, 1, 1, 1, 1},
               .right = {0, 0, 0, 0, 0.1, 0.3, 0.3, 0.5, 0.7, 0.8, 1, 1}},
       .real = {.x = {940, 950, 960, 970, 980, 990, 1000, 1010, 1020, 1030, 1040, 1050},
                .left = {0, 0, 0, 0, 0, 0, 0, 0.3, 1, 1, 1, 1},
                .right = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1}},
       .d_plus = 9,
       .d_minus = 0,
       .white_west = 19},
  };
  return all;
}

class CredibilityFramework : public testing::TestWithParam<Case> {};

// Areas of some 10 from heights given with one decimal: rounding stays below 1e-12.
TEST_P(CredibilityFramework, PublishedAreaIsReproduced) {
  const metrics::PBox sim = GetParam().sim.box();
  const metrics::PBox real = GetParam().real.box();
  const metrics::AreaPortions portions = metrics::areaPortions({.simulated = sim, .measured = real});
  EXPECT_NEAR(portions.d_plus, GetParam().d_plus, 1e-12);
  EXPECT_NEAR(portions.d_minus, GetParam().d_minus, 1e-12);
  EXPECT_NEAR(metrics::areaValidationMetric({.simulated = sim, .measured = real}),
              GetParam().d_plus + GetParam().d_minus, 1e-12);
}

TEST_P(CredibilityFramework, PublishedAreaIsReproducedAlongTheValues) {
  const metrics::PBox sim = GetParam().sim.box();
  const metrics::PBox real = GetParam().real.box();
  const metrics::AreaPortions portions = metrics::areaPortionsOverValues({.simulated = sim, .measured = real});
  EXPECT_NEAR(portions.d_plus, GetParam().d_plus, 1e-12);
  EXPECT_NEAR(portions.d_minus, GetParam().d_minus, 1e-12);
}

TEST_P(CredibilityFramework, PublishedVariantOfWhiteAndWestIsReproduced) {
  const metrics::PBox sim = GetParam().sim.box();
  const metrics::PBox real = GetParam().real.box();
  EXPECT_NEAR(metrics::whiteWestPortions({.simulated = sim, .measured = real}).area(), GetParam().white_west, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Vectors, CredibilityFramework, testing::ValuesIn(cases()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
