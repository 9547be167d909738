#include "model/scene/refined_shapes.h"

#include <algorithm>

namespace model {

namespace {

/// Collects the parts of one object; heights count from the ground below its box.
class Outline {
 public:
  explicit Outline(const TrafficObject& object)
      : object_(object), length_m(object.size_m[0]), width_m(object.size_m[1]), height_m(object.size_m[2]) {}

  void box(const std::string& name, const std::string& material, double from_x, double to_x, double width,
           double from_z, double to_z) {
    parts.push_back({name, Box{{to_x - from_x, width, to_z - from_z}},
                     Pose{{(from_x + to_x) / 2, 0.0, (from_z + to_z) / 2 - height_m / 2}}, material});
  }

  void upright(const std::string& name, const std::string& material, double radius, double from_z, double to_z) {
    parts.push_back(
        {name, Cylinder{radius, to_z - from_z}, Pose{{0.0, 0.0, (from_z + to_z) / 2 - height_m / 2}}, material});
  }

  void ball(const std::string& name, const std::string& material, double radius, double at_z) {
    parts.push_back({name, Sphere{radius}, Pose{{0.0, 0.0, at_z - height_m / 2}}, material});
  }

  void wheel(const std::string& name, double x, double y, double radius, double thickness) {
    parts.push_back({name, Cylinder{radius, thickness}, Pose{{x, y, radius - height_m / 2}, 0.0, 0.0, 90.0}, "tyre"});
  }

  /// Two axles; the trace's where it knows them and they lie inside the box.
  void axles(double rear_share, double front_share, double radius, double thickness) {
    const auto place = [&](const std::optional<Vector3>& axle, double share) {
      const double x = axle ? (*axle)[0] : share * length_m;
      return std::clamp(x, -length_m / 2 + radius, length_m / 2 - radius);
    };
    const double y = (width_m - thickness) / 2;
    const double rear = place(object_.rear_axle_m, rear_share), front = place(object_.front_axle_m, front_share);
    wheel("wheel-rear-left", rear, y, radius, thickness);
    wheel("wheel-rear-right", rear, -y, radius, thickness);
    wheel("wheel-front-left", front, y, radius, thickness);
    wheel("wheel-front-right", front, -y, radius, thickness);
  }

  /// The trace's wheel, or the usual one; never more than a quarter of the box.
  [[nodiscard]] double wheelRadius(double usual_m) const {
    return std::min({object_.wheel_radius_m.value_or(usual_m), height_m / 4, length_m / 4});
  }
  [[nodiscard]] double clearance(double usual_m) const {
    return std::min(object_.ground_clearance_m.value_or(usual_m), height_m / 4);
  }

 private:
  const TrafficObject& object_;

