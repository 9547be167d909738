#include "bench/street.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "bench/mesh_builder.h"
#include "core/random.h"

namespace bench {

namespace {

using model::Vector3;

constexpr double kLane_m = 3.5, kParking_m = 2.2, kPavement_m = 2.8, kKerb_m = 0.12;
constexpr double kCentre_m = kLane_m / 2;                       // of the street; the sensor drives in the right lane
constexpr double kKerbAt_m = kLane_m + kParking_m;              // from the centre line
constexpr double kFacadeAt_m = kKerbAt_m + 0.15 + kPavement_m;  // from the centre line

/// One side of the street: distances from the centre line become y.
struct Side {
  double sign;  ///< +1: left
  [[nodiscard]] double y(double from_centre_m) const { return kCentre_m + sign * from_centre_m; }
};
constexpr std::array kSides{Side{1.0}, Side{-1.0}};

/// Everything stands on the road at z = 0 until the end, when it moves down below the sensor.
class Street {
 public:
  explicit Street(const StreetOptions& options)
      : options_(options),
        half_m_(options.length_m / 2),
        random_({.seed = options.seed, .purpose = core::purposeOf("street")}) {}

  model::Triangles build() {
    roadSurface();
    for (const Side& side : kSides) {
      footway(side);
      facades(side);
      furniture(side);
      parkedCars(side);
    }
    traffic();
    for (const Vector3& foot : trees_) wood(foot);
    leaves();
    model::Triangles all = mesh_.take();
    for (Vector3& vertex : all.vertices) vertex[2] -= options_.sensor_height_m;
    return all;
  }

 private:
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * random_.uniform(); }

  void roadSurface() {  // 2 % crown, ±4 mm of roughness
    const int across = 12, along = static_cast<int>(options_.length_m);
    const auto height = [&](double from_centre) { return -0.02 * std::abs(from_centre) + between(-0.004, 0.004); };
    mesh_.grid(along, across, [&](double u, double v) -> Vector3 {
      const double from_centre = (2.0 * v - 1.0) * kKerbAt_m;
      return {half_m_ * (2.0 * u - 1.0), kCentre_m + from_centre, height(from_centre)};
    });
  }

  void footway(const Side& side) {  // kerb stones of half a metre, slabs of one
    const int along = static_cast<int>(options_.length_m);
    const double low = -0.02 * kKerbAt_m - 0.01;
    mesh_.grid(2 * along, 2, [&](double u, double v) -> Vector3 {
      const double out = v < 0.25 ? 0.0 : v < 0.75 ? 0.01 : 0.15;
      return {half_m_ * (2.0 * u - 1.0), side.y(kKerbAt_m + out), v < 0.25 ? low : kKerb_m};
    });
    mesh_.grid(along, 3, [&](double u, double v) -> Vector3 {
      return {half_m_ * (2.0 * u - 1.0), side.y(kKerbAt_m + 0.15 + v * (kPavement_m + 0.4)),
              kKerb_m + between(0.0, 0.004)};
    });
  }

  void facades(const Side& side) {
    constexpr double kBay_m = 2.5, kStorey_m = 3.2;
    for (double x = -half_m_; x + 5 * kBay_m <= half_m_;) {
      const int bays = 5 + static_cast<int>(random_.below(4)), storeys = 4 + static_cast<int>(random_.below(3));
      const double set_back = kFacadeAt_m + between(0.0, 0.4), end = x + bays * kBay_m, top = storeys * kStorey_m;
      for (int storey = 0; storey < storeys; ++storey) {
        for (int bay = 0; bay < bays; ++bay) {
          const double left = x + bay * kBay_m, low = storey * kStorey_m;
          window(side, set_back, {left, low}, {left + kBay_m, low + kStorey_m}, storey == 0);
          if (storey > 0 && random_.uniform() < 0.12) balcony(side, set_back, left + kBay_m / 2, low + 0.1);
        }
      }
      const double back = set_back + 10.0, ridge = top + between(2.5, 4.0), middle = set_back + 5.0;
      for (const double at : {x, end}) {  // the walls between houses, with their gables
        mesh_.quad({at, side.y(set_back), 0}, {at, side.y(back), 0}, {at, side.y(back), top},
                   {at, side.y(set_back), top});
        mesh_.triangle({at, side.y(set_back), top}, {at, side.y(back), top}, {at, side.y(middle), ridge});
      }
      for (const double eaves : {set_back, back}) {
        mesh_.quad({x, side.y(eaves), top}, {end, side.y(eaves), top}, {end, side.y(middle), ridge},
                   {x, side.y(middle), ridge});
      }
      x = end;
    }
  }

