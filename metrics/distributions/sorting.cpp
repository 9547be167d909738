#include "metrics/distributions/sorting.h"

#include <algorithm>
#include <hwy/contrib/sort/vqsort.h>

namespace metrics {

void sortAscending(std::span<double> finite) {
  if (std::is_sorted(finite.begin(), finite.end())) return;
  hwy::Sorter()(finite.data(), finite.size(), hwy::SortAscending());
}

}  // namespace metrics
