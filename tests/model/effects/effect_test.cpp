#include "model/effects/effect.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "core/file.h"
#include "tests/model/effects/effect_bench.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace model {
namespace {

using nlohmann::json;

TEST(Effects, DeclareThemselvesCompletely) {
  std::set<std::string> names;
  Stage stage = Stage::kEmission;
  for (const EffectEntry& entry : allEffects()) {
    const EffectInfo& info = entry.info;
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_GE(info.stage, stage) << info.name << ": the list follows the chain";
    stage = info.stage;
    EXPECT_FALSE(info.title.empty()) << info.name;
    EXPECT_TRUE(info.summary.ends_with('.')) << info.name << ": a sentence for a reader who never heard of it";
    EXPECT_FALSE(info.source.empty()) << info.name;
    std::set<std::string> known;
    for (const ParameterInfo& parameter : info.parameters) {
      known.insert(parameter.name);
      EXPECT_LT(parameter.min, parameter.max) << info.name << " " << parameter.name;
      EXPECT_TRUE(parameter.typical >= parameter.min && parameter.typical <= parameter.max)
          << info.name << " " << parameter.name;
      if (parameter.default_value) {
        EXPECT_TRUE(*parameter.default_value >= parameter.min && *parameter.default_value <= parameter.max)
            << parameter.name;
      }
      EXPECT_FALSE(parameter.meaning.empty());
      EXPECT_FALSE(parameter.meaning.starts_with("Of ")) << parameter.meaning << ": a page says it before the number";
    }
    for (const std::string& fitted : info.fitted) EXPECT_TRUE(known.count(fitted)) << info.name << " fits " << fitted;
    for (const FittedForm& form : info.other_forms) {
      EXPECT_FALSE(form.name.empty()) << info.name;
      for (const std::string& fitted : form.parameters) EXPECT_TRUE(known.count(fitted)) << info.name << " " << fitted;
    }
    EXPECT_EQ(findEffect(info.name), &entry);
  }
  EXPECT_EQ(findEffect("no-such-effect"), nullptr);
}

/// Noise everywhere and two surfaces in some beams, so that every random stream is used.
lab::Case noisyCase() {
  lab::Case setup;
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 4}, {"to", -4}, {"step", 0.5}};
  setup.sensor["receiver"]["noise_w"] = 4e-9;
  setup.sensor["detection"]["range_noise_m"] = 0.01;
  setup.sensor["detection"]["epw_noise_m"] = 0.03;
  setup.rays_per_beam = {3, 3};
  setup.effects["beam-divergence"] = json::object();
  setup.scene = {lab::board(30, 60),
                 lab::object("post", {{"type", "cylinder"}, {"radius_m", 0.2}, {"height_m", 4}}, {12, 0.2, 0})};
  setup.frames = 20;
  return setup;
}

bool same(const core::Detections& a, const core::Detections& b) {
  return a.frame == b.frame && a.range_m == b.range_m && a.epw_m == b.epw_m && a.intensity == b.intensity;
}

// An effect whose strength is nothing is as good as off, to the last bit: it takes no random number from anybody else.
TEST(Effects, WithoutStrengthChangeNoByte) {
  const core::Detections off = lab::fire(noisyCase());
  const std::pair<const char*, json> neutral[] = {{"aperture-offset", {{"offset_m", 0}}},
                                                  {"stray-radiation", {{"fraction", 0}}},
                                                  {"mounting-error", {{"yaw_deg", 0}, {"position_m", {0, 0, 0}}}},
                                                  {"pulse-jitter", {{"power_stddev", 0}}},
                                                  {"atmospheric-attenuation", json::object()},
                                                  {"atmospheric-backscatter", json::object()},
                                                  {"precipitation-clutter", json::object()},
                                                  {"road-spray", json::object()},
                                                  {"exhaust-cloud", {{"centre", {10, 50, 0}}}},
                                                  {"crosstalk", {{"rate_1_s", 0}}},
                                                  {"spoofing", {{"azimuth_deg", 180}}},
                                                  {"blinding", {{"azimuth_deg", 180}, {"irradiance", 100}}},
                                                  {"angular-reflection", json::object()},
                                                  {"surface-moisture", {{"wetness", 0}}},
                                                  {"retroreflection", json::object()},
                                                  {"transmission", json::object()},
                                                  {"multipath", json::object()},
                                                  {"motion-scan", json::object()},
                                                  {"cover-contamination", {{"attenuation", 0}}},
                                                  {"photo-response-nonuniformity", {{"stddev", 0}}},
                                                  {"background-light", json::object()},
                                                  {"thermal-noise", json::object()},
                                                  {"saturation", json::object()},
                                                  {"blooming", {{"fraction", 0}}},
                                                  {"dead-time", {{"dead_time_ns", 1}}},
                                                  {"dynamic-threshold", {{"factor", 5}}},
                                                  {"quantisation", json::object()},
                                                  {"range-gating", json::object()},
                                                  {"echo-merging", json::object()},
                                                  {"latency", {{"delay_s", 0}}},
                                                  {"clock-drift", json::object()},
                                                  {"range-offset", json::object()},
                                                  {"angle-clipping", json::object()},
                                                  {"false-alarm", json::object()},
                                                  {"detection-loss", json::object()}};
  for (const auto& [name, parameters] : neutral) {
    lab::Case setup = noisyCase();
    setup.effects[name] = parameters;
    EXPECT_TRUE(same(lab::fire(setup), off)) << name;
  }
}

