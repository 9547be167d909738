#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/effect_bench.h"
#include "tests/model/effects/shot_bench.h"

namespace model {
namespace {

using nlohmann::json;

/// Noise of the receiver with an effect on. [W]
double noiseWith(const std::string& effect, const json& parameters, const json& environment = json::object()) {
  lab::Case setup = lab::boardWith(10, effect, parameters);
  setup.sensor["receiver"]["noise_w"] = 2e-9;
  setup.sensor["receiver"]["field_of_view_rad"] = {{"horizontal", 0.01}, {"vertical", 0.02}};
  setup.environment = environment;
  const LidarModel model = lab::modelOf(setup);
  const Experiment experiment = lab::experimentOf(setup);
  return SignalChain(model.sensor(""), model.effects, situationOf(experiment, experiment.samples[0]).environment)
      .settings()
      .receiver.noise_w;
}

TEST(CoverContamination, SectorLosesPowerAtBothPassages) {
  lab::Case setup =
      lab::boardWith(20, "cover-contamination", {{"attenuation", 0.3}, {"azimuth_from_deg", 3}, {"azimuth_to_deg", 8}});
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 10}, {"to", 0}, {"step", 5}};
  lab::Case clean = setup;
  clean.effects = json::object();
  const auto dirty = lab::fire(setup).intensity, clear = lab::fire(clean).intensity;
  EXPECT_NEAR(dirty.at(0) / clear.at(0), 1.0, 1e-12);
  EXPECT_NEAR(dirty.at(1) / clear.at(1), 0.49, 1e-6);
  EXPECT_NEAR(dirty.at(2) / clear.at(2), 1.0, 1e-12);
}

TEST(ThermalNoise, DarkCurrentDoublesEveryEightKelvin) {
  EXPECT_NEAR(noiseWith("thermal-noise", {{"temperature_degC", 20}}), 2e-9, 1e-18);
  EXPECT_NEAR(noiseWith("thermal-noise", {{"temperature_degC", 28}}), 2e-9 * std::sqrt(2.0), 1e-18);
  EXPECT_NEAR(noiseWith("thermal-noise", {{"temperature_degC", 36}, {"dark_share", 0.5}}),
              2e-9 * std::sqrt(0.5 + 0.5 * 4), 1e-18);
  EXPECT_NEAR(noiseWith("thermal-noise", json::object(), {{"temperature_degC", 4}}), 2e-9 / 2.0, 1e-18);
  EXPECT_NEAR(noiseWith("thermal-noise", json::object()), 2e-9, 1e-18);
}

// σ² = σ_0² + 2 E_ph P_b B, every quantity written out again.
TEST(BackgroundLight, ShotNoiseAddsInQuadrature) {
  const double photon_J = 6.62607015e-34 * 299792458.0 / 905e-9;
  const double power_w = 0.8 * 20 * 0.3 / std::numbers::pi * std::numbers::pi / 4 * 0.02 * 0.02 * 0.01 * 0.02 * 0.5;
  const double variance = 4e-18 + 2 * photon_J * power_w * 0.44 / 5e-9;
  EXPECT_NEAR(noiseWith("background-light", {{"irradiance_w_m2_nm", 0.8}}) / std::sqrt(variance), 1.0, 1e-6);
  EXPECT_NEAR(
      noiseWith("background-light", json::object(), {{"background_irradiance_w_m2_nm", 0.8}}) / std::sqrt(variance),
      1.0, 1e-6);
  EXPECT_NEAR(noiseWith("background-light", json::object()), 2e-9, 1e-18);
}

