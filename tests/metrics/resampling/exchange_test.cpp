#include "metrics/resampling/exchange.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/metrics/random_cases.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::Edf;
using metrics::Exchange;
using metrics::UnitSample;
using Values = std::vector<double>;
using Units = std::vector<std::uint32_t>;

core::Random randomOf(std::uint32_t replicate) { return core::Random({.seed = 6, .sample = replicate}); }

/// Every value as often as an EDF holds it.
Values valuesOf(const Edf& edf) {
  Values values;
  double below = 0.0;
  for (std::size_t i = 0; i < edf.values().size(); ++i) {
    values.insert(values.end(), static_cast<std::size_t>((edf.levels()[i] - below) * double(edf.n()) + 0.5),
                  edf.values()[i]);
    below = edf.levels()[i];
  }
  return values;
}

TEST(Exchange, DealsOutEveryValueOnce) {
  metrics_test::RandomCases cases(70);
  for (std::uint32_t k = 0; k < 100; ++k) {
    const Values a = cases.sample();
    const Values b = cases.sample();
    const Values c = cases.sample();
    const std::vector<UnitSample> samples{
        {.values = a, .units = {}}, {.values = b, .units = {}}, {.values = c, .units = {}}};
    core::Random random = randomOf(k);
    const std::vector<Edf> dealt = Exchange(samples, Values(3, 0.0)).dealt(random);
    EXPECT_EQ(dealt[0].n(), a.size());
    EXPECT_EQ(dealt[1].n(), b.size());
    Values before = a;
    before.insert(before.end(), b.begin(), b.end());
    before.insert(before.end(), c.begin(), c.end());
    Values after;
    for (const Edf& edf : dealt) std::ranges::copy(valuesOf(edf), std::back_inserter(after));
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    EXPECT_EQ(before, after);
  }
}

TEST(Exchange, KeepsUnitsWhole) {
  const Values a{1.0, 2.0, 3.0};
  const Values b{10.0, 20.0, 30.0, 40.0};
  const Units a_units{0, 0, 1};
  const Units b_units{0, 1, 1, 1};  // the numbers of the two samples have nothing to do with each other
  const Exchange exchange(std::vector<UnitSample>{{.values = a, .units = a_units}, {.values = b, .units = b_units}},
                          Values(2, 0.0));
  const std::vector<Values> units{{1.0, 2.0}, {3.0}, {10.0}, {20.0, 30.0, 40.0}};
  for (std::uint32_t k = 0; k < 50; ++k) {
    core::Random random = randomOf(k);
    const Values mine = valuesOf(exchange.dealt(random)[0]);
    std::size_t whole = 0;
    std::size_t values = 0;
    for (const Values& unit : units) {
      if (!std::ranges::includes(mine, unit)) continue;
      ++whole;
      values += unit.size();
    }
    EXPECT_EQ(whole, 2u);
    EXPECT_EQ(values, mine.size());
  }
}

// Of 2 + 2 units there are 6 deals: each comes once in six, within 5 deviations of 6000 trials.
TEST(Exchange, GivesEveryDealTheSameChance) {
  const Values a{1.0, 2.0};
  const Values b{4.0, 8.0};
  const Exchange exchange(std::vector<UnitSample>{{.values = a, .units = {}}, {.values = b, .units = {}}},
                          Values(2, 0.0));
  std::vector<int> seen(13, 0);
  for (std::uint32_t k = 0; k < 6000; ++k) {
    core::Random random = randomOf(k);
    double sum = 0.0;
    for (const double x : valuesOf(exchange.dealt(random)[0])) sum += x;
    ++seen[static_cast<std::size_t>(sum)];
  }
  for (const std::size_t sum : {3, 5, 9, 6, 10, 12}) EXPECT_NEAR(seen[sum], 1000, 5 * 29);
}

TEST(Exchange, MovesEachSampleByItsShift) {
  const Values a{1.0};
  const Values b{1.0};
  core::Random random = randomOf(0);
  const std::vector<Edf> dealt =
      Exchange(std::vector<UnitSample>{{.values = a, .units = {}}, {.values = b, .units = {}}}, Values{0.0, 5.0})
          .dealt(random);
  EXPECT_EQ(dealt[0].mean() + dealt[1].mean(), 7.0);
}

TEST(Exchange, RefusesUnitsOfOneSampleOnly) {
  const Values a{1.0, 2.0};
  const Units units{0, 1};
  EXPECT_NE(
      test_support::thrownMessage([&] {
        Exchange(std::vector<UnitSample>{{.values = a, .units = units}, {.values = a, .units = {}}}, Values(2, 0.0));
      }).find("sample 2: has units where"),
      std::string::npos);
}

}  // namespace
