#pragma once

#include <string>
#include <vector>

#include "gap/replay/replay.h"

namespace gap {

/// By what factor the received power of each layer of some sensors, all of which have as many layers, differs from the
/// baseline's: the median, over the cells of their samples that are not of role `prediction` (of all, if there are no
/// others), of the ratio that intensity shows, or of the one that the echo pulse width shows by P/P' = 2^((E² - E'²) /
/// (c·FWHM)²) (formats.md section 3, step 6). NaN for a layer with fewer than five cells: nobody sees what it receives.
/// Empty if there is one layer, or sensors have not as many, or neither channel was measured.
[[nodiscard]] std::vector<double> layerGains(const Replay& replay, const std::vector<std::string>& sensors);

/// Gains without the factor that all layers seen share beyond chance (Student's t of their logarithms): a weaker
/// emitter, or fog, is no unevenness, and neither is what a single layer has.
[[nodiscard]] std::vector<double> unevenPartOf(std::vector<double> gains);

}  // namespace gap
