#include "objects/object_list.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <set>

#include "core/error.h"
#include "core/parallel.h"
#include "core/physics.h"
#include "core/text.h"
#include "model/scene/triangles.h"

namespace objects {

namespace {

using model::Experiment;
using model::Sample;

const model::Gate& gateOf(const Experiment& experiment, const GateId& id) {
  std::vector<std::string> known;
  for (const model::Gate& gate : experiment.gates) {
    if (gate.id == id) return gate;
    known.push_back(gate.id);
  }
  const std::string nearest = core::nearestName(id, known);
  throw core::InputError({.file = experiment.file, .item = "/gates"}, "has no gate '" + id + "'.",
                         known.empty()     ? "Define it under /gates."
                         : nearest.empty() ? "Known are " + core::join(known) + "."
                                           : "Did you mean '" + nearest + "'?");
}

/// Indices of the detections of each frame, in their order.
std::vector<std::vector<std::size_t>> framesOf(const core::Detections& detections, const Experiment& experiment,
                                               const Sample& sample) {
  std::vector<std::vector<std::size_t>> frames(static_cast<std::size_t>(sample.frames));
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const std::int32_t frame = detections.frame.empty() ? 0 : detections.frame[i];
    if (frame < 0 || frame >= sample.frames) {
      throw core::InputError(
          {.file = sample.measurements.empty() ? experiment.file : sample.measurements},
          fmt::format("has a detection in frame {}, but sample '{}' has {} frames.", frame, sample.id, sample.frames),
          "Correct 'frames' of the sample; frames count from 0.");
    }
    frames[static_cast<std::size_t>(frame)].push_back(i);
  }
  return frames;
}

void mustHaveDirections(const core::Detections& detections, const Experiment& experiment, const Sample& sample) {
  if (detections.hasDirections()) return;
  throw core::InputError({.file = sample.measurements.empty() ? experiment.file : sample.measurements},
                         "has no directions (columns layer, azimuth_rad, elevation_rad).",
                         "Objects lie somewhere: record the direction of each detection.");
}

std::vector<std::vector<Feature>> featuresOfFrames(std::size_t sample, const core::Detections& detections,
                                                   const std::vector<std::vector<std::size_t>>& frames,
                                                   const model::Situation& situation, const Stages& stages,
                                                   StageCounts& counts) {
  const std::vector<Vector3> points = pointsOf(detections);
  const Ground ground = groundOf(situation.scene);
  const auto owners = stages.segments_by == SegmentsBy::kReference ? ownersOf(detections, situation, stages.margin_m)
                                                                   : std::vector<std::optional<std::size_t>>{};
  std::vector<std::vector<Feature>> features(frames.size());
  std::vector<StageCounts> counts_of_frames(frames.size());
  core::parallelFor(frames.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const FrameInput input{.points = points,
                             .indices = frames[f],
                             .situation = situation,
                             .reference_ground = ground,
                             .owners = owners,
                             .random = {.seed = stages.seed,
                                        .sample = static_cast<std::uint32_t>(sample),
                                        .frame = static_cast<std::uint32_t>(f),
                                        .purpose = core::purposeOf("ground-fit")}};
      features[f] = featuresOf(input, stages, counts_of_frames[f]);
    }
  });
  for (const StageCounts& of_frame : counts_of_frames) counts.add(of_frame);
  return features;
}

/// The upright box around a turned one, with its heading.
Box uprightBox(const model::SceneObject& object) {
  const model::Bounds bounds = model::localBounds(object.shape);
  const auto rotation = object.pose.rotation();
  Box box{.yaw_rad = wrapped(object.pose.yaw_deg * core::kRadPerDeg)};
  // Heading of the turned x axis; that of a board lying flat is its yaw.
  if (std::hypot(rotation[0][0], rotation[1][0]) > 1e-9) box.yaw_rad = std::atan2(rotation[1][0], rotation[0][0]);
  Vector3 low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (int corner = 0; corner < 8; ++corner) {
    Vector3 local;
    for (std::size_t k = 0; k < 3; ++k) local[k] = (corner >> k) & 1 ? bounds.high[k] : bounds.low[k];
    const Vector3 turned = box.toLocal(object.pose.toWorld(local));  // the box still has its centre at the sensor
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], turned[k]);
      high[k] = std::max(high[k], turned[k]);
    }
  }
  box.length_m = high[0] - low[0];
  box.width_m = high[1] - low[1];
  box.height_m = high[2] - low[2];
  box.centre_m = box.toWorld({(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2});
  return box;
}

/// The same rectangle, its length along the side that lies as the reference's length does.
Box lyingAs(const Box& reference, const Box& box) {
  Box same = box;
  const double turn = std::remainder(box.yaw_rad - reference.yaw_rad, std::numbers::pi);
  if (std::abs(turn) <= std::numbers::pi / 4) return same;
  std::swap(same.length_m, same.width_m);
  same.yaw_rad = wrapped(same.yaw_rad + std::numbers::pi / 2);
  return same;
}

