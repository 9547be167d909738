#pragma once

#include "model/effect.h"

namespace model::effects {

// One line an effect: each file of this folder defines one of these. The list in all_effects.cpp is the library.
EffectEntry beamDivergence();
EffectEntry atmosphericAttenuation();
EffectEntry angularReflection();
EffectEntry pulseBroadening();
EffectEntry coverContamination();
EffectEntry rangeWalk();
EffectEntry quantisation();
EffectEntry rangeOffset();
EffectEntry angleClipping();
EffectEntry detectionLoss();

/// Maker of an effect class that is constructed from its parameters.
template <typename EffectClass>
std::unique_ptr<Effect> makeFrom(const EffectParameters& parameters) {
  return std::make_unique<EffectClass>(parameters);
}

}  // namespace model::effects
