#pragma once

#include <vector>

namespace withheld {

/// Light that comes back: an impulse of the waveform.
struct Arrival {
  double range_m;  ///< half the way that it took
  double power_w;  ///< peak power of its pulse
  int source;      ///< which object (or ghost) sent it back; kVolume: a medium, never averaged
};

constexpr int kVolume = -1;

}  // namespace withheld
