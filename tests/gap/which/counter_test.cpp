#include "gap/which/counter.h"

#include <gtest/gtest.h>

#include "gap/far/how_far.h"
#include "gap/pairs/partners.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// A wall whose ranges are multiples of 43.7 mm, and whatever else a test measures it with.
class Counter {
 public:
  explicit Counter(SmallWorld::Effects effects, double true_reflectivity = 0.4)
      : measured_(world_.measuredBy(counting(std::move(effects)), true_reflectivity)) {}

  /// With these values, best first.
  [[nodiscard]] gap::Candidate candidate(const std::string& name, double value, double total_left = 1.0) const {
    return {
        .hypothesis = test_support::hypothesisNamed(hypotheses_, name), .values = {value}, .total_left = total_left};
  }
  [[nodiscard]] gap::Candidate counter() const { return candidate("quantisation", 0.0437); }
  [[nodiscard]] gap::Candidate noise(double total_left = 1.0) const {
    return candidate("/sensor/detection/range_noise_m", 0.02, total_left);
  }
  [[nodiscard]] std::vector<gap::Candidate> pairsOf(const std::vector<gap::Candidate>& singles) const {
    core::SilentProgress progress;
    const gap::HeldOutGaps gaps(replay_, judge_.split.held_out.samples, 1);
    const gap::WhereResult where = gap::whereIn(replay_, replay_.baseline(), 1);
    return gap::besideTheCounter(judge_, judge_, gaps, where, singles, progress);
  }
  [[nodiscard]] bool earns(const gap::Candidate& beside) const {
    gap::Candidate pair = gap::pairOf(beside, counter());
    judge_.hear(pair);
    return earns({beside, counter()}, pair);
  }
  [[nodiscard]] bool earns(const std::vector<gap::Candidate>& singles, const gap::Candidate& pair) const {
    return gap::earnsBesideTheCounter(judge_, singles, pair);
  }
  [[nodiscard]] gap::Candidate heard(gap::Candidate candidate) const {
    judge_.hear(candidate);
    return candidate;
  }

 private:
  static model::LidarModel counting(SmallWorld::Effects effects) {
    effects["quantisation"] = {{"range_step_m", 0.0437}};
    return SmallWorld::modelWith(effects);
  }

  SmallWorld world_;
  model::Experiment measured_;
  gap::Replay replay_{measured_, SmallWorld::modelWith({})};
  std::vector<gap::Hypothesis> hypotheses_ = gap::hypothesesFor(replay_, {"quantisation", "atmospheric-attenuation"});
  gap::Judge judge_{replay_, gap::splitOf(replay_, 1), gap::yardstickOf(replay_, gap::splitOf(replay_, 1).held_out)};
};

TEST(BesideACounter, ACauseMustBringWhatItsNumberCosts) {
  EXPECT_FALSE(Counter({}).earns(Counter({}).noise()));
  const Counter foggy({{"atmospheric-attenuation", {{"visibility_m", 400}}}});
  EXPECT_TRUE(foggy.earns(foggy.candidate("atmospheric-attenuation", 400.0)));
}

// Intensities are half as large again as the model says, which neither the counter nor a noise does: most of the total
// gap stays. That speaks against the counter only if the noise alone leaves less of it.
TEST(BesideACounter, ATotalGapThatTheBestCauseLeavesAsWellDoesNotSpeakAgainstIt) {
  const Counter brighter({}, 0.6);
  const auto pairs = brighter.pairsOf({brighter.noise(1.1), brighter.counter()});
  ASSERT_FALSE(pairs.empty());
  EXPECT_GT(pairs.front().total_left, 0.5);
  EXPECT_TRUE(brighter.pairsOf({brighter.noise(0.3), brighter.counter()}).empty());
}

TEST(BesideACounter, NothingIsPairedWithItThatBringsNothing) {
  const Counter alone({});
  EXPECT_TRUE(alone.pairsOf({alone.counter(), alone.noise()}).empty());
}

// Steps of 43.7 mm are most of what range cells show, and hide a haze that takes a few per cent of the power.
TEST(BesideACounter, ASecondCauseIsFoundAndProvesItselfWhereTheCounterIsTheBestCause) {
  const Counter hazy({{"atmospheric-attenuation", {{"visibility_m", 1500}}}});
  const std::vector<gap::Candidate> singles = {hazy.heard(hazy.counter()),
                                               hazy.heard(hazy.candidate("atmospheric-attenuation", 10000.0))};
  const auto pairs = hazy.pairsOf(singles);
  ASSERT_FALSE(pairs.empty());
  EXPECT_EQ(pairs.front().hypothesis.members.at(1).name, "atmospheric-attenuation");
  EXPECT_NEAR(pairs.front().values.at(1), 1500.0, 150.0);
  EXPECT_TRUE(hazy.earns(singles, pairs.front()));
}

TEST(BesideACounter, ItLeadsWhereNothingEarnsItsPlaceThere) {
  const Counter alone({});
  std::vector<gap::Candidate> singles = {alone.noise(), alone.candidate("atmospheric-attenuation", 400.0)};
  EXPECT_FALSE(gap::showACounter(singles));
  singles.push_back(alone.counter());
  ASSERT_TRUE(gap::showACounter(singles));
  gap::leadByTheCounter(singles);
  EXPECT_EQ(singles[0].hypothesis.name, "quantisation");
  EXPECT_EQ(singles[1].hypothesis.name, "/sensor/detection/range_noise_m");
  EXPECT_EQ(singles[2].hypothesis.name, "atmospheric-attenuation");
}

}  // namespace
