#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "core/file.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

// `fidelis metric` as scripts see it: files in, JSON or a table out, exit status.
namespace {

using nlohmann::json;
using test_support::ProgramRun;
using test_support::runFidelis;
using test_support::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MetricCommand : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& content) {
    return folder_.write(name, content).string();
  }
  /// Measured 0, 1, 3 m.
  std::string real() { return file("real.csv", "frame,range_m,epw_m\n0,0,1\n1,1,1\n2,3,1.5\n"); }
  /// The same 5 m farther; pulse widths as measured.
  std::string simulated() { return file("sim.csv", "range_m,epw_m\n5,1\n6,1\n8,1.5\n"); }

  TemporaryFolder folder_;
};

json measurandOf(const ProgramRun& run, std::size_t index = 0) {
  EXPECT_EQ(run.status, 0) << run.messages;
  return json::parse(run.out).at("measurands").at(index);
}

TEST_F(MetricCommand, PureOffsetIsReportedAsBiasUnderEveryKey) {
  const ProgramRun run = runFidelis({"metric", real(), simulated(), "--column", "range_m", "--json", "-"});
  const json range = measurandOf(run);
  EXPECT_EQ(json::parse(run.out).at("format"), "fidelis-metric");
  EXPECT_EQ(json::parse(run.out).at("version"), 1);
  EXPECT_EQ(range.at("name"), "range_m");
  EXPECT_EQ(range.at("unit"), "m");
  EXPECT_EQ(range.at("n_real"), 3);
  EXPECT_THAT(range.at("n_sim"), ElementsAre(3));
  for (const char* key : {"d_avm", "d_minus", "d_bias", "d_bias_balanced", "d_avm_max", "mean_difference",
                          "median_difference", "wasserstein_1"}) {
    EXPECT_DOUBLE_EQ(range.at(key).get<double>(), 5.0) << key;
  }
  for (const char* key : {"d_plus", "d_cavm", "residual_bias", "d_cavm_balanced", "pbox_area", "std_difference"}) {
    EXPECT_NEAR(range.at(key).get<double>(), 0.0, 1e-15) << key;
  }
  EXPECT_DOUBLE_EQ(range.at("dvm").at(0).get<double>(), 5.0);
  EXPECT_DOUBLE_EQ(range.at("double_metric").at(1).get<double>(), 5.0);
  EXPECT_LT(range.at("d_mavm").at(0).get<double>(), -5.0);
  EXPECT_GT(range.at("d_mavm").at(1).get<double>(), 0.0);
  EXPECT_EQ(range.at("ks").at("statistic"), 1.0);
  EXPECT_LT(range.at("ks").at("p_value").get<double>(), 0.1);
}

TEST_F(MetricCommand, SeveralSimulatedFilesMakeABox) {
  const std::string low = file("low.csv", "v\n2\n");
  const std::string high = file("high.csv", "v\n5\n5\n");
  const json v =
      measurandOf(runFidelis({"metric", file("seven.csv", "v\n7\n"), low, high, "--column", "v", "--json", "-"}));
  EXPECT_THAT(v.at("n_sim"), ElementsAre(1, 2));
  EXPECT_EQ(v.at("unit"), "");
  EXPECT_EQ(v.at("d_bias"), -2.0);
  EXPECT_THAT(v.at("double_metric"), ElementsAre(5.0, 2.0));
  EXPECT_EQ(v.at("d_avm_max"), 5.0);
  EXPECT_EQ(v.at("pbox_area"), 3.0);
  EXPECT_DOUBLE_EQ(v.at("mean_difference").get<double>(), -3.0);  // pooled: 2, 5, 5
  EXPECT_EQ(v.at("median_difference"), -2.0);
  EXPECT_TRUE(v.at("std_difference").is_null());  // one measured value has no spread
}

