#include "core/parallel.h"

#include <algorithm>
#include <memory>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace core {

void limitThreads(int threads) {
  static std::unique_ptr<tbb::global_control> control;  // the one process-wide setting that TBB has
  control.reset();
  if (threads > 0) {
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(threads));
  }
}

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  grain = std::max<std::size_t>(1, grain);
  const std::size_t pieces = (count + grain - 1) / grain;
  // Isolated: when another piece of an outer loop throws, TBB would end this loop early and in silence, and its caller
  // would go on with half of the results.
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, pieces, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t piece = range.begin(); piece != range.end(); ++piece) {
          body(piece * grain, std::min(count, (piece + 1) * grain));
        }
      },
      context);
}

}  // namespace core
