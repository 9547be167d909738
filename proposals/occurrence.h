#pragma once

#include <string>

#include "cepra/table.h"
#include "proposals/gap_report.h"

namespace proposals {

/// In how many of the held-out set-ups an effect was seen.
struct Seen {
  int setups = 0;
  int of = 0;  ///< 0: the report does not list them

  [[nodiscard]] double share() const { return of > 0 ? static_cast<double>(setups) / of : 1.0; }
};

/// An effect was seen in a set-up if adding it shrinks the gap there by at least half of what it does on average. Where
/// an effect is absent, adding it changes nothing or makes the gap larger.
[[nodiscard]] Seen seenIn(const GapReport& report);

/// How often, as far as one experiment can tell (docs/diagnosis.md, "Back to the table"):
///
///   q = confidence x lower end of the held-out shrink x share of set-ups in which the effect was seen
///
///   q                     >= 0.9   >= 0.5   >= 0.1   below
///   permanent causes        10        9        8       7
///   causes outside           7        6        5       4     (the row has a system-independent cause)
///
/// The upper line reads the scale as shares of operation, which its steps 8 to 10 are: what lies in the sensor is in
/// every drive. A cause outside the sensor was met because somebody measured there; how often it is met on the road,
/// one experiment does not tell: three steps less, into the steps that count days and seasons. A score that is there
/// already is never lowered. All of this is a proposal; a person decides.
struct ProposedOccurrence {
  int value = 1;             ///< to be written
  int by_rule = 1;           ///< what the rule alone gives
  bool kept = false;         ///< the row's own score is higher and stays
  bool outside = false;      ///< the row has a system-independent cause
  double established = 0.0;  ///< confidence x lower end of the shrink
  Seen seen;

  /// How it came about, in one sentence.
  [[nodiscard]] std::string text() const;
};

[[nodiscard]] ProposedOccurrence occurrenceFor(const GapReport& report, const gap::Cause& cause, const cepra::Row& row);

}  // namespace proposals
