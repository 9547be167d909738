#include "model/scene/traffic.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

#include "model/experiment.h"
#include "model/scene/mesh.h"
#include "model/scene/refined_shapes.h"
#include "model/scene/traffic_experiment.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

// A trace is written here byte by byte, after the wire format of protocol buffers and the field numbers of OSI 3, and
// without the reader's generated code.
std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value > 127; value >>= 7) bytes += static_cast<char>((value & 127) | 128);
  return bytes + static_cast<char>(value);
}
std::string number(int field, std::uint64_t value) { return varint(field << 3) + varint(value); }
std::string real(int field, double value) {
  std::string bytes = varint(field << 3 | 1);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}
std::string message(int field, const std::string& content) {
  return varint(field << 3 | 2) + varint(content.size()) + content;
}
std::string three(const Vector3& v) { return real(1, v[0]) + real(2, v[1]) + real(3, v[2]); }

struct Moving {
  std::uint64_t id = 0;
  Vector3 size_m{4.5, 1.8, 1.5};
  Vector3 position_m{};
  Vector3 roll_pitch_yaw_rad{};
  Vector3 velocity_m_s{};
  double yaw_rate_rad_s = 0.0;
  int type = 2;  ///< vehicle
};
std::string movingObject(const Moving& m) {
  return message(5,
                 message(1, number(1, m.id)) +
                     message(2, message(1, three(m.size_m)) + message(2, three(m.position_m)) +
                                    message(3, three(m.roll_pitch_yaw_rad)) + message(4, three(m.velocity_m_s)) +
                                    message(6, three({0, 0, m.yaw_rate_rad_s}))) +
                     number(3, m.type) +
                     message(5, real(2, 0.3) + message(4, three({-1.2, 0, -0.4})) + message(5, three({1.4, 0, -0.4}))) +
                     message(6, number(1, 4)));
}
std::string groundTruth(const std::vector<Moving>& objects, std::uint64_t host) {
  std::string truth = message(2, number(1, 3) + number(2, 250'000'000)) + message(3, number(1, host));
  for (const Moving& object : objects) truth += movingObject(object);
  return truth;
}
std::string framed(const std::string& content) {
  const auto length = static_cast<std::uint32_t>(content.size());
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  return bytes + content;
}
std::string view(const std::string& truth, const Vector3& mounting, double mounting_yaw_rad = 0.0) {
  return message(4, message(1, three(mounting)) + message(2, real(3, mounting_yaw_rad))) + message(7, truth);
}

void expectNear(const Vector3& a, const Vector3& b, double tolerance = 1e-9) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << k;
}

Scene sceneOf(const TrafficExperiment& made) {
  const Experiment experiment = parseExperiment(made.json, "experiment.json");
  return situationOf(experiment, experiment.samples.at(0)).scene;
}
const SceneObject& object(const Scene& scene, const std::string& id) {
  for (const SceneObject& candidate : scene.objects) {
    if (candidate.id == id) return candidate;
  }
  throw std::runtime_error("no object " + id);
}

// Host at (100, 50), heading +y (yaw 90°); the sensor 2 m before its rear axle, 1 m above. A car 20 m further along +y
// and 3 m to the west (-x) is ahead and to the left. By hand: rear axle at (100, 50 - 1.2, 0.75 - 0.4), sensor at
// (100, 50.8, 1.35); the car's centre at (97, 70, 0.75) lies 19.2 m ahead, 3 m left, 0.6 m lower.
TEST(Traffic, PlacesAreThoseSeenFromTheMountedSensor) {
  const test_support::TemporaryFolder folder;
  const Moving host{.id = 7, .position_m = {100, 50, 0.75}, .roll_pitch_yaw_rad = {0, 0, M_PI / 2}};
  const Moving car{.id = 9, .position_m = {97, 70, 0.75}, .roll_pitch_yaw_rad = {0, 0, M_PI}};
  const auto file = folder.write("a_sv.osi", framed(view(groundTruth({host, car}, 7), {2, 0, 1})));
  const auto frames = readTraffic(file);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_NEAR(frames[0].time_s, 3.25, 1e-12);
  const Scene scene = sceneOf(trafficExperiment(frames, file, {.refined = false}));
  ASSERT_EQ(scene.objects.size(), 2U);  // the host is left out, the ground comes in
  const Pose& pose = object(scene, "moving-9").pose;
  expectNear(pose.position_m, {19.2, 3.0, -0.6}, 1e-6);
  EXPECT_NEAR(pose.yaw_deg, 90.0, 1e-6);                                 // it looks west, the sensor north
  EXPECT_NEAR(object(scene, "ground").pose.position_m[2], -1.35, 1e-6);  // the host's box ends at z = 0
}

