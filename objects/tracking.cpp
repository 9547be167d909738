#include "objects/tracking.h"

#include <algorithm>
#include <tuple>

namespace objects {

namespace {
constexpr double kRounding = 1e-9;  // sums of increments that should be the threshold, or nothing
}

std::vector<std::pair<std::size_t, std::size_t>> nearestPairs(std::span<const Box> a, std::span<const Box> b,
                                                              double distance_m) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> candidates;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double distance = groundDistance(a[i], b[j]);
      if (distance <= distance_m) candidates.emplace_back(distance, i, j);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> a_taken(a.size(), false), b_taken(b.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [distance, i, j] : candidates) {
    if (a_taken[i] || b_taken[j]) continue;
    a_taken[i] = b_taken[j] = true;
    pairs.emplace_back(i, j);
  }
  return pairs;
}

std::vector<std::optional<std::size_t>> Tracker::featuresOfObjects(std::span<const Feature> features) const {
  std::vector<std::optional<std::size_t>> seen(objects_.size());
  std::vector<Box> was, is;
  std::vector<std::size_t> unknown_objects, unknown_features;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!objects_[i].feature.object.empty()) continue;
    unknown_objects.push_back(i);
    was.push_back(objects_[i].feature.box);
  }
  for (std::size_t j = 0; j < features.size(); ++j) {
    if (features[j].object.empty()) {
      unknown_features.push_back(j);
      is.push_back(features[j].box);
      continue;
    }
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      if (objects_[i].feature.object == features[j].object) seen[i] = j;
    }
  }
  for (const auto& [i, j] : nearestPairs(was, is, settings_.distance_m)) {
    seen[unknown_objects[i]] = unknown_features[j];
  }
  return seen;
}

void Tracker::step(std::span<const Feature> features) {
  const auto seen = featuresOfObjects(features);
  std::vector<bool> known(features.size(), false);
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    TrackedObject& object = objects_[i];
    ++object.age;
    object.seen = seen[i].has_value();
    if (object.seen) {
      object.feature = features[*seen[i]];
      known[*seen[i]] = true;
    }
    object.existence =
        std::clamp(object.existence + (object.seen ? settings_.increment : -settings_.decrement), 0.0, 1.0);
  }
  std::erase_if(objects_, [](const TrackedObject& object) { return object.existence <= kRounding; });
  for (std::size_t j = 0; j < features.size(); ++j) {
    if (known[j]) continue;
    objects_.push_back({.id = ++last_id_, .feature = features[j], .existence = std::min(1.0, settings_.increment)});
  }
}

std::vector<TrackedObject> Tracker::listed() const {
  std::vector<TrackedObject> list;
  for (const TrackedObject& object : objects_) {
    if (object.existence >= settings_.threshold - kRounding) list.push_back(object);
  }
  return list;
}

}  // namespace objects
