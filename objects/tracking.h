#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "objects/box.h"

namespace objects {

/// One segment that is worth being an object: what leaves feature identification.
struct Feature {
  Box box;
  int detections = 0;
  std::string object;  ///< of the scene, if the segmentation knows it; "" otherwise
};

/// An object that is followed from frame to frame.
struct TrackedObject {
  int id = 0;              ///< from 1, in order of appearance
  Feature feature;         ///< as seen last
  double existence = 0.0;  ///< probability
  int age = 1;             ///< frames since it appeared, this one included
  bool seen = true;        ///< in this frame
};

struct Tracking {
  double increment = 0.2;    ///< what a frame adds in which the object was seen
  double decrement = 0.055;  ///< what a frame takes in which it was not
  double threshold = 0.5;    ///< listed from this probability on
  double distance_m = 2.5;   ///< how far its centre may move from one frame to the next
};

/// Follows features over frames and holds a probability of existence for each object.
///
///   p <- min(1, p + increment)   seen      0.2  0.4  0.6 -> listed in the third frame
///   p <- max(0, p - decrement)   not seen  1 … 0.505 -> still listed nine frames after it vanished, not in the tenth
///
/// At p = 0 the object is forgotten. A counter rather than a Bayes filter; box and number of detections are those of
/// the last frame that saw it, nothing is smoothed or predicted. Features that know their object follow it; the others
/// belong to the nearest object, nearest pair first.
/// Source: numbers and limits as in openMSL sl-1-2-reflection-based-lidar-object-model, profiles SCALA 1 and Ibeo LUX.
class Tracker {
 public:
  explicit Tracker(const Tracking& settings) : settings_(settings) {}

  /// Takes the features of the next frame.
  void step(std::span<const Feature> features);

  /// In order of id.
  [[nodiscard]] const std::vector<TrackedObject>& all() const noexcept { return objects_; }
  [[nodiscard]] std::vector<TrackedObject> listed() const;

 private:
  [[nodiscard]] std::vector<std::optional<std::size_t>> featuresOfObjects(std::span<const Feature> features) const;

  Tracking settings_;
  std::vector<TrackedObject> objects_;
  int last_id_ = 0;
};

/// Pairs (i, j) of two lists of boxes, nearest centres first, each in one pair at most, none farther apart than the
/// distance on the ground. Ties: smaller i, then j.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> nearestPairs(std::span<const Box> a,
                                                                            std::span<const Box> b, double distance_m);

}  // namespace objects
