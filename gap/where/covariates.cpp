#include "gap/where/covariates.h"

#include <cmath>
#include <set>

#include "core/physics.h"

namespace gap {

namespace {

/// To a billionth of a degree, so that the middle of a scan is 0 and not what rounding left of it.
double roundDegrees(double angle_rad) { return std::round(angle_rad * core::kDegPerRad * 1e9) / 1e9 + 0.0; }

const Cell& cellAt(const Replay& replay, const CellPlace& place) {
  return replay.samples()[place.sample].layout->cells()[place.cell];
}

/// Where a beam goes, and what it meets there.
void addGeometry(const Replay& replay, std::vector<Covariate>& list) {
  const auto cell = [&replay](const CellPlace& place) -> const Cell& { return cellAt(replay, place); };
  const auto beam = [&replay](const CellPlace& place) -> const model::Beam& {
    return replay.samples()[place.sample].beams[cellAt(replay, place).beam];
  };
  const auto number = [&list](const char* name, auto value) { list.push_back({name, true, value, nullptr}); };
  number("range_m", [cell](const CellPlace& r) { return cell(r).object < 0 ? NAN : cell(r).anchor_m; });
  number("azimuth_deg", [beam](const CellPlace& r) { return roundDegrees(beam(r).azimuth_rad); });
  number("elevation_deg", [beam](const CellPlace& r) { return roundDegrees(beam(r).elevation_rad); });
  number("incidence_deg",
         [cell](const CellPlace& r) { return cell(r).object < 0 ? NAN : cell(r).incidence_rad * core::kDegPerRad; });
  number("time_s", [beam](const CellPlace& r) { return beam(r).time_s; });
}

/// The names of what a beam meets, in the scene of its sample.
void addSurfaces(const Replay& replay, std::vector<Covariate>& list) {
  const auto named = [&](const char* name, auto nameOf) {
    list.push_back({name, false, nullptr, [&replay, nameOf](const CellPlace& r) {
                      const model::Scene& scene = replay.samples()[r.sample].scene;
                      const std::int32_t object = cellAt(replay, r).object;
                      return object < 0 ? std::string("(nothing)")
                                        : nameOf(scene, scene.objects[static_cast<std::size_t>(object)]);
                    }});
  };
  named("object", [](const model::Scene&, const model::SceneObject& object) { return object.id; });
  named("material", [](const model::Scene& scene, const model::SceneObject& object) {
    return scene.materials[object.material].name;
  });
}

/// The values that are expected; measured ones where nothing is.
void addValues(const Replay& replay, const std::vector<std::vector<CellStatistics>>& expected,
               std::vector<Covariate>& list) {
  const auto mean = [&replay, &expected](Channel channel) {
    return [&replay, &expected, channel](const CellPlace& place) {
      const CellStatistics& x = expected[place.sample][place.cell];
      const CellStatistics& m = replay.samples()[place.sample].statistics[place.cell];
      return x.count > 0.0 ? x.mean(channel) : m.count > 0.0 ? m.mean(channel) : NAN;
    };
  };
  for (const Channel channel : replay.channels()) {
    if (channel == kEpw) list.push_back({"epw_m", true, mean(kEpw), nullptr});
    if (channel == kIntensity) list.push_back({"intensity", true, mean(kIntensity), nullptr});
  }
}

/// What the experiment says of whole samples: sensor, set-up, settings.
void addSettings(const Replay& replay, bool pooled, std::vector<Covariate>& list) {
  const auto named = [&](const char* name, std::string model::Sample::*text) {
    list.push_back({name, false, nullptr,
                    [&replay, text](const CellPlace& r) { return replay.samples()[r.sample].sample->*text; }});
  };
  if (!replay.experiment().sensors.empty()) named("sensor", &model::Sample::sensor);
  if (setupsOf(replay).size() > 1) named("setup", &model::Sample::setup);
  std::set<std::string> parameters;
  for (const ReplaySample& sample : replay.samples()) {
    for (const auto& [name, value] : sample.sample->parameters) parameters.insert(name);
  }
  for (const std::string& name : parameters) {
    if (name == "range_m" && !pooled) continue;  // the covariate of that name is finer
    list.push_back({name, true,
                    [&replay, name](const CellPlace& r) {
                      const auto& values = replay.samples()[r.sample].sample->parameters;
                      const auto found = values.find(name);
                      return found == values.end() ? NAN : found->second;
                    },
                    nullptr});
  }
}

}  // namespace

std::vector<Covariate> covariatesOf(const Replay& replay, const std::vector<std::vector<CellStatistics>>& expected) {
  std::vector<Covariate> list;
  const bool pooled = replay.samples().front().layout->pooled();
  if (!pooled) {
    addGeometry(replay, list);
    addSurfaces(replay, list);
  }
  addValues(replay, expected, list);
  addSettings(replay, pooled, list);
  return list;
}

}  // namespace gap
