#include "specs/trace.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/specs/small_project.h"
#include "tests/support/paths.h"

namespace specs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Specification filled() {
  test_support::TemporaryFolder folder;
  auto store = ProjectStore::create(folder / "demo.fidelis");
  test_specs::fill(store);
  store.storeRun({.verdicts = {{.test = "RangeError_Fog_3", .verdict = Verdict::Failed}}});
  return store.specification();
}

TEST(Trace, LeadsBothWaysOverAllSteps) {
  const LinkIndex index(filled());
  EXPECT_THAT(index.allFollowersOf("RangeError_Fog_1"),
              ElementsAre("RangeError_Fog_2", "RangeError_Fog_3", "RangeError_Fog_4", "RangeError_Fog_5"));
  EXPECT_EQ(index.allOriginsOf("RangeError_Fog_5").size(), 4u);
  EXPECT_EQ(index.allOriginsOf("RangeError_Fog_5").back()[0], 'r') << "the CEPRA row is the last origin";
}

TEST(Trace, TextIsATreeWithStatusAndVerdict) {
  const std::string text = traceText(filled(), "RangeError_Fog_2");
  EXPECT_THAT(text, HasSubstr("RangeError_Fog_2  requirement, accepted: Range bias in fog\n"
                              "follows from\n"
                              "  RangeError_Fog_1  requirement, accepted: Fog is modelled\n"
                              "    r"));
  EXPECT_THAT(text, HasSubstr("leads to\n"
                              "  RangeError_Fog_3  acceptance test, accepted, failed: Range bias at 10 m\n"
                              "    RangeError_Fog_4  experiment data requirement, under review: Sweep\n"
                              "    RangeError_Fog_5  reference data requirement, under review: True range\n"));
}

TEST(Trace, EndsInACircleToo) {
  Specification specification;
  specification.requirements = {Requirement{{.id = "A_B_1"}}, Requirement{{.id = "A_B_2"}}};
  specification.links = {{"A_B_1", "A_B_2"}, {"A_B_2", "A_B_1"}};
  EXPECT_THAT(traceText(specification, "A_B_1"), HasSubstr("(see above)"));
}

TEST(Trace, AnUnknownIdNamesTheNearest) {
  try {
    (void)traceText(filled(), "RangeError_Fig_2");
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("Did you mean 'RangeError_Fog_2'?"));
  }
}

}  // namespace
}  // namespace specs