TEST_F(MetricCommand, EveryColumnIsAMeasurandWithTheUnitOfItsName) {
  const std::string words = "range_m,azimuth_rad,time_s,delay_ns,intensity,speed_m_s,count\n1,1,1,1,1,1,1\n";
  const std::string both = file("all.csv", words);
  std::vector<std::string> arguments{"metric", both, both, "--json", "-"};
  for (const char* column : {"range_m", "azimuth_rad", "time_s", "delay_ns", "intensity", "speed_m_s", "count"}) {
    arguments.insert(arguments.end(), {"--column", column});
  }
  std::vector<std::string> units;
  const json document = json::parse(runFidelis(arguments).out);
  for (const json& measurand : document.at("measurands")) units.push_back(measurand.at("unit"));
  EXPECT_THAT(units, ElementsAre("m", "rad", "s", "ns", "nW", "m/s", ""));
}

TEST_F(MetricCommand, GivenUnitsReplaceThoseOfTheNames) {
  const std::vector<std::string> words{"metric",  real(),     simulated(), "--json", "-", "--column",
                                       "range_m", "--column", "epw_m",     "--unit", "ft"};
  EXPECT_EQ(measurandOf(runFidelis(words), 1).at("unit"), "ft");
}

TEST_F(MetricCommand, TableNamesMetricValueUnitAndMeaning) {
  const ProgramRun run = runFidelis({"metric", real(), simulated(), "--column", "range_m", "--metric", "d_bias,ks"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("range_m: n = 3 measured, 3 simulated\n"));
  EXPECT_THAT(run.out, testing::ContainsRegex("d_bias +5 +m +d_minus - d_plus; > 0: simulation too high"));
  EXPECT_THAT(run.out, testing::ContainsRegex("ks +\\[1, 0\\.[0-9]+\\] +-  "));
  EXPECT_THAT(run.out, testing::Not(HasSubstr("d_cavm")));
  EXPECT_THAT(run.messages, IsEmpty());
}

// Uncovered half of a box: one shift leaves a rest, the balanced one does not, and dvm takes the one that is asked for.
TEST_F(MetricCommand, ShiftOptionChoosesTheCorrectionOfTheDoubleValidationMetric) {
  const std::string low = file("low.csv", "v\n0\n9\n");
  const std::string high = file("high.csv", "v\n2\n12\n");
  const std::string measured = file("measured.csv", "v\n1\n4\n");
  const auto run = [&](const std::string& shift) {
    return measurandOf(runFidelis({"metric", measured, low, high, "--column", "v", "--shift", shift, "--json", "-"}));
  };
  const json one = run("one");
  const json balanced = run("balanced");
  // d_minus = (9 - 4)/2 = 2.5; moved by 2.5, [-2.5, -0.5] misses 1 by 1.5, [6.5, 9.5] misses 4 by 2.5: 1.25 - 0.75.
  EXPECT_DOUBLE_EQ(one.at("d_bias").get<double>(), 2.5);
  EXPECT_DOUBLE_EQ(one.at("residual_bias").get<double>(), 0.5);
  EXPECT_THAT(one.at("dvm"), ElementsAre(2.5, 2.0));
  // Balanced where 5 - b = b - 1: b = 3.
  EXPECT_THAT(balanced.at("dvm"), ElementsAre(3.0, 2.0));
  EXPECT_DOUBLE_EQ(balanced.at("d_bias").get<double>(), 2.5);
  EXPECT_DOUBLE_EQ(one.at("d_bias_balanced").get<double>(), 3.0);
}

TEST_F(MetricCommand, ExperimentsWidenTheIntervalWhenTheyAreFew) {
  const auto lower = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"metric", real(), simulated(), "--column", "range_m", "--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return measurandOf(runFidelis(words)).at("d_mavm").at(0).get<double>();
  };
  EXPECT_DOUBLE_EQ(lower({"--experiments", "1"}), -2.5 - 4.55 * 2.5);
  EXPECT_EQ(lower({"--experiments", "3"}), lower({}));
}

