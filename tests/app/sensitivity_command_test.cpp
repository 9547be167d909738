#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "core/csv.h"
#include "core/text.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

// `fidelis sensitivity` as scripts see it: a design out, outputs in, indices out.
namespace {

using nlohmann::json;
using test_support::ProgramRun;
using test_support::runFidelis;
using test_support::TemporaryFolder;
using testing::HasSubstr;

class SensitivityCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) { return (folder_ / name).string(); }

  /// Three numbers from -pi to pi.
  std::string ishigamiParameters() {
    std::string all;
    for (const char* name : {"x1", "x2", "x3"}) {
      all += (all.empty() ? "" : ",") + std::string(R"({"name": ")") + name +
             R"(", "min": -3.141592653589793, "max": 3.141592653589793})";
    }
    return folder_
        .write("parameters.json", R"({"format": "fidelis-parameters", "version": 1, "parameters": [)" + all + "]}")
        .string();
  }

  /// Runs the Ishigami function for every row of a design.
  std::string ishigamiOutputs(const std::string& design) {
    const std::vector<std::string> names{"x1", "x2", "x3"};
    const auto x = core::readNumericColumns(design, names);
    std::string text = "y\n";
    for (std::size_t row = 0; row < x[0].size(); ++row) {
      text += core::shortestNumber(std::sin(x[0][row]) + 7.0 * std::pow(std::sin(x[1][row]), 2.0) +
                                   0.1 * std::pow(x[2][row], 4.0) * std::sin(x[0][row])) +
              "\n";
    }
    return folder_.write("outputs.csv", text).string();
  }

  json indicesOfIshigami(std::vector<std::string> options) {
    std::vector<std::string> words{"sensitivity", "design", ishigamiParameters(), "--out", path("design.csv")};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramRun design = runFidelis(words);
    EXPECT_EQ(design.status, 0) << design.messages;
    const ProgramRun run = runFidelis({"sensitivity", "analyze", path("design.csv"),
                                       ishigamiOutputs(path("design.csv")), "--column", "y", "--json", "-"});
    EXPECT_EQ(run.status, 0) << run.messages;
    return json::parse(run.out);
  }

  TemporaryFolder folder_;
};

/// Values of all parameters, in their order.
std::vector<double> values(const json& output, const char* which) {
  std::vector<double> all;
  for (const json& parameter : output.at("parameters")) all.push_back(parameter.at(which).at("value"));
  return all;
}

// Closed form, a = 7, b = 0.1: first .3139 .4424 0, total .5576 .4424 .2437.
TEST_F(SensitivityCommand, RoundTripOfTheIshigamiFunctionBySobol) {
  const json result = indicesOfIshigami({"--n", "2048"});
  EXPECT_EQ(result.at("format"), "fidelis-sensitivity");
  EXPECT_EQ(result.at("version"), 1);
  EXPECT_EQ(result.at("method"), "sobol");
  EXPECT_EQ(result.at("n"), 2048);
  EXPECT_EQ(result.at("seed"), 1);
  const json& output = result.at("outputs").at(0);
  EXPECT_EQ(output.at("name"), "y");
  EXPECT_THAT(values(output, "first"), testing::Pointwise(testing::DoubleNear(0.02), {0.3139, 0.4424, 0.0}));
  EXPECT_THAT(values(output, "total"), testing::Pointwise(testing::DoubleNear(0.02), {0.5576, 0.4424, 0.2437}));
  const json& total = output.at("parameters").at(0).at("total");
  EXPECT_LT(total.at("low").get<double>(), total.at("value").get<double>());
  EXPECT_GT(total.at("high").get<double>(), total.at("value").get<double>());
}

TEST_F(SensitivityCommand, RoundTripOfTheIshigamiFunctionByFast) {
  const json result = indicesOfIshigami({"--method", "fast", "--n", "513", "--curves", "3"});
  EXPECT_EQ(result.at("method"), "fast");
  EXPECT_EQ(result.at("n"), 513);
  EXPECT_EQ(result.at("options").at("curves"), 3);
  const json& output = result.at("outputs").at(0);
  EXPECT_THAT(values(output, "first"), testing::Pointwise(testing::DoubleNear(0.04), {0.3139, 0.4424, 0.0}));
  EXPECT_THAT(values(output, "total"), testing::Pointwise(testing::DoubleNear(0.06), {0.5576, 0.4424, 0.2437}));
}

