#include "proposals/occurrence.h"

#include <gmock/gmock.h>

namespace proposals {
namespace {

using percollect::NodeKind;
using ::testing::HasSubstr;

/// A report whose cause is sure, with the given total gaps before and after, one set-up each.
GapReport reportOf(const std::vector<std::pair<double, double>>& totals, double shrink) {
  GapReport report;
  report.shrink = gap::Shrink{.fraction = shrink, .interval = {}};
  for (const auto& [before, after] : totals) {
    const std::string id = "s" + std::to_string(report.samples.size());
    report.samples.push_back({id, id, before, after});
  }
  return report;
}

gap::Cause causeOf(double confidence, double shrink_low) {
  gap::Cause cause;
  cause.confidence = confidence;
  cause.shrink.interval = {shrink_low, 1.0};
  return cause;
}

cepra::Row rowOf(NodeKind kind) {
  cepra::Row row;
  row.effects = {{"0", "Range error"}, {"1", "Attenuation"}};
  row.causes = {{"2", "a cause", kind}};
  return row;
}

TEST(Occurrence, ASetUpInWhichTheCauseOnlyAddsToTheGapDidNotShowIt) {
  const Seen seen = seenIn(reportOf({{10, 1}, {10, 2}, {1, 1}, {1, 2}}, 0.7));
  EXPECT_EQ(seen.setups, 2);
  EXPECT_EQ(seen.of, 4);
}

TEST(Occurrence, SamplesOfOneSetUpCountOnce) {
  GapReport report = reportOf({{10, 1}, {10, 1}, {10, 9.9}}, 0.6);
  report.samples[1].setup = report.samples[0].setup;
  EXPECT_EQ(seenIn(report).of, 2);
  EXPECT_EQ(seenIn(report).setups, 1);
}

// The table of occurrence.h, at and around its bounds. q = confidence x shrink x share.
TEST(Occurrence, FollowsTheTableForCausesInTheSensor) {
  const cepra::Row row = rowOf(NodeKind::DesignParameter);
  const auto always = reportOf({{10, 0}}, 1.0);
  const std::pair<double, int> expected[] = {{1.0, 10}, {0.9, 10}, {0.89, 9}, {0.5, 9}, {0.49, 8}, {0.1, 8}, {0.09, 7}};
  for (const auto& [q, step] : expected) {
    EXPECT_EQ(occurrenceFor(always, causeOf(q, 1.0), row).value, step) << q;
    EXPECT_EQ(occurrenceFor(always, causeOf(1.0, q), row).value, step) << q;
  }
  const auto half_of_setups = reportOf({{10, 0}, {10, 10}}, 0.5);
  EXPECT_EQ(occurrenceFor(half_of_setups, causeOf(1.0, 1.0), row).value, 9);
}

TEST(Occurrence, ACauseOutsideTheSensorGetsThreeStepsLess) {
  const auto report = reportOf({{10, 0}}, 1.0);
  for (const double q : {1.0, 0.6, 0.2, 0.01}) {
    const int inside = occurrenceFor(report, causeOf(q, 1.0), rowOf(NodeKind::DesignParameter)).value;
    EXPECT_EQ(occurrenceFor(report, causeOf(q, 1.0), rowOf(NodeKind::SystemIndependent)).value, inside - 3);
  }
}

TEST(Occurrence, AScoreIsNeverLoweredAndTheTextSaysSo) {
  cepra::Row row = rowOf(NodeKind::SystemIndependent);
  row.occurrence.value = 9;
  const auto kept = occurrenceFor(reportOf({{10, 0}}, 1.0), causeOf(1.0, 1.0), row);
  EXPECT_EQ(kept.value, 9);
  EXPECT_THAT(kept.text(), HasSubstr("occurrence 7. The row has 9, which is more and stays."));
  row.occurrence.value = 2;
  EXPECT_EQ(occurrenceFor(reportOf({{10, 0}}, 1.0), causeOf(1.0, 1.0), row).value, 7);
}

// Broken or extreme reports give a score of the scale all the same.
TEST(Occurrence, IsAlwaysAStepOfTheScale) {
  for (const double shrink : {-2.0, 0.0, 1.0, 7.0}) {
    for (const double confidence : {-1.0, 0.0, 3.0}) {
      const int value = occurrenceFor({}, causeOf(confidence, shrink), rowOf(NodeKind::SystemIndependent)).value;
      EXPECT_TRUE(1 <= value && value <= 10);
    }
  }
}

}  // namespace
}  // namespace proposals
