#pragma once

#include <string>
#include <vector>

#include "bench/withheld/generator/shots.h"
#include "bench/withheld/generator/world.h"

namespace withheld {

/// A sample of an experiment package after its patch and the true reference errors.
struct Sample {
  std::string id, measurements, sensor;
  int frames = 1;
  Scene scene;
  Environment environment;
  std::vector<Beam> beams;  ///< empty: the profile's scan
};

struct Package {
  std::string folder;
  std::vector<Sample> samples;
  std::vector<std::string> copied;           ///< files that go along as they are, inside the folder
  std::map<std::string, std::string> names;  ///< our column name → the package's
};

/// Where the true scene stands other than the recorded one:
///
///     {"reference_offsets": {"/scene/0/pose/position_m/0": {"everywhere": 0.03, "per_setup": {"day-2": -0.1}}},
///      "setup_scatter": {"/scene/0/pose/position_m/0": 0.01}}
///
/// True minus recorded, added after the sample's patch; the scatter is drawn once a set-up.
[[nodiscard]] Package readPackage(const std::string& folder, const std::string& truth_file, std::uint64_t seed);

/// Lines of a measurement, numbers rounded as the sensor does.
[[nodiscard]] std::string measurementText(const std::vector<Detection>& detections, const std::vector<Beam>& beams,
                                          const Profile& profile, const std::map<std::string, std::string>& names);

/// Writes experiment.json as it was and one file a sample. Throws BadInput if a file cannot be written.
void writePackage(const Package& package, const std::vector<std::string>& texts, const std::string& folder);

/// All samples, on `threads` threads; the same texts for any number of them.
[[nodiscard]] std::vector<std::string> simulate(const Package& package, const World& world, std::uint64_t seed,
                                                int threads);

}  // namespace withheld
