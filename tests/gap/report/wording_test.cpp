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

// It is believed that it is one of both: no headline may say that no effect is missing, or name one of them alone.
TEST(Answer, OfCausesThatCannotBeToldApartNamesBoth) {
  Diagnosis diagnosis;
  diagnosis.verdict.kind = VerdictKind::kParameter;
  diagnosis.verdict.names = {"/sensor/receiver/threshold_w"};
  diagnosis.verdict.indistinguishable_from = {"dynamic-threshold"};
  diagnosis.verdict.confidence = 0.94;
  diagnosis.causes.resize(2);
  diagnosis.causes[0].kind = CauseKind::kParameter;
  diagnosis.causes[0].name = "/sensor/receiver/threshold_w";
  diagnosis.causes[1].name = "dynamic-threshold";
  EXPECT_EQ(answerSentence(diagnosis),
            "Either a number is wrong in the simulation (detection threshold of the receiver), or an effect is missing "
            "in the simulation (threshold that follows the noise): these data cannot tell which.");
  diagnosis.verdict.kind = VerdictKind::kEffect;
  diagnosis.verdict.names = {"speckle"};
  diagnosis.causes[0].kind = CauseKind::kEffect;
  diagnosis.causes[0].name = "speckle";
  EXPECT_EQ(answerSentence(diagnosis),
            "The measurement shows an effect that the simulation lacks: speckle or threshold that follows the noise, "
            "which these data cannot tell apart.");
}

/// Of a model that shows so large a gap when it is run, where the diagnosis sees one of 100.
std::string asRunOf(double before_total, std::optional<AsRun::Corrected> corrected) {
  Diagnosis diagnosis;
  diagnosis.before.total = 100.0;
  diagnosis.shrink.fraction = 0.6;
  diagnosis.as_run = AsRun{before_total, corrected, 11, 9};
  return asRunSentence(diagnosis);
}

TEST(AsRun, IsSaidWhereItsOwnGridShrinksOtherwiseOrMakesMuchOfTheGap) {
  const std::string traced =
      "Beams that meet the edge of an object, or a surface very obliquely, are traced more finely here than the model "
      "does with its 11 × 9 rays per beam. Run as it is, it shows a total gap of ";
  EXPECT_EQ(asRunOf(120.0, AsRun::Corrected{90.0, {.fraction = 0.25}}),
            traced + "120 and, corrected, 90: 25 % less. More rays bring it nearer to what is said here.");
  EXPECT_EQ(asRunOf(400.0, std::nullopt), traced + "400 in place of 100. More rays take that away.");
  EXPECT_EQ(asRunOf(400.0, AsRun::Corrected{160.0, {.fraction = 0.6}}),
            traced + "400 in place of 100. More rays take that away.");
  EXPECT_EQ(asRunOf(120.0, AsRun::Corrected{48.0, {.fraction = 0.6}}), "") << "about what is said of the finer grid";
  EXPECT_EQ(asRunOf(80.0, std::nullopt), "");
}

TEST(Recalibrations, AreSaidOfTheEffectInWhosePlaceTheyMayStand) {
  const std::vector<Rival> numbers = {{"/materials/board/reflectivity", 0.5, "blooming"},
                                      {"/sensor/emitter/peak_power_w", 0.0, "blooming"}};
  Diagnosis diagnosis;
  EXPECT_TRUE(recalibrationSentences(diagnosis, numbers).empty()) << "no cause is named in the end";
  diagnosis.verdict.names = {"aperture-offset", "blooming"};
  EXPECT_EQ(
      recalibrationSentences(diagnosis, numbers),
      std::vector<std::string>{
          "Instead of blooming a number may be wrong: beside offset of the receiver's axis, another reflectivity "
          "of the material “board” or peak power of the emitter does as well, and these data cannot tell which it is. "
          "Check the number before you add the effect."});
  EXPECT_TRUE(recalibrationSentences(diagnosis, {}).empty());
}

/// Of a cloud, named or only weighed, that came out as large as clouds are searched.
std::string atEndOf(const std::vector<std::string>& named) {
  Diagnosis diagnosis;
  diagnosis.verdict.kind = VerdictKind::kEffect;
  diagnosis.verdict.names = named;
  Cause cloud{.name = "exhaust-cloud"};
  cloud.parameters.push_back(
      {.name = "extinction_1_m", .unit = "1/m", .value = 0.002, .plausible = Interval{0.0, 10.0}});
  cloud.parameters.push_back(
      {.name = "size_m", .unit = "m", .value = 9.99, .plausible = Interval{0.1, 10.0}, .at_end = true});
  diagnosis.causes = {cloud};
  return atEndSentence(diagnosis);
}

TEST(AtEndSentence, SaysWhichNumberOfTheAnswerIsAsLargeAsItWasSearched) {
  EXPECT_EQ(
      atEndOf({"exhaust-cloud"}),
      "At the end of what is plausible: diameter of the cloud (9.99 m; searched from 0.1 to 10 m). If the data ask "
      "for more than that, something else is at work.");
  EXPECT_EQ(atEndOf({"range-offset"}), "");
}

}  // namespace
}  // namespace gap
