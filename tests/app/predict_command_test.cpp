#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "core/csv.h"
#include "core/file.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

// `fidelis predict` as scripts see it: files in, JSON or a table out, exit status.
namespace {

using nlohmann::json;
using test_support::ProgramRun;
using test_support::runFidelis;
using test_support::TemporaryFolder;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class PredictCommand : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& content) {
    return folder_.write(name, content).string();
  }
  std::string path(const std::string& name) { return (folder_ / name).string(); }

  /// Pulse width errors of Rosenberger 2023, ch. 10: three ranges.
  std::string published() {
    return file("published.csv", "range_m,d_bias,d_cavm\n9.984,0.027,0.022\n14.995,0.028,0.019\n19.865,0.038,0.005\n");
  }
  /// d_bias = 0.01 range - 0.02 angle without noise; one row of each role beside the validation rows.
  std::string plane() {
    return file("plane.csv",
                "setup,role,range_m,angle_deg,d_bias\n"
                "a,validation,10,0,0.1\nb,validation,20,5,0.1\nc,validation,30,0,0.3\nd,validation,40,10,0.2\n"
                "e,validation,25,8,0.09\nf,calibration,50,0,9\ng,prediction,30,5,0.2\n");
  }

  TemporaryFolder folder_;
};

json documentOf(const ProgramRun& run) {
  EXPECT_EQ(run.status, 0) << run.messages;
  return json::parse(run.out);
}

// The published line: .028 (.061) for the bias and .020 (.055) for the scatter at 12.436 m. Bounds from inputs in
// millimetres: with one degree of freedom the rounding alone moves that of the scatter by several millimetres.
TEST_F(PredictCommand, PublishedTableIsReproduced) {
  const json document = documentOf(runFidelis(
      {"predict", published(), "--over", "range_m", "--family", "linear", "--at", "range_m=12.436", "--json", "-"}));
  EXPECT_EQ(document.at("format"), "fidelis-predict");
  EXPECT_EQ(document.at("version"), 1);
  EXPECT_EQ(document.at("source").at("sha256").get<std::string>(), core::sha256OfFile(path("published.csv")));
  const json& bias = document.at("predictions").at(0);
  EXPECT_EQ(bias.at("target"), "d_bias");
  EXPECT_EQ(bias.at("family"), "linear");
  EXPECT_EQ(bias.at("bounds"), "exact");
  EXPECT_EQ(bias.at("n"), 3);
  EXPECT_EQ(bias.at("dof"), 1);
  EXPECT_EQ(bias.at("coefficients").at(1).at("name"), "range_m");
  EXPECT_EQ(bias.at("domain").at("ranges").at(0).at("max"), 19.865);
  const json& query = document.at("queries").at(0);
  EXPECT_EQ(query.at("at").at("range_m"), 12.436);
  EXPECT_EQ(query.at("extrapolation"), false);
  const json& at = query.at("errors").at("d_bias");
  EXPECT_NEAR(at.at("value").get<double>(), 0.028, 0.0005);
  EXPECT_NEAR(at.at("largest").get<double>(), 0.061, 0.001);
  EXPECT_NEAR(at.at("observation").at(1).get<double>(), 0.086, 0.001);
  EXPECT_NEAR(query.at("errors").at("d_cavm").at("value").get<double>(), 0.020, 0.0005);
  EXPECT_EQ(query.at("errors").at("d_cavm").at("confidence").at(0), 0.0);  // never negative
}

