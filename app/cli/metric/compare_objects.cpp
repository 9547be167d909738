#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

#include "app/cli/metric/compare.h"
#include "app/cli/metric/read.h"
#include "core/csv.h"
#include "metrics/objects/object_metrics.h"

namespace app {

namespace {

/// One row of a list of objects; `frame` is 0 where the file has no such column.
struct Row {
  metrics::Object object;
  double frame = 0.0;
};

int idOf(double number, const std::string& file, std::size_t row) {
  if (number == std::floor(number) && std::abs(number) < 2e9) return static_cast<int>(number);
  throw core::InputError({.file = file, .item = fmt::format("row {}, column 'id'", row + 1)},
                         fmt::format("{} is no whole number.", number), "Number the objects 1, 2, 3, …");
}

/// Columns: id x_m y_m are needed; z_m, length_m with width_m and yaw_rad, existence and frame may be there.
std::vector<Row> readRows(const std::string& file) {
  const std::vector<std::string> header = headerOf(file);
  std::vector<std::string> names{"id", "x_m", "y_m"};
  for (const char* name : {"z_m", "length_m", "width_m", "yaw_rad", "existence", "frame"}) {
    if (hasColumns(header, {name})) names.emplace_back(name);
  }
  const auto columns = core::readNumericColumns(file, names);
  std::map<std::string, std::size_t> at;
  for (std::size_t i = 0; i < names.size(); ++i) at[names[i]] = i;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    const auto value = [&](const char* name, double absent) {
      const auto found = at.find(name);
      return found == at.end() ? absent : columns[found->second][i];
    };
    Row row{.object = {.id = idOf(columns[0][i], file, i),
                       .position = {columns[1][i], columns[2][i], value("z_m", 0.0)},
                       .existence = value("existence", 1.0)},
            .frame = value("frame", 0.0)};
    if (at.contains("length_m") && at.contains("width_m")) {
      row.object.footprint = {value("length_m", 0.0), value("width_m", 0.0), value("yaw_rad", 0.0)};
    }
    rows.push_back(row);
  }
  return rows;
}

metrics::ObjectOptions optionsOf(const MetricSettings& settings) {
  return {.set = {.order = settings["order"], .cutoff_m = settings["cut_off_m"]},
          .label_m = settings["label_m"],
          .piece_m = settings["piece_m"],
          .switch_m = settings["switch_m"],
          .least_existence = settings["least_existence"]};
}

std::map<std::string, double> defaults() {
  const metrics::ObjectOptions options;
  return {{"order", options.set.order},   {"cut_off_m", options.set.cutoff_m},
          {"label_m", options.label_m},   {"piece_m", options.piece_m},
          {"switch_m", options.switch_m}, {"least_existence", options.least_existence}};
}

std::vector<metrics::Object> objectsOf(const std::vector<Row>& rows, double frame) {
  std::vector<metrics::Object> objects;
  for (const Row& row : rows) {
    if (row.frame == frame) objects.push_back(row.object);
  }
  return objects;
}

/// One time step for every frame that either side has; one track for every id.
std::vector<metrics::Track> tracksOf(const std::vector<Row>& rows, const std::vector<double>& frames,
                                     const std::string& file) {
  std::map<int, metrics::Track> tracks;
  for (const Row& row : rows) {
    metrics::Track& track = tracks[row.object.id];
    track.id = row.object.id;
    track.positions.resize(frames.size());
    const auto step = std::lower_bound(frames.begin(), frames.end(), row.frame) - frames.begin();
    auto& position = track.positions[static_cast<std::size_t>(step)];
    if (position) {
      throw core::InputError({.file = file}, fmt::format("has object {} twice in frame {}.", track.id, row.frame),
                             "An object is in one place at a time; correct its id or frame.");
    }
    position = row.object.position;
  }
  std::vector<metrics::Track> list;
  for (auto& [id, track] : tracks) list.push_back(std::move(track));
  return list;
}

std::vector<double> framesOf(const std::vector<Row>& a, const std::vector<Row>& b) {
  std::set<double> frames;
  for (const std::vector<Row>* rows : {&a, &b}) {
    for (const Row& row : *rows) frames.insert(row.frame);
  }
  return {frames.begin(), frames.end()};
}

void mustHaveFrames(const std::string& file) {
  if (hasColumns(headerOf(file), {"frame"})) return;
  throw core::InputError({.file = file, .line = 1}, "has no column 'frame'.",
                         "Tracks need the time step of each row; lists of one instant are --data object-list.");
}

}  // namespace

std::vector<MeasurandResult> compareObjectLists(const MetricRequest& request, const Session&) {
  mustHaveNoColumns(request);
  mustHaveOneSimulation(request);
  auto known = defaults();
  known["frame"] = 0.0;
  const MetricSettings settings(request, std::move(known));
  const auto choice = choiceOf(metrics::objectMetrics(), request);
  const auto real = objectsOf(readRows(request.real), settings["frame"]);
  const auto simulated = objectsOf(readRows(request.simulated.front()), settings["frame"]);
  MeasurandResult measurand{.name = "objects", .unit = "m", .n_real = real.size(), .n_sim = {simulated.size()}};
  const metrics::ObjectListInput input{.lists = {.simulated = simulated, .measured = real},
                                       .options = optionsOf(settings)};
  evaluate(choice, input, request, measurand);
  return {std::move(measurand)};
}

std::vector<MeasurandResult> compareTracks(const MetricRequest& request, const Session&) {
  mustHaveNoColumns(request);
  mustHaveOneSimulation(request);
  const MetricSettings settings(request, defaults());
  const auto choice = choiceOf(metrics::trackMetrics(), request);
  for (const std::string* file : {&request.real, &request.simulated.front()}) mustHaveFrames(*file);
  const std::vector<Row> real_rows = readRows(request.real);
  const std::vector<Row> simulated_rows = readRows(request.simulated.front());
  const std::vector<double> frames = framesOf(real_rows, simulated_rows);
  const auto real = tracksOf(real_rows, frames, request.real);
  const auto simulated = tracksOf(simulated_rows, frames, request.simulated.front());
  MeasurandResult measurand{.name = "tracks", .unit = "m", .n_real = real.size(), .n_sim = {simulated.size()}};
  const metrics::TracksInput input{.sets = {.simulated = simulated, .measured = real}, .options = optionsOf(settings)};
  evaluate(choice, input, request, measurand);
  return {std::move(measurand)};
}

}  // namespace app
