#include "objects/object_list.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/csv.h"
#include "core/json_object.h"
#include "core/parallel.h"
#include "core/physics.h"
#include "tests/objects/street.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"
#include "tests/support/thrown_message.h"

// From detections to lists: a scene whose truth is known, seen without noise.
namespace {

using nlohmann::json;
using objects::GroundBy;
using objects::identifyObjects;
using objects::ListedObject;
using objects::ObjectList;
using objects::ReferenceChoice;
using objects::referenceObjects;
using objects::SegmentsBy;
using objects::Stages;
using test_objects::experimentOf;
using test_objects::fire;
using test_objects::kColumn_rad;
using test_objects::streetJson;
using testing::HasSubstr;

ReferenceChoice named(const std::string& name) { return *ReferenceChoice::named(name); }

ObjectList identify(const model::Experiment& experiment, const Stages& stages = {}, const std::string& gate = "") {
  return identifyObjects(experiment, 0, fire(experiment), stages, gate);
}

/// Errors of the last frame by name of the reference.
std::map<std::string, objects::ObjectError> lastErrors(const model::Experiment& experiment, const ObjectList& list,
                                                       const std::string& point) {
  std::map<std::string, objects::ObjectError> errors;
  for (const auto& error : errorsOf(list, referenceObjects(experiment, 0), named(point))) {
    errors[error.object] = error;
  }
  return errors;
}

// The end of a side at range r, seen under the angle λ, is missed by less than a step of the scan: r Δφ / sin λ. The
// rear of both cars is seen steeply (λ > 45°), their long sides end at 17.7 m under 30° and at 27.6 m under 8.5°.
TEST(ObjectList, TwoCarsAreFoundWhereTheyStand) {
  const model::Experiment experiment = experimentOf(streetJson());
  const ObjectList list = identify(experiment);
  const auto errors = lastErrors(experiment, list, "nearest-corner");
  ASSERT_EQ(errors.size(), 2u);
  const auto step = [](double range_m, double incidence_deg) {
    return range_m * kColumn_rad / std::sin(incidence_deg * core::kRadPerDeg);
  };
  // The finer search knows the heading to 0.025° plus what sampling leaves open.
  const std::map<std::string, double> length_step = {{"near", step(17.7, 25)}, {"far", step(27.6, 8)}};
  for (const auto& [name, error] : errors) {
    const double across = step(name == "near" ? 14.0 : 23.5, 45);
    EXPECT_LE(std::abs(error.yaw_rad), 1.0 * core::kRadPerDeg) << name;
    EXPECT_LE(std::hypot(error.position_m[0], error.position_m[1]), across) << name;
    EXPECT_LE(error.width_m, 0.05) << name;
    EXPECT_GE(error.width_m, -2 * across) << name;
    EXPECT_LE(error.length_m, 0.05) << name;
    EXPECT_GE(error.length_m, -length_step.at(name) - across) << name;
    // The roof is missed by less than a layer, the foot stands on the street.
    EXPECT_LE(error.height_m, 1e-3) << name;
    EXPECT_GE(error.height_m, -27.6 * std::tan(0.5 * core::kRadPerDeg)) << name;
  }
}

TEST(ObjectList, ObjectsAppearInTheThirdFrame) {
  const ObjectList list = identify(experimentOf(streetJson(4)));
  ASSERT_EQ(list.objects.size(), 4u);
  EXPECT_EQ(list.objects[0].frame, 2);
  EXPECT_NEAR(list.objects[0].existence, 0.6, 1e-12);
  EXPECT_EQ(list.objects[2].frame, 3);
  EXPECT_NEAR(list.objects[2].existence, 0.8, 1e-12);
  EXPECT_EQ(list.objects[0].id, list.objects[2].id);
  EXPECT_EQ(list.objects[0].age, 3);
}

// By hand: what is no higher than 0.2 m above the street goes, everything else stays, and nothing is lost on the way.
TEST(ObjectList, TheGroundIsRemovedAndNothingElse) {
  const model::Experiment experiment = experimentOf(streetJson(1));
  const core::Detections detections = fire(experiment);
  std::size_t low = 0;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    low += detections.range_m[i] * std::sin(detections.elevation_rad[i]) <= -1.3;
  }
  const auto counts = identifyObjects(experiment, 0, detections, {}).counts;
  EXPECT_EQ(counts.detections, detections.size());
  EXPECT_EQ(counts.ground, low);
  EXPECT_GT(low, 1000u);
  EXPECT_EQ(counts.features, 2u);
  EXPECT_EQ(counts.without_object, 0u);
}

