#include "gap/hypotheses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "gap/discrepancy.h"
#include "gap/layer_gains.h"
#include "gap/range_comb.h"
#include "gap/settle.h"

namespace gap {

using nlohmann::json;

namespace {

constexpr const char* kUnevenLayers = "photo-response-nonuniformity";

/// The number that an effect declares under this name.
FreeParameter declared(const model::EffectInfo& info, const std::string& name) {
  const auto p = std::find_if(info.parameters.begin(), info.parameters.end(),
                              [&](const model::ParameterInfo& parameter) { return parameter.name == name; });
  const double low = p->logarithmic && p->min <= 0.0 ? p->max * 1e-4 : p->min;
  return {p->name, p->unit, low, p->max, p->logarithmic, std::clamp(p->typical, low, p->max), p->absent_at, p->whole};
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
  for (const std::string& name : fitted) hypothesis.parameters.push_back(declared(info, name));
  const std::string effect = info.name;
  hypothesis.apply = [effect, fitted](World& world, const std::vector<double>& values) {
    world.model = model::withEffect(world.model, {effect, parametersOf(fitted, values), {}});
  };
  return hypothesis;
}

/// The fit may cross the ends of a sector.
void orderSector(Hypothesis& hypothesis) {
  hypothesis.apply = [inner = hypothesis.apply, parameters = hypothesis.parameters](World& world,
                                                                                    const std::vector<double>& values) {
    inner(world, inOrder(parameters, values));
  };
}

/// The values themselves show the step of a counter, more exactly than any fit: means of few noisy frames hardly do.
void narrowToComb(const Replay& replay, Hypothesis& hypothesis) {
  FreeParameter& step = hypothesis.parameters.front();  // of the range
  const std::optional<Comb> comb = rangeComb(replay);
  if (!comb || comb->step > step.high) return;
  step.start = comb->step;
  step.low = comb->step - comb->uncertain;
  step.high = comb->step + comb->uncertain;
  hypothesis.seen_in_values = true;
}

/// A cloud may hang anywhere in front of the sensor, at its height.
void placeCloud(Hypothesis& hypothesis) {
  const auto inner = hypothesis.apply;
  const std::size_t x = hypothesis.parameters.size();
  const std::string effect = hypothesis.name;
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

/// Whether anything in the samples gives the effect something to act on; what can change nothing is not tried.
bool hasSubject(const Replay& replay, const model::EffectEntry& entry, const std::vector<std::string>& fitted) {
  const bool of_motion = entry.info.name == "motion-scan" || entry.info.name == "latency";
  const bool of_ways = entry.info.name == "transmission" || entry.info.name == "multipath";
  if (!of_motion && !of_ways) return true;
  if (of_motion && replay.baseline().model.has("motion-scan")) return true;  // the sensor itself may move
  std::vector<double> typical;
  for (const std::string& name : fitted) typical.push_back(declared(entry.info, name).start);
  const auto effect = entry.make(parametersOf(fitted, typical));
  for (const ReplaySample& sample : replay.samples()) {
    const model::Scene scene = model::situationOf(replay.experiment(), *sample.sample).scene;
    const auto moves = [](const model::SceneObject& object) { return object.velocity_m_s != model::Vector3{}; };
    const auto shines = [&](const model::Material& m) { return effect->letsThrough(m) || effect->mirrors(m); };
    if (of_motion && std::any_of(scene.objects.begin(), scene.objects.end(), moves)) return true;
    if (of_ways && std::any_of(scene.materials.begin(), scene.materials.end(), shines)) return true;
  }
  return false;
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
    if (hasSubject(replay, entry, info.fitted)) {
      list.push_back(effectHypothesis(info, info.fitted, ""));
      orderSector(list.back());
      if (info.name == "exhaust-cloud") placeCloud(list.back());
      if (info.name == "quantisation") narrowToComb(replay, list.back());
    }
    for (const model::FittedForm& form : info.other_forms) {
      if (!hasSubject(replay, entry, form.parameters)) continue;
      list.push_back(effectHypothesis(info, form.parameters, form.name));
      list.back().costly = form.costly;
    }
  }
}

/// An uneven gain of the layers has the pattern that the data of some sensors show; how strong it is, is fitted. The
/// gains of all layers would be as many numbers as there are layers.
void addPattern(const Replay& replay, const model::EffectInfo& info, const std::vector<std::string>& seen_by,
                const std::vector<std::string>& sensors, std::vector<Hypothesis>& list) {
  std::vector<double> pattern = unevenPartOf(layerGains(replay, seen_by));
  double squares = 0.0;
  for (double& gain : pattern) {
    gain -= 1.0;
    squares += gain * gain;
  }
  if (squares <= 0.0) return;
  const double stddev = std::sqrt(squares / static_cast<double>(pattern.size()));
  for (double& deviation : pattern) deviation /= stddev;
  Hypothesis hypothesis = effectHypothesis(info, {"stddev"}, "");
  hypothesis.sensors = sensors;
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

/// A number of the model file that is wrong; `value` says its unit, range and what is recorded.
Hypothesis modelParameter(const std::string& pointer, const FreeParameter& value) {
  Hypothesis hypothesis;
  hypothesis.kind = CauseKind::kParameter;
  hypothesis.name = pointer;
  hypothesis.parameters = {value};
  hypothesis.apply = [pointer](World& world, const std::vector<double>& values) {
    json changed = world.model.json;
    changed[json::json_pointer(pointer)] = values[0];
    const model::LidarModel parsed = model::parseModel(changed, world.model.file);
    world.model = parsed;
  };
  return hypothesis;
}

void addModelParameters(const Replay& replay, std::vector<Hypothesis>& list) {
  const json& model = replay.baseline().model.json;
  const auto add = [&](const std::string& pointer, const char* unit, double factor) {
    const json::json_pointer place(pointer);
    if (!model.contains(place) || !model.at(place).is_number()) return;
    const double value = model.at(place).get<double>();
    if (value > 0.0)
      list.push_back(modelParameter(pointer, {"value", unit, value / factor, value * factor, true, value}));
  };
  std::vector<std::string> roots;
  if (model.contains("sensor")) roots.push_back("/sensor");
  if (model.contains("sensors")) {
    for (const auto& item : model["sensors"].items()) roots.push_back("/sensors/" + item.key());
  }
  for (const std::string& root : roots) {
    add(root + "/emitter/peak_power_w", "W", 4.0);
    add(root + "/emitter/pulse_fwhm_ns", "ns", 3.0);
    add(root + "/receiver/noise_w", "W", 10.0);
    add(root + "/receiver/threshold_w", "W", 5.0);
    add(root + "/detection/range_noise_m", "m", 20.0);
    add(root + "/detection/epw_noise_m", "m", 20.0);
    if (replay.baseline().model.has("beam-divergence")) {
      add(root + "/emitter/divergence_rad/horizontal", "rad", 3.0);
      add(root + "/emitter/divergence_rad/vertical", "rad", 3.0);
    }
  }
  for (const model::ActiveEffect& effect : replay.baseline().model.effects) {
    for (const auto& [name, value] : effect.parameters.numbers) {
      const auto& parameters = model::findEffect(effect.name)->info.parameters;
      const auto info =
          std::find_if(parameters.begin(), parameters.end(), [&](const auto& p) { return p.name == name; });
      if (info == parameters.end()) continue;
      const double low = std::max(info->min, value > 0 ? value / 10 : info->min);
      const double high = std::min(info->max, value > 0 ? value * 10 : info->max);
      list.push_back(
          modelParameter("/effects/" + effect.name + "/" + name, {"value", info->unit, low, high, false, value}));
    }
  }
}

/// Objects that hold a notable part of the deviation: a wrong pose or material of any other cannot explain it.
std::set<std::int32_t> suspects(const Replay& replay) {
  constexpr int kFrames = 5;
  constexpr double kNotable = 0.05;
  std::map<std::int32_t, double> deviation;
  double all = 0.0;
  std::vector<Comparison> comparisons;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    comparisons.push_back(
        {s, sample.statistics, sample.frames, replay.simulate(replay.baseline(), s, kFrames, 1), kFrames});
  }
  settle(replay, replay.baseline(), comparisons, {});
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    const auto& simulated = comparisons[s].simulated;
    for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
      const CellStatistics &m = sample.statistics[c], &x = simulated[c];
      double sum = std::abs(m.count / sample.frames - x.count / kFrames) > 0.5 ? 10.0 : 0.0;
      for (const Channel channel : replay.channels()) {
        if (m.count == 0.0 || x.count == 0.0) continue;
        sum += std::max(
            0.0, std::abs(m.mean(channel) - x.mean(channel)) / meanError(replay, sample, c, channel, m, x) - 3.0);
      }
      deviation[sample.layout->cells()[c].object] += sum;
      all += sum;
    }
  }
  std::set<std::int32_t> objects;
  for (const auto& [object, sum] : deviation) {
    if (object >= 0 && sum >= kNotable * all) objects.insert(object);
  }
  return objects;
}

