#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "metrics/area/area_metric.h"
#include "metrics/area/double_metric.h"
#include "metrics/area/largest_area_metric.h"
#include "metrics/samples/anderson_darling.h"
#include "metrics/samples/divergences.h"
#include "metrics/samples/kolmogorov_smirnov.h"
#include "metrics/samples/moment_differences.h"
#include "metrics/samples/positive_ks_tests.h"
#include "tests/metrics/random_cases.h"
#include "tests/support/paths.h"

// Rosenberger 2022, ch. 8, compares metrics on one draw of n = 100 from each distribution of a manufactured universe.
// That draw is not published, so its tables cannot be recomputed digit by digit. What can be checked is whether the
// published figure is a likely draw of ours, and whether our sampling distribution is the one that an independent
// program (numpy, scipy) finds. What follows from it is in docs/metrics-chapter8.md.

namespace {

using metrics::Edf;
using metrics::PBox;
using metrics::SamplePair;

constexpr std::size_t kDraws = 2000;
constexpr std::size_t kSimulations = 7;
constexpr std::size_t kSample = 100;
constexpr double kBoxHalfWidth_m = 0.10;

/// One draw of Tab. 8-2, in m: real N(22, 0.2), sim1 N(22.55, 0.4), sim2 N(22.55, 0.2), sim3 N(21.91, 0.1),
/// sim4 N(22, 0.6), sim5 = sim4 - 0.50, sim6 = sim2 - 0.64 (means 22.55 -> 21.91; the text says -0.65), sim7 as real.
struct Universe {
  Edf real;
  std::vector<Edf> simulated;
};

Universe draw(std::uint32_t repetition) {
  std::uint32_t stream = 0;
  const auto normal = [&](double mean, double deviation) {
    core::Random random({.seed = 8, .sample = repetition, .frame = stream++, .purpose = core::purposeOf("chapter 8")});
    std::vector<double> values(kSample);
    for (double& x : values) x = mean + deviation * random.normal();
    return Edf(values);
  };
  Universe universe{.real = normal(22.0, 0.2), .simulated = {}};
  const Edf sim1 = normal(22.55, 0.4);
  const Edf sim2 = normal(22.55, 0.2);
  const Edf sim3 = normal(21.91, 0.1);
  const Edf sim4 = normal(22.0, 0.6);
  const Edf sim7 = normal(22.0, 0.2);
  universe.simulated = {sim1, sim2, sim3, sim4, sim4.shifted(-0.50), sim2.shifted(-0.64), sim7};
  return universe;
}

using Figures = std::map<std::string, double>;

/// In bins of 0.10 m that hold both samples.
double histogramSymmetrised(const SamplePair& pair) {
  constexpr double kBin_m = 0.10;
  const double last = std::max(pair.simulated.max(), pair.measured.max());
  std::vector<double> edges = {kBin_m * std::floor(std::min(pair.simulated.min(), pair.measured.min()) / kBin_m)};
  while (edges.back() <= last) edges.push_back(edges.back() + kBin_m);
  return metrics::histogramDivergences(pair, edges).symmetrised;
}

void addSampleFigures(const SamplePair& pair, Figures& figures) {
  figures["abs_mean_difference"] = std::abs(metrics::meanDifference(pair));
  figures["abs_median_difference"] = std::abs(metrics::medianDifference(pair));
  figures["abs_std_difference"] = std::abs(metrics::standardDeviationDifference(pair));
  const metrics::KolmogorovSmirnov ks = metrics::kolmogorovSmirnovTest(pair);
  figures["ks"] = ks.statistic;
  figures["ks_p"] = ks.p_value;
  figures["ks_positive"] = metrics::positiveKsTests(std::array{pair}).frequency;
  const metrics::AndersonDarlingToNormal ad = metrics::andersonDarlingToFittedNormal(pair);
  figures["ad_as_published"] = ad.as_published;
  figures["ad_log_tails"] = ad.statistic;
  figures["ad_two_sample"] = metrics::andersonDarlingTest(pair).statistic;
  const metrics::Divergences kde = metrics::kdeDivergences(pair);
  figures["kl"] = kde.kl;
  figures["kl_reverse"] = kde.kl_reverse;
  figures["kl_symmetrised"] = kde.symmetrised;
  figures["js_divergence"] = kde.js;
  figures["histogram_symmetrised"] = histogramSymmetrised(pair);
}

void addBoxFigures(const SamplePair& pair, Figures& figures) {
  const PBox real = pair.measured;
  figures["avm"] = metrics::areaValidationMetric({.simulated = pair.simulated, .measured = real});
  const PBox box = metrics_test::widened(pair.simulated, kBoxHalfWidth_m);
  figures["box_avm"] = metrics::areaValidationMetric({.simulated = box, .measured = real});
  const metrics::DoubleMetric edges = metrics::doubleMetric({.simulated = box, .measured = real});
  figures["double_left"] = edges.left;
  figures["double_right"] = edges.right;
  figures["double_larger"] = std::max(edges.left, edges.right);
  figures["box_avm_max"] = metrics::largestAreaMetric({.simulated = box, .measured = real}).area;
}

/// kDraws results of each figure of each simulation, ascending: results["avm sim4"].
using Results = std::map<std::string, std::vector<double>>;

Results drawAll() {
  std::vector<std::array<Figures, kSimulations>> draws(kDraws);
  core::parallelFor(kDraws, 10, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Universe universe = draw(static_cast<std::uint32_t>(k));
      for (std::size_t s = 0; s < kSimulations; ++s) {
        const SamplePair pair{.simulated = universe.simulated[s], .measured = universe.real};
        addSampleFigures(pair, draws[k][s]);
        addBoxFigures(pair, draws[k][s]);
      }
    }
  });
  Results results;
  for (const auto& simulations : draws) {
    for (std::size_t s = 0; s < kSimulations; ++s) {
      for (const auto& [name, value] : simulations[s]) {
        results[name + " sim" + std::to_string(s + 1)].push_back(value);
      }
    }
  }
  for (auto& [name, values] : results) std::sort(values.begin(), values.end());
  return results;
}