TEST_F(PredictCommand, RolesDecideWhatIsLearntAndWhatIsChecked) {
  const ProgramRun run =
      runFidelis({"predict", plane(), "--over", "range_m,angle_deg", "--family", "linear", "--json", "-"});
  const json document = documentOf(run);
  const json& prediction = document.at("predictions").at(0);
  EXPECT_EQ(prediction.at("n"), 5);
  EXPECT_NEAR(prediction.at("coefficients").at(1).at("value").get<double>(), 0.01, 1e-12);
  EXPECT_NEAR(prediction.at("coefficients").at(2).at("value").get<double>(), -0.02, 1e-12);
  EXPECT_EQ(prediction.at("held_out").at("n"), 1);
  EXPECT_NEAR(prediction.at("held_out").at("largest_miss").get<double>(), 0.0, 1e-12);
  EXPECT_NEAR(prediction.at("held_out").at("skill_over_none").get<double>(), 1.0, 1e-9);
  EXPECT_EQ(document.at("left_out").at(0).at("where"), "line 7");
  EXPECT_THAT(run.messages, HasSubstr("line 7 is left out: the model was fitted to it"));
}

TEST_F(PredictCommand, ExtrapolationNamesTheParameter) {
  const json document =
      documentOf(runFidelis({"predict", plane(), "--over", "range_m,angle_deg", "--family", "linear", "--at",
                             "angle_deg=11,range_m=20", "--at", "range_m=25,angle_deg=5", "--json", "-"}));
  EXPECT_EQ(document.at("queries").at(0).at("extrapolation"), true);
  EXPECT_THAT(document.at("queries").at(0).at("outside"), ElementsAre("angle_deg"));
  EXPECT_EQ(document.at("queries").at(1).at("extrapolation"), false);
}

TEST_F(PredictCommand, AutoSaysWhatItTriedAndWhyNot) {
  const json candidates = documentOf(runFidelis({"predict", published(), "--over", "range_m", "--json", "-"}))
                              .at("predictions")
                              .at(0)
                              .at("candidates");
  ASSERT_EQ(candidates.size(), 5u);
  EXPECT_TRUE(candidates.at(1).at("score").is_number());
  EXPECT_TRUE(candidates.at(2).at("score").is_null());
  EXPECT_THAT(candidates.at(2).at("reason").get<std::string>(), HasSubstr("2 rows are too few"));
}

// Saved numbers read back as the same doubles.
TEST_F(PredictCommand, SavedPredictionAnswersTheSame) {
  std::string curve = "range_m,d_bias\n";
  for (int i = 0; i < 12; ++i) {
    curve += std::to_string(3 * i) + "," + std::to_string(0.4 * std::exp(-0.09 * i * 3) + 0.01 * (i % 3)) + "\n";
  }
  const std::string results = file("curve.csv", curve);
  const std::string saved = path("prediction.json");
  const std::vector<std::string> at{"--at", "range_m=4.25", "--at", "range_m=100"};
  std::vector<std::string> learn{"predict", results, "--over", "range_m", "--family", "exponential", "--save", saved};
  std::vector<std::string> ask{"predict", "--with", saved, "--json", "-"};
  learn.insert(learn.end(), at.begin(), at.end());
  ask.insert(ask.end(), at.begin(), at.end());
  EXPECT_EQ(runFidelis(learn).status, 0);
  const json again = documentOf(runFidelis(ask));
  EXPECT_EQ(again.at("queries").dump(), json::parse(core::readFile(saved)).at("queries").dump());
  EXPECT_EQ(again.at("predictions").at(0).at("bounds"), "approximate");
  const json wider =
      documentOf(runFidelis({"predict", "--with", saved, "--level", "0.99", "--at", "range_m=4.25", "--json", "-"}));
  EXPECT_GT(wider.at("queries").at(0).at("errors").at("d_bias").at("confidence").at(1).get<double>(),
            again.at("queries").at(0).at("errors").at("d_bias").at("confidence").at(1).get<double>());
}

