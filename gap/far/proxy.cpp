#include "gap/far/proxy.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "gap/far/how_far.h"

namespace gap {

namespace {

using nlohmann::json;

/// A model file of the built-in lidar from what an inline proxy says.
json completed(const model::Experiment& experiment, const model::LidarModel& foreign, json keys) {
  keys["format"] = "fidelis-model";
  keys["version"] = 1;
  if (!keys.contains("id")) keys["id"] = foreign.id + "-proxy";
  if (!keys.contains("seed")) keys["seed"] = foreign.seed;
  if (!keys.contains("rays_per_beam")) keys["rays_per_beam"] = {9, 9};
  if (!keys.contains("effects")) {
    keys["effects"] = {{"beam-divergence", json::object()}, {"pulse-broadening", json::object()}};
  }
  if (keys.contains("sensor") || keys.contains("sensors")) return keys;
  for (const char* key : {"sensor", "sensors"}) {
    if (experiment.json.contains(key)) keys[key] = experiment.json[key];
  }
  model::writeOutSensors(keys, experiment.file);
  return keys;
}

model::LidarModel unchecked(const model::Experiment& experiment, const model::LidarModel& foreign,
                            const std::optional<model::LidarModel>& given) {
  if (given) return *given;
  const json& file = foreign.json.contains("model") ? foreign.json["model"] : foreign.json;
  const json named = file.value("proxy", json());
  if (named.is_string()) return model::readModel(foreign.file.parent_path() / named.get<std::string>());
  return model::parseModel(completed(experiment, foreign, named.is_object() ? named : json::object()), foreign.file);
}

std::string sentences(const Approximation& a, const model::LidarModel& proxy, bool present) {
  std::vector<std::string> effects;
  for (const model::ActiveEffect& effect : proxy.effects) effects.push_back(effect.name);
  std::string text = fmt::format(
      "The model under test is not the built-in lidar. What an effect would change was computed in a built-in proxy "
      "({}; {}) and applied to what the model under test reported: an approximation. Proxy and model under test "
      "differ by a total gap of {} (two simulations of the proxy by {}), the measurement and the model under test "
      "by {}.",
      a.proxy, effects.empty() ? "no effects" : core::join(effects), core::significant(a.proxy_gap, 3),
      core::significant(a.noise, 3), core::significant(a.gap, 3));
  if (!present) return text;
  if (!a.reliable()) {
    text +=
        " The proxy is no nearer to the model under test than the measurement is: do not rely upon the causes, "
        "and give a better proxy.";
  } else if (a.trust() < 1.0) {
    text += fmt::format(" The difference is {:.0f} % of the gap: causes deserve less trust.", 100.0 * a.ratio);
  }
  return text;
}

}  // namespace

model::LidarModel proxyOf(const model::Experiment& experiment, const model::LidarModel& foreign,
                          const std::optional<model::LidarModel>& given) {
  model::LidarModel proxy = unchecked(experiment, foreign, given);
  model::requireBuiltIn(proxy, "a proxy");
  return proxy;
}

std::optional<model::LidarModel> chosenProxy(const std::filesystem::path& file, const model::LidarModel& lidar) {
  if (file.empty()) return std::nullopt;
  if (!lidar.external) {
    throw core::InputError({.file = file},
                           "no proxy is needed: it stands for models that are commands or recordings, and " +
                               lidar.file.string() + " is the built-in lidar itself.",
                           "Leave the proxy out.");
  }
  return model::readModel(file);
}

double Approximation::trust() const { return std::clamp(1.1 - ratio, 0.3, 1.0); }

Approximation approximationOf(const Replay& replay, const std::vector<std::size_t>& held_out, std::uint64_t seed,
                              bool present) {
  const World& baseline = replay.baseline();
  const auto& measurands = replay.experiment().measurands;
  std::vector<TotalGap> to_proxy, of_proxy, to_measured;
  for (const std::size_t s : held_out) {
    const ReplaySample& sample = replay.samples()[s];
    const core::Detections theirs = replay.detections(baseline, s, seed);
    const core::Detections ours = replay.builtInDetections(baseline, s, seed);
    to_proxy.push_back(totalGap(measurands, theirs, ours, sample.frames));
    of_proxy.push_back(totalGap(measurands, replay.builtInDetections(baseline, s, seed + 1), ours, sample.frames));
    to_measured.push_back(totalGap(measurands, sample.measured, theirs, sample.frames));
  }
  Approximation a;
  a.proxy = baseline.model.id;
  a.proxy_gap = meanOf(to_proxy).total;
  a.noise = meanOf(of_proxy).total;
  a.gap = meanOf(to_measured).total;
  a.ratio = std::max(0.0, a.proxy_gap - a.noise) / std::max(1e-9, a.gap - a.noise);
  a.text = sentences(a, baseline.model, present);
  return a;
}

}  // namespace gap
