#include "model/material/fresnel.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace model {
namespace {

constexpr ComplexIndex kWater{1.328, 4.86e-7};  ///< at 900 nm: Hale & Querry 1973
constexpr ComplexIndex kGlass{1.5, 0.0};
constexpr ComplexIndex kMetal{2.0, 8.0};

double cosDeg(double deg) { return std::cos(deg * std::numbers::pi / 180); }

TEST(Fresnel, WaterReflectsTwoPerCentSquareOn) {
  EXPECT_NEAR(fresnelReflectance(1.0, kWater).unpolarised(), 0.02, 3e-4);
}

TEST(Fresnel, SquareOnItIsTheTextbookFormulaForBothPolarisations) {
  for (const ComplexIndex index : {kWater, kGlass, kMetal}) {
    const double n = index.real(), k = index.imag();
    const double expected = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    EXPECT_NEAR(fresnelReflectance(1.0, index).s, expected, 1e-12);
    EXPECT_NEAR(fresnelReflectance(1.0, index).p, expected, 1e-12);
  }
}

TEST(Fresnel, NothingPolarisedInThePlaneReturnsAtBrewstersAngle) {
  const double brewster = std::atan(1.5);
  EXPECT_NEAR(fresnelReflectance(std::cos(brewster), kGlass).p, 0.0, 1e-15);
  EXPECT_GT(fresnelReflectance(std::cos(brewster - 0.1), kGlass).p, 1e-4);
  EXPECT_GT(fresnelReflectance(std::cos(brewster + 0.1), kGlass).p, 1e-4);
}

// Abelès' relation, exact for any index: at 45° the parallel reflectance is the square of the perpendicular one.
TEST(Fresnel, AtFortyFiveDegreesParallelIsThePerpendicularSquared) {
  for (const ComplexIndex index : {kWater, kGlass, kMetal}) {
    const Polarised r = fresnelReflectance(cosDeg(45), index);
    EXPECT_NEAR(r.p, r.s * r.s, 1e-12);
  }
}

TEST(Fresnel, EverythingIsReflectedAtGrazingIncidenceAndNothingWithoutAStep) {
  EXPECT_NEAR(fresnelReflectance(0.0, kGlass).unpolarised(), 1.0, 1e-12);
  EXPECT_NEAR(fresnelReflectance(0.0, kMetal).unpolarised(), 1.0, 1e-12);
  for (const double c : {0.1, 0.5, 1.0}) EXPECT_NEAR(fresnelReflectance(c, {1.0, 0.0}).unpolarised(), 0.0, 1e-15);
}

// From glass into air: total beyond the critical angle of 41.8°.
TEST(Fresnel, TotalReflectionBeyondTheCriticalAngle) {
  EXPECT_NEAR(fresnelReflectance(cosDeg(42), {1 / 1.5, 0.0}).unpolarised(), 1.0, 1e-12);
  EXPECT_LT(fresnelReflectance(cosDeg(41), {1 / 1.5, 0.0}).unpolarised(), 0.6);
}

// Walsh 1926 integrated Fresnel's formula over the hemisphere in closed form.
TEST(Fresnel, DiffuseReflectanceIsWalshsClosedForm) {
  for (const double n : {1.33, 1.5, 2.4}) {
    const double n2 = n * n, n4 = n2 * n2;
    const double walsh = 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
                         n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
                         2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
                         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
    EXPECT_NEAR(diffuseFresnelReflectance({n, 0.0}), walsh, 1e-6) << n;
  }
}

TEST(Pane, ReflectedAndTransmittedMakeOneWithoutAbsorption) {
  const Pane pane{kGlass, 1.0};
  for (const double deg : {0.0, 30.0, 56.0, 75.0, 89.0}) {
    const Polarised r = pane.reflectance(cosDeg(deg)), t = pane.transmittance(cosDeg(deg));
    EXPECT_NEAR(r.s + t.s, 1.0, 1e-12);
    EXPECT_NEAR(r.p + t.p, 1.0, 1e-12);
  }
}

TEST(Pane, ClearGlassPassesTwoFaces) {
  EXPECT_NEAR((Pane{kGlass, 1.0}.transmittance(1.0).s), 0.96 / 1.04, 1e-12);               // (1 - R)/(1 + R), R = 0.04
  EXPECT_NEAR((Pane{kGlass, 1.0}.transmittance(1 / std::hypot(1.0, 1.5)).p), 1.0, 1e-12);  // Brewster
}

TEST(Pane, AbsorptionTakesWhatIsMissing) {
  for (const double deg : {0.0, 45.0, 80.0, 90.0}) {
    const Pane pane{kGlass, 0.7};
    EXPECT_LT(pane.reflectance(cosDeg(deg)).s + pane.transmittance(cosDeg(deg)).s, 1.0 + 1e-12);
  }
  EXPECT_NEAR((Pane{kGlass, 0.0}.reflectance(1.0).s), 0.04, 1e-12);  // the back face is not seen
}

TEST(Pane, OfTransmissionPassesIt) {
  for (const double transmission : {0.1, 0.5, 0.9}) {
    EXPECT_NEAR(Pane::ofTransmission(kGlass, transmission).transmittance(1.0).unpolarised(), transmission, 1e-12);
  }
  EXPECT_EQ(Pane::ofTransmission(kGlass, 0.99).internal_transmittance, 1.0);  // more than clear glass is clear glass
  EXPECT_NEAR(Pane::ofTransmission({1.0, 0.0}, 0.37).transmittance(0.999999).s, 0.37, 1e-5);
}

}  // namespace
}  // namespace model