TEST_F(PredictCommand, SavedPredictionIsCheckedOnRowsOfAnotherFile) {
  const std::string saved = path("prediction.json");
  EXPECT_EQ(
      runFidelis({"predict", plane(), "--over", "range_m,angle_deg", "--family", "linear", "--save", saved}).status, 0);
  const std::string more =
      file("more.csv", "angle_deg,range_m,d_bias,role\n5,20,0.1,validation\n0,30,1.3,calibration\n");
  const json check = documentOf(runFidelis({"predict", "--with", saved, "--held-out", more, "--json", "-"}))
                         .at("predictions")
                         .at(0)
                         .at("held_out");
  EXPECT_EQ(check.at("n"), 2);
  EXPECT_EQ(check.at("covered"), 1);
  EXPECT_NEAR(check.at("largest_miss").get<double>(), 1.0, 1e-12);
}

TEST_F(PredictCommand, QueriesMayComeFromAFile) {
  const std::string queries = file("queries.csv", "name,range_m\nx,10\ny,15\n");
  const json document = documentOf(runFidelis(
      {"predict", published(), "--over", "range_m", "--family", "linear", "--at-file", queries, "--json", "-"}));
  ASSERT_EQ(document.at("queries").size(), 2u);
  EXPECT_EQ(document.at("queries").at(1).at("at").at("range_m"), 15.0);
}

TEST_F(PredictCommand, ReportOfAcceptIsAnotherSource) {
  const std::string report = file("report.json", R"({"format": "fidelis-acceptance", "version": 1, "tests": [
    {"id": "A_1", "samples": []},
    {"id": "A_2", "measurand": "epw", "unit": "m", "column": "epw_m", "samples": [
      {"id": "r10", "parameters": {"range_m": 10}, "values": {"d_bias": 0.1, "d_cavm": 0.2}},
      {"id": "r20", "parameters": {"range_m": 20}, "values": {"d_bias": 0.2, "d_cavm": 0.2}},
      {"id": "r25", "parameters": {"range_m": 25}, "values": {"d_bias": null, "d_cavm": null}},
      {"id": "r30", "parameters": {"range_m": 30}, "values": {"d_bias": 0.3, "d_cavm": 0.2}}]}]})");
  const ProgramRun run = runFidelis({"predict", report, "--test", "A_2", "--over", "range_m", "--json", "-"});
  const json document = documentOf(run);
  EXPECT_EQ(document.at("measurand"), (json{{"name", "epw"}, {"column", "epw_m"}, {"unit", "m"}}));
  EXPECT_EQ(document.at("predictions").at(0).at("n"), 3);
  EXPECT_EQ(document.at("predictions").at(0).at("family"), "linear");
  EXPECT_NEAR(document.at("predictions").at(0).at("coefficients").at(1).at("value").get<double>(), 0.01, 1e-14);
  EXPECT_EQ(document.at("predictions").at(1).at("family"), "constant");
  EXPECT_THAT(run.messages, HasSubstr("r25 is left out: a value is undefined"));
  const ProgramRun unnamed = runFidelis({"predict", report, "--over", "range_m"});
  EXPECT_EQ(unnamed.status, 2);
  EXPECT_THAT(unnamed.messages, HasSubstr("one test must be named; the report has 2"));
  EXPECT_THAT(runFidelis({"predict", report, "--test", "A_3", "--over", "range_m"}).messages,
              HasSubstr("the report has no test 'A_3'"));
  EXPECT_THAT(runFidelis({"predict", report, "--test", "A_2", "--over", "rnge_m"}).messages,
              HasSubstr("Did you mean 'range_m'?"));
}