TEST(PhotoResponseNonuniformity, GainIsAFixedPatternOverLayers) {
  const auto gains = [](double pattern) {
    lab::Case setup = lab::boardWith(20, "photo-response-nonuniformity", {{"stddev", 0.1}, {"pattern", pattern}});
    const json layer = setup.sensor["scan"]["layers"][0];
    setup.sensor["scan"]["layers"] = json::array();
    for (int i = 0; i < 200; ++i) setup.sensor["scan"]["layers"].push_back(layer);
    setup.frames = 2;
    std::vector<double> list;
    for (const double intensity : lab::fire(setup).intensity)
      list.push_back(intensity / (1e9 * lab::radarEquation(20)));
    return list;
  };
  const auto first = gains(1);
  ASSERT_EQ(first.size(), 400u);
  for (std::size_t i = 0; i < 200; ++i) EXPECT_EQ(first[i], first[i + 200]);  // the same in every frame
  EXPECT_NEAR(lab::mean(first), 1.0, 4 * 0.1 / std::sqrt(200.0));
  EXPECT_NEAR(lab::deviation(first) / 0.1, 1.0, 4 / std::sqrt(400.0));
  EXPECT_NE(gains(2), first);
}

TEST(PhotoResponseNonuniformity, MeasuredGainsReplaceThePattern) {
  lab::Case setup = lab::boardWith(20, "photo-response-nonuniformity", {{"gain_per_layer", {0.5, 2.0}}});
  const json layer = setup.sensor["scan"]["layers"][0];
  setup.sensor["scan"]["layers"] = {layer, layer, layer};
  const auto intensity = lab::fire(setup).intensity;
  ASSERT_EQ(intensity.size(), 3u);
  for (const auto& [i, gain] : {std::pair{0, 0.5}, {1, 2.0}, {2, 0.5}}) {
    EXPECT_NEAR(1e-9 * intensity[static_cast<std::size_t>(i)] / lab::radarEquation(20), gain, 1e-6);
  }
}

// The overdrive ln(P/P_sat) decays with τ: the fall comes so much later.
TEST(Saturation, SlowRecoveryWidensTheEcho) {
  const json parameters = {{"saturation_w", 1e-7}, {"recovery_ns", 4.0}};
  const auto open = lab::fire(lab::boardWith(5));
  const double later_m = 0.299792458 * 4 * std::log(lab::radarEquation(5) / 1e-7);
  lab::Case setup = lab::boardWith(5, "saturation", parameters);
  EXPECT_NEAR(lab::fire(setup).epw_m.at(0), open.epw_m.at(0) + later_m, 1e-5);
  EXPECT_EQ(lab::fire(setup).range_m, open.range_m);  // at the peak
  setup.sensor["detection"]["range_mode"] = "centre";
  EXPECT_NEAR(lab::fire(setup).range_m.at(0), 5 + later_m / 4, 1e-5);
}

TEST(Saturation, CapsTheIntensityAndLeavesTheCrossings) {
  const auto clipped = lab::fire(lab::boardWith(5, "saturation", {{"saturation_w", 1e-7}}));
  const auto open = lab::fire(lab::boardWith(5));
  EXPECT_NEAR(clipped.intensity.at(0), 100.0, 1e-9);
  EXPECT_EQ(clipped.epw_m, open.epw_m);
  EXPECT_EQ(clipped.range_m, open.range_m);
  EXPECT_GT(open.intensity.at(0), 100.0);
}

// P (1 + (P/P_sat)^n)^(-1/n), below the saturation as well as above it. The Gaussian pulse is cut where it is bent to
// the threshold: EPW = c · FWHM · √log2(P/P_th') (formats.md section 3) with the P_th' that the knee bends to P_th.
TEST(Saturation, ASoftKneeBendsBeforeItClips) {
  const double power_w = lab::radarEquation(5);
  for (const double most_w : {2.0 * power_w, power_w, power_w / 20.0, 1.2 * lab::kThreshold_w}) {
    const auto bent = lab::fire(lab::boardWith(5, "saturation", {{"saturation_w", most_w}, {"knee_sharpness", 3.0}}));
    const auto bend = [&](double w) { return w / std::cbrt(1.0 + std::pow(w / most_w, 3.0)); };
    EXPECT_NEAR(1e-9 * bent.intensity.at(0), bend(power_w), 1e-6 * power_w);
    double low_w = lab::kThreshold_w, high_w = power_w;  // halved until the knee bends their middle to the threshold
    for (int i = 0; i < 60; ++i)
      (bend(0.5 * (low_w + high_w)) < lab::kThreshold_w ? low_w : high_w) = 0.5 * (low_w + high_w);
    EXPECT_NEAR(bent.epw_m.at(0), lab::epwLaw(power_w, low_w), 1e-6) << most_w;
  }
}

