#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/physics.h"
#include "model/effects/declarations.h"
#include "model/effects/shot_noise.h"

namespace model::effects {

namespace {

constexpr double kSceneReflectivity = 0.3;  ///< of what a field of view sees on the average
constexpr double kSkyReflectivity = 0.1;    ///< of a surface as bright as the clear sky: its share of all light
constexpr double kFilterWidth_nm = 20.0;    ///< optical band pass
constexpr double kSunRadius_rad = 0.00465;
constexpr double kAerosolDepth = 0.1;    ///< optical depth of hazy clear air towards the sun
constexpr double kForwardScatter = 0.7;  ///< asymmetry of its phase function

double reflectivityOf(const Scene& scene, std::int32_t object) {
  return scene.materials[scene.objects[static_cast<std::size_t>(object)].material].reflectivity;
}

/// Radiance of the air around the sun over the sun's irradiance. [1/sr] Source: Henyey & Greenstein 1941,
/// doi:10.1086/144246 (phase function), once scattered.
double aureole(double cos_to_sun) {
  constexpr double g = kForwardScatter;
  return kAerosolDepth / (4.0 * std::numbers::pi) * (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cos_to_sun, 1.5);
}

/// Shot noise of sunlight in the receiver; it adds to the receiver's noise in quadrature (shot_noise.h).
///
///   P_b = E_λ Δλ · ρ/π · A_r Ω η                  what a beam's surfaces reflect into the field of view Ω
///   P_s = E_λ Δλ · A_r η · (v + a(δ) Ω)           towards the sun, for a beam at the angle δ to it
///   σ²  = σ_0² + shot noise of P_b + P_s
///
/// ρ is the mean over the beam's sub-rays, each of which sees the surface that it meets first, or the sky. The noise of
/// the sensor as a whole, which thresholds follow, is that of a scene of ρ = 0.3. v is the share of the sun's disc in
/// the field of view (taken as a circle of the same area), a(δ) the aureole of once-scattered light. P_s counts if the
/// sun's direction is given and it stands above the horizon. Whether a surface stands before the sun is not asked:
/// every beam of such a direction is dazzled.
/// Source: Gagliardi & Karp 1995, Optical Communications, ch. 2; Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011;
/// the sky: Bird & Riordan 1986, J. Climate Appl. Meteorol. 25, 87 (diffuse over global irradiance in the near
/// infrared).
class BackgroundLight final : public Effect {
 public:
  explicit BackgroundLight(const EffectParameters& parameters)
      : irradiance_(parameters.number("irradiance_w_m2_nm")),
        sun_azimuth_deg_(parameters.number("sun_azimuth_deg")),
        sun_elevation_deg_(parameters.number("sun_elevation_deg")) {}

  void prepare(ChainSettings& settings, const Environment& environment) override {
    const double irradiance = irradiance_.value_or(environment.background_irradiance_w_m2_nm.value_or(0.0));
    Receiver& receiver = settings.receiver;
    const AngularSize& view =
        receiver.field_of_view.horizontal_rad > 0.0 ? receiver.field_of_view : settings.emitter.divergence;
    const double aperture_m2 = std::numbers::pi / 4.0 * receiver.aperture_diameter_m * receiver.aperture_diameter_m;
    solid_angle_sr_ = view.horizontal_rad * view.vertical_rad;
    const double light_w = irradiance * kFilterWidth_nm * aperture_m2 * receiver.efficiency;  // of 1 sr, if as bright
    white_noise_w2_ = shotNoise_w2(settings.emitter, light_w / std::numbers::pi * solid_angle_sr_);
    receiver.noise_w = std::sqrt(receiver.noise_w * receiver.noise_w + kSceneReflectivity * white_noise_w2_);
    const double elevation_deg = sun_elevation_deg_.value_or(0.0);
    if (elevation_deg <= 0.0) return;
    sun_ = directionOf({.azimuth_rad = sun_azimuth_deg_.value_or(0.0) * core::kRadPerDeg,
                        .elevation_rad = elevation_deg * core::kRadPerDeg},
                       0.0, 0.0);
    sun_noise_w2_ = shotNoise_w2(settings.emitter, light_w);
  }
  [[nodiscard]] bool addsNoise() const override { return white_noise_w2_ > 0.0; }
  [[nodiscard]] double addedNoise_w2(const BeamView& view) const override {
    return (reflectivityBefore(view) - kSceneReflectivity) * white_noise_w2_ + sunNoise_w2(view.beam);
  }

 private:
  /// ρ of a beam; what sends light back and is unknown, as hits from elsewhere are, is a scene on the average.
  [[nodiscard]] static double reflectivityBefore(const BeamView& view) {
    double met = 0.0, sum = 0.0;
    for (const Hit& hit : view.hits) {
      const double weight = view.rays.weight[hit.ray];
      met += weight;
      sum += weight * (hit.object < 0 ? kSceneReflectivity : reflectivityOf(view.scene, hit.object));
    }
    return (sum + std::max(0.0, 1.0 - met) * kSkyReflectivity) / std::max(1.0, met);
  }
  [[nodiscard]] double sunNoise_w2(const Beam& beam) const {
    if (sun_noise_w2_ <= 0.0) return 0.0;
    const Vector3 d = directionOf(beam, 0.0, 0.0);
    const double cos_to_sun = std::clamp(d[0] * sun_[0] + d[1] * sun_[1] + d[2] * sun_[2], -1.0, 1.0);
    return (discInView(std::acos(cos_to_sun)) + aureole(cos_to_sun) * solid_angle_sr_) * sun_noise_w2_;
  }
  /// Share of the sun's disc in the field of view; linear where its edge crosses the view's edge.
  [[nodiscard]] double discInView(double to_sun_rad) const {
    const double view_radius_rad = std::sqrt(solid_angle_sr_ / std::numbers::pi);
    const double smaller = std::min(view_radius_rad, kSunRadius_rad);
    const double most = smaller * smaller / (kSunRadius_rad * kSunRadius_rad);
    return most * std::clamp((view_radius_rad + kSunRadius_rad - to_sun_rad) / (2.0 * smaller), 0.0, 1.0);
  }

  std::optional<double> irradiance_;
  std::optional<double> sun_azimuth_deg_;
  std::optional<double> sun_elevation_deg_;
  Vector3 sun_{};
  double solid_angle_sr_ = 0.0;
  double white_noise_w2_ = 0.0;  ///< before a white surface
  double sun_noise_w2_ = 0.0;    ///< if all of the sun's direct light came in
};

}  // namespace

EffectEntry backgroundLight() {
  return {
      .info = {.name = "background-light",
               .title = "Shot noise of background light",
               .summary = "Sunlight in the receiver adds noise: weak echoes are lost and noise is taken for echoes, "
                          "before bright surfaces and most towards the sun.",
               .stage = Stage::kReception,
               .percollect = {"86", "90", "91", "99", "101", "143"},
               .parameters = {{"irradiance_w_m2_nm", "W/(m² nm)", 0.0, 1.0, std::nullopt,
                               "Spectral irradiance of the scene; without it the experiment's environment", false, 0.5},
                              {"sun_azimuth_deg", "deg", -180.0, 180.0, std::nullopt,
                               "Where the sun stands, counted to the left from straight ahead", false, 0.0},
                              {"sun_elevation_deg", "deg", -90.0, 90.0, std::nullopt,
                               "Its height; without it, or below the horizon, no beam is dazzled", false, 10.0}},
               .fitted = {"irradiance_w_m2_nm"},
               .source = "Gagliardi & Karp 1995; Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011"},
      .make = makeFrom<BackgroundLight>};
}

}  // namespace model::effects
