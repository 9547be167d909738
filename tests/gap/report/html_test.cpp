#include "gap/report/html.h"

#include <gmock/gmock.h>
#include <limits>
#include <set>

#include "gap/report/wording.h"
#include "tests/report/svg_reader.h"

// Pages of diagnoses that are written down here: what must stand in them for each kind of verdict.
namespace {

using testing::HasSubstr;
using testing::Not;

gap::Cause causeOf(gap::CauseKind kind, const std::string& name, double explained) {
  gap::Cause cause;
  cause.kind = kind;
  cause.name = name;
  cause.explained = explained;
  cause.confidence = 0.5;
  cause.shrink = {explained, {explained - 0.05, explained + 0.02}};
  return cause;
}

gap::Diagnosis plainDiagnosis(gap::VerdictKind kind) {
  gap::Diagnosis d;
  d.experiment = "wall <1>";
  d.model = "baseline";
  d.verdict.kind = kind;
  d.verdict.confidence = 0.9;
  d.p_value = kind == gap::VerdictKind::kNone ? 0.4 : 0.0;
  d.present = kind != gap::VerdictKind::kNone;
  d.held_out = {"r19", "r36"};
  d.before = {{{"epw", "m", 0.31, 0.04, 0.04}}, 0.02, 0.0, 11.0};
  d.bias_intervals["epw"] = {0.29, 0.33};
  d.background = {{"target"}, {"r08", "r13"}, 80, 12345, d.present ? 60U : 0U, {"beam-divergence"}};
  d.curves.push_back({"epw", "m", "r19", {1.0, 1.1, 1.2}, {1.3, 1.4, 1.5}, {}});
  if (!d.present) return d;
  d.where.push_back({.measurand = "epw",
                     .component = "bias",
                     .covariate = "range_m",
                     .low = 20.0,
                     .high = 69.0,
                     .value = -0.31,
                     .unit = "m",
                     .share = 0.77,
                     .size = 0.37,
                     .p_value = 0.0});
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const char* component : {"bias", "scatter"})
    d.maps.push_back({"epw", component, "m", "r19", 1.0, {"-0.4°", "0.4°"}, {{0.0, 0, -0.3}, {1.0, 1, none}}});
  return d;
}

gap::Diagnosis withCause(gap::VerdictKind kind, const gap::Cause& cause) {
  gap::Diagnosis d = plainDiagnosis(kind);
  d.causes = {cause, causeOf(gap::CauseKind::kEffect, "cover-contamination", 0.58)};
  d.confusion = {{cause.name, "cover-contamination"}, {{1.0, 0.25}, {0.25, 1.0}}};
  if (kind == gap::VerdictKind::kUnknown) return d;
  d.verdict.names = {cause.name};
  d.shrink = cause.shrink;
  d.after = gap::TotalGap{{{"epw", "m", 0.003, 0.007, 0.04}}, 0.0, 0.0, 0.5};
  d.curves[0].after = {1.01, 1.11, 1.21};
  d.next_experiment = gap::NextExperiment{.text = "Repeat.",
                                          .separates = {cause.name, "cover-contamination"},
                                          .parameters = {{"range_m", 57.0}},
                                          .sample = "r57",
                                          .predictions = {{"epw", "m", 0.8, {2.61, 2.11, 2.34}, 0.02}}};
  return d;
}

gap::Diagnosis fogDiagnosis() {
  gap::Cause fog = causeOf(gap::CauseKind::kEffect, "atmospheric-attenuation", 0.96);
  fog.decomposition_block = "Signal propagation";
  fog.parameters = {{"visibility_m", "m", 522.0, gap::Interval{450.0, 594.0}, gap::Interval{20.0, 20000.0}, {}}};
  fog.chain = {"87", "54", "39"};
  fog.chain_titles = {"Extinction by fog", "Weak echo", "Echo pulse width error"};
  gap::Diagnosis d = withCause(gap::VerdictKind::kEffect, fog);
  d.proposed_model = {{"effects", {{"atmospheric-attenuation", {{"visibility_m", 521.9123456}}}}}};
  return d;
}

