#include "model/signal/power_stage.h"

#include <algorithm>
#include <numbers>

namespace model {

namespace {

/// One pulse per object, in the order in which the objects are met; ranges are weighted with power.
void pulsePerObject(const TracedBeams& traced, std::size_t beam, std::span<const double> power_w,
                    std::vector<std::int32_t>& objects, std::vector<Pulse>& out) {
  const std::size_t first = traced.hits.first[traced.first_beam], begin = traced.hits.first[traced.first_beam + beam];
  const std::size_t end = traced.hits.first[traced.first_beam + beam + 1];
  objects.clear();
  const std::size_t before = out.size();
  for (std::size_t i = begin; i < end; ++i) {
    const std::int32_t object = traced.hits.object[i];
    std::size_t known = object < 0 ? objects.size() : 0;  // hits from elsewhere may not know what they are of
    while (known < objects.size() && objects[known] != object) ++known;
    if (known == objects.size()) {
      objects.push_back(object);
      out.push_back({});
    }
    Pulse& pulse = out[before + known];
    pulse.range_m += power_w[i - first] * traced.hits.range_m[i];  // divided by the power below
    pulse.power_w += power_w[i - first];
  }
  for (std::size_t p = before; p < out.size(); ++p) {
    if (out[p].power_w > 0.0) out[p].range_m /= out[p].power_w;
  }
}

}  // namespace

void Pulses::clear() {
  first.assign(1, 0);
  pulses.clear();
}

void Pulses::add(std::span<const Pulse> of_next_beam) {
  pulses.insert(pulses.end(), of_next_beam.begin(), of_next_beam.end());
  first.push_back(static_cast<std::uint32_t>(pulses.size()));
}

PowerStage::PowerStage(const ChainSettings& settings, std::span<const Effect* const> effects, const Scene& scene)
    : settings_(settings), scene_(scene) {
  const double diameter_m = settings.receiver.aperture_diameter_m;
  constant_w_m2_ =
      settings.emitter.peak_power_w * settings.receiver.efficiency * std::numbers::pi / 4.0 * diameter_m * diameter_m;
  for (const SceneObject& object : scene.objects) {
    materials_.push_back(&scene.materials[object.material]);
    reflectivity_over_pi_.push_back(materials_.back()->reflectivity / std::numbers::pi);
  }
  for (const Effect* effect : effects) {
    if (effect->changesPower()) power_effects_.push_back(effect);
    if (effect->addsPulses()) pulse_effects_.push_back(effect);
  }
}

BeamView PowerStage::viewOf(const Beam& beam, const HitsOfBeam& hits, const SubRays& rays) const {
  return {beam, hits, scene_, settings_, rays, constant_w_m2_ * beam.gain};
}

void PowerStage::weaken(const TracedBeams& traced, std::size_t begin, const Effect& effect,
                        std::span<double> power_w) const {
  const Hits& hits = traced.hits;
  if (effect.weakensInBulk()) {
    effect.weaken({std::span(hits.range_m).subspan(begin, power_w.size()),
                   std::span(hits.cos_incidence).subspan(begin, power_w.size()),
                   std::span(hits.object).subspan(begin, power_w.size()), materials_, power_w});
    return;
  }
  for (std::size_t b = 0; b < traced.beams.size(); ++b) {
    for (std::size_t i = hits.first[traced.first_beam + b]; i < hits.first[traced.first_beam + b + 1]; ++i) {
      power_w[i - begin] *= effect.powerFactor({traced.beams[b],
                                                traced.rays.left_rad[hits.ray[i]],
                                                traced.rays.up_rad[hits.ray[i]],
                                                hits.range_m[i],
                                                hits.cos_incidence[i],
                                                *materials_[static_cast<std::size_t>(hits.object[i])],
                                                {}});
    }
  }
}

void PowerStage::powersOf(const TracedBeams& traced, std::vector<double>& power_w) const {
  const Hits& hits = traced.hits;
  const std::size_t begin = hits.first[traced.first_beam], end = hits.first[traced.first_beam + traced.beams.size()];
  power_w.resize(end - begin);
  if (!traced.power_w.empty()) {
    std::copy_n(traced.power_w.begin() + static_cast<std::ptrdiff_t>(begin), end - begin, power_w.begin());
    return;
  }
  for (std::size_t b = 0; b < traced.beams.size(); ++b) {
    const double constant_w_m2 = constant_w_m2_ * traced.beams[b].gain;
    for (std::size_t i = hits.first[traced.first_beam + b]; i < hits.first[traced.first_beam + b + 1]; ++i) {
      power_w[i - begin] = constant_w_m2 * traced.rays.weight[hits.ray[i]] *
                           reflectivity_over_pi_[static_cast<std::size_t>(hits.object[i])] *
                           static_cast<double>(hits.cos_incidence[i]) / (hits.range_m[i] * hits.range_m[i]);
    }
  }
  for (const Effect* effect : power_effects_) weaken(traced, begin, *effect, power_w);
}

double PowerStage::powerOf(const Beam& beam, const SubRays& rays, const SecondHit& second) const {
  std::array<Crossing, SecondHit::kMostTurns> crossings;
  for (std::size_t t = 0; t < second.turn_count; ++t) {
    const Turn& turn = second.turns[t];
    crossings[t] = {turn.mirrored ? Crossing::Way::kMirrored : Crossing::Way::kThrough,
                    materials_[static_cast<std::size_t>(turn.object)], turn.cos_incidence};
  }
  const Hit& hit = second.hit;
  const auto object = static_cast<std::size_t>(hit.object);
  const Reflection reflection{beam,
                              rays.left_rad[hit.ray],
                              rays.up_rad[hit.ray],
                              hit.range_m,
                              hit.cos_incidence,
                              *materials_[object],
                              std::span(crossings).first(second.turn_count)};
  double power_w = constant_w_m2_ * beam.gain * rays.weight[hit.ray] * reflectivity_over_pi_[object] *
                   static_cast<double>(hit.cos_incidence) / (hit.range_m * hit.range_m);
  for (const Effect* effect : power_effects_) power_w *= effect->powerFactor(reflection);
  return power_w;
}

void PowerStage::receive(const TracedBeams& traced, Scratch& scratch, Pulses& out) const {
  powersOf(traced, scratch.power_w);
  out.clear();
  const std::vector<std::uint32_t>& first = traced.hits.first;
  const std::size_t begin = first[traced.first_beam];
  const bool straight = pulse_effects_.empty() && traced.first_second.empty();
  for (std::size_t b = 0; b < traced.beams.size(); ++b) {
    const std::size_t of_beam = first[traced.first_beam + b], end = first[traced.first_beam + b + 1];
    if (end == of_beam + 1) {
      out.pulses.push_back({traced.hits.range_m[of_beam], scratch.power_w[of_beam - begin]});
    } else if (settings_.broadens_pulses) {
      for (std::size_t i = of_beam; i < end; ++i) {
        out.pulses.push_back({traced.hits.range_m[i], scratch.power_w[i - begin]});
      }
    } else {
      pulsePerObject(traced, b, scratch.power_w, scratch.objects, out.pulses);
    }
    if (!straight) receiveOtherwise(traced, b, scratch, out);
    out.first.push_back(static_cast<std::uint32_t>(out.pulses.size()));
  }
}

/// What reaches the receiver by way of panes and mirrors, and what effects add. These see the pulses of this beam only.
void PowerStage::receiveOtherwise(const TracedBeams& traced, std::size_t b, Scratch& scratch, Pulses& out) const {
  std::vector<Pulse>& pulses = scratch.of_beam;
  const auto begin = out.pulses.begin() + static_cast<std::ptrdiff_t>(out.first.back());
  pulses.assign(begin, out.pulses.end());
  out.pulses.erase(begin, out.pulses.end());
  const std::span<const SecondHit> of_beam = traced.secondOf(b);
  for (std::size_t i = 0; i < of_beam.size(); ++i) {
    const double power_w = traced.second_power_w.empty() ? powerOf(traced.beams[b], traced.rays, of_beam[i])
                                                         : traced.second_power_w[traced.first_second[b] + i];
    pulses.push_back({of_beam[i].hit.range_m, power_w});
  }
  const HitsOfBeam hits = traced.hitsOf(b);
  for (const Effect* effect : pulse_effects_) {
    effect->addPulses(viewOf(traced.beams[b], hits, traced.rays), pulses);
  }
  out.pulses.insert(out.pulses.end(), pulses.begin(), pulses.end());
}

}  // namespace model
