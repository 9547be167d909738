#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// The beam has a cross-section: partial hits, several echoes, r⁻³ and r⁻⁴ laws for small targets (formats.md
/// section 3, step 1). Off: the beam is its one central ray.
class BeamDivergence final : public Effect {
 public:
  explicit BeamDivergence(const EffectParameters& parameters)
      : horizontal_rad_(parameters.number("horizontal_rad")), vertical_rad_(parameters.number("vertical_rad")) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    settings.divergence = {horizontal_rad_.value_or(settings.emitter.divergence.horizontal_rad),
                           vertical_rad_.value_or(settings.emitter.divergence.vertical_rad)};
  }

 private:
  std::optional<double> horizontal_rad_;
  std::optional<double> vertical_rad_;
};

}  // namespace

EffectEntry beamDivergence() {
  return {.info = {.name = "beam-divergence",
                   .title = "Beam divergence",
                   .summary = "The beam widens with distance: it may meet several surfaces at once, and only a part of "
                              "it meets small ones.",
                   .stage = Stage::kEmission,
                   .percollect = {"106", "117", "118", "105"},
                   .parameters = {{"horizontal_rad", "rad", 0.0, 0.2, std::nullopt,
                                   "Full width; without it the profile's", true, 0.003},
                                  {"vertical_rad", "rad", 0.0, 0.2, std::nullopt,
                                   "Full width; without it the profile's", true, 0.003}},
                   .other_forms = {{"of another width", {"horizontal_rad", "vertical_rad"}}},
                   .source = "Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011, sec. 2",
                   .moves_geometry = true},
          .make = makeFrom<BeamDivergence>};
}

}  // namespace model::effects
