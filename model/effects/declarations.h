#pragma once

#include "model/effects/effect.h"

namespace model::effects {

// One line an effect: each file of this folder defines one of these. The list in all_effects.cpp is the library.
EffectEntry beamDivergence();
EffectEntry apertureOffset();
EffectEntry strayRadiation();
EffectEntry mountingError();
EffectEntry pulseJitter();
EffectEntry atmosphericAttenuation();
EffectEntry atmosphericBackscatter();
EffectEntry precipitationClutter();
EffectEntry roadSpray();
EffectEntry exhaustCloud();
EffectEntry crosstalk();
EffectEntry spoofing();
EffectEntry blinding();
EffectEntry angularReflection();
EffectEntry surfaceMoisture();
EffectEntry retroreflection();
EffectEntry transmission();
EffectEntry multipath();
EffectEntry pulseBroadening();
EffectEntry speckle();
EffectEntry motionScan();
EffectEntry coverContamination();
EffectEntry photoResponseNonuniformity();
EffectEntry backgroundLight();
EffectEntry thermalNoise();
EffectEntry saturation();
EffectEntry blooming();
EffectEntry deadTime();
EffectEntry rangeWalk();
EffectEntry dynamicThreshold();
EffectEntry quantisation();
EffectEntry rangeGating();
EffectEntry echoMerging();
EffectEntry latency();
EffectEntry clockDrift();
EffectEntry rangeOffset();
EffectEntry angleClipping();
EffectEntry falseAlarm();
EffectEntry detectionLoss();

/// Maker of an effect class that is constructed from its parameters.
template <typename EffectClass>
std::unique_ptr<Effect> makeFrom(const EffectParameters& parameters) {
  return std::make_unique<EffectClass>(parameters);
}

}  // namespace model::effects
