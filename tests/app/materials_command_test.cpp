#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace {

using test_support::runFidelis;
using testing::HasSubstr;

std::string examples() { return test_support::sourceFolder() / "docs/materials"; }

// 10 log10(0.5) square on, and 3 dB less at 60 degrees by Lambert's cosine.
TEST(MaterialsCommand, LambertianFollowsTheCosine) {
  const auto run = runFidelis({"materials", examples(), "--only", "cardboard", "--json", "-"});
  ASSERT_EQ(run.status, 0) << run.messages;
  const auto values = nlohmann::json::parse(run.out)["materials"][0]["return_dB"];
  EXPECT_NEAR(values[0].get<double>(), -3.0103, 1e-4);
  EXPECT_NEAR(values[2].get<double>(), -6.0206, 1e-4);
}

TEST(MaterialsCommand, TableHasADashWhereItEndsAndAPictureIsDrawn) {
  const test_support::TemporaryFolder folder;
  const auto picture = folder / "m.svg";
  const auto run = runFidelis({"materials", examples(), "--only", "measured", "--svg", picture.string()});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.out, HasSubstr("–"));
  EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST(MaterialsCommand, FaultsAreBadInput) {
  const auto typo = runFidelis({"materials", examples(), "--only", "cardbord"});
  EXPECT_EQ(typo.status, 2);
  EXPECT_THAT(typo.messages, HasSubstr("Did you mean 'cardboard'?"));
  const auto wavelength = runFidelis({"materials", examples(), "--wavelength", "700"});
  EXPECT_EQ(wavelength.status, 2);
  EXPECT_THAT(wavelength.messages, HasSubstr("covers wavelengths from 905 to 1550 nm"));
  EXPECT_EQ(wavelength.out, "");
}

}  // namespace
