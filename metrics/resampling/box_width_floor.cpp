#include "metrics/resampling/box_width_floor.h"

#include <fmt/format.h>
#include <vector>

#include "core/error.h"
#include "metrics/distributions/p_box.h"
#include "metrics/resampling/exchange.h"
#include "metrics/resampling/replicated.h"

namespace metrics {

NullDistribution boxWidthFloor(std::span<const UnitSample> runs, const BoxWidthOptions& options,
                               core::Progress& progress) {
  if (runs.size() < 2) {
    throw core::InputError({}, fmt::format("{} runs make no box with a width.", runs.size()),
                           "Give two or more simulated samples.");
  }
  const Exchange exchange(runs, std::vector<double>(runs.size(), 0.0));
  return NullDistribution(
      replicated<double>(options.replicates, options.seed, "box width floor", progress,
                         [&](core::Random& random) { return PBox::envelope(exchange.dealt(random)).area(); }));
}

}  // namespace metrics
