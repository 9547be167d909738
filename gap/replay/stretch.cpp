#include "gap/replay/stretch.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace gap {

double stretchOf_m(const model::HitsOfBeam& hits) {
  double nearest_m = std::numeric_limits<double>::infinity(), farthest_m = 0.0;
  for (const model::Hit& hit : hits) {
    nearest_m = std::min(nearest_m, static_cast<double>(hit.range_m));
    farthest_m = std::max(farthest_m, static_cast<double>(hit.range_m));
  }
  return farthest_m - nearest_m;
}

bool isTornApart(const model::HitsOfBeam& hits, const model::SubRays& rays, double most_m) {
  if (!(stretchOf_m(hits) > most_m)) return false;  // most beams; sorting takes long
  std::vector<double> ranges_m;
  for (const model::Hit& hit : hits)
    if (rays.weight[hit.ray] > 0.0) ranges_m.push_back(hit.range_m);
  std::sort(ranges_m.begin(), ranges_m.end());
  const auto apart = [most_m](double nearer_m, double farther_m) { return farther_m - nearer_m > most_m; };
  return std::adjacent_find(ranges_m.begin(), ranges_m.end(), apart) != ranges_m.end();
}

}  // namespace gap