const std::vector<double>& drawsOf(const std::string& cell) {
  static const Results results = drawAll();
  return results.at(cell);
}

/// Sample quantile of ascending draws.
double at(const std::vector<double>& draws, double p) {
  const double rank = std::clamp(p, 0.0, 1.0) * static_cast<double>(draws.size() - 1);
  return draws[static_cast<std::size_t>(std::llround(rank))];
}

struct Cell {
  std::string table;
  std::string figure_and_simulation;
  double draws;  ///< of the independent program
  double low, high;
  double share_infinite;
  bool is_published;
  double published;
  double half_digit;
};

double number(const std::string& text) {
  return text == "inf" ? std::numeric_limits<double>::infinity() : std::stod(text);
}

std::vector<Cell> readCells() {
  std::ifstream file(test_support::testData("metrics/samples/chapter8.txt"));
  std::vector<Cell> cells;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string table, figure, simulation, draws, low, high, infinite, published, half;
    words >> table >> figure >> simulation >> draws >> low >> high >> infinite >> published >> half;
    const bool is_published = published != "-";
    cells.push_back({.table = table,
                     .figure_and_simulation = figure + " " + simulation,
                     .draws = number(draws),
                     .low = number(low),
                     .high = number(high),
                     .share_infinite = number(infinite),
                     .is_published = is_published,
                     .published = is_published ? number(published) : 0.0,
                     .half_digit = is_published ? number(half) : 0.0});
  }
  return cells;
}

bool covers(const std::vector<double>& draws, double published, double half_digit) {
  return published + half_digit >= at(draws, 0.025) && published - half_digit <= at(draws, 0.975);
}

