#include "metrics/points/nearest_points.h"

#include <array>
#include <nanoflann.hpp>

#include "core/parallel.h"

namespace metrics {

namespace {

/// What nanoflann wants to know of a cloud.
struct TreeView {
  std::span<const Position> points;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const {
    const Position& p = points[index];
    return axis == 0 ? p.x_m : axis == 1 ? p.y_m : p.z_m;
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;  // let the tree find it
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, TreeView>, TreeView, 3, std::size_t>;

}  // namespace

std::vector<double> nearestDistances(std::span<const Position> from, std::span<const Position> to) {
  const TreeView view{to};
  const Tree tree(3, view);
  std::vector<double> distances(from.size());
  core::parallelFor(from.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::array<double, 3> query{from[i].x_m, from[i].y_m, from[i].z_m};
      std::size_t nearest = 0;
      double square = 0.0;
      tree.knnSearch(query.data(), 1, &nearest, &square);
      distances[i] = distance(from[i], to[nearest]);
    }
  });
  return distances;
}

NearestDistances nearestDistances(const CloudPair& clouds) {
  mustHavePoints(clouds);
  return {.of_simulated = nearestDistances(clouds.simulated, clouds.measured),
          .of_measured = nearestDistances(clouds.measured, clouds.simulated)};
}

}  // namespace metrics
