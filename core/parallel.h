#pragma once

#include <cstddef>
#include <functional>

namespace core {

/// How many threads the whole program may use: 0 means all cores. Call once, before any work.
void limitThreads(int threads);

/// Runs body(begin, end) over pieces of [0, count) on all allowed threads and waits. The pieces have `grain` elements,
/// whatever the number of threads, so a sum per piece is reproducible. An exception of a body reaches the caller; a
/// loop within a body is always run to its end, whatever happens in other bodies.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace core
