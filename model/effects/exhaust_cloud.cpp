#include <cmath>

#include "model/effects/declarations.h"
#include "model/effects/soft_target.h"

namespace model::effects {

namespace {

/// A sphere of exhaust: it weakens what lies behind it and sends light back itself.
///
///   P_behind = P · exp(-2 α l)      l: way of the sub-ray inside the sphere, before its surface
///   P_cloud: soft target (soft_target.h) with β = ω α / S along the way of the beam's axis
///
/// ω is the single-scattering albedo: near 1 for condensed water of a cold engine, 0.2 … 0.3 for soot; S = 18.8 sr,
/// right for droplets, an assumption for soot. The centre stands in the sensor's nominal frame. Ways by a mirror are
/// taken as straight; light that went through a pane counts in full. Source: Beer–Lambert law; Bond & Bergstrom 2006,
/// doi:10.1080/02786820500421521; Hasirlioglu et al. 2017, Effects of Exhaust Gases on Laser Scanner Data Quality at
/// Low Ambient Temperatures, IEEE Intelligent Vehicles Symposium.
class ExhaustCloud final : public Effect {
 public:
  explicit ExhaustCloud(const EffectParameters& parameters)
      : extinction_1_m_(parameters.numberOr("extinction_1_m", 0.5)),
        albedo_(parameters.numberOr("albedo", 0.9)),
        radius_m_(parameters.numberOr("size_m", 1.0) / 2.0) {
    const std::vector<double> centre = parameters.listOr("centre", {10.0, 0.0, 0.0});
    centre_m_ = {centre[0], centre[1], centre[2]};
  }

  void prepare(ChainSettings& settings, const Environment&) override { sensor_m_ = settings.sensor_position_m; }
  [[nodiscard]] bool changesPower() const override { return extinction_1_m_ > 0.0; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    const Passage way = passageThroughSphere(sensor_m_, reflection.direction(), centre_m_, radius_m_);
    return std::exp(-2.0 * extinction_1_m_ * way.lengthBefore_m(reflection.range_m));
  }
  [[nodiscard]] bool addsPulses() const override { return extinction_1_m_ * albedo_ > 0.0; }
  void addPulses(const BeamView& view, std::vector<Pulse>& pulses) const override {
    const Passage way = passageThroughSphere(sensor_m_, directionOf(view.beam, 0.0, 0.0), centre_m_, radius_m_);
    addSoftTarget(view,
                  {.from_m = way.enter_m,
                   .to_m = way.leave_m,
                   .backscatter_1_m_sr = albedo_ * extinction_1_m_ / kLidarRatioOfDroplets_sr,
                   .extinction_1_m = extinction_1_m_,
                   .extinction_from_m = way.enter_m},
                  pulses);
  }

 private:
  double extinction_1_m_;
  double albedo_;
  double radius_m_;
  Vector3 centre_m_{};
  Vector3 sensor_m_{};
};

}  // namespace

EffectEntry exhaustCloud() {
  return {
      .info = {.name = "exhaust-cloud",
               .title = "Cloud of exhaust gas",
               .summary = "A cloud that stands in the scene takes light away and throws some of it back.",
               .stage = Stage::kPropagation,
               .percollect = {"94", "141"},
               .parameters = {{"extinction_1_m", "1/m", 0.0, 10.0, 0.5, "Extinction inside the cloud", true, 0.5},
                              {"size_m", "m", 0.1, 10.0, 1.0, "Diameter of the cloud", false, 1.5},
                              {"albedo", "", 0.0, 1.0, 0.9, "Share of the extinction that is scattering", false, 0.25}},
               .fitted = {"extinction_1_m", "size_m"},
               .other_forms = {{"of another albedo", {"extinction_1_m", "size_m", "albedo"}}},
               .source = "Beer–Lambert law; Bond & Bergstrom 2006, doi:10.1080/02786820500421521; Hasirlioglu et "
                         "al. 2017, IEEE Intelligent Vehicles Symposium"},
      .make = makeFrom<ExhaustCloud>,
      .texts = {},
      .lists = {{"centre", "m", -300.0, 300.0, 3, "Centre of the cloud, sensor frame (default 10, 0, 0)"}}};
}

}  // namespace model::effects
