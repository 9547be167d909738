#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/paths.h"
#include "tests/support/program.h"

// `fidelis validity` as scripts see it: files in, JSON or a table out, exit status.
namespace {

using nlohmann::json;
using test_support::ProgramRun;
using test_support::runFidelis;
using test_support::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ValidityCommand : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& content) {
    return folder_.write(name, content).string();
  }

  static ProgramRun run(std::vector<std::string> words, const std::vector<std::string>& more = {}) {
    words.insert(words.begin(), "validity");
    words.insert(words.end(), more.begin(), more.end());
    return runFidelis(words);
  }

  static json documentOf(const ProgramRun& done, int status = 0) {
    EXPECT_EQ(done.status, status) << done.messages;
    const json document = json::parse(done.out);
    EXPECT_EQ(document.at("format"), "fidelis-validity");
    EXPECT_EQ(document.at("version"), 1);
    EXPECT_TRUE(document.contains("source"));
    return document;
  }

  static void expectError(const ProgramRun& done, const std::vector<std::string>& told) {
    EXPECT_EQ(done.status, 2);
    EXPECT_THAT(done.out, IsEmpty());
    for (const std::string& text : told) EXPECT_THAT(done.messages, HasSubstr(text));
  }

 private:
  TemporaryFolder folder_;
};

// ---- labels

class ValidityLabels : public ValidityCommand {
 protected:
  /// Sample 'dry' repeats 1 to 5 (mean 3, s = sqrt(2.5)), 'rain' the same 100 higher; y is 10 x.
  std::string real() {
    std::string rows = "sample,x_m,y\n";
    for (int i = 1; i <= 5; ++i) rows += "dry," + std::to_string(i) + "," + std::to_string(10 * i) + "\n";
    for (int i = 1; i <= 5; ++i) rows += "rain," + std::to_string(100 + i) + "," + std::to_string(10 * i) + "\n";
    return file("real.csv", rows);
  }
  ProgramRun labels(const std::string& simulated, const std::vector<std::string>& more = {}) {
    return run({"labels", real(), file("sim.csv", simulated), "--column", "x_m"}, more);
  }
};

// The interval of 'dry' is 3 -+ t(4, 0.975) sqrt(2.5) sqrt(1.2) = 3 -+ 4.8091; one simulated value has an interval
// of width 0, which lies inside or not at all.
TEST_F(ValidityLabels, FollowTheToleranceIntervals) {
  const json document = documentOf(labels("sample,x_m\ndry,7.8\nrain,110\n", {"--json", "-"}));
  EXPECT_EQ(document.at("kind"), "labels");
  EXPECT_EQ(document.at("options").at("confidence"), 0.95);
  EXPECT_EQ(document.at("measurands").at(0), (json{{"name", "x_m"}, {"unit", "m"}}));
  EXPECT_EQ(document.at("counts"), (json{{"green", 1}, {"yellow", 0}, {"red", 0}, {"black", 1}}));
  const json dry = document.at("samples").at(0);
  EXPECT_EQ(dry.at("name"), "dry");
  EXPECT_EQ(dry.at("worst"), "green");
  const double half = 2.7764451051977987 * std::sqrt(2.5) * std::sqrt(1.2);
  EXPECT_NEAR(dry.at("labels").at(0).at("measured").at(0).get<double>(), 3.0 - half, 1e-9);
  EXPECT_NEAR(dry.at("labels").at(0).at("measured").at(1).get<double>(), 3.0 + half, 1e-9);
  EXPECT_EQ(dry.at("labels").at(0).at("n_real"), 5);
  EXPECT_EQ(dry.at("labels").at(0).at("n_sim"), 1);
  EXPECT_EQ(document.at("samples").at(1).at("labels").at(0).at("number"), 4);
}

