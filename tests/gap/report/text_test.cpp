#include "gap/report/text.h"

#include <gmock/gmock.h>

#include "gap/report/wording.h"

namespace gap {
namespace {

using testing::HasSubstr;
using testing::Not;

Cause causeNamed(const std::string& name, double explained) {
  Cause cause;
  cause.name = name;
  cause.explained = explained;
  return cause;
}

/// A gap of two causes, of which a third one may stand for the second.
Diagnosis twoCauses() {
  Diagnosis diagnosis;
  diagnosis.present = true;
  diagnosis.verdict.kind = VerdictKind::kEffect;
  diagnosis.verdict.names = {"spoofing", "thermal-noise"};
  diagnosis.verdict.indistinguishable_from = {"speckle"};
  diagnosis.causes = {causeNamed("spoofing", 0.98), causeNamed("thermal-noise", 0.98), causeNamed("speckle", 0.97),
                      causeNamed("pulse-jitter", 0.4)};
  return diagnosis;
}

WhereRow row(const std::string& measurand, const std::string& component, const std::string& covariate, double p_value) {
  return {.measurand = measurand, .component = component, .covariate = covariate, .p_value = p_value};
}

// What two explain together, neither explains; a third one may be at work instead of one of them.
TEST(ReportText, SaysOfEveryCauseWhatPartItHasInTheVerdict) {
  const std::string text = reportText(twoCauses());
  EXPECT_THAT(text, HasSubstr("  cause: effect spoofing, explains with thermal-noise 98 %"));
  EXPECT_THAT(text, HasSubstr("  cause: effect thermal-noise, explains with spoofing 98 %"));
  EXPECT_THAT(text, HasSubstr("  or instead: effect speckle, explains 97 %"));
  EXPECT_THAT(text, HasSubstr("  also weighed: effect pulse-jitter, explains 40 %"));
}

TEST(ReportText, SaysWhatStandsBesideTheNamedCause) {
  Diagnosis diagnosis = twoCauses();
  diagnosis.verdict.names = {"spoofing"};
  diagnosis.verdict.beside = {"thermal-noise"};
  const std::string text = reportText(diagnosis);
  EXPECT_THAT(text, HasSubstr("  cause: effect spoofing, explains with thermal-noise 98 %"));
  EXPECT_THAT(text, HasSubstr("  beside it: effect thermal-noise, explains with spoofing 98 %"));
}

TEST(ReportText, SaysOfOneCauseWhatItExplainsAlone) {
  Diagnosis diagnosis = twoCauses();
  diagnosis.verdict.names = {"spoofing"};
  EXPECT_THAT(reportText(diagnosis), HasSubstr("  cause: effect spoofing, explains 98 %"));
}

// Three lines that say the same along other quantities would hide that something else differs, too.
TEST(ReportText, ShowsEveryKindOfDifferenceOnce) {
  Diagnosis diagnosis = twoCauses();
  diagnosis.where = {row("intensity", "scatter", "incidence_deg", 1e-9), row("intensity", "scatter", "range_m", 1e-9),
                     row("existence", "extra", "azimuth_deg", 1e-9), row("epw", "bias", "range_m", 0.4)};
  const PartedRows parted = partedByKind(diagnosis.where);
  ASSERT_EQ(parted.first.size(), 2U);
  EXPECT_EQ(parted.first[0].covariate, "incidence_deg");
  EXPECT_EQ(parted.first[1].covariate, "azimuth_deg");
  ASSERT_EQ(parted.others.size(), 2U);
  EXPECT_EQ(parted.others[1].measurand, "epw");  // may be chance
  const std::string text = reportText(diagnosis);
  for (const WhereRow& shown : parted.first) EXPECT_THAT(text, HasSubstr("  where: " + whereSentence(shown)));
  for (const WhereRow& hidden : parted.others) EXPECT_THAT(text, Not(HasSubstr(whereSentence(hidden))));
}

TEST(ReportText, ShowsWhatMayBeChanceWhereAllOfItMay) {
  EXPECT_EQ(partedByKind({row("epw", "bias", "range_m", 0.4), row("epw", "bias", "angle_deg", 0.5)}).first.size(), 1U);
}

}  // namespace
}  // namespace gap
