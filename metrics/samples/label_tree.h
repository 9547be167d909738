#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace metrics {

/// Points in the ball around a place, by label.
struct Votes {
  std::size_t simulated;
  std::size_t measured;
};

/// k-d tree of labelled points that asks a neighbourhood for its vote.
///
///   +-----+--------+     Every node knows its bounding box and how many points of each label it holds: a box inside
///   |  .  |   . .  |     the ball is counted at once, so that thousands of equal values (counters) cost no more than
///   | . . +----+---+     one. Ties at the edge of the ball all vote: the result does not depend on the order of
///   points.
///   +-----+----+---+
///
/// Immutable; safe to share among threads. Source: Bentley 1975, doi:10.1145/361002.361007.
class LabelTree {
 public:
  /// `rows` are the points to hold, out of `coordinates` (row by row) with one label each; both are copied.
  LabelTree(std::span<const double> coordinates, std::size_t dimension, std::span<const std::uint32_t> rows,
            std::span<const char> is_simulated);

  /// Labels in the smallest closed ball around `place` that holds at least k points (all, if there are fewer).
  [[nodiscard]] Votes ballOf(std::span<const double> place, std::size_t k) const;

 private:
  struct Node {
    std::size_t begin, end;  // points
    std::size_t simulated;
    std::size_t left = 0;  // child nodes; 0: a leaf
    std::size_t right = 0;
  };
  struct Distances;  // squared, of a place to the nearest and farthest corner of a box

  std::size_t build(std::span<const double> coordinates, std::span<const char> is_simulated,
                    std::span<std::uint32_t> rows, std::size_t begin, std::size_t end);
  [[nodiscard]] Distances distancesTo(std::size_t node, std::span<const double> place) const;
  [[nodiscard]] double squaredDistance(std::size_t point, std::span<const double> place) const;
  void collect(std::size_t node, std::span<const double> place, std::size_t k, std::vector<double>& nearest,
               double& reach) const;
  void count(std::size_t node, std::span<const double> place, double reach, Votes& votes) const;

  std::size_t dimension_;
  std::vector<double> points_;  // in the order of the tree
  std::vector<char> labels_;
  std::vector<Node> nodes_;
  std::vector<double> boxes_;  // low and high corner of each node
};

}  // namespace metrics
