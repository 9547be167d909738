#include <algorithm>
#include <cmath>

#include "gap/causes/counters.h"
#include "gap/causes/kinds.h"
#include "gap/causes/layer_gains.h"
#include "gap/replay/statistics.h"

namespace gap {

namespace {

constexpr const char* kUnevenLayers = "photo-response-nonuniformity";

/// The number that an effect declares under this name, which it has.
FreeParameter numberNamed(const model::EffectInfo& info, const std::string& name) {
  return declared(*std::find_if(info.parameters.begin(), info.parameters.end(),
                                [&](const model::ParameterInfo& parameter) { return parameter.name == name; }));
}

model::EffectParameters parametersOf(const std::vector<std::string>& names, const std::vector<double>& values) {
  model::EffectParameters parameters;
  for (std::size_t i = 0; i < names.size(); ++i) parameters.numbers[names[i]] = values[i];
  return parameters;
}

Hypothesis effectHypothesis(const model::EffectInfo& info, const std::vector<std::string>& fitted,
                            const std::string& variant) {
  Hypothesis hypothesis;
  hypothesis.kind = CauseKind::kEffect;
  hypothesis.name = info.name;
  hypothesis.variant = variant;
  hypothesis.percollect = info.percollect;
  hypothesis.decomposition_block = model::toString(info.stage);
  for (const std::string& name : fitted) hypothesis.parameters.push_back(numberNamed(info, name));
  hypothesis.apply = [effect = info.name, fitted, parameters = hypothesis.parameters](
                         World& world, const std::vector<double>& values) {
    const std::vector<double> ordered = inOrder(parameters, values);  // the fit may cross the ends of a sector
    world.model = model::withEffect(world.model, {effect, parametersOf(fitted, ordered), {}});
  };
  return hypothesis;
}

/// A cloud may hang anywhere in front of the sensor, at its height.
void placeCloud(Hypothesis& hypothesis) {
  const auto inner = hypothesis.apply;
  const std::size_t x = hypothesis.parameters.size();
  const std::string effect = hypothesis.name;
  hypothesis.anywhere = true;
  hypothesis.parameters.push_back({"centre_x_m", "m", 0.5, 60.0, false, 10.0});
  hypothesis.parameters.push_back({"centre_y_m", "m", -30.0, 30.0, false, 0.0});
  hypothesis.apply = [inner, x, effect](World& world, const std::vector<double>& values) {
    inner(world, {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(x)});
    for (const model::ActiveEffect& active : world.model.effects) {
      if (active.name != effect) continue;
      model::ActiveEffect placed = active;
      placed.parameters.lists["centre"] = {values[x], values[x + 1], 0.0};
      world.model = model::withEffect(world.model, placed);
      return;
    }
  };
}

/// The effect on some sensors only.
Hypothesis restricted(const Hypothesis& everywhere, const std::vector<std::string>& sensors) {
  Hypothesis hypothesis = everywhere;
  hypothesis.sensors = sensors;
  hypothesis.apply = [inner = everywhere.apply, effect = everywhere.name, sensors](World& world,
                                                                                   const std::vector<double>& values) {
    inner(world, values);
    for (const model::ActiveEffect& active : world.model.effects) {
      if (active.name != effect) continue;
      world.model = model::withEffect(world.model, {effect, active.parameters, sensors});
      return;
    }
  };
  return hypothesis;
}

/// Which sensors an effect may be limited to: every part of two or three, single ones of more.
std::vector<std::vector<std::string>> partsOf(const std::vector<std::string>& sensors) {
  constexpr std::size_t kAllParts = 3;
  std::vector<std::vector<std::string>> parts;
  const std::size_t most = sensors.size() <= kAllParts ? sensors.size() - 1 : 1;
  for (std::size_t bits = 1; sensors.size() < 16 && bits < (std::size_t{1} << sensors.size()); ++bits) {
    std::vector<std::string> part;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
      if ((bits >> i & 1U) != 0) part.push_back(sensors[i]);
    }
    if (part.size() <= most) parts.push_back(std::move(part));
  }
  return parts;
}

void addParts(const std::vector<std::string>& sensors, std::vector<Hypothesis>& list) {
  if (sensors.size() < 2) return;
  const std::vector<Hypothesis> everywhere = list;
  for (const auto& part : partsOf(sensors)) {
    for (const Hypothesis& hypothesis : everywhere) list.push_back(restricted(hypothesis, part));
  }
}

/// Whether a form of range walk differs from a constant offset: where every sensor reports the leading edge already,
/// only the linear front does.
bool walks(const Replay& replay, const std::vector<std::string>& fitted) {
  if (std::find(fitted.begin(), fitted.end(), "coefficient_m") != fitted.end()) return true;
  return std::any_of(replay.samples().begin(), replay.samples().end(), [&](const ReplaySample& sample) {
    return replay.baseline().model.sensor(sample.sample->sensor).detection.range_mode != model::RangeMode::kLeadingEdge;
  });
}

/// Whether the scene of any sample is such.
template <typename Condition>
bool inAnyScene(const Replay& replay, Condition holds) {
  return std::any_of(replay.samples().begin(), replay.samples().end(),
                     [&](const ReplaySample& sample) { return holds(sample.scene); });
}

/// Whether anything in the scenes moves, or the sensor itself may.
bool moves(const Replay& replay) {
  const auto driven = [](const model::SceneObject& object) { return object.velocity_m_s != model::Vector3{}; };
  return replay.baseline().model.has("motion-scan") || inAnyScene(replay, [&](const model::Scene& scene) {
           return std::any_of(scene.objects.begin(), scene.objects.end(), driven);
         });
}

/// Whether any material lets light through.
bool hasPanes(const Replay& replay, const model::Effect& effect) {
  return inAnyScene(replay, [&](const model::Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [&](const model::Material& material) { return effect.letsThrough(material); });
  });
}

