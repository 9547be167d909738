#include "model/signal/disturbances.h"

namespace model {

namespace {

constexpr std::uint32_t kWholeFrame = 0xFFFFFFFF;  // in place of a beam: of what the beams of a frame share

}  // namespace

Disturbances::Disturbances(const std::vector<DrawingEffect>& effects, const Scene& scene, const ChainSettings& settings,
                           const core::Random::Key& first, int frames)
    : effects_(effects), first_frame_(first.frame) {
  core::Random::Key of_frame = first;
  of_frame.beam = kWholeFrame;
  for (int f = 0; f < frames; ++f, ++of_frame.frame) {
    for (const DrawingEffect& drawing : effects_)
      in_frames_.push_back(drawing.effect->inFrame(scene, settings, drawing.keyOf(of_frame)));
  }
}

void Disturbances::disturb(const BeamView& view, const core::Random::Key& shot, std::vector<Pulse>& pulses) const {
  const std::size_t frame = shot.frame - first_frame_;
  for (std::size_t e = 0; e < effects_.size(); ++e)
    in_frames_[frame * effects_.size() + e]->disturb(view, effects_[e].keyOf(shot), pulses);
}

}  // namespace model
