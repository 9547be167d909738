#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>

#include "metrics/objects/gospa.h"
#include "metrics/objects/ospa.h"
#include "metrics/objects/track_ospa.h"
#include "metrics/objects/trajectory_metric.h"
#include "tests/metrics/objects/random_objects.h"
#include "tests/support/paths.h"

namespace {

using metrics::Track;
using metrics_test::ObjectList;
using metrics_test::TrackList;

struct Value {
  metrics::SetOptions set;
  double label_m = 0.0;
  double switch_m = 0.0;
  std::string name;
  double expected = 0.0;
};

struct OracleCase {
  TrackList measured;
  TrackList simulated;
  std::vector<Value> values;
};

void addPosition(TrackList& tracks, std::size_t row, std::size_t step, const metrics::Position& position) {
  if (tracks.size() <= row) tracks.resize(row + 1);
  if (tracks[row].positions.size() <= step) tracks[row].positions.resize(step + 1);
  tracks[row].positions[step] = position;
}

void makeEquallyLong(OracleCase& one) {
  std::size_t steps = 0;
  for (TrackList* tracks : {&one.measured, &one.simulated}) {
    for (const Track& track : *tracks) steps = std::max(steps, track.positions.size());
  }
  for (TrackList* tracks : {&one.measured, &one.simulated}) {
    for (Track& track : *tracks) track.positions.resize(steps);
  }
}

/// tests/data/metrics/objects/set_oracles.csv; the script beside it says what a line means.
std::map<int, OracleCase> readCases() {
  std::map<int, OracleCase> cases;
  std::ifstream file(test_support::testData("metrics/objects/set_oracles.csv"));
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    const auto number = [&cells](std::size_t i) { return std::stod(cells[i]); };
    OracleCase& one = cases[std::stoi(cells[1])];
    if (cells[0] == "track") {
      addPosition(cells[2] == "m" ? one.measured : one.simulated, std::stoul(cells[3]), std::stoul(cells[4]),
                  {number(5), number(6), number(7)});
    } else {
      one.values.push_back({.set = {.order = number(2), .cutoff_m = number(3)},
                            .label_m = number(4),
                            .switch_m = number(5),
                            .name = cells[6],
                            .expected = number(7)});
    }
  }
  for (auto& [number, one] : cases) makeEquallyLong(one);
  return cases;
}

ObjectList atFirstStep(const TrackList& tracks) {
  ObjectList list;
  for (const Track& track : tracks) {
    if (track.existsAt(0)) list.push_back({.position = *track.positions[0]});
  }
  return list;
}

double computed(const Value& value, const OracleCase& one) {
  const metrics::TrackSets sets{.simulated = one.simulated, .measured = one.measured};
  const ObjectList simulated = atFirstStep(one.simulated);
  const ObjectList measured = atFirstStep(one.measured);
  const metrics::ObjectLists lists{.simulated = simulated, .measured = measured};
  if (value.name == "ospa") return ospa(lists, value.set).distance;
  if (value.name == "gospa") return gospa(lists, value.set).distance;
  if (value.name == "ospa_t") return ospaT(sets, {.set = value.set, .label_m = value.label_m}).mean;
  if (value.name == "ospa_2") return ospaOfTracks(sets, value.set).distance;
  return trajectoryDistance(sets, {.set = value.set, .switch_m = value.switch_m}).distance;
}

// scipy 1.10.1: linear_sum_assignment, linprog (HiGHS, feasible and optimal to 1e-7 by default).
TEST(SetOracles, AgreeWithScipy) {
  const auto cases = readCases();
  ASSERT_EQ(cases.size(), 30U);
  for (const auto& [number, one] : cases) {
    ASSERT_EQ(one.values.size(), 15U);
    for (const Value& value : one.values) {
      EXPECT_NEAR(computed(value, one), value.expected, value.name == "track_metric" ? 1e-7 : 1e-12)
          << "case " << number << ", " << value.name << ", p = " << value.set.order;
    }
  }
}

}  // namespace
