#include "model/geometry/ray_tracer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <optional>

#include "core/physics.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

struct Expected {
  double range_m;
  double cos_incidence;
};

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 directionOf(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad), std::cos(elevation_rad) * std::sin(azimuth_rad),
          std::sin(elevation_rad)};
}

/// Rotates about one axis by the right-hand rule: written out again, independent of Pose.
Vector3 turned(const Vector3& v, int axis, double angle_deg) {
  const double c = std::cos(angle_deg * core::kRadPerDeg), s = std::sin(angle_deg * core::kRadPerDeg);
  if (axis == 0) return {v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]};
  if (axis == 1) return {c * v[0] + s * v[2], v[1], -s * v[0] + c * v[2]};
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

/// A pose rolls first, then pitches, then yaws (ISO 8855); this undoes it.
Vector3 unposed(const Vector3& v, const Pose& pose) {
  return turned(turned(turned(v, 2, -pose.yaw_deg), 1, -pose.pitch_deg), 0, -pose.roll_deg);
}

/// Ray from the origin in the object's own frame.
struct LocalRay {
  Vector3 o, d;
};
LocalRay localRay(const Vector3& direction, const Pose& pose) {
  const Vector3& p = pose.position_m;
  return {unposed({-p[0], -p[1], -p[2]}, pose), unposed(direction, pose)};
}

std::optional<Expected> meetSphere(const LocalRay& ray, double radius) {
  const double b = dot(ray.o, ray.d), c = dot(ray.o, ray.o) - radius * radius;
  if (b * b < c) return std::nullopt;
  const double t = -b - std::sqrt(b * b - c);
  const Vector3 n = {ray.o[0] + t * ray.d[0], ray.o[1] + t * ray.d[1], ray.o[2] + t * ray.d[2]};
  return Expected{t, std::abs(dot(n, ray.d)) / radius};
}

std::optional<Expected> meetCylinder(const LocalRay& ray, double radius, double height) {
  std::optional<Expected> first;
  const auto keep = [&](double t, double cosine) {
    if (t > 0 && (!first || t < first->range_m)) first = Expected{t, cosine};
  };
  const double a = ray.d[0] * ray.d[0] + ray.d[1] * ray.d[1];
  const double b = ray.o[0] * ray.d[0] + ray.o[1] * ray.d[1];
  const double c = ray.o[0] * ray.o[0] + ray.o[1] * ray.o[1] - radius * radius;
  if (b * b > a * c) {
    const double t = (-b - std::sqrt(b * b - a * c)) / a;
    if (std::abs(ray.o[2] + t * ray.d[2]) <= height / 2) {
      const double x = ray.o[0] + t * ray.d[0], y = ray.o[1] + t * ray.d[1];
      keep(t, std::abs(x * ray.d[0] + y * ray.d[1]) / radius);
    }
  }
  for (const double lid : {-height / 2, height / 2}) {
    const double t = (lid - ray.o[2]) / ray.d[2];
    const double x = ray.o[0] + t * ray.d[0], y = ray.o[1] + t * ray.d[1];
    if (x * x + y * y <= radius * radius) keep(t, std::abs(ray.d[2]));
  }
  return first;
}

std::optional<Expected> meetBox(const LocalRay& ray, const Vector3& size) {
  double enter = 0.0, leave = 1e300;
  std::size_t axis = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double t0 = (-size[k] / 2 - ray.o[k]) / ray.d[k], t1 = (size[k] / 2 - ray.o[k]) / ray.d[k];
    if (t0 > t1) std::swap(t0, t1);
    if (t0 > enter) {
      enter = t0;
      axis = k;
    }
    leave = std::min(leave, t1);
  }
  if (enter >= leave) return std::nullopt;
  return Expected{enter, std::abs(ray.d[axis])};
}

std::optional<Expected> meetRectangle(const LocalRay& ray, double width, double height) {
  const double t = -ray.o[0] / ray.d[0];
  const double y = ray.o[1] + t * ray.d[1], z = ray.o[2] + t * ray.d[2];
  if (t <= 0 || std::abs(y) > width / 2 || std::abs(z) > height / 2) return std::nullopt;
  return Expected{t, std::abs(ray.d[0])};
}

std::optional<Expected> meetPlane(const LocalRay& ray) {
  const double t = -ray.o[2] / ray.d[2];
  return t > 0 ? std::optional(Expected{t, std::abs(ray.d[2])}) : std::nullopt;
}

RayHit traced(const Shape& shape, const Pose& pose, const Vector3& direction) {
  Scene scene;
  scene.materials.push_back({.name = "m"});
  scene.objects.push_back({.id = "o", .shape = shape, .pose = pose});
  const RayTracer tracer(scene);
  const Ray ray{{}, direction};
  RayHit hit;
  tracer.trace({&ray, 1}, {&hit, 1});
  return hit;
}

