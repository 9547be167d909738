#include "metrics/samples/label_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace metrics {

namespace {
constexpr std::size_t kLeaf = 16;
}

struct LabelTree::Distances {
  double near;
  double far;
};

LabelTree::LabelTree(std::span<const double> coordinates, std::size_t dimension, std::span<const std::uint32_t> rows,
                     std::span<const char> is_simulated)
    : dimension_(dimension) {
  std::vector<std::uint32_t> order(rows.begin(), rows.end());
  if (!order.empty()) build(coordinates, is_simulated, order, 0, order.size());
  for (const std::uint32_t row : order) {
    const auto point = coordinates.subspan(row * dimension, dimension);
    points_.insert(points_.end(), point.begin(), point.end());
    labels_.push_back(is_simulated[row]);
  }
}

std::size_t LabelTree::build(std::span<const double> coordinates, std::span<const char> is_simulated,
                             std::span<std::uint32_t> rows, std::size_t begin, std::size_t end) {
  const std::size_t here = nodes_.size();
  Node node{.begin = begin, .end = end, .simulated = 0};
  std::vector<double> low(dimension_, std::numeric_limits<double>::infinity());
  std::vector<double> high(dimension_, -std::numeric_limits<double>::infinity());
  for (std::size_t i = begin; i < end; ++i) {
    node.simulated += is_simulated[rows[i]] ? 1 : 0;
    for (std::size_t d = 0; d < dimension_; ++d) {
      const double x = coordinates[rows[i] * dimension_ + d];
      low[d] = std::min(low[d], x);
      high[d] = std::max(high[d], x);
    }
  }
  nodes_.push_back(node);
  boxes_.insert(boxes_.end(), low.begin(), low.end());
  boxes_.insert(boxes_.end(), high.begin(), high.end());

  std::size_t widest = 0;
  for (std::size_t d = 1; d < dimension_; ++d) {
    if (high[d] - low[d] > high[widest] - low[widest]) widest = d;
  }
  if (end - begin <= kLeaf || high[widest] == low[widest]) return here;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&rows](std::size_t i) { return rows.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return coordinates[a * dimension_ + widest] < coordinates[b * dimension_ + widest];
  });
  const std::size_t left = build(coordinates, is_simulated, rows, begin, middle);
  const std::size_t right = build(coordinates, is_simulated, rows, middle, end);
  nodes_[here].left = left;
  nodes_[here].right = right;
  return here;
}

// All three sums run over the coordinates in one order, and rounding keeps <=: a point in a box is never nearer than
// its near corner nor farther than its far one.
LabelTree::Distances LabelTree::distancesTo(std::size_t node, std::span<const double> place) const {
  const double* low = boxes_.data() + node * 2 * dimension_;
  const double* high = low + dimension_;
  Distances squared{.near = 0.0, .far = 0.0};
  for (std::size_t d = 0; d < dimension_; ++d) {
    const double near = std::max(0.0, std::max(low[d] - place[d], place[d] - high[d]));
    const double far = std::max(high[d] - place[d], place[d] - low[d]);
    squared.near += near * near;
    squared.far += far * far;
  }
  return squared;
}

double LabelTree::squaredDistance(std::size_t point, std::span<const double> place) const {
  double sum = 0.0;
  for (std::size_t d = 0; d < dimension_; ++d) {
    const double away = points_[point * dimension_ + d] - place[d];
    sum += away * away;
  }
  return sum;
}

/// Squared distances that may be among the k smallest; `reach` bounds the k-th from above.
void LabelTree::collect(std::size_t node, std::span<const double> place, std::size_t k, std::vector<double>& nearest,
                        double& reach) const {
  const Node& here = nodes_[node];
  if (here.left != 0) {
    std::pair first{distancesTo(here.left, place).near, here.left};
    std::pair second{distancesTo(here.right, place).near, here.right};
    if (second.first < first.first) std::swap(first, second);
    if (first.first < reach) collect(first.second, place, k, nearest, reach);
    if (second.first < reach) collect(second.second, place, k, nearest, reach);
    return;
  }
  for (std::size_t i = here.begin; i < here.end; ++i) {
    const double distance = squaredDistance(i, place);
    if (distance >= reach) continue;
    nearest.push_back(distance);
    if (nearest.size() < 2 * k) continue;
    std::nth_element(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(k - 1), nearest.end());
    nearest.resize(k);
    reach = nearest.back();
  }
}

void LabelTree::count(std::size_t node, std::span<const double> place, double reach, Votes& votes) const {
  const Node& here = nodes_[node];
  const Distances squared = distancesTo(node, place);
  if (squared.near > reach) return;
  if (squared.far <= reach) {
    votes.simulated += here.simulated;
    votes.measured += here.end - here.begin - here.simulated;
  } else if (here.left != 0) {
    count(here.left, place, reach, votes);
    count(here.right, place, reach, votes);
  } else {
    for (std::size_t i = here.begin; i < here.end; ++i) {
      if (squaredDistance(i, place) <= reach) ++(labels_[i] ? votes.simulated : votes.measured);
    }
  }
}

Votes LabelTree::ballOf(std::span<const double> place, std::size_t k) const {
  Votes votes{.simulated = 0, .measured = 0};
  if (labels_.empty() || k == 0) return votes;
  k = std::min(k, labels_.size());
  std::vector<double> nearest;
  nearest.reserve(2 * k);
  double reach = std::numeric_limits<double>::infinity();
  collect(0, place, k, nearest, reach);
  std::nth_element(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(k - 1), nearest.end());
  count(0, place, nearest[k - 1], votes);
  return votes;
}

}  // namespace metrics
