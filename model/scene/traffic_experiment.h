#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/traffic.h"

namespace model {

/// How a trace becomes an experiment.
struct TrafficExperimentOptions {
  std::string id = "traffic";
  std::string sensor = "demo-scanner";   ///< a shipped profile's id
  std::vector<std::size_t> messages{0};  ///< one sample each
  std::optional<std::string> host;       ///< id of the object that carries the sensor, in place of the trace's
  std::optional<Pose> mounting;          ///< in place of the trace's, in the host's frame
  bool refined = true;                   ///< false: bounding boxes
  bool ground = true;                    ///< a level plane below the host
  int frames = 1;
};

struct TrafficExperiment {
  nlohmann::ordered_json json;     ///< experiment.json, no measurements
  std::vector<std::string> notes;  ///< what the trace left open and how it was filled
};

/// The surroundings of the host vehicle as the sensor sees them.
///
///   sensor = host box centre + R_host · (rear axle + mounting)          (osi3::SensorView::mounting_position)
///   poses in the sensor's frame, ISO 8855; the host itself is left out: the sensor stands on it
///   velocities are those that the sensor sees, v − v_host − ω_host × (p − p_host), so that `motion-scan` distorts
///   moving objects as they appear from a moving host, with its own ego_speed_m_s left at 0; standing objects move too
///
/// Without a mounting position the sensor stands 0.2 m above the middle of the host's roof. Every message chosen is a
/// sample; those after the first replace the scene by a patch.
/// Throws InputError if the trace (`source`) names no host, or lacks a message that is asked for.
[[nodiscard]] TrafficExperiment trafficExperiment(const std::vector<TrafficFrame>& frames,
                                                  const std::filesystem::path& source,
                                                  const TrafficExperimentOptions& options = {});

}  // namespace model