void addMaterials(const model::Scene& scene, const std::set<std::int32_t>& objects, std::vector<Hypothesis>& list) {
  std::set<std::size_t> materials;
  for (const std::int32_t object : objects) materials.insert(scene.objects[static_cast<std::size_t>(object)].material);
  for (const std::size_t index : materials) {
    const model::Material& material = scene.materials[index];
    if (material.reflectivity <= 0.0) continue;
    Hypothesis hypothesis;
    hypothesis.kind = CauseKind::kParameter;
    hypothesis.name = "/materials/" + material.name + "/reflectivity";
    hypothesis.parameters = {{"value", "", material.reflectivity / 5.0, std::min(1.0, 5.0 * material.reflectivity),
                              true, material.reflectivity}};
    const std::string name = material.name;
    hypothesis.apply = [name](World& world, const std::vector<double>& values) {
      world.reflectivity[name] = values[0];
    };
    list.push_back(std::move(hypothesis));
  }
}

/// A quantity that is off by the same everywhere, and one that is off by something else in every set-up.
void addReference(const std::string& pointer, const std::string& unit, double most,
                  const std::vector<std::string>& setups, std::vector<Hypothesis>& list) {
  Hypothesis constant;
  constant.kind = CauseKind::kReference;
  constant.name = pointer;
  constant.parameters = {{"offset", unit, -most, most, false, 0.0}};
  constant.apply = [pointer](World& world, const std::vector<double>& values) {
    world.references.push_back({pointer, values[0], {}});
  };
  list.push_back(constant);
  if (setups.size() < 2) return;
  Hypothesis varying = constant;
  varying.variant = "per set-up";
  varying.per_setup = true;
  varying.parameters.clear();
  for (const std::string& setup : setups) varying.parameters.push_back({setup, unit, -most, most, false, 0.0});
  varying.apply = [pointer, setups](World& world, const std::vector<double>& values) {
    ReferenceOffset offset{pointer, 0.0, {}};
    for (std::size_t i = 0; i < setups.size(); ++i) offset.by_setup[setups[i]] = values[i];
    world.references.push_back(std::move(offset));
  };
  list.push_back(std::move(varying));
}

