#include "prediction/annotate.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/csv.h"
#include "core/file.h"
#include "tests/prediction/small_package.h"
#include "tests/support/thrown_message.h"

namespace {

using nlohmann::json;
using prediction::AnnotatedCounts;
using prediction::AnnotateOptions;
using prediction::Annotation;
using test_prediction::aroundLine;
using test_prediction::savePrediction;
using testing::ElementsAre;
using testing::HasSubstr;
using Names = std::vector<std::string>;
using FilePath = std::filesystem::path;

class AnnotatedPackage : public testing::Test {
 protected:
  /// One sample without parameters; what its detections are is up to the test.
  void write(const std::string& measurement, const json& parameters = json::object()) {
    test_prediction::addSample(folder_, json_, "s" + std::to_string(json_["samples"].size()), parameters, measurement);
  }
  FilePath save(const metrics::ErrorSamples& samples, const std::string& measurand = "range",
                const std::string& name = "prediction.json") {
    return savePrediction(folder_ / name, {samples}, measurand);
  }
  std::vector<AnnotatedCounts> annotate(const std::vector<FilePath>& files, const AnnotateOptions& options = {}) {
    std::vector<prediction::PredictionFile> read;
    for (const FilePath& file : files) read.push_back(prediction::readPredictionFile(file));
    return Annotation(model::readExperiment(package()), std::move(read), options).apply(package());
  }
  std::string refusal(const std::vector<FilePath>& files, const AnnotateOptions& options = {}) {
    return test_support::thrownMessage([&] { (void)annotate(files, options); });
  }
  [[nodiscard]] FilePath package() const { return folder_ / "package"; }
  [[nodiscard]] FilePath measurement(int sample = 0) const {
    return package() / ("measurements/s" + std::to_string(sample) + ".csv");
  }
  std::vector<double> column(const std::string& name) {
    return core::readNumericColumns(measurement(), Names{name}).front();
  }
  Names cells(const std::string& name, int sample = 0) {
    const core::CsvTable table = core::readCsvTable(measurement(sample));
    Names values;
    for (const auto& row : table.rows) values.push_back(row[table.column(name)]);
    return values;
  }