// Ranks have an order and no differences: what needs differences is left out, and refused when it is asked for.
TEST_F(MetricCommand, AScaleOfMeasurementKeepsOutWhatItDoesNotAllow) {
  const std::vector<std::string> words{"metric", real(), simulated(), "--column", "epw_m", "--scale", "epw_m=ordinal"};
  std::vector<std::string> json_words = words;
  json_words.insert(json_words.end(), {"--json", "-"});
  const json epw = measurandOf(runFidelis(json_words));
  EXPECT_EQ(epw.at("scale"), "ordinal");
  EXPECT_FALSE(epw.contains("d_avm"));
  EXPECT_EQ(epw.at("left_out").at("d_avm"), "needs an interval scale, and epw_m is ordinal.");
  EXPECT_EQ(epw.at("ks").at("statistic"), 0.0);
  std::vector<std::string> asked = words;
  asked.insert(asked.end(), {"--metric", "d_bias"});
  const ProgramRun refused = runFidelis(asked);
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.messages, HasSubstr("metric 'd_bias': needs an interval scale, and epw_m is ordinal"));
}

// Row by row 5 m apart: every distance of pairs is known.
TEST_F(MetricCommand, SeriesAreComparedRowByRow) {
  const json range = measurandOf(
      runFidelis({"metric", real(), simulated(), "--data", "series", "--column", "range_m", "--json", "-"}));
  EXPECT_DOUBLE_EQ(range.at("manhattan").get<double>(), 15.0);
  EXPECT_DOUBLE_EQ(range.at("rmse").get<double>(), 5.0);
  EXPECT_DOUBLE_EQ(range.at("pearson").get<double>(), 1.0);
  const ProgramRun shorter = runFidelis({"metric", real(), file("short.csv", "range_m\n1\n"), "--data", "series",
                                         "--column", "range_m", "--metric", "rmse"});
  EXPECT_EQ(shorter.status, 2);
  EXPECT_THAT(shorter.messages, testing::AllOf(HasSubstr("3"), HasSubstr("1")));
}

// A wall at x = 3 m, written once as points and once as detections straight ahead, 0.25 m farther.
TEST_F(MetricCommand, PointCloudsMayBeWrittenAsPointsOrAsDetections) {
  const std::string points = file("points.csv", "x_m,y_m,z_m\n3,0,0\n3,0,0\n");
  const std::string detections =
      file("detections.csv", "frame,azimuth_rad,elevation_rad,range_m\n0,0,0,3.25\n1,0,0,9\n");
  const json all = measurandOf(runFidelis({"metric", points, detections, "--data", "point-cloud", "--json", "-"}));
  EXPECT_EQ(all.at("n_sim").at(0), 2);
  EXPECT_DOUBLE_EQ(all.at("hausdorff").get<double>(), 6.0);
  const json first = measurandOf(
      runFidelis({"metric", detections, detections, "--data", "point-cloud", "--set", "frame=0", "--json", "-"}));
  EXPECT_EQ(first.at("n_real"), 1);
  const ProgramRun neither = runFidelis({"metric", real(), points, "--data", "point-cloud"});
  EXPECT_EQ(neither.status, 2);
  EXPECT_THAT(neither.messages, HasSubstr("real.csv:1: has neither x_m, y_m, z_m nor range_m"));
}

// Two layers of two beams; the nearest echo of a beam counts, a beam without a line has none.
TEST_F(MetricCommand, RangeImagesAreReadFromMeasurementsOrFromAMatrix) {
  const std::string header = "frame,layer,azimuth_rad,echo,range_m\n";
  const std::string measured =
      file("image.csv", header + "0,0,0.1,1,5\n0,0,0.1,2,9\n0,0,0,1,6\n0,1,0,1,7\n1,1,0.1,1,8\n");
  const std::string matrix = file("matrix.csv", "5.5,6.5\n,7.5\n");
  const std::string same = file("same.csv", "5,6\nnan,7\n");
  const json from_matrix = measurandOf(runFidelis({"metric", same, matrix, "--data", "range-image", "--json", "-"}));
  EXPECT_DOUBLE_EQ(from_matrix.at("mean_signed_error").get<double>(), 0.5);
  EXPECT_EQ(from_matrix.at("measured_only_pixels"), 0.0);
  const std::string simulated = file("simulated.csv", header + "0,0,0.1,1,5.5\n0,0,0,1,6.5\n0,1,0.1,1,8\n");
  const json image = measurandOf(runFidelis({"metric", measured, simulated, "--data", "range-image", "--json", "-"}));
  EXPECT_EQ(image.at("n_real"), 3);
  EXPECT_DOUBLE_EQ(image.at("mean_signed_error").get<double>(), 0.5);
  EXPECT_DOUBLE_EQ(image.at("measured_only_pixels").get<double>(), 0.25);
  EXPECT_DOUBLE_EQ(image.at("simulated_only_pixels").get<double>(), 0.25);
}

