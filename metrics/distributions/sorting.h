#pragma once

#include <span>

namespace metrics {

/// Into ascending order, in time n if they are already. Finite numbers only, and no -0: then the order is unique and
/// the same bytes come out on every processor. Vectorised quicksort with the widest registers that the processor has.
/// Source: Wassenberg et al. 2022, doi:10.48550/arXiv.2205.05982 (Highway's VQSort).
void sortAscending(std::span<double> finite);

}  // namespace metrics
