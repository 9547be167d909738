#include "gap/candidates/tried.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "gap/diagnosis.h"
#include "tests/gap/small_world.h"

// What else was weighed, and what judges that do not think say of it.
namespace {

using test_support::SmallWorld;

const SmallWorld::Effects kFog = {{"atmospheric-attenuation", {{"visibility_m", 400}}}};

gap::Diagnosis diagnosed(const model::Experiment& experiment, const gap::DiagnoseOptions& options) {
  core::SilentProgress progress;
  return gap::diagnose(experiment, SmallWorld::modelWith({}), options, progress);
}

/// Four beams and a wall: every judge must see fog there.
class TriedInFog : public testing::Test {
 protected:
  static const std::vector<gap::Tried>& tried() {
    static const std::vector<gap::Tried> list = [] {
      const SmallWorld world;
      const auto measured = world.measuredBy(SmallWorld::modelWith(kFog), 0.4);
      return diagnosed(measured,
                       {.library = {"atmospheric-attenuation", "range-offset", "detection-loss"}, .list_tried = true})
          .tried;
    }();
    return list;
  }
  static const gap::Tried& named(const std::string& name) {
    return *std::find_if(tried().begin(), tried().end(), [&](const gap::Tried& t) { return t.name == name; });
  }
};

TEST_F(TriedInFog, TheTrueCauseHasTheLowestBic) {
  const auto least = std::min_element(tried().begin(), tried().end(),
                                      [](const gap::Tried& a, const gap::Tried& b) { return a.bic < b.bic; });
  EXPECT_EQ(least->name, "atmospheric-attenuation");
  EXPECT_EQ(least->rank, 1U);
  ASSERT_EQ(least->values.size(), 1U);
  EXPECT_EQ(least->values[0].first, "visibility_m");
  EXPECT_NEAR(least->values[0].second, 400.0, 20.0);
}

TEST_F(TriedInFog, TheTrueCauseLooksMostLikeTheMeasurement) {
  EXPECT_GT(*named("atmospheric-attenuation").similarity, 0.95);
  EXPECT_LT(*named("range-offset").similarity, 0.5);
  for (const gap::Tried& one : tried()) {
    EXPECT_LE(std::abs(one.similarity.value_or(0.0)), 1.0 + 1e-9) << one.name;
  }
}

TEST_F(TriedInFog, TheModelAsItIsComesFirstAndExplainsNothing) {
  const gap::Tried& none = tried().front();
  EXPECT_EQ(none.kind, "none");
  EXPECT_TRUE(none.values.empty());
  EXPECT_EQ(none.explained, 0.0);
  EXPECT_FALSE(none.similarity.has_value());
  EXPECT_LT(named("atmospheric-attenuation").discrepancy, 0.5 * none.discrepancy);
}

TEST_F(TriedInFog, ParametersAndReferencesStandBesideEffects) {
  for (const char* kind : {"none", "effect", "parameter", "reference"})
    EXPECT_TRUE(std::any_of(tried().begin(), tried().end(), [&](const gap::Tried& t) { return t.kind == kind; }))
        << kind;
}

TEST(Tried, AreNotListedUnlessAskedFor) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith(kFog), 0.4);
  EXPECT_TRUE(diagnosed(measured, {.library = {"atmospheric-attenuation"}}).tried.empty());
}

TEST(Tried, PairsNameTheNumbersOfBoth) {
  const SmallWorld world;
  SmallWorld::Effects both = kFog;
  both["detection-loss"] = {{"probability", 0.08}};
  const auto measured = world.measuredBy(SmallWorld::modelWith(both), 0.4);
  const auto tried =
      diagnosed(measured, {.library = {"atmospheric-attenuation", "detection-loss"}, .list_tried = true}).tried;
  const auto pair = std::find_if(tried.begin(), tried.end(), [](const gap::Tried& t) { return t.kind == "pair"; });
  ASSERT_NE(pair, tried.end());
  EXPECT_EQ(pair->rank, 1U);
  std::vector<std::string> names;
  for (const auto& [name, value] : pair->values) names.push_back(name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"atmospheric-attenuation.visibility_m", "detection-loss.probability"}));
}

/// BIC of a world in which the model has these effects, measured by a model without any.
class Bic : public testing::Test {
 protected:
  double of(const SmallWorld::Effects& effects, std::size_t free_numbers = 0) const {
    gap::World world = replay_.baseline();
    world.model = SmallWorld::modelWith(effects);
    return gap::bicOf(gap::meansApart(replay_, world, gap::splitOf(replay_, 1).refined), free_numbers);
  }

  SmallWorld world_;
  model::Experiment measured_ = world_.measuredBy(SmallWorld::modelWith({}), 0.4);
  gap::Replay replay_{measured_, SmallWorld::modelWith({})};
};

// Four samples are fitted; a wall of 60 m by 12 m fills 4 layers of 41 beams there, each with the share of shots
// detected, range, pulse width and intensity.
TEST_F(Bic, AFreeNumberCostsTheLogarithmOfTheNumberOfTerms) {
  EXPECT_NEAR(of({}, 1) - of({}), std::log(4 * 4 * 41 * 4), 1e-6);
  EXPECT_NEAR(of({}, 3) - of({}), 3 * std::log(4 * 4 * 41 * 4), 1e-6);
}

// Independent normal errors are what the right model has, so that Σ z² is about the number of terms or, with floors
// in the errors, less.
TEST_F(Bic, OfTheRightModelIsNoMoreThanTheNumberOfTerms) { EXPECT_LT(of({}), 4 * 4 * 41 * 4); }

TEST_F(Bic, LosingEverythingIsNoWayToAgree) {
  EXPECT_GT(of({{"detection-loss", {{"probability", 1.0}}}}), of({{"range-offset", {{"offset_m", 0.1}}}}));
  EXPECT_GT(of({{"range-offset", {{"offset_m", 0.1}}}}), of({}));
}

TEST(TriedCsv, HasOneRecordForEachAndQuotesWhatNeedsIt) {
  gap::Tried one;
  one.kind = "effect";
  one.rank = 2;
  one.name = "a,b";
  one.sensors = {"left", "right"};
  one.values = {{"x_m", 0.5}, {"y", -2.0}};
  one.explained = 0.25;
  one.discrepancy = 12.5;
  one.bic = 80.0;
  EXPECT_EQ(gap::toCsv({one}),
            "rank,kind,name,variant,sensors,free_numbers,values,explained,discrepancy,bic,similarity\n"
            "2,effect,\"a,b\",,left;right,2,x_m=0.5;y=-2,0.25,12.5,80,\n");
}

}  // namespace
