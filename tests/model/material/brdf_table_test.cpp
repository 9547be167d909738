#include "model/material/brdf_table.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "model/material/refractive_index.h"
#include "tests/model/material/hemisphere.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

namespace model {
namespace {

using std::numbers::pi;

BrdfTable read(const BrdfTableSource& source) {
  std::vector<std::filesystem::path> files;
  return readBrdfTable(source, files);
}

class BrdfTableFile : public testing::Test {
 protected:
  BrdfTable csv(const std::string& content, bool clamp = false, bool times_cos = false) {
    return read({.file = folder_.write("t.csv", content), .times_cos = times_cos, .clamp = clamp});
  }
  std::string refusal(const std::string& name, const std::string& content) {
    const auto file = folder_.write(name, content);
    return test_support::thrownMessage([&] { (void)read({.file = file}); });
  }
  /// An OpenMATERIAL 3D table with the given rows.
  static std::string xompt(const std::string& rows, const std::string& technology = "lidar") {
    return R"({"metadata": {"typicalSensorTechnology": ")" + technology +
           R"("}, "brdf": {"wavelengths": [9.05e-7], "lookupTable": [)" + rows + "]}}";
  }
  test_support::TemporaryFolder folder_;
};

TEST_F(BrdfTableFile, LambertianTableIsFactorOne) {
  const auto table =
      csv("wavelength_nm,incidence_deg,brdf_1_sr\n905,0,0.1591549431\n905,45,0.1591549431\n905,90,0.1591549431\n");
  for (const double deg : {0.0, 20.0, 60.0, 90.0}) {
    EXPECT_NEAR(table.monostaticFactor(0.5, lab::cosOfDegrees(deg), 905), 1.0, 1e-9);
  }
  // The same surface as an instrument with cosine weighting gives it.
  const auto weighted = csv("incidence_deg,brdf_1_sr\n0,0.1591549431\n60,0.07957747155\n", false, true);
  EXPECT_NEAR(weighted.monostaticFactor(0.5, 1.0, 905), 1.0, 1e-9);
  EXPECT_NEAR(weighted.monostaticFactor(0.5, 0.5, 905), 1.0, 1e-9);
}

TEST_F(BrdfTableFile, IsLinearBetweenWavelengths) {
  const auto table =
      csv("wavelength_nm,incidence_deg,factor\n1550,0,3\n905,0,1\n905,80,1\n1550,80,3\n940,0,2\n940,80,2\n");
  EXPECT_NEAR(table.monostaticFactor(0.5, 0.8, 905), 1.0, 1e-12);
  EXPECT_NEAR(table.monostaticFactor(0.5, 0.8, 922.5), 1.5, 1e-12);
  EXPECT_NEAR(table.monostaticFactor(0.5, 0.8, 940), 2.0, 1e-12);
  EXPECT_NEAR(table.monostaticFactor(0.5, 0.8, 1245), 2.5, 1e-12);
  EXPECT_NEAR(table.monostaticFactor(0.5, 0.8, 885), 1.0, 1e-12);  // a diode's tolerance
}

TEST_F(BrdfTableFile, OutsideOfItIsAnErrorUnlessTheBorderHolds) {
  const std::string content = "wavelength_nm,incidence_deg,factor\n905,10,2\n905,60,1\n";
  const auto strict = csv(content), clamped = csv(content, true);
  const auto message = [&](double deg, double nm) {
    return test_support::thrownMessage([&] { (void)strict.monostaticFactor(0.5, lab::cosOfDegrees(deg), nm); });
  };
  EXPECT_NE(message(0, 905).find("covers incidence angles from 10 to 60 degrees"), std::string::npos);
  EXPECT_NE(message(70, 905).find("\"outside\": \"clamp\""), std::string::npos);
  EXPECT_NE(message(30, 1550).find("covers wavelengths from 905 to 905 nm; the emitter has 1550 nm"),
            std::string::npos);
  EXPECT_EQ(message(10, 905), "");
  EXPECT_EQ(message(60, 905), "");
  EXPECT_EQ(clamped.monostaticFactor(0.5, 1.0, 905), 2.0);
  EXPECT_EQ(clamped.monostaticFactor(0.5, 0.0, 1550), 1.0);
}

TEST_F(BrdfTableFile, FaultsAreNamedWithTheirLine) {
  EXPECT_NE(refusal("a.csv", "incidence_deg,brdf_1_sr\n0,1\n95,1\n").find("a.csv:3"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "incidence_deg,brdf_1_sr\n0,1\n0,1\n").find("a second time"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "incidence_deg,brdf_1_sr\n0,-1\n").find("negative"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "incidence_deg,brdf_1_sr\n0,x\n").find("'x' is not a number"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "incidence_deg,brdf_1_sr\n").find("holds no values"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "incidence_deg,brdf\n0,1\n").find("brdf_1_sr"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "wavelength_nm,incidence_deg,factor\n0,0,1\n").find("not positive"), std::string::npos);
}

