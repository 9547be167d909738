#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace specs {

/// `Failed`: ran, and the expression does not hold. `Error`: could not be decided. `Skipped`: was not run.
enum class Verdict { Passed, Failed, Error, Skipped };

[[nodiscard]] std::string_view name(Verdict verdict);  ///< "passed", "failed", "error", "skipped"
[[nodiscard]] std::optional<Verdict> verdictOf(std::string_view name);

/// One sample of a test: the numbers that the expression saw.
struct SampleVerdict {
  std::string sample;
  Verdict verdict = Verdict::Skipped;
  std::map<std::string, double> values;  ///< metric results and parameters by name, in the measurand's unit
  std::optional<double> value;           ///< left side of the decision, if it is a comparison
  std::optional<double> limit;           ///< right side
  std::string text;                      ///< one sentence
  bool operator==(const SampleVerdict&) const = default;
};

/// Something that a verdict rests on.
struct UsedFile {
  std::string path;
  std::string sha256;
  bool operator==(const UsedFile&) const = default;
};

struct TestVerdict {
  std::string test;  ///< shown id of the acceptance test at that time
  Verdict verdict = Verdict::Skipped;
  std::string text;  ///< one sentence: why
  std::vector<SampleVerdict> samples;
  std::vector<UsedFile> used;  ///< files of the experiment package, model, …
  std::string evaluation;      ///< JSON text with everything that the report shows; may be empty
  std::string report;          ///< path of the report, relative to the project file if possible
  bool operator==(const TestVerdict&) const = default;
};

/// One call of the acceptance run.
struct TestRun {
  std::string id;               ///< given by the store if empty: "run-1", "run-2", …
  std::string started_at;       ///< ISO 8601, from the caller's clock
  std::string program_version;  ///< of the program that ran it
  std::vector<TestVerdict> verdicts;
  bool operator==(const TestRun&) const = default;
};

}  // namespace specs
