#include "gap/candidates/cross_fit.h"

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

CrossFit::CrossFit(const Judge& quick, const Judge& exact, std::size_t runs)
    : quick_(quick),
      exact_(exact),
      exchanged_(exchanged(exact.split)),
      nulls_(exact.replay, exact.replay.baseline(), bySample(exchanged_.held_out), runs) {}

bool CrossFit::applies(const Judge& judge, const Hypothesis& hypothesis) {
  return !judge.split.weak && !hypothesis.per_setup;
}

NullRuns::Gains CrossFit::gainsOf(const Hypothesis& hypothesis, const core::Progress& progress) const {
  const Evidence& fitted = exchanged_.fitted;
  const Evidence few = spreadOver(fitted, kScoutedSamples, fitted.most_frames);
  std::vector<double> values = scout(quick_.replay, hypothesis, few, {}, progress).values;
  values = fitFrom(quick_.replay, hypothesis, fitted, values, progress);
  values = refine(exact_.replay, hypothesis, exchanged_.refined, values, progress);
  return nulls_.gainsOf(worldOf(exact_.replay, hypothesis, values));
}

}  // namespace gap