  test_support::TemporaryFolder folder_;
  json json_ = test_prediction::emptyExperiment();
};

// Line 0.1 + 0.01 x, s = r sqrt 6, h = 1/3 + (x - 20)^2 / 200, one degree of freedom: t = tan(0.475 pi) (Cauchy).
TEST_F(AnnotatedPackage, BiasAndBoundsOfEveryDetectionFollowTheClosedForm) {
  write("range_m\n10\n12.5\n20\n28.75\n");
  const auto counts = annotate({save(aroundLine("range_m", 0.002))}, {.coordinates = {"range_m=detection"}});
  const auto bias = column("range_m_bias");
  const auto low = column("range_m_bias_low");
  const auto high = column("range_m_bias_high");
  const double t = std::tan(0.475 * std::acos(-1.0));
  const double ranges[] = {10, 12.5, 20, 28.75};
  ASSERT_EQ(bias.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double half = t * 0.002 * std::sqrt(6.0) * std::sqrt(1.0 / 3 + std::pow(ranges[i] - 20, 2) / 200);
    const double value = 0.1 + 0.01 * ranges[i];
    EXPECT_NEAR(bias[i], value, 1e-6);  // six digits are written
    EXPECT_NEAR(low[i], value - half, 1e-6);
    EXPECT_NEAR(high[i], value + half, 1e-6);
  }
  EXPECT_EQ(counts.at(0).detections, 4u);
  EXPECT_EQ(counts.at(0).outside + counts.at(0).unknown, 0u);
}

TEST_F(AnnotatedPackage, ObservationBoundsHoldOneMoreSample) {
  write("range_m\n20\n");
  annotate({save(aroundLine("range_m", 0.002))}, {.bounds = metrics::BoundOf::Observation});
  const double t = std::tan(0.475 * std::acos(-1.0));
  EXPECT_NEAR(column("range_m_bias_high").at(0), 0.3 + t * 0.002 * std::sqrt(6.0 * 4 / 3), 1e-6);
}

// The samples lie at 10, 20 and 30: these ends are inside, the next number that the file can hold is not.
TEST_F(AnnotatedPackage, ExtrapolationBeginsExactlyBehindTheLastSample) {
  write("range_m\n9.9999\n10\n30\n30.0001\n");
  const auto counts = annotate({save(aroundLine("range_m", 0.002))});
  EXPECT_THAT(cells("range_m_extrapolated"), ElementsAre("1", "0", "0", "1"));
  EXPECT_EQ(counts.at(0).outside, 2u);
  EXPECT_NEAR(column("range_m_bias").at(3), 0.400001, 1e-6);  // flagged, not withheld
}

// Samples on the diagonal of a square: the other corner is in range in both, and far from all of them.
TEST_F(AnnotatedPackage, CombinationWithoutASampleNearIsFlaggedByItself) {
  write("layer,azimuth_rad,elevation_rad,range_m\n0,0,0,10\n3,0,0,10\n");
  const metrics::ErrorSamples samples{.target = "d_bias",
                                      .parameters = {"range_m", "layer"},
                                      .points = {10, 0, 20, 1, 30, 3, 20, 2, 25, 2},
                                      .errors = {0.1, 0.2, 0.3, 0.2, 0.25}};
  annotate({save(samples)});
  EXPECT_THAT(cells("range_m_extrapolated"), ElementsAre("0", "2"));
}

TEST_F(AnnotatedPackage, UnknownPointGetsAFlagAndNoNumber) {
  write("range_m\n12\n", {{"tilt", 20.0}});
  write("range_m\n12\n");  // nobody recorded the tilt of this one
  const auto counts = annotate({save(aroundLine("tilt", 0.002))});
  EXPECT_THAT(cells("range_m_bias", 0), ElementsAre("0.3"));
  for (const char* name : {"range_m_bias", "range_m_bias_low", "range_m_bias_high"}) {
    EXPECT_THAT(cells(name, 1), ElementsAre(""));
  }
  EXPECT_THAT(cells("range_m_extrapolated", 1), ElementsAre("3"));
  EXPECT_EQ(counts.at(0).unknown, 1u);
}

// Three coefficients through three samples: no degrees of freedom, so the bounds are infinite.
TEST_F(AnnotatedPackage, BoundThatIsNotKnownIsAnEmptyCell) {
  write("range_m\n12\n");
  metrics::ErrorSamples two{.target = "d_bias", .parameters = {"range_m"}, .points = {10, 20}, .errors = {0.2, 0.3}};
  annotate({save(two)});
  EXPECT_THAT(cells("range_m_bias"), ElementsAre("0.22"));
  EXPECT_THAT(cells("range_m_bias_low"), ElementsAre(""));
  EXPECT_THAT(cells("range_m_extrapolated"), ElementsAre("0"));
}

TEST_F(AnnotatedPackage, EveryErrorOfEveryFileHasItsColumns) {
  write("range_m,epw_m\n12,1\n");
  metrics::ErrorSamples scatter = aroundLine("range_m", 0.002);
  scatter.target = "d_cavm";
  const FilePath both = savePrediction(folder_ / "both.json", {aroundLine("range_m", 0.002), scatter}, "epw");
  annotate({save(aroundLine("range_m", 0.002)), both});
  EXPECT_THAT(core::readCsvTable(measurement()).header,
              ElementsAre("range_m", "epw_m", "range_m_bias", "range_m_bias_low", "range_m_bias_high",
                          "range_m_extrapolated", "epw_m_bias", "epw_m_bias_low", "epw_m_bias_high", "epw_m_cavm",
                          "epw_m_cavm_low", "epw_m_cavm_high", "epw_m_extrapolated"));
}

TEST_F(AnnotatedPackage, CellsThatWereThereStayAsTheyWere) {
  write("note,range_m,echo\n\"a, \"\"b\"\"\",12.50,1\n,20.0000,2\n");
  annotate({save(aroundLine("range_m", 0.0))});
  EXPECT_THAT(core::readFile(measurement()),
              HasSubstr("\n\"a, \"\"b\"\"\",12.50,1,0.225,0.225,0.225,0\n,20.0000,2,0.3,"));
}

TEST_F(AnnotatedPackage, IsStillAPackageWithTheSameDetections) {
  write("frame,layer,azimuth_rad,elevation_rad,echo,range_m,epw_m\n0,1,0.1,0.2,1,12.5,0.8\n");
  const core::Detections before = core::readDetections(measurement());
  annotate({save(aroundLine("range_m", 0.002))});
  const model::Experiment package = model::readExperiment(this->package());
  const core::Detections after = model::readMeasurements(package, package.samples[0]);
  EXPECT_EQ(after.range_m, before.range_m);
  EXPECT_EQ(after.epw_m, before.epw_m);
  EXPECT_EQ(after.azimuth_rad, before.azimuth_rad);
}

TEST_F(AnnotatedPackage, RecordsWhichFileSaidIt) {
  write("range_m\n12\n");
  const FilePath file = save(aroundLine("range_m", 0.002));
  annotate({file});
  const json entry = core::readJson(package() / "experiment.json").at("x-prediction").at(0);
  EXPECT_EQ(entry.at("file"), "prediction.json");
  EXPECT_EQ(entry.at("sha256"), core::sha256OfFile(file));
  EXPECT_EQ(entry.at("title"), "d_bias of range (range_m, m) over range_m");
  EXPECT_EQ(entry.at("coordinates").at("range_m"), "detection:range_m");
  EXPECT_EQ(entry.at("measurand"), (json{{"name", "range"}, {"column", "range_m"}, {"unit", "m"}}));
  annotate({});  // the next simulation predicts nothing
  EXPECT_FALSE(core::readJson(package() / "experiment.json").contains("x-prediction"));
}

TEST_F(AnnotatedPackage, FileWithoutMeasurandAsksForIt) {
  write("range_m\n12\n");
  const FilePath old = save(aroundLine("range_m", 0.002), "");
  EXPECT_THAT(refusal({old}), HasSubstr("does not record whose errors it predicts"));
  EXPECT_THAT(refusal({old}), HasSubstr("--measurand range"));
  annotate({old}, {.measurand = "range"});
  EXPECT_THAT(cells("range_m_bias"), ElementsAre("0.22"));
}

TEST_F(AnnotatedPackage, MeasurandMustBeTheExperiments) {
  write("range_m\n12\n");
  const FilePath old = save(aroundLine("range_m", 0.002), "", "old.json");
  EXPECT_THAT(refusal({old}, {.measurand = "rnge"}), HasSubstr("Did you mean 'range'?"));
  EXPECT_THAT(refusal({save(aroundLine("range_m", 0.002))}, {.measurand = "epw"}), HasSubstr("contradicts the file"));
  json_["measurands"][0]["unit"] = "cm";
  core::writeJson(package() / "experiment.json", json_);
  EXPECT_THAT(refusal({save(aroundLine("range_m", 0.002))}), HasSubstr("is in cm"));
}

TEST_F(AnnotatedPackage, MeasurandIsPredictedOnce) {
  write("range_m\n12\n");
  EXPECT_THAT(refusal({save(aroundLine("range_m", 0.002)), save(aroundLine("range_m", 0.0), "range", "again.json")}),
              HasSubstr("again.json: predicts 'range' a second time"));
}

TEST_F(AnnotatedPackage, MeasurandThatIsNeverReportedIsRefused) {
  write("range_m\n12\n");
  EXPECT_THAT(refusal({save(aroundLine("range_m", 0.002), "epw")}), HasSubstr("no detection has the column 'epw_m'"));
}

TEST_F(AnnotatedPackage, SampleWithoutDetectionsKeepsItsHeader) {
  write("frame,echo,range_m\n");
  annotate({save(aroundLine("range_m", 0.002))});
  EXPECT_EQ(core::readFile(measurement()),
            "frame,echo,range_m,range_m_bias,range_m_bias_low,range_m_bias_high,range_m_extrapolated\n");
}

}  // namespace
