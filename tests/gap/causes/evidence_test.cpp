#include "gap/causes/evidence.h"

#include <gtest/gtest.h>
#include <vector>

#include "gap/replay/statistics.h"
#include "tests/gap/measured_wall.h"

// How far a simulated world is from what was measured.
namespace {

/// One shot in a hundred gives a false alarm.
class RareEchoes : public test_support::MeasuredWall {
 protected:
  RareEchoes() : MeasuredWall({{"false-alarm", {{"rate_per_beam", 0.01}}}}) {}

  /// Of the right world, under a seed.
  [[nodiscard]] gap::SimulatedWorld simulated(std::uint64_t seed, std::size_t simulations) const {
    gap::Evidence evidence = split_.held_out;
    evidence.seed = seed;
    return {*replay_, world_of_false_alarms_, evidence, simulations};
  }
  [[nodiscard]] double scatterOf(std::size_t simulations) const {
    std::vector<double> discrepancies;
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
      discrepancies.push_back(simulated(seed, simulations).discrepancy());
    return gap::Distribution(discrepancies).stddev;
  }

  gap::World world_of_false_alarms_ = gap::worldOf(*replay_, effect("false-alarm"), {0.01});
};

TEST_F(RareEchoes, OfSeveralSimulationsAreAsFarAsTheseAreInTheMean) {
  const gap::SimulatedWorld world = simulated(1, 3);
  ASSERT_EQ(world.simulations(), 3U);
  const gap::Measured drawn = gap::measuredIn(*replay_, world_of_false_alarms_, split_.held_out, 99);
  const double first = world.discrepancyTo(drawn, 0), second = world.discrepancyTo(drawn, 1);
  EXPECT_NE(first, second);
  EXPECT_EQ(first, simulated(1, 1).discrepancyTo(drawn)) << "the first is that of the evidence's own seed";
  EXPECT_DOUBLE_EQ(world.discrepancyTo(drawn), (first + second + world.discrepancyTo(drawn, 2)) / 3.0);
}

// A few echoes lie where chance puts them: the distance of one simulation is mostly its own noise.
TEST_F(RareEchoes, ScatterLessInTheMeanOfSeveralSimulations) {
  EXPECT_LT(scatterOf(8), 0.6 * scatterOf(1));  // 0.35 if they were independent
}

}  // namespace
