#pragma once

#include <map>
#include <string>

#include "bench/withheld/generator/effects.h"
#include "bench/withheld/generator/profile.h"
#include "bench/withheld/generator/waveform.h"

namespace withheld {

/// The world: a model file whose effects all truly exist. `x-pulse`: "gaussian" (as without it) or "measured-like",
/// which rises in 40 % of its width and falls in 60 %. `rays_per_beam` is read and not used: the footprint is the
/// generator's own.
struct World {
  std::map<std::string, Profile> sensors;  ///< by name; a single sensor has the name ""
  Effects effects;
  double pulse_rise_share = 0.5;
  std::uint64_t seed = 1;
};

/// `profiles`: the folder in which a sensor that is given by its id is looked up. Throws BadInput.
[[nodiscard]] World readWorld(const std::string& file, const std::string& profiles);

}  // namespace withheld
