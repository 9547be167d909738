#pragma once

#include <vector>

#include "model/sensor/plausibility.h"

namespace model::checks {

/// One check looks at one thing and adds what it finds. A new check is a line here and one in plausibility.cpp.
using Check = void (*)(const SensorProfile& sensor, std::vector<Finding>& findings);

// scan_checks.cpp: where and when beams are fired
void angles(const SensorProfile& sensor, std::vector<Finding>& findings);
void layersThatMeet(const SensorProfile& sensor, std::vector<Finding>& findings);
void gapsBetweenBeams(const SensorProfile& sensor, std::vector<Finding>& findings);
void darkBeams(const SensorProfile& sensor, std::vector<Finding>& findings);
void timing(const SensorProfile& sensor, std::vector<Finding>& findings);

// power_checks.cpp: what comes back, and what is made of it
void beamWidth(const SensorProfile& sensor, std::vector<Finding>& findings);
void fieldOfView(const SensorProfile& sensor, std::vector<Finding>& findings);
void overlap(const SensorProfile& sensor, std::vector<Finding>& findings);
void noise(const SensorProfile& sensor, std::vector<Finding>& findings);
void saturation(const SensorProfile& sensor, std::vector<Finding>& findings);
void reach(const SensorProfile& sensor, std::vector<Finding>& findings);
void pulse(const SensorProfile& sensor, std::vector<Finding>& findings);
void steps(const SensorProfile& sensor, std::vector<Finding>& findings);

}  // namespace model::checks
