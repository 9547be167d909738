#include "gap/report/wording.h"

#include <gtest/gtest.h>

namespace gap {
namespace {

std::string sentenceOf(VerdictKind kind, const std::vector<std::string>& names) {
  Diagnosis diagnosis;
  diagnosis.verdict.kind = kind;
  diagnosis.verdict.names = names;
  diagnosis.verdict.confidence = 0.8;
  diagnosis.shrink.fraction = 0.6;
  return verdictSentence(diagnosis);
}

TEST(VerdictSentence, SaysOneWrongNumberAndTwoOfThemInTheirOwnWords) {
  EXPECT_EQ(sentenceOf(VerdictKind::kParameter, {"/sensor/receiver/noise_w"}),
            "The parameter /sensor/receiver/noise_w has a wrong value; with the fitted one the gap on held-out samples "
            "shrinks by 60 % (confidence 80 %).");
  EXPECT_EQ(sentenceOf(VerdictKind::kParameter, {"/sensor/receiver/noise_w", "/scene/0/pose/position_m/0"}),
            "Both /sensor/receiver/noise_w and /scene/0/pose/position_m/0 are wrong; corrected, the gap on held-out "
            "samples shrinks by 60 % (confidence 80 %).");
}

TEST(VerdictSentence, DoesNotCallADifferenceThatIsCertainButTooSmallToMatterNoise) {
  Diagnosis diagnosis;
  diagnosis.verdict.kind = VerdictKind::kNone;
  diagnosis.verdict.confidence = 0.5;
  diagnosis.p_value = 0.2;
  EXPECT_EQ(verdictSentence(diagnosis),
            "Measurement and simulation do not differ by more than their uncertainty (confidence 50 %).");
  EXPECT_EQ(answerSentence(diagnosis),
            "Measurement and simulation agree as far as these data can tell: there is no gap to explain.");
  diagnosis.p_value = 1e-9;
  EXPECT_EQ(verdictSentence(diagnosis),
            "Measurement and simulation differ by more than noise, but by too little to matter against the sensor's "
            "resolution (confidence 50 %).");
  EXPECT_EQ(answerSentence(diagnosis),
            "Measurement and simulation agree to within what matters at the sensor's resolution: no gap is to be "
            "explained.");
}

}  // namespace
}  // namespace gap