TEST_F(ValidityLabels, MakeAMapWithWordsAndNumbers) {
  const ProgramRun done = run({"labels", real(), file("sim.csv", "sample,x_m,y\ndry,3,300\nrain,103,30\n")},
                              {"--column", "x_m", "--column", "y"});
  EXPECT_EQ(done.status, 0) << done.messages;
  EXPECT_THAT(done.out, testing::ContainsRegex("sample +x_m +y +worst"));
  EXPECT_THAT(done.out, testing::ContainsRegex("dry +1 green +4 black +4 black"));
  EXPECT_THAT(done.out, testing::ContainsRegex("rain +1 green +1 green +1 green"));
  EXPECT_THAT(done.out, HasSubstr("x_m [m]"));
  EXPECT_THAT(done.out, HasSubstr("3 green, 0 yellow, 0 red, 1 black"));
}

TEST_F(ValidityLabels, FollowTheThresholdsThatAreGiven) {
  const std::string half_outside = "sample,x_m\ndry,7.2\ndry,7.3\ndry,7.5\nrain,103\n";
  const auto labelOf = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return documentOf(labels(half_outside, words)).at("samples").at(0).at("worst").get<std::string>();
  };
  EXPECT_EQ(labelOf({}), "yellow");
  EXPECT_EQ(labelOf({"--yellow", "0.99"}), "red");
  EXPECT_EQ(labelOf({"--green", "0.5"}), "green");
}

// Two frames of three detections: means 2 and 4, as if the file held just these.
TEST_F(ValidityLabels, AverageTheRowsOfARepetition) {
  const std::string detections = file("detections.csv", "sample,frame,x_m\n7,0,1\n7,0,2\n7,0,3\n7,1,3\n7,1,4\n7,1,5\n");
  const std::string means = file("means.csv", "sample,frame,x_m\n7.0,0,2\n7.0,1,4\n");
  const auto cellOf = [&](const std::string& real) {
    return documentOf(run({"labels", real, means, "--repetition", "frame", "--column", "x_m", "--json", "-"}))
        .at("samples")
        .at(0)
        .at("labels")
        .at(0);
  };
  EXPECT_EQ(cellOf(detections).at("n_real"), 2);
  EXPECT_EQ(cellOf(detections), cellOf(means));
  const ProgramRun forgotten = run({"labels", detections, means, "--column", "x_m"});
  EXPECT_THAT(forgotten.messages, HasSubstr("give --repetition frame"));
  EXPECT_THAT(forgotten.out, testing::ContainsRegex("\\] +6 +\\["));
}

TEST_F(ValidityLabels, RefuseAMapWithHoles) {
  const std::string dry = file("dry.csv", "sample,x_m\ndry,3\n");
  expectError(run({"labels", real(), dry, "--column", "x_m"}),
              {"real.csv:7, sample 'rain': is not in", "dry.csv", "leaves nothing out silently"});
  expectError(labels("sample,x_m\ndry,3\nrian,3\n"), {"real.csv:7, sample 'rain'", "Is it 'rian' there?"});
  expectError(labels("smple,x_m\ndry,3\n"), {"sim.csv:1: has no column 'sample'", "Did you mean 'smple'?"});
  expectError(labels("sample,x_m\ndry,far\n"), {"sim.csv:2, column 'x_m': 'far' is not a finite number"});
  expectError(labels("sample,x_m\n,3\n"), {"sim.csv:2, column 'sample': is empty"});
  expectError(labels("sample,x_m\n"), {"sim.csv: has a header and no rows"});
  expectError(labels("sample,x_m\ndry,3\nrain,3\n", {"--yellow", "2"}), {"thresholds of labels"});
  expectError(labels("sample,x_m\ndry,3\nrain,3\n", {"--column", "x_m"}), {"--column x_m: is given twice"});
  expectError(labels("sample,x_m\ndry,3\nrain,3\n", {"--unit", "m", "--unit", "s"}), {"--unit: is given 2 times"});
  expectError(run({"labels", dry, dry, "--column", "x_m"}), {"dry.csv:2, sample 'dry': has a single repetition"});
}

// ---- gap