// A sensor that is itself turned: the frame of the whole scene turns the other way, lengths stay.
TEST(Traffic, TurnedMountingTurnsTheSceneTheOtherWay) {
  const Moving host{.id = 1}, car{.id = 2, .position_m = {10, 0, 0}};
  const test_support::TemporaryFolder folder;
  const auto file = folder.write("a.osi", framed(view(groundTruth({host, car}, 1), {1.2, 0, 0.4}, M_PI / 2)));
  const Scene scene = sceneOf(trafficExperiment(readTraffic(file), file, {.refined = false, .ground = false}));
  expectNear(scene.objects.at(0).pose.position_m, {0, -10, 0}, 1e-6);  // looking left, the car ahead is to the right
  EXPECT_NEAR(scene.objects.at(0).pose.yaw_deg, -90.0, 1e-6);
}

// v − v_host − ω × (p − p_host): host at 10 m/s along +x turning left at 0.1 rad/s, a car 20 m ahead at 15 m/s. ω × r =
// 0.1 · 20 m/s to the left, so the car seems to slide 2 m/s to the right.
TEST(Traffic, VelocitiesAreThoseThatTheSensorSees) {
  const Moving host{.id = 1, .velocity_m_s = {10, 0, 0}, .yaw_rate_rad_s = 0.1};
  const Moving car{.id = 2, .position_m = {20, 0, 0}, .velocity_m_s = {15, 0, 0}};
  const test_support::TemporaryFolder folder;
  const auto file = folder.write("a.osi", framed(view(groundTruth({host, car}, 1), {0, 0, 0})));
  const Scene scene = sceneOf(trafficExperiment(readTraffic(file), file, {.refined = false}));
  expectNear(object(scene, "moving-2").velocity_m_s, {5, -2, 0}, 1e-6);
  // The sensor stands on the rear axle, 1.2 m behind the host's centre, and so swings 0.12 m/s to the right.
  expectNear(object(scene, "ground").velocity_m_s, {-10, 0.12, 0}, 1e-6);
}

TEST(Traffic, GroundTruthAloneIsReadToo) {
  const test_support::TemporaryFolder folder;
  const std::string truth = groundTruth({{.id = 1}, {.id = 2, .position_m = {9, 0, 0}, .type = 3}}, 1);
  const auto frames = readTraffic(folder.write("a_gt.osi", framed(truth) + framed(truth)));
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[1].host, std::optional<std::size_t>(0));
  EXPECT_EQ(frames[1].objects.at(1).kind, TrafficKind::kPedestrian);
  EXPECT_FALSE(frames[1].mounting.has_value());
}

TEST(Traffic, FaultsAreNamedWithTheMessage) {
  const test_support::TemporaryFolder folder;
  const std::string good = framed(view(groundTruth({{.id = 1}}, 1), {}));
  const auto refusal = [&](const std::string& content) {
    return lab::refusal([&] { (void)readTraffic(folder.write("x.osi", content)); });
  };
  EXPECT_NE(refusal(good + good.substr(0, good.size() - 3)).find("message 1: is cut off"), std::string::npos);
  EXPECT_NE(refusal("").find("holds no message"), std::string::npos);
  EXPECT_NE(refusal("{\"format\": \"fidelis-experiment\"}").find("no OSI trace"), std::string::npos);
  EXPECT_NE(refusal(framed(message(2, number(1, 5)))).find("no osi3::GroundTruth with objects"), std::string::npos);
  EXPECT_NE(refusal(framed(groundTruth({{.id = 4, .size_m = {4, 0, 1}}}, 4))).find("object 'moving-4' has a bounding"),
            std::string::npos);
  EXPECT_NE(refusal(framed(groundTruth({{.id = 4, .position_m = {std::nan(""), 0, 1}}}, 4))).find("not a finite"),
            std::string::npos);
  const auto file = folder.write("nohost.osi", framed(view(groundTruth({{.id = 1}, {.id = 2}}, 77), {})));
  const auto frames = readTraffic(file);
  EXPECT_NE(lab::refusal([&] { (void)trafficExperiment(frames, file); }).find("one of moving-1, moving-2"),
            std::string::npos);
  EXPECT_EQ(lab::refusal([&] { (void)trafficExperiment(frames, file, {.host = "moving-2"}); }), "");
  EXPECT_NE(lab::refusal([&] { (void)trafficExperiment(frames, file, {.messages = {3}}); }).find("it holds 1"),
            std::string::npos);
}

/// Lowest and highest corner of all parts together, from the vertices of their own triangles.
std::pair<Vector3, Vector3> boundsOf(const std::vector<OutlinePart>& parts) {
  Vector3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  for (const OutlinePart& part : parts) {
    std::vector<Vector3> points = trianglesOf(part.shape).vertices;
    if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (const double sign : {-1.0, 1.0}) {
          Vector3 point{};
          point[k] = sign * sphere->radius_m;
          points.push_back(point);
        }
      }
    }
    for (const Vector3& point : points) {
      const Vector3 at = part.pose.toWorld(point);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
  }
  return {low, high};
}