// What clips is s(t), and n comes to it (formats.md section 3, steps 4 and 5): capped echoes still scatter.
TEST(Saturation, NoiseComesBehindTheCap) {
  constexpr double kNoise_nw = 5.0;
  constexpr int kShots = 2000;
  lab::Case setup = lab::boardWith(5, "saturation", {{"saturation_w", 1e-7}});
  setup.sensor["receiver"]["noise_w"] = 1e-9 * kNoise_nw;
  setup.frames = kShots;
  const auto capped = lab::fire(setup).intensity;
  ASSERT_EQ(capped.size(), static_cast<std::size_t>(kShots));
  EXPECT_NEAR(lab::mean(capped), 100.0, 4 * kNoise_nw / std::sqrt(kShots));
  EXPECT_NEAR(lab::deviation(capped) / kNoise_nw, 1.0, 4 / std::sqrt(2.0 * kShots));
}

// A bent pulse crosses the threshold less steeply: the received power at which it does is that which the knee bends to
// P_th - n.
TEST(Saturation, NoiseMovesTheEdgesOfABentPulseFurther) {
  const double power_w = lab::radarEquation(5), most_w = 1.2 * lab::kThreshold_w;
  lab::Case setup = lab::boardWith(5, "saturation", {{"saturation_w", most_w}, {"knee_sharpness", 3.0}});
  setup.sensor["receiver"]["noise_w"] = 0.05 * lab::kThreshold_w;
  const lab::ShotBench bench(setup);
  for (int frame = 0; frame < 20; ++frame) {
    const ShotRecord shot = bench.shot(frame);
    ASSERT_EQ(shot.echoes.size(), 1u);
    const double output_w = lab::kThreshold_w - shot.noise_w.at(0);
    const double received_w = output_w / std::cbrt(1.0 - std::pow(output_w / most_w, 3.0));
    EXPECT_NEAR(shot.echoes.at(0).epw_m, lab::epwLaw(power_w, received_w), 1e-6) << frame;
  }
}

// The profile's own limit counts only with the effect on (formats.md section 3, step 4).
TEST(Saturation, OfTheProfileCountsWithTheEffectOnly) {
  lab::Case setup = lab::boardWith(5);
  setup.sensor["receiver"]["saturation_w"] = 1e-7;
  EXPECT_GT(lab::fire(setup).intensity.at(0), 100.0);
  setup.effects["saturation"] = json::object();
  EXPECT_NEAR(lab::fire(setup).intensity.at(0), 100.0, 1e-9);
}

// Echoes at 10, 14 and 18 m: blind for c/2 · τ behind each that is seen, and only behind those (non-paralysable).
TEST(DeadTime, HidesWhatComesTooSoonAfterASeenEcho) {
  lab::Case setup;
  setup.rays_per_beam = {3, 1};
  const json piece = {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}};
  setup.scene = {lab::object("a", piece, {10, 1.005, 0}), lab::object("b", piece, {14, 0.993, 0}), lab::board(18)};
  const auto rangesWith = [&](double blind_m) {
    setup.effects = {{"beam-divergence", json::object()}};
    if (blind_m > 0) setup.effects["dead-time"] = {{"dead_time_ns", 2 * blind_m / 0.299792458}};
    std::vector<int> metres;
    for (const double range : lab::fire(setup).range_m) metres.push_back(static_cast<int>(std::lround(range)));
    return metres;
  };
  EXPECT_EQ(rangesWith(0), (std::vector<int>{10, 14, 18}));
  EXPECT_EQ(rangesWith(3.9), (std::vector<int>{10, 14, 18}));
  EXPECT_EQ(rangesWith(4.1), (std::vector<int>{10, 18}));
  EXPECT_EQ(rangesWith(8.1), (std::vector<int>{10}));
}

}  // namespace
}  // namespace model
