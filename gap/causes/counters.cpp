#include "gap/causes/counters.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gap/causes/kinds.h"
#include "gap/replay/comb.h"

namespace gap {

namespace {

/// What a counter counts, by the number of the effect that says how coarsely.
struct Counted {
  const char* column;      ///< of a measurement
  const char* resolution;  ///< of a profile's detection
  double model::DetectionStage::*step;
};

std::optional<Counted> countedBy(const std::string& parameter) {
  const std::map<std::string, Counted> known = {
      {"range_step_m", {"range_m", "range_resolution_m", &model::DetectionStage::range_resolution_m}},
      {"epw_step_m", {"epw_m", "epw_resolution_m", &model::DetectionStage::epw_resolution_m}},
      {"intensity_bits", {"intensity", "intensity_resolution", &model::DetectionStage::intensity_resolution_nw}}};
  const auto counted = known.find(parameter);
  return counted == known.end() ? std::nullopt : std::optional(counted->second);
}

void narrowToComb(const Replay& replay, Hypothesis& hypothesis) {
  FreeParameter& step = hypothesis.parameters.front();
  const std::optional<Comb> comb = rangeComb(replay, hypothesis.sensors);
  if (!comb || comb->step > step.high) return;
  step.start = comb->step;
  if (!comb->shown()) return;
  step.low = comb->step - comb->uncertain;
  step.high = comb->step + comb->uncertain;
  hypothesis.seen_in_values = true;
}

/// Whether any of these sensors (none named: all) reports values that are no multiples of its resolution.
bool finerThanItsProfile(const Replay& replay, const std::vector<std::string>& sensors, const Counted& counted) {
  return std::any_of(replay.samples().begin(), replay.samples().end(), [&](const ReplaySample& sample) {
    const std::string& sensor = sample.sample->sensor;
    if (!model::isOn(sensors, sensor)) return false;
    const std::vector<double>* const values = sample.measured.values(counted.column);
    const double step = replay.baseline().model.sensor(sensor).detection.*counted.step;
    return values && !lieOnSteps(*values, step);
  });
}

void leaveUnrounded(const Counted& counted, Hypothesis& hypothesis) {
  hypothesis.apply = [inner = hypothesis.apply, sensors = hypothesis.sensors, resolution = counted.resolution](
                         World& world, const std::vector<double>& values) {
    inner(world, values);
    for (const std::string& profile : profilesIn(world.model.json, sensors))
      setNumber(world, profile + "/detection/" + resolution, 0.0);
  };
}

}  // namespace

void readCounter(const Replay& replay, Hypothesis& hypothesis) {
  if (hypothesis.parameters.empty()) return;
  const std::string& parameter = hypothesis.parameters.front().name;
  const std::optional<Counted> counted = countedBy(parameter);
  if (!counted) return;
  if (parameter == "range_step_m") narrowToComb(replay, hypothesis);
  if (finerThanItsProfile(replay, hypothesis.sensors, *counted)) leaveUnrounded(*counted, hypothesis);
}

}  // namespace gap
