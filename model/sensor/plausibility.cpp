#include "model/sensor/plausibility.h"

#include <algorithm>

#include "model/sensor/checks.h"

namespace model {

namespace {

constexpr checks::Check kChecks[] = {
    checks::beamWidth,  checks::fieldOfView, checks::overlap,        checks::noise,
    checks::saturation, checks::angles,      checks::layersThatMeet, checks::gapsBetweenBeams,
    checks::darkBeams,  checks::timing,      checks::reach,          checks::pulse,
    checks::steps,
};

}  // namespace

std::string toString(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      break;
  }
  return "note";
}

std::vector<Finding> plausibilityOf(const SensorProfile& sensor) {
  std::vector<Finding> findings;
  for (const checks::Check check : kChecks) check(sensor, findings);
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
  return findings;
}

}  // namespace model