void addReferences(const Replay& replay, const std::set<std::int32_t>& objects, std::vector<Hypothesis>& list) {
  constexpr std::size_t kMostObjects = 8;  // more of them would cost minutes and teach nothing
  constexpr double kFarthest_m = 0.5, kMost_deg = 15.0;
  std::size_t count = 0;
  std::vector<std::size_t> everything(replay.samples().size());
  std::iota(everything.begin(), everything.end(), std::size_t{0});
  const std::vector<std::string> setups = setupsOf(replay, everything);
  for (const std::int32_t index : objects) {
    if (++count > kMostObjects) break;
    const auto& pose = replay.experiment().json["scene"][static_cast<std::size_t>(index)]["pose"];
    const std::string root = "/scene/" + std::to_string(index) + "/pose/";
    for (const char* axis : {"0", "1"}) {
      addReference(root + "position_m/" + axis, "m", kFarthest_m, setups, list);
    }
    if (pose.contains("yaw_pitch_roll_deg"))
      addReference(root + "yaw_pitch_roll_deg/0", "deg", kMost_deg, setups, list);
  }
}

}  // namespace

std::string toString(CauseKind kind) {
  switch (kind) {
    case CauseKind::kEffect:
      return "effect";
    case CauseKind::kParameter:
      return "parameter";
    case CauseKind::kReference:
      return "reference";
  }
  return "";
}