TEST_F(MetricCommand, OccupancyGridsAreMatricesOfProbabilities) {
  const std::string measured = file("grid.csv", "0.9,0.1\n0.9,0.1\n");
  const std::string simulated = file("grid_sim.csv", "0.9,0.9\n0.9,0.1\n");
  const json grid = measurandOf(runFidelis({"metric", measured, simulated, "--data", "occupancy-grid", "--json", "-"}));
  EXPECT_NEAR(grid.at("jaccard").get<double>(), 1.0 - 2.0 / 3.0, 1e-12);
  const ProgramRun empty_cell =
      runFidelis({"metric", measured, file("hole.csv", "0.9,\n0.9,0.1\n"), "--data", "occupancy-grid"});
  EXPECT_EQ(empty_cell.status, 2);
  EXPECT_THAT(empty_cell.messages, HasSubstr("hole.csv, row 1, column 2: is empty"));
  const ProgramRun ragged =
      runFidelis({"metric", measured, file("ragged2.csv", "0.9,0.1\n0.9\n"), "--data", "occupancy-grid"});
  EXPECT_THAT(ragged.messages, HasSubstr("ragged2.csv:2: has 1 cells; the first row has 2"));
}

// One object 0.3 m off, one missed: GOSPA^2 = 0.3^2 + c^2 / 2.
TEST_F(MetricCommand, ObjectListsAndTracksComeFromTheSameColumns) {
  const std::string truth = file("truth.csv", "id,frame,x_m,y_m\n1,0,10,0\n2,0,20,5\n1,1,11,0\n");
  const std::string objects = file("objects.csv", "id,frame,x_m,y_m\n7,0,10.3,0\n7,1,11.3,0\n");
  const json lists = measurandOf(
      runFidelis({"metric", truth, objects, "--data", "object-list", "--set", "cut_off_m=2", "--json", "-"}));
  EXPECT_NEAR(lists.at("gospa").at("distance").get<double>(), std::sqrt(0.3 * 0.3 + 2.0), 1e-12);
  EXPECT_EQ(lists.at("gospa").at("missed"), 1.0);
  const json tracks = measurandOf(runFidelis({"metric", truth, objects, "--data", "tracks", "--json", "-"}));
  EXPECT_EQ(tracks.at("n_real"), 2);
  EXPECT_EQ(tracks.at("track_metric").at("switches"), 0.0);
  const ProgramRun no_frame =
      runFidelis({"metric", file("still.csv", "id,x_m,y_m\n1,0,0\n"), objects, "--data", "tracks"});
  EXPECT_EQ(no_frame.status, 2);
  EXPECT_THAT(no_frame.messages, HasSubstr("still.csv:1: has no column 'frame'"));
  const ProgramRun twice =
      runFidelis({"metric", file("twice.csv", "id,frame,x_m,y_m\n1,0,0,0\n1,0,1,0\n"), objects, "--data", "tracks"});
  EXPECT_THAT(twice.messages, HasSubstr("twice.csv: has object 1 twice in frame 0"));
}

