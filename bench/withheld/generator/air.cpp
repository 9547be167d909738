#include "bench/withheld/generator/air.h"

#include <algorithm>
#include <cmath>

namespace withheld {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLidarRatio_sr = 20.0;
constexpr double kStep_m = 0.1;

double kimExponent(double visibility_km) {
  if (visibility_km > 50.0) return 1.6;
  if (visibility_km > 6.0) return 1.3;
  if (visibility_km > 1.0) return 0.16 * visibility_km + 0.34;
  return std::max(0.0, visibility_km - 0.5);
}

// Straight back out of a medium that scatters forward. Henyey & Greenstein 1941.
double backwardPhase_1_sr(double g) { return (1.0 - g * g) / (4.0 * kPi * std::pow(1.0 + g, 3.0)); }

double attenuation(const Effects& effects, const Profile& profile, const Environment& environment) {
  const std::string name = "atmospheric-attenuation";
  if (!effects.on(name)) return 0.0;
  auto visibility = effects.number(name, "visibility_m"), rain = effects.number(name, "rain_rate_mm_h");
  const auto extinction = effects.number(name, "extinction_1_m");
  if (!visibility && !rain && !extinction) visibility = environment.visibility_m, rain = environment.rain_rate_mm_h;
  return (visibility ? fogExtinction(*visibility, profile.wavelength_nm) : 0.0) + (rain ? rainExtinction(*rain) : 0.0) +
         extinction.value_or(0.0);
}

}  // namespace

double fogExtinction(double visibility_m, double wavelength_nm) {
  return 3.912 / visibility_m * std::pow(wavelength_nm / 550.0, -kimExponent(visibility_m / 1000.0));
}

double rainExtinction(double rate_mm_h) {
  if (rate_mm_h <= 0.0) return 0.0;
  const double slope_1_mm = 4.1 * std::pow(rate_mm_h, -0.21);
  return kPi * 8000.0 / std::pow(slope_1_mm, 3.0) * 1e-6;
}

Air::Air(const Effects& effects, const Profile& profile, const Environment& environment)
    : extinction_1_m_(attenuation(effects, profile, environment)), nearest_m_(std::max(0.5, profile.min_range_m)) {
  const std::string fog = "atmospheric-backscatter", cloud = "exhaust-cloud";
  if (effects.on(fog)) {
    const auto visibility = effects.number(fog, "visibility_m");
    const auto known = visibility ? visibility : environment.visibility_m;
    if (known) fog_extinction_1_m_ = fogExtinction(*known, profile.wavelength_nm);
    fog_backscatter_1_m_sr_ = effects.number(fog, "backscatter_1_m_sr", fog_extinction_1_m_ / kLidarRatio_sr);
  }
  if (effects.on(cloud)) {
    cloud_extinction_1_m_ = effects.number(cloud, "extinction_1_m", 0.5);
    cloud_radius_m_ = 0.5 * effects.number(cloud, "size_m", 1.0);
    cloud_albedo_ = effects.number(cloud, "albedo", 0.9);
    const std::vector<double> centre = effects.list(cloud, "centre");
    if (centre.size() == 3) cloud_centre_ = {centre[0], centre[1], centre[2]};
  }
}

// Integral of 1.5 k (1 − ρ²/R²) along the chord, closed form: with ρ² = d² + s², s from the foot point.
double Air::cloudDepth(const Ray& ray, double to_m) const {
  if (cloud_extinction_1_m_ <= 0.0) return 0.0;
  const Vec to_centre = cloud_centre_ - ray.from;
  const double foot = dot(to_centre, ray.along), r2 = cloud_radius_m_ * cloud_radius_m_;
  const double d2 = std::max(0.0, dot(to_centre, to_centre) - foot * foot);
  if (d2 >= r2) return 0.0;
  const double half = std::sqrt(r2 - d2);
  const double from = std::clamp(-foot, -half, half), to = std::clamp(to_m - foot, -half, half);
  const auto integral = [&](double s) { return (1.0 - d2 / r2) * s - s * s * s / (3.0 * r2); };
  return 1.5 * cloud_extinction_1_m_ * std::max(0.0, integral(to) - integral(from));
}

double Air::left(const Ray& ray, double range_m) const {
  return std::exp(-2.0 * (extinction_1_m_ * range_m + cloudDepth(ray, range_m)));
}

std::vector<Arrival> Air::sentBack(const Ray& ray, double end_m, double constant) const {
  std::vector<Arrival> arrivals;
  if (fog_backscatter_1_m_sr_ <= 0.0 && cloud_extinction_1_m_ * cloud_albedo_ <= 0.0) return arrivals;
  for (double r = nearest_m_ + 0.5 * kStep_m; r < end_m; r += kStep_m) {
    const double cloud_depth = cloudDepth(ray, r + 0.5 * kStep_m) - cloudDepth(ray, r - 0.5 * kStep_m);
    const double fog = fog_backscatter_1_m_sr_ * kStep_m * std::exp(-2.0 * fog_extinction_1_m_ * r);
    const double cloud = cloud_albedo_ * cloud_depth * backwardPhase_1_sr(0.6);
    const double power = constant * (fog + cloud) * left(ray, r) / (r * r);
    if (power > 0.0) arrivals.push_back({r, power, kVolume});
  }
  return arrivals;
}

