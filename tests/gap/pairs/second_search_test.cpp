#include "gap/pairs/second_search.h"

#include <gtest/gtest.h>

#include "tests/gap/small_world.h"
#include "tests/gap/usual_causes.h"

namespace {

using test_support::SmallWorld;

/// A measurement, and what is found beside one of its two causes.
class BesideAKnownCause {
 public:
  /// The world lives longer.
  BesideAKnownCause(const SmallWorld& world, const SmallWorld::Effects& truth)
      : measured_(world.measuredBy(SmallWorld::modelWith(truth, SmallWorld::narrowView()), 0.4)),
        replay_(measured_, SmallWorld::modelWith({}, SmallWorld::narrowView())) {}

  [[nodiscard]] std::vector<gap::Found> foundBeside(const std::string& name, const std::vector<double>& values) {
    return gap::searchedBeside(judge_, knownAs(name, values), singles_, progress_);
  }
  /// In nats, of all that is fitted.
  [[nodiscard]] double gainBeside(const std::string& name, const std::vector<double>& values,
                                  const gap::Found& found) const {
    const gap::Hypothesis known = knownAs(name, values).hypothesis;
    const gap::Hypothesis both = gap::together(known, singles_[found.single].hypothesis);
    return judge_.leftOfFitted(known, values) - judge_.leftOfFitted(both, gap::joined(values, found.values));
  }
  [[nodiscard]] const std::string& nameOf(const gap::Found& found) const {
    return singles_[found.single].hypothesis.name;
  }

 private:
  [[nodiscard]] gap::Candidate knownAs(const std::string& name, const std::vector<double>& values) const {
    return test_support::causeNamed(singles_, name, values);
  }

  model::Experiment measured_;
  gap::Replay replay_;
  gap::Split split_ = gap::splitOf(replay_, 1);
  gap::Judge judge_{replay_, split_, gap::yardstickOf(replay_, split_.held_out)};
  std::vector<gap::Candidate> singles_ = test_support::usualCauses(replay_);
  core::SilentProgress progress_;
};

// 8 m away an offset of 56.5 mm takes nearly all light; two millimetres more take all, two less half as much.
TEST(SecondSearch, FindsANumberBetweenTwoPlacesOfAnEvenSearch) {
  const SmallWorld world;
  BesideAKnownCause search(world,
                           {{"aperture-offset", {{"offset_m", 0.0565}}}, {"range-offset", {{"offset_m", 0.05}}}});
  const auto found = search.foundBeside("range-offset", {0.05});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(search.nameOf(found.front()), "aperture-offset");
  EXPECT_NEAR(found.front().values.at(0), 0.0565, 0.0005);
}

// A scan that is turned sends every ray another way, and moves few echoes: those beside edges.
TEST(SecondSearch, FitsACauseThatSendsTheRaysAnotherWay) {
  SmallWorld world;
  world.withAWallOf(4.0);
  BesideAKnownCause search(world, {{"mounting-error", {{"yaw_deg", 0.3}}}, {"range-offset", {{"offset_m", 0.05}}}});
  const auto found = search.foundBeside("range-offset", {0.05});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(search.nameOf(found.front()), "mounting-error");
  EXPECT_NEAR(found.front().values.at(0), 0.3, 0.03);
}

// What noise gives one of some sixty causes may be more than its price; whoever judges the pair sees that.
TEST(SecondSearch, HoldsNothingThatBringsLessThanItCosts) {
  const SmallWorld world;
  BesideAKnownCause search(world, {{"range-offset", {{"offset_m", 0.05}}}});
  for (const gap::Found& found : search.foundBeside("range-offset", {0.05}))
    EXPECT_GT(search.gainBeside("range-offset", {0.05}, found), 4.0 * static_cast<double>(found.values.size()));
}

}  // namespace
