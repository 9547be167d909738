#include "gap/which/rivals.h"

#include <gtest/gtest.h>
#include <optional>

#include "gap/candidates/separation.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// A rough wall at one range, measured with a tenth less power. At one range many causes take a tenth of the power.
class Rivals : public testing::Test {
 protected:
  Rivals()
      : measured_(world_.measuredBy(
            SmallWorld::modelWith({{"angular-reflection", {{"model", "oren-nayar"}, {"roughness_rad", 0.4}}}}), 0.36)),
        replay_(measured_, SmallWorld::modelWith({})),
        hypotheses_(withGlossyWall(gap::hypothesesFor(replay_, {"angular-reflection", "atmospheric-attenuation"}))),
        judge_{replay_, atOneRange(), gap::yardstickOf(replay_, atOneRange().held_out)} {}

  /// With a cause that the library does not offer here, where nothing stands in what the wall would mirror.
  [[nodiscard]] static std::vector<gap::Hypothesis> withGlossyWall(std::vector<gap::Hypothesis> hypotheses) {
    gap::Hypothesis glossy{.name = "multipath", .variant = "every surface", .parameters = {}, .apply = {}};
    glossy.parameters.push_back({.name = "specular_fraction", .high = 1.0, .start = 0.3});
    glossy.apply = [](gap::World& world, const std::vector<double>& values) {
      world.model = model::withEffect(world.model, {"multipath", {{{"specular_fraction", values[0]}}, {}, {}}, {}});
    };
    hypotheses.push_back(std::move(glossy));
    return hypotheses;
  }
  [[nodiscard]] gap::Split atOneRange() const {
    gap::Split split = gap::splitOf(replay_, 1);
    for (gap::Evidence* evidence : {&split.fitted, &split.refined, &split.held_out}) evidence->samples = {2};
    return split;
  }
  /// Beside the roughness.
  [[nodiscard]] gap::Candidate pairAt(const std::string& name, const std::string& variant, double value,
                                      double merit) const {
    const auto find = [&](const std::string& wanted, const std::string& form) {
      return test_support::hypothesisNamed(hypotheses_, wanted, form);
    };
    gap::Candidate pair{.hypothesis = gap::together(find("angular-reflection", "oren-nayar"), find(name, variant)),
                        .values = {0.4, value}};
    judge_.hear(pair);
    pair.merit = merit;
    return pair;
  }
  /// The same, both fitted.
  [[nodiscard]] gap::Candidate pairWith(const std::string& name, const std::string& variant, double value,
                                        double merit) const {
    gap::Candidate pair = pairAt(name, variant, value, merit);
    pair.values = gap::fitFrom(replay_, pair.hypothesis, judge_.split.refined, pair.values, core::SilentProgress());
    judge_.hear(pair);
    pair.merit = merit;
    return pair;
  }
  [[nodiscard]] std::string leaderOf(std::vector<gap::Candidate> pairs) const {
    gap::leadByPlainest(judge_, judge_, pairs);
    return pairs.front().hypothesis.members[1].name;
  }

  SmallWorld world_;
  model::Experiment measured_;
  gap::Replay replay_;
  std::vector<gap::Hypothesis> hypotheses_;
  gap::Judge judge_;
  gap::Candidate weaker_emitter_ = pairWith("/sensor/emitter/peak_power_w", "", 45.0, 1.0);
  gap::Candidate haze_ = pairWith("atmospheric-attenuation", "", 1100.0, 0.99);
  gap::Candidate glossy_wall_ = pairWith("multipath", "every surface", 0.1, 0.99);
};

TEST_F(Rivals, OfTwoEffectsLeadBeforeAnEffectWithARecalibration) {
  EXPECT_EQ(leaderOf({weaker_emitter_, haze_}), "atmospheric-attenuation");
}

