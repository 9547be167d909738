#include "model/sensor/azimuth_gain.h"

#include <algorithm>
#include <fmt/format.h>

namespace model {

double AzimuthGain::at(double azimuth) const {
  if (azimuth_deg.empty()) return 1.0;
  const auto right = std::upper_bound(azimuth_deg.begin(), azimuth_deg.end(), azimuth);
  if (right == azimuth_deg.begin()) return gain.front();
  if (right == azimuth_deg.end()) return gain.back();
  const auto i = static_cast<std::size_t>(right - azimuth_deg.begin());
  const double share = (azimuth - azimuth_deg[i - 1]) / (azimuth_deg[i] - azimuth_deg[i - 1]);
  return gain[i - 1] + share * (gain[i] - gain[i - 1]);
}

AzimuthGain readAzimuthGain(core::JsonObject object) {
  AzimuthGain table;
  table.azimuth_deg = object.numbers("azimuth_deg");
  table.gain = object.numbers("gain", table.azimuth_deg.size());
  if (table.azimuth_deg.empty()) object.fail("azimuth_deg", "is empty.", "Give at least one azimuth, or no table.");
  for (std::size_t i = 0; i < table.gain.size(); ++i) {
    if (i > 0 && table.azimuth_deg[i] <= table.azimuth_deg[i - 1]) {
      object.fail(fmt::format("azimuth_deg/{}", i),
                  fmt::format("is {}, after {}; the table must rise.", table.azimuth_deg[i], table.azimuth_deg[i - 1]),
                  "Sort the table by azimuth, each azimuth once.");
    }
    if (table.gain[i] < 0.0 || table.gain[i] > 1.0) {
      object.fail(fmt::format("gain/{}", i), fmt::format("is {}; it must be 0 to 1.", table.gain[i]),
                  "Give the share of emitter/peak_power_w that goes out there.");
    }
  }
  object.finish();
  return table;
}

}  // namespace model
