#pragma once

#include <optional>

#include "gap/candidates/candidates.h"

namespace gap {

/// How a measurement's losses vary from beam to beam, where a cause says that every shot is alike.
struct UnevenLoss {
  double mean = 0.0;    ///< share of the echoes that the cause loses, of strong echoes off edges
  double stddev = 0.0;  ///< of what the beams' shares deviate from the cause's, beyond chance
  double unhurt = 0.0;  ///< share of the beams that lose less than half of the mean
  std::size_t beams = 0;
  double z = 0.0;                    ///< of the variance between beams above that of chance, in standard deviations
  std::optional<double> period_deg;  ///< of azimuth, if they come and go with it
};

/// Looks at strong echoes off edges only: these get lost by nothing else, and two programs agree on them. Losses of one
/// beam are counted over all frames and samples. Nothing if no member of the cause takes echoes from all shots alike
/// (model::EffectInfo::every_shot_alike) or corrects how many of them, or if they vary by less than half of their mean,
/// or not beyond doubt: neither from beam to beam, nor as a wave over azimuth.
///
/// The variance between beams beyond that of Bernoulli trials is found by the method of moments, as in tests of
/// overdispersion (Cochran 1954, Some methods for strengthening the common χ² tests, Biometrics 10, 417, section 4:
/// the index of dispersion). Losses too rare for that show in stripes: the largest power of the sines over azimuth, of
/// standard normal deviates 1 on average, is larger than x with a probability of M exp(-x), M the number of periods
/// that were tried (Scargle 1982, Astrophys. J. 263, 835, section III).
[[nodiscard]] std::optional<UnevenLoss> unevenLossIn(const Judge& judge, const Candidate& cause);

}  // namespace gap