/// What every page must be: well-formed, alone, with targets for its links, a sentence after each heading of a section.
void expectSoundPage(const std::string& html) {
  std::set<std::string> ids, targets;
  std::size_t sections = 0, leads = 0;
  report_test::eachElement(html, [&](const tinyxml2::XMLElement& element) {
    const std::string name = element.Name();
    if (const char* id = element.Attribute("id")) {
      EXPECT_TRUE(ids.insert(id).second) << "twice: " << id;
    }
    if (const char* href = element.Attribute("href")) {
      ASSERT_EQ(href[0], '#') << href;
      targets.insert(href + 1);
    }
    if (name == "h2" && element.Attribute("id") && std::string(element.Attribute("id")) != "answer-heading") {
      ++sections;
      const auto* next = element.NextSiblingElement();
      leads += next && next->Attribute("class", "lead") ? 1 : 0;
    }
    EXPECT_NE(name, "script");
    EXPECT_NE(name, "img");
    EXPECT_EQ(element.Attribute("src"), nullptr);
    if (name == "svg") {
      EXPECT_TRUE(element.Attribute("aria-hidden") || element.FirstChildElement("title"));
    }
  });
  EXPECT_EQ(sections, leads);
  for (const std::string& target : targets) EXPECT_TRUE(ids.count(target)) << "no target for #" << target;
  for (const char* section : {"answer", "where", "causes", "shrink", "method", "word-total-gap"})
    EXPECT_TRUE(ids.count(section)) << section;
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(GapPage, OfAMissingEffectNamesItWithItsStrengthItsTrustAndItsNextSteps) {
  const std::string html = gap::reportHtml(fogDiagnosis());
  expectSoundPage(html);
  EXPECT_THAT(html, HasSubstr("missing effect"));
  EXPECT_THAT(html, HasSubstr("attenuation by the atmosphere"));
  EXPECT_THAT(html, HasSubstr("Fog, haze or rain weaken the light"));  // for who never heard of it
  EXPECT_THAT(html, HasSubstr("<code>atmospheric-attenuation</code>"));
  EXPECT_THAT(html, HasSubstr("522 m (95 % interval 450 to 594 m)"));
  EXPECT_THAT(html, HasSubstr("searched 20 to 20000 m"));
  EXPECT_THAT(html, HasSubstr("id=\"proposal\""));
  EXPECT_THAT(html, HasSubstr("521.9"));
  EXPECT_THAT(html, HasSubstr("id=\"experiment\""));
  EXPECT_THAT(html, HasSubstr("2.34 m"));  // what the rival predicts there
  EXPECT_THAT(html, HasSubstr("id=\"confusion\""));
  EXPECT_THAT(html, HasSubstr("Weak echo"));
  EXPECT_THAT(html, HasSubstr("<span class=\"badge bad\">Signal propagation</span>"));
  EXPECT_THAT(html, HasSubstr("wall &lt;1&gt;"));
}

// To measure a place again takes less than to change a model for what may be no effect.
TEST(GapPage, OfAnEffectOrAWrongReferenceShowsBothAndSendsToTheReferenceFirst) {
  const std::string place = "/scene/0/pose/position_m/0";
  gap::Diagnosis d = fogDiagnosis();
  d.causes.insert(d.causes.begin() + 1, causeOf(gap::CauseKind::kReference, place, 0.9));
  d.verdict.indistinguishable_from = {place};
  const auto expectBoth = [](const gap::Diagnosis& diagnosis, const std::string& badges) {
    const std::string html = gap::reportHtml(diagnosis);
    expectSoundPage(html);
    EXPECT_THAT(html, HasSubstr(badges));
    EXPECT_THAT(html, HasSubstr("Measure the reference again first ("));
    EXPECT_THAT(html, Not(HasSubstr("do not change the sensor model")));
  };
  const std::string effect = "<span class=\"badge bad\">missing effect</span>";
  const std::string reference = "<span class=\"badge bad\">wrong reference data</span>";
  expectBoth(d, effect + " or " + reference);
  std::swap(d.causes[0], d.causes[1]);
  d.verdict.kind = gap::VerdictKind::kReference;
  d.verdict.names = {place};
  d.verdict.indistinguishable_from = {"atmospheric-attenuation"};
  expectBoth(d, reference + " or " + effect);
}

TEST(GapPage, OfAnEffectAndANumberCorrectedBesideItTellsBothAndWhatChangesInTheModel) {
  gap::Diagnosis d = fogDiagnosis();
  d.causes.insert(d.causes.begin() + 1, causeOf(gap::CauseKind::kParameter, "/sensor/emitter/peak_power_w", 0.96));
  d.verdict.beside = {"/sensor/emitter/peak_power_w"};
  d.proposed_model["sensor"] = {{"emitter", {{"peak_power_w", 43.34}}}};
  const std::string html = gap::reportHtml(d);
  expectSoundPage(html);
  EXPECT_THAT(html, HasSubstr("Besides, the peak power of the emitter is wrong."));
  EXPECT_THAT(html, HasSubstr("<span class=\"badge bad\">corrected too</span>"));
  EXPECT_THAT(html, HasSubstr("43.34"));
  EXPECT_THAT(html, HasSubstr("both together"));
}

TEST(GapPage, OfCausesThatNoSingleBeamTellsApartAsksForALongerRecord) {
  gap::Diagnosis d = fogDiagnosis();
  EXPECT_THAT(gap::reportHtml(d), Not(HasSubstr("record for longer")));
  d.next_experiment->predictions.clear();
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("No single beam on a surface shows it"));
}

