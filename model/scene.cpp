#include "model/scene.h"

#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"
#include "core/physics.h"
#include "core/text.h"

namespace model {

namespace {

constexpr core::Bounds kPositive{.min = 0.0, .open_min = true};
constexpr core::Bounds kFraction{.min = 0.0, .max = 1.0};

Vector3 vectorOf(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

Brdf readBrdf(core::JsonObject object) {
  Brdf brdf;
  const std::string name = object.choice("model", {"lambertian", "oren-nayar", "phong", "retroreflector"});
  if (name == "oren-nayar") {
    brdf.model = BrdfModel::kOrenNayar;
    brdf.roughness_rad = object.number("roughness_rad", {.min = 0.0, .max = 1.6});
  } else if (name == "phong") {
    brdf.model = BrdfModel::kPhong;
    brdf.diffuse_fraction = object.number("diffuse_fraction", kFraction);
    brdf.exponent = object.number("exponent", {.min = 0.0});
  } else if (name == "retroreflector") {
    brdf.model = BrdfModel::kRetroreflector;
    brdf.gain = object.number("gain", kPositive);
    brdf.half_width_rad = object.number("half_width_rad", kPositive);
  }
  object.finish();
  return brdf;
}

Material readMaterial(const std::string& name, core::JsonObject object) {
  Material material;
  material.name = name;
  material.reflectivity = object.number("reflectivity", kFraction);
  if (object.has("brdf")) material.brdf = readBrdf(object.object("brdf"));
  material.transmission = object.numberOr("transmission", 0.0, kFraction);
  material.refractive_index = object.numberOr("refractive_index", 1.5, {.min = 1.0, .max = 10.0});
  object.finish();
  return material;
}

Shape readShape(core::JsonObject object) {
  const std::string type = object.choice("type", {"rectangle", "box", "sphere", "cylinder", "plane", "mesh"});
  Shape shape = Plane{};
  if (type == "rectangle") shape = Rectangle{object.number("width_m", kPositive), object.number("height_m", kPositive)};
  if (type == "box") {
    const Vector3 size = vectorOf(object.numbers("size_m", 3));
    for (const double length : size) {
      if (length <= 0.0) object.fail("size_m", "has a length that is not positive.", "Give three positive lengths.");
    }
    shape = Box{size};
  }
  if (type == "sphere") shape = Sphere{object.number("radius_m", kPositive)};
  if (type == "cylinder") shape = Cylinder{object.number("radius_m", kPositive), object.number("height_m", kPositive)};
  if (type == "mesh") {
    shape = Mesh{object.file().parent_path() / object.text("file"), object.numberOr("scale", 1.0, kPositive)};
  }
  object.finish();
  return shape;
}

Pose readPose(core::JsonObject object) {
  Pose pose;
  pose.position_m = vectorOf(object.numbers("position_m", 3));
  if (object.has("yaw_pitch_roll_deg")) {
    const auto angles = object.numbers("yaw_pitch_roll_deg", 3);
    pose.yaw_deg = angles[0];
    pose.pitch_deg = angles[1];
    pose.roll_deg = angles[2];
  }
  object.finish();
  return pose;
}

std::size_t materialIndex(const Scene& scene, core::JsonObject& object) {
  const std::string name = object.text("material");
  std::vector<std::string> known;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (scene.materials[i].name == name) return i;
    known.push_back(scene.materials[i].name);
  }
  const std::string nearest = core::nearestName(name, known);
  object.fail("material", "'" + name + "' is not among the materials.",
              nearest.empty() ? "Define it under /materials." : "Did you mean '" + nearest + "'?");
}

}  // namespace

std::array<Vector3, 3> Pose::rotation() const {
  const double cy = std::cos(yaw_deg * core::kRadPerDeg), sy = std::sin(yaw_deg * core::kRadPerDeg);
  const double cp = std::cos(pitch_deg * core::kRadPerDeg), sp = std::sin(pitch_deg * core::kRadPerDeg);
  const double cr = std::cos(roll_deg * core::kRadPerDeg), sr = std::sin(roll_deg * core::kRadPerDeg);
  return {{{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
           {sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr},
           {-sp, cp * sr, cp * cr}}};
}

Vector3 Pose::toWorld(const Vector3& local) const {
  const auto r = rotation();
  Vector3 world = position_m;
  for (std::size_t i = 0; i < 3; ++i) world[i] += r[i][0] * local[0] + r[i][1] * local[1] + r[i][2] * local[2];
  return world;
}

Vector3 Pose::toLocal(const Vector3& world) const {
  const auto r = rotation();
  const Vector3 d = {world[0] - position_m[0], world[1] - position_m[1], world[2] - position_m[2]};
  Vector3 local{};
  for (std::size_t i = 0; i < 3; ++i) local[i] = r[0][i] * d[0] + r[1][i] * d[1] + r[2][i] * d[2];
  return local;
}

Scene readScene(core::JsonObject& experiment) {
  Scene scene;
  if (experiment.has("materials")) {
    core::JsonObject materials = experiment.object("materials");
    for (const std::string& name : materials.keys()) {
      scene.materials.push_back(readMaterial(name, materials.object(name)));
    }
  }
  std::set<std::string> ids;
  experiment.eachObject("scene", [&](core::JsonObject& object) {
    SceneObject item;
    item.id = object.text("id");
    if (!ids.insert(item.id).second) object.fail("id", "'" + item.id + "' stands twice in the scene.", "Rename one.");
    item.shape = readShape(object.object("shape"));
    item.pose = readPose(object.object("pose"));
    if (object.has("velocity_m_s")) item.velocity_m_s = vectorOf(object.numbers("velocity_m_s", 3));
    item.material = materialIndex(scene, object);
    scene.objects.push_back(std::move(item));
  });
  return scene;
}

Vector3 halfExtents(const Shape& shape) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  if (const auto* r = std::get_if<Rectangle>(&shape)) return {0.0, r->width_m / 2, r->height_m / 2};
  if (const auto* b = std::get_if<Box>(&shape)) return {b->size_m[0] / 2, b->size_m[1] / 2, b->size_m[2] / 2};
  if (const auto* s = std::get_if<Sphere>(&shape)) return {s->radius_m, s->radius_m, s->radius_m};
  if (const auto* c = std::get_if<Cylinder>(&shape)) return {c->radius_m, c->radius_m, c->height_m / 2};
  return {kUnbounded, kUnbounded, std::holds_alternative<Plane>(shape) ? 0.0 : kUnbounded};
}

}  // namespace model
