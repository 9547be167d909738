#pragma once

#include "model/material/material.h"
#include "model/material/wet_film.h"

namespace model {

/// What a material sends back to a sensor that lights it up, over what a Lambertian surface of the same reflectivity
/// would: β(θ) π / Γ. The laser radar equation with Γ/π times this is that of the material.
///
///   lambertian  1                      phong, oren-nayar, retroreflector   their own monostaticFactor()
///   table       measured               cook-torrance, glass                β π / Γ
///
/// Throws InputError where a table or a file of refractive indices says nothing about angle or wavelength.
[[nodiscard]] double monostaticFactor(const Material& material, double cos_incidence, double wavelength_nm);

/// What a water film makes of the return of a surface: what it makes of that of a Lambertian surface of its
/// reflectivity (wet_film.h). Surfaces that mirror by themselves (cook-torrance, glass) keep theirs: their own
/// lobe outshines that of a film.
[[nodiscard]] double wetFactor(const Material& material, double cos_incidence, const WetFilm& film);

/// Share of unpolarised light that a smooth surface of this material throws into the mirror direction: Fresnel, of a
/// pane with both its faces where the material transmits (fresnel.h). How much of the surface is smooth is the
/// caller's to say.
[[nodiscard]] double specularReflectance(const Material& material, double cos_incidence, double wavelength_nm);

/// Share of unpolarised light that goes straight through: the material's `transmission` at normal incidence (never more
/// than its faces let pass), less when slanted; 0 if it is opaque. specularReflectance + transmittance <= 1.
[[nodiscard]] double transmittance(const Material& material, double cos_incidence, double wavelength_nm);

}  // namespace model
