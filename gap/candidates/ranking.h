#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/candidates/candidates.h"
#include "gap/where/where.h"

namespace gap {

/// Fits every hypothesis. What is `known` is at work in all of them, and only what they bring beyond it decides which
/// are fitted to the end.
[[nodiscard]] std::vector<Candidate> fitted(const Judge& judge, const std::vector<Hypothesis>& hypotheses,
                                            const WhereResult& where, core::Progress& progress,
                                            const World* known = nullptr);
/// Fits every hypothesis and judges it on held-out data; best merit first.
[[nodiscard]] std::vector<Candidate> rank(const Judge& judge, const std::vector<Hypothesis>& hypotheses,
                                          const WhereResult& where, core::Progress& progress);

}  // namespace gap