class ValidityGap : public ValidityCommand {
 protected:
  /// Level means (0.25 + 0.75)/2 and 0.1; gap 0.3.
  std::string levels() {
    return file("levels.csv",
                "level,metric,value,maximum,unit\nobjects,ospa,1,4,m\nclouds,wasserstein,0.2,2,m\n"
                "objects,1 - iou,0.75,1,\n");
  }
};

TEST_F(ValidityGap, IsTheMeanOfTheLevelsMeans) {
  const json document = documentOf(run({"gap", levels(), "--json", "-"}));
  EXPECT_EQ(document.at("kind"), "gap");
  EXPECT_DOUBLE_EQ(document.at("gap").get<double>(), 0.3);
  EXPECT_EQ(document.at("levels").at(0).at("name"), "objects");
  EXPECT_DOUBLE_EQ(document.at("levels").at(0).at("gap").get<double>(), 0.5);
  EXPECT_DOUBLE_EQ(document.at("levels").at(1).at("gap").get<double>(), 0.1);
  EXPECT_EQ(document.at("levels").at(0).at("metrics").at(1).at("scaled"), 0.75);
  EXPECT_EQ(document.at("levels").at(0).at("metrics").at(0).at("unit"), "m");
  const ProgramRun table = run({"gap", levels()});
  EXPECT_THAT(table.out, HasSubstr("gap (Ngo et al. 2021): 0.3"));
  EXPECT_THAT(table.out, testing::ContainsRegex("objects +0.5 +ospa +1 / 4 m +0.25"));
}

TEST_F(ValidityGap, ReadsTheSameFromJson) {
  const std::string same = file("levels.json", R"({"format": "fidelis-levels", "version": 1, "levels": [
    {"name": "objects", "metrics": [{"name": "ospa", "value": 1, "maximum": 4, "unit": "m"},
                                    {"name": "1 - iou", "value": 0.75, "maximum": 1}]},
    {"name": "clouds", "metrics": [{"name": "wasserstein", "value": 0.2, "maximum": 2, "unit": "m"}]}]})");
  json from_csv = documentOf(run({"gap", levels(), "--json", "-"}));
  json from_json = documentOf(run({"gap", same, "--json", "-"}));
  from_csv.erase("file");
  from_json.erase("file");
  EXPECT_EQ(from_csv, from_json);
}

TEST_F(ValidityGap, SaysWhichRowIsWrong) {
  const auto bad = [&](const std::string& row) {
    return run({"gap", file("bad.csv", "level,metric,value,maximum\nI,a,0,1\n" + row + "\n")});
  };
  expectError(bad("I,b,3,2"), {"bad.csv:3, level 'I', metric 'b': is 3, not between 0 and its maximum 2"});
  expectError(bad("I,b,1,0"), {"bad.csv:3", "has maximum 0; it must be positive"});
  expectError(bad("I,b,nan,1"), {"bad.csv:3"});
  expectError(bad("I,b,x,1"), {"bad.csv:3, column 'value': 'x' is not a number"});
  expectError(bad("I,a,1,1"), {"bad.csv:3: has metric 'a' twice at level 'I'"});
  expectError(bad(",b,1,1"), {"bad.csv:3, column 'level': is empty"});
  expectError(run({"gap", file("short.csv", "level,metric,value,max\nI,a,0,1\n")}), {"no column 'maximum'"});
  const auto json_file = [&](const std::string& level) {
    return file("bad.json", R"({"format": "fidelis-levels", "version": 1, "levels": [)" + level + "]}");
  };
  expectError(run({"gap", json_file(R"({"name": "I", "metrcs": []})")}), {"/levels/0", "metrics"});
  expectError(run({"gap", json_file(R"({"name": "I", "metrics": []})")}), {"/levels/0/metrics: gives no metric"});
  expectError(run({"gap", json_file(R"({"name": "I", "metrics": [{"name": "a", "value": -1, "maximum": 1}]})")}),
              {"/levels/0/metrics/0, level 'I', metric 'a': is -1"});
  expectError(run({"gap", json_file("")}), {"/levels: holds no level"});
}