TEST(GapPage, OfBeamsThatJudgeDoesNotSayThatNoFitSawTheSamples) {
  gap::Diagnosis d = fogDiagnosis();
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("they took no part in fitting it"));
  d.weak_hold_out = true;
  const std::string html = gap::reportHtml(d);
  EXPECT_THAT(html, Not(HasSubstr("they took no part in fitting it")));
  EXPECT_THAT(html, HasSubstr("one half of the beams took no part"));
}

TEST(GapPage, OfACauseThatMayShrinkNoPooledGapSaysWhyItIsNamedAllTheSame) {
  gap::Diagnosis d = fogDiagnosis();
  d.verdict.evidence.explained = 0.84;
  d.shrink = {0.04, {-0.7, 0.74}};
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("Beam by beam the cause explains 84 % of what differs. Pooled over all"));
  d.shrink = {0.04, {0.01, 0.74}};
  EXPECT_THAT(gap::reportHtml(d), Not(HasSubstr("Beam by beam the cause explains"))) << "it shrinks beyond luck";
  d.shrink = {0.6, {-0.1, 0.74}};
  EXPECT_THAT(gap::reportHtml(d), Not(HasSubstr("Beam by beam the cause explains"))) << "it shrinks by about as much";
}

TEST(GapPage, OfNoGapSaysSoAndSearchesForNoCause) {
  const std::string html = gap::reportHtml(plainDiagnosis(gap::VerdictKind::kNone));
  expectSoundPage(html);
  EXPECT_THAT(html, HasSubstr("no gap"));
  EXPECT_THAT(html, HasSubstr("agree as far as these data can tell"));
  EXPECT_THAT(html, Not(HasSubstr("id=\"next\"")));
  EXPECT_THAT(html, Not(HasSubstr("id=\"confusion\"")));
}

TEST(GapPage, OfAnUnknownCauseShowsTheNearestButProposesNothing) {
  const std::string html =
      gap::reportHtml(withCause(gap::VerdictKind::kUnknown, causeOf(gap::CauseKind::kEffect, "range-walk", 0.41)));
  expectSoundPage(html);
  EXPECT_THAT(html, HasSubstr("cause unknown"));
  EXPECT_THAT(html, HasSubstr("41 %"));
  EXPECT_THAT(html, Not(HasSubstr("id=\"proposal\"")));
  EXPECT_THAT(html, Not(HasSubstr(">named<")));
}

TEST(GapPage, OfAnUnknownCauseSaysWhichTwoComeNearerTogether) {
  gap::Diagnosis d = withCause(gap::VerdictKind::kUnknown, causeOf(gap::CauseKind::kEffect, "range-walk", 0.41));
  d.verdict.nearest_pair = gap::NearestPair{{"range-walk", "cover-contamination"}, 0.83};
  const std::string html = gap::reportHtml(d);
  expectSoundPage(html);
  EXPECT_THAT(html, HasSubstr("together 83 %"));
  d.verdict.text = gap::verdictSentence(d);
  EXPECT_THAT(d.verdict.text,
              HasSubstr("range-walk, explains 41 %, range-walk and cover-contamination together 83 %."));
}

TEST(GapPage, OfAGapThatNoPartShowsByItselfDoesNotSayThatNothingDeviates) {
  gap::Diagnosis d = withCause(gap::VerdictKind::kUnknown, causeOf(gap::CauseKind::kEffect, "detection-loss", 0.7));
  d.where.clear();
  const std::string page = gap::reportHtml(d);
  expectSoundPage(page);
  EXPECT_THAT(page, HasSubstr("shows only when all data are taken together"));
  EXPECT_THAT(page, Not(HasSubstr("by enough to matter")));
}

TEST(GapPage, OfAnUnknownCauseSaysWhatRepeatsItselfAndWhereToLookFirst) {
  gap::Diagnosis d = plainDiagnosis(gap::VerdictKind::kUnknown);
  d.rest = gap::Rest{.left = 1.0, .systematic = 0.98, .laws = {{"range", "bias", "m", 0.0, {}, 0.98}}};
  d.rest->laws.front().terms = {{"range_m", "sin x", 0.03, 0.9, 0.2}};
  const std::string html = gap::reportHtml(d);
  expectSoundPage(html);
  EXPECT_THAT(html, HasSubstr("repeats every 0.9 m of distance: 98 % of what is left there."));
  EXPECT_THAT(html, HasSubstr("Look at how the sensor measures time first"));
}

