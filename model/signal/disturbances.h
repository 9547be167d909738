#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "model/effects/effect.h"

namespace model {

/// An effect that draws random numbers has a stream of its own: switching it on changes nobody else's noise.
struct DrawingEffect {
  const Effect* effect;
  std::uint32_t purpose;

  [[nodiscard]] core::Random::Key keyOf(core::Random::Key shot) const {
    shot.purpose = purpose;
    return shot;
  }
};

/// What some effects do to the shots of a few frames; what all beams of a frame share is drawn once.
class Disturbances {
 public:
  /// `first` is the key of any shot of the first of so many frames. Lives no longer than effects, scene and settings.
  Disturbances(const std::vector<DrawingEffect>& effects, const Scene& scene, const ChainSettings& settings,
               const core::Random::Key& first, int frames);

  /// Disturbs the pulses of a shot. `shot` is its key; its frame must be one of those.
  void disturb(const BeamView& view, const core::Random::Key& shot, std::vector<Pulse>& pulses) const;

 private:
  const std::vector<DrawingEffect>& effects_;
  std::uint32_t first_frame_;
  std::vector<std::unique_ptr<const Disturbance>> in_frames_;  ///< of every effect, frame by frame
};

}  // namespace model
