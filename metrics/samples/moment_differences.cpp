#include "metrics/samples/moment_differences.h"

namespace metrics {

double meanDifference(const SamplePair& samples) { return samples.simulated.mean() - samples.measured.mean(); }

double medianDifference(const SamplePair& samples) { return samples.simulated.median() - samples.measured.median(); }

double standardDeviationDifference(const SamplePair& samples) {
  return samples.simulated.standardDeviation() - samples.measured.standardDeviation();
}

}  // namespace metrics
