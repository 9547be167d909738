#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/effects/declarations.h"
#include "model/effects/soft_target.h"

namespace model::effects {

namespace {

constexpr double kReferenceSpeed_m_s = 100.0 / 3.6;
constexpr double kLargestRadius_m = 1.0;
constexpr double kLogRadius = -1.2, kLogRadiusSpread = 0.8;  ///< radius of a cluster is lognormal [log m]
constexpr double kLogDensitySpread = 1.1;                    ///< so is its extinction
constexpr double kSmallestVehicle_m = 1.0;                   ///< smaller things raise no plume of their own
constexpr Vector3 kHalfMesh_m = {2.2, 0.9, 0.75};            ///< of a vehicle whose size the scene does not tell

struct Cluster {
  Passage way;
  double extinction_1_m;
};

/// The box behind a vehicle in which its spray hangs, with axes backwards, to the left of that, and up.
struct Plume {
  Vector3 origin_m;  ///< middle of the vehicle's rear, at its lower edge
  Vector3 back;
  Vector3 aside;
  double strength;  ///< 1 at 100 km/h

  [[nodiscard]] Vector3 place(double behind_m, double left_m, double up_m) const {
    return {origin_m[0] + behind_m * back[0] + left_m * aside[0], origin_m[1] + behind_m * back[1] + left_m * aside[1],
            origin_m[2] + up_m};
  }
};

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// How far the object reaches from its middle in a direction.
double extentAlong(const SceneObject& object, const Vector3& direction) {
  Vector3 half = halfExtents(object.shape);
  if (!std::isfinite(half[0])) half = kHalfMesh_m;
  const std::array<Vector3, 3> rows = object.pose.rotation();
  double extent = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    extent += half[k] * std::abs(rows[0][k] * direction[0] + rows[1][k] * direction[1] + rows[2][k] * direction[2]);
  }
  return extent;
}

/// Behind vehicles that are faster than a speed on a wet road clusters of droplets hang in a box as long as the plume.
/// They belong to the frame: all its beams meet the same ones.
///
///   number  Poisson, mean density · L W H · (v - v_0) / (100 km/h - v_0)
///   place   uniform over width and height; behind the vehicle exponential with a third of L, cut off at L
///   radius  lognormal (log -1.2, spread 0.8), at most 1 m; extinction lognormal with the given mean, spread 1.1
///   what lies behind is weakened by exp(-2 α l), l chord of the beam's axis in the cluster
///   echo    η A_r P_t · (α/S) l / r² at a normal range around the middle of the chord, deviation l/6
///
/// S is that of droplets (soft_target.h). A vehicle is a moving object longer than 1 m in some direction that is no
/// plane; of a mesh, whose size the scene does not tell, 4.4 m × 1.8 m × 1.5 m around its origin. The plume follows its
/// vehicle within the frame.
/// Source: Linnhoff et al. 2022, Simulating Road Spray Effects in Automotive Lidar Sensor Models, arXiv:2212.08558
/// (clusters, their sizes, weakening, echo ranges and growth with speed, calibrated to measurements).
class RoadSpray final : public Effect {
 public:
  explicit RoadSpray(const EffectParameters& parameters)
      : density_1_m3_(parameters.numberOr("density", 1.0)),
        length_m_(parameters.numberOr("plume_length_m", 10.0)),
        width_m_(parameters.numberOr("plume_width_m", 3.4)),
        height_m_(parameters.numberOr("plume_height_m", 1.5)),
        extinction_1_m_(parameters.numberOr("extinction_1_m", 0.02)),
        least_speed_m_s_(parameters.numberOr("least_speed_m_s", 50.0 / 3.6)) {}

  [[nodiscard]] bool disturbs() const override { return density_1_m3_ > 0.0; }
  void disturb(const BeamView& view, const core::Random::Key& key, std::vector<Pulse>& pulses) const override {
    const Vector3 direction = directionOf(view.beam, 0.0, 0.0);
    std::vector<Cluster> clusters;
    for (std::size_t i = 0; i < view.scene.objects.size(); ++i) {
      const std::optional<Plume> plume = plumeOf(view.scene.objects[i], view);
      if (!plume || !crosses(*plume, view.settings.sensor_position_m, direction)) continue;
      core::Random::Key shared = key;  // a stream an object: nobody's clusters depend on whether others are crossed
      shared.beam = kWholeFrame - static_cast<std::uint32_t>(i);
      core::Random random(shared);
      drawClusters(*plume, view.settings.sensor_position_m, direction, random, clusters);
    }
    if (clusters.empty()) return;
    for (Pulse& pulse : pulses) pulse.power_w *= lightAt(clusters, pulse.range_m);
    core::Random random(key);
    for (const Cluster& cluster : clusters) addEcho(view, cluster, clusters, random, pulses);
  }

 private:
  [[nodiscard]] std::optional<Plume> plumeOf(const SceneObject& object, const BeamView& view) const;
  [[nodiscard]] bool crosses(const Plume& plume, const Vector3& sensor_m, const Vector3& direction) const;
  void drawClusters(const Plume& plume, const Vector3& sensor_m, const Vector3& direction, core::Random& random,
                    std::vector<Cluster>& out) const;