TEST(ObjectList, AFittedGroundIsTheTrueOne) {
  const model::Experiment experiment = experimentOf(streetJson(3));
  Stages fit;
  fit.ground_by = GroundBy::kFit;
  const ObjectList fitted = identify(experiment, fit), known = identify(experiment);
  EXPECT_EQ(fitted.counts.frames_without_ground, 0u);
  // The feet of the cars lie within the tolerance and tilt the plane by some millimetres.
  EXPECT_NEAR(static_cast<double>(fitted.counts.ground), static_cast<double>(known.counts.ground),
              0.01 * static_cast<double>(known.counts.ground));
  ASSERT_EQ(fitted.objects.size(), known.objects.size());
  for (std::size_t i = 0; i < known.objects.size(); ++i) {
    EXPECT_NEAR(groundDistance(fitted.objects[i].box, known.objects[i].box), 0.0, 0.05);
  }
}

// Why ground is removed: rings on the street lie nearer to each other and to the wheels than objects do.
TEST(ObjectList, WithoutGroundRemovalTheStreetJoinsTheCars) {
  Stages none;
  none.ground_by = GroundBy::kNone;
  const model::Experiment experiment = experimentOf(streetJson(3));
  const ObjectList list = identify(experiment, none);
  EXPECT_EQ(list.counts.ground, 0u);
  ASSERT_FALSE(list.objects.empty());
  EXPECT_GT(list.objects[0].box.length_m, 10.0);
}

// Perfect segmentation knows whose a detection is: names instead of distances.
TEST(ObjectList, ReferenceSegmentsCarryTheNamesOfTheirObjects) {
  const model::Experiment experiment = experimentOf(streetJson(3));
  Stages stages;
  stages.segments_by = SegmentsBy::kReference;
  const ObjectList list = identify(experiment, stages);
  ASSERT_EQ(list.objects.size(), 2u);
  EXPECT_EQ(list.objects[0].object, "near");
  EXPECT_EQ(list.objects[1].object, "far");
  // Ground is removed first; each box then holds all other detections of its car, as clusters do.
  const ObjectList clustered = identify(experiment);
  std::multiset<int> in_boxes, in_clusters;
  for (const ListedObject& object : list.objects) in_boxes.insert(*object.detections);
  for (const ListedObject& object : clustered.objects) in_clusters.insert(*object.detections);
  EXPECT_EQ(in_boxes, in_clusters);
}

TEST(ObjectList, AGateShowsOneCar) {
  const ObjectList list = identify(experimentOf(streetJson(3)), {}, "near-car");
  ASSERT_EQ(list.objects.size(), 1u);
  EXPECT_NEAR(list.objects[0].box.centre_m[0], 15.0, 0.5);
  EXPECT_GT(list.counts.outside_gate, 1000u);
}

TEST(ObjectList, TwoDetectionsAreNoObject) {
  json street = streetJson(1);
  street["scene"] = json::array();
  street["gates"] = json::array();
  const model::Experiment experiment = experimentOf(street);
  core::Detections two;
  two.frame = {0, 0, 0, 0, 0};
  two.layer = two.echo = {1, 1, 1, 1, 1};
  two.azimuth_rad = {0.0, 0.01, 0.3, 0.31, 0.32};
  two.elevation_rad = {0, 0, 0, 0, 0};
  two.range_m = {10, 10, 20, 20, 20};
  const auto counts = identifyObjects(experiment, 0, two, {}).counts;
  EXPECT_EQ(counts.segments, 2u);
  EXPECT_EQ(counts.features, 1u);
  EXPECT_EQ(counts.without_object, 2u);
}

