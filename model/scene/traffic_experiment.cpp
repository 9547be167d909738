#include "model/scene/traffic_experiment.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "core/error.h"
#include "model/scene/refined_shapes.h"

namespace model {

namespace {

using nlohmann::ordered_json;

/// Micrometres and millionths of a degree are enough, and readable.
double rounded(double value) {
  const double result = std::round(value * 1e6) / 1e6;
  return result == 0.0 ? 0.0 : result;  // no -0
}
ordered_json jsonOf(const Vector3& v) { return {rounded(v[0]), rounded(v[1]), rounded(v[2])}; }

ordered_json jsonOf(const Pose& pose) {
  return {{"position_m", jsonOf(pose.position_m)},
          {"yaw_pitch_roll_deg", jsonOf(Vector3{pose.yaw_deg, pose.pitch_deg, pose.roll_deg})}};
}

ordered_json jsonOf(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) return {{"type", "box"}, {"size_m", jsonOf(box->size_m)}};
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    return {{"type", "sphere"}, {"radius_m", rounded(sphere->radius_m)}};
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    return {{"type", "cylinder"}, {"radius_m", rounded(cylinder->radius_m)}, {"height_m", rounded(cylinder->height_m)}};
  }
  return {{"type", "plane"}};
}

class SceneMaker {
 public:
  SceneMaker(const std::filesystem::path& source, const TrafficExperimentOptions& options)
      : source_(source), options_(options) {}

  ordered_json sceneOf(const TrafficFrame& frame, std::size_t message) {
    const std::size_t host_index = hostOf(frame, message);
    const TrafficObject& host = frame.objects[host_index];
    const Pose sensor = sensorOf(frame, host);
    ordered_json scene = ordered_json::array();
    if (options_.ground) {
      const double ground_m = host.pose.position_m[2] - host.size_m[2] / 2;
      const Pose below{{sensor.position_m[0], sensor.position_m[1], ground_m}};
      TrafficObject road{.id = "ground", .pose = below};
      add(scene, "ground", Plane{}, seenFrom(sensor, below), apparentVelocity(road, host, sensor), "asphalt");
    }
    for (std::size_t i = 0; i < frame.objects.size(); ++i) {
      if (i == host_index) continue;
      const TrafficObject& object = frame.objects[i];
      const auto parts = options_.refined ? outlineOf(object) : boxOutlineOf(object);
      for (const OutlinePart& part : parts) {
        add(scene, parts.size() == 1 ? object.id : object.id + "-" + part.name, part.shape,
            seenFrom(sensor, chained(object.pose, part.pose)), apparentVelocity(object, host, sensor), part.material);
      }
    }
    return scene;
  }

  [[nodiscard]] ordered_json materials() const {
    ordered_json json = ordered_json::object();
    for (const TrafficMaterial& material : trafficMaterials()) {
      if (used_.count(material.name)) json[material.name] = {{"reflectivity", material.reflectivity}};
    }
    return json;
  }

  [[nodiscard]] std::vector<std::string> notes() const { return {notes_.begin(), notes_.end()}; }

 private:
  void add(ordered_json& scene, const std::string& id, const Shape& shape, const Pose& pose, const Vector3& velocity,
           const std::string& material) {
    used_.insert(material);
    scene.push_back({{"id", id},
                     {"shape", jsonOf(shape)},
                     {"pose", jsonOf(pose)},
                     {"velocity_m_s", jsonOf(velocity)},
                     {"material", material}});
  }

  [[nodiscard]] std::size_t hostOf(const TrafficFrame& frame, std::size_t message) const {
    std::string known;
    for (std::size_t i = 0; i < frame.objects.size(); ++i) {
      const std::string& id = frame.objects[i].id;
      if (options_.host ? id == *options_.host : frame.host == i) return i;
      known += (known.empty() ? "" : ", ") + id;
    }
    throw core::InputError(
        {.file = source_, .item = "message " + std::to_string(message)},
        options_.host ? "has no object '" + *options_.host + "'." : "does not say which object carries the sensor.",
        "Name the host: one of " + known + ".");
  }

  Pose sensorOf(const TrafficFrame& frame, const TrafficObject& host) {
    const auto mounting = options_.mounting ? options_.mounting : frame.mounting;
    if (!mounting) {
      notes_.insert("the trace has no mounting position: the sensor stands 0.2 m above the middle of the host's roof");
      return chained(host.pose, Pose{{0.0, 0.0, host.size_m[2] / 2 + 0.2}});
    }
    if (!host.rear_axle_m) {
      notes_.insert(
          "the trace does not place the host's rear axle: the mounting position counts from its box's centre");
    }
    const Vector3 axle = host.rear_axle_m.value_or(Vector3{});
    return chained(chained(host.pose, Pose{axle}), *mounting);
  }

  /// In the sensor's axes.
  static Vector3 apparentVelocity(const TrafficObject& object, const TrafficObject& host, const Pose& sensor) {
    const Vector3 &v = object.velocity_m_s, &p = object.pose.position_m, &h = host.pose.position_m;
    const double rate = host.yaw_rate_rad_s;  // about the world's z: the rates of roll and pitch are left out
    return turnedInto(sensor, {v[0] - host.velocity_m_s[0] + rate * (p[1] - h[1]),
                               v[1] - host.velocity_m_s[1] - rate * (p[0] - h[0]), v[2] - host.velocity_m_s[2]});
  }

  const std::filesystem::path& source_;
  const TrafficExperimentOptions& options_;
  std::set<std::string> used_;
  std::set<std::string> notes_;
};

ordered_json measurands() {
  return {{{"name", "range"}, {"column", "range_m"}, {"unit", "m"}, {"scale", "ratio"}, {"resolution", 0.01}}};
}

}  // namespace

TrafficExperiment trafficExperiment(const std::vector<TrafficFrame>& frames, const std::filesystem::path& source,
                                    const TrafficExperimentOptions& options) {
  SceneMaker maker(source, options);
  ordered_json first, samples = ordered_json::array();
  for (const std::size_t message : options.messages) {
    if (message >= frames.size()) {
      throw core::InputError({.file = source}, fmt::format("has no message {}; it holds {}.", message, frames.size()),
                             "Messages are counted from 0.");
    }
    ordered_json sample{{"id", fmt::format("m{:05}", message)},
                        {"role", "validation"},
                        {"parameters", {{"time_s", frames[message].time_s}}},
                        {"frames", options.frames}};
    ordered_json scene = maker.sceneOf(frames[message], message);
    if (samples.empty()) {
      first = std::move(scene);
    } else {
      sample["patch"] = ordered_json::array({{{"op", "replace"}, {"path", "/scene"}, {"value", std::move(scene)}}});
    }
    samples.push_back(std::move(sample));
  }
  TrafficExperiment result;
  result.json = {{"format", "fidelis-experiment"},
                 {"version", 1},
                 {"id", options.id},
                 {"title", "Scene from the ground truth of " + source.filename().string()},
                 {"source", "ground truth of the ASAM OSI trace " + source.filename().string() +
                                (options.refined ? ", objects refined from their boxes" : ", bounding boxes") +
                                "; reflectivities are round figures to start from"},
                 {"sensor", options.sensor},
                 {"measurands", measurands()},
                 {"materials", maker.materials()},
                 {"scene", std::move(first)},
                 {"samples", std::move(samples)}};
  result.notes = maker.notes();
  return result;
}

}  // namespace model
