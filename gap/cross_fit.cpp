#include "gap/cross_fit.h"

#include <utility>

namespace gap {

namespace {

/// Takes the samples and their part from elsewhere, all else stays.
Evidence on(Evidence evidence, const Evidence& elsewhere) {
  evidence.samples = elsewhere.samples;
  evidence.part.half = elsewhere.part.half;
  return evidence;
}

Split exchanged(const Split& split) {
  return {on(split.fitted, split.held_out), on(split.held_out, split.fitted), on(split.refined, split.held_out),
          split.weak};
}

}  // namespace

CrossFit::CrossFit(const Judge& quick, const Judge& exact, const NullRuns& nulls)
    : quick_(quick),
      exact_(exact),
      nulls_(nulls),
      exchanged_(exchanged(exact.split)),
      exchanged_nulls_(exact.replay, bySample(exchanged_.held_out), nulls.runs()) {}

bool CrossFit::applies(const Candidate& candidate) const {
  return !exact_.split.weak && !candidate.hypothesis.per_setup;
}

Significance CrossFit::significanceOf(const Candidate& candidate, const core::Progress& progress) const {
  const Hypothesis& hypothesis = candidate.hypothesis;
  const Split few = exchanged(quick_.split);
  std::vector<double> values = scout(quick_.replay, hypothesis, few.fitted, {}, progress).values;
  values = fitFrom(quick_.replay, hypothesis, few.fitted, values, progress);
  values = refine(exact_.replay, hypothesis, exchanged_.refined, values, progress);
  return gap::significanceOf(exact_, candidate,
                             joined(nulls_.gainsOf(worldOf(exact_.replay, hypothesis, candidate.values)),
                                    exchanged_nulls_.gainsOf(worldOf(exact_.replay, hypothesis, values))));
}

}  // namespace gap