/// Pairs of one frame: by name first, then by distance.
std::vector<std::pair<const ListedObject*, const ListedObject*>> pairsOf(
    const std::vector<const ListedObject*>& listed, const std::vector<const ListedObject*>& reference,
    double distance_m) {
  std::vector<std::pair<const ListedObject*, const ListedObject*>> pairs;
  std::vector<const ListedObject*> unnamed, free;
  std::set<const ListedObject*> taken;
  for (const ListedObject* object : listed) {
    const auto same = std::find_if(reference.begin(), reference.end(), [&](const ListedObject* other) {
      return !object->object.empty() && other->object == object->object;
    });
    if (same == reference.end()) {
      unnamed.push_back(object);
    } else {
      pairs.emplace_back(object, *same);
      taken.insert(*same);
    }
  }
  std::vector<Box> a, b;
  for (const ListedObject* object : unnamed) a.push_back(object->box);
  for (const ListedObject* object : reference) {
    if (taken.contains(object)) continue;
    free.push_back(object);
    b.push_back(object->box);
  }
  for (const auto& [i, j] : nearestPairs(a, b, distance_m)) pairs.emplace_back(unnamed[i], free[j]);
  std::sort(pairs.begin(), pairs.end(), [](const auto& x, const auto& y) { return x.first->id < y.first->id; });
  return pairs;
}

std::vector<std::vector<const ListedObject*>> byFrame(const ObjectList& list, int frames) {
  std::vector<std::vector<const ListedObject*>> frames_of_list(static_cast<std::size_t>(frames));
  for (const ListedObject& object : list.objects) {
    if (object.frame < frames) frames_of_list[static_cast<std::size_t>(object.frame)].push_back(&object);
  }
  return frames_of_list;
}

ObjectError errorOf(const ListedObject& estimate, const ListedObject& reference, const ReferenceChoice& choice,
                    const ReferenceOptions& options) {
  const Box box = lyingAs(reference.box, estimate.box);
  return {.frame = estimate.frame,
          .id = estimate.id,
          .object = reference.object,
          .point = choice.on(reference.box),
          .position_m = positionError(box, reference.box, choice, options),
          .length_m = box.length_m - reference.box.length_m,
          .width_m = box.width_m - reference.box.width_m,
          .height_m = box.height_m - reference.box.height_m,
          .yaw_rad = yawError(box, reference.box),
          .existence = estimate.existence};
}

}  // namespace

ObjectList identifyObjects(const Experiment& experiment, std::size_t sample_index, const core::Detections& all,
                           const Stages& stages, const GateId& gate) {
  const Sample& sample = experiment.samples.at(sample_index);
  mustHaveDirections(all, experiment, sample);
  const model::Situation situation = model::situationOf(experiment, sample);
  const core::Detections detections = gate.empty() ? all : model::insideGate(all, situation, gateOf(experiment, gate));
  ObjectList list{.sample = sample.id, .frames = sample.frames};
  list.counts.detections = all.size();
  list.counts.outside_gate = all.size() - detections.size();
  const auto frames = framesOf(detections, experiment, sample);
  const auto features = featuresOfFrames(sample_index, detections, frames, situation, stages, list.counts);
  Tracker tracker(stages.tracking);
  for (std::size_t f = 0; f < features.size(); ++f) {
    tracker.step(features[f]);
    for (const TrackedObject& object : tracker.listed()) {
      list.objects.push_back({.frame = static_cast<int>(f),
                              .id = object.id,
                              .box = object.feature.box,
                              .existence = object.existence,
                              .detections = object.seen ? object.feature.detections : 0,
                              .age = object.age,
                              .object = object.feature.object});
    }
  }
  list.counts.listed = list.objects.size();
  return list;
}

ObjectList referenceObjects(const Experiment& experiment, std::size_t sample_index) {
  const Sample& sample = experiment.samples.at(sample_index);
  const model::Situation situation = model::situationOf(experiment, sample);
  ObjectList list{.sample = sample.id, .frames = sample.frames};
  std::vector<ListedObject> still;
  for (const std::size_t o : realObjects(situation.scene)) {
    const model::SceneObject& object = situation.scene.objects[o];
    still.push_back({.id = static_cast<int>(o) + 1, .box = uprightBox(object), .object = object.id});
  }
  for (int f = 0; f < sample.frames; ++f) {
    for (ListedObject object : still) {
      object.frame = f;
      object.age = f + 1;
      list.objects.push_back(object);
    }
  }
  return list;
}

std::vector<ObjectError> errorsOf(const ObjectList& list, const ObjectList& reference, const ReferenceChoice& choice,
                                  const ErrorOptions& options) {
  const int frames = std::max(list.frames, reference.frames);
  const auto listed = byFrame(list, frames), should = byFrame(reference, frames);
  std::vector<ObjectError> errors;
  for (std::size_t f = 0; f < listed.size(); ++f) {
    for (const auto& [estimate, truth] : pairsOf(listed[f], should[f], options.distance_m)) {
      errors.push_back(errorOf(*estimate, *truth, choice, options.reference));
    }
  }
  return errors;
}

}  // namespace objects