/// Shoots a fan of rays around the object; edges (where a hundredth of a degree decides) are allowed to differ.
template <typename Meet>
void expectAgreement(const Shape& shape, const Pose& pose, double spread_rad, double range_tolerance_m,
                     double cos_tolerance, const Meet& meet) {
  const Vector3& p = pose.position_m;
  const double azimuth = std::atan2(p[1], p[0]), elevation = std::atan2(p[2], std::hypot(p[0], p[1]));
  Scene scene;
  scene.objects.push_back({.id = "o", .shape = shape, .pose = pose});
  const RayTracer tracer(scene);
  std::vector<Ray> rays;
  for (int i = -20; i <= 20; ++i) {
    for (int k = -20; k <= 20; ++k) {
      rays.push_back({{}, directionOf(azimuth + spread_rad * i / 19.7, elevation + spread_rad * k / 19.3)});
    }
  }
  std::vector<RayHit> hits(rays.size());
  tracer.trace(rays, hits);
  int hit_count = 0, edge_count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto expected = meet(localRay(rays[i].direction, pose));
    if (expected.has_value() != (hits[i].object == 0)) {
      ++edge_count;
      continue;
    }
    if (!expected) continue;
    ++hit_count;
    if (std::abs(hits[i].cos_incidence - expected->cos_incidence) > 0.2) {  // the other side of an edge
      ++edge_count;
      continue;
    }
    if (expected->cos_incidence < 0.1) continue;  // grazing: the range itself is ill-conditioned
    EXPECT_NEAR(hits[i].range_m, expected->range_m, range_tolerance_m);
    EXPECT_NEAR(hits[i].cos_incidence, expected->cos_incidence, cos_tolerance);
  }
  EXPECT_GT(hit_count, 200);
  EXPECT_LE(edge_count, 8);
}

const Pose kOblique{{18.0, 6.0, 2.0}, 33.0, -21.0, 48.0};

TEST(RayTracer, SphereIsMetWhereGeometrySays) {
  expectAgreement(Sphere{1.5}, kOblique, 0.09, 1e-9, 1e-9, [](const LocalRay& ray) { return meetSphere(ray, 1.5); });
}

TEST(RayTracer, CylinderIsMetWhereGeometrySays) {
  expectAgreement(Cylinder{0.8, 2.5}, kOblique, 0.09, 1e-9, 1e-9,
                  [](const LocalRay& ray) { return meetCylinder(ray, 0.8, 2.5); });
}

TEST(RayTracer, BoxIsMetWhereGeometrySays) {
  expectAgreement(Box{{2.0, 1.2, 1.7}}, kOblique, 0.09, 1e-9, 1e-9, [](const LocalRay& ray) {
    return meetBox(ray, {2.0, 1.2, 1.7});
  });
}

TEST(RayTracer, RectangleIsMetWhereGeometrySays) {
  expectAgreement(Rectangle{2.0, 3.0}, kOblique, 0.09, 1e-9, 1e-9,
                  [](const LocalRay& ray) { return meetRectangle(ray, 2.0, 3.0); });
}

TEST(RayTracer, PlaneIsMetWhereGeometrySays) {
  expectAgreement(Plane{}, kOblique, 0.09, 1e-9, 1e-9, [](const LocalRay& ray) { return meetPlane(ray); });
}

// A road seen from 1.5 m above, up to 170 m away at a grazing angle of half a degree.
TEST(RayTracer, GroundPlaneIsMetFarAway) {
  for (const double down_deg : {0.5, 1.0, 2.0, 5.0, 20.0, 89.0}) {
    const double s = std::sin(down_deg * core::kRadPerDeg);
    const RayHit hit = traced(Plane{}, {{0, 0, -1.5}}, directionOf(0.3, -down_deg * core::kRadPerDeg));
    ASSERT_EQ(hit.object, 0);
    EXPECT_NEAR(hit.range_m, 1.5 / s, 1e-9);
    EXPECT_NEAR(hit.cos_incidence, s, 1e-9);
  }
  EXPECT_EQ(traced(Plane{}, {{0, 0, -1.5}}, directionOf(0.3, 0.01)).object, -1);
}

TEST(RayTracer, NearerOfTwoSurfacesHidesTheOther) {
  Scene scene;
  scene.objects.push_back({.id = "far", .shape = Rectangle{2, 2}, .pose = {{20, 0, 0}}});
  scene.objects.push_back({.id = "near", .shape = Sphere{0.5}, .pose = {{10, 0, 0}}});
  const RayTracer tracer(scene);
  const Ray rays[] = {{{}, {1, 0, 0}}, {{}, directionOf(0.049, 0.0)}, {{}, {-1, 0, 0}}};
  RayHit hits[3];
  tracer.trace(rays, hits);
  EXPECT_EQ(hits[0].object, 1);
  EXPECT_NEAR(hits[0].range_m, 9.5, 1e-5);
  EXPECT_EQ(hits[1].object, 1);
  EXPECT_EQ(hits[2].object, -1);
}

TEST(RayTracer, SurfacesReflectFromBothSides) {
  EXPECT_EQ(traced(Rectangle{2, 2}, {{10, 0, 0}, 180.0}, {1, 0, 0}).object, 0);
  EXPECT_NEAR(traced(Box{{8, 8, 8}}, {}, {1, 0, 0}).range_m, 4.0, 1e-6);  // from inside
  EXPECT_NEAR(traced(Sphere{8}, {}, {1, 0, 0}).range_m, 8.0, 1e-5);
}

// Tall cylinders: 'wires' and lamp posts must not lose rays between their facets.
TEST(RayTracer, NoRaySlipsThroughACylinder) {
  Scene scene;
  scene.objects.push_back({.id = "post", .shape = Cylinder{0.1, 50.0}, .pose = {{20, 0, 0}}});
  const RayTracer tracer(scene);
  std::vector<Ray> rays;
  for (int i = 0; i < 20000; ++i) rays.push_back({{}, directionOf(0.00499 * (i / 10000.0 - 1.0), 0.2 * std::sin(i))});
  std::vector<RayHit> hits(rays.size());
  tracer.trace(rays, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) ASSERT_EQ(hits[i].object, 0) << i;
}

TEST(RayTracer, EmptySceneReturnsNothing) {
  const RayTracer tracer(Scene{});
  const Ray ray{{}, {1, 0, 0}};
  RayHit hit;
  tracer.trace({&ray, 1}, {&hit, 1});
  EXPECT_EQ(hit.object, -1);
}

}  // namespace
}  // namespace model
