#include "model/scene.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/physics.h"
#include "tests/model/lab.h"

namespace model {
namespace {

void expectNear(const Vector3& a, const Vector3& b) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-12);
}

// ISO 8855: yaw turns left, a positive pitch turns the nose down, a positive roll lowers the right side.
TEST(Pose, AnglesTurnAsIso8855Says) {
  expectNear(Pose{{1, 2, 3}, 90, 0, 0}.toWorld({1, 0, 0}), {1, 3, 3});
  expectNear(Pose{{0, 0, 0}, 0, 90, 0}.toWorld({1, 0, 0}), {0, 0, -1});
  expectNear(Pose{{0, 0, 0}, 0, 0, 90}.toWorld({0, 1, 0}), {0, 0, 1});
}

// p = position + Rz(yaw) · Ry(pitch) · Rx(roll) · p_local: roll comes first, yaw last.
TEST(Pose, RollComesFirstAndYawLast) {
  expectNear(Pose{{0, 0, 0}, 90, 0, 90}.toWorld({0, 1, 0}), {0, 0, 1});
  expectNear(Pose{{0, 0, 0}, 90, 90, 0}.toWorld({1, 0, 0}), {0, 0, -1});
  expectNear(Pose{{0, 0, 0}, 90, 90, 0}.toWorld({0, 0, 1}), {0, 1, 0});
}

TEST(Pose, LocalUndoesWorldAndLengthsStay) {
  const Pose pose{{3, -4, 5}, 31, -47, 118};
  const Vector3 local{0.3, -1.7, 2.2};
  expectNear(pose.toLocal(pose.toWorld(local)), local);
  const Vector3 world = pose.toWorld(local);
  EXPECT_NEAR(std::hypot(world[0] - 3, world[1] + 4, world[2] - 5), std::hypot(0.3, 1.7, 2.2), 1e-12);
}

std::string refusalOf(nlohmann::json scene, nlohmann::json materials = {{"grey", {{"reflectivity", 0.5}}}}) {
  lab::Case setup;
  setup.scene = std::move(scene);
  setup.materials = std::move(materials);
  return lab::refusal([&] { (void)lab::experimentOf(setup); });
}

TEST(Scene, FaultsAreNamedWithPointerAndRemedy) {
  using nlohmann::json;
  json misspelt = lab::board(10);
  misspelt["velocty_m_s"] = {0, 0, 0};
  EXPECT_NE(refusalOf({misspelt})
                .find("experiment.json, /scene/0/velocty_m_s: is an unknown key.\n  Did you mean 'velocity_m_s'?"),
            std::string::npos);
  json own = lab::board(10);
  own["x-note"] = "kept for myself";
  EXPECT_EQ(refusalOf({own}), "");
  EXPECT_NE(refusalOf({lab::board(10, 1, "gray")}).find("Did you mean 'grey'?"), std::string::npos);
  EXPECT_NE(refusalOf({lab::board(10), lab::board(12)}).find("/scene/1/id: 'board' stands twice"), std::string::npos);
  EXPECT_NE(
      refusalOf({lab::object("s", {{"type", "sphere"}, {"radius_m", -1}}, {1, 0, 0})}).find("/scene/0/shape/radius_m"),
      std::string::npos);
  EXPECT_NE(refusalOf({lab::object("s", {{"type", "spere"}}, {1, 0, 0})}).find("Did you mean 'sphere'?"),
            std::string::npos);
  EXPECT_NE(refusalOf({lab::object("s", {{"type", "box"}, {"size_m", {1, 0, 1}}}, {1, 0, 0})}).find("size_m"),
            std::string::npos);
  EXPECT_NE(refusalOf({}, {{"grey", {{"reflectivity", 1.5}}}}).find("/materials/grey/reflectivity"), std::string::npos);
  EXPECT_NE(refusalOf({}, {{"grey", {{"reflectivity", 0.5}, {"brdf", {{"model", "phong"}, {"exponent", 3}}}}}})
                .find("diffuse_fraction: is missing"),
            std::string::npos);
}

TEST(Scene, HalfExtentsAreThoseOfTheOwnBox) {
  expectNear(halfExtents(Box{{1, 2, 3}}), {0.5, 1, 1.5});
  expectNear(halfExtents(Sphere{2}), {2, 2, 2});
  expectNear(halfExtents(Cylinder{1, 4}), {1, 1, 2});
  expectNear(halfExtents(Rectangle{2, 3}), {0, 1, 1.5});
  EXPECT_TRUE(std::isinf(halfExtents(Plane{})[0]));
}

}  // namespace
}  // namespace model
