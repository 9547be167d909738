#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// What is put out is older than its time stamp: the scene is the one of `delay_s` before, so whatever moves lags.
///
///   Δp = -v · delay_s
///
/// Time stamps stay as they are. A sensor that moves itself (`ego_speed_m_s` of motion-scan) lags by its own way too.
/// Source: Huck, Westenberger, Fritzsche, Schwarz, Dietmayer 2011, IEEE Intelligent Vehicles Symposium (time stamping
/// and latency of sensors).
class Latency final : public Effect {
 public:
  explicit Latency(const EffectParameters& parameters) : delay_s_(parameters.numberOr("delay_s", 0.0)) {}

  void aim(std::span<Beam> beams) const override {
    for (Beam& beam : beams) beam.scene_time_s -= delay_s_;
  }

 private:
  double delay_s_;
};

}  // namespace

EffectEntry latency() {
  return {.info = {.name = "latency",
                   .title = "Latency",
                   .summary = "Values are older than their time stamp says: moving objects seem to lag behind.",
                   .stage = Stage::kPreProcessing,
                   .percollect = {"50", "51"},
                   .parameters = {{"delay_s", "s", 0.0, 0.5, 0.0, "Age of the data at their time stamp", false, 0.05}},
                   .fitted = {"delay_s"},
                   .source = "Huck et al. 2011, IEEE Intelligent Vehicles Symposium",
                   .moves_geometry = true},
          .make = makeFrom<Latency>};
}

}  // namespace model::effects