TEST(ReferenceObjects, AreTheBoxesOfTheScene) {
  json street = streetJson(2);
  street["scene"].push_back({{"id", "board"},
                             {"shape", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 1}}},
                             {"pose", {{"position_m", {30, 0, 0}}, {"yaw_pitch_roll_deg", {0, 0, 90}}}},
                             {"material", "grey"}});
  const ObjectList list = referenceObjects(experimentOf(street), 0);
  ASSERT_EQ(list.objects.size(), 6u);  // three in each of two frames; the street is none
  const ListedObject& near = list.objects[0];
  EXPECT_EQ(near.object, "near");
  EXPECT_EQ(near.id, 2);
  EXPECT_NEAR(near.box.length_m, 4.5, 1e-12);
  EXPECT_NEAR(near.box.width_m, 1.8, 1e-12);
  EXPECT_NEAR(near.box.yaw_rad, 20 * core::kRadPerDeg, 1e-12);
  EXPECT_NEAR(near.box.centre_m[0], 15.0, 1e-12);
  EXPECT_FALSE(near.detections);
  const objects::Box& board = list.objects[2].box;  // rolled by 90°: 1 m wide, 2 m high
  EXPECT_NEAR(board.length_m, 0.0, 1e-12);
  EXPECT_NEAR(board.width_m, 1.0, 1e-12);
  EXPECT_NEAR(board.height_m, 2.0, 1e-12);
}

TEST(ReferenceObjects, HaveNoErrorAgainstThemselves) {
  const ObjectList list = referenceObjects(experimentOf(streetJson(2)), 0);
  const auto errors = errorsOf(list, list, named("nearest-side"));
  ASSERT_EQ(errors.size(), 4u);
  for (const auto& error : errors) {
    EXPECT_EQ(error.length_m, 0.0);
    EXPECT_EQ(error.yaw_rad, 0.0);
    EXPECT_EQ(error.position_m, (objects::Vector3{0, 0, 0}));
  }
}

TEST(ObjectList, IsTheSameForAnyNumberOfThreads) {
  const model::Experiment experiment = experimentOf(streetJson(6));
  const core::Detections detections = fire(experiment);
  Stages stages;
  stages.ground_by = GroundBy::kFit;
  const auto list = [&](int threads) {
    core::limitThreads(threads);
    return toCsv(identifyObjects(experiment, 0, detections, stages), named("nearest-corner"));
  };
  const std::string one = list(1);
  EXPECT_EQ(one, list(4));
  core::limitThreads(0);
}

TEST(ObjectList, SaysWhatCannotBeUsed) {
  const model::Experiment experiment = experimentOf(streetJson(2));
  const auto messageFor = [&](const core::Detections& detections, const std::string& gate = "") {
    return test_support::thrownMessage([&] { (void)identifyObjects(experiment, 0, detections, {}, gate); });
  };
  core::Detections pooled;
  pooled.range_m = {10};
  pooled.frame = {0};
  EXPECT_THAT(messageFor(pooled), HasSubstr("has no directions"));
  core::Detections late = pooled;
  late.layer = late.echo = {1};
  late.azimuth_rad = late.elevation_rad = {0};
  late.frame = {2};
  EXPECT_THAT(messageFor(late), HasSubstr("in frame 2, but sample 's' has 2 frames"));
  EXPECT_THAT(messageFor({}, "near-cat"), HasSubstr("Did you mean 'near-car'?"));
  EXPECT_EQ(messageFor({}), "");  // no detections are no error: everything was missed
}

// `fidelis objects` as scripts see it.
class ObjectsCommand : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "street");
    core::writeJson(folder_ / "street/experiment.json", streetJson(5));
    core::writeJson(folder_ / "model.json", test_objects::modelJson());
    const auto run = test_support::runFidelis(
        {"simulate", path("street"), "--model", path("model.json"), "--out", path("simulated")});
    ASSERT_EQ(run.status, 0) << run.messages;
  }
  std::string path(const std::string& name) { return (folder_ / name).string(); }
  test_support::ProgramRun objects(std::vector<std::string> words) {
    words.insert(words.begin(), "objects");
    return test_support::runFidelis(words);
  }

  test_support::TemporaryFolder folder_;
};

