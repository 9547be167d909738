#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "model/effects/declarations.h"
#include "model/effects/soft_target.h"
#include "model/overlap.h"

namespace model::effects {

namespace {

constexpr double kSmallestEcho = 0.1;  ///< of the threshold; weaker particles are the attenuation's
constexpr double kMillimetre = 1e-3;

/// Size distribution N(D) = N_0 exp(-Λ D) per volume, and what a particle of diameter D does to light.
struct Particles {
  double number_1_m4 = 0.0;       ///< N_0
  double slope_1_m = 1.0;         ///< Λ
  double area_over_sphere = 1.0;  ///< cross-section over π D²/4; D is the melted diameter
  double backscatter_1_sr = 0.0;  ///< radiant intensity sent back over power caught
  double smallest_m = 0.0;        ///< melted diameter
};

/// What is known of drops of rain no better than to a factor: the lidar ratio of soft_target.h is that of spheres, and
/// drops flatten as they fall; and the exponential law has too many small ones (Marshall & Palmer 1948, below 1.5 mm).
struct Drops {
  double lidar_ratio_sr = kLidarRatioOfDroplets_sr;
  double smallest_mm = 0.0;
};

/// Marshall & Palmer 1948: N_0 = 8000 /(m³ mm), Λ = 4.1 R^-0.21 /mm. A drop catches twice its cross-section (half of it
/// is diffraction) and sends 1/S of that back.
Particles rain(double rate_mm_h, const Drops& drops) {
  return {8000.0 / kMillimetre, 4.1 * std::pow(rate_mm_h, -0.21) / kMillimetre, 1.0, 2.0 / drops.lidar_ratio_sr,
          drops.smallest_mm * kMillimetre};
}

/// Gunn & Marshall 1958: N_0 = 3800 R^-0.87 /(m³ mm), Λ = 2.55 R^-0.48 /mm, R and D of the melted water. Taken as
/// Lambertian spheres of density 100 kg/m³ and reflectivity 0.8.
Particles snow(double rate_mm_h) {
  return {3800.0 * std::pow(rate_mm_h, -0.87) / kMillimetre, 2.55 * std::pow(rate_mm_h, -0.48) / kMillimetre,
          std::pow(10.0, 2.0 / 3.0), 0.8 / std::numbers::pi};
}

/// The particles of one kind that are worth an echo of their own, as a Poisson process over the range.
///
///   mean number per range  A(r) ∫_{D_0(r)} N(D) dD = A(r) (N_0/Λ) exp(-Λ D_0(r))
class Field {
 public:
  Field(const Particles& kind, const ChainSettings& settings, double window_m);

  struct Particle {
    double range_m;
    double power_w;
    double blocked;  ///< share of the beam
  };
  void draw(const BeamView& view, core::Random& random, std::vector<Particle>& out) const;

 private:
  [[nodiscard]] double footprint_m2(double range_m) const {
    return (window_m_ + divergence_.horizontal_rad * range_m) * (window_m_ + divergence_.vertical_rad * range_m);
  }
  /// Diameter from which on a particle counts.
  [[nodiscard]] double leastDiameter_m(double range_m) const {
    const double least_area_m2 = footprint_m2(range_m) * least_share_m2_;
    return std::max(kind_.smallest_m,
                    range_m * std::sqrt(least_area_m2 / (area_over_sphere_ * std::numbers::pi / 4.0)));
  }
  [[nodiscard]] double number_1_m(double range_m) const {
    return footprint_m2(range_m) * kind_.number_1_m4 / kind_.slope_1_m *
           std::exp(-kind_.slope_1_m * leastDiameter_m(range_m));
  }

  /// The cell in which the cumulative mean number reaches `place`.
  [[nodiscard]] std::size_t cellAt(double place) const {
    std::size_t cell = cells_from_[static_cast<std::size_t>(place / mean_until_.back() * (kCells - 1))];
    while (cell > 0 && place < mean_until_[cell]) --cell;  // rounding
    while (cell + 1 < kCells && place >= mean_until_[cell + 1]) ++cell;
    return cell;
  }

