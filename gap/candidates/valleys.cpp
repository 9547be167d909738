#include "gap/candidates/valleys.h"

#include "gap/candidates/signature_fit.h"
#include "gap/causes/search.h"

namespace gap {

namespace {

constexpr std::size_t kBeams = 120;  // a sample
constexpr std::size_t kSamples = 4;
constexpr int kFrames = 4;
constexpr double kMostErrors = 1e6;                      // of a shift: all of them count
constexpr double kStep = 1e-3;                           // of a number's range
constexpr int kWalks = 4;                                // on, from the lowest place, while that leads on
constexpr double kPlaces[] = {0.1, 0.3, 0.5, 0.7, 0.9};  // of a number's range

}  // namespace

Valleys::Valleys(const Judge& judge)
    : few_(judge.replay.thinner(kBeams)),
      evidence_(spreadOver(judge.split.refined, kSamples, kFrames)),
      space_(few_, evidence_.samples, evidence_.most_frames, evidence_.seed, kMostErrors) {}

bool Valleys::mayHelp(const Candidate& candidate) {
  const Hypothesis& hypothesis = candidate.hypothesis;
  return hypothesis.parameters.size() > 1 && !hypothesis.per_setup && smooth(hypothesis);
}

std::vector<double> Valleys::lowestFrom(const Candidate& candidate, const core::Progress& progress) const {
  const Hypothesis& hypothesis = candidate.hypothesis;
  const Objective objective(few_, hypothesis, evidence_, progress);
  std::vector<double> lowest = candidate.values;
  const std::vector<double> unit = objective.unitOf(lowest);
  if (!mayHelp(candidate) || objective.tracesAnew(unit)) return lowest;
  const auto leftAt = [&](const std::vector<double>& values) {
    return shiftsLeftBy(space_, worldOf(few_, hypothesis, values));
  };
  double least = leftAt(lowest);
  const auto walkFrom = [&](const std::vector<double>& start) {
    std::vector<double> fitted = signatureFitFrom(few_, space_, hypothesis, start, progress, kStep);
    const double left = leftAt(fitted), gained = least - left;
    if (gained <= 0.0) return 0.0;
    least = left;
    lowest = std::move(fitted);
    return gained;
  };
  for (std::size_t i = 0; i < unit.size(); ++i) {
    for (const double place : kPlaces) {
      std::vector<double> from = unit;
      from[i] = place;
      walkFrom(objective.valuesAt(from));
    }
  }
  int walks = 0;
  while (walks < kWalks && walkFrom(lowest) > Judge::kNatsPerNumber) ++walks;
  return lowest;
}

}  // namespace gap