// Rows away from the light do not count; between exit angles the value is interpolated.
TEST_F(BrdfTableFile, OpenMaterialIsReadWhereTheLightComesFrom) {
  const auto file = folder_.write("a_brdf.xompt", xompt("[9.05e-7, 0.0, 0.0, 0.0, 0.3],"
                                                        "[9.05e-7, 0.5, 0.4, 0.0, 0.2], [9.05e-7, 0.5, 0.4, 3.14, 9],"
                                                        "[9.05e-7, 0.5, 0.6, 0.0, 0.1], [9.05e-7, 0.5, null, 0.0, 1],"
                                                        "[9.05e-7, 1.0, 1.0, 6.283185, 0.05]"));
  const auto table = read({.file = file});
  EXPECT_NEAR(table.monostaticFactor(pi * 0.3, 1.0, 905), 1.0, 1e-12);
  EXPECT_NEAR(table.monostaticFactor(pi * 0.15, std::cos(0.5), 905), 1.0, 1e-9);
  EXPECT_NEAR(table.monostaticFactor(pi * 0.05, std::cos(1.0), 905), 1.0, 1e-9);
}

TEST_F(BrdfTableFile, MaterialNamesItsTablesAndTheOneForLidarsIsTaken) {
  (void)folder_.write("camera_brdf.xompt", xompt("[9.05e-7, 0.0, 0.0, 0.0, 0.9]", "camera"));
  (void)folder_.write("lidar_brdf.xompt", xompt("[9.05e-7, 0.0, 0.0, 0.0, 0.3]"));
  const auto file = folder_.write("m.xomp", R"({"materialProperties": {"brdfUris":
      ["missing_brdf.xompt", "camera_brdf.xompt", "lidar_brdf.xompt"]}})");
  std::vector<std::filesystem::path> files;
  EXPECT_NEAR(readBrdfTable({.file = file}, files).monostaticFactor(pi * 0.3, 1.0, 905), 1.0, 1e-12);
  EXPECT_EQ(files, (std::vector<std::filesystem::path>{file, folder_ / "lidar_brdf.xompt"}));
}

TEST_F(BrdfTableFile, OpenMaterialFaultsAreNamedWithPointer) {
  EXPECT_NE(refusal("a.xompt", xompt("[9.05e-7, 0.0, 0.0, 0.3]")).find("/brdf/lookupTable/0"), std::string::npos);
  EXPECT_NE(refusal("a.xompt", xompt("[9.05e-7, 0.5, 0.5, 3.14, 0.3]")).find("no value in the direction"),
            std::string::npos);
  EXPECT_NE(refusal("a.xompt", R"({"opticalProperties": []})").find("brdfUris"), std::string::npos);
  EXPECT_NE(refusal("m.xomp", R"({"materialProperties": {"brdfUris": ["a_brdf.xompt"]}})").find("none of the tables"),
            std::string::npos);
}

// The standard's own example: grazing angles only. Its values fall with the cosine of incidence; taken as β cos θ they
// are those of one Lambertian surface, from row to row.
TEST(OpenMaterial, ExampleIsAPlainLambertianAtGrazingAngles) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto file = shared / "data/formats/openmaterial3d_brdf/example_material_lidar_brdf.xompt";
  const auto table = read({.file = file, .times_cos = true});
  const double first = table.monostaticFactor(0.06, std::cos(1.500983), 905);
  EXPECT_NEAR(table.monostaticFactor(0.06, std::cos(1.518436), 905) / first, 1.0, 1e-3);
  EXPECT_NEAR(table.monostaticFactor(0.06, std::cos(1.535890), 905) / first, 1.0, 1e-3);
  EXPECT_NEAR(read({.file = file}).monostaticFactor(0.06, std::cos(1.500983), 905), 0.0013255 * pi / 0.06, 1e-6);
  EXPECT_NE(test_support::thrownMessage([&] { (void)table.monostaticFactor(0.06, 1.0, 905); }).find("from 86 to 90"),
            std::string::npos);
}

// Columns are [wavelength, temperature, n, κ] by the schema. The standard's example holds them the other way round: its
// aluminium agrees with Rakić 1995 only with n and k exchanged.
TEST(OpenMaterial, OpticalPropertiesAreReadAsTheSchemaSays) {
  FIDELIS_NEEDS_SHARED(shared);
  std::vector<std::filesystem::path> files;
  const auto folder = shared / "data/formats/openmaterial3d_brdf";
  const ComplexIndex example = RefractiveIndex(readOpticalConstants(folder / "example_material.xomp", files)).at(905);
  EXPECT_EQ(files.size(), 2u);
  EXPECT_EQ(files.back(), folder / "example_material_optical.xompt");
  const auto published = shared / "data/optics/refractiveindex/main_Al_nk_Rakic.yml";
  const ComplexIndex aluminium = RefractiveIndex(readOpticalConstants(published, files)).at(905);
  EXPECT_NEAR(example.real() / aluminium.imag(), 1.0, 0.1);
  EXPECT_NEAR(example.imag() / aluminium.real(), 1.0, 0.3);
}

}  // namespace
}  // namespace model