  static double lightAt(const std::vector<Cluster>& clusters, double range_m) {
    double depth = 0.0;
    for (const Cluster& cluster : clusters) depth += cluster.extinction_1_m * cluster.way.lengthBefore_m(range_m);
    return std::exp(-2.0 * depth);
  }
  static void addEcho(const BeamView& view, const Cluster& cluster, const std::vector<Cluster>& clusters,
                      core::Random& random, std::vector<Pulse>& pulses) {
    const double chord_m = cluster.way.length_m();
    const double middle_m = 0.5 * (cluster.way.enter_m + cluster.way.leave_m);
    const double range_m =
        std::clamp(middle_m + chord_m / 6.0 * random.normal(), cluster.way.enter_m, cluster.way.leave_m);
    if (range_m < view.settings.detection.min_range_m) return;
    const double reflected_1_sr = cluster.extinction_1_m / kLidarRatioOfDroplets_sr * chord_m;
    const double power_w = view.power_constant_w_m2 * reflected_1_sr / (range_m * range_m) * openShare(view, range_m) *
                           lightAt(clusters, range_m);
    if (power_w > 0.0) pulses.push_back({range_m, power_w});
  }

  double density_1_m3_;
  double length_m_;
  double width_m_;
  double height_m_;
  double extinction_1_m_;
  double least_speed_m_s_;
};

std::optional<Plume> RoadSpray::plumeOf(const SceneObject& object, const BeamView& view) const {
  const Vector3& v = object.velocity_m_s;
  const double speed_m_s = std::hypot(v[0], v[1]);
  if (speed_m_s <= least_speed_m_s_ || std::holds_alternative<Plane>(object.shape)) return std::nullopt;
  const Vector3 half = halfExtents(object.shape);
  if (2.0 * std::max({half[0], half[1], half[2]}) < kSmallestVehicle_m) return std::nullopt;
  const Vector3 back = {-v[0] / speed_m_s, -v[1] / speed_m_s, 0.0};
  const double rear_m = extentAlong(object, back), low_m = extentAlong(object, {0.0, 0.0, 1.0});
  Vector3 origin = object.pose.position_m;
  for (std::size_t k = 0; k < 3; ++k) {
    origin[k] += rear_m * back[k] + (v[k] - view.settings.sensor_velocity_m_s[k]) * view.beam.scene_time_s;
  }
  origin[2] -= low_m;
  const double strength = (speed_m_s - least_speed_m_s_) / (kReferenceSpeed_m_s - least_speed_m_s_);
  return Plume{origin, back, {-back[1], back[0], 0.0}, strength};
}

/// Whether the ray passes the box around all clusters.
bool RoadSpray::crosses(const Plume& plume, const Vector3& sensor_m, const Vector3& direction) const {
  const Vector3 from = {sensor_m[0] - plume.origin_m[0], sensor_m[1] - plume.origin_m[1],
                        sensor_m[2] - plume.origin_m[2]};
  const Vector3 up = {0.0, 0.0, 1.0};
  const Vector3 start = {dot(from, plume.back), dot(from, plume.aside), from[2]};
  const Vector3 slope = {dot(direction, plume.back), dot(direction, plume.aside), dot(direction, up)};
  const Vector3 low = {-kLargestRadius_m, -width_m_ / 2.0 - kLargestRadius_m, -kLargestRadius_m};
  const Vector3 high = {length_m_ + kLargestRadius_m, width_m_ / 2.0 + kLargestRadius_m, height_m_ + kLargestRadius_m};
  double enter = 0.0, leave = 1e9;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(slope[k]) < 1e-12) {
      if (start[k] < low[k] || start[k] > high[k]) return false;
      continue;
    }
    const double a = (low[k] - start[k]) / slope[k], b = (high[k] - start[k]) / slope[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave;
}

void RoadSpray::drawClusters(const Plume& plume, const Vector3& sensor_m, const Vector3& direction,
                             core::Random& random, std::vector<Cluster>& out) const {
  const double decay_m = length_m_ / 3.0;
  const std::uint32_t count = random.poisson(density_1_m3_ * length_m_ * width_m_ * height_m_ * plume.strength);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double behind_m = -decay_m * std::log(1.0 - random.uniform() * (1.0 - std::exp(-length_m_ / decay_m)));
    const double left_m = width_m_ * (random.uniform() - 0.5), up_m = height_m_ * random.uniform();
    const double radius_m = std::min(kLargestRadius_m, std::exp(kLogRadius + kLogRadiusSpread * random.normal()));
    const double log_density = kLogDensitySpread * random.normal() - 0.5 * kLogDensitySpread * kLogDensitySpread;
    const Passage way = passageThroughSphere(sensor_m, direction, plume.place(behind_m, left_m, up_m), radius_m);
    if (way.length_m() > 0.0) out.push_back({way, extinction_1_m_ * std::exp(log_density)});
  }
}

}  // namespace

EffectEntry roadSpray() {
  return {
      .info = {.name = "road-spray",
               .title = "Spray behind vehicles on a wet road",
               .summary = "Wheels on a wet road throw up water, which gives clusters of false echoes behind vehicles.",
               .stage = Stage::kPropagation,
               .percollect = {"94", "141"},
               .parameters =
                   {{"density", "1/m³", 0.0, 10.0, 1.0, "Clusters per volume of the plume at 100 km/h", true, 1.0},
                    {"plume_length_m", "m", 1.0, 50.0, 10.0, "Length of the plume behind the vehicle", false, 10.0},
                    {"plume_width_m", "m", 0.5, 6.0, 3.4, "Its width", false, 3.4},
                    {"plume_height_m", "m", 0.2, 5.0, 1.5, "Its height above the vehicle's lower edge", false, 1.5},
                    {"extinction_1_m", "1/m", 0.001, 1.0, 0.02, "Mean extinction inside a cluster", true, 0.02},
                    {"least_speed_m_s", "m/s", 1.0, 25.0, 50.0 / 3.6, "Speed from which on a vehicle raises spray",
                     false, 50.0 / 3.6}},
               .fitted = {"density", "extinction_1_m"},
               .source = "Linnhoff et al. 2022, arXiv:2212.08558"},
      .make = makeFrom<RoadSpray>};
}

}  // namespace model::effects
