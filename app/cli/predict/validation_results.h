#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "metrics/prediction/error_samples.h"
#include "prediction/measurand.h"

namespace app {

/// Which columns of a table of results are what, by their names in the header.
struct ResultColumns {
  std::vector<std::string> parameters;  ///< predicted over
  std::vector<std::string> targets;     ///< errors; empty: d_bias and d_cavm, as far as they are there
  std::string setup;                    ///< empty: "setup", if there is such a column
  std::string role;                     ///< empty: "role", if there is such a column
  std::string weight;                   ///< empty: rows weigh the same
  bool every_role = false;              ///< take all rows as seen, whatever their role
};

/// A sample that was not used, and why.
struct UnusedSample {
  std::string where;
  std::string why;
};

/// Validation results of several samples, sorted by what they may be used for.
struct ValidationResults {
  std::filesystem::path file;
  std::vector<metrics::ErrorSamples> seen;      ///< to learn from, one entry a target
  std::vector<metrics::ErrorSamples> held_out;  ///< role `prediction`; the same targets
  std::vector<UnusedSample> left_out;
  std::optional<prediction::Measurand> measurand;  ///< if the file tells

  [[nodiscard]] std::size_t size() const { return seen.front().size(); }
};

/// From a CSV file, one row a sample. Rows of role `prediction` are held out, those of role `calibration` left out: the
/// model was fitted to them. Throws InputError with line and column for a cell that is no finite number, and for a
/// column that is missing, with the nearest name.
[[nodiscard]] ValidationResults readResultsTable(const std::filesystem::path& file, const ResultColumns& columns);

/// From the report of `fidelis accept --json`: the samples of one test (the only one if `test` is empty). Samples whose
/// error is undefined are left out.
[[nodiscard]] ValidationResults readAcceptanceReport(const std::filesystem::path& file, const ResultColumns& columns,
                                                     const std::string& test);

/// Errors that cannot be negative, by their names: d_cavm, d_avm, d_plus, d_minus and their variants.
[[nodiscard]] bool isNeverNegative(const std::string& target);

}  // namespace app
