#include "specs/shown_id.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace specs {
namespace {

TEST(ShownId, IsPhenomenonCausesAndNumber) {
  EXPECT_TRUE(isShownId("FalseNegativeDetection_AttenuationByAerosols_1"));
  EXPECT_TRUE(isShownId("RangeError_Quantisation_LeadingEdge_12"));
  for (const char* wrong :
       {"", "RangeError", "RangeError_1", "RangeError__1", "rangeError_Offset_1", "RangeError_Offset_0",
        "RangeError_Offset_01", "RangeError_Offset_x", "Range Error_Offset_1", "RangeError_Offset_",
        "_RangeError_Offset_1", "RangeError_Öffset_1", "RangeError_Offset_12345678901"}) {
    EXPECT_FALSE(isShownId(wrong)) << wrong;
  }
}

TEST(ShownId, TitlesBecomeCamelCase) {
  EXPECT_EQ(camelCase("Attenuation by aerosols"), "AttenuationByAerosols");
  EXPECT_EQ(camelCase("Specular/diffuse reflection"), "SpecularDiffuseReflection");
  EXPECT_EQ(camelCase("  Größe, Höhe"), "GroesseHoehe");
  EXPECT_EQ(camelCase("3D shape"), "N3DShape");
  EXPECT_EQ(camelCase("one two three", 2), "OneTwo");
  EXPECT_EQ(camelCase("→"), "");
}

TEST(ShownId, ProposalIsTheFirstFreeNumberAndAlwaysValid) {
  const std::vector<std::string> taken = {"RangeError_Offset_1", "RangeError_Offset_3"};
  EXPECT_EQ(proposeId("Range error", "Offset", taken), "RangeError_Offset_2");
  EXPECT_TRUE(isShownId(proposeId("", "→", {})));
}

TEST(ShownId, OfARowIsItsPhenomenonAndItsLastEffect) {
  const cepra::Row row{
      .effects = {{"0", "False negative detection"}, {"5", "Low power"}, {"7", "Attenuation by aerosols"}}};
  EXPECT_EQ(proposeId(row, {}), "FalseNegativeDetection_AttenuationByAerosols_1");
}

TEST(ShownId, NumbersSortByValue) {
  std::vector<std::string> ids = {"R_B_10", "R_B_2", "R_A_3", "R_B_1"};
  std::sort(ids.begin(), ids.end(), naturallyLess);
  EXPECT_EQ(ids, (std::vector<std::string>{"R_A_3", "R_B_1", "R_B_2", "R_B_10"}));
}

}  // namespace
}  // namespace specs