  /// One bay of one storey: wall around a window that is set back behind its reveal, with mullions and a sill.
  void window(const Side& side, double at, std::array<double, 2> low, std::array<double, 2> high, bool shop) {
    constexpr double kDepth_m = 0.22, kBar_m = 0.06;
    const double margin = shop ? 0.25 : 0.6, x0 = low[0] + margin, x1 = high[0] - margin;
    const double z0 = low[1] + (shop ? 0.4 : 0.9), z1 = high[1] - 0.5;
    const auto wall = [&](double x, double z) -> Vector3 { return {x, side.y(at), z}; };
    const auto pane = [&](double x, double z) -> Vector3 { return {x, side.y(at + kDepth_m), z}; };
    const std::array<std::array<double, 2>, 4> outer{{low, {high[0], low[1]}, high, {low[0], high[1]}}};
    const std::array<std::array<double, 2>, 4> inner{{{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}}};
    for (std::size_t i = 0, j = 1; i < 4; ++i, j = (j + 1) % 4) {
      mesh_.quad(wall(outer[i][0], outer[i][1]), wall(outer[j][0], outer[j][1]), wall(inner[j][0], inner[j][1]),
                 wall(inner[i][0], inner[i][1]));
      mesh_.quad(wall(inner[i][0], inner[i][1]), wall(inner[j][0], inner[j][1]), pane(inner[j][0], inner[j][1]),
                 pane(inner[i][0], inner[i][1]));
    }
    mesh_.quad(pane(x0, z0), pane(x1, z0), pane(x1, z1), pane(x0, z1));
    const double xm = (x0 + x1) / 2, zm = (z0 + z1) / 2, y = side.y(at + kDepth_m - kBar_m);
    mesh_.box({xm, y, zm}, {kBar_m, kBar_m, z1 - z0});
    mesh_.box({xm, y, z0 + 0.7 * (z1 - z0)}, {x1 - x0, kBar_m, kBar_m});
    if (!shop) mesh_.box({xm, side.y(at - 0.06), z0 - 0.03}, {x1 - x0 + 0.2, 0.12, 0.05});
  }

  void balcony(const Side& side, double at, double x, double z) {
    mesh_.box({x, side.y(at - 0.6), z}, {2.2, 1.2, 0.15});
    mesh_.box({x, side.y(at - 1.17), z + 1.0}, {2.2, 0.05, 0.05});
    for (int bar = 0; bar < 12; ++bar)
      mesh_.box({x - 1.05 + bar * 2.1 / 11, side.y(at - 1.17), z + 0.52}, {0.02, 0.02, 0.9});
  }

  void furniture(const Side& side) {
    for (double x = -half_m_ + 5.0; x < half_m_ - 5.0; x += 25.0) {
      const double y = side.y(kKerbAt_m + 0.5);
      mesh_.tube({x, y, 0.0}, {x, y, 7.0}, 0.09, 0.05, 12);
      mesh_.tube({x, y, 6.9}, {x, side.y(kKerbAt_m - 1.2), 7.3}, 0.04, 0.04, 12);
      mesh_.box({x, side.y(kKerbAt_m - 1.4), 7.3}, {0.25, 0.7, 0.12});
      mesh_.tube({x + 12.0, y, 0.0}, {x + 12.0, y, 2.6}, 0.03, 0.03, 12);  // a sign, facing along the street
      mesh_.tube({x + 11.95, y, 2.9}, {x + 11.97, y, 2.9}, 0.3, 0.3, 24);
      for (double step = 2.0; step < 9.0; step += 1.5)
        mesh_.tube({x + step, y, 0.0}, {x + step, y, 1.0}, 0.05, 0.05, 12);
      trees_.push_back({x + 17.0, side.y(kKerbAt_m + 0.9), kKerb_m});
    }
  }

  void parkedCars(const Side& side) {
    for (double x = -half_m_ + 3.0; x < half_m_ - 3.0; x += between(5.4, 9.0)) {
      car({x, side.y(kLane_m + 1.15) + between(-0.08, 0.08), -0.08}, side.sign > 0 ? std::numbers::pi : 0.0);
    }
  }

  void traffic() {
    for (const double x : {14.0, 33.0, 70.0, -16.0, -55.0}) {
      if (std::abs(x) < half_m_ - 5.0) car({x, between(-0.2, 0.2), 0.0}, 0.0);
    }
    for (const double x : {9.0, 46.0, -28.0, -80.0}) {
      if (std::abs(x) < half_m_ - 5.0) car({x, kLane_m + between(-0.2, 0.2), 0.0}, std::numbers::pi);
    }
  }

