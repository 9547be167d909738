#include "metrics/points/cloud_to_cloud.h"

#include "metrics/distributions/summation.h"
#include "metrics/points/nearest_points.h"

namespace metrics {

namespace {

double sumOf(const std::vector<double>& distances) {
  Summation sum;
  for (const double d : distances) sum.add(d);
  return sum.value();
}

}  // namespace

CloudToCloud cloudToCloud(const CloudPair& clouds) {
  const NearestDistances nearest = nearestDistances(clouds);
  const double simulated = sumOf(nearest.of_simulated);
  const double measured = sumOf(nearest.of_measured);
  return {.sum_of_simulated = simulated,
          .sum_of_measured = measured,
          .mean_of_simulated = simulated / static_cast<double>(clouds.simulated.size()),
          .mean_of_measured = measured / static_cast<double>(clouds.measured.size())};
}

}  // namespace metrics