TEST_F(ObjectsCommand, ListsCanBeComparedByTheMetrics) {
  ASSERT_EQ(objects({path("simulated"), "--out", path("found")}).status, 0);
  ASSERT_EQ(objects({path("simulated"), "--reference", "--out", path("true")}).status, 0);
  const auto compare = [&](const std::string& real, const std::string& kind) {
    const auto run = test_support::runFidelis({"metric", path(real), path("found/s.csv"), "--data", kind, "--set",
                                               "frame=4", "--metric", "gospa", "--json", "-"});
    EXPECT_EQ(run.status, 0) << run.messages;
    return json::parse(run.out).at("measurands").at(0);
  };
  const json same = compare("found/s.csv", "object-list"), truth = compare("true/s.csv", "object-list");
  EXPECT_EQ(same.at("n_sim").at(0), 2);
  EXPECT_EQ(same.at("gospa").at("distance"), 0.0);
  EXPECT_EQ(truth.at("n_real"), 2);
  EXPECT_EQ(truth.at("gospa").at("missed"), 0);
  EXPECT_LT(truth.at("gospa").at("distance"), 0.5);
  const auto tracks =
      test_support::runFidelis({"metric", path("true/s.csv"), path("found/s.csv"), "--data", "tracks", "--json", "-"});
  EXPECT_EQ(tracks.status, 0) << tracks.messages;
  const auto errors = test_support::runFidelis(
      {"metric", path("found/errors/s.csv"), path("found/errors/s.csv"), "--column", "error_x_m", "--json", "-"});
  EXPECT_EQ(errors.status, 0) << errors.messages;
  EXPECT_EQ(json::parse(errors.out).at("measurands").at(0).at("n_real"), 6);  // two cars in three frames
}

TEST_F(ObjectsCommand, JsonTellsWhatBecameOfTheDetections) {
  const auto run = objects({path("simulated"), "--reference-point", "nearest-corner", "--json", "-"});
  ASSERT_EQ(run.status, 0) << run.messages;
  const json document = json::parse(run.out);
  EXPECT_EQ(document.at("format"), "fidelis-objects");
  EXPECT_EQ(document.at("reference_point"), "nearest-corner");
  const json& sample = document.at("samples").at(0);
  EXPECT_EQ(sample.at("objects").size(), 6u);
  const json& blocks = sample.at("stages");
  ASSERT_EQ(blocks.size(), 3u);
  EXPECT_EQ(blocks.at(1).at("block"), "Feature identification");
  EXPECT_EQ(blocks.at(1).at("features"), 10);
  EXPECT_EQ(blocks.at(2).at("objects"), 6);
}

// Positions of corners with sizes around a middle would be boxes that are out of place: the metric must not see them.
TEST_F(ObjectsCommand, SizesGoByAnotherNameWhereThePositionIsNoMiddle) {
  ASSERT_EQ(objects({path("simulated"), "--reference-point", "rear", "--out", path("found")}).status, 0);
  const auto header = core::readCsvTable(folder_ / "found/s.csv").header;
  EXPECT_THAT(header, testing::Contains("box_length_m"));
  EXPECT_THAT(header, testing::Not(testing::Contains("length_m")));
}

TEST_F(ObjectsCommand, SaysWhatIsWrong) {
  const auto messageFor = [&](std::vector<std::string> words) {
    const auto run = objects(std::move(words));
    EXPECT_EQ(run.status, 2);
    return run.messages;
  };
  EXPECT_THAT(messageFor({path("street"), "--out", path("x")}), HasSubstr("s.csv"));  // was never measured
  EXPECT_THAT(messageFor({path("nowhere"), "--out", path("x")}), HasSubstr("nowhere"));
  EXPECT_THAT(messageFor({path("simulated")}), HasSubstr("--out"));
  EXPECT_THAT(messageFor({path("simulated"), "--out", path("street")}), HasSubstr("not an empty folder"));
  EXPECT_THAT(messageFor({path("simulated"), "--out", path("x"), "--sample", "t"}), HasSubstr("Did you mean 's'?"));
  EXPECT_THAT(messageFor({path("simulated"), "--out", path("x"), "--reference-point", "bumper"}),
              HasSubstr("nearest-corner"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x"));
}

}  // namespace
