#include "objects/segments.h"

#include <array>
#include <cmath>
#include <nanoflann.hpp>
#include <numeric>

namespace objects {

namespace {

/// Points with squeezed heights, as nanoflann wants to see them.
struct TreeView {
  std::vector<std::array<double, 3>> points;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const { return points[index][axis]; }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;  // let the tree find it
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, TreeView>, TreeView, 3, std::size_t>;

/// Disjoint sets; the root of a set is its least member.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) {
    i = root(i);
    j = root(j);
    if (i != j) parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<std::vector<std::size_t>> clustersOf(std::span<const Vector3> points, std::span<const std::size_t> indices,
                                                 const Nearness& nearness) {
  if (indices.empty()) return {};
  TreeView view;
  std::vector<double> reach;
  for (const std::size_t i : indices) {
    const Vector3& p = points[i];
    view.points.push_back({p[0], p[1], nearness.vertical_weight * p[2]});
    reach.push_back(nearness.distance_m + nearness.distance_per_range * std::hypot(p[0], p[1], p[2]));
  }
  const Tree tree(3, view);
  Sets sets(indices.size());
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  std::vector<std::pair<std::size_t, double>> found;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    // The farther one of a pair has the longer reach and finds the nearer one.
    tree.radiusSearch(view.points[i].data(), reach[i] * reach[i], found, unsorted);
    for (const auto& [j, square] : found) sets.unite(i, j);
  }
  std::vector<std::vector<std::size_t>> clusters;
  std::vector<std::size_t> cluster_of(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t root = sets.root(i);
    if (root == i) {
      cluster_of[i] = clusters.size();
      clusters.emplace_back();
    }
    clusters[cluster_of[root]].push_back(indices[i]);
  }
  return clusters;
}

}  // namespace objects
