#include "acceptance/result.h"

#include <algorithm>
#include <cmath>

namespace acceptance {

namespace {

/// Errors before failures before the rest.
int severity(specs::Verdict verdict) {
  switch (verdict) {
    case specs::Verdict::Error:
      return 0;
    case specs::Verdict::Failed:
      return 1;
    case specs::Verdict::Passed:
      return 2;
    case specs::Verdict::Skipped:
      break;
  }
  return 3;
}

double relativeMargin(const SampleResult& sample) {
  if (!sample.decisive) return -HUGE_VAL;
  const double margin = sample.decisive->margin() / std::max(std::abs(sample.decisive->limit), 1e-300);
  return std::isnan(margin) ? -HUGE_VAL : margin;
}

}  // namespace

const SampleResult* TestResult::decisiveSample() const {
  const auto worst = std::min_element(samples.begin(), samples.end(), [](const SampleResult& a, const SampleResult& b) {
    if (severity(a.verdict) != severity(b.verdict)) return severity(a.verdict) < severity(b.verdict);
    return relativeMargin(a) < relativeMargin(b);
  });
  return worst == samples.end() ? nullptr : &*worst;
}

std::size_t RunResult::count(specs::Verdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(tests.begin(), tests.end(), [&](const TestResult& test) { return test.verdict == verdict; }));
}

}  // namespace acceptance
