#pragma once

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "metrics/distributions/edf.h"
#include "tests/support/paths.h"

namespace metrics_test {

/// What scipy computes (tests/data/metrics/samples/reference.py, run once).
inline const nlohmann::json& samplesReference() {
  static const nlohmann::json reference = [] {
    std::ifstream file(test_support::testData("metrics/samples/reference.json"));
    return nlohmann::json::parse(file);
  }();
  return reference;
}

/// null stands for infinity, which JSON lacks.
inline double numberOf(const nlohmann::json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

inline metrics::Edf edfOf(const nlohmann::json& values) { return metrics::Edf(values.get<std::vector<double>>()); }

}  // namespace metrics_test
