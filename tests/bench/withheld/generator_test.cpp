#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include "bench/withheld/generator/reflection.h"
#include "tests/bench/withheld/small_world.h"

// Closed forms of the second generator. The board stands square to the sensor; with one ray a beam (no
// beam-divergence) a beam of azimuth a and elevation e meets it at d / (cos a cos e) with that cosine of incidence.
namespace {

using nlohmann::json;
using namespace small_world;

constexpr double kLight_m_ns = 0.299792458, kThreshold_w = 2.5e-8, kFwhm_ns = 4.0, kBoard_m = 20.0;

struct Ideal {
  double range_m, power_w;
};

Ideal idealOf(const Table& table, std::size_t i) {
  const double cosine = std::cos(table.at("azimuth_rad")[i]) * std::cos(table.at("elevation_rad")[i]);
  const double range = kBoard_m / cosine;
  return {range, boardPower_w(range) * cosine};
}

TEST(WithheldGenerator, FlatBoardObeysTheRadarEquationAndThePulse) {
  const Table table = generated(experiment({kBoard_m}), model(json::object()));
  ASSERT_EQ(table.at("range_m").size(), 84U);
  for (std::size_t i = 0; i < 84; ++i) {
    const Ideal ideal = idealOf(table, i);
    EXPECT_NEAR(table.at("range_m")[i], ideal.range_m, 1e-4);
    EXPECT_NEAR(table.at("intensity")[i], ideal.power_w * 1e9, 1e-4 * ideal.power_w * 1e9);
    EXPECT_NEAR(table.at("epw_m")[i], kLight_m_ns * kFwhm_ns * std::sqrt(std::log2(ideal.power_w / kThreshold_w)),
                1e-4);
  }
}

// A footprint on one even board counts at its mean range: no other width than that of one ray.
TEST(WithheldGenerator, WideBeamOnAFlatBoardSeesWhatOneRaySees) {
  const Table one = generated(experiment({kBoard_m}), model(json::object()));
  const Table wide = generated(experiment({kBoard_m}), model({{"beam-divergence", json::object()}}));
  ASSERT_EQ(wide.at("range_m").size(), one.at("range_m").size());
  for (std::size_t i = 0; i < one.at("range_m").size(); ++i) {
    EXPECT_NEAR(wide.at("range_m")[i], one.at("range_m")[i], 3e-3);
    EXPECT_NEAR(wide.at("intensity")[i], one.at("intensity")[i], 2e-3 * one.at("intensity")[i]);
  }
}

TEST(WithheldGenerator, ExtinctionWeakensByBeerAndLambertOutAndBack) {
  const Table clear = generated(experiment({kBoard_m}), model(json::object()));
  const Table thick =
      generated(experiment({kBoard_m}), model({{"atmospheric-attenuation", {{"extinction_1_m", 0.01}}}}));
  ASSERT_EQ(thick.at("range_m").size(), clear.at("range_m").size());
  for (std::size_t i = 0; i < clear.at("range_m").size(); ++i) {
    const double expected = std::exp(-0.02 * idealOf(clear, i).range_m);
    EXPECT_NEAR(thick.at("intensity")[i] / clear.at("intensity")[i], expected, 1e-5);
  }
}

// Kim 2001: below 500 m of visibility the wavelength does not matter; at 10 km it enters with the power 1.3.
TEST(WithheldGenerator, FogFollowsKim) {
  EXPECT_NEAR(withheld::fogExtinction(200, 905), 3.912 / 200, 1e-12);
  EXPECT_NEAR(withheld::fogExtinction(10'000, 905), 3.912e-4 * std::pow(905.0 / 550, -1.3), 1e-12);
}

// Published for Marshall–Palmer rain: 1.58 dB/km R^0.63 (ITU-R P.1814, table of rain coefficients).
TEST(WithheldGenerator, RainFollowsThePublishedPowerLaw) {
  for (const double rate : {1.0, 10.0, 50.0}) {
    const double db_per_km = withheld::rainExtinction(rate) * 1e4 / std::numbers::ln10;
    EXPECT_NEAR(db_per_km, 1.58 * std::pow(rate, 0.63), 0.01 * 1.58 * std::pow(rate, 0.63)) << rate;
  }
}

TEST(WithheldGenerator, DriftDividesByTheClockAndOffsetAdds) {
  const Table plain = generated(experiment({kBoard_m}), model(json::object()));
  const json effects = {{"clock-drift", {{"scale_ppm", 1000}}}, {"range-offset", {{"offset_m", 0.05}}}};
  const Table drifted = generated(experiment({kBoard_m}), model(effects));
  for (std::size_t i = 0; i < plain.at("range_m").size(); ++i) {
    EXPECT_NEAR(drifted.at("range_m")[i], plain.at("range_m")[i] / (1 - 1e-3) + 0.05, 2e-6);
  }
}

// Bernoulli: 84 beams × 100 frames, p = 0.2; five standard deviations.
TEST(WithheldGenerator, LossesHaveTheirProbability) {
  const Table table = generated(experiment({kBoard_m}, 100), model({{"detection-loss", {{"probability", 0.2}}}}));
  EXPECT_NEAR(static_cast<double>(table.at("range_m").size()) / 8400, 0.8, 5 * std::sqrt(0.2 * 0.8 / 8400));
}

// Poisson of 0.05 a shot beside a board that is always seen; five standard deviations.
TEST(WithheldGenerator, FalseAlarmsHaveTheirRate) {
  const Table table = generated(experiment({kBoard_m}, 100), model({{"false-alarm", {{"rate_per_beam", 0.05}}}}));
  // 0.6 m to either side of the board they merge with it
  const double expected = 8400 * 0.05 * (1 - 1.2 / 149.5);
  EXPECT_NEAR(static_cast<double>(table.at("range_m").size()) - 8400, expected, 5 * std::sqrt(expected));
}

// The range of a leading edge that is calibrated at an SNR is right there, and late by the rest of the front elsewhere.
TEST(WithheldGenerator, RangeWalkIsTheFrontOfTheGaussian) {
  const Table walked = generated(experiment({kBoard_m}), model({{"range-walk", {{"calibrated_at_snr", 100}}}}));
  for (std::size_t i = 0; i < walked.at("range_m").size(); ++i) {
    const Ideal ideal = idealOf(walked, i);
    const double front_m = 0.25 * kLight_m_ns * kFwhm_ns;
    const double late = front_m * (std::sqrt(std::log2(100.0)) - std::sqrt(std::log2(ideal.power_w / kThreshold_w)));
    EXPECT_NEAR(walked.at("range_m")[i], ideal.range_m + late, 1e-4);
  }
}

// Speckle of M looks: relative variance 1/M (Goodman 2007, sec. 4.4). 8400 echoes: the variance is known to 5
// sqrt(2/n).
TEST(WithheldGenerator, SpeckleHasTheVarianceOfItsLooks) {
  const Table table = generated(experiment({kBoard_m}, 100), model({{"speckle", {{"looks", 50}}}}));
  double sum = 0, squares = 0;
  const std::size_t n = table.at("intensity").size();
  for (std::size_t i = 0; i < n; ++i) {
    const double relative = table.at("intensity")[i] * 1e-9 / idealOf(table, i).power_w;
    sum += relative, squares += relative * relative;
  }
  const double mean = sum / static_cast<double>(n), variance = squares / static_cast<double>(n) - mean * mean;
  EXPECT_NEAR(mean, 1.0, 5 * std::sqrt(0.02 / 8400));
  EXPECT_NEAR(variance, 0.02, 0.02 * 5 * std::sqrt(2.3 / 8400));
}

TEST(WithheldGenerator, PulseThatIsNotEvenKeepsItsWidthAtHalfMaximum) {
  const withheld::Pulse pulse{4.0, 0.4};
  EXPECT_DOUBLE_EQ(pulse.widthAt(2.0), 4.0);
  EXPECT_DOUBLE_EQ(pulse.riseFrom(2.0), 1.6);
  json world = model(json::object());
  world["x-pulse"] = "measured-like";
  const Table table = generated(experiment({kBoard_m}), world);
  for (std::size_t i = 0; i < table.at("epw_m").size(); ++i) {
    const Ideal ideal = idealOf(table, i);
    EXPECT_NEAR(table.at("epw_m")[i], kLight_m_ns * kFwhm_ns * std::sqrt(std::log2(ideal.power_w / kThreshold_w)),
                1e-3);
  }
}

// Half of the beam on a near board, half on one 5 m behind it: two echoes at both ranges.
TEST(WithheldGenerator, BeamOnAnEdgeBringsTwoEchoes) {
  json package = experiment({kBoard_m});
  json half = package["scene"][0];
  half["id"] = "half";
  half["shape"]["width_m"] = 10;
  half["pose"]["position_m"] = {15, 5, 0};
  package["scene"].push_back(half);
  const Table table = generated(package, model({{"beam-divergence", json::object()}}));
  int on_edge = 0;
  for (std::size_t i = 0; i < table.at("echo").size(); ++i) {
    if (std::abs(table.at("azimuth_rad")[i]) > 1e-6) continue;
    ++on_edge;
    const double expected = (table.at("echo")[i] < 1.5 ? 15 : 20) / std::cos(table.at("elevation_rad")[i]);
    EXPECT_NEAR(table.at("range_m")[i], expected, 2e-3);
    EXPECT_NEAR(table.at("intensity")[i] * 1e-9, 0.5 * boardPower_w(expected) * std::cos(table.at("elevation_rad")[i]),
                0.01 * boardPower_w(expected));
  }
  EXPECT_EQ(on_edge, 8);
}

TEST(WithheldGenerator, TruthMovesTheSceneOnly) {
  const json truth = {
      {"reference_offsets",
       {{"/scene/0/pose/position_m/0", {{"everywhere", 0.1}, {"per_setup", {{"s0", 0.2}, {"s1", 9.0}}}}}}}};
  const Table recorded = generated(experiment({kBoard_m}), model(json::object()));
  const Table moved = generated(experiment({kBoard_m}), model(json::object()), truth);
  for (std::size_t i = 0; i < recorded.at("range_m").size(); ++i) {
    EXPECT_NEAR(moved.at("range_m")[i], recorded.at("range_m")[i] * (kBoard_m + 0.3) / kBoard_m, 1e-4);
  }
}

// The glossy lobe over the half vector has the peak of the mirror's: (n+2)/2π, n the exponent of cos^n 2θ.
TEST(WithheldGenerator, GlossyLobeHasThePublishedPeak) {
  const withheld::Effects effects({{"angular-reflection", json::object()}}, "");
  withheld::Material gloss{
      .reflectivity = 0.4, .law = withheld::Material::Law::phong, .diffuse_fraction = 0.0, .exponent = 10};
  EXPECT_NEAR(withheld::Surfaces(effects).backward(gloss, 1.0), 0.4 * 12 / (2 * std::numbers::pi), 1e-12);
}

// Ångström: a surface that absorbs nothing stays white when wet, and a black one black.
TEST(WithheldGenerator, WetWhiteStaysWhiteAndWetGreyIsDarker) {
  const withheld::Effects effects({{"surface-moisture", {{"wetness", 1.0}}}}, "");
  const auto diffuse = [&](double reflectivity) {
    withheld::Material material{.reflectivity = reflectivity};
    return withheld::Surfaces(effects).backward(material, 0.5) * std::numbers::pi;
  };
  EXPECT_NEAR(diffuse(1.0), 1.0, 1e-6);
  EXPECT_NEAR(diffuse(0.0), 0.0, 1e-6);
  EXPECT_NEAR(diffuse(0.5), 1.0 / (1.0 + 1.33 * 1.33), 1e-6);
}

TEST(WithheldGenerator, CirclesOverlapAsTheyShould) {
  EXPECT_DOUBLE_EQ(withheld::circleOverlap(1, 2, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(withheld::circleOverlap(2, 1, 0.5), 0.25);
  EXPECT_DOUBLE_EQ(withheld::circleOverlap(1, 1, 2.5), 0.0);
  // two unit circles, centres one radius apart: 2π/3 − √3/2 of π
  EXPECT_NEAR(withheld::circleOverlap(1, 1, 1), (2 * std::numbers::pi / 3 - std::sqrt(3) / 2) / std::numbers::pi,
              1e-12);
}

}  // namespace
