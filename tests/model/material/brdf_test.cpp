// What every BRDF owes to physics, and each one's closed forms.
#include <gtest/gtest.h>

#include "model/material/cook_torrance.h"
#include "model/material/glass.h"
#include "model/material/lambertian.h"
#include "model/material/oren_nayar.h"
#include "model/material/phong.h"
#include "model/material/retroreflector.h"
#include "model/material/wet_film.h"
#include "tests/model/material/hemisphere.h"

namespace model {
namespace {

using lab::Around;
using std::numbers::pi;

constexpr double kIntegral = 2e-3;  ///< error of the numerical hemisphere

TEST(Lambertian, ReflectsItsReflectivity) {
  for (const double cos_in : lab::kIncidences) {
    EXPECT_NEAR(lab::reflectedShare([](auto) { return lambertianBrdf(0.7); }, cos_in, Around::kNormal), 0.7, kIntegral);
  }
}

TEST(OrenNayar, SmoothIsLambertian) {
  for (const double cos_in : lab::kIncidences) {
    EXPECT_DOUBLE_EQ(OrenNayar{0.0}.monostaticFactor(cos_in), 1.0);
    EXPECT_DOUBLE_EQ(OrenNayar{0.0}.brdf(0.5, {cos_in, 0.3, 0.5}), 0.5 / pi);
  }
}

// At normal incidence sin α tan β = 0 everywhere but φ = any, θ_in = 0: the hemisphere holds A. At grazing incidence
// α = 90°, and ∫ max(0, cos φ) tan θ cos θ sin θ dθ dφ = 2 · π/4 gives A + B/2.
TEST(OrenNayar, HemisphereHoldsAAtNormalAndAPlusHalfBAtGrazingIncidence) {
  const double s = 0.3 * 0.3, a = 1 - 0.5 * s / (s + 0.33), b = 0.45 * s / (s + 0.09);
  const auto brdf = [](const ReflectionAngles& angles) { return OrenNayar{0.3}.brdf(1.0, angles); };
  EXPECT_NEAR(lab::reflectedShare(brdf, 1.0, Around::kNormal), a, kIntegral);
  EXPECT_NEAR(lab::reflectedShare(brdf, 1e-4, Around::kNormal), a + b / 2, kIntegral);
}

// Eq. 30 is an approximation: for a white surface it may give 1.6 % too much, at grazing incidence.
TEST(OrenNayar, ConservesEnergyToWithinItsApproximation) {
  for (const double sigma : {0.1, 0.2, 0.35, 0.8}) {
    const auto brdf = [&](const ReflectionAngles& angles) { return OrenNayar{sigma}.brdf(1.0, angles); };
    for (const double cos_in : lab::kIncidences) {
      EXPECT_LE(lab::reflectedShare(brdf, cos_in, Around::kNormal), 1.016 + kIntegral) << sigma;
    }
  }
}

TEST(OrenNayar, MonostaticIsItsBrdfTowardsTheLight) {
  for (const double cos_in : lab::kIncidences) {
    EXPECT_NEAR(OrenNayar{0.35}.brdf(0.4, ReflectionAngles::monostatic(cos_in)) * pi / 0.4,
                OrenNayar{0.35}.monostaticFactor(cos_in), 1e-12);
  }
}

TEST(Phong, ReflectsItsReflectivityAtNormalIncidenceAndNeverMore) {
  for (const double exponent : {0.0, 1.0, 20.0, 1000.0}) {
    const auto brdf = [&](const ReflectionAngles& angles) { return Phong{0.3, exponent}.brdf(0.9, angles); };
    EXPECT_NEAR(lab::reflectedShare(brdf, 1.0, Around::kMirror), 0.9, kIntegral);
    for (const double cos_in : lab::kIncidences) {
      EXPECT_LE(lab::reflectedShare(brdf, cos_in, Around::kMirror), 0.9 + kIntegral);
    }
  }
}

// Mirrors of total reflection: what is missing from 1 was shaded, or reflected twice.
TEST(CookTorrance, PerfectMirrorsNeverReflectMoreThanEverything) {
  for (const auto microfacets : {Microfacets::kGgx, Microfacets::kBeckmann}) {
    for (const double roughness : {0.02, 0.1, 0.4, 1.0}) {
      const auto brdf = [&](const ReflectionAngles& angles) {
        return microfacetLobe(microfacets, roughness, 1.0, angles);
      };
      for (const double cos_in : lab::kIncidences) {
        EXPECT_LE(lab::reflectedShare(brdf, cos_in, Around::kMirror), 1.0 + kIntegral) << roughness << " " << cos_in;
      }
    }
    const auto smooth = [&](const ReflectionAngles& angles) { return microfacetLobe(microfacets, 0.02, 1.0, angles); };
    EXPECT_NEAR(lab::reflectedShare(smooth, 1.0, Around::kMirror), 1.0, 5e-3);
    EXPECT_NEAR(lab::reflectedShare(smooth, 0.5, Around::kMirror), 1.0, 1e-2);
  }
}

TEST(CookTorrance, SmoothSurfacesReflectWhatFresnelSays) {
  const ComplexIndex index{1.5, 0.0};
  for (const double deg : {0.0, 30.0, 60.0}) {
    const CookTorrance paint{.roughness = 0.01, .microfacets = Microfacets::kBeckmann};
    const auto brdf = [&](const ReflectionAngles& angles) { return paint.brdf(0.5, index, angles); };
    const double c = lab::cosOfDegrees(deg), fresnel = fresnelReflectance(c, index).unpolarised();
    EXPECT_NEAR(lab::reflectedShare(brdf, c, Around::kMirror) / fresnel, 1.0, 1e-2);
  }
}

// Square on, all mirrors that count lie flat: D = 1/(π α²), nothing in shadow.
TEST(CookTorrance, ReturnAtNormalIncidenceIsFresnelOverFourPiAlphaSquared) {
  const ComplexIndex index{1.5, 0.0};
  for (const auto microfacets : {Microfacets::kGgx, Microfacets::kBeckmann}) {
    const CookTorrance paint{.roughness = 0.2, .diffuse_fraction = 0.6, .microfacets = microfacets};
    const double lobe = 0.04 / (4 * pi * 0.2 * 0.2);
    EXPECT_NEAR(paint.brdf(0.5, index, ReflectionAngles::monostatic(1.0)), 0.6 * 0.5 / pi + 0.4 * lobe, 1e-12);
  }
}

TEST(CookTorrance, DiffuseFractionOneIsLambertian) {
  const CookTorrance paint{.roughness = 0.2, .diffuse_fraction = 1.0};
  for (const double cos_in : lab::kIncidences) {
    EXPECT_DOUBLE_EQ(paint.brdf(0.5, {1.5, 0}, ReflectionAngles::monostatic(cos_in)), 0.5 / pi);
  }
}

TEST(Glass, ReflectsThePaneAndItsDustAndNeverMore) {
  const Pane pane{{1.5, 0.0}, 1.0};
  for (const double cos_in : lab::kIncidences) {
    const auto brdf = [&](const ReflectionAngles& angles) { return Glass{0.01}.brdf(0.02, pane, angles); };
    const double expected = 0.02 + 0.98 * pane.reflectance(cos_in).unpolarised();
    const double share = lab::reflectedShare(brdf, cos_in, Around::kMirror);
    EXPECT_LE(share, 1.0 + kIntegral);
    if (cos_in > 0.4) {
      EXPECT_NEAR(share / expected, 1.0, 2e-2) << cos_in;
    }
  }
}

TEST(Glass, OnlyDustComesBackFromASlantedPane) {
  const Glass glass{0.01};
  EXPECT_NEAR(glass.brdf(0.02, {{1.5, 0}, 1}, ReflectionAngles::monostatic(lab::cosOfDegrees(10))), 0.02 / pi, 1e-12);
  EXPECT_GT(glass.brdf(0.02, {{1.5, 0}, 1}, ReflectionAngles::monostatic(1.0)), 10.0);
}

TEST(Retroreflector, SurplusHalvesAtItsHalfWidths) {
  const Retroreflector beads{.gain = 300, .half_width_rad = 0.5, .observation_half_width_rad = 0.007};
  EXPECT_NEAR(beads.monostaticFactor(1.0), 300, 1e-9);
  EXPECT_NEAR(beads.monostaticFactor(std::cos(0.5)), 1 + 299 / 2.0, 1e-9);
  EXPECT_NEAR(beads.brdf(0.3, {1.0, std::cos(0.007), 1.0}) * pi / 0.3,
              1 + 299 / 2.0 * std::exp2(-0.5 * 0.007 * 0.007 / 0.25), 1e-3);
  EXPECT_NEAR(beads.brdf(0.3, {1.0, std::cos(0.3), 1.0}), 0.3 / pi, 1e-9);
}

// The lobe is narrow, so all of it leaves at the cosine of 1: closed form by small angles.
TEST(Retroreflector, HemisphereHoldsLambertAndLobe) {
  for (const double width : {0.001, 0.007}) {
    const Retroreflector prisms{.gain = 2000, .half_width_rad = 0.4, .observation_half_width_rad = width};
    const auto brdf = [&](const ReflectionAngles& angles) { return prisms.brdf(0.3, angles); };
    EXPECT_NEAR(lab::reflectedShare(brdf, 1.0, Around::kLight) / prisms.hemisphericalReflectance(0.3), 1.0, 5e-3);
    EXPECT_LE(prisms.hemisphericalReflectance(0.3), 1.0);
  }
}

TEST(WetFilm, TakesItsConstantsFromFresnel) {
  const ComplexIndex water{1.33, 0.0};
  const double inside = 1 - (1 - diffuseFresnelReflectance(water)) / (1.33 * 1.33);
  const double normal = fresnelReflectance(1.0, water).s;
  for (const double dry : {0.1, 0.5, 0.9}) {
    const double expected = (1 - normal) * (1 - inside) * dry / (1 - inside * dry);
    EXPECT_NEAR(WetFilm::diffuseUnderFilm(dry) / expected, 1.0, 2e-3);
  }
}

// A white ground absorbs nothing, so the film cannot either: 1 - F below it and F in the lobe.
TEST(WetFilm, WhiteStaysWhiteAndDarkGetsDarker) {
  EXPECT_NEAR(WetFilm::diffuseUnderFilm(1.0), 0.98, 1e-12);
  for (const double dry : {0.05, 0.2, 0.6}) EXPECT_LT(WetFilm::diffuseUnderFilm(dry), dry);
  const auto brdf = [](const ReflectionAngles& angles) { return WetFilm{1.0}.brdf(1.0, angles); };
  EXPECT_NEAR(lab::reflectedShare(brdf, 1.0, Around::kMirror), 1.0, kIntegral);
  for (const double cos_in : lab::kIncidences) EXPECT_LE(lab::reflectedShare(brdf, cos_in, Around::kMirror), 1.002);
}

// A film that follows rougher ground throws back less where it is hit square on and more beside; it takes none.
TEST(WetFilm, RougherFilmSpreadsTheSameLobe) {
  const WetFilm flat{.wetness = 1.0, .lobe_exponent = 200.0}, rough{.wetness = 1.0, .lobe_exponent = 20.0};
  EXPECT_GT(flat.monostaticFactor(0.3, 1.0), rough.monostaticFactor(0.3, 1.0));
  EXPECT_LT(flat.monostaticFactor(0.3, std::cos(0.25)), rough.monostaticFactor(0.3, std::cos(0.25)));
  const auto share = [](const WetFilm& film) {
    return lab::reflectedShare([&](const ReflectionAngles& angles) { return film.brdf(0.3, angles); }, 1.0,
                               Around::kMirror);
  };
  EXPECT_NEAR(share(flat), share(rough), kIntegral);
}

TEST(WetFilm, DryChangesNothing) {
  for (const double cos_in : lab::kIncidences) EXPECT_DOUBLE_EQ(WetFilm{0.0}.monostaticFactor(0.3, cos_in), 1.0);
  EXPECT_EQ(WetFilm{1.0}.monostaticFactor(0.0, 0.5), 1.0);
}

TEST(Brdf, InAndOutMayChangePlaces) {
  const Pane pane{{1.5, 0.0}, 0.9};
  EXPECT_LT(lab::reciprocityError([](auto a) { return OrenNayar{0.4}.brdf(0.5, a); }), 1e-12);
  EXPECT_LT(lab::reciprocityError([](auto a) { return Phong{0.5, 30}.brdf(0.5, a); }), 1e-12);
  EXPECT_LT(lab::reciprocityError([](auto a) { return CookTorrance{0.3, 0.2}.brdf(0.5, {2, 8}, a); }), 1e-12);
  EXPECT_LT(lab::reciprocityError([&](auto a) { return Glass{0.1}.brdf(0.1, pane, a); }), 1e-12);
  EXPECT_LT(lab::reciprocityError([](auto a) { return Retroreflector{300, 0.5, 0.02}.brdf(0.5, a); }), 1e-12);
  EXPECT_LT(lab::reciprocityError([](auto a) { return WetFilm{0.7}.brdf(0.5, a); }), 1e-12);
}

}  // namespace
}  // namespace model