  static constexpr std::size_t kCells = 4096;
  Particles kind_;
  AngularSize divergence_;
  double window_m_;
  double area_over_sphere_;
  double least_share_m2_;  ///< share of the beam that a particle at r must block, over r²
  double begin_m_;
  double step_m_ = 0.0;
  std::vector<double> mean_until_;         ///< cumulative mean number at the ends of the cells
  std::vector<std::uint32_t> cells_from_;  ///< where to begin, for even parts of the mean number
};

Field::Field(const Particles& kind, const ChainSettings& settings, double window_m)
    : kind_(kind),
      divergence_(settings.emitter.divergence),
      window_m_(window_m),
      area_over_sphere_(kind.area_over_sphere),
      begin_m_(settings.detection.min_range_m) {
  const Receiver& receiver = settings.receiver;
  const double aperture_m2 = std::numbers::pi / 4.0 * receiver.aperture_diameter_m * receiver.aperture_diameter_m;
  const double constant_w_m2 =
      settings.emitter.peak_power_w * receiver.efficiency * aperture_m2 * kind.backscatter_1_sr;
  least_share_m2_ = kSmallestEcho * receiver.threshold_w / constant_w_m2;
  constexpr double kRarest = 40.0;  // exp(-40): none of that size
  double end_m = settings.detection.max_range_m;
  while (end_m > 1.01 * begin_m_ && kind.slope_1_m * leastDiameter_m(end_m) > kRarest) end_m *= 0.95;
  step_m_ = std::max(0.0, end_m - begin_m_) / static_cast<double>(kCells);
  mean_until_.push_back(0.0);
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const double middle_m = begin_m_ + (static_cast<double>(cell) + 0.5) * step_m_;
    mean_until_.push_back(mean_until_.back() + number_1_m(middle_m) * step_m_);
  }
  for (std::uint32_t part = 0, cell = 0; part < kCells; ++part) {
    const double place = mean_until_.back() * part / (kCells - 1);
    while (cell + 1 < kCells && place >= mean_until_[cell + 1]) ++cell;
    cells_from_.push_back(cell);
  }
}

void Field::draw(const BeamView& view, core::Random& random, std::vector<Particle>& out) const {
  const std::uint32_t count = random.poisson(mean_until_.back());
  for (std::uint32_t i = 0; i < count; ++i) {
    const double place = random.uniform() * mean_until_.back(), rarer = random.uniform();
    const double in_the_open = random.uniform();
    const std::size_t cell = cellAt(place);
    const double before = mean_until_[cell], within = (place - before) / (mean_until_[cell + 1] - before);
    const double range_m = begin_m_ + (static_cast<double>(cell) + within) * step_m_;
    if (in_the_open >= openShare(view, range_m)) continue;  // behind a surface
    const double diameter_m = leastDiameter_m(range_m) - std::log(rarer) / kind_.slope_1_m;
    const double area_m2 = area_over_sphere_ * std::numbers::pi / 4.0 * diameter_m * diameter_m;
    const double blocked = std::min(1.0, area_m2 / footprint_m2(range_m));
    const double seen = overlap(view.settings.emitter, view.settings.receiver, range_m);
    out.push_back(
        {range_m, view.power_constant_w_m2 * kind_.backscatter_1_sr * blocked * seen / (range_m * range_m), blocked});
  }
}

/// How much light the particles leave. Sorts them by range.
class Shadows {
 public:
  explicit Shadows(std::vector<Field::Particle>& particles) : particles_(particles) {
    std::stable_sort(particles.begin(), particles.end(), nearer);
    for (const Field::Particle& particle : particles)
      left_.push_back(left_.back() * (1.0 - particle.blocked) * (1.0 - particle.blocked));
  }
  [[nodiscard]] double lightBehind(double range_m) const {
    const auto beyond = std::lower_bound(particles_.begin(), particles_.end(), Field::Particle{range_m}, nearer);
    return left_[static_cast<std::size_t>(beyond - particles_.begin())];
  }

 private:
  static bool nearer(const Field::Particle& a, const Field::Particle& b) { return a.range_m < b.range_m; }
  const std::vector<Field::Particle>& particles_;
  std::vector<double> left_{1.0};  ///< behind so many of them
};

/// Drops and flakes are others in every shot.
class Falling final : public Disturbance {
 public:
  explicit Falling(const std::vector<Field>& fields) : fields_(fields) {}

  void disturb(const BeamView& view, const core::Random::Key& key, std::vector<Pulse>& pulses) const override {
    std::vector<Field::Particle> particles;
    core::Random random(key);
    for (const Field& field : fields_) field.draw(view, random, particles);
    if (particles.empty()) return;
    const Shadows shadows(particles);
    for (Pulse& pulse : pulses) pulse.power_w *= shadows.lightBehind(pulse.range_m);
    for (const Field::Particle& particle : particles)
      pulses.push_back({particle.range_m, particle.power_w * shadows.lightBehind(particle.range_m), false});
  }