/// Whether mirrors turn any ray to something else: without that, they take a share of the light as anything does.
bool hasGhosts(const Replay& replay, const World& mirroring) {
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    if (replay.mirrors(mirroring, s)) return true;
  }
  return false;
}

/// Whether anything in the samples gives the effect something to act on; what can change nothing is not tried.
bool hasSubject(const Replay& replay, const model::EffectEntry& entry, const std::vector<std::string>& fitted) {
  const std::string& name = entry.info.name;
  if (name == "range-walk") return walks(replay, fitted);
  if (name == "motion-scan" || name == "latency") return moves(replay);
  if (name != "transmission" && name != "multipath") return true;
  std::vector<double> typical;
  for (const std::string& number : fitted) typical.push_back(numberNamed(entry.info, number).start);
  const model::EffectParameters parameters = parametersOf(fitted, typical);
  if (name == "transmission") return hasPanes(replay, *entry.make(parameters));
  World mirroring = replay.baseline();
  mirroring.model = model::withEffect(mirroring.model, {name, parameters, {}});
  return hasGhosts(replay, mirroring);
}

/// Whether the model lacks an effect and `only` allows it. Angle clipping changes no byte of the output.
bool considered(const Replay& replay, const std::string& effect, const std::vector<std::string>& only) {
  if (replay.baseline().model.has(effect) || effect == "angle-clipping") return false;
  return only.empty() || std::find(only.begin(), only.end(), effect) != only.end();
}

void addEffects(const Replay& replay, const std::vector<std::string>& only, std::vector<Hypothesis>& list) {
  for (const model::EffectEntry& entry : model::allEffects()) {
    const model::EffectInfo& info = entry.info;
    if (!considered(replay, info.name, only) || info.name == kUnevenLayers) continue;
    const auto add = [&](const std::vector<std::string>& fitted, const std::string& variant, bool costly) {
      if (!hasSubject(replay, entry, fitted)) return;
      list.push_back(effectHypothesis(info, fitted, variant));
      list.back().costly = costly;
      if (info.name == "exhaust-cloud") placeCloud(list.back());
    };
    add(info.fitted, "", false);
    for (const model::FittedForm& form : info.other_forms) add(form.parameters, form.name, form.costly);
  }
}