// What the trace states must survive the refinement: no part outside the bounding box, and for vehicles all six sides
// of it touched (a body, a roof, wheels on the ground).
TEST(RefinedShapes, UnionKeepsTheBoundingBox) {
  for (int kind = 0; kind <= static_cast<int>(TrafficKind::kOther); ++kind) {
    TrafficObject thing{.kind = static_cast<TrafficKind>(kind), .size_m = {4.5, 1.8, 1.5}};
    const bool slim = thing.kind == TrafficKind::kPedestrian || thing.kind == TrafficKind::kPole;
    if (slim) thing.size_m = {0.6, 0.6, 1.75};
    if (thing.kind == TrafficKind::kTwoWheeler) thing.size_m = {1.8, 0.6, 1.7};
    const auto [low, high] = boundsOf(outlineOf(thing));
    const bool crowned = thing.kind == TrafficKind::kTree;
    for (std::size_t k = 0; k < 3; ++k) {
      const double half = thing.size_m[k] / 2;
      EXPECT_LE(high[k], half + 1e-9) << toString(thing.kind) << " axis " << k;
      EXPECT_GE(low[k], -half - 1e-9) << toString(thing.kind) << " axis " << k;
      if (crowned && k < 2) continue;  // a crown is round, its box need not be
      EXPECT_NEAR(high[k], half, 1e-3) << toString(thing.kind) << " axis " << k;
      EXPECT_NEAR(low[k], -half, 1e-3) << toString(thing.kind) << " axis " << k;
    }
  }
}

TEST(RefinedShapes, PartsNameKnownMaterialsAndSpeakOfThemselvesOnce) {
  for (int kind = 0; kind <= static_cast<int>(TrafficKind::kOther); ++kind) {
    std::set<std::string> names;
    for (const OutlinePart& part : outlineOf({.kind = static_cast<TrafficKind>(kind), .size_m = {4, 2, 1.5}})) {
      EXPECT_TRUE(names.insert(part.name).second) << part.name;
      const auto& known = trafficMaterials();
      EXPECT_TRUE(std::any_of(known.begin(), known.end(), [&](const auto& m) { return m.name == part.material; }));
    }
  }
}

TEST(RefinedShapes, WheelsStandAtTheAxlesOfTheTrace) {
  TrafficObject car{.kind = TrafficKind::kCar, .size_m = {4.5, 1.8, 1.5}};
  car.rear_axle_m = {-1.2, 0, -0.4};
  car.front_axle_m = {1.4, 0, -0.4};
  car.wheel_radius_m = 0.3;
  int wheels = 0;
  for (const OutlinePart& part : outlineOf(car)) {
    if (part.material != "tyre") continue;
    ++wheels;
    EXPECT_NEAR(part.pose.position_m[0], part.name.find("rear") != std::string::npos ? -1.2 : 1.4, 1e-12);
    EXPECT_NEAR(part.pose.position_m[2], 0.3 - 0.75, 1e-12);
    EXPECT_NEAR(std::get<Cylinder>(part.shape).radius_m, 0.3, 1e-12);
  }
  EXPECT_EQ(wheels, 4);
}

/// Places and ranges of the traces were read off a dump of their bytes (field numbers and doubles), not with this
/// reader.
TEST(Traffic, RecordedTracesBecomeScenes) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto osi = shared / "data/formats/osi";
  const auto two = readTraffic(osi / "openmaterial3d_sv_360_two_vehicles.osi");
  EXPECT_EQ(two.size(), 140U);
  ASSERT_EQ(two[0].objects.size(), 2U);
  expectNear(two[0].objects[0].size_m, {3.8540000915527344, 1.6180000305175781, 1.2960000038146973});
  expectNear(two[0].objects[1].pose.position_m, {13.53194566440389, 3.1922046801672397, 0.6470000147819519});
  const auto sl13 = readTraffic(osi / "openmsl_sl13_sv_340_300.osi");
  EXPECT_EQ(sl13.size(), 150U);
  // Host (id 1) at x = 10 m without yaw, the other car at 20 m, 2 m to the right; the sensor over the host's roof.
  const auto made = trafficExperiment(sl13, "a.osi", {.refined = false});
  EXPECT_EQ(made.notes.size(), 1U);
  expectNear(object(sceneOf(made), "moving-0").pose.position_m, {10.0, -2.0, -0.75 - 0.2}, 1e-6);
  const auto sv = readTraffic(osi / "openmsl_sv_350_100.osi");
  // Host (id 0) at x = 10 m, rear axle 1.146 m behind and 0.317 m below; mounting 0.5 m ahead of it; car at 25 m.
  expectNear(object(sceneOf(trafficExperiment(sv, "b.osi", {.refined = false})), "moving-3").pose.position_m,
             {25.0 - (10.0 - 1.146 + 0.5), 0.0, 0.317}, 1e-6);
  for (const char* name : {"osi_validation_minimal_valid.osi", "qc_invalid_version.osi"}) {
    EXPECT_EQ(lab::refusal([&] { (void)sceneOf(trafficExperiment(readTraffic(osi / name), name)); }), "") << name;
  }
}

}  // namespace
}  // namespace model
