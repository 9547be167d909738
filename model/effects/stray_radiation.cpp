#include <cmath>
#include <numbers>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

constexpr int kRings = 3;

/// Dirt, scratches and reflections inside the sensor throw a little of the light beside the beam: around it lies a weak
/// pedestal, and what stands in it echoes in beams that point past it. Only bright targets are seen so: signs and
/// reflectors get ghosts beside them.
///
///   w_pedestal = fraction / 4K²  each on 4K² sub-rays,   w_beam = (1 - fraction) w
///
/// The pedestal is even over a cone of `half_angle_rad` around the beam's axis, cut into K = 3 rings of 4 (2k - 1)
/// cells of equal area, with a sub-ray where it halves the mean square radius of its cell. A target smaller than a cell
/// (a sixth of the half angle) may be missed or counted whole. The receiver is taken to see all of the cone.
/// Source: Peterson 2004, Proc. SPIE 5178 (in-field scattered light of optical systems); the even cone is its simplest
/// reading.
class StrayRadiation final : public Effect {
 public:
  explicit StrayRadiation(const EffectParameters& parameters)
      : fraction_(parameters.numberOr("fraction", 1e-4)),
        half_angle_rad_(parameters.numberOr("half_angle_rad", 0.02)) {}

  void spread(SubRays& rays, const ChainSettings&) const override {
    if (fraction_ <= 0.0) return;
    for (double& weight : rays.weight) weight *= 1.0 - fraction_;
    for (int ring = 1; ring <= kRings; ++ring) {
      const int cells = 4 * (2 * ring - 1);
      const double inner = static_cast<double>(ring - 1) / kRings, outer = static_cast<double>(ring) / kRings;
      const double radius_rad = half_angle_rad_ * std::sqrt((inner * inner + outer * outer) / 2.0);
      for (int cell = 0; cell < cells; ++cell) {
        const double around = 2.0 * std::numbers::pi * (cell + 0.5) / cells;
        rays.add(radius_rad * std::cos(around), radius_rad * std::sin(around), fraction_ / (4 * kRings * kRings));
      }
    }
  }

 private:
  double fraction_;
  double half_angle_rad_;
};

}  // namespace

EffectEntry strayRadiation() {
  return {
      .info = {.name = "stray-radiation",
               .title = "Stray radiation around the beam",
               .summary =
                   "A little light travels beside the beam: bright objects give ghosts in beams that pass beside them.",
               .stage = Stage::kEmission,
               .percollect = {"139", "140"},
               .parameters = {{"fraction", "", 0.0, 1e-2, 1e-4,
                               "Share of the beam's power that strays; seldom below 1e-6", true, 1e-4},
                              {"half_angle_rad", "rad", 0.002, 0.1, 0.02, "From the beam's axis to the pedestal's edge",
                               true, 0.02}},
               .fitted = {"fraction"},
               .other_forms = {{"other angle", {"fraction", "half_angle_rad"}, true}},
               .source = "Peterson 2004, Proc. SPIE 5178 (in-field scattered light)",
               .moves_geometry = true},
      .make = makeFrom<StrayRadiation>};
}

}  // namespace model::effects
