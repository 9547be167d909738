#include "gap/where/covariates.h"

#include <cmath>
#include <set>

#include "core/physics.h"

namespace gap {

namespace {

/// To a billionth of a degree, so that the middle of a scan is 0 and not what rounding left of it.
double roundDegrees(double angle_rad) { return std::round(angle_rad * core::kDegPerRad * 1e9) / 1e9 + 0.0; }

}  // namespace

std::vector<Covariate> covariatesOf(const Replay& replay, const std::vector<std::vector<CellStatistics>>& expected) {
  const auto cell = [&replay](const CellPlace& place) -> const Cell& {
    return replay.samples()[place.sample].layout->cells()[place.cell];
  };
  const auto beam = [&replay, cell](const CellPlace& place) -> const model::Beam& {
    return replay.samples()[place.sample].beams[cell(place).beam];
  };
  const auto mean = [&replay, &expected](Channel channel) {
    return [&replay, &expected, channel](const CellPlace& place) {
      const CellStatistics& x = expected[place.sample][place.cell];
      const CellStatistics& m = replay.samples()[place.sample].statistics[place.cell];
      return x.count > 0.0 ? x.mean(channel) : m.count > 0.0 ? m.mean(channel) : NAN;
    };
  };
  std::vector<Covariate> list;
  const bool pooled = replay.samples().front().layout->pooled();
  if (!pooled) {
    list.push_back(
        {"range_m", true, [cell](const CellPlace& r) { return cell(r).object < 0 ? NAN : cell(r).anchor_m; }, nullptr});
    list.push_back(
        {"azimuth_deg", true, [beam](const CellPlace& r) { return roundDegrees(beam(r).azimuth_rad); }, nullptr});
    list.push_back(
        {"elevation_deg", true, [beam](const CellPlace& r) { return roundDegrees(beam(r).elevation_rad); }, nullptr});
    list.push_back(
        {"incidence_deg", true,
         [cell](const CellPlace& r) { return cell(r).object < 0 ? NAN : cell(r).incidence_rad * core::kDegPerRad; },
         nullptr});
    list.push_back({"time_s", true, [beam](const CellPlace& r) { return beam(r).time_s; }, nullptr});
    const auto seen = [&replay, cell](auto nameOf) {
      return [&replay, cell, nameOf](const CellPlace& r) {
        const model::Scene& scene = replay.samples()[r.sample].scene;
        const std::int32_t object = cell(r).object;
        return object < 0 ? std::string("(nothing)") : nameOf(scene, scene.objects[static_cast<std::size_t>(object)]);
      };
    };
    list.push_back({"object", false, nullptr,
                    seen([](const model::Scene&, const model::SceneObject& object) { return object.id; })});
    list.push_back({"material", false, nullptr, seen([](const model::Scene& scene, const model::SceneObject& object) {
                      return scene.materials[object.material].name;
                    })});
  }
  for (const Channel channel : replay.channels()) {
    if (channel == kEpw) list.push_back({"epw_m", true, mean(kEpw), nullptr});
    if (channel == kIntensity) list.push_back({"intensity", true, mean(kIntensity), nullptr});
  }
  if (!replay.experiment().sensors.empty()) {
    list.push_back({"sensor", false, nullptr,
                    [&replay](const CellPlace& r) { return replay.samples()[r.sample].sample->sensor; }});
  }
  std::set<std::string> setups, parameters;
  for (const ReplaySample& sample : replay.samples()) {
    setups.insert(sample.sample->setup);
    for (const auto& [name, value] : sample.sample->parameters) parameters.insert(name);
  }
  if (setups.size() > 1) {
    list.push_back(
        {"setup", false, nullptr, [&replay](const CellPlace& r) { return replay.samples()[r.sample].sample->setup; }});
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
  return list;
}

}  // namespace gap