// Haze at one range takes what a weaker emitter has not; one that is too weak does not do what the haze does.
TEST_F(Rivals, OfTwoEffectsMayBeAWrongNumber) {
  const auto recalibrations = gap::recalibrationsInPairs(judge_, judge_, {haze_, weaker_emitter_, glossy_wall_}, 1.0);
  ASSERT_EQ(recalibrations.size(), 1U);
  EXPECT_EQ(recalibrations[0].name, "/sensor/emitter/peak_power_w");
  EXPECT_EQ(recalibrations[0].instead_of, "atmospheric-attenuation");
  const gap::Candidate too_weak = pairAt("/sensor/emitter/peak_power_w", "", 40.0, 0.99);
  EXPECT_TRUE(gap::recalibrationsInPairs(judge_, judge_, {haze_, too_weak}, 1.0).empty());
  EXPECT_TRUE(gap::recalibrationsInPairs(judge_, judge_, {weaker_emitter_, haze_}, 1.0).empty())
      << "the number is named already";
}

// A threshold a little beside what is recorded, and one that is a multiple of the noise, are one threshold.
TEST_F(Rivals, OfTwoEffectsLeadHoweverLittleARecalibrationMoves) {
  const double recorded_w = replay_.baseline().model.sensor("").receiver.threshold_w;
  const gap::Candidate threshold = pairAt("/sensor/receiver/threshold_w", "", 1.001 * recorded_w, 1.0);
  EXPECT_EQ(leaderOf({threshold, pairAt("atmospheric-attenuation", "", 20000.0, 0.99)}), "atmospheric-attenuation");
}

// A haze that nobody sees and a gloss that none has do as little; the gloss of every surface is one form of several.
TEST_F(Rivals, InTheirUsualFormLeadBeforeAnotherFormThatSaysTheSame) {
  const gap::Candidate gloss = pairAt("multipath", "every surface", 0.0, 1.0);
  EXPECT_EQ(leaderOf({gloss, pairAt("atmospheric-attenuation", "", 20000.0, 0.99)}), "atmospheric-attenuation");
}

// A wall that is too dark and a gate before it may differ by nothing that single cells tell: all detections do.
TEST_F(Rivals, ThatLeaveMoreOfTheTotalGapDoNotLeadThoughTheySayLess) {
  gap::Candidate gloss = pairAt("multipath", "every surface", 0.0, 1.0);
  gap::Candidate haze = pairAt("atmospheric-attenuation", "", 20000.0, 0.99);
  const auto leaderWhereHazeLeaves = [&](double of_total) {
    gap::Judge judge = judge_;
    judge.weight_of_total = 0.3;
    gloss.total_left = 0.0;
    haze.total_left = of_total;
    std::vector<gap::Candidate> pairs{gloss, haze};
    gap::leadByPlainest(judge, judge, pairs);
    return pairs.front().hypothesis.members[1].name;
  };
  EXPECT_EQ(leaderWhereHazeLeaves(0.05), "atmospheric-attenuation");
  EXPECT_EQ(leaderWhereHazeLeaves(0.2), "multipath");
}

TEST_F(Rivals, ThatChooseAnotherFormSayMoreAndDoNotLead) {
  // They are as near.
  EXPECT_LT(gap::separationOnAll(judge_, judge_, weaker_emitter_, glossy_wall_, 0.03), 1.5);
  EXPECT_EQ(leaderOf({weaker_emitter_, glossy_wall_}), "/sensor/emitter/peak_power_w");
}

// Two pairs of one giant differ by little of the gap; by the measure of what the second cause adds they do not.
TEST_F(Rivals, LeadByTheMeasureOfWhatTheSecondAdds) {
  gap::Candidate thinner_haze = haze_;
  thinner_haze.values.back() *= 1.05;
  judge_.hear(thinner_haze);
  thinner_haze.merit = 1.0;
  gap::Candidate emitter = weaker_emitter_;
  emitter.merit = 0.99;
  const auto leader = [&](double added) {
    std::vector<gap::Candidate> pairs{thinner_haze, emitter};
    gap::leadByAll(judge_, judge_, pairs, added);
    return pairs.front().hypothesis.name;
  };
  EXPECT_EQ(leader(1.0), thinner_haze.hypothesis.name);
  EXPECT_EQ(leader(0.01), emitter.hypothesis.name);
}

TEST(AddedBySecond, IsTheShareOfTheNearestPairThatTheBestSingleCauseDoesNotExplain) {
  const auto explaining = [](double share) { return gap::Candidate{.explained = share}; };
  EXPECT_NEAR(gap::addedBySecond(explaining(0.96), {explaining(0.97), explaining(1.0), explaining(0.98)}), 0.04, 1e-12);
  EXPECT_DOUBLE_EQ(gap::addedBySecond(explaining(0.96), {explaining(0.9)}), 0.0);
}