/// A receiver that clips within its noise above the threshold loses echoes however strong they are, at random. That is
/// no saturation, and where no intensity is measured it does what lost shots do.
void keepAboveNoise(const Replay& replay, Hypothesis& saturation) {
  constexpr double kNoise = 3.0;  // standard deviations: one echo in seven hundred
  for (const ReplaySample& sample : replay.samples()) {
    const std::string& sensor = sample.sample->sensor;
    if (!model::isOn(saturation.sensors, sensor)) continue;
    const model::Receiver& receiver = replay.baseline().model.sensor(sensor).receiver;
    for (FreeParameter& p : saturation.parameters) {
      if (p.name != "saturation_w") continue;
      p.low = std::clamp(receiver.threshold_w + kNoise * receiver.noise_w, p.low, p.high);
      p.start = std::max(p.start, p.low);
    }
  }
}

/// An uneven gain of the layers has the pattern that the data of some sensors show; how strong it is, is fitted. The
/// gains of all layers would be as many numbers as there are layers. Gains that are each their own are hardly alike by
/// chance: a pattern that is nearly even may as well be a weaker emitter's, and pays for that.
void addPattern(const Replay& replay, const model::EffectInfo& info, const std::vector<std::string>& seen_by,
                const std::vector<std::string>& sensors, std::vector<Hypothesis>& list) {
  std::vector<double> pattern = unevenPartOf(layerGains(replay, seen_by));
  std::vector<double> seen;
  double squares = 0.0;
  for (double& gain : pattern) {
    if (std::isfinite(gain)) seen.push_back(std::log(gain));
    const double deviation = std::isfinite(gain) ? gain - 1.0 : 0.0;
    squares += deviation * deviation;
    gain = deviation;
  }
  if (squares <= 0.0) return;
  const double stddev = std::sqrt(squares / static_cast<double>(seen.size()));
  for (double& deviation : pattern) deviation /= stddev;
  Hypothesis hypothesis = effectHypothesis(info, {"stddev"}, "");
  hypothesis.sensors = sensors;
  hypothesis.improbable_nats = seen.size() > 1 ? -std::log(meanByChance(seen)) : 0.0;
  hypothesis.parameters.front().start = std::min(stddev, hypothesis.parameters.front().high);
  hypothesis.apply = [pattern, sensors](World& world, const std::vector<double>& values) {
    model::ActiveEffect uneven{kUnevenLayers, {}, sensors};
    for (const double deviation : pattern)
      uneven.parameters.lists["gain_per_layer"].push_back(std::max(0.05, 1.0 + values[0] * deviation));
    world.model = model::withEffect(world.model, uneven);
  };
  list.push_back(std::move(hypothesis));
}

/// Of all sensors together, and of every part of them, each with its own pattern.
void addPatterns(const Replay& replay, const std::vector<std::string>& only, std::vector<Hypothesis>& list) {
  const model::EffectInfo& info = model::findEffect(kUnevenLayers)->info;
  if (!considered(replay, info.name, only)) return;
  const std::vector<std::string>& sensors = replay.experiment().sensors;
  addPattern(replay, info, sensors.empty() ? std::vector<std::string>{""} : sensors, {}, list);
  if (sensors.size() < 2) return;
  for (const auto& part : partsOf(sensors)) addPattern(replay, info, part, part, list);
}

}  // namespace

FreeParameter declared(const model::ParameterInfo& p) {
  const double low = p.logarithmic && p.min <= 0.0 ? p.max * 1e-4 : p.min;
  return {.name = p.name,
          .unit = p.unit,
          .low = low,
          .high = p.max,
          .logarithmic = p.logarithmic,
          .start = std::clamp(p.typical, low, p.max),
          .absent_at = p.absent_at,
          .whole = p.whole,
          .azimuth = p.name.starts_with("azimuth_")};
}

void addEffectHypotheses(const Replay& replay, const std::vector<std::string>& only, std::vector<Hypothesis>& list) {
  addEffects(replay, only, list);
  addParts(replay.experiment().sensors, list);
  for (Hypothesis& hypothesis : list) {
    if (hypothesis.name == "quantisation") readCounter(replay, hypothesis);
    if (hypothesis.name == "saturation") keepAboveNoise(replay, hypothesis);
  }
  addPatterns(replay, only, list);
}

}  // namespace gap