// --gtest_output=json:FILE writes our intervals (docs/metrics-chapter8.md).
// A 2.5 % point of R draws lies between the points p -+ sqrt(p (1 - p) / R) of the distribution. The difference of two
// such points is therefore judged in ranks of our draws, 4 standard errors to either side (252 comparisons), without
// assuming any density; then come the four printed digits.
TEST(Chapter8, SamplingIntervalsAgreeWithTheIndependentOnes) {
  const std::vector<Cell> cells = readCells();
  ASSERT_EQ(cells.size(), 18 * kSimulations);
  for (const Cell& cell : cells) {
    const std::vector<double>& draws = drawsOf(cell.figure_and_simulation);
    RecordProperty(cell.figure_and_simulation, fmt::format("{:.2g} .. {:.2g}", at(draws, 0.025), at(draws, 0.975)));
    const double error = 4.0 * std::sqrt(0.025 * 0.975 * (1.0 / kDraws + 1.0 / cell.draws));
    for (const auto& [p, theirs] : {std::pair{0.025, cell.low}, std::pair{0.975, cell.high}}) {
      const double printed = std::isinf(theirs) ? 0.0 : 6e-4 * std::abs(theirs) + 1e-12;
      EXPECT_GE(theirs + printed, at(draws, p - error)) << cell.figure_and_simulation << " at " << p;
      EXPECT_LE(theirs - printed, at(draws, p + error)) << cell.figure_and_simulation << " at " << p;
    }
  }
}

// Infinities depend on where 1 - cdf rounds to 0 and on how far the kernel's grid reaches.
TEST(Chapter8, AsManyResultsAreInfiniteAsElsewhere) {
  for (const Cell& cell : readCells()) {
    const std::vector<double>& draws = drawsOf(cell.figure_and_simulation);
    const auto infinite = std::count_if(draws.begin(), draws.end(), [](double x) { return std::isinf(x); });
    const double share = static_cast<double>(infinite) / kDraws;
    const double pooled = (share * kDraws + cell.share_infinite * cell.draws) / (kDraws + cell.draws);
    const double error = std::sqrt(pooled * (1.0 - pooled) * (1.0 / kDraws + 1.0 / cell.draws));
    EXPECT_NEAR(share, cell.share_infinite, 4.0 * error + 0.0005) << cell.figure_and_simulation;
  }
}

// All misses are sim3. With a real mean that happened to be near 21.95, d, d_AVM and d_AVM,max hang together; with them
// d_AVM,L does not: for a box of +-0.10, max(L, R) >= 0.10 + d = 0.14, published are 0.12 and 0.11.
TEST(Chapter8, EveryPublishedFigureIsALikelyDrawButFourOfSim3) {
  std::set<std::string> unlikely;
  std::size_t published = 0;
  for (const Cell& cell : readCells()) {
    if (!cell.is_published) continue;
    ++published;
    if (!covers(drawsOf(cell.figure_and_simulation), cell.published, cell.half_digit)) {
      unlikely.insert(cell.table + " " + cell.figure_and_simulation);
    }
  }
  EXPECT_EQ(published, 15 * kSimulations);
  EXPECT_EQ(unlikely, (std::set<std::string>{"8-3 abs_mean_difference sim3", "8-3 avm sim3", "8-6 double_left sim3",
                                             "8-6 box_avm_max sim3"}));
}

// Conventions that the tables do not follow, though their text would allow them.
TEST(Chapter8, OtherConventionsAreExcluded) {
  // Two-sample Anderson-Darling: never infinite, never near 400 or 310.
  EXPECT_FALSE(covers(drawsOf("ad_two_sample sim2"), 400.0, 5.0));
  EXPECT_FALSE(covers(drawsOf("ad_two_sample sim5"), 310.0, 5.0));
  EXPECT_TRUE(std::isfinite(drawsOf("ad_two_sample sim1").back()));
  // d as mean of |differences| (eq. 8-3 on sorted values, the AVM for n = m): sim4 has the published mean 0.00.
  EXPECT_FALSE(covers(drawsOf("avm sim4"), 0.00, 0.005));
  // d_AVM,max as the larger of L and R.
  EXPECT_FALSE(covers(drawsOf("double_larger sim4"), 0.45, 0.005));
  // Histograms: some bin is empty on one side.
  for (const char* cell : {"histogram_symmetrised sim1", "histogram_symmetrised sim2", "histogram_symmetrised sim4"}) {
    EXPECT_TRUE(std::isinf(at(drawsOf(cell), 0.025))) << cell;
  }
  // D_JS as the distance, the root of the divergence.
  const double smallest_root = std::sqrt(at(drawsOf("js_divergence sim1"), 0.025));
  EXPECT_GT(smallest_root, 0.41 + 0.005);
}

}  // namespace
