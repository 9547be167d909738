#include "model/material/reflection.h"

#include <numbers>

#include "model/material/glass.h"
#include "model/material/oren_nayar.h"
#include "model/material/phong.h"
#include "model/material/retroreflector.h"
#include "model/material/wet_film.h"

namespace model {

namespace {

/// Opaque glass (a mirror, a lacquered pane) shows its front face only.
Pane paneOf(const Material& material, double wavelength_nm) {
  const ComplexIndex index = material.refractive_index.at(wavelength_nm);
  if (material.transmission <= 0.0) return {index, 0.0};
  return Pane::ofTransmission(index, material.transmission);
}

double overLambert(double brdf_1_sr, double reflectivity) {
  return reflectivity > 0.0 ? brdf_1_sr * std::numbers::pi / reflectivity : 1.0;
}

}  // namespace

double monostaticFactor(const Material& material, double cos_incidence, double wavelength_nm) {
  const Brdf& brdf = material.brdf;
  const auto angles = ReflectionAngles::monostatic(cos_incidence);
  switch (brdf.model) {
    case BrdfModel::kLambertian:
      return 1.0;
    case BrdfModel::kOrenNayar:
      return OrenNayar{brdf.roughness_rad}.monostaticFactor(cos_incidence);
    case BrdfModel::kPhong:
      return Phong{brdf.diffuse_fraction, brdf.exponent}.monostaticFactor(cos_incidence);
    case BrdfModel::kRetroreflector:
      return Retroreflector{brdf.gain, brdf.half_width_rad, brdf.observation_half_width_rad}.monostaticFactor(
          cos_incidence);
    case BrdfModel::kCookTorrance: {
      const CookTorrance model{brdf.roughness, brdf.diffuse_fraction, brdf.microfacets};
      const ComplexIndex index = material.refractive_index.at(wavelength_nm);
      return overLambert(model.brdf(material.reflectivity, index, angles), material.reflectivity);
    }
    case BrdfModel::kGlass:
      return overLambert(Glass{brdf.roughness}.brdf(material.reflectivity, paneOf(material, wavelength_nm), angles),
                         material.reflectivity);
    case BrdfModel::kTable:
      return brdf.table->monostaticFactor(material.reflectivity, cos_incidence, wavelength_nm);
  }
  return 1.0;
}

double wetFactor(const Material& material, double cos_incidence, const WetFilm& film) {
  const BrdfModel model = material.brdf.model;
  if (model == BrdfModel::kCookTorrance || model == BrdfModel::kGlass) return 1.0;
  return film.monostaticFactor(material.reflectivity, cos_incidence);
}

double specularReflectance(const Material& material, double cos_incidence, double wavelength_nm) {
  return paneOf(material, wavelength_nm).reflectance(cos_incidence).unpolarised();
}

double transmittance(const Material& material, double cos_incidence, double wavelength_nm) {
  if (material.transmission <= 0.0) return 0.0;
  return paneOf(material, wavelength_nm).transmittance(cos_incidence).unpolarised();
}

}  // namespace model
