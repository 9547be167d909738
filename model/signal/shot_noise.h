#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/random.h"

namespace model {

/// The noise of one shot: of the received power, of the range and of the pulse width. Standard normal numbers, three a
/// beam and echo.
struct ShotNoise {
  float power = 0.0F;
  float range = 0.0F;
  float epw = 0.0F;
};

/// The noise of the shots of one beam, drawn for all its frames at once when the first of them asks.
class BeamNoise {
 public:
  /// `first` is the key of the shot in the first of so many frames.
  void begin(const core::Random::Key& first, std::size_t frames);
  /// Of the echo `echo` (or of that part of the waveform) of the shot in a frame.
  [[nodiscard]] ShotNoise of(std::uint32_t frame, std::uint32_t echo);

 private:
  using OfFrames = std::array<std::vector<float>, 4>;

  core::Random::Key first_;
  std::size_t frames_ = 0;
  std::uint32_t drawn_ = 0;  ///< echoes
  std::vector<OfFrames> of_echo_;
};

}  // namespace model