// What one effect draws leaves the noise of everything else as it was: losses only remove lines.
TEST(Effects, DrawFromStreamsOfTheirOwn) {
  const core::Detections off = lab::fire(noisyCase());
  lab::Case setup = noisyCase();
  setup.effects["detection-loss"] = {{"probability", 0.3}};
  const core::Detections lossy = lab::fire(setup);
  const std::set<double> before(off.range_m.begin(), off.range_m.end());
  for (const double range : lossy.range_m) EXPECT_EQ(before.count(range), 1u);
  EXPECT_LT(lossy.size(), off.size());
}

TEST(Effects, AreListedByTheProgramAsTheyDeclareThemselves) {
  const auto run = test_support::runFidelis({"effects", "--json", "-"});
  ASSERT_EQ(run.status, 0) << run.messages;
  const json listed = json::parse(run.out);
  ASSERT_EQ(listed["effects"].size(), allEffects().size());
  for (std::size_t i = 0; i < allEffects().size(); ++i) {
    const EffectInfo& info = allEffects()[i].info;
    EXPECT_EQ(listed["effects"][i]["name"], info.name);
    EXPECT_EQ(listed["effects"][i]["percollect"], json(info.percollect));
    for (const ListInfo& list : allEffects()[i].lists) {
      EXPECT_NE(listed["effects"][i]["parameters"].dump().find('"' + list.name + '"'), std::string::npos) << list.name;
    }
    for (std::size_t p = 0; p < info.parameters.size(); ++p) {
      EXPECT_EQ(listed["effects"][i]["parameters"][p]["name"], info.parameters[p].name);
      EXPECT_EQ(listed["effects"][i]["parameters"][p]["max"], info.parameters[p].max);
    }
  }
  const auto one = test_support::runFidelis({"effects", "saturation"});
  EXPECT_NE(one.out.find("saturation_w"), std::string::npos);
  EXPECT_NE(one.out.find("graph nodes 142"), std::string::npos);
  const auto wrong = test_support::runFidelis({"effects", "sauration"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.messages.find("Did you mean 'saturation'?"), std::string::npos);
}

TEST(Sensors, AreListedByTheProgram) {
  const auto run = test_support::runFidelis({"sensors", "--json", "-"});
  ASSERT_EQ(run.status, 0) << run.messages;
  EXPECT_NE(run.out.find("\"ibeo-lux-2010\""), std::string::npos);
  EXPECT_NE(run.out.find("\"beams_per_frame\": 790"), std::string::npos);
}

// scripts/effect-pages writes them there.
TEST(Effects, HaveASectionEachInTheDocs) {
  const std::string page = core::readFile(test_support::sourceFolder() / "docs/effects.md");
  for (const EffectEntry& entry : allEffects()) {
    const std::size_t begin = page.find("## " + entry.info.name + "\n");
    ASSERT_NE(begin, std::string::npos) << entry.info.name;
    const std::string section = page.substr(begin, page.find("\n## ", begin) - begin);
    EXPECT_NE(section.find(entry.info.title), std::string::npos) << entry.info.name;
    EXPECT_NE(section.find(entry.info.summary), std::string::npos) << entry.info.name;
    EXPECT_NE(section.find(entry.info.source), std::string::npos) << entry.info.name;
    for (const ParameterInfo& parameter : entry.info.parameters) {
      EXPECT_NE(section.find("| `" + parameter.name + "` |"), std::string::npos) << parameter.name;
      EXPECT_NE(section.find(parameter.meaning), std::string::npos) << parameter.name;
    }
    for (const ListInfo& list : entry.lists)
      EXPECT_NE(section.find("`" + list.name + "`"), std::string::npos) << list.name;
  }
}

}  // namespace
}  // namespace model
