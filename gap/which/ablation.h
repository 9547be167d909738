#pragma once

#include <span>
#include <string>
#include <vector>

#include "gap/causes/split.h"
#include "model/experiment.h"

namespace gap {

/// Parts of the diagnosis that are left out to see what they bring. The answers are not for use.
struct Ablation {
  bool references = false;  ///< recorded poses are taken as exact: no hypotheses of them, no tolerance (settle.h)
  bool parameters = false;  ///< recorded parameters are taken as right: no hypotheses, so no recalibrated pairs either
  bool hold_out = false;    ///< hypotheses are judged on the samples that they were fitted to

  /// `names`: "references", "parameters", "hold-out". Throws InputError for others.
  static Ablation of(std::span<const std::string> names);

  /// The experiment with all references known exactly, if references are left out.
  [[nodiscard]] model::Experiment applied(model::Experiment experiment) const;
  [[nodiscard]] std::vector<Hypothesis> applied(std::vector<Hypothesis> hypotheses) const;
  [[nodiscard]] Split applied(Split split) const;

  /// What a reader must be told; empty if nothing is left out.
  [[nodiscard]] std::string note() const;
};

}  // namespace gap
