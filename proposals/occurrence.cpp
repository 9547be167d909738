#include "proposals/occurrence.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "core/text.h"

namespace proposals {

namespace {

constexpr double kHalf = 0.5;  // of the average shrink: nearer to present than to absent
constexpr int kOutside = 3;    // steps from shares of a drive to days and seasons

int stepOf(double q) {
  if (q >= 0.9) return 10;
  if (q >= 0.5) return 9;
  return q >= 0.1 ? 8 : 7;
}

}  // namespace

Seen seenIn(const GapReport& report) {
  struct Totals {
    double before = 0.0;
    double after = 0.0;
  };
  std::map<std::string, Totals> setups;
  for (const gap::SampleTotals& sample : report.samples) {
    setups[sample.setup].before += sample.before;
    setups[sample.setup].after += sample.after;
  }
  const double shrink = report.shrink ? report.shrink->fraction : 0.0;
  Seen seen{.setups = 0, .of = static_cast<int>(setups.size())};
  for (const auto& [setup, totals] : setups) {
    const bool smaller = totals.after < totals.before;
    seen.setups += smaller && 1.0 - totals.after / totals.before >= kHalf * shrink;
  }
  return seen;
}

ProposedOccurrence occurrenceFor(const GapReport& report, const gap::Cause& cause, const cepra::Row& row) {
  ProposedOccurrence proposed;
  proposed.established = std::clamp(cause.confidence, 0.0, 1.0) * std::clamp(cause.shrink.interval.low, 0.0, 1.0);
  proposed.seen = seenIn(report);
  proposed.outside = !row.causesOfKind(percollect::NodeKind::SystemIndependent).empty();
  const int step = stepOf(proposed.established * proposed.seen.share());
  proposed.by_rule = proposed.outside ? step - kOutside : step;
  proposed.kept = row.occurrence.value.value_or(0) > proposed.by_rule;
  proposed.value = std::max(proposed.by_rule, row.occurrence.value.value_or(0));
  return proposed;
}

std::string ProposedOccurrence::text() const {
  std::string text = seen.of > 0 ? fmt::format("Seen in {} of {} held-out set-ups", seen.setups, seen.of)
                                 : std::string("The report does not say in how many set-ups it was seen");
  text += fmt::format(", established to {} (confidence times the lower end of the shrink)",
                      core::significant(established, 2));
  text += outside ? "; three steps less, because a cause outside the sensor was met where somebody measured"
                  : "; the cause lies in the sensor and is in every drive";
  text += fmt::format(": occurrence {}.", by_rule);
  if (kept) text += fmt::format(" The row has {}, which is more and stays.", value);
  return text;
}

}  // namespace proposals
