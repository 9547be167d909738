#include <algorithm>
#include <cmath>

#include "model/effects/declarations.h"
#include "model/scene/scene.h"

namespace model::effects {

namespace {

/// The sensor stands turned and shifted against what everybody assumes: its beams leave from another place in turned
/// directions while it reports the nominal ones. d_true = Rz(yaw) · Ry(pitch) · Rx(roll) · d_nominal, ISO 8855
/// (positive pitch looks down); origin = `position_m`, true minus assumed, in the frame of the scene. The cross-section
/// of a beam does not roll along; at a few degrees that turns it by less than its own cells. Source: Glennie & Lichti
/// 2010, doi:10.3390/rs2061610 (boresight angles).
class MountingError final : public Effect {
 public:
  explicit MountingError(const EffectParameters& parameters) {
    turn_.yaw_deg = parameters.numberOr("yaw_deg", 0.0);
    turn_.pitch_deg = parameters.numberOr("pitch_deg", 0.0);
    turn_.roll_deg = parameters.numberOr("roll_deg", 0.0);
    const std::vector<double> shift_m = parameters.listOr("position_m", {0.0, 0.0, 0.0});
    std::copy_n(shift_m.begin(), shift_m_.size(), shift_m_.begin());
  }

  void prepare(ChainSettings& settings, const Environment&) override {
    for (std::size_t i = 0; i < shift_m_.size(); ++i) settings.sensor_position_m[i] += shift_m_[i];
  }

  void aim(std::span<Beam> beams) const override {
    const auto r = turn_.rotation();
    for (Beam& beam : beams) {
      const double ce = std::cos(beam.elevation_rad);
      const Vector3 d = {ce * std::cos(beam.azimuth_rad), ce * std::sin(beam.azimuth_rad),
                         std::sin(beam.elevation_rad)};
      Vector3 turned{};
      for (std::size_t i = 0; i < 3; ++i) turned[i] = r[i][0] * d[0] + r[i][1] * d[1] + r[i][2] * d[2];
      beam.azimuth_rad = std::atan2(turned[1], turned[0]);
      beam.elevation_rad = std::asin(std::clamp(turned[2], -1.0, 1.0));
    }
  }

 private:
  Pose turn_;
  Vector3 shift_m_{};
};

}  // namespace

EffectEntry mountingError() {
  return {
      .info = {.name = "mounting-error",
               .title = "Error of the sensor's mounting",
               .summary =
                   "The sensor stands or looks other than assumed: everything that it sees is displaced or turned.",
               .stage = Stage::kEmission,
               .percollect = {"7"},
               .parameters =
                   {{"yaw_deg", "deg", -5.0, 5.0, 0.0, "True minus assumed yaw, positive to the left", false, 0.5},
                    {"pitch_deg", "deg", -5.0, 5.0, 0.0, "True minus assumed pitch, positive down", false, 0.5},
                    {"roll_deg", "deg", -5.0, 5.0, 0.0, "True minus assumed roll, positive to the right", false, 0.5}},
               .fitted = {"yaw_deg", "pitch_deg"},
               .other_forms = {{"roll", {"roll_deg"}}},
               .source = "Glennie & Lichti 2010, doi:10.3390/rs2061610",
               .moves_geometry = true},
      .make = makeFrom<MountingError>,
      .lists = {{"position_m", "m", -2.0, 2.0, 3, "True minus assumed position: forward, left, up"}}};
}

}  // namespace model::effects
