#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "objects/features.h"

namespace objects {

/// One row of an object list.
struct ListedObject {
  int frame = 0;
  int id = 0;
  Box box;
  double existence = 1.0;
  std::optional<int> detections;  ///< in this frame; absent in a list of reference objects
  int age = 1;                    ///< frames since it appeared
  std::string object;             ///< of the scene, if known; "" otherwise
};

/// The objects of one sample, frame by frame, in order of id.
struct ObjectList {
  std::string sample;
  int frames = 0;
  std::vector<ListedObject> objects;
  StageCounts counts;  ///< all zero in a list of reference objects
};

/// Which gate of the experiment detections must lie in; "" takes all of them.
using GateId = std::string;

/// Feature and object identification of the sample's detections (measured or simulated: nobody can tell). Frames are
/// worked on in parallel, the tracking in their order; the same input and seed give the same list for any number of
/// threads.
/// Throws InputError if directions were not recorded, a frame is beyond the sample's or the gate is unknown.
[[nodiscard]] ObjectList identifyObjects(const model::Experiment& experiment, std::size_t sample,
                                         const core::Detections& detections, const Stages& stages,
                                         const GateId& gate = {});

/// What a perfect object list would say: the scene's bounded objects (no ground) in every frame, whether a beam can
/// reach them or not. The box stands upright around the object and has its heading; ids count the scene's objects
/// from 1.
[[nodiscard]] ObjectList referenceObjects(const model::Experiment& experiment, std::size_t sample);

/// How wrong a listed object is. Errors are estimate minus reference, in world axes.
struct ObjectError {
  int frame = 0;
  int id = 0;
  std::string object;    ///< the reference it was taken for
  ReferencePoint point;  ///< of the reference, at which positions were compared
  Vector3 position_m{};
  double length_m = 0.0;
  double width_m = 0.0;
  double height_m = 0.0;
  double yaw_rad = 0.0;    ///< modulo 180°
  double existence = 0.0;  ///< of the listed object
};

struct ErrorOptions {
  double distance_m = 5.0;  ///< centres farther apart are not the same object; the length of a car, ours
  ReferenceOptions reference;
};

/// Errors of the objects that have a reference: of the same name, else the nearest in the frame, nearest pair first.
/// Lengths and widths are compared as they lie, not as they are called: a board whose short side is its length in the
/// scene has no error for that.
[[nodiscard]] std::vector<ObjectError> errorsOf(const ObjectList& list, const ObjectList& reference,
                                                const ReferenceChoice& choice, const ErrorOptions& options = {});

/// As in docs/formats.md, "Object lists".
[[nodiscard]] std::string toCsv(const ObjectList& list, const ReferenceChoice& choice,
                                const ReferenceOptions& options = {});
[[nodiscard]] std::string toCsv(std::span<const ObjectError> errors);
[[nodiscard]] nlohmann::ordered_json toJson(const ObjectList& list, const ReferenceChoice& choice,
                                            const ReferenceOptions& options = {});
/// What became of the detections, block by block.
[[nodiscard]] nlohmann::ordered_json toJson(const StageCounts& counts);

}  // namespace objects