// ---- tolerance

class ValidityTolerance : public ValidityCommand {
 protected:
  std::string real() { return file("real.csv", "time_s,x_m\n0,10\n1,21\n2,33.5\n3,40\n"); }
  std::string simulated() { return file("sim.csv", "time_s,x_m\n0,10\n1,20\n2,30\n3,40\n"); }
  ProgramRun tolerance(const std::vector<std::string>& more) {
    return run({"tolerance", real(), simulated(), "--over", "time_s", "--column", "x_m"}, more);
  }
};

// Around 30 the band of 10 % ends at 33, around 33.5 it begins at 30.15.
TEST_F(ValidityTolerance, LaysTheMeasurementIntoABandAroundTheSimulation) {
  const json document = documentOf(tolerance({"--relative", "0.1", "--json", "-"}), 1);
  EXPECT_EQ(document.at("kind"), "tolerance");
  EXPECT_EQ(document.at("passed"), false);
  EXPECT_EQ(document.at("n"), 4);
  EXPECT_EQ(document.at("inside"), 3);
  EXPECT_EQ(document.at("share_inside"), 0.75);
  EXPECT_EQ(document.at("options").at("around"), "simulated");
  EXPECT_EQ(document.at("measurand").at("unit"), "m");
  const json first = document.at("first");
  EXPECT_EQ(first.at("line"), 4);
  EXPECT_EQ(first.at("over"), 2.0);
  EXPECT_NEAR(first.at("excess").get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(first.at("high").get<double>(), 33.0, 1e-12);
  EXPECT_EQ(document.at("worst"), first);
  const json other = documentOf(tolerance({"--relative", "0.1", "--around", "measured", "--json", "-"}), 1);
  EXPECT_NEAR(other.at("first").at("excess").get<double>(), 30.0 - 30.15, 1e-12);
}

TEST_F(ValidityTolerance, EndsWithOneOnlyIfAPointIsOutside) {
  const ProgramRun inside = tolerance({"--relative", "0.1", "--absolute", "0.5"});
  EXPECT_EQ(inside.status, 0);
  EXPECT_THAT(inside.out, HasSubstr("4 of 4 points are in the band (100 %)"));
  const ProgramRun outside = tolerance({"--relative", "0.1", "--absolute", "0.4"});
  EXPECT_EQ(outside.status, 1);
  EXPECT_THAT(outside.out, HasSubstr("3 of 4 points"));
  EXPECT_THAT(outside.out, HasSubstr("real.csv:4: at time_s = 2 x_m is 33.5 m, 0.1 m above the bound 33.4 m"));
}

// Repetitions 1 and 3, 2 and 2: means 2 and 2, deviations sqrt(2) and 0. Rows in any order.
TEST_F(ValidityTolerance, CountsDeviationsOfRepeatedMeasurements) {
  const std::string runs = file("runs.csv", "run,t,x\nb,2,2\na,1,1\nb,1,3\na,2,2\n");
  const std::string model = file("model.csv", "t,x\n1,3\n2,2.5\n");
  const auto check = [&](const std::string& k, const std::vector<std::string>& more, int status) {
    std::vector<std::string> words{"tolerance", runs, model, "--over", "t", "--column", "x", "--repetition", "run"};
    words.insert(words.end(), {"--band", k, "--json", "-"});
    return documentOf(run(words, more), status);
  };
  const json narrow = check("1", {}, 1);
  EXPECT_EQ(narrow.at("options").at("around"), "measured");
  EXPECT_EQ(narrow.at("centre_curves"), 2);
  EXPECT_EQ(narrow.at("first").at("line"), 3);
  EXPECT_DOUBLE_EQ(narrow.at("first").at("excess").get<double>(), 0.5);
  EXPECT_EQ(check("0.5", {}, 1).at("inside"), 0);
  EXPECT_EQ(check("1", {"--absolute", "0.5"}, 0).at("first"), nullptr);
}

TEST_F(ValidityTolerance, ChecksEveryRepetition) {
  const std::string runs = file("runs.csv", "run,t,x\na,1,1\na,2,2\nb,1,1.5\nb,2,9\n");
  const std::string model = file("model.csv", "t,x\n1,1\n2,2\n");
  const ProgramRun done = run({"tolerance", runs, model, "--over", "t", "--column", "x", "--repetition", "run"},
                              {"--absolute", "0.1", "--json", "-"});
  const json document = documentOf(done, 1);
  EXPECT_EQ(document.at("n"), 4);
  EXPECT_EQ(document.at("inside"), 2);
  EXPECT_EQ(document.at("first").at("repetition"), "b");
  EXPECT_EQ(document.at("first").at("line"), 4);
  EXPECT_EQ(document.at("worst").at("line"), 5);
  EXPECT_EQ(document.at("curves").at(0).at("share_inside"), 1.0);
  EXPECT_EQ(document.at("curves").at(1).at("share_inside"), 0.0);
}

TEST_F(ValidityTolerance, SaysWhichPointHasNoPartner) {
  const auto with = [&](const std::string& sim, const std::vector<std::string>& more = {"--absolute", "1"}) {
    return run({"tolerance", real(), file("other.csv", sim), "--over", "time_s", "--column", "x_m"}, more);
  };
  expectError(with("time_s,x_m\n0,1\n1,1\n2.5,1\n3,1\n"),
              {"real.csv:4: has time_s = 2;", "other.csv has no such point"});
  expectError(with("time_s,x_m\n0,1\n1,1\n1.5,1\n2,1\n3,1\n"), {"other.csv:4: has time_s = 1.5;"});
  expectError(with("time_s,x_m\n0,1\n0,1\n1,1\n2,1\n3,1\n"),
              {"other.csv:3: has time_s = 0 again; line 2", "--repetition"});
  expectError(with("tme_s,x_m\n0,1\n"), {"other.csv:1: has no column 'time_s'", "Did you mean 'tme_s'?"});
  expectError(with("time_s,x_m\n0,1\n", {}), {"--relative, --absolute, --band: are all 0"});
  expectError(with("time_s,x_m\n0,1\n", {"--absolute", "-1"}), {"--absolute"});
  expectError(tolerance({"--band", "2"}), {"real.csv: holds a single curve", "--repetition"});
  expectError(tolerance({"--band", "2", "--repetition", "tme_s"}), {"no column 'tme_s'", "Did you mean 'time_s'?"});
}

// ---- ks

class ValidityKs : public ValidityCommand {
 protected:
  /// Per group 20 values 0, 1, … 19, moved by an offset.
  std::string groups(const std::string& name, const std::vector<std::pair<std::string, double>>& offsets) {
    std::string rows = "frame,x_m\n";
    for (const auto& [group, offset] : offsets) {
      for (int i = 0; i < 20; ++i) rows += group + "," + std::to_string(i + offset) + "\n";
    }
    return file(name, rows);
  }
};

// Equal samples have D = 0, samples apart have D = 1: two of four groups differ.
TEST_F(ValidityKs, CountsTheGroupsThatDiffer) {
  const std::string real = groups("real.csv", {{"a", 0}, {"b", 0}, {"c", 0}, {"d", 0}, {"only", 0}});
  const std::string simulated = groups("sim.csv", {{"d", 100}, {"a", 0}, {"b", -100}, {"c", 0}});
  const json document = documentOf(run({"ks", real, simulated, "--by", "frame", "--column", "x_m", "--json", "-"}));
  EXPECT_EQ(document.at("kind"), "ks");
  EXPECT_EQ(document.at("options").at("alpha"), 0.05);
  EXPECT_THAT(document.at("only_real"), ElementsAre("only"));
  EXPECT_THAT(document.at("only_simulated"), IsEmpty());
  const json x = document.at("measurands").at(0);
  EXPECT_EQ(x.at("frequency"), 0.5);
  EXPECT_EQ(x.at("rejected"), 2);
  EXPECT_EQ(x.at("counted"), 4);
  EXPECT_EQ(x.at("groups").at(0).at("name"), "a");
  EXPECT_EQ(x.at("groups").at(0).at("statistic"), 0.0);
  EXPECT_EQ(x.at("groups").at(1).at("statistic"), 1.0);
  EXPECT_EQ(x.at("groups").at(1).at("rejected"), true);
  const ProgramRun table = run({"ks", real, simulated, "--by", "frame", "--column", "x_m"});
  EXPECT_THAT(table.out, HasSubstr("in 2 of 4 groups (by frame)"));
  EXPECT_THAT(table.out, HasSubstr("only measured: 1 (only)"));
}

TEST_F(ValidityKs, LeavesOutSmallGroupsAndSaysSo) {
  std::string rows = "frame,x_m\n";
  for (int i = 0; i < 11; ++i) rows += "b," + std::to_string(i) + "\n";
  for (int i = 0; i < 12; ++i) rows += "a," + std::to_string(i) + "\n";
  const std::string both = file("small.csv", rows);
  const json x =
      documentOf(run({"ks", both, both, "--by", "frame", "--column", "x_m", "--json", "-"})).at("measurands").at(0);
  EXPECT_EQ(x.at("frequency"), 0.0);
  EXPECT_EQ(x.at("counted"), 1);
  EXPECT_THAT(x.at("too_small"), ElementsAre("b"));
}

// Frame 0 of two samples, both right; pooled by frame alone, equal too, but as one group.
TEST_F(ValidityKs, GroupsBySeveralColumns) {
  std::string rows = "sample,frame,x_m\n";
  for (int i = 0; i < 20; ++i) rows += "dry,0," + std::to_string(i) + "\nrain,00," + std::to_string(i) + "\n";
  const std::string both = file("both.csv", rows);
  const auto groupsBy = [&](const std::string& by) {
    return documentOf(run({"ks", both, both, "--by", by, "--column", "x_m", "--json", "-"}))
        .at("measurands")
        .at(0)
        .at("groups");
  };
  EXPECT_EQ(groupsBy("frame").size(), 1u);
  ASSERT_EQ(groupsBy("sample,frame").size(), 2u);
  EXPECT_EQ(groupsBy("sample,frame").at(1).at("name"), "rain, 0");
}

TEST_F(ValidityKs, RefusesToDecideAboutNothing) {
  const std::string a = groups("a.csv", {{"a", 0}});
  const std::string b = groups("b.csv", {{"b", 0}});
  const std::string few = file("few.csv", "frame,x_m\na,1\n");
  expectError(run({"ks", a, b, "--by", "frame", "--column", "x_m"}),
              {"--by frame: finds none of the 2 groups in both"});
  expectError(run({"ks", a, few, "--by", "frame", "--column", "x_m"}), {"no group with 12 values on both sides"});
  expectError(run({"ks", a, a, "--by", "fram", "--column", "x_m"}), {"a.csv:1: has no column 'fram'", "'frame'"});
  expectError(run({"ks", a, a, "--by", "frame", "--column", "x_m", "--alpha", "1"}), {"alpha: is 1"});
  expectError(run({"ks", a, a, "--column", "x_m"}), {"--by is required"});
}

// ---- the command as such

TEST_F(ValidityCommand, NamesTheNearestSubCommand) {
  expectError(run({"lables", "a.csv"}),
              {"There is no command 'validity lables'. Did you mean 'fidelis validity labels'?"});
  const ProgramRun after_option = runFidelis({"--threads", "2", "validity", "lables"});
  EXPECT_THAT(after_option.messages, HasSubstr("There is no command 'validity lables'"));
  const ProgramRun help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* name : {"labels", "gap", "tolerance", "ks"}) EXPECT_THAT(help.out, HasSubstr(name));
}

}  // namespace
