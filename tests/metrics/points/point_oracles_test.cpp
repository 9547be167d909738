#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>

#include "metrics/points/cloud_to_cloud.h"
#include "metrics/points/hausdorff.h"
#include "metrics/points/point_wasserstein.h"
#include "tests/metrics/points/random_clouds.h"
#include "tests/support/paths.h"

namespace {

struct OracleCase {
  metrics_test::Cloud simulated;
  metrics_test::Cloud measured;
  std::map<std::string, double> values;
};

/// tests/data/metrics/points/point_oracles.csv; the script beside it says what a line means.
std::map<int, OracleCase> readCases() {
  std::map<int, OracleCase> cases;
  std::ifstream file(test_support::testData("metrics/points/point_oracles.csv"));
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::string kind;
    std::string number;
    std::string name;
    std::getline(cells, kind, ',');
    std::getline(cells, number, ',');
    std::getline(cells, name, ',');
    OracleCase& one = cases[std::stoi(number)];
    char comma = ',';
    if (kind == "value") {
      cells >> one.values[name];
    } else {
      metrics::Position p;
      cells >> p.x_m >> comma >> p.y_m >> comma >> p.z_m;
      (name == "s" ? one.simulated : one.measured).push_back(p);
    }
  }
  return cases;
}

// scipy 1.10.1: directed_hausdorff, cdist, linear_sum_assignment. Tolerance: sums of at most 480 rounded terms.
TEST(PointOracles, AgreeWithScipy) {
  const auto cases = readCases();
  ASSERT_EQ(cases.size(), 7U);
  for (const auto& [number, one] : cases) {
    SCOPED_TRACE(number);
    ASSERT_EQ(one.values.size(), 6U);
    const metrics::CloudPair clouds{.simulated = one.simulated, .measured = one.measured};
    const metrics::Hausdorff farthest = metrics::hausdorff(clouds);
    EXPECT_NEAR(farthest.of_simulated, one.values.at("hausdorff_of_simulated"), 1e-12);
    EXPECT_NEAR(farthest.of_measured, one.values.at("hausdorff_of_measured"), 1e-12);
    const metrics::CloudToCloud sums = metrics::cloudToCloud(clouds);
    EXPECT_NEAR(sums.sum_of_simulated, one.values.at("sum_of_simulated"), 1e-11);
    EXPECT_NEAR(sums.sum_of_measured, one.values.at("sum_of_measured"), 1e-11);
    EXPECT_NEAR(metrics::pointWassersteinDistance(clouds, 1.0), one.values.at("wasserstein_1"), 1e-12);
    EXPECT_NEAR(metrics::pointWassersteinDistance(clouds, 2.0), one.values.at("wasserstein_2"), 1e-12);
  }
}

}  // namespace
