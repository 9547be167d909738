#pragma once

#include "bench/withheld/generator/echoes.h"
#include "bench/withheld/generator/footprint.h"
#include "bench/withheld/generator/reflection.h"

namespace withheld {

/// All that one sample is made of. Refers to profile and effects: keep them alive.
struct Situation {
  const Profile& profile;
  const Effects& effects;
  Environment environment;
  Scene scene;
  std::vector<Beam> beams;
  int frames = 1;
  Pulse pulse;
  std::uint64_t seed = 1, sample = 0;
};

/// Fires every beam once at the unmoving scene, then reads it out frame after frame with fresh noise. What changes from
/// shot to shot (jitter, speckle, drops, spray, foreign light) changes the impulses; else the waveform is kept.
///
/// - footprint: 48 sub-rays where all meet one even face, 768 where they do not;
/// - stray light: a halo that falls with one over the angle, not a pedestal;
/// - blooming: what spills over falls with the square of the distance in columns;
/// - multipath: up to `max_bounces` − 1 mirrors on the way out, the same on the way back.
[[nodiscard]] std::vector<Detection> fireAll(const Situation& situation);

}  // namespace withheld
