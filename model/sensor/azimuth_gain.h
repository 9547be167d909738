#pragma once

#include <vector>

#include "core/json_object.h"

namespace model {

/// Share of the emitter's peak power that goes out towards an azimuth: a table, straight between its points, held at
/// its first and last value beyond them. Without points it is 1 everywhere.
///
///   gain 1 |     ________          windows, mirrors and lenses vignette a scan
///          |   _/        \_        towards its ends
///        0 |__/____________\__
///                azimuth [deg]
struct AzimuthGain {
  std::vector<double> azimuth_deg;  ///< rising
  std::vector<double> gain;         ///< 0 … 1, one per azimuth

  [[nodiscard]] double at(double azimuth_deg) const;
};

/// {"azimuth_deg": [rising …], "gain": [0 … 1, as many]}
[[nodiscard]] AzimuthGain readAzimuthGain(core::JsonObject object);

}  // namespace model
