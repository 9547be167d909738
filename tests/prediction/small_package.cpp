#include "tests/prediction/small_package.h"

#include "core/json_object.h"
#include "prediction/prediction_file.h"

namespace test_prediction {

using nlohmann::json;

json emptyExperiment() {
  return {{"format", "fidelis-experiment"},
          {"version", 1},
          {"id", "nothing"},
          {"source", "synthetic: a test"},
          {"sensor", "ibeo-lux-2010"},
          {"measurands",
           {{{"name", "range"}, {"column", "range_m"}, {"unit", "m"}, {"resolution", 0.01}},
            {{"name", "epw"}, {"column", "epw_m"}, {"unit", "m"}, {"resolution", 0.04}}}},
          {"environment", {{"temperature_degC", nullptr}, {"visibility_m", 200.0}}},
          {"scene", json::array()},
          {"samples", json::array()}};
}

void addSample(const test_support::TemporaryFolder& folder, json& experiment, const std::string& id,
               const json& parameters, const std::string& measurement) {
  const std::string file = "measurements/" + id + ".csv";
  (void)folder.write("package/" + file, measurement);
  experiment["samples"].push_back({{"id", id}, {"frames", 1}, {"parameters", parameters}, {"measurements", file}});
  core::writeJson(folder / "package/experiment.json", experiment);
}

metrics::ErrorSamples aroundLine(const std::string& parameter, double residual) {
  return {.target = "d_bias",
          .parameters = {parameter},
          .points = {10, 20, 30},
          .errors = {0.2 - residual, 0.3 + 2 * residual, 0.4 - residual}};
}

std::filesystem::path savePrediction(const std::filesystem::path& file,
                                     const std::vector<metrics::ErrorSamples>& samples, const std::string& measurand) {
  nlohmann::ordered_json document{{"format", "fidelis-predict"}, {"version", 1}};
  if (!measurand.empty()) document["measurand"] = prediction::toJson(prediction::measurandNamed(measurand));
  for (const metrics::ErrorSamples& entry : samples) {
    document["predictions"].push_back(prediction::toJson(metrics::predict(entry)));
  }
  core::writeJson(file, document);
  return file;
}

}  // namespace test_prediction
