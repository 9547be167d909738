#include <limits>

#include "model/effects/declarations.h"
#include "model/effects/soft_target.h"
#include "model/extinction.h"

namespace model::effects {

namespace {

/// Fog sends light back from every range: a rise of the signal close to the sensor, a floor farther out.
///
///   P(r) = η A_r P_t · β · (c τ / 2) · exp(-2 α r) · χ(r) / r²     within one pulse length c τ / 2; soft_target.h
///
///   α  extinction from the visibility (model/extinction.h); α = S β if only β is given
///   β  backscatter, given or α / S with S = 18.8 sr of water droplets
///
/// χ is the profile's overlap (model/overlap.h): with a field of view and an offset of the axes the nearest metres stay
/// dark, without them the signal grows towards the end of the blind range. Single scattering; surfaces are weakened by
/// atmospheric-attenuation. Hahner et al. use β = 0.046 / visibility, which is α / 65 sr: give it as
/// backscatter_1_m_sr to follow them.
/// Source: Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011; Hahner et al. 2021, Fog Simulation on Real LiDAR Point
/// Clouds, ICCV; O'Connor et al. 2004, J. Atmos. Oceanic Technol. 21, 777 (S).
class AtmosphericBackscatter final : public Effect {
 public:
  explicit AtmosphericBackscatter(const EffectParameters& parameters)
      : visibility_m_(parameters.number("visibility_m")), given_1_m_sr_(parameters.number("backscatter_1_m_sr")) {}

  void prepare(ChainSettings& settings, const Environment& environment) override {
    const std::optional<double> visibility_m = visibility_m_ ? visibility_m_ : environment.visibility_m;
    if (visibility_m) {
      fog_.extinction_1_m = extinctionFromVisibility(*visibility_m, settings.emitter.wavelength_nm);
    } else {
      fog_.extinction_1_m = kLidarRatioOfDroplets_sr * given_1_m_sr_.value_or(0.0);
    }
    fog_.backscatter_1_m_sr = given_1_m_sr_.value_or(fog_.extinction_1_m / kLidarRatioOfDroplets_sr);
    fog_.to_m = std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] bool addsPulses() const override { return fog_.backscatter_1_m_sr > 0.0; }
  void addPulses(const BeamView& view, std::vector<Pulse>& pulses) const override { addSoftTarget(view, fog_, pulses); }

 private:
  std::optional<double> visibility_m_;
  std::optional<double> given_1_m_sr_;
  SoftTarget fog_;
};

}  // namespace

EffectEntry atmosphericBackscatter() {
  return {.info = {.name = "atmospheric-backscatter",
                   .title = "Backscatter by the atmosphere",
                   .summary = "The air itself throws light back, which gives echoes from near the sensor and raises "
                              "what the receiver sees.",
                   .stage = Stage::kPropagation,
                   .percollect = {"89", "94", "95"},
                   .parameters = {{"visibility_m", "m", 20.0, 20000.0, std::nullopt,
                                   "Meteorological visibility; without it the experiment's environment", true, 200.0},
                                  {"backscatter_1_m_sr", "1/(m sr)", 1e-7, 0.1, std::nullopt,
                                   "Backscatter coefficient; without it extinction over 18.8 sr", true, 1e-3}},
                   .fitted = {"visibility_m"},
                   .other_forms = {{"of other droplets", {"visibility_m", "backscatter_1_m_sr"}, true}},
                   .source = "Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011; Hahner et al. 2021, ICCV; O'Connor et "
                             "al. 2004, J. Atmos. Oceanic Technol. 21, 777"},
          .make = makeFrom<AtmosphericBackscatter>};
}

}  // namespace model::effects
