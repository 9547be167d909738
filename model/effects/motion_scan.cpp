#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// The beams of a frame are fired one after the other, and everything moves in the meantime: a car that crosses is
/// longer or shorter, one that approaches is bent. A beam fired at t meets an object where it then stands,
///
///   p(t) = p(0) + (v_object - v_sensor) t,      t: since the start of the frame
///
/// and reports it as if it had been there all along. v_sensor = `ego_speed_m_s` along the sensor's x. Objects and
/// sensor do not turn while they move. Off: all beams meet the scene as it is at the start of the frame.
/// Source: Groll & Kapp 2007, IEEE Trans. Signal Process. 55 (effect of fast motion on range images of lidar scanners).
class MotionScan final : public Effect {
 public:
  explicit MotionScan(const EffectParameters& parameters) : ego_speed_m_s_(parameters.numberOr("ego_speed_m_s", 0.0)) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    settings.sensor_velocity_m_s[0] += ego_speed_m_s_;
  }
  void aim(std::span<Beam> beams) const override {
    for (Beam& beam : beams) beam.scene_time_s += beam.time_s;
  }

 private:
  double ego_speed_m_s_;
};

}  // namespace

EffectEntry motionScan() {
  return {.info = {.name = "motion-scan",
                   .title = "Motion during the scan",
                   .summary = "The beams of one frame are fired one after the other, while objects move on: moving "
                              "objects look distorted.",
                   .stage = Stage::kInteraction,
                   .percollect = {"102", "17", "81"},
                   .parameters = {{"ego_speed_m_s", "m/s", -80.0, 80.0, 0.0, "Speed of the sensor along its x axis",
                                   false, 0.0}},
                   .source = "Groll & Kapp 2007, IEEE Trans. Signal Process. 55",
                   .moves_geometry = true},
          .make = makeFrom<MotionScan>};
}

}  // namespace model::effects
