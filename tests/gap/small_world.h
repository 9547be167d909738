#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "model/experiment.h"
#include "model/lidar_model.h"
#include "tests/support/paths.h"

namespace test_support {

/// A small experiment whose measurement is made by one model and diagnosed with another: a wall in front of a 4-layer
/// scanner at six ranges, two of them held out.
class SmallWorld {
 public:
  using Effects = std::map<std::string, nlohmann::json>;

  explicit SmallWorld(double reflectivity = 0.4) : reflectivity_(reflectivity) {}

  /// The model with these effects beside beam divergence; other `sensor` values by JSON Pointer.
  [[nodiscard]] static model::LidarModel modelWith(const Effects& effects,
                                                   const std::map<std::string, double>& sensor = {});
  /// The same with so many sub-rays in every row and column of a beam.
  [[nodiscard]] static model::LidarModel withRays(int in_a_row, const Effects& effects = {},
                                                  const std::map<std::string, double>& sensor = {});
  /// Of beams so tall that neighbours of three sub-rays meet a wall that leans by 80 degrees 1.1 m apart, farther than
  /// a pulse is long (0.67 m); neighbours of 51 do not.
  [[nodiscard]] static std::map<std::string, double> tallBeams() {
    return {{"/sensor/emitter/divergence_rad/vertical", 0.03}, {"/sensor/emitter/peak_power_w", 500.0}};
  }
  /// Of a sensor that looks hardly past its beam: 8 m away it sees the whole beam up to an aperture offset of 50 mm,
  /// and nothing of it from 58 mm on.
  [[nodiscard]] static std::map<std::string, double> narrowView() {
    return {{"/sensor/receiver/field_of_view_rad/horizontal", 0.012},
            {"/sensor/receiver/field_of_view_rad/vertical", 0.012}};
  }
  /// The package as recorded: measured by `truth` in a world in which the wall stands `offset_m` farther than recorded
  /// (per sample, 0 if absent) and has `true_reflectivity`.
  [[nodiscard]] model::Experiment measuredBy(const model::LidarModel& truth, double true_reflectivity,
                                             const std::map<std::string, double>& offset_m = {}) const;
  /// experiment.json of the world in which the wall stands `offset_m` farther than recorded.
  [[nodiscard]] nlohmann::json recorded(const std::map<std::string, double>& offset_m = {}) const;
  /// With a wall so wide; as it is, no beam meets its edges.
  SmallWorld& withAWallOf(double width_m);
  /// The same, leaning away from the sensor by this angle.
  SmallWorld& leaning(double pitch_deg);
  /// The same, seen through a large pane of glass so far away.
  SmallWorld& behindAPane(double at_m);
  /// The same, recorded with an epistemic interval of ± `half_m` for the wall's distance.
  SmallWorld& knownToWithin(double half_m);
  /// Measured under other noise than usual; never that of the model under test.
  SmallWorld& measuredUnder(std::uint64_t seed);
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

 private:
  [[nodiscard]] nlohmann::json withThings(double reflectivity, const std::map<std::string, double>& offset_m) const;

  double reflectivity_;
  double wall_width_m_ = 60.0;
  double pitch_deg_ = 0.0;
  double pane_at_m_ = 0.0;  ///< 0: there is none
  double known_to_within_m_ = 0.0;
  std::uint64_t seed_ = 4711;
  TemporaryFolder folder_;
};

}  // namespace test_support
