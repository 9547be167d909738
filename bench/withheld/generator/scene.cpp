#include "bench/withheld/generator/scene.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

#include "bench/withheld/generator/bad_input.h"

namespace withheld {

namespace {

constexpr double kNearest_m = 1e-9;

struct LocalHit {
  double range_m;
  int face;
  Vec normal;
};

using Found = std::optional<LocalHit>;

void keepNearer(Found& best, double t, int face, Vec normal) {
  if (t > kNearest_m && (!best || t < best->range_m)) best = {t, face, normal};
}

Found intersect(const Rectangle& shape, Vec from, Vec along) {
  if (along.x == 0.0) return {};
  Found best;
  const double t = -from.x / along.x;
  const bool inside =
      std::abs(from.y + t * along.y) <= shape.width_m / 2 && std::abs(from.z + t * along.z) <= shape.height_m / 2;
  if (inside) keepNearer(best, t, 0, {-1, 0, 0});
  return best;
}

Found intersect(const Plane&, Vec from, Vec along) {
  Found best;
  if (along.z != 0.0) keepNearer(best, -from.z / along.z, 0, {0, 0, 1});
  return best;
}

Found intersect(const Box& shape, Vec from, Vec along) {
  const double start[3] = {from.x, from.y, from.z}, step[3] = {along.x, along.y, along.z};
  const double half[3] = {shape.half_m.x, shape.half_m.y, shape.half_m.z};
  double enter = -1e300, leave = 1e300;
  int enter_axis = 0, leave_axis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (step[axis] == 0.0) {
      if (std::abs(start[axis]) > half[axis]) return {};
      continue;
    }
    double first = (-half[axis] - start[axis]) / step[axis], second = (half[axis] - start[axis]) / step[axis];
    if (first > second) std::swap(first, second);
    if (first > enter) enter = first, enter_axis = axis;
    if (second < leave) leave = second, leave_axis = axis;
  }
  if (enter > leave) return {};
  Found best;
  const Vec axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto faceOf = [&](int axis, bool entering) { return 2 * axis + ((step[axis] > 0.0) == entering ? 0 : 1); };
  keepNearer(best, enter, faceOf(enter_axis, true), axes[enter_axis]);
  if (!best) keepNearer(best, leave, faceOf(leave_axis, false), axes[leave_axis]);
  return best;
}

// Roots of a t² + 2 b t + c = 0, without the cancellation of the school formula.
std::optional<std::array<double, 2>> roots(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (a == 0.0 || discriminant < 0.0) return {};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  return q == 0.0 ? std::array{0.0, 0.0} : std::array{q / a, c / q};
}

Found intersect(const Sphere& shape, Vec from, Vec along) {
  Found best;
  const auto both = roots(1.0, dot(from, along), dot(from, from) - shape.radius_m * shape.radius_m);
  if (!both) return best;
  for (const double t : *both) keepNearer(best, t, -1, (1.0 / shape.radius_m) * (from + t * along));
  return best;
}

Found intersect(const Cylinder& shape, Vec from, Vec along) {
  Found best;
  const double r2 = shape.radius_m * shape.radius_m;
  const auto mantle = roots(along.x * along.x + along.y * along.y, from.x * along.x + from.y * along.y,
                            from.x * from.x + from.y * from.y - r2);
  if (mantle) {
    for (const double t : *mantle) {
      const Vec at = from + t * along;
      if (std::abs(at.z) <= shape.half_height_m) keepNearer(best, t, -1, (1.0 / shape.radius_m) * Vec{at.x, at.y, 0});
    }
  }
  if (along.z != 0.0) {
    for (const double end : {-shape.half_height_m, shape.half_height_m}) {
      const double t = (end - from.z) / along.z;
      const Vec at = from + t * along;
      if (at.x * at.x + at.y * at.y <= r2) keepNearer(best, t, end > 0.0 ? 1 : 0, {0, 0, 1});
    }
  }
  return best;
}

Vec vecOf(const Fields& fields, const std::string& key) {
  if (!fields.find(key)) return {};
  const std::vector<double> v = fields.numbers(key, 3);
  return {v[0], v[1], v[2]};
}

std::variant<Rectangle, Box, Sphere, Cylinder, Plane> readShape(const Json& json, const std::string& place) {
  const Fields shape(json, place, {"type", "width_m", "height_m", "size_m", "radius_m", "file", "scale"});
  const std::string type = shape.oneOf("type", {"rectangle", "box", "sphere", "cylinder", "plane", "mesh"}, "");
  if (type == "rectangle") return Rectangle{shape.number("width_m"), shape.number("height_m")};
  if (type == "box") return Box{0.5 * vecOf(shape, "size_m")};
  if (type == "sphere") return Sphere{shape.number("radius_m")};
  if (type == "cylinder") return Cylinder{shape.number("radius_m"), 0.5 * shape.number("height_m")};
  if (type == "plane") return Plane{};
  throw BadInput(shape.placeOf("type"), fmt::format("'{}' is not simulated here.", type),
                 "Use rectangle, box, sphere, cylinder or plane.");
}

void readLaw(const Fields& brdf, Material& material) {
  const std::string law = brdf.oneOf("model", {"lambertian", "oren-nayar", "phong", "retroreflector"}, "lambertian");
  if (law == "oren-nayar") {
    material.law = Material::Law::oren_nayar;
    material.roughness_rad = brdf.number("roughness_rad");
  } else if (law == "phong") {
    material.law = Material::Law::phong;
    material.diffuse_fraction = brdf.number("diffuse_fraction");
    material.exponent = brdf.number("exponent");
    material.specular_fraction = 1.0 - material.diffuse_fraction;
  } else if (law == "retroreflector") {
    material.law = Material::Law::retroreflector;
    material.gain = brdf.number("gain");
    material.half_width_rad = brdf.number("half_width_rad");
  }
}

std::map<std::string, Material> readMaterials(const Json& experiment, const std::string& place) {
  std::map<std::string, Material> materials;
  const auto found = experiment.find("materials");
  if (found == experiment.end()) return materials;
  for (const auto& [name, json] : found->items()) {
    const Fields fields(json, place + "/materials/" + name,
                        {"reflectivity", "brdf", "transmission", "refractive_index"});
    Material material;
    material.reflectivity = fields.number("reflectivity");
    material.transmission = fields.number("transmission", 0.0);
    if (fields.find("refractive_index")) material.refractive_index = fields.number("refractive_index");
    if (const Json* brdf = fields.find("brdf")) {
      readLaw({*brdf,
               fields.placeOf("brdf"),
               {"model", "roughness_rad", "diffuse_fraction", "exponent", "gain", "half_width_rad"}},
              material);
    }
    materials[name] = material;
  }
  return materials;
}

}  // namespace

