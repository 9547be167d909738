#include "model/material/reflection.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/effect_bench.h"
#include "tests/model/material/hemisphere.h"
#include "tests/support/paths.h"

namespace model {
namespace {

using nlohmann::json;
using std::numbers::pi;

Material materialOf(const json& value) {
  return readMaterial("m", core::JsonObject(value, "experiment.json", "/materials/m"));
}

TEST(MonostaticFactor, IsTheBrdfOverLamberts) {
  const auto cook = materialOf({{"reflectivity", 0.4},
                                {"refractive_index", 1.5},
                                {"brdf", {{"model", "cook-torrance"}, {"roughness", 0.2}, {"diffuse_fraction", 0.6}}}});
  EXPECT_NEAR(monostaticFactor(cook, 1.0, 905), 0.6 + 0.4 * 0.04 / (4 * 0.2 * 0.2) / 0.4, 1e-12);
  const auto glass = materialOf({{"reflectivity", 0.01}, {"transmission", 0.9}, {"brdf", {{"model", "glass"}}}});
  EXPECT_NEAR(monostaticFactor(glass, lab::cosOfDegrees(15), 905), 1.0, 1e-9);  // dust
  EXPECT_GT(monostaticFactor(glass, 1.0, 905), 1000);
  const auto phong =
      materialOf({{"reflectivity", 0.4}, {"brdf", {{"model", "phong"}, {"diffuse_fraction", 0.8}, {"exponent", 20}}}});
  EXPECT_NEAR(monostaticFactor(phong, 1.0, 905), 0.8 + 0.2 * 11, 1e-12);
  EXPECT_EQ(monostaticFactor(materialOf({{"reflectivity", 0.4}}), 0.3, 905), 1.0);
}

TEST(MonostaticFactor, OfAMetalRisesWithItsReflectance) {
  const auto metal = [](double k) {
    return materialOf({{"reflectivity", 0.1},
                       {"refractive_index", {{"n", 2.0}, {"k", k}}},
                       {"brdf", {{"model", "cook-torrance"}, {"roughness", 0.3}, {"microfacets", "beckmann"}}}});
  };
  EXPECT_NEAR(monostaticFactor(metal(8), 1.0, 905) / monostaticFactor(metal(0), 1.0, 905), (65.0 / 73) / (1.0 / 9),
              1e-9);
}

TEST(Transmittance, IsTheStatedOneSquareOnAndLeavesRoomForTheReflection) {
  const auto glass = materialOf({{"reflectivity", 0.0}, {"transmission", 0.8}, {"refractive_index", 1.52}});
  EXPECT_NEAR(transmittance(glass, 1.0, 905), 0.8, 1e-12);
  double last = 1.0;
  for (const double deg : {0.0, 30.0, 60.0, 80.0, 89.9}) {
    const double c = lab::cosOfDegrees(deg), t = transmittance(glass, c, 905);
    EXPECT_LE(t + specularReflectance(glass, c, 905), 1.0 + 1e-12);
    EXPECT_LE(t, last);
    last = t;
  }
  EXPECT_LT(last, 0.03);
  const auto opaque = materialOf({{"reflectivity", 0.3}, {"refractive_index", 1.5}});
  EXPECT_EQ(transmittance(opaque, 1.0, 905), 0.0);
  EXPECT_NEAR(specularReflectance(opaque, 1.0, 905), 0.04, 1e-12);
  const auto clear = materialOf({{"reflectivity", 0.0}, {"transmission", 1.0}, {"refractive_index", 1.0}});
  EXPECT_NEAR(transmittance(clear, 0.2, 905), 1.0, 1e-12);
}

class PackageWithTables : public testing::Test {
 protected:
  PackageWithTables() {
    std::filesystem::create_directories(folder_ / "materials");
    (void)folder_.write("materials/half.csv", "incidence_deg,factor\n0,0.5\n80,0.5\n");
    (void)folder_.write("materials/n.yml",
                        "DATA:\n  - type: formula 5\n    wavelength_range: 0.4 2\n"
                        "    coefficients: 1.5\n");
    (void)folder_.write("p.csv", "time_ns,power\n0,0\n3,2\n7,0\n");
    setup_.file = folder_ / "experiment.json";
    setup_.scene = {lab::board(10)};
    setup_.materials["grey"]["brdf"] = {{"model", "table"}, {"table", "materials/half.csv"}};
  }
  test_support::TemporaryFolder folder_;
  lab::Case setup_;
};

TEST_F(PackageWithTables, TableTakesPartWithAngularReflectionOnly) {
  EXPECT_NEAR(lab::power_w(setup_) / lab::radarEquation(10), 1.0, 1e-6);
  setup_.effects["angular-reflection"] = json::object();
  EXPECT_NEAR(lab::power_w(setup_) / lab::radarEquation(10), 0.5, 1e-6);
}

TEST_F(PackageWithTables, BeamsOutsideTheTableAreAnErrorWithRemedy) {
  setup_.effects["angular-reflection"] = json::object();
  const lab::Case slanted = lab::slanted(setup_, 85);
  EXPECT_NE(lab::refusal([&] { (void)lab::fire(slanted); }).find("from 0 to 80 degrees"), std::string::npos);
}

TEST_F(PackageWithTables, FilesOfASampleHoldTablesAndPulse) {
  setup_.materials["grey"]["refractive_index"] = {{"file", "materials/n.yml"}};
  setup_.sensor["emitter"]["pulse_shape"] = {{"file", "p.csv"}};
  setup_.sensor["emitter"].erase("pulse_fwhm_ns");
  const Experiment experiment = lab::experimentOf(setup_);
  const auto files = filesOf(experiment, experiment.samples[0]);
  for (const char* name : {"materials/half.csv", "materials/n.yml", "p.csv"}) {
    EXPECT_NE(std::find(files.begin(), files.end(), folder_ / name), files.end()) << name;
  }
}

TEST_F(PackageWithTables, MissingTableIsNamed) {
  setup_.materials["grey"]["brdf"]["table"] = "materials/none.csv";
  EXPECT_NE(lab::refusal([&] { (void)lab::experimentOf(setup_); }).find("none.csv"), std::string::npos);
}

}  // namespace
}  // namespace model