 private:
  const std::vector<Field>& fields_;
};

/// Single drops and flakes as small targets in the beam: echoes of their own, and a shadow on what lies behind.
///
///   P = η A_r P_t · b · χ(r) · σ / (A(r) r²),  A(r) = (w + r φ_h)(r φ_v + w)     hence r^-2 near, r^-4 far
///
///   σ  cross-section of the particle; b its backscatter per sr; χ overlap (model/overlap.h)
///   A  footprint of the beam, which leaves the sensor w wide; the share σ / A of the power does not go on, and as
///      much of what returns, so that many particles attenuate both ways as a haze does
///
/// Poisson in number, anew in every shot, uniform over the footprint. Only particles that alone reach a tenth of the
/// profile's threshold at the beam's full power are drawn: the others are many and weak, and stand in
/// atmospheric-attenuation (rain_rate_mm_h) and atmospheric-backscatter.
/// Source: Marshall & Palmer 1948, doi:10.1175/1520-0469(1948)005<0165:TDORWS>2.0.CO;2; Gunn & Marshall 1958,
/// doi:10.1175/1520-0469(1958)015<0452:TDWSOA>2.0.CO;2; Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011.
class PrecipitationClutter final : public Effect {
 public:
  explicit PrecipitationClutter(const EffectParameters& parameters)
      : rain_rate_mm_h_(parameters.number("rain_rate_mm_h")),
        snow_rate_mm_h_(parameters.numberOr("snow_rate_mm_h", 0.0)),
        window_m_(parameters.numberOr("window_m", 0.01)),
        drops_{parameters.numberOr("lidar_ratio_sr", kLidarRatioOfDroplets_sr),
               parameters.numberOr("smallest_drop_mm", 0.0)} {}

  void prepare(ChainSettings& settings, const Environment& environment) override {
    const bool given = rain_rate_mm_h_ || snow_rate_mm_h_ > 0.0;
    const double rain_rate_mm_h = given ? rain_rate_mm_h_.value_or(0.0) : environment.rain_rate_mm_h.value_or(0.0);
    if (rain_rate_mm_h > 0.0) fields_.emplace_back(rain(rain_rate_mm_h, drops_), settings, window_m_);
    if (snow_rate_mm_h_ > 0.0) fields_.emplace_back(snow(snow_rate_mm_h_), settings, window_m_);
  }
  [[nodiscard]] bool disturbs() const override { return !fields_.empty(); }
  [[nodiscard]] std::unique_ptr<const Disturbance> inFrame(const Scene&, const ChainSettings&,
                                                           const core::Random::Key&) const override {
    return std::make_unique<Falling>(fields_);
  }

 private:
  std::optional<double> rain_rate_mm_h_;
  double snow_rate_mm_h_;
  double window_m_;
  Drops drops_;
  std::vector<Field> fields_;
};

}  // namespace

EffectEntry precipitationClutter() {
  return {.info = {.name = "precipitation-clutter",
                   .title = "Echoes of drops and flakes",
                   .summary = "Single drops or flakes give echoes of their own, and hide what is behind them.",
                   .stage = Stage::kPropagation,
                   .percollect = {"89", "93"},
                   .parameters = {{"rain_rate_mm_h", "mm/h", 0.0, 100.0, std::nullopt,
                                   "Rain rate; without any rate the experiment's environment", false, 10.0},
                                  {"snow_rate_mm_h", "mm/h", 0.0, 20.0, 0.0, "Snowfall, as melted water", false, 2.0},
                                  {"window_m", "m", 0.001, 0.1, 0.01, "Width of the beam where it leaves the sensor",
                                   true, 0.01},
                                  {"lidar_ratio_sr", "sr", 9.4, 37.6, kLidarRatioOfDroplets_sr,
                                   "Light that a drop of rain takes over what it sends back per sr", true, 18.8},
                                  {"smallest_drop_mm", "mm", 0.0, 1.0, 0.0, "Diameter of the smallest drops of rain",
                                   false, 0.5}},
                   .fitted = {"rain_rate_mm_h"},
                   .other_forms = {{"snow", {"snow_rate_mm_h"}},
                                   {"other drops", {"rain_rate_mm_h", "lidar_ratio_sr", "smallest_drop_mm"}, true}},
                   .source = "Marshall & Palmer 1948; Gunn & Marshall 1958; Rasshofer et al. 2011, "
                             "doi:10.5194/ars-9-49-2011"},
          .make = makeFrom<PrecipitationClutter>};
}

}  // namespace model::effects