// A cause that leads by all samples together while the held-out ones prefer another is not told from it, however far
// apart they are.
TEST_F(Rivals, AreNotToldApartWhereHeldOutSamplesPreferTheOther) {
  const auto candidate = [&](const std::string& name, double value, double merit) {
    gap::Candidate single{.hypothesis = test_support::hypothesisNamed(hypotheses_, name), .values = {value}};
    judge_.hear(single);
    single.merit = merit;
    return single;
  };
  const gap::Candidate weaker_emitter = candidate("/sensor/emitter/peak_power_w", 45.0, 0.9);
  for (const double merit : {0.89, 0.91}) {
    const auto rivals =
        gap::rivalsOf(judge_, judge_, {weaker_emitter, candidate("atmospheric-attenuation", 60.0, merit)});
    ASSERT_EQ(rivals.size(), 1U);
    EXPECT_EQ(rivals[0].tied(), merit > 0.9) << rivals[0].separation;
  }
}

// Scatter may come as near as a counter's steps do; only the steps make all values multiples of one.
TEST_F(Rivals, WhatTheValuesShowHasNone) {
  gap::Candidate shown = weaker_emitter_;
  EXPECT_FALSE(gap::rivalsOf(judge_, judge_, {shown, haze_}).empty());
  shown.hypothesis.seen_in_values = true;
  EXPECT_TRUE(gap::rivalsOf(judge_, judge_, {shown, haze_}).empty());
}

// A jitter may be one of the duration, of the power, or of both. Where that of the power is the graininess of the
// light, which says one number and could say no other, it has chosen among its mechanisms.
TEST(RivalsAlone, OfOneNumberEachLeadsTheOneThatHasNoOtherToSay) {
  const SmallWorld world;
  const model::Experiment measured = world.measuredBy(SmallWorld::modelWith({{"speckle", {{"looks", 100.0}}}}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const auto hypotheses = gap::hypothesesFor(replay, {"pulse-jitter", "speckle"});
  std::vector<gap::Candidate> candidates;
  for (const auto& [name, values] :
       std::map<std::string, std::vector<double>>{{"pulse-jitter", {0.0, 0.1}}, {"speckle", {100.0}}}) {
    candidates.push_back({.hypothesis = test_support::hypothesisNamed(hypotheses, name), .values = values});
    judge.hear(candidates.back());
    candidates.back().merit = 1.0;
  }
  ASSERT_EQ(candidates.front().hypothesis.name, "pulse-jitter");
  ASSERT_EQ(candidates.front().hypothesis.parameters.size(), 2U);
  gap::leadByPlainest(judge, judge, candidates);
  EXPECT_EQ(candidates.front().hypothesis.name, "speckle");
}

// Dirt of a few per mille in the middle of the view says three numbers, though all of them are small: a cause that says
// the same with two is plainer.
TEST_F(Rivals, LittleDirtInASectorSaysThreeNumbers) {
  gap::Candidate dirt{.hypothesis = test_support::hypothesisNamed(gap::hypothesesFor(replay_, {"cover-contamination"}),
                                                                  "cover-contamination"),
                      .values = {0.004, -0.5, 0.6}};
  gap::Candidate of_two{.hypothesis = dirt.hypothesis, .values = {0.08, 0.05}};
  of_two.hypothesis.name = "the same in two numbers";
  of_two.hypothesis.parameters = {{.name = "a", .high = 1.0}, {.name = "b", .high = 1.0}};
  of_two.hypothesis.apply = [same = dirt.hypothesis](gap::World& world, const std::vector<double>& values) {
    same.apply(world, {values[0] * values[1], -0.5, 0.6});
  };
  std::vector<gap::Candidate> candidates{dirt, of_two};
  for (gap::Candidate& candidate : candidates) {
    judge_.hear(candidate);
    candidate.merit = 1.0;
  }
  gap::leadByPlainest(judge_, judge_, candidates);
  EXPECT_EQ(candidates.front().hypothesis.name, of_two.hypothesis.name);
}

}  // namespace
