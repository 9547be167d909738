#include "gap/causes/hypotheses.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/causes/kinds.h"
#include "gap/distance/discrepancy.h"
#include "gap/distance/settle.h"

namespace gap {

namespace {

constexpr std::size_t kMostPoses = 8;  // of objects: more of them would cost minutes and teach nothing

/// Objects that hold a notable part of the deviation, with what they hold, the most first: a wrong pose or material of
/// any other cannot explain it.
std::vector<std::pair<double, std::string>> suspects(const Replay& replay) {
  constexpr int kFrames = 5;
  constexpr double kNotable = 0.05;
  std::map<std::string, double> deviation;
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
      const std::int32_t object = sample.layout->cells()[c].object;
      if (object >= 0) deviation[sample.scene.objects[static_cast<std::size_t>(object)].id] += sum;
      all += sum;
    }
  }
  std::vector<std::pair<double, std::string>> objects;
  for (const std::string& object : objectsOf(replay)) {
    const double sum = deviation[object];
    if (sum > 0.0 && sum >= kNotable * all) objects.emplace_back(sum, object);
  }
  std::stable_sort(objects.begin(), objects.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  return objects;
}

/// In the order of the scene.
std::vector<std::string> firstOf(const Replay& replay, const std::vector<std::pair<double, std::string>>& suspects,
                                 std::size_t most) {
  const auto end = suspects.begin() + static_cast<std::ptrdiff_t>(std::min(most, suspects.size()));
  std::vector<std::string> objects = objectsOf(replay);
  std::erase_if(objects, [&](const std::string& object) {
    return std::none_of(suspects.begin(), end, [&](const auto& suspect) { return suspect.second == object; });
  });
  return objects;
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
  addEffectHypotheses(replay, only, list);
  const auto objects = suspects(replay);
  addParameterHypotheses(replay, firstOf(replay, objects, objects.size()), list);
  addReferenceHypotheses(replay, firstOf(replay, objects, kMostPoses), list);
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
