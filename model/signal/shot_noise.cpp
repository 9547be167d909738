#include "model/signal/shot_noise.h"

#include "core/bulk_math.h"

namespace model {

void BeamNoise::begin(const core::Random::Key& first, std::size_t frames) {
  first_ = first;
  frames_ = frames;
  drawn_ = 0;
}

ShotNoise BeamNoise::of(std::uint32_t frame, std::uint32_t echo) {
  for (; drawn_ <= echo; ++drawn_) {
    if (drawn_ == of_echo_.size()) of_echo_.emplace_back();
    OfFrames& n = of_echo_[drawn_];
    for (std::vector<float>& column : n) column.resize(frames_);
    core::normalsInFrames(first_, drawn_, {n[0], n[1], n[2], n[3]});
  }
  const OfFrames& n = of_echo_[echo];
  const std::size_t shot = frame - first_.frame;
  return {n[0][shot], n[1][shot], n[2][shot]};
}

}  // namespace model
