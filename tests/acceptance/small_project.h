#pragma once

#include <filesystem>
#include <string>

#include "specs/project_store.h"
#include "tests/support/paths.h"

namespace acceptance_test {

/// A project in a folder of its own: one beam on a wide wall at 8, 10 and 12 m (r8, r10 validate, r12 predicts), each
/// known to ± 2 mm, 40 frames each. The "measurements" are evenly spread around the true range, so their distribution
/// is known exactly: range = true range + offset_m ± 20 mm.
class SmallProject {
 public:
  struct Settings {
    double offset_m = 0.0;                         ///< of every measured range
    std::string source = "synthetic, for a test";  ///< of the experiment
  };

  explicit SmallProject(const Settings& settings);
  SmallProject() : SmallProject(Settings{}) {}

  [[nodiscard]] std::filesystem::path file() const { return folder_ / "small.fidelis"; }
  [[nodiscard]] const test_support::TemporaryFolder& folder() const { return folder_; }
  [[nodiscard]] specs::ProjectStore open() const { return specs::ProjectStore::open(file()); }

  /// A test of the range with this id (linked to requirement RangeError_Requirement_1) and expression.
  void addTest(const std::string& id, const std::string& expression) const;
  /// The test that addTest would add, for those who change it.
  [[nodiscard]] static specs::AcceptanceTest rangeTest(const std::string& id, const std::string& expression);

 private:
  test_support::TemporaryFolder folder_;
};

inline const specs::Signature kSomebody = {.who = "test", .when = "2024-01-01T00:00:00Z"};

}  // namespace acceptance_test
