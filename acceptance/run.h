#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "acceptance/evaluate.h"
#include "acceptance/result.h"
#include "core/progress.h"
#include "specs/project_store.h"

namespace acceptance {

struct RunOptions {
  std::vector<std::string> tests;              ///< shown ids; empty: all that are not rejected
  std::optional<std::filesystem::path> model;  ///< accepted in place of the model that each test names
  std::optional<std::uint64_t> seed;           ///< in place of the models' seeds
};

/// Runs acceptance tests of a project. Same project, files, options: same result, whatever the number of threads.
/// Throws InputError for an unknown test id (with the nearest) and for a project without tests; Cancelled.
[[nodiscard]] RunResult runTests(const specs::ProjectStore& store, const RunOptions& options, core::Progress& progress);

/// When a run took place, and where its report lies.
struct RunRecord {
  std::string started_at;        ///< ISO 8601, from the caller's clock
  std::filesystem::path report;  ///< HTML report; "" if none was written
};

/// Stores verdicts, values and hashes as one transaction and returns the id of the run. The evaluation of each test is
/// stored as JSON (result_json.h) with its figures, so that it can be shown again without being run.
std::string storeRun(specs::ProjectStore& store, const RunResult& result, const RunRecord& record);

}  // namespace acceptance
