#include "gap/candidates/scouted_samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "gap/causes/fit.h"

namespace gap {

namespace {

constexpr double kBeyond = 3.0;  // standard errors: of a thousand cells hardly three deviate so far by chance
constexpr double kFarMore = 3.0;
constexpr double kClear = 5.0;  // standard errors beyond those, of all cells together: noise makes two or three

/// How far the cells of each sample deviate beyond what is noise, in standard errors.
std::map<std::size_t, double> deviationsIn(const WhereResult& where) {
  std::map<std::size_t, double> deviations;
  for (const ResidualTable& table : where.tables)
    for (const ResidualTable::Row& row : table.rows)
      if (row.error > 0.0) deviations[row.sample] += std::max(0.0, std::abs(row.value) / row.error - kBeyond);
  return deviations;
}

}  // namespace

Evidence scoutedSamples(const Evidence& evidence, const WhereResult& where) {
  Evidence few = spreadOver(evidence, kScoutedSamples, evidence.most_frames);
  std::map<std::size_t, double> deviations = deviationsIn(where);
  const auto most = [&](const std::vector<std::size_t>& samples) {
    std::pair<double, std::size_t> found;
    for (const std::size_t sample : samples) found = std::max(found, {deviations[sample], sample});
    return found;
  };
  const auto [deviation, outstanding] = most(evidence.samples);
  if (deviation >= std::max(kClear, kFarMore * most(few.samples).first)) {
    few.samples.push_back(outstanding);
    std::sort(few.samples.begin(), few.samples.end());
  }
  return few;
}

}  // namespace gap
