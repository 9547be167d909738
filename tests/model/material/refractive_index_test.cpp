// Formulas against published values of real substances; files of refractiveindex.info as they are, and broken ones.
#include "model/material/refractive_index.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

namespace model {
namespace {

double indexOf(int formula, std::vector<double> coefficients, double wavelength_um) {
  return Dispersion{formula, std::move(coefficients)}.at(wavelength_um);
}

// Malitson 1965, doi:10.1364/JOSA.55.001205: fused silica, n_d = 1.45846.
TEST(Dispersion, Formula1GivesFusedSilica) {
  EXPECT_NEAR(indexOf(1, {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161}, 0.5876), 1.45846, 1e-5);
}

// The same law with the squares written out.
TEST(Dispersion, Formula2IsFormula1WithSquaredResonances) {
  EXPECT_NEAR(indexOf(2, {0, 0.6961663, 0.0684043 * 0.0684043, 0.4079426, 0.1162414 * 0.1162414}, 0.905),
              indexOf(1, {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414}, 0.905), 1e-12);
}

// Nikon SK2, catalogue 2017-11: n_d = 1.607380.
TEST(Dispersion, Formula3GivesACatalogueGlass) {
  EXPECT_NEAR(
      indexOf(3, {2.54233, -0.01001372, 2, 0.01366271, -2, 0.0008285866, -4, -8.590268e-05, -6, 5.079496e-06, -8},
              0.5875618),
      1.607380, 2e-6);
}

// Beta barium borate, ordinary ray: 1.6551 at 1064 nm (laser crystal tables), coefficients of Eimerl 1987.
TEST(Dispersion, Formula4GivesBariumBorate) {
  EXPECT_NEAR(indexOf(4, {2.7405, 0.0184, 0, 0.0179, 1, 0, 0, 0, 1, -0.0155, 2}, 1.064), 1.6551, 2e-4);
}

TEST(Dispersion, Formula5IsCauchysSeries) {
  EXPECT_NEAR(indexOf(5, {1.5, 0.004, -2, 1e-4, -4}, 0.5), 1.5 + 0.004 / 0.25 + 1e-4 / 0.0625, 1e-15);
}

// Argon at 0 °C and 1 atm: n - 1 = 2.82e-4 in green light; Bideau-Mehu 1981.
TEST(Dispersion, Formula6GivesArgon) {
  EXPECT_NEAR(indexOf(6, {0, 2.50141e-3, 91.012, 5.00283e-4, 87.892, 5.22343e-2, 214.02}, 0.546) - 1, 2.82e-4, 2e-6);
}

// Silicon at 10 µm: 3.418 (Salzberg & Villa 1957); coefficients of Edwards & Ochoa 1980.
TEST(Dispersion, Formula7GivesSilicon) {
  EXPECT_NEAR(indexOf(7, {3.41983, 0.159906, -0.123109, 1.26878e-6, -1.95104e-9}, 10.0), 3.418, 5e-3);
}

// Silver bromide in sodium light: 2.253 (handbooks); coefficients of Schröter 1931.
TEST(Dispersion, Formula8GivesSilverBromide) {
  EXPECT_NEAR(indexOf(8, {0.452505, 0.09939, 0.070537, -0.000150}, 0.5893), 2.253, 5e-3);
}

// Urea in sodium light, extraordinary ray: 1.602 (handbooks); coefficients of Rosker 1985.
TEST(Dispersion, Formula9GivesUrea) {
  EXPECT_NEAR(indexOf(9, {2.51527, 0.0240, 0.0300, 0.020, 1.52, 0.8771}, 0.5893), 1.602, 6e-3);
}

RefractiveIndex read(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  return RefractiveIndex(readOpticalConstants(file, files));
}

TEST(RefractiveIndexInfo, FilesAreReadAsPublished) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto folder = shared / "data/optics/refractiveindex";
  const ComplexIndex water = read(folder / "main_H2O_nk_Hale.yml").at(900);
  EXPECT_DOUBLE_EQ(water.real(), 1.328);
  EXPECT_NEAR(water.imag(), 4.86e-7, 1e-12);
  EXPECT_NEAR(fresnelReflectance(1.0, read(folder / "main_H2O_nk_Hale.yml").at(905)).s, 0.02, 3e-4);
  // Two laboratories agree on water; the second as formula with a table of k.
  EXPECT_NEAR(read(folder / "main_H2O_nk_Kedenburg.yml").at(905).real(), water.real(), 3e-3);
  EXPECT_NEAR(read(folder / "main_SiO2_nk_Malitson.yml").at(587.6).real(), 1.45846, 1e-5);
  EXPECT_EQ(read(folder / "main_TiO2_nk_Bond-o.yml").at(900), ComplexIndex(2.4995, 0.0));  // a table of n alone
  // Bare aluminium reflects most, with its known dip around 830 nm.
  const auto aluminium = read(folder / "main_Al_nk_Rakic.yml");
  EXPECT_LT(fresnelReflectance(1.0, aluminium.at(830)).s, fresnelReflectance(1.0, aluminium.at(1550)).s);
  EXPECT_GT(fresnelReflectance(1.0, aluminium.at(1550)).s, 0.95);
}

TEST(RefractiveIndexInfo, EverySharedFileCoversTheLidarWavelengths) {
  FIDELIS_NEEDS_SHARED(shared);
  for (const auto& entry : std::filesystem::directory_iterator(shared / "data/optics/refractiveindex")) {
    const auto index = read(entry.path());
    for (const double nm : {905.0, 940.0, 1550.0}) {
      EXPECT_GT(index.at(nm).real(), 0.5) << entry.path();
      EXPECT_GE(index.at(nm).imag(), 0.0) << entry.path();
    }
  }
}

class BrokenFile : public testing::Test {
 protected:
  std::string refusal(const std::string& content, double wavelength_nm = 905) {
    const auto file = folder_.write("x.yml", content);
    return test_support::thrownMessage([&] { (void)read(file).at(wavelength_nm); });
  }
  bool refusedWith(const std::string& content, const std::string& words) {
    const std::string message = refusal(content);
    EXPECT_NE(message.find(words), std::string::npos) << message;
    return message.find(words) != std::string::npos;
  }
  test_support::TemporaryFolder folder_;
};

TEST_F(BrokenFile, IsNamedWithItsLine) {
  refusedWith("DATA:\n  - type: tabulated nk\n    data: |\n        0.8 1.3 0\n        0.9 1.3\n", "x.yml:5");
  refusedWith("DATA:\n  - type: tabulated n\n    data: |\n        0.9 1.3\n        -0.8 1.3\n", "x.yml:5");
  refusedWith("DATA:\n  - type: tabulated n\n    data: |\n        0.9 abc\n", "'abc' is not a number");
  refusedWith("DATA:\n  - type: formula 10\n    wavelength_range: 0.4 2\n    coefficients: 0 1 2\n", "x.yml:2");
  refusedWith("DATA:\n  - type: formula 8\n    wavelength_range: 0.4 2\n    coefficients: 0 1 2 3 4\n",
              "5 coefficients");
  refusedWith("DATA:\n  - type: formula 1\n    coefficients: 0 1 2\n", "has no 'wavelength_range'");
  refusedWith("DATA:\n  - type: tabulated k\n    data: |\n        0.9 1\n", "says nothing about n");
  refusedWith("DATA: 5\n", "has no list 'DATA'");
  refusedWith("DATA: [\n", "is no YAML");
  refusedWith("", "has no list 'DATA'");
  refusedWith("DATA:\n  - type: formula 3\n    wavelength_range: 0.4 2\n    coefficients: -1\n", "has no value");
}

TEST_F(BrokenFile, WavelengthOutsideIsRefusedWithTheRange) {
  const std::string table = "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.3\n        0.7 1.4\n";
  EXPECT_NE(refusal(table).find("from 0.4 to 0.7 µm; the emitter's 0.905 µm lies outside"), std::string::npos);
  EXPECT_EQ(refusal(table, 700), "");
}

}  // namespace
}  // namespace model
