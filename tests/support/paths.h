#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

namespace test_support {

/// The source tree, for resources/ and tests/data.
[[nodiscard]] std::filesystem::path sourceFolder();
[[nodiscard]] std::filesystem::path testData(const std::string& name);

/// The shared reference data: $FIDELIS_SHARED, else ../shared beside the source tree; empty if absent.
[[nodiscard]] std::filesystem::path sharedFolder();

/// A folder of its own for one test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Writes a small file and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace test_support

/// Skips, visibly, a test that needs the shared reference data where they are absent.
#define FIDELIS_NEEDS_SHARED(variable)                                 \
  const std::filesystem::path variable = test_support::sharedFolder(); \
  if (variable.empty()) GTEST_SKIP() << "reference data not present (set FIDELIS_SHARED to their folder)"
