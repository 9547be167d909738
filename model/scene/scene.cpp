#include "model/scene/scene.h"

#include <limits>
#include <set>

#include "core/error.h"
#include "core/text.h"

namespace model {

namespace {

constexpr core::Bounds kPositive{.min = 0.0, .open_min = true};

Vector3 vectorOf(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

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
