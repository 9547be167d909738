#include "model/effects/declarations.h"

namespace model {

// The list to read to see what the sensor can do. An explicit list: static self-registration is dropped by the linker.
const std::vector<EffectEntry>& allEffects() {
  static const std::vector<EffectEntry> entries = {
      effects::beamDivergence(),
      effects::atmosphericAttenuation(),
      effects::angularReflection(),
      effects::pulseBroadening(),
      effects::coverContamination(),
      effects::rangeWalk(),
      effects::quantisation(),
      effects::rangeOffset(),
      effects::angleClipping(),
      effects::detectionLoss(),
  };
  return entries;
}

}  // namespace model