// Two runs with the values 0 and 3 in opposite rows have one EDF, so their envelope has no width; but if rows are the
// same aleatory sample, each may be 0 or 3.
TEST_F(MetricCommand, SeveralFilesMayBeCombinedInThreeWays) {
  const std::string first = file("first.csv", "v\n0\n3\n");
  const std::string second = file("second.csv", "v\n3\n0\n");
  const std::string other = file("other.csv", "v\n1\n2\n");
  const std::string measured = file("measured.csv", "v\n1\n2\n");
  const auto area = [&](const std::string& with, std::vector<std::string> more) {
    std::vector<std::string> words{"metric", measured, first, with, "--column", "v", "--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return measurandOf(runFidelis(words));
  };
  EXPECT_EQ(area(second, {}).at("pbox_area"), 0.0);
  EXPECT_DOUBLE_EQ(area(second, {"--combine", "a-outer"}).at("pbox_area").get<double>(), 3.0);
  const json mixture = area(other, {"--combine", "mixture", "--shares", "3,1"});
  EXPECT_EQ(mixture.at("pbox_area"), 0.0);
  EXPECT_DOUBLE_EQ(mixture.at("d_bias").get<double>(), 0.0);  // both means are 1.5
  EXPECT_DOUBLE_EQ(mixture.at("d_avm").get<double>(), 0.75);  // 0, 0, 0, 1 | 2, 3, 3, 3 against 1 | 2, by eighths
  const ProgramRun uneven = runFidelis(
      {"metric", measured, first, file("long.csv", "v\n1\n2\n3\n"), "--column", "v", "--combine", "a-outer"});
  EXPECT_EQ(uneven.status, 2);
  EXPECT_THAT(uneven.messages, HasSubstr("long.csv: has 3 rows"));
}

TEST_F(MetricCommand, MarginsBandsWeightsAndLookUpsShapeTheBoxes) {
  const auto run = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"metric", real(), simulated(), "--column", "range_m", "--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return measurandOf(runFidelis(words));
  };
  // 5 m apart, each side known to some margin.
  EXPECT_DOUBLE_EQ(run({"--sim-margin", "1"}).at("d_avm").get<double>(), 4.0);
  EXPECT_DOUBLE_EQ(run({"--sim-margin", "1", "--real-margin", "1.5"}).at("d_avm").get<double>(), 2.5);
  EXPECT_LT(run({"--band", "0.05"}).at("d_avm").get<double>(), 1.0);  // three values say little
  const json look = run({"--sim-margin", "1", "--at-level", "0.5", "--at-value", "5"});
  EXPECT_THAT(look.at("quantiles").at(0).at("real"), ElementsAre(1.0, 1.0));
  EXPECT_THAT(look.at("quantiles").at(0).at("simulated"), ElementsAre(5.0, 7.0));
  EXPECT_EQ(look.at("probabilities").at(0).at("simulated").at(0), 0.0);  // 6, 7, 9 at the right edge
  EXPECT_DOUBLE_EQ(look.at("probabilities").at(0).at("simulated").at(1).get<double>(), 2.0 / 3.0);  // 4, 5, 7
  const std::string weighted = file("weighted.csv", "v,w\n0,3\n4,1\n");
  const std::string repeated = file("repeated.csv", "v,w\n0,1\n0,1\n0,1\n4,1\n");
  const json same =
      measurandOf(runFidelis({"metric", weighted, repeated, "--column", "v", "--weights", "w", "--json", "-"}));
  EXPECT_EQ(same.at("d_avm"), 0.0);
  const ProgramRun both =
      runFidelis({"metric", real(), simulated(), "--column", "range_m", "--sim-margin", "1", "--floor"});
  EXPECT_EQ(both.status, 2);
  EXPECT_THAT(both.messages, HasSubstr("draw plain samples anew"));
}

// Two frames whose detections are equal: drawn by detection the mean seems known, drawn by frame it is not.
TEST_F(MetricCommand, IntervalsAreDrawnByTheUnitOfChance) {
  std::string rows = "frame,range_m\n";
  for (int i = 0; i < 200; ++i) rows += std::to_string(i % 4) + "," + std::to_string(i % 4) + "\n";
  const std::string both = file("frames.csv", rows);
  const auto run = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"metric", both,          both,  "--column", "range_m", "--metric",
                                   "d_bias", "--intervals", "200", "--json",   "-"};
    words.insert(words.end(), more.begin(), more.end());
    return runFidelis(words);
  };
  const auto width = [](const ProgramRun& done) {
    const json interval = measurandOf(done).at("intervals").at("d_bias");
    return interval.at("high").get<double>() - interval.at("low").get<double>();
  };
  // Standard error of a difference of means: sqrt(2) 1.118 / sqrt(n), n = 200 detections or 4 frames.
  EXPECT_NEAR(width(run({})), 2 * 1.96 * std::sqrt(2.0) * 1.118 / std::sqrt(200.0), 0.12);
  EXPECT_GT(width(run({"--chance-unit", "frame"})), 2.0);
  EXPECT_EQ(run({"--threads", "1"}).out, run({"--threads", "2"}).out);
  EXPECT_NE(run({"--seed", "2"}).out, run({"--seed", "3"}).out);
  const ProgramRun no_unit = run({"--chance-unit", "frme"});
  EXPECT_EQ(no_unit.status, 2);
  EXPECT_THAT(no_unit.messages, HasSubstr("Did you mean 'frame'?"));
}

