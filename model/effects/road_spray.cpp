#include <algorithm>
#include <cmath>
#include <memory>
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

/// Where the beam's axis passes a cluster.
struct Crossed {
  Passage way;
  double extinction_1_m;
};

/// A ball of droplets behind a vehicle, in the axes of its plume.
struct Cluster {
  double behind_m, left_m, up_m;
  double radius_m;
  double extinction_1_m;
};

struct Size {
  double length_m, width_m, height_m;
};

/// The box behind a vehicle in which its spray hangs, with axes backwards, to the left of that, and up.
struct Plume {
  Vector3 origin_m;  ///< middle of the vehicle's rear, at its lower edge, when the frame begins
  Vector3 velocity_m_s;
  Vector3 back;
  Vector3 aside;
  double strength;  ///< 1 at 100 km/h
  std::vector<Cluster> clusters;

  /// Where it stands as seen from a sensor that moves.
  [[nodiscard]] Vector3 originAt(double time_s, const ChainSettings& settings) const {
    Vector3 origin = origin_m;
    for (std::size_t k = 0; k < 3; ++k) origin[k] += (velocity_m_s[k] - settings.sensor_velocity_m_s[k]) * time_s;
    return origin;
  }
  [[nodiscard]] Vector3 placeOf(const Cluster& cluster, const Vector3& origin) const {
    return {origin[0] + cluster.behind_m * back[0] + cluster.left_m * aside[0],
            origin[1] + cluster.behind_m * back[1] + cluster.left_m * aside[1], origin[2] + cluster.up_m};
  }
  /// Whether a ray from a sensor that stands there, seen from the plume's origin, passes the box around all clusters.
  [[nodiscard]] bool crossedBy(const Vector3& direction, const Vector3& from, const Size& size) const;
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

bool Plume::crossedBy(const Vector3& direction, const Vector3& from, const Size& size) const {
  const Vector3 start = {dot(from, back), dot(from, aside), from[2]};
  const Vector3 slope = {dot(direction, back), dot(direction, aside), direction[2]};
  const Vector3 low = {-kLargestRadius_m, -size.width_m / 2.0 - kLargestRadius_m, -kLargestRadius_m};
  const Vector3 high = {size.length_m + kLargestRadius_m, size.width_m / 2.0 + kLargestRadius_m,
                        size.height_m + kLargestRadius_m};
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

double lightAt(const std::vector<Crossed>& clusters, double range_m) {
  double depth = 0.0;
  for (const Crossed& cluster : clusters) depth += cluster.extinction_1_m * cluster.way.lengthBefore_m(range_m);
  return std::exp(-2.0 * depth);
}

/// The plumes of a frame.
class Spray final : public Disturbance {
 public:
  Spray(std::vector<Plume> plumes, const Size& size) : plumes_(std::move(plumes)), size_(size) {}

  void disturb(const BeamView& view, const core::Random::Key& key, std::vector<Pulse>& pulses) const override {
    const std::vector<Crossed> crossed = crossedBy(view);
    if (crossed.empty()) return;
    for (Pulse& pulse : pulses) pulse.power_w *= lightAt(crossed, pulse.range_m);
    core::Random random(key);
    for (const Crossed& cluster : crossed) addEcho(view, cluster, crossed, random, pulses);
  }

 private:
  [[nodiscard]] std::vector<Crossed> crossedBy(const BeamView& view) const {
    std::vector<Crossed> crossed;
    const Vector3 direction = directionOf(view.beam, 0.0, 0.0), sensor_m = view.settings.sensor_position_m;
    for (const Plume& plume : plumes_) {
      const Vector3 origin = plume.originAt(view.beam.scene_time_s, view.settings);
      const Vector3 from = {sensor_m[0] - origin[0], sensor_m[1] - origin[1], sensor_m[2] - origin[2]};
      if (!plume.crossedBy(direction, from, size_)) continue;
      for (const Cluster& cluster : plume.clusters) {
        const Passage way = passageThroughSphere(sensor_m, direction, plume.placeOf(cluster, origin), cluster.radius_m);
        if (way.length_m() > 0.0) crossed.push_back({way, cluster.extinction_1_m});
      }
    }
    return crossed;
  }
  static void addEcho(const BeamView& view, const Crossed& cluster, const std::vector<Crossed>& clusters,
                      core::Random& random, std::vector<Pulse>& pulses) {
    const double chord_m = cluster.way.length_m();
    const double middle_m = 0.5 * (cluster.way.enter_m + cluster.way.leave_m);
    const double range_m =
        std::clamp(middle_m + chord_m / 6.0 * random.normal(), cluster.way.enter_m, cluster.way.leave_m);
    if (range_m < view.settings.detection.min_range_m) return;
    const double reflected_1_sr = cluster.extinction_1_m / kLidarRatioOfDroplets_sr * chord_m;
    const double power_w = view.power_constant_w_m2 * reflected_1_sr / (range_m * range_m) * openShare(view, range_m) *
                           lightAt(clusters, range_m);
    if (power_w > 0.0) pulses.push_back({range_m, power_w, false});
  }

  std::vector<Plume> plumes_;
  Size size_;
};

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
        size_{parameters.numberOr("plume_length_m", 10.0), parameters.numberOr("plume_width_m", 3.4),
              parameters.numberOr("plume_height_m", 1.5)},
        extinction_1_m_(parameters.numberOr("extinction_1_m", 0.02)),
        least_speed_m_s_(parameters.numberOr("least_speed_m_s", 50.0 / 3.6)) {}

  [[nodiscard]] bool disturbs() const override { return density_1_m3_ > 0.0; }
  [[nodiscard]] std::unique_ptr<const Disturbance> inFrame(const Scene& scene, const ChainSettings&,
                                                           const core::Random::Key& key) const override {
    std::vector<Plume> plumes;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      std::optional<Plume> plume = plumeOf(scene.objects[i]);
      if (!plume) continue;
      core::Random::Key own = key;  // a stream an object: nobody's clusters depend on what else drives
      own.beam -= static_cast<std::uint32_t>(i);
      plume->clusters = drawClusters(plume->strength, core::Random(own));
      plumes.push_back(std::move(*plume));
    }
    return std::make_unique<Spray>(std::move(plumes), size_);
  }