  /// A body of rounded cross-sections between a floor and an outline of bonnet, screens and roof; wheels, mirrors.
  void car(const Vector3& foot, double yaw_rad) {
    const double scale = between(0.92, 1.08), length = 4.5 * scale, half_width = 0.9 * scale;
    const auto place = [&](const Vector3& p) -> Vector3 {
      const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
      return {foot[0] + c * p[0] - s * p[1], foot[1] + s * p[0] + c * p[1], foot[2] + p[2]};
    };
    constexpr std::array<std::array<double, 2>, 8> kOutline{
        {{0.0, 0.75}, {0.04, 0.98}, {0.10, 1.04}, {0.22, 1.42}, {0.5, 1.47}, {0.70, 1.0}, {0.95, 0.82}, {1.0, 0.6}}};
    const auto top = [&](double u) {
      std::size_t k = 1;
      while (k + 1 < kOutline.size() && kOutline[k][0] < u) ++k;
      const auto& a = kOutline[k - 1];
      const auto& b = kOutline[k];
      return scale * (a[1] + (b[1] - a[1]) * (u - a[0]) / (b[0] - a[0]));
    };
    mesh_.loft(22, 24, [&](double u, double angle) {
      const double low = 0.22 * scale, high = top(u), round = 1.0 - 0.12 * std::pow(std::abs(2.0 * u - 1.0), 4.0);
      const auto rounded = [](double x) { return std::copysign(std::sqrt(std::abs(x)), x); };  // a superellipse
      const double z = (low + high) / 2 + (high - low) / 2 * rounded(std::sin(angle));
      const double inward = 1.0 - 0.3 * std::max(0.0, z - 0.95 * scale) / (0.5 * scale);
      return place({length * (u - 0.5), half_width * round * inward * rounded(std::cos(angle)), z});
    });
    for (const double x : {-0.29 * length, 0.31 * length}) {
      for (const double y : {-0.86 * half_width, 0.86 * half_width}) {
        mesh_.tube(place({x, y - 0.11, 0.32}), place({x, y + 0.11, 0.32}), 0.32, 0.32, 16);
      }
    }
    for (const double y : {-1.0, 1.0})
      mesh_.box(place({0.16 * length, y * (half_width + 0.08), 1.0}), {0.1, 0.2, 0.14});
  }

  void wood(const Vector3& foot) {
    const Vector3 fork = {foot[0] + between(-0.2, 0.2), foot[1] + between(-0.2, 0.2), 3.0};
    mesh_.tube(foot, fork, 0.2, 0.14, 16);
    for (int branch = 0; branch < 10; ++branch) {
      const double angle = between(0.0, 2.0 * std::numbers::pi), out = between(0.7, 2.0);
      mesh_.tube(fork, {fork[0] + out * std::cos(angle), fork[1] + out * std::sin(angle), between(4.0, 6.5)}, 0.07,
                 0.02, 8);
    }
  }

  /// Single triangles of about 12 cm, strewn evenly over the crowns' volumes.
  void leaves() {
    if (mesh_.size() > options_.triangles || trees_.empty()) {
      throw std::invalid_argument("a street of " + std::to_string(options_.length_m) + " m has " +
                                  std::to_string(mesh_.size()) + " triangles without leaves");
    }
    constexpr double kLeaf_m = 0.12;
    for (std::size_t leaf = 0; mesh_.size() < options_.triangles; ++leaf) {
      const Vector3& foot = trees_[leaf % trees_.size()];
      const double out = std::cbrt(random_.uniform()), height = between(-1.0, 1.0), angle = between(0.0, 6.2831853);
      const double flat = std::sqrt(1.0 - height * height);
      const Vector3 at = {foot[0] + 2.2 * out * flat * std::cos(angle), foot[1] + 2.2 * out * flat * std::sin(angle),
                          foot[2] + 5.6 + 2.4 * out * height};
      const double turn = between(0.0, 6.2831853), tilt = between(-1.0, 1.0);
      const Vector3 along = {kLeaf_m * std::cos(turn), kLeaf_m * std::sin(turn), kLeaf_m * tilt};
      const Vector3 across = {-0.6 * along[1], 0.6 * along[0], 0.3 * kLeaf_m};
      mesh_.triangle(at, {at[0] + along[0], at[1] + along[1], at[2] + along[2]},
                     {at[0] + across[0], at[1] + across[1], at[2] + across[2]});
    }
  }

  StreetOptions options_;
  double half_m_;
  core::Random random_;
  MeshBuilder mesh_;
  std::vector<Vector3> trees_;
};

}  // namespace

model::Triangles street(const StreetOptions& options) { return Street(options).build(); }

}  // namespace bench
