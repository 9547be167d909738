#pragma once

namespace model {

/// A pulse in the received signal; its shape is the emitter's.
struct Pulse {
  double range_m = 0.0;  ///< c/2 · time of its peak
  double power_w = 0.0;  ///< of its peak

  friend bool operator==(const Pulse&, const Pulse&) = default;
};

}  // namespace model
