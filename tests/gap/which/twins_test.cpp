#include "gap/which/twins.h"

#include <gtest/gtest.h>

#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace gap {
namespace {

using test_support::SmallWorld;

/// A wall, measured with a threshold of 30 nW in place of 20 nW; noise of 2 nW.
class Twins : public testing::Test {
 protected:
  [[nodiscard]] Candidate heard(const std::string& name, double value) const {
    Candidate candidate{.hypothesis = test_support::hypothesisNamed(hypotheses_, name), .values = {value}};
    judge_.hear(candidate);
    return candidate;
  }
  [[nodiscard]] static std::vector<double> valuesOf(const std::string& name, const std::vector<Candidate>& all) {
    for (const Candidate& candidate : all)
      if (candidate.hypothesis.name == name) return candidate.values;
    return {};
  }

  SmallWorld world_;
  model::Experiment measured_ =
      world_.measuredBy(SmallWorld::modelWith({}, {{"/sensor/receiver/threshold_w", 3e-8}}), 0.4);
  Replay replay_{measured_, SmallWorld::modelWith({})};
  std::vector<Hypothesis> hypotheses_ = hypothesesFor(replay_, {"dynamic-threshold", "atmospheric-attenuation"});
  Judge judge_{replay_, splitOf(replay_, 1), yardstickOf(replay_, splitOf(replay_, 1).held_out)};
};

// A multiple of the noise is another threshold: 15 times 2 nW.
TEST_F(Twins, TakeTheValueThatMakesTheSameWorld) {
  std::vector<Candidate> singles{heard("/sensor/receiver/threshold_w", 3e-8), heard("dynamic-threshold", 13.5)};
  ASSERT_LT(singles[1].merit, singles[0].merit - 0.01);
  takeValuesOfTwins(judge_, judge_, singles, core::SilentProgress());
  ASSERT_EQ(singles.size(), 2u);
  EXPECT_NEAR(valuesOf("dynamic-threshold", singles).at(0), 15.0, 0.02);
  EXPECT_EQ(valuesOf("/sensor/receiver/threshold_w", singles), std::vector<double>{3e-8});
  EXPECT_NEAR(singles[0].merit, singles[1].merit, 1e-3);
}

// Haze takes power, which makes echoes narrower, too, but not their intensity as it is.
TEST_F(Twins, AreNotThoseThatOnlyComeNear) {
  std::vector<Candidate> singles{heard("/sensor/receiver/threshold_w", 3e-8), heard("atmospheric-attenuation", 500.0)};
  takeValuesOfTwins(judge_, judge_, singles, core::SilentProgress());
  EXPECT_EQ(valuesOf("atmospheric-attenuation", singles), std::vector<double>{500.0});
}

// What a worse one would make of it is not taken; it takes the better one's world.
TEST_F(Twins, KeepTheirOwnValueWhereItIsBetter) {
  std::vector<Candidate> singles{heard("dynamic-threshold", 15.0), heard("/sensor/receiver/threshold_w", 2.7e-8)};
  takeValuesOfTwins(judge_, judge_, singles, core::SilentProgress());
  EXPECT_EQ(valuesOf("dynamic-threshold", singles), std::vector<double>{15.0});
  EXPECT_NEAR(valuesOf("/sensor/receiver/threshold_w", singles).at(0), 3e-8, 1e-10);
}

}  // namespace
}  // namespace gap
