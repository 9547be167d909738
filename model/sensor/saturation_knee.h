#pragma once

#include "model/sensor/sensor_profile.h"

namespace model {

// How the output of a receiver follows the received power P with `saturation` on; n is its knee_sharpness, P_sat its
// saturation_w. Without either it follows wherever the power goes.
//
//   P_out = P / (1 + (P/P_sat)^n)^(1/n),   for n -> infinity min(P, P_sat)
//
// The receiver's noise is added behind that, where the comparator sees it (formats.md section 3, step 4: s(t) + n
// exceeds the threshold): a bent pulse crosses the threshold less steeply, and noise moves its edges further.
// Source: Rapp 1991, Proc. 2nd European Conf. on Satellite Communications, ESA SP-332, pp. 179-184 (n = 2p).

/// The output that belongs to a received power.
[[nodiscard]] double outputOf_w(double received_w, const Receiver& receiver);

/// The received power at which the output is so high; infinity if it never gets there.
[[nodiscard]] double receivedFor_w(double output_w, const Receiver& receiver);

}  // namespace model
