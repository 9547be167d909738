#include "objects/features.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/scene/triangles.h"

namespace objects {

namespace {

bool isBounded(const model::Bounds& bounds) {
  return std::all_of(bounds.high.begin(), bounds.high.end(), [](double value) { return std::isfinite(value); });
}

/// How far outside of the box, or how deep (negative) inside.
double distanceOutside(const Vector3& local, const model::Bounds& box) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) farthest = std::max({farthest, box.low[k] - local[k], local[k] - box.high[k]});
  return farthest;
}

Ground groundIn(const FrameInput& input, const Stages& stages, StageCounts& counts) {
  if (stages.ground_by == GroundBy::kReference) return input.reference_ground;
  Ground ground;
  if (stages.ground_by == GroundBy::kNone) return ground;
  std::vector<Vector3> points;
  for (const std::size_t i : input.indices) points.push_back(input.points[i]);
  if (const auto plane = fitGround(points, stages.ground, core::Random(input.random))) {
    ground.add(*plane);
  } else if (!points.empty()) {
    ++counts.frames_without_ground;
  }
  return ground;
}

struct Segment {
  std::vector<std::size_t> indices;
  std::string object;
};

std::vector<Segment> segmentsOf(const FrameInput& input, std::span<const std::size_t> standing, const Stages& stages) {
  std::vector<Segment> segments;
  if (stages.segments_by == SegmentsBy::kClusters) {
    for (auto& cluster : clustersOf(input.points, standing, stages.nearness)) {
      segments.push_back({.indices = std::move(cluster), .object = {}});
    }
    return segments;
  }
  std::map<std::size_t, std::vector<std::size_t>> by_object;
  for (const std::size_t i : standing) {
    if (input.owners[i]) by_object[*input.owners[i]].push_back(i);
  }
  for (auto& [object, indices] : by_object) {
    segments.push_back({.indices = std::move(indices), .object = input.situation.scene.objects[object].id});
  }
  return segments;
}

/// Ground removal takes the foot of an object with it: give it back.
Box standingOn(const Ground& ground, const Box& box, double to_ground_m) {
  const auto height = ground.heightAt(box.centre_m[0], box.centre_m[1]);
  const double foot = box.centre_m[2] - box.height_m / 2, top = box.centre_m[2] + box.height_m / 2;
  if (!height || foot > *height + to_ground_m || top < *height) return box;
  Box standing = box;
  standing.height_m = top - *height;
  standing.centre_m[2] = (top + *height) / 2;
  return standing;
}

}  // namespace

void StageCounts::add(const StageCounts& other) {
  detections += other.detections;
  outside_gate += other.outside_gate;
  ground += other.ground;
  frames_without_ground += other.frames_without_ground;
  without_object += other.without_object;
  segments += other.segments;
  features += other.features;
  listed += other.listed;
}

std::vector<std::size_t> realObjects(const model::Scene& scene) {
  std::vector<std::size_t> real;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const model::SceneObject& object = scene.objects[i];
    if (!isGround(object) && isBounded(model::localBounds(object.shape))) real.push_back(i);
  }
  return real;
}

std::vector<std::optional<std::size_t>> ownersOf(const core::Detections& detections, const model::Situation& situation,
                                                 double margin_m) {
  const std::vector<Vector3> points = pointsOf(detections);
  std::vector<std::optional<std::size_t>> owners(points.size());
  std::vector<double> outside(points.size(), std::numeric_limits<double>::infinity());
  for (const std::size_t o : realObjects(situation.scene)) {
    const model::SceneObject& object = situation.scene.objects[o];
    const model::Bounds bounds = model::localBounds(object.shape);
    const model::Gate gate{.id = object.id, .object = object.id, .margin_m = margin_m};
    for (const std::size_t i : model::indicesInsideGate(detections, situation, gate)) {
      const double distance = distanceOutside(object.pose.toLocal(points[i]), bounds);
      if (distance >= outside[i]) continue;
      outside[i] = distance;
      owners[i] = o;
    }
  }
  return owners;
}

std::vector<Feature> featuresOf(const FrameInput& input, const Stages& stages, StageCounts& counts) {
  const Ground ground = groundIn(input, stages, counts);
  std::vector<std::size_t> standing;
  for (const std::size_t i : input.indices) {
    if (!isOnGround(input.points[i], ground, stages.ground.tolerance_m)) standing.push_back(i);
  }
  counts.ground += input.indices.size() - standing.size();
  counts.without_object += standing.size();
  std::vector<Feature> features;
  for (const Segment& segment : segmentsOf(input, standing, stages)) {
    ++counts.segments;
    if (segment.indices.size() < static_cast<std::size_t>(stages.least_detections)) continue;
    counts.without_object -= segment.indices.size();
    const Box fitted = standingOn(ground, fitBox(input.points, segment.indices, stages.box), stages.to_ground_m);
    features.push_back({.box = withLongerSideAhead(atLeast(fitted, stages.least_size_m)),
                        .detections = static_cast<int>(segment.indices.size()),
                        .object = segment.object});
  }
  counts.features += features.size();
  return features;
}

}  // namespace objects