// Dealing equal samples out anew, d_avm is never below that of the samples themselves, which is 0: p = 1.
TEST_F(MetricCommand, TheFloorSaysWhatChanceAloneGives) {
  const std::string both = file("line.csv", "v\n1\n2\n3\n4\n5\n6\n7\n8\n");
  const json v = measurandOf(runFidelis({"metric", both, both, "--column", "v", "--floor", "--json", "-"}));
  EXPECT_EQ(v.at("floor").at("d_avm").at("p_value"), 1.0);
  EXPECT_GT(v.at("floor").at("d_avm").at("median").get<double>(), 0.0);
  EXPECT_GE(v.at("floor").at("d_avm").at("quantile_95"), v.at("floor").at("d_avm").at("median"));
  const ProgramRun table = runFidelis({"metric", both, both, "--column", "v", "--floor", "--half-width", "d_bias=0.1"});
  EXPECT_THAT(table.out, HasSubstr("floor of d_cavm: a perfect model gives"));
  EXPECT_GT(v.at("floor").at("d_cavm").at("perfect_model_median").get<double>(), 0.0);
  EXPECT_THAT(table.out, HasSubstr("d_bias to +-0.1:"));
  EXPECT_EQ(runFidelis({"metric", both, both, "--column", "v", "--half-width", "d_bias"}).status, 2);
  EXPECT_EQ(runFidelis({"metric", both, both, "--column", "v", "--data", "series", "--floor"}).status, 2);
}

