#include "model/scene/scene.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/model/lab.h"

namespace model {
namespace {

void expectNear(const Vector3& a, const Vector3& b) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-12);
}

std::string refusalOf(nlohmann::json scene) {
  lab::Case setup;
  setup.scene = std::move(scene);
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
