#pragma once

#include "model/sensor/sensor_profile.h"

namespace model {

/// Share of the beam's disc that the receiver sees at a range, 0 … 1. Emitter and receiver look out side by side:
///
///   χ(r) = share of the beam's disc (radius r φ/2) inside the field of view's disc (radius D/2 + r Ψ/2),
///          centres `axis_offset_m` apart, axes parallel
///
/// φ and Ψ are the horizontal full widths, the vertical ones if those are zero. Without a field of view in the profile
/// χ = 1. Source: Stelmaszczyk et al. 2005, doi:10.1364/AO.44.001323 (geometrical compression form factor).
[[nodiscard]] double overlap(const Emitter& emitter, const Receiver& receiver, double range_m);

}  // namespace model