 public:
  double length_m, width_m, height_m;
  std::vector<OutlinePart> parts;
};

// Tyres: 205/55 R 16 has a diameter of 0.632 m, 315/70 R 22.5 one of 1.01 m (from the size designations themselves).
constexpr double kCarWheel_m = 0.316, kTruckWheel_m = 0.506;

void car(Outline& outline) {
  const double belt = 0.62 * outline.height_m, l = outline.length_m;
  outline.box("body", "car-paint", -l / 2, l / 2, outline.width_m, outline.clearance(0.18), belt);
  outline.box("cabin", "car-window", -0.325 * l, 0.225 * l, 0.85 * outline.width_m, belt, outline.height_m);
  outline.axles(-0.29, 0.31, outline.wheelRadius(kCarWheel_m), std::min(0.2, outline.width_m / 4));
}

void van(Outline& outline) {
  const double l = outline.length_m;
  outline.box("body", "car-paint", -l / 2, l / 2, outline.width_m, outline.clearance(0.25), outline.height_m);
  outline.axles(-0.3, 0.3, outline.wheelRadius(l > 7.0 ? kTruckWheel_m : kCarWheel_m),
                std::min(0.25, outline.width_m / 4));
}

void truck(Outline& outline) {  // driver's cab in front, a gap, the load
  const double l = outline.length_m, radius = outline.wheelRadius(kTruckWheel_m);
  outline.box("cab", "car-paint", 0.5 * l - 0.24 * l, 0.5 * l, outline.width_m, outline.clearance(0.3),
              0.85 * outline.height_m);
  outline.box("load", "tarpaulin", -l / 2, 0.5 * l - 0.28 * l, outline.width_m, 2.0 * radius, outline.height_m);
  outline.axles(-0.3, 0.36, radius, std::min(0.3, outline.width_m / 4));
}

void trailer(Outline& outline) {  // both axles under its rear half
  const double l = outline.length_m, radius = outline.wheelRadius(kTruckWheel_m);
  outline.box("load", "tarpaulin", -l / 2, l / 2, outline.width_m, 2.0 * radius, outline.height_m);
  outline.axles(-0.35, -0.2, radius, std::min(0.3, outline.width_m / 4));
}

void twoWheeler(Outline& outline) {
  const double l = outline.length_m, radius = std::min({0.34, l / 4, outline.height_m / 2});
  const double seat = 0.5 * outline.height_m, head = outline.height_m / 14;
  outline.wheel("wheel-rear", -l / 2 + radius, 0.0, radius, 0.06);
  outline.wheel("wheel-front", l / 2 - radius, 0.0, radius, 0.06);
  outline.box("frame", "car-paint", -l / 2 + radius, l / 2 - radius, std::min(0.2, outline.width_m), radius, seat);
  outline.box("handlebar", "metal", 0.2 * l, 0.2 * l + 0.05, outline.width_m, seat, seat + 0.05);
  outline.upright("rider", "clothing", 0.4 * std::min(outline.width_m, l) / 2 + 0.05, seat,
                  outline.height_m - 2.0 * head);
  outline.ball("head", "skin", head, outline.height_m - head);
}

void pedestrian(Outline& outline) {
  const double head = outline.height_m / 16;  // radius: a head is 1/8 of the height
  outline.upright("body", "clothing", (outline.length_m + outline.width_m) / 4, 0.0, outline.height_m - 2.0 * head);
  outline.ball("head", "skin", head, outline.height_m - head);
}

void tree(Outline& outline) {
  const double crown = std::min((outline.length_m + outline.width_m) / 4, 0.45 * outline.height_m);
  outline.upright("trunk", "bark", std::min(0.15, crown / 4), 0.0, outline.height_m - crown);
  outline.ball("crown", "foliage", crown, outline.height_m - crown);
}

}  // namespace

std::vector<OutlinePart> boxOutlineOf(const TrafficObject& object) {
  const auto material = [&]() -> std::string {
    switch (object.kind) {
      case TrafficKind::kPedestrian:
        return "clothing";
      case TrafficKind::kPole:
        return "metal";
      case TrafficKind::kTree:
      case TrafficKind::kVegetation:
        return "foliage";
      case TrafficKind::kBuilding:
        return "concrete";
      case TrafficKind::kTrailer:
        return "tarpaulin";
      case TrafficKind::kOther:
        return "grey";
      default:
        return "car-paint";
    }
  };
  return {{"box", Box{object.size_m}, Pose{}, material()}};
}

std::vector<OutlinePart> outlineOf(const TrafficObject& object) {
  Outline outline(object);
  switch (object.kind) {
    case TrafficKind::kCar:
      car(outline);
      break;
    case TrafficKind::kVan:
      van(outline);
      break;
    case TrafficKind::kTruck:
      truck(outline);
      break;
    case TrafficKind::kTrailer:
      trailer(outline);
      break;
    case TrafficKind::kTwoWheeler:
      twoWheeler(outline);
      break;
    case TrafficKind::kPedestrian:
      pedestrian(outline);
      break;
    case TrafficKind::kPole:
      outline.upright("pole", "metal", (outline.length_m + outline.width_m) / 4, 0.0, outline.height_m);
      break;
    case TrafficKind::kTree:
      tree(outline);
      break;
    default:
      return boxOutlineOf(object);
  }
  return outline.parts;
}

const std::vector<TrafficMaterial>& trafficMaterials() {
  static const std::vector<TrafficMaterial> materials{{"asphalt", 0.15},   {"bark", 0.3},      {"car-paint", 0.4},
                                                      {"car-window", 0.1}, {"clothing", 0.4},  {"concrete", 0.35},
                                                      {"foliage", 0.5},    {"grey", 0.25},     {"metal", 0.3},
                                                      {"skin", 0.5},       {"tarpaulin", 0.5}, {"tyre", 0.05}};
  return materials;
}

}  // namespace model
