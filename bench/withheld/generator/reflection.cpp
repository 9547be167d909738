#include "bench/withheld/generator/reflection.h"

#include <algorithm>
#include <cmath>

namespace withheld {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWater = 1.33;
constexpr double kFilmLobe = 120.0;  // exponent over the half vector: a film of a few degrees' slopes

double square(double x) { return x * x; }

double halfVectorLobe(double exponent, double cosine) {
  return (exponent + 8.0) / (8.0 * kPi) * std::pow(cosine, exponent);
}

// Oren & Nayar 1994 with both angles equal and no azimuth between them.
double orenNayar(double reflectivity, double roughness, double cosine) {
  const double s2 = roughness * roughness, angle = std::acos(std::min(1.0, cosine)), tangent = std::tan(angle);
  const double c1 = 1.0 - 0.5 * s2 / (s2 + 0.33), c2 = 0.45 * s2 / (s2 + 0.09) * std::sin(angle);
  const double direct = c1 + c2 * std::min(tangent, 1e3);
  const double twice = 0.17 * s2 / (s2 + 0.13) * (1.0 - square(2.0 * angle / kPi));
  return reflectivity / kPi * direct + square(reflectivity) / kPi * twice;
}

double dryLaw(const Material& m, double cosine, bool angular, bool retro) {
  const double lambertian = m.reflectivity / kPi;
  if (angular && m.law == Material::Law::oren_nayar) return orenNayar(m.reflectivity, m.roughness_rad, cosine);
  if (angular && m.law == Material::Law::phong) {
    return m.reflectivity *
           (m.diffuse_fraction / kPi + (1.0 - m.diffuse_fraction) * halfVectorLobe(4.0 * m.exponent, cosine));
  }
  if (retro && m.law == Material::Law::retroreflector) {
    const double power = std::log(0.5) / std::log(std::cos(m.half_width_rad));
    return lambertian * (1.0 + (m.gain - 1.0) * std::pow(cosine, power));
  }
  return lambertian;
}

}  // namespace

double fresnel(double cosine, double index) {
  const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
  const double across = (cosine - index * inside) / (cosine + index * inside);
  const double along = (index * cosine - inside) / (index * cosine + inside);
  return 0.5 * (across * across + along * along);
}

Material Surfaces::asItIs(const Material& material) const {
  Material m = material;
  const auto given = [&](const char* effect, const char* parameter) { return effects_.number(effect, parameter); };
  const std::string law = effects_.text("angular-reflection", "model");
  const auto roughness = given("angular-reflection", "roughness_rad");
  const auto diffuse = given("angular-reflection", "diffuse_fraction"),
             exponent = given("angular-reflection", "exponent");
  if (m.law != Material::Law::retroreflector) {
    if (law == "lambertian") m.law = Material::Law::lambertian;
    if (law == "oren-nayar" || (law.empty() && roughness)) m.law = Material::Law::oren_nayar;
    if (law == "phong" || (law.empty() && (diffuse || exponent))) m.law = Material::Law::phong;
  }
  m.roughness_rad = roughness.value_or(m.roughness_rad);
  m.diffuse_fraction = diffuse.value_or(m.diffuse_fraction);
  m.exponent = exponent.value_or(m.exponent);
  m.gain = given("retroreflection", "gain").value_or(m.gain);
  m.half_width_rad = given("retroreflection", "half_width_rad").value_or(m.half_width_rad);
  return m;
}

double Surfaces::backward(const Material& material, double cosine) const {
  Material m = asItIs(material);
  const double wetness = effects_.on("surface-moisture") ? effects_.number("surface-moisture", "wetness", 0.5) : 0.0;
  const double wet = m.reflectivity / (m.reflectivity + kWater * kWater * (1.0 - m.reflectivity));
  m.reflectivity = (1.0 - wetness) * m.reflectivity + wetness * wet;
  const double film = wetness * fresnel(1.0, kWater) * halfVectorLobe(kFilmLobe, cosine);
  return dryLaw(m, cosine, effects_.on("angular-reflection"), effects_.on("retroreflection")) + film;
}

double Surfaces::passing(const Material& material, double cosine) const {
  if (!effects_.on("transmission") || material.transmission <= 0.0) return 0.0;
  const double square_on = effects_.number("transmission", "transmission", material.transmission);
  const double index = effects_.number("transmission", "refractive_index", material.refractive_index);
  const double faces = square(1.0 - fresnel(1.0, index));
  const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
  const double absorbed = std::pow(std::min(1.0, square_on / faces), 1.0 / inside);
  return std::min(1.0, absorbed * square(1.0 - fresnel(cosine, index)));
}

double Surfaces::mirrored(const Material& material) const {
  if (!effects_.on("multipath")) return 0.0;
  return material.reflectivity * effects_.number("multipath", "specular_fraction", material.specular_fraction);
}

}  // namespace withheld
