#include "gap/candidates/suggested.h"

#include <gtest/gtest.h>

#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

// What is known of causes before the best ones are fitted with all beams.
namespace {

using test_support::hypothesisNamed;
using test_support::SmallWorld;

class Counted : public testing::Test {
 protected:
  /// What becomes of a fit of foreign pulses that ended here, where 4000 of this mean excess come in a second.
  [[nodiscard]] static std::vector<double> after(const std::vector<double>& fitted, double true_excess) {
    const SmallWorld world;
    const model::Experiment measured =
        world.measuredBy(SmallWorld::modelWith({{"crosstalk", {{"rate_1_s", 4000.0}, {"excess", true_excess}}}}), 0.4);
    const gap::Replay replay(measured, SmallWorld::modelWith({}));
    const gap::Split split = gap::splitOf(replay, 1);
    const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
    const auto hypotheses = gap::hypothesesFor(replay, {});
    std::vector<gap::Candidate> candidates{{hypothesisNamed(hypotheses, "crosstalk"), fitted},
                                           {hypothesisNamed(hypotheses, "range-offset"), {0.1}}};
    for (gap::Candidate& candidate : candidates) judge.hear(candidate);
    core::SilentProgress progress;
    gap::takeWhatIsCounted(judge, gap::whereIn(replay, replay.baseline(), 1), candidates, progress);
    EXPECT_EQ(candidates.front().hypothesis.name, "crosstalk");     // best first
    EXPECT_EQ(candidates.back().values, std::vector<double>{0.1});  // nothing was counted of it
    return candidates.front().values;
  }
};

// Four in a thousand shots have such an echo: few beams with luck hardly any, all 19680 shots some 80, give or take 9.
TEST_F(Counted, ARateReplacesOneThatFewBeamsLedTo) { EXPECT_NEAR(after({300.0, 10.0}, 10.0)[0], 4000.0, 4.0 * 450.0); }

// A fit that found how strong they are, too, knows more than their number.
TEST_F(Counted, ARateLeavesABetterFitAlone) {
  const std::vector<double> better{4000.0, 200.0};
  EXPECT_EQ(after(better, 200.0), better);
}

}  // namespace
