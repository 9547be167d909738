#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "core/physics.h"
#include "model/sensor/beams.h"
#include "model/sensor/link_budget.h"
#include "model/sensor/plausibility.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

// The profiles against the public facts that they were built from: the profiles of openMSL sl-1-2 (beams, angles,
// times, powers; all check values are computed there, not here) and the makers' manuals named in each `source`.
namespace model {
namespace {

SensorProfile profileOf(const std::string& id) { return resolveSensorProfile(id, "m.json", "/sensor"); }
std::vector<Beam> beamsOfProfile(const std::string& id) { return beamsOf(profileOf(id).scan); }

std::vector<std::string> shippedIds() {
  std::vector<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(test_support::sourceFolder() / "resources/sensors"))
    ids.push_back(entry.path().stem().string());
  return ids;
}

/// The beam of a layer at an azimuth that is one of its columns.
const Beam& beamAt(const std::vector<Beam>& beams, std::int32_t layer, double azimuth_deg) {
  return *std::min_element(beams.begin(), beams.end(), [&](const Beam& a, const Beam& b) {
    const auto far = [&](const Beam& beam) {
      return (beam.layer == layer ? 0.0 : 1e3) + std::abs(beam.azimuth_rad * core::kDegPerRad - azimuth_deg);
    };
    return far(a) < far(b);
  });
}

double elevation_deg(const Beam& beam) { return beam.elevation_rad * core::kDegPerRad; }

TEST(ShippedProfiles, FireTheBeamsOfAFullScan) {
  const std::map<std::string, std::size_t> facts = {{"velodyne-vlp-16", 28'784},
                                                    {"velodyne-vlp-32c", 57'568},
                                                    {"valeo-scala-1", 3'486},
                                                    {"ibeo-lux-2010", 790},
                                                    {"blickfeld-cube", 11'520}};
  for (const auto& [id, count] : facts) EXPECT_EQ(beamsOfProfile(id).size(), count) << id;
  EXPECT_EQ(beamsOfProfile("flash-spad-array").size(), 96u * 32u);
  EXPECT_EQ(beamsOfProfile("bistatic-2d").size(), 1081u);
}

TEST(ShippedProfiles, HaveNeitherErrorsNorWarnings) {
  for (const std::string& id : shippedIds()) {
    for (const Finding& finding : plausibilityOf(profileOf(id))) {
      EXPECT_EQ(finding.severity, Severity::kNote) << id << " " << finding.pointer << " " << finding.problem;
    }
  }
}

TEST(ShippedProfiles, FireEveryBeamWithinItsFrame) {
  for (const std::string& id : shippedIds()) {
    const SensorProfile profile = profileOf(id);
    for (const Beam& beam : beamsOf(profile.scan)) {
      ASSERT_GE(beam.time_s, 0.0) << id;
      ASSERT_LT(beam.time_s, 1.0 / profile.scan.frame_rate_hz) << id;
    }
  }
}

TEST(Vlp16, LayersAndFiringOrderAreThoseOfTheManual) {
  const auto beams = beamsOfProfile("velodyne-vlp-16");
  const std::vector<double> as_fired = {-15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15};
  std::vector<const Beam*> column;
  for (const Beam& beam : beams) {
    if (beam.column == 100) column.push_back(&beam);
  }
  ASSERT_EQ(column.size(), 16u);
  EXPECT_TRUE(std::is_sorted(column.begin(), column.end(),
                             [](auto* a, auto* b) { return a->elevation_rad < b->elevation_rad; }));
  std::sort(column.begin(), column.end(), [](auto* a, auto* b) { return a->time_s < b->time_s; });
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_NEAR(elevation_deg(*column[i]), as_fired[i], 1e-9);
    EXPECT_NEAR(column[i]->time_s - column[0]->time_s, 2.304e-6 * static_cast<double>(i), 1e-12);
  }
}

TEST(Vlp16, TurnsClockwiseOnceAFrame) {
  const auto beams = beamsOfProfile("velodyne-vlp-16");
  const Beam& first = beamAt(beams, 0, 179.6);
  const Beam& last = beamAt(beams, 0, -180.0);
  EXPECT_NEAR(first.azimuth_rad * core::kDegPerRad, 179.6, 1e-9);
  EXPECT_LT(first.time_s, last.time_s);
  // The manual's 55.296 µs from column to column, to within the rounding of the facts' 0.2°.
  EXPECT_NEAR(last.time_s / 1798.0, 55.296e-6, 0.5e-6);
}

TEST(Vlp32c, HasTheLayersOfTheManualInPairs) {
  const auto beams = beamsOfProfile("velodyne-vlp-32c");
  const std::vector<double> layers = {-25,    -15.639, -11.310, -8.843, -7.254, -6.148, -5.333, -4.667,
                                      -4.000, -3.667,  -3.333,  -3.000, -2.667, -2.333, -2.000, -1.667,
                                      -1.333, -1.000,  -0.667,  -0.333, 0,      0.333,  0.667,  1.000,
                                      1.333,  1.667,   2.333,   3.333,  4.667,  7.000,  10.333, 15.000};
  std::map<double, int> at_time;
  for (std::int32_t l = 0; l < 32; ++l) {
    const Beam& beam = beamAt(beams, l, 0.0);
    EXPECT_NEAR(elevation_deg(beam), layers[static_cast<std::size_t>(l)], 1e-9);
    ++at_time[beam.time_s];
  }
  EXPECT_EQ(at_time.size(), 16u);
  for (const auto& [time, count] : at_time) EXPECT_EQ(count, 2) << time;
  EXPECT_EQ(beamAt(beams, 0, 0).time_s, beamAt(beams, 17, 0).time_s);  // lasers 0 (-25°) and 1 (-1°)
}

// Check values of the polynomial, to the digits that are given, both mirror sides.
TEST(Scala1, LayersAreCurvedAsThePolynomialSays) {
  const auto beams = beamsOfProfile("valeo-scala-1");
  const std::map<double, std::vector<double>> facts = {{-72.5, {-1.3935, -0.5935, 0.2065, 0.5935, 1.3935, 2.1935}},
                                                       {-30, {-1.3198, -0.5198, 0.2802, 0.5198, 1.3198, 2.1198}},
                                                       {0, {-1.2240, -0.4240, 0.3760, 0.4240, 1.2240, 2.0240}},
                                                       {30, {-1.1003, -0.3003, 0.4997, 0.3003, 1.1003, 1.9003}},
                                                       {72.5, {-0.8916, -0.0916, 0.7084, 0.0916, 0.8916, 1.6916}}};
  for (const auto& [azimuth, elevations] : facts) {
    for (std::int32_t l = 0; l < 6; ++l)
      EXPECT_NEAR(elevation_deg(beamAt(beams, l, azimuth)), elevations[static_cast<std::size_t>(l)], 0.5001e-4)
          << azimuth << " " << l;
  }
}

TEST(Scala1, SecondMirrorSideFollowsAfterFortyMilliseconds) {
  const auto beams = beamsOfProfile("valeo-scala-1");
  for (std::int32_t l = 0; l < 3; ++l)
    EXPECT_NEAR(beamAt(beams, l + 3, 20).time_s - beamAt(beams, l, 20).time_s, 0.040, 1e-12);
}

TEST(Scala1, GainIsThatOfTheFacts) {
  const auto beams = beamsOfProfile("valeo-scala-1");
  for (const auto& [azimuth, percent] :
       std::map<double, double>{{-72.5, 25}, {-60, 32.5}, {-55, 43.75}, {0, 100}, {40, 72.5}, {70, 25}, {72.5, 12.5}})
    EXPECT_NEAR(beamAt(beams, 4, azimuth).gain, percent / 100, 1e-12) << azimuth;
}

TEST(IbeoLux, GainIsThatOfTheFacts) {
  const Scan scan = profileOf("ibeo-lux-2010").scan;
  const std::map<double, std::vector<double>> facts = {
      {52, {0, 0, 0, 0}},           {50, {17.8, 19.0, 0, 0}},       {46, {51.6, 54.2, 0, 0}},
      {38, {65.0, 68.4, 0, 0}},     {36, {66.2, 70.0, 10.0, 11.4}}, {25, {83.6, 87.6, 86.6, 85.0}},
      {10, {97.0, 100, 100, 99.0}}, {-20, {100, 100, 100, 100}},    {-40, {93.2, 97.4, 97.6, 95.2}},
      {-50, {35.0, 36.0, 80, 79}},  {-52, {0, 0, 75.2, 74.4}},      {-60, {0, 0, 44.2, 41.6}}};
  for (const auto& [azimuth, percent] : facts) {
    for (std::int32_t l = 0; l < 4; ++l)
      EXPECT_NEAR(gainOf(scan, l, azimuth * core::kRadPerDeg), percent[static_cast<std::size_t>(l)] / 100, 1e-9)
          << azimuth << " " << l;
  }
}

// Extremes of elevation in the swings 0, 15 and 31 as the facts give them, to their digits.
TEST(Blickfeld, ElevationGrowsFromSwingToSwing) {
  const auto beams = beamsOfProfile("blickfeld-cube");
  for (const auto& [swing, low, high] :
       {std::tuple{0, -0.24, 0.09}, std::tuple{15, -4.92, 4.77}, std::tuple{31, -9.92, 9.77}}) {
    double least = 0.0, most = 0.0;
    for (const Beam& beam : beams) {
      if (beam.layer / 2 != swing) continue;
      least = std::min(least, elevation_deg(beam));
      most = std::max(most, elevation_deg(beam));
    }
    EXPECT_NEAR(least, low, 0.005) << swing;
    EXPECT_NEAR(most, high, 0.005) << swing;
  }
}

// 181 beams on the way right and 179 back in each of 32 swings.
TEST(Blickfeld, WaysOfTheMirrorHaveTheBeamsOfTheFacts) {
  std::map<std::int32_t, int> count;
  for (const Beam& beam : beamsOfProfile("blickfeld-cube")) ++count[beam.layer];
  ASSERT_EQ(count.size(), 64u);
  for (const auto& [layer, beams] : count) EXPECT_EQ(beams, layer % 2 == 0 ? 181 : 179);
}

// The published widths of a 50 % diffuse target, c · 4.5 ns + 0.03 m + 0.65, 0.61 and 0.45 m.
TEST(Scala1, HasThePublishedEchoPulseWidths) {
  for (const auto& [range_m, epw_m] : {std::pair{10.0, 2.029}, {15.0, 1.989}, {20.0, 1.829}}) {
    lab::Case setup;
    setup.sensor = sensorProfileJson("valeo-scala-1", "m.json", "/sensor");
    setup.sensor["scan"]["layers"] = {{{"elevation_deg", 0}, {"azimuth_deg", {{"from", 0}, {"to", 0}, {"step", 1}}}}};
    setup.scene = {lab::board(range_m)};
    setup.frames = 400;
    EXPECT_NEAR(lab::mean(lab::fire(setup).epw_m), epw_m, 0.1) << range_m;
  }
}

// What their sources promise: half of the echoes of a 50 % target are left at max_range_m.
TEST(ShippedProfiles, WithAChosenThresholdSeeHalfGreyUpToTheirWindow) {
  for (const char* id : {"velodyne-vlp-16", "valeo-scala-1", "blickfeld-cube"}) {
    const SensorProfile profile = profileOf(id);
    const double range_m = rangeOfPower_m(profile, {.reflectivity = 0.5}, profile.receiver.threshold_w);
    EXPECT_NEAR(range_m, profile.detection.max_range_m, 0.01 * profile.detection.max_range_m) << id;
  }
}

TEST(ShippedProfiles, PowersAreThoseOfTheFactsInDecibelMilliwatt) {
  for (const auto& [id, dbm] : std::map<std::string, double>{{"velodyne-vlp-16", 44.913},
                                                             {"velodyne-vlp-32c", 44.913},
                                                             {"valeo-scala-1", 49.912},
                                                             {"ibeo-lux-2010", 50.0},
                                                             {"blickfeld-cube", 49.956}})
    EXPECT_NEAR(10.0 * std::log10(1e3 * profileOf(id).emitter.peak_power_w), dbm, 0.001) << id;
}

}  // namespace
}  // namespace model
