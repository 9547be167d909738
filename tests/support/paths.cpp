#include "tests/support/paths.h"

#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace test_support {

std::filesystem::path sourceFolder() { return FIDELIS_SOURCE_DIR; }

std::filesystem::path testData(const std::string& name) { return sourceFolder() / "tests" / "data" / name; }

std::filesystem::path sharedFolder() {
  const char* given = std::getenv("FIDELIS_SHARED");
  std::filesystem::path folder = given ? std::filesystem::path(given) : sourceFolder().parent_path() / "shared";
  return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "fidelis-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::string& name, const std::string& content) const {
  const auto file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

}  // namespace test_support