std::vector<Hypothesis> hypothesesFor(const Replay& replay, const std::vector<std::string>& only) {
  std::vector<Hypothesis> list;
  addEffects(replay, only, list);
  addParts(replay.experiment().sensors, list);
  addPatterns(replay, only, list);
  addModelParameters(replay, list);
  const model::Scene scene = model::situationOf(replay.experiment(), *replay.samples().front().sample).scene;
  const std::set<std::int32_t> objects = suspects(replay);
  addMaterials(scene, objects, list);
  addReferences(replay, objects, list);
  return list;
}

bool asRecorded(const Replay& replay, const Hypothesis& hypothesis, const std::vector<double>& values) {
  if (hypothesis.kind != CauseKind::kReference) return false;
  const auto offsetIn = [&](const model::Sample& sample) {
    const auto own = std::find_if(hypothesis.parameters.begin(), hypothesis.parameters.end(),
                                  [&](const FreeParameter& p) { return p.name == sample.setup; });
    return hypothesis.per_setup ? values[static_cast<std::size_t>(own - hypothesis.parameters.begin())] : values[0];
  };
  return std::all_of(replay.samples().begin(), replay.samples().end(), [&](const ReplaySample& one) {
    const model::Sample& sample = *one.sample;
    return std::any_of(sample.epistemic.begin(), sample.epistemic.end(), [&](const model::Epistemic& epistemic) {
      const double offset = offsetIn(sample);
      return epistemic.path == hypothesis.name && epistemic.low <= offset && offset <= epistemic.high;
    });
  });
}

Hypothesis together(const Hypothesis& a, const Hypothesis& b) {
  Hypothesis both = a;
  both.name = a.name + " + " + b.name;
  both.variant = a.variant.empty() ? b.variant : b.variant.empty() ? a.variant : a.variant + ", " + b.variant;
  both.parameters.insert(both.parameters.end(), b.parameters.begin(), b.parameters.end());
  both.members = {a, b};
  both.seen_in_values = false;  // one of them alone, at best
  const std::size_t split = a.parameters.size();
  both.apply = [first = a.apply, second = b.apply, split](World& world, const std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(split);
    first(world, {values.begin(), middle});
    second(world, {middle, values.end()});
  };
  return both;
}

Hypothesis beside(const Hypothesis& known, const std::vector<double>& values, const Hypothesis& added) {
  Hypothesis both = added;
  both.apply = [first = known.apply, values, second = added.apply](World& world, const std::vector<double>& own) {
    first(world, values);
    second(world, own);
  };
  return both;
}

std::vector<double> inOrder(const std::vector<FreeParameter>& parameters, std::vector<double> values) {
  const auto placeOf = [&](const char* name) {
    const auto found =
        std::find_if(parameters.begin(), parameters.end(), [&](const auto& p) { return p.name == name; });
    return static_cast<std::size_t>(found - parameters.begin());
  };
  const std::size_t from = placeOf("azimuth_from_deg"), to = placeOf("azimuth_to_deg");
  if (from < values.size() && to < values.size() && values[from] > values[to]) std::swap(values[from], values[to]);
  return values;
}

std::vector<double> joined(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace gap
