#pragma once

#include <functional>
#include <vector>

#include "model/scene/triangles.h"

namespace bench {

/// Collects triangles from surfaces that are easy to say.
class MeshBuilder {
 public:
  using Vector3 = model::Vector3;

  void triangle(const Vector3& a, const Vector3& b, const Vector3& c);
  void quad(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);
  void box(const Vector3& centre, const Vector3& size);  ///< along the axes, 12 triangles
  /// A cone's trunk with both lids, 4 · sides triangles.
  void tube(const Vector3& from, const Vector3& to, double from_radius, double to_radius, int sides);
  /// point(u, v) over the unit square, 2 · along · across triangles; each point is asked once.
  void grid(int along, int across, const std::function<Vector3(double u, double v)>& point);
  /// Closed rings ring(u, angle) at u = 0 … 1, joined and capped: 2 · rings · corners triangles.
  void loft(int rings, int corners, const std::function<Vector3(double u, double angle_rad)>& ring);

  [[nodiscard]] std::size_t size() const { return triangles_.faces.size(); }
  [[nodiscard]] model::Triangles take() { return std::move(triangles_); }

 private:
  std::uint32_t vertex(const Vector3& at);

  model::Triangles triangles_;
};

}  // namespace bench
