#pragma once

namespace model {

/// A pulse in the received signal; its shape is the emitter's.
struct Pulse {
  double range_m = 0.0;  ///< c/2 · time of its peak
  double power_w = 0.0;  ///< of its peak
  /// Sent back by a surface, whose roughness makes coherent light fluctuate; not by air, drops or another emitter.
  bool of_surface = true;

  friend bool operator==(const Pulse&, const Pulse&) = default;
};

/// What chance makes of the power of one shot; 1 is no change.
struct Fluctuation {
  double of_all = 1.0;       ///< of every pulse
  double of_surfaces = 1.0;  ///< besides, of what surfaces send back

  [[nodiscard]] double ofSurface() const { return of_all * of_surfaces; }
  [[nodiscard]] double of(const Pulse& pulse) const { return pulse.of_surface ? ofSurface() : of_all; }
};

}  // namespace model
