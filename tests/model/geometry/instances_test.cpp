#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>

#include "model/geometry/geometry_pass.h"
#include "model/geometry/ray_tracer.h"
#include "tests/support/paths.h"

// A mesh that many objects show is kept once (instances). The oracle is the same scene with a file of its own for each
// object, which shares nothing.
namespace model {
namespace {

namespace fs = std::filesystem;

constexpr int kAround = 100, kUp = 100;
constexpr std::size_t kTriangles = 2 * kAround * (kUp - 1);

/// A dented ball, different from every side.
void writeDentedBall(const fs::path& file) {
  std::ofstream out(file);
  for (int j = 0; j < kUp; ++j) {
    for (int i = 0; i < kAround; ++i) {
      const double a = 2 * std::numbers::pi * i / kAround, e = std::numbers::pi * ((j + 0.5) / kUp - 0.5);
      const double r = 1.0 + 0.2 * std::cos(3 * a) * std::cos(e) + 0.1 * std::sin(5 * e + a);
      out << "v " << 2 * r * std::cos(e) * std::cos(a) << " " << r * std::cos(e) * std::sin(a) << " "
          << 0.7 * r * std::sin(e) << "\n";
    }
  }
  for (int j = 0; j + 1 < kUp; ++j) {
    for (int i = 0; i < kAround; ++i) {
      const int a = j * kAround + i + 1, b = j * kAround + (i + 1) % kAround + 1;
      out << "f " << a << " " << b << " " << b + kAround << "\nf " << a << " " << b + kAround << " " << a + kAround
          << "\n";
    }
  }
}

/// Balls on rings around the sensor, each turned otherwise and under way, a wall behind some of them.
Scene manyBalls(std::size_t count, const std::function<fs::path(std::size_t)>& file) {
  Scene scene;
  scene.materials.emplace_back();
  scene.objects.push_back({.id = "wall", .shape = Rectangle{200.0, 40.0}, .pose = {.position_m = {90, 0, 0}}});
  for (std::size_t i = 0; i < count; ++i) {
    const double k = static_cast<double>(i), a = 2.399963 * k, r = 8.0 + 70.0 * k / static_cast<double>(count);
    SceneObject ball{.id = std::to_string(i),
                     .shape = Mesh{file(i), 1.0},
                     .pose = {.position_m = {r * std::cos(a), r * std::sin(a), std::sin(k)}}};
    ball.pose.yaw_deg = 40.0 * k;
    ball.pose.pitch_deg = 17.0 * std::sin(k);
    ball.pose.roll_deg = 11.0 * k;
    ball.velocity_m_s = {10.0 * std::cos(k), 10.0 * std::sin(2 * k), 0.0};
    scene.objects.push_back(ball);
  }
  return scene;
}

std::vector<Beam> beamsAllAround() {
  std::vector<Beam> beams;
  for (int layer = -8; layer <= 8; ++layer) {
    for (int column = 0; column < 1440; ++column) {
      Beam beam{.layer = layer, .column = column};
      beam.azimuth_rad = 2 * std::numbers::pi * column / 1440;
      beam.elevation_rad = 0.012 * layer;
      beam.scene_time_s = 0.1 * column / 1440;
      beams.push_back(beam);
    }
  }
  return beams;
}

class Instances : public testing::Test {
 protected:
  Scene shared(std::size_t count) const {
    return manyBalls(count, [&](std::size_t) { return folder_ / "ball.obj"; });
  }
  Scene apart(std::size_t count) const {
    return manyBalls(count, [&](std::size_t i) {
      const fs::path own = folder_ / ("ball-" + std::to_string(i) + ".obj");
      if (!fs::exists(own)) fs::copy_file(folder_ / "ball.obj", own);
      return own;
    });
  }
  void SetUp() override { writeDentedBall(folder_ / "ball.obj"); }

  test_support::TemporaryFolder folder_;
};

// Single precision in two frames: 1e-5 m at up to 80 m is about one step of a float. At outlines of the balls either
// may be met.
TEST_F(Instances, AreMetLikeMeshesOfTheirOwn) {
  const std::vector<Beam> beams = beamsAllAround();
  constexpr std::size_t kBalls = 12;
  const RayTracer instances(shared(kBalls), timesOf(beams)), meshes(apart(kBalls), timesOf(beams));
  EXPECT_LT(2 * instances.memory_bytes(), meshes.memory_bytes());  // it does share
  std::vector<Ray> rays;
  for (const Beam& beam : beams) rays.push_back({{0.1, 0.2, 0.3}, directionOf(beam, 0, 0), beam.scene_time_s});
  std::vector<RayHit> a(rays.size()), b(rays.size());
  instances.trace(rays, a);
  meshes.trace(rays, b);
  std::size_t on_balls = 0, otherwise = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (a[i].object != b[i].object || std::abs(a[i].range_m - b[i].range_m) > 1e-3) {
      ++otherwise;
      continue;
    }
    if (a[i].object <= 0) continue;
    ++on_balls;
    EXPECT_NEAR(a[i].range_m, b[i].range_m, 1e-4);
    EXPECT_NEAR(a[i].cos_incidence, b[i].cos_incidence, 1e-2);  // a neighbouring facet, where rounding decides
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(a[i].normal[k]), std::abs(b[i].normal[k]), 0.1);
  }
  EXPECT_GT(on_balls, 1000u);
  EXPECT_LT(otherwise, on_balls / 200);
}

TEST_F(Instances, ArePassedAndMirroredLikeMeshesOfTheirOwn) {
  const std::vector<Beam> beams = beamsAllAround();
  constexpr std::size_t kBalls = 12;
  SubRays rays;
  rays.add(0.0, 0.0, 1.0);
  SecondWays ways{.most_turns = 2, .through = std::vector<bool>(kBalls + 1), .mirrored = std::vector<bool>(kBalls + 1)};
  for (std::size_t i = 1; i <= kBalls; ++i) (i % 2 ? ways.through : ways.mirrored)[i] = true;
  const BeamHits a = traceBeams(RayTracer(shared(kBalls), timesOf(beams)), beams, rays, {}, ways);
  const BeamHits b = traceBeams(RayTracer(apart(kBalls), timesOf(beams)), beams, rays, {}, ways);
  std::size_t same = 0, otherwise = 0;
  for (std::size_t beam = 0; beam < beams.size(); ++beam) {
    const auto of_a = a.secondOf(beam), of_b = b.secondOf(beam);
    if (of_a.size() != of_b.size()) {
      ++otherwise;
      continue;
    }
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      const bool close = of_a[i].hit.object == of_b[i].hit.object &&
                         of_a[i].turns[0].object == of_b[i].turns[0].object &&
                         std::abs(of_a[i].hit.range_m - of_b[i].hit.range_m) < 0.05;  // mirrors magnify rounding
      ++(close ? same : otherwise);
    }
  }
  EXPECT_GT(same, 500u);
  EXPECT_LT(otherwise, same / 50);
}

// Three hundred times the same mesh costs little more than the mesh itself: 300 poses and a tree over them.
TEST_F(Instances, TakeTheMemoryOfOneMesh) {
  EXPECT_GT(kTriangles, 19'000u);
  const std::size_t empty = RayTracer(shared(0)).memory_bytes(), one = RayTracer(shared(1)).memory_bytes() - empty;
  EXPECT_GT(one, kTriangles * 3 * sizeof(unsigned));
  EXPECT_LT(RayTracer(shared(300)).memory_bytes() - empty, 2 * one);
}

}  // namespace
}  // namespace model
