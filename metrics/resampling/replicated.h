#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/parallel.h"
#include "core/progress.h"
#include "core/random.h"

namespace metrics {

/// `count` results of replicate(random), each with a random stream of its own: the same for any number of threads.
template <typename Result, typename Replicate>
std::vector<Result> replicated(std::size_t count, std::uint64_t seed, const char* purpose, core::Progress& progress,
                               Replicate replicate) {
  std::vector<Result> results(count);
  std::atomic<std::size_t> done = 0;
  core::parallelFor(count, 1, [&](std::size_t b, std::size_t) {
    core::stopIfCancelled(progress);
    core::Random random({.seed = seed, .sample = static_cast<std::uint32_t>(b), .purpose = core::purposeOf(purpose)});
    results[b] = replicate(random);
    progress.report(static_cast<double>(++done) / static_cast<double>(count), "resampling");
  });
  return results;
}

}  // namespace metrics