TEST_F(PredictCommand, TableShowsFunctionBoundsAndRemarks) {
  const ProgramRun run = runFidelis({"predict", published(), "--over", "range_m", "--family", "linear", "--at",
                                     "range_m=12.436", "--at", "range_m=30"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("d_bias over range_m: linear, n = 3, 1 degrees of freedom"));
  EXPECT_THAT(run.out, ContainsRegex("intercept +[-0-9.e]+ \\+- "));
  EXPECT_THAT(run.out, ContainsRegex("range_m=12.436 +d_bias +0.028"));
  EXPECT_THAT(run.out, ContainsRegex("range_m=30 .*outside range_m"));
  EXPECT_THAT(run.messages, IsEmpty());
}

TEST_F(PredictCommand, SharedSetupsAreRemarkedUnlessQuiet) {
  const std::string results =
      file("shared.csv", "setup,range_m,d_bias\na,1,0.1\na,2,0.2\nb,3,0.3\nb,4,0.5\nc,5,0.5\nc,6,0.6\n");
  const std::vector<std::string> words{"predict", results, "--over", "range_m"};
  EXPECT_THAT(runFidelis(words).messages, HasSubstr("6 rows are of 3 set-ups"));
  std::vector<std::string> quiet = words;
  quiet.insert(quiet.begin(), "--quiet");
  EXPECT_THAT(runFidelis(quiet).messages, IsEmpty());
}

TEST_F(PredictCommand, WithoutDegreesOfFreedomBoundsAreNullAndSaidToBe) {
  const std::string two = file("two.csv", "range_m,d_bias\n1,0.1\n2,0.2\n");
  const std::vector<std::string> words{"predict",  two,      "--over", "range_m",
                                       "--family", "linear", "--at",   "range_m=1.5"};
  EXPECT_THAT(runFidelis(words).out, HasSubstr("no degrees of freedom"));
  std::vector<std::string> as_json = words;
  as_json.insert(as_json.end(), {"--json", "-"});
  const json document = documentOf(runFidelis(as_json));
  EXPECT_EQ(document.at("predictions").at(0).at("bounds"), "none");
  EXPECT_TRUE(document.at("predictions").at(0).at("residual_sd").is_null());
  EXPECT_TRUE(document.at("queries").at(0).at("errors").at("d_bias").at("confidence").at(0).is_null());
}

TEST_F(PredictCommand, BadInputEndsWithStatusTwoAndSaysWhere) {
  const auto expectError = [](const std::vector<std::string>& more, const std::vector<std::string>& told) {
    std::vector<std::string> words{"predict"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun run = runFidelis(words);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.out, IsEmpty());
    for (const std::string& text : told) EXPECT_THAT(run.messages, HasSubstr(text));
  };
  const std::string good = published();
  const std::string gap = file("gap.csv", "range_m,d_bias\n1,0.1\n2,nan\n");
  const std::string negative = file("negative.csv", "range_m,d_cavm\n1,0.1\n2,-0.1\n");
  const std::string role = file("role.csv", "range_m,d_bias,role\n1,0.1,validaton\n");
  const std::string copies =
      file("copies.csv", "range_m,range_cm,d_bias\n1,100,0.1\n2,200,0.3\n3,300,0.2\n4,400,0.1\n");
  const std::string saved = path("saved.json");
  EXPECT_EQ(runFidelis({"predict", good, "--over", "range_m", "--save", saved}).status, 0);
  expectError({good, "--over", "rnge_m"}, {"published.csv:1: has no column 'rnge_m'", "Did you mean 'range_m'?"});
  expectError({good, "--over", "range_m", "--for", "d_bais"}, {"Did you mean 'd_bias'?"});
  expectError({good, "--over", "range_m", "--setup", "site"}, {"has no column 'site'"});
  expectError({path("absent.csv"), "--over", "range_m"}, {"absent.csv"});
  expectError({file("header.csv", "range_m,d_bias\n"), "--over", "range_m"}, {"header.csv: has no sample"});
  expectError({file("names.csv", "range_m,x\n1,2\n"), "--over", "range_m"}, {"neither a column 'd_bias' nor 'd_cavm'"});
  expectError({gap, "--over", "range_m"}, {"gap.csv:3, column 'd_bias': 'nan' is not a finite number"});
  expectError({negative, "--over", "range_m"}, {"negative.csv:3", "d_cavm never is"});
  expectError({role, "--over", "range_m"}, {"role.csv:2, column 'role': 'validaton' is no role"});
  expectError({copies, "--over", "range_m,range_cm", "--family", "linear"},
              {"copies.csv, range_cm: follows from range_m", "collinear"});
  expectError({good, "--over", "range_m", "--family", "quadratc"}, {"--family"});
  expectError({good, "--over", "range_m", "--family", "sigmoid"}, {"4 coefficients; 3 rows are too few"});
  expectError({good, "--over", "range_m", "--at", "rang_m=3"}, {"'rang_m' is no parameter", "Did you mean 'range_m'?"});
  expectError({good, "--over", "range_m", "--at", "range_m=far"}, {"'range_m=far' gives no finite number"});
  expectError({good, "--over", "range_m", "--at", "range_m=1,range_m=2"}, {"'range_m' is given twice"});
  expectError({plane(), "--over", "range_m,angle_deg", "--at", "range_m=1"}, {"'angle_deg' is missing"});
  expectError({good}, {"--over: is missing"});
  expectError({}, {"either RESULTS or --with"});
  expectError({good, "--with", saved, "--over", "range_m"}, {"either RESULTS or --with"});
  expectError({"--with", saved}, {"a saved prediction is there to be asked"});
  expectError({"--with", file("other.json", R"({"format": "fidelis-metric", "version": 1})"), "--at", "range_m=1"},
              {"'fidelis-predict' was expected"});
  std::string broken = core::readFile(saved);
  broken.replace(broken.find("\"scale\": [") + 10, 0, "1.0,");
  expectError({"--with", file("broken.json", broken), "--at", "range_m=1"}, {"/predictions/0/curve/scale"});
}

TEST_F(PredictCommand, NumberOfThreadsDoesNotChangeABit) {
  const std::string results = published();
  const auto bytes = [&](const char* threads) {
    return runFidelis({"--threads", threads, "predict", results, "--over", "range_m", "--json", "-"}).out;
  };
  EXPECT_EQ(bytes("1"), bytes("2"));
  EXPECT_THAT(bytes("1"), Not(IsEmpty()));
}

// Boxes (--simulated) --------------------------------------------------------------------------------------------

class PredictedBoxes : public PredictCommand {
 protected:
  /// Learns a constant of every error and saves it. Ranges 10, 20, 30 m.
  std::string saved(const std::string& targets, const std::string& rows) {
    const std::string results = file("results.csv", "range_m," + targets + "\n" + rows);
    const ProgramRun run = runFidelis({"predict", results, "--over", "range_m", "--for", targets, "--family",
                                       "constant", "--save", path("prediction.json")});
    EXPECT_EQ(run.status, 0) << run.messages;
    return path("prediction.json");
  }
  /// Two runs; the second lies 0.25 to the right.
  std::vector<std::string> simulated() {
    return {file("sim-1.csv", "range_m\n40.5\n40\n41\n42\n"),
            file("sim-2.csv", "range_m\n40.75\n40.25\n41.25\n42.25\n")};
  }
  ProgramRun ask(const std::string& saved, const std::vector<std::string>& more) {
    std::vector<std::string> words{"predict",    "--with",   saved,     "--at",
                                   "range_m=25", "--column", "range_m", "--simulated"};
    for (const std::string& sim : simulated()) words.push_back(sim);
    words.insert(words.end(), more.begin(), more.end());
    return runFidelis(words);
  }
  json boxes(const std::string& saved, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--json", "-"});
    return documentOf(ask(saved, more)).at("boxes");
  }
};

/// The box is the simulated one with its left edge moved by `left` and its right edge by `right`.
void expectMoved(const json& boxes, const std::string& name, double left, double right) {
  const std::vector<double> levels{0.05, 0.25, 0.5, 0.75, 0.95};
  const std::vector<double> values{40.0, 40.0, 40.5, 41.0, 42.0};  // of the first run; the second is 0.25 higher
  const json& box = boxes.at(name);
  ASSERT_EQ(box.at("quantiles").size(), levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const json& quantile = box.at("quantiles").at(i);
    EXPECT_EQ(quantile.at("level"), levels[i]);
    EXPECT_NEAR(quantile.at("interval").at(0).get<double>(), values[i] + left, 1e-12) << name;
    EXPECT_NEAR(quantile.at("interval").at(1).get<double>(), values[i] + 0.25 + right, 1e-12) << name;
  }
  EXPECT_NEAR(box.at("mean").at(0).get<double>(), 40.875 + left, 1e-12) << name;
  EXPECT_NEAR(box.at("mean").at(1).get<double>(), 41.125 + right, 1e-12) << name;
  EXPECT_NEAR(box.at("width").get<double>(), 0.25 + right - left, 1e-12) << name;
}

// Of three samples a constant has 2 degrees of freedom, whose quantile has a closed form: (2p - 1) / sqrt(2 p (1 - p)).
const double kStudent2 = 0.95 / std::sqrt(2.0 * 0.975 * 0.025);

TEST_F(PredictedBoxes, KnownOffsetIsTakenAway) {
  const json all = boxes(saved("d_bias,d_cavm", "10,0.1,0\n20,0.1,0\n30,0.1,0\n"));
  expectMoved(all, "simulated", 0.0, 0.0);
  expectMoved(all, "expected", -0.1, -0.1);
  expectMoved(all, "bound", -0.1, -0.1);  // three samples agree: nothing is left uncertain
  EXPECT_EQ(all.at("extrapolation"), false);
  EXPECT_EQ(all.at("n_sim"), json({4, 4}));
  EXPECT_FALSE(all.contains("total"));
  EXPECT_TRUE(all.at("model_form").is_null());
}

TEST_F(PredictedBoxes, ScatterWidensTheExpectedBoxOnBothSides) {
  expectMoved(boxes(saved("d_bias,d_cavm", "10,-0.1,0.02\n20,-0.1,0.02\n30,-0.1,0.02\n")), "expected", 0.08, 0.12);
}

// Mean 0.2, standard deviation 0.1: the mean is known to t s / sqrt(3), one more sample to t s sqrt(4 / 3).
TEST_F(PredictedBoxes, BoundTakesTheErrorsAtTheirBounds) {
  const std::string prediction = saved("d_bias,d_cavm", "10,0.1,0.05\n20,0.2,0.05\n30,0.3,0.05\n");
  const double mean = kStudent2 * 0.1 / std::sqrt(3.0);
  const double one_more = kStudent2 * 0.1 * std::sqrt(4.0 / 3.0);
  expectMoved(boxes(prediction), "bound", -0.2 - mean - 0.05, -0.2 + mean + 0.05);
  const json wider = boxes(prediction, {"--bounds", "observation"});
  expectMoved(wider, "bound", -0.2 - one_more - 0.05, -0.2 + one_more + 0.05);
  expectMoved(wider, "expected", -0.25, -0.15);
  EXPECT_EQ(wider.at("bounds"), "observation");
}

TEST_F(PredictedBoxes, AggregatedEdgesMoveByTheirPartsExactly) {
  const std::string prediction = saved("d_plus,d_minus", "10,0.01,0.1\n20,0.01,0.1\n30,0.01,0.1\n");
  const ProgramRun run = ask(prediction, {"--numerical", "0.002", "--json", "-"});
  const json all = documentOf(run).at("boxes");
  expectMoved(all, "with_model_form", -0.1, 0.01);
  expectMoved(all, "total", -0.102, 0.012);
  EXPECT_EQ(all.at("model_form").at("of"), "portions");
  EXPECT_NEAR(all.at("model_form").at("below").get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(all.at("model_form").at("above").get<double>(), 0.01, 1e-12);
  EXPECT_EQ(all.at("numerical"), 0.002);
  EXPECT_FALSE(all.contains("expected"));
  EXPECT_EQ(all.at("left_out").at(0).at("box"), "expected");
  EXPECT_THAT(run.messages, HasSubstr("'expected' is left out: d_bias and d_cavm are not predicted"));
  EXPECT_THAT(run.messages, HasSubstr("--for d_minus,d_plus,d_bias,d_cavm"));
}

TEST_F(PredictedBoxes, AreaIsAppendedOnBothSidesOnRequest) {
  const std::string prediction = saved("d_bias,d_cavm,d_avm", "10,0,0,1.1\n20,0,0,1.2\n30,0,0,1.3\n");
  const double most = 1.2 + kStudent2 * 0.1 * std::sqrt(4.0 / 3.0);
  expectMoved(boxes(prediction, {"--model-form", "area"}), "total", -most, most);
  const ProgramRun unasked = ask(prediction, {});
  EXPECT_THAT(unasked.out, Not(HasSubstr("total")));
  EXPECT_THAT(unasked.messages, HasSubstr("d_plus and d_minus are not predicted"));
  EXPECT_THAT(unasked.messages, HasSubstr("--model-form area"));
}

TEST_F(PredictedBoxes, TableShowsEveryBoxAndMarksExtrapolation) {
  const std::string prediction =
      saved("d_bias,d_cavm,d_plus,d_minus", "10,0.5,0,0,0.5\n20,0.5,0,0,0.5\n30,0.5,0,0,0.5\n");
  const std::string sim = file("sim.csv", "range_m\n50\n52\n");
  const std::vector<std::string> words{"predict", "--with",   prediction, "--at",        "range_m=50", "--simulated",
                                       sim,       "--column", "range_m",  "--numerical", "0.25"};
  const ProgramRun run = runFidelis(words);
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(run.out, HasSubstr("Boxes of range_m at range_m=50, extrapolated: outside range_m"));
  EXPECT_THAT(run.out, ContainsRegex("simulated +expected +bound +with model form +total"));
  EXPECT_THAT(run.out, ContainsRegex("75 % +52 +51.5 +51.5 +\\[51.5, 52\\] +\\[51.25, 52.25\\]"));
  EXPECT_THAT(run.out, ContainsRegex("mean +51 +50.5 "));
  EXPECT_THAT(run.out, HasSubstr("model form: 0.5 below, 0 above: 95 % bounds of one more sample; numerical: 0.25"));
  EXPECT_THAT(run.messages, IsEmpty());
  std::vector<std::string> as_json = words;
  as_json.insert(as_json.end(), {"--json", "-"});
  const json document = documentOf(runFidelis(as_json));
  EXPECT_EQ(document.at("boxes").at("extrapolation"), true);
  EXPECT_THAT(document.at("boxes").at("outside"), ElementsAre("range_m"));
  EXPECT_EQ(document.at("source").at("simulated").at(0).at("sha256").get<std::string>(), core::sha256OfFile(sim));
}

// Runs of 2 and 4 values: the edges step at 1/4, 1/2, 3/4 and 1.
TEST_F(PredictedBoxes, EdgesAreWrittenAtEveryStep) {
  const std::string prediction = saved("d_bias,d_cavm", "10,0.5,0.25\n20,0.5,0.25\n30,0.5,0.25\n");
  const ProgramRun run = runFidelis({"predict", "--with", prediction, "--at", "range_m=25", "--column", "range_m",
                                     "--simulated", file("two.csv", "range_m\n1\n2\n"),
                                     file("four.csv", "range_m\n1\n3\n4\n5\n"), "--box-csv", path("edges.csv")});
  EXPECT_EQ(run.status, 0) << run.messages;
  EXPECT_THAT(
      core::readFile(path("edges.csv")),
      testing::StartsWith("p,simulated_left,simulated_right,expected_left,expected_right,bound_left,bound_right\n"
                          "0.25,1,1,"));
  const auto columns = core::readNumericColumns(
      path("edges.csv"),
      std::vector<std::string>{"p", "simulated_left", "simulated_right", "expected_left", "expected_right"});
  EXPECT_THAT(columns[0], ElementsAre(0.25, 0.5, 0.75, 1.0));
  EXPECT_THAT(columns[1], ElementsAre(1.0, 1.0, 2.0, 2.0));
  EXPECT_THAT(columns[2], ElementsAre(1.0, 3.0, 4.0, 5.0));
  // The fitted constants are means, rounded.
  const auto near = [](double value) { return testing::DoubleNear(value, 1e-12); };
  EXPECT_THAT(columns[3], ElementsAre(near(0.25), near(0.25), near(1.25), near(1.25)));
  EXPECT_THAT(columns[4], ElementsAre(near(0.75), near(2.75), near(3.75), near(4.75)));
}

TEST_F(PredictedBoxes, WithoutDegreesOfFreedomThereIsNoBound) {
  const std::string prediction = saved("d_bias,d_cavm,d_plus,d_minus", "20,0.1,0,0,0.1\n");
  const ProgramRun run = ask(prediction, {"--json", "-"});
  const json all = documentOf(run).at("boxes");
  expectMoved(all, "expected", -0.1, -0.1);
  EXPECT_FALSE(all.contains("bound"));
  EXPECT_FALSE(all.contains("total"));
  EXPECT_THAT(run.messages, HasSubstr("'bound' is left out"));
  EXPECT_THAT(run.messages, HasSubstr("'total' is left out"));
  EXPECT_THAT(run.messages, HasSubstr("no degrees of freedom"));
}

TEST_F(PredictedBoxes, SavedWithAPredictionTheyDoNotDisturbIt) {
  const std::string prediction = saved("d_bias,d_cavm", "10,0.1,0\n20,0.1,0\n30,0.1,0\n");
  EXPECT_EQ(ask(prediction, {"--save", path("again.json")}).status, 0);
  EXPECT_EQ(boxes(path("again.json")).dump(), boxes(prediction).dump());
}

TEST_F(PredictedBoxes, WhatIsMissingOrWrongIsNamed) {
  const auto expectError = [](const ProgramRun& run, const std::vector<std::string>& told) {
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.out, IsEmpty());
    for (const std::string& text : told) EXPECT_THAT(run.messages, HasSubstr(text));
  };
  const std::string sim = simulated().front();
  std::string prediction = saved("d_bias,d_cavm", "10,0.1,0\n20,0.1,0\n30,0.1,0\n");
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"predict", "--with", prediction};
    words.insert(words.end(), more.begin(), more.end());
    return runFidelis(words);
  };
  expectError(ask(prediction, {"--numerical", "-0.1"}), {"--numerical"});
  expectError(ask(prediction, {"--bounds", "both"}), {"--bounds"});
  expectError(ask(prediction, {"--at", "range_m=26"}), {"exactly one --at"});
  expectError(run({"--held-out", path("results.csv"), "--simulated", sim, "--column", "range_m"}),
              {"exactly one --at"});
  expectError(run({"--at", "range_m=25", "--simulated", sim}), {"--column: is missing"});
  expectError(run({"--at", "range_m=25", "--column", "range_m"}), {"--simulated"});
  expectError(run({"--at", "range_m=25", "--simulated", sim, "--column", "rang_m"}),
              {"sim-1.csv", "Did you mean 'range_m'?"});
  expectError(run({"--at", "range_m=25", "--simulated", file("none.csv", "range_m\n"), "--column", "range_m"}),
              {"none.csv: has a header and no rows"});
  prediction = saved("d_bias", "10,0.1\n20,0.1\n30,0.1\n");
  expectError(ask(prediction, {}), {"d_cavm is not predicted", "--for d_bias,d_cavm", "d_plus and d_minus are not"});
  expectError(ask(prediction, {"--numerical", "0.1"}), {"--numerical", "d_plus and d_minus are not predicted"});
  expectError(ask(prediction, {"--model-form", "area"}), {"--model-form area", "d_avm is not predicted"});
}

}  // namespace