TEST_F(SensitivityCommand, SaysHowManyRowsAreMissing) {
  (void)runFidelis({"sensitivity", "design", ishigamiParameters(), "--n", "8", "--out", path("design.csv")});
  const std::string outputs = folder_.write("outputs.csv", "y\n1\n2\n3\n").string();
  const ProgramRun run = runFidelis({"sensitivity", "analyze", path("design.csv"), outputs, "--column", "y"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.messages, HasSubstr("has 3 rows"));
  EXPECT_THAT(run.messages, HasSubstr("has 40"));
}

TEST_F(SensitivityCommand, SaysWhereADesignIsOutOfOrder) {
  const std::string outputs = folder_.write("outputs.csv", "y\n1\n2\n3\n4\n5\n6\n").string();
  const auto messageFor = [&](const std::string& rows) {
    const std::string design = folder_.write("design.csv", "block,curve,x\n" + rows).string();
    const ProgramRun run = runFidelis({"sensitivity", "analyze", design, outputs, "--column", "y"});
    EXPECT_EQ(run.status, 2);
    return run.messages;
  };
  EXPECT_THAT(messageFor("A,1,0\nA,1,1\nx,1,0\nx,1,1\nB,1,0\nB,1,1\n"), HasSubstr("design.csv:4"));
  EXPECT_THAT(messageFor("A,1,0\nA,1,1\nB,1,0\nB,1,1\nx,1,0\n"), HasSubstr("has 5 rows"));
  EXPECT_THAT(messageFor(""), HasSubstr("no rows"));
}

/// The demo's range sweep: a Lambertian board, so its echo weakens with reflectivity and fog.
class SensitivityOfTheLidar : public SensitivityCommand {
 protected:
  ProgramRun run(std::vector<std::string> options) {
    const std::filesystem::path demo = test_support::sourceFolder() / "resources" / "demo";
    std::vector<std::string> words{"sensitivity",
                                   "run",
                                   (demo / "range-sweep").string(),
                                   "--model",
                                   (demo / "model.json").string(),
                                   "--sample",
                                   "r10",
                                   "--n",
                                   "8"};
    words.insert(words.end(), options.begin(), options.end());
    return runFidelis(words);
  }
};

// Where the board stands decides what range is measured; how grey it is does not.
TEST_F(SensitivityOfTheLidar, RangeIsThatOfTheTarget) {
  const ProgramRun result = run({"--column", "range_m", "--vary", "/scene/0/pose/position_m/0=8:12", "--vary",
                                 "/materials/grey-board/reflectivity=0.3:0.9", "--json", "-"});
  ASSERT_EQ(result.status, 0) << result.messages;
  const json document = json::parse(result.out);
  EXPECT_EQ(document.at("runs"), 32);
  const json& mean = document.at("outputs").at(0);
  EXPECT_EQ(mean.at("sample"), "r10");
  EXPECT_EQ(mean.at("column"), "range_m");
  EXPECT_EQ(mean.at("statistic"), "mean");
  EXPECT_NEAR(mean.at("mean").get<double>(), 10.0, 0.5);
  EXPECT_GT(values(mean, "total").at(0), 0.5);
  EXPECT_NEAR(values(mean, "total").at(1), 0.0, 0.01);
}

// The model names its profile; a number of the profile can be varied all the same. A stronger pulse is a wider echo.
TEST_F(SensitivityOfTheLidar, ANumberOfANamedProfileCanBeVaried) {
  const ProgramRun result =
      run({"--column", "epw_m", "--vary", "/sensor/emitter/peak_power_w=20:60", "--replicates", "0", "--json", "-"});
  ASSERT_EQ(result.status, 0) << result.messages;
  EXPECT_GT(values(json::parse(result.out).at("outputs").at(0), "total").at(0), 0.5);
}

TEST_F(SensitivityOfTheLidar, IsTheSameForAnyNumberOfThreads) {
  const std::vector<std::string> options{"--column", "epw_m", "--vary", "/materials/grey-board/reflectivity=0.1:0.9",
                                         "--json",   "-"};
  std::vector<std::string> one = options;
  one.insert(one.end(), {"--threads", "1"});
  const ProgramRun first = run(one);
  EXPECT_EQ(first.out, run(options).out);
}

TEST_F(SensitivityOfTheLidar, SaysWhatCannotBeVaried) {
  const auto messageFor = [this](const std::string& vary) {
    const ProgramRun result = run({"--column", "range_m", "--vary", vary});
    EXPECT_EQ(result.status, 2);
    return result.messages;
  };
  EXPECT_THAT(messageFor("/materials/white-board/reflectivity=0.1:0.2"), HasSubstr("/materials/white-board"));
  EXPECT_THAT(messageFor("/effects/fog-attenuation/visibility_m=100:200"), HasSubstr("Switch the effect on"));
  EXPECT_THAT(messageFor("/effects/beam-divergence/no_such=1:2"), HasSubstr("no_such"));
  EXPECT_THAT(messageFor("/sensor/emitter/no_such=1:2"), HasSubstr("Name a number below /sensor"));
  EXPECT_THAT(messageFor("/gates/0/margin_m=1:2"), HasSubstr("where nothing can be varied"));
  EXPECT_THAT(messageFor("/environment/visibility_m=100"), HasSubstr("POINTER=LOW:HIGH"));
  EXPECT_THAT(messageFor("/environment/visibility_m=200:100"), HasSubstr("range 200 to 100"));
}

TEST_F(SensitivityOfTheLidar, ShowsATableWithoutJson) {
  const ProgramRun result =
      run({"--column", "range_m", "--gate", "board", "--vary", "/scene/0/pose/position_m/0=9.9:10.1"});
  EXPECT_EQ(result.status, 0) << result.messages;
  EXPECT_THAT(result.out, HasSubstr("r10: range_m, mean"));
  EXPECT_THAT(result.out, HasSubstr("/scene/0/pose/position_m/0"));
}

}  // namespace
