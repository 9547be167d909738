#include "model/signal/pulse_shape.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "model/sensor/sensor_profile.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

namespace model {
namespace {

TEST(PulseShape, GaussianIsTheDefaultWithItsClosedForms) {
  const PulseShape pulse;
  EXPECT_TRUE(pulse.isGaussian());
  EXPECT_EQ(pulse.at(0.0), 1.0);
  EXPECT_DOUBLE_EQ(pulse.at(0.5), 0.5);
  EXPECT_DOUBLE_EQ(pulse.at(-1.0), 0.0625);
  for (const double level : {0.9, 0.5, 0.1, 1e-6}) {
    const auto [rise, fall] = pulse.crossings(level).value();
    EXPECT_NEAR(pulse.at(rise), level, 1e-12);
    EXPECT_DOUBLE_EQ(rise, -fall);
    EXPECT_NEAR(fall - rise, std::sqrt(std::log2(1 / level)), 1e-12);  // formats.md section 3: EPW law
  }
  EXPECT_FALSE(pulse.crossings(1.0));
}

// A triangle from 0 over 2 at t = 3 to 0 at t = 7: half of the peak at 1.5 and 5, so 3.5 wide.
TEST(PulseShape, TriangleHasItsCrossings) {
  const PulseShape pulse({0, 3, 7}, {0, 2, 0});
  EXPECT_DOUBLE_EQ(pulse.width(), 3.5);
  EXPECT_DOUBLE_EQ(pulse.at(0), 1.0);
  EXPECT_DOUBLE_EQ(pulse.at(-1.5 / 3.5), 0.5);
  EXPECT_DOUBLE_EQ(pulse.at(2.0 / 3.5), 0.5);
  const auto [rise, fall] = pulse.crossings(0.25).value();
  EXPECT_NEAR(rise, (0.75 - 3) / 3.5, 1e-12);
  EXPECT_NEAR(fall, (6 - 3) / 3.5, 1e-12);
  EXPECT_EQ(pulse.at(-10), 0.0);
  EXPECT_EQ(pulse.at(10), 0.0);
}

TEST(PulseShape, DenselySampledGaussianIsTheGaussian) {
  std::vector<double> t, p;
  for (int i = -1500; i <= 1500; ++i) {
    t.push_back(100 + 0.01 * i);
    p.push_back(7e-3 * std::exp2(-4 * std::pow(0.01 * i / 5.0, 2)));
  }
  const PulseShape measured(t, p), law;
  EXPECT_NEAR(measured.width(), 5.0, 1e-5);
  for (double u = -1.5; u <= 1.5; u += 0.013) EXPECT_NEAR(measured.at(u), law.at(u), 1e-5);
  EXPECT_NEAR(measured.crossings(0.1)->rise, law.crossings(0.1)->rise, 1e-5);
}

TEST(PulseShape, AfterpulsesCountAndNoiseBelowZeroDoesNot) {
  const PulseShape pulse({0, 1, 2, 3, 4, 5}, {-1, 10, 0, 6, -2, 0});
  EXPECT_EQ(pulse.at(-1.0 / pulse.width()), 0.0);
  const auto half = pulse.crossings(0.5).value();
  EXPECT_NEAR(half.fall - half.rise, 1.0, 1e-12);  // first rise to last fall
  EXPECT_EQ(pulse.at(1.0 / pulse.width()), 0.0);
}

class PulseFile : public testing::Test {
 protected:
  std::string refusal(const std::string& name, const std::string& content, std::optional<double> step = {}) {
    const auto file = folder_.write(name, content);
    return test_support::thrownMessage([&] { (void)readPulseShape(file, step); });
  }
  test_support::TemporaryFolder folder_;
};

TEST_F(PulseFile, CsvIsRead) {
  const auto file = folder_.write("p.csv", "time_ns,power\n0,0\n3,2\n7,0\n");
  EXPECT_DOUBLE_EQ(readPulseShape(file, {}).width(), 3.5);
}

TEST_F(PulseFile, FaultsAreNamedWithTheirLine) {
  EXPECT_NE(refusal("p.csv", "time_ns,power\n0,0\n3,2\n2,0\n").find("p.csv:4"), std::string::npos);
  EXPECT_NE(refusal("p.csv", "time_ns,power\n0,0\n3,nan\n4,0\n").find("'nan' is not a number"), std::string::npos);
  EXPECT_NE(refusal("p.csv", "time_ns,power\n0,0\n3,2\n").find("fewer than three"), std::string::npos);
  EXPECT_NE(refusal("p.csv", "time_ns,power\n0,2\n3,1\n4,0\n").find("above half of its peak"), std::string::npos);
  EXPECT_NE(refusal("p.csv", "time_ns,power\n0,0\n3,-1\n4,0\n").find("no positive power"), std::string::npos);
  EXPECT_NE(refusal("p.npy", "x").find("step_ns"), std::string::npos);
  EXPECT_NE(refusal("p.npy", "x", 0.008).find("is no .npy file"), std::string::npos);
}

// Lindell & others' SPAD histograms: the peak lies in bin 0, the rise at the end of the period.
TEST(PulseShape, PeriodicHistogramsAreTurned) {
  FIDELIS_NEEDS_SHARED(shared);
  const auto folder = shared / "data/optics/spad_irf/scan_data_scripts/system_irf/20190207_face_scanning_low_mu/free";
  const PulseShape pulse = readPulseShape(folder / "unimodal-irf_tres-8ps_tlen-10000ps.npy", 0.008);
  EXPECT_EQ(pulse.at(0), 1.0);
  EXPECT_LT(pulse.begin(), -0.5);
  EXPECT_GT(pulse.end(), 0.5);
  EXPECT_NEAR(pulse.crossings(0.5)->fall - pulse.crossings(0.5)->rise, 1.0, 1e-12);
  EXPECT_NEAR(pulse.width(), 9 * 0.008, 2 * 0.008);  // nine bins lie above half of the peak
}

class MeasuredPulse : public testing::Test {
 protected:
  SensorProfile profile(const nlohmann::json& shape, const nlohmann::json& width) {
    nlohmann::json sensor = lab::sensor();
    sensor["emitter"]["pulse_shape"] = shape;
    sensor["emitter"]["pulse_fwhm_ns"] = width;
    (void)folder_.write("p.csv", "time_ns,power\n0,0\n3,2\n7,0\n");
    return resolveSensorProfile(sensor, folder_ / "experiment.json", "/sensor");
  }
  test_support::TemporaryFolder folder_;
};

TEST_F(MeasuredPulse, OfAProfileBringsItsOwnWidth) {
  const auto emitter = profile({{"file", "p.csv"}}, nullptr).emitter;
  EXPECT_FALSE(emitter.pulse_shape.isGaussian());
  EXPECT_DOUBLE_EQ(emitter.pulse_fwhm_ns, 3.5);
  EXPECT_DOUBLE_EQ(profile({{"file", "p.csv"}}, 3.6).emitter.pulse_fwhm_ns, 3.5);
}

TEST_F(MeasuredPulse, OfAnotherWidthThanStatedIsRefused) {
  EXPECT_NE(lab::refusal([&] {
              (void)profile({{"file", "p.csv"}}, 5.0);
            }).find("/sensor/emitter/pulse_fwhm_ns"),
            std::string::npos);
  EXPECT_NE(lab::refusal([&] { (void)profile({{"fil", "p.csv"}}, nullptr); }).find("file"), std::string::npos);
  EXPECT_NE(lab::refusal([&] { (void)profile({{"file", "none.csv"}}, nullptr); }).find("none.csv"), std::string::npos);
}

}  // namespace
}  // namespace model