Scene readScene(const Json& experiment, const std::string& place) {
  const std::map<std::string, Material> materials = readMaterials(experiment, place);
  Scene scene;
  if (!experiment.contains("scene") || !experiment["scene"].is_array()) {
    throw BadInput(place + "/scene", "is no list.", "List the objects of the scene.");
  }
  for (std::size_t i = 0; i < experiment["scene"].size(); ++i) {
    const Fields fields(experiment["scene"][i], place + "/scene/" + std::to_string(i),
                        {"id", "shape", "pose", "velocity_m_s", "material", "class"});
    const Fields pose(fields.at("pose"), fields.placeOf("pose"), {"position_m", "yaw_pitch_roll_deg"});
    const std::string name = fields.text("material");
    if (!materials.contains(name)) {
      throw BadInput(fields.placeOf("material"), fmt::format("'{}' is not among the materials.", name),
                     "Add it to /materials.");
    }
    const Vec angles = kDegree * vecOf(pose, "yaw_pitch_roll_deg");
    scene.push_back({fields.text("id"), readShape(fields.at("shape"), fields.placeOf("shape")),
                     vecOf(pose, "position_m"), Turn::yawPitchRoll(angles.x, angles.y, angles.z),
                     vecOf(fields, "velocity_m_s"), materials.at(name)});
  }
  return scene;
}

std::optional<Hit> nearestHit(const Scene& scene, const Ray& ray, double moved_s) {
  std::optional<Hit> best;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const Object& object = scene[i];
    const Vec from = object.turn.inward(ray.from - object.position - moved_s * object.velocity_m_s);
    const Vec along = object.turn.inward(ray.along);
    const Found found = std::visit([&](const auto& shape) { return intersect(shape, from, along); }, object.shape);
    if (!found || (best && best->range_m <= found->range_m)) continue;
    Vec normal = object.turn.outward(found->normal);
    if (dot(normal, ray.along) > 0.0) normal = -1.0 * normal;
    best = {found->range_m, static_cast<int>(i), found->face, normal};
  }
  return best;
}

}  // namespace withheld
