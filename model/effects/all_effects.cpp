#include "model/effects/declarations.h"

namespace model {

// The list to read to see what the sensor can do. An explicit list: static self-registration is dropped by the linker.
const std::vector<EffectEntry>& allEffects() {
  static const std::vector<EffectEntry> entries = {
      effects::beamDivergence(),
      effects::apertureOffset(),
      effects::strayRadiation(),
      effects::mountingError(),
      effects::pulseJitter(),
      effects::atmosphericAttenuation(),
      effects::atmosphericBackscatter(),
      effects::precipitationClutter(),
      effects::roadSpray(),
      effects::exhaustCloud(),
      effects::crosstalk(),
      effects::spoofing(),
      effects::blinding(),
      effects::angularReflection(),
      effects::surfaceMoisture(),
      effects::retroreflection(),
      effects::transmission(),
      effects::multipath(),
      effects::pulseBroadening(),
      effects::speckle(),
      effects::motionScan(),
      effects::coverContamination(),
      effects::photoResponseNonuniformity(),
      effects::backgroundLight(),
      effects::thermalNoise(),
      effects::saturation(),
      effects::blooming(),
      effects::deadTime(),
      effects::rangeWalk(),
      effects::dynamicThreshold(),
      effects::quantisation(),
      effects::rangeGating(),
      effects::echoMerging(),
      effects::latency(),
      effects::clockDrift(),
      effects::rangeOffset(),
      effects::angleClipping(),
      effects::falseAlarm(),
      effects::detectionLoss(),
  };
  return entries;
}

}  // namespace model
