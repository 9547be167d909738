#pragma once

#include <nlohmann/json.hpp>

#include "acceptance/result.h"

namespace acceptance {

/// Figures are some ten kilobytes a sample: for the project file, not for scripts.
enum class Figures { LeftOut, Included };

/// The result of a run for scripts, keys in this order:
///
///   {"format": "fidelis-acceptance", "version": 1, "project", "program_version",
///    "counts": {"passed", "failed", "error", "skipped"}, "tests": [{…}]}
///
/// and of a test:
///
///   id, title, requirements [id], verdict ("passed" | "failed" | "error" | "skipped"), text (one sentence: why),
///   experiment {id, title, source, synthetic, path}, model {id, path}, seed, measurand, unit, column, gate, metric,
///   expression, samples [{id, verdict, text, parameters {…}, n_real, n_sim [centre, corners …],
///             values {name: number, null where undefined},
///             relations [{left, order, right, value, limit, margin, holds}], figure (SVG, if included)}],
///   used [{path, sha256}]
///
/// `margin` is how far inside its limit the value lies. Of a test that did not run the keys from experiment on are
/// empty.
[[nodiscard]] nlohmann::ordered_json toJson(const RunResult& run, Figures figures = Figures::LeftOut);
[[nodiscard]] nlohmann::ordered_json toJson(const TestResult& test, Figures figures = Figures::LeftOut);

}  // namespace acceptance
