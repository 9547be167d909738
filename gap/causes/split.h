#pragma once

#include <cstdint>

#include "gap/causes/fit.h"

namespace gap {

/// Which data are fitted and which judge.
struct Split {
  Evidence fitted;
  Evidence held_out;
  Evidence refined;   ///< as fitted, with more frames: for candidates that are nearly right
  bool weak = false;  ///< no whole sample is held out: beams of the same samples judge
};

/// Samples of role `prediction` judge, the others are fitted. Without them every third sample judges; with fewer than
/// three samples the beams are split.
[[nodiscard]] Split splitOf(const Replay& replay, std::uint64_t seed);

/// Every second beam of all samples judges (Half): the weaker way, where no whole sample can.
[[nodiscard]] Split splitByBeams(const Replay& replay, std::uint64_t seed);

}  // namespace gap