TEST(GapPage, OfAWrongParameterSaysWhatTheFileSaysAndWhatTheMeasurementAsksFor) {
  gap::Cause power = causeOf(gap::CauseKind::kParameter, "/sensor/emitter/peak_power_w", 0.97);
  power.parameters = {{"value", "W", 44.2, std::nullopt, gap::Interval{12.5, 200.0}, 50.0}};
  const std::string html = gap::reportHtml(withCause(gap::VerdictKind::kParameter, power));
  expectSoundPage(html);
  EXPECT_THAT(html, HasSubstr("wrong parameter"));
  EXPECT_THAT(html, HasSubstr("peak power of the emitter"));
  EXPECT_THAT(html, HasSubstr("44.2 W"));
  EXPECT_THAT(html, HasSubstr("the model says 50 W"));
}

TEST(GapPage, OfLargeNumbersWritesNoExponent) {
  gap::Diagnosis d = fogDiagnosis();
  d.before.total = 2062.4;
  d.causes[0].parameters[0].value = 2062.4;
  const std::string html = gap::reportHtml(d);
  EXPECT_THAT(html, HasSubstr("from 2060 to 0.5"));
  EXPECT_THAT(html, HasSubstr("2060 m (95 % interval"));
  EXPECT_THAT(html, Not(HasSubstr("e+0")));
}

TEST(GapPage, OfWrongReferenceDataNamesTheObjectTheAxisAndEverySetUp) {
  gap::Cause place = causeOf(gap::CauseKind::kReference, "/scene/0/pose/position_m/0", 0.97);
  place.setups["r13"] = {"r13", "m", 0.12, {}, {}, {}};
  place.setups["r36"] = {"r36", "m", -0.08, {}, {}, {}};
  const std::string html = gap::reportHtml(withCause(gap::VerdictKind::kReference, place));
  expectSoundPage(html);
  EXPECT_THAT(html, HasSubstr("wrong reference data"));
  EXPECT_THAT(html, HasSubstr("recorded position of “target”, x (forward)"));
  EXPECT_THAT(html, HasSubstr("r13 +0.12 m; r36 -0.08 m"));
}

TEST(GapPage, OfTwoCausesNamesBothAndOfATieItsRival) {
  gap::Diagnosis d = fogDiagnosis();
  d.causes[1].name = "detection-loss";
  d.verdict.names.push_back("detection-loss");
  expectSoundPage(gap::reportHtml(d));
  d.verdict.indistinguishable_from = {"false-alarm"};
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("effects that the simulation lacks"));
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("name the right causes"));
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("cannot tell one of them from"));
  d = fogDiagnosis();
  d.verdict.indistinguishable_from = {"cover-contamination"};
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("cannot tell it from"));
}

TEST(GapPage, SaysWhenDataAreSyntheticAndWhenNoSampleCouldBeHeldOut) {
  gap::Diagnosis d = fogDiagnosis();
  EXPECT_THAT(gap::reportHtml(d), Not(HasSubstr("Synthetic data")));
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("samples that the fit never saw"));
  d.synthetic = d.weak_hold_out = true;
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("Synthetic data"));
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("other beams of the same samples"));
  EXPECT_THAT(gap::reportHtml(d), Not(HasSubstr("samples that the fit never saw")));
  d.verdict.limits = {"there is one sample only"};
  d.notes = {"The intensity was not measured."};
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("The data tell little: there is one sample only."));
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("The intensity was not measured."));
  EXPECT_THAT(gap::reportHtml(d), Not(HasSubstr("Likely, but not sure")));
  d.verdict.confidence = 0.5;
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("Likely, but not sure: the measurement shows"));
  d.verdict.confidence = 0.3;
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("Possibly, hardly more than a guess: the measurement shows"));
}

TEST(GapPage, SaysWhenChanceAloneWouldMakeTheLargestDifference) {
  gap::Diagnosis d = fogDiagnosis();
  ASSERT_FALSE(d.where.empty());
  d.where.front().p_value = 1e-9;
  EXPECT_THAT(gap::reportHtml(d), Not(HasSubstr("It may be chance.")));
  d.where.front().p_value = 0.5;
  EXPECT_THAT(gap::reportHtml(d), HasSubstr("It may be chance."));
}

TEST(GapPage, ListsAcceptanceTestsWhoseVerdictChanges) {
  gap::Diagnosis d = fogDiagnosis();
  d.acceptance_tests = {{{"AT-1", "EchoPulseWidth_Fog", "epw", "failed", "passed", "0.41 m", "0.02 m"},
                         {"AT-2", "RangeIsRight", "range", "passed", "passed", "", ""}}};
  const std::string page = gap::reportHtml(d);
  EXPECT_THAT(page, HasSubstr("1 of 2 acceptance tests of the project"));
  EXPECT_THAT(page, HasSubstr("AT-1 EchoPulseWidth_Fog"));
  EXPECT_EQ(page.find("RangeIsRight"), std::string::npos);
}

}  // namespace
