#include <algorithm>
#include <gtest/gtest.h>

#include "core/error.h"
#include "gap/diagnosis.h"
#include "tests/gap/small_world.h"

// What the diagnosis is without its parts: each guards against a mistake, which is made as soon as it is gone.
namespace {

using test_support::SmallWorld;

gap::Diagnosis diagnosed(const model::Experiment& experiment, const gap::Ablation& without) {
  core::SilentProgress progress;
  return gap::diagnose(experiment, SmallWorld::modelWith({}),
                       {.library = {"range-offset"}, .list_tried = true, .without = without}, progress);
}

bool tried(const gap::Diagnosis& diagnosis, const std::string& kind) {
  return std::any_of(diagnosis.tried.begin(), diagnosis.tried.end(),
                     [&](const gap::Tried& one) { return one.kind == kind; });
}

TEST(Ablation, WithoutReferencesASetUpThatStandsWithinItsToleranceIsAGap) {
  SmallWorld world;
  world.knownToWithin(0.03);
  const auto measured = world.measuredBy(
      SmallWorld::modelWith({}), 0.4,
      {{"r8", 0.021}, {"r13", -0.018}, {"r19", 0.012}, {"r27", -0.024}, {"r36", 0.006}, {"r46", -0.009}});
  const gap::Diagnosis full = diagnosed(measured, {}), without = diagnosed(measured, {.references = true});
  EXPECT_FALSE(full.present);
  EXPECT_TRUE(without.present);
  EXPECT_FALSE(tried(without, "reference"));
  EXPECT_TRUE(tried(without, "parameter"));
}

TEST(Ablation, WithoutParametersAWrongOneIsNeverNamed) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({}, {{"/sensor/detection/epw_noise_m", 0.09}}), 0.4);
  EXPECT_EQ(diagnosed(measured, {}).verdict.kind, gap::VerdictKind::kParameter);
  const gap::Diagnosis without = diagnosed(measured, {.parameters = true});
  EXPECT_NE(without.verdict.kind, gap::VerdictKind::kParameter);
  EXPECT_FALSE(tried(without, "parameter"));
  EXPECT_TRUE(tried(without, "effect"));
}

TEST(Ablation, WithoutHoldOutTheFittedSamplesJudge) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.1}}}}), 0.4);
  EXPECT_EQ(diagnosed(measured, {}).held_out, (std::vector<std::string>{"r19", "r36"}));
  EXPECT_EQ(diagnosed(measured, {.hold_out = true}).held_out, (std::vector<std::string>{"r8", "r13", "r27", "r46"}));
}

TEST(Ablation, IsToldBesideTheVerdict) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({}), 0.4);
  const auto told = [](const gap::Diagnosis& diagnosis) {
    return std::any_of(diagnosis.notes.begin(), diagnosis.notes.end(),
                       [](const std::string& note) { return note.find("Made without hold-out") == 0; });
  };
  EXPECT_FALSE(told(diagnosed(measured, {})));
  EXPECT_TRUE(told(diagnosed(measured, {.hold_out = true})));
}

TEST(Ablation, OfAnUnknownPartIsRefused) {
  const std::vector<std::string> names{"physics"};
  EXPECT_THROW(static_cast<void>(gap::Ablation::of(names)), core::InputError);
}

}  // namespace
