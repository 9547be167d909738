#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Area that two circles share, as a share of the first one's.
double sharedArea(double radius, double other, double distance) {
  if (distance >= radius + other) return 0.0;
  if (distance <= other - radius) return 1.0;
  if (distance <= radius - other) return other * other / (radius * radius);
  const double a = std::acos((distance * distance + radius * radius - other * other) / (2.0 * distance * radius));
  const double b = std::acos((distance * distance + other * other - radius * radius) / (2.0 * distance * other));
  const double area = radius * radius * (a - 0.5 * std::sin(2.0 * a)) + other * other * (b - 0.5 * std::sin(2.0 * b));
  return area / (std::numbers::pi * radius * radius);
}

/// Emitter and receiver look out side by side: near the sensor the receiver does not see the whole illuminated spot.
///
///   χ(r) = share of the beam's disc (radius r φ/2) inside the field of view's disc (radius D/2 + r Ψ/2),
///          centres `offset` apart, axes parallel
///
/// φ and Ψ are the horizontal full widths, the larger one if that is zero. Without a field of view in the profile χ
/// = 1. Source: Stelmaszczyk et al. 2005, doi:10.1364/AO.44.001323 (geometrical compression form factor).
class ApertureOffset final : public Effect {
 public:
  explicit ApertureOffset(const EffectParameters& parameters) : given_m_(parameters.number("offset_m")) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    const AngularSize& beam = settings.emitter.divergence;
    const AngularSize& view = settings.receiver.field_of_view;
    offset_m_ = std::abs(given_m_.value_or(settings.receiver.axis_offset_m));
    aperture_m_ = settings.receiver.aperture_diameter_m / 2.0;
    half_beam_rad_ = (beam.horizontal_rad > 0.0 ? beam.horizontal_rad : beam.vertical_rad) / 2.0;
    half_view_rad_ = (view.horizontal_rad > 0.0 ? view.horizontal_rad : view.vertical_rad) / 2.0;
  }
  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    if (half_view_rad_ == 0.0) return 1.0;
    const double spot_m = std::max(1e-6, reflection.range_m * half_beam_rad_);
    return sharedArea(spot_m, aperture_m_ + reflection.range_m * half_view_rad_, offset_m_);
  }

 private:
  std::optional<double> given_m_;
  double offset_m_ = 0.0;
  double aperture_m_ = 0.0;
  double half_beam_rad_ = 0.0;
  double half_view_rad_ = 0.0;
};

}  // namespace

EffectEntry apertureOffset() {
  return {.info = {.name = "aperture-offset",
                   .title = "Offset of the receiver's axis",
                   .stage = Stage::kEmission,
                   .percollect = {"14", "73", "107"},
                   .parameters = {{"offset_m", "m", 0.0, 0.1, std::nullopt,
                                   "Distance of the axes; without it the profile's", false, 0.03}},
                   .fitted = {"offset_m"},
                   .source = "Stelmaszczyk et al. 2005, doi:10.1364/AO.44.001323"},
          .make = makeFrom<ApertureOffset>};
}

}  // namespace model::effects