TEST_F(MetricCommand, AMetricOfAnotherKindOfDataIsToldWhichKind) {
  const ProgramRun run = runFidelis({"metric", real(), simulated(), "--column", "range_m", "--metric", "rmse"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("Give --data series"));
}

// scripts/metric-table writes it there.
TEST_F(MetricCommand, TheTableInTheDocsIsTheProgramsOwn) {
  const ProgramRun run = runFidelis({"metric", "--list"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(core::readFile(test_support::sourceFolder() / "docs/metrics.md"), HasSubstr(run.out));
  const json list = json::parse(runFidelis({"metric", "--list", "--json", "-"}).out);
  EXPECT_GE(list.at("metrics").size(), 34u);
}

TEST_F(MetricCommand, CompressedFileGivesTheSameBytes) {
  const std::string plain = real();
  const std::string packed = (folder_ / "real.csv.gz").string();
  core::writeFile(packed, core::readFile(plain));
  const auto numbers = [&](const std::string& measured) {
    return measurandOf(runFidelis({"metric", measured, simulated(), "--column", "epw_m", "--json", "-"}));
  };
  EXPECT_EQ(numbers(packed).dump(), numbers(plain).dump());
}

TEST_F(MetricCommand, NumberOfThreadsDoesNotChangeABit) {
  const auto bytes = [&](const char* threads) {
    return runFidelis({"--threads", threads, "metric", real(), simulated(), "--column", "range_m", "--json", "-"}).out;
  };
  EXPECT_EQ(bytes("1"), bytes("2"));
}

TEST_F(MetricCommand, JsonGoesToAFileAndNothingElseIsSaid) {
  const std::string result = (folder_ / "result.json").string();
  const ProgramRun run = runFidelis({"metric", real(), simulated(), "--column", "range_m", "--json", result});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_EQ(json::parse(core::readFile(result)).at("measurands").at(0).at("d_bias"), 5.0);
}

TEST_F(MetricCommand, BadInputEndsWithStatusTwoAndSaysWhere) {
  const auto expectError = [this](const std::vector<std::string>& more, const std::vector<std::string>& told) {
    std::vector<std::string> words{"metric"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun run = runFidelis(words);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.out, IsEmpty());
    for (const std::string& text : told) EXPECT_THAT(run.messages, HasSubstr(text));
  };
  const std::string good = real();
  const std::string other = simulated();
  const std::string nothing = file("nothing.csv", "");
  const std::string header = file("header.csv", "range_m\n");
  const std::string gap = file("gap.csv", "range_m\n1\nNaN\n");
  const std::string blank = file("blank.csv", "frame,range_m\n0,1\n1,\n");
  const std::string text = file("text.csv", "frame,range_m\n0,far\n");
  const std::string ragged = file("ragged.csv", "frame,range_m\n0\n");
  const std::string absent = (folder_ / "absent.csv").string();
  expectError({good, other, "--column", "rnge_m"}, {"real.csv:1: has no column 'rnge_m'", "Did you mean 'range_m'?"});
  expectError({good, absent, "--column", "range_m"}, {"absent.csv"});
  expectError({good, nothing, "--column", "range_m"}, {"nothing.csv: is empty; a header line was expected"});
  expectError({header, other, "--column", "range_m"}, {"header.csv: has a header and no rows"});
  expectError({good, gap, "--column", "range_m"}, {"gap.csv:3, column 'range_m': 'NaN' is not a finite number"});
  expectError({good, blank, "--column", "range_m"}, {"blank.csv:3, column 'range_m'"});
  expectError({good, text, "--column", "range_m"}, {"text.csv:2, column 'range_m': 'far' is not a finite number"});
  expectError({good, ragged, "--column", "range_m"}, {"ragged.csv:2, column 'range_m': the cell is missing"});
  expectError({good, other, "--column", "range_m", "--metric", "bias"}, {"metric 'bias': is not known"});
  expectError({good, other, "--column", "range_m", "--column", "range_m"}, {"--column range_m: is given twice"});
  expectError({good, other, "--column", "range_m", "--unit", "m", "--unit", "ft"}, {"--unit: is given 2 times"});
  expectError({good, other, "--column", "range_m", "--shift", "two"}, {"--shift"});
  expectError({good, other, "--column", "range_m", "--experiments", "0"}, {"--experiments"});
  expectError({good, other}, {"--column: is required"});
  expectError({good, "--column", "range_m"}, {"SIM: is required"});
}

TEST_F(MetricCommand, JsonThatCannotBeWrittenIsAnErrorNotASilence) {
  const std::string target = (folder_.path() / "no" / "folder" / "result.json").string();
  const ProgramRun run = runFidelis({"metric", real(), simulated(), "--column", "range_m", "--json", target});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("result.json"));
}

// A measurement of a million lines against one that is 0.25 m farther.
TEST_F(MetricCommand, MillionLinesAreCompared) {
  std::string real = "frame,range_m,epw_m\n";
  std::string simulated = real;
  for (int i = 0; i < 1'000'000; ++i) {
    const int steps = static_cast<int>((static_cast<long long>(i) * 7919) % 400'000);  // of 0.25 mm
    real += std::to_string(i) + "," + std::to_string(0.00025 * steps) + ",1\n";
    simulated += std::to_string(i) + "," + std::to_string(0.00025 * (steps + 1000)) + ",1\n";
  }
  const std::string first = file("million.csv", real);
  const std::string second = file("million_simulated.csv", simulated);
  const json range = measurandOf(runFidelis({"metric", first, second, "--column", "range_m", "--json", "-"}));
  EXPECT_EQ(range.at("n_real"), 1'000'000);
  EXPECT_NEAR(range.at("d_bias").get<double>(), 0.25, 1e-9);
  EXPECT_NEAR(range.at("d_cavm").get<double>(), 0.0, 1e-6);  // six decimals in the files
}

}  // namespace