namespace {

struct GrainKind {
  double n0, slope_1_mm;   // N(D) = n0 exp(-slope D), per m³ and mm, D melted
  double size, back_1_sr;  // true over melted diameter; share of the intercepted light sent back
};

void addGrains(const GrainKind& kind, double window_m, const Profile& profile, double constant, double end_m,
               Dice& dice, std::vector<Grain>& grains) {
  constexpr double kSmallest_mm = 0.5;
  const double density = kind.n0 / kind.slope_1_mm * std::exp(-kind.slope_1_mm * kSmallest_mm);
  const double a = window_m, h = profile.divergence_h_rad, v = profile.divergence_v_rad;
  const double far_m = std::min(end_m, 25.0);  // farther out a drop is too small a part of the beam
  const double largest = (a + h * far_m) * (a + v * far_m);
  const int count = dice.poisson(std::min(2000.0, density * largest * far_m));
  for (int i = 0; i < count; ++i) {
    const double r = dice.uniform() * far_m, melted_mm = kSmallest_mm + dice.exponential() / kind.slope_1_mm;
    const double area = (a + h * r) * (a + v * r);
    const double keep = dice.uniform();
    if (r < 0.3 || keep * largest > area) continue;  // thinning: the beam is narrower here
    const double diameter_m = kind.size * melted_mm * 1e-3;
    const double share = std::min(1.0, kPi / 4.0 * diameter_m * diameter_m / area);
    grains.push_back({r, constant * share * kind.back_1_sr / (r * r), (1.0 - share) * (1.0 - share)});
  }
}

}  // namespace

std::vector<Grain> dropsInBeam(const Effects& effects, const Profile& profile, const Environment& environment,
                               double constant, double end_m, Dice& dice) {
  const std::string name = "precipitation-clutter";
  std::vector<Grain> grains;
  if (!effects.on(name)) return grains;
  const auto rain_given = effects.number(name, "rain_rate_mm_h"), snow_given = effects.number(name, "snow_rate_mm_h");
  const double rain = rain_given ? *rain_given : snow_given ? 0.0 : environment.rain_rate_mm_h.value_or(0.0);
  const double snow = snow_given.value_or(0.0), window_m = effects.number(name, "window_m", 0.01);
  if (rain > 0.0) {
    addGrains({8000.0, 4.1 * std::pow(rain, -0.21), 1.0, 0.06}, window_m, profile, constant, end_m, dice, grains);
  }
  if (snow > 0.0) {
    addGrains({3800.0 * std::pow(snow, -0.87), 2.55 * std::pow(snow, -0.48), 2.5, 0.2}, window_m, profile, constant,
              end_m, dice, grains);
  }
  std::sort(grains.begin(), grains.end(), [](const Grain& p, const Grain& q) { return p.range_m < q.range_m; });
  return grains;
}

Spray sprayOfFrame(const Effects& effects, const Scene& scene, Dice dice) {
  const std::string name = "road-spray";
  Spray spray;
  if (!effects.on(name)) return spray;
  spray.extinction_1_m = effects.number(name, "extinction_1_m", 0.02);
  const double long_m = effects.number(name, "plume_length_m", 10.0),
               wide_m = effects.number(name, "plume_width_m", 3.4);
  const double high_m = effects.number(name, "plume_height_m", 1.5);
  for (const Object& object : scene) {
    const double speed = length(object.velocity_m_s);
    const auto* box = std::get_if<Box>(&object.shape);
    if (!box || speed < effects.number(name, "least_speed_m_s", 50.0 / 3.6)) continue;
    const Vec back = (-1.0 / speed) * object.velocity_m_s, side{-back.y, back.x, 0.0};
    const double mean =
        effects.number(name, "density", 1.0) * long_m * wide_m * high_m * std::pow(speed * 3.6 / 100.0, 2.0);
    const int count = dice.poisson(std::min(mean, 5000.0));
    for (int i = 0; i < count; ++i) {
      const double behind = box->half_m.x + long_m * dice.uniform();
      const double beside = wide_m * (dice.uniform() - 0.5), above = high_m * dice.uniform() - box->half_m.z;
      spray.centres.push_back(object.position + behind * back + beside * side + Vec{0, 0, above});
    }
  }
  return spray;
}

std::vector<Grain> sprayInBeam(const Spray& spray, const Ray& ray, double constant, double end_m) {
  std::vector<Grain> grains;
  const double r2 = spray.radius_m * spray.radius_m;
  for (const Vec& centre : spray.centres) {
    const Vec to = centre - ray.from;
    const double foot = dot(to, ray.along), d2 = dot(to, to) - foot * foot;
    if (foot < 0.3 || foot > end_m || d2 >= r2) continue;
    const double depth = 2.0 * std::sqrt(r2 - d2) * spray.extinction_1_m;
    const double back = constant * (1.0 - std::exp(-2.0 * depth)) / (2.0 * kLidarRatio_sr) / (foot * foot);
    grains.push_back({foot, back, std::exp(-2.0 * depth)});
  }
  std::sort(grains.begin(), grains.end(), [](const Grain& p, const Grain& q) { return p.range_m < q.range_m; });
  return grains;
}

}  // namespace withheld