 private:
  [[nodiscard]] std::optional<Plume> plumeOf(const SceneObject& object) const;
  [[nodiscard]] std::vector<Cluster> drawClusters(double strength, core::Random random) const;

  double density_1_m3_;
  Size size_;
  double extinction_1_m_;
  double least_speed_m_s_;
};

std::optional<Plume> RoadSpray::plumeOf(const SceneObject& object) const {
  const Vector3& v = object.velocity_m_s;
  const double speed_m_s = std::hypot(v[0], v[1]);
  if (speed_m_s <= least_speed_m_s_ || std::holds_alternative<Plane>(object.shape)) return std::nullopt;
  const Vector3 half = halfExtents(object.shape);
  if (2.0 * std::max({half[0], half[1], half[2]}) < kSmallestVehicle_m) return std::nullopt;
  const Vector3 back = {-v[0] / speed_m_s, -v[1] / speed_m_s, 0.0};
  const double rear_m = extentAlong(object, back), low_m = extentAlong(object, {0.0, 0.0, 1.0});
  Vector3 origin = object.pose.position_m;
  for (std::size_t k = 0; k < 3; ++k) origin[k] += rear_m * back[k];
  origin[2] -= low_m;
  const double strength = (speed_m_s - least_speed_m_s_) / (kReferenceSpeed_m_s - least_speed_m_s_);
  return Plume{origin, v, back, {-back[1], back[0], 0.0}, strength, {}};
}

std::vector<Cluster> RoadSpray::drawClusters(double strength, core::Random random) const {
  const double decay_m = size_.length_m / 3.0;
  const std::uint32_t count =
      random.poisson(density_1_m3_ * size_.length_m * size_.width_m * size_.height_m * strength);
  std::vector<Cluster> clusters;
  clusters.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double behind_m = -decay_m * std::log(1.0 - random.uniform() * (1.0 - std::exp(-size_.length_m / decay_m)));
    const double left_m = size_.width_m * (random.uniform() - 0.5), up_m = size_.height_m * random.uniform();
    const double radius_m = std::min(kLargestRadius_m, std::exp(kLogRadius + kLogRadiusSpread * random.normal()));
    const double log_density = kLogDensitySpread * random.normal() - 0.5 * kLogDensitySpread * kLogDensitySpread;
    clusters.push_back({behind_m, left_m, up_m, radius_m, extinction_1_m_ * std::exp(log_density)});
  }
  return clusters;
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
