#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/support/paths.h"

// The folders are the architecture: who may include whom, as drawn in docs/architecture.md. A folder may always
// include itself and core.
namespace {

const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"core", {}},
    {"percollect", {}},
    {"cepra", {"percollect"}},
    {"metrics", {}},
    {"model", {}},
    {"objects", {"model"}},
    {"prediction", {"metrics", "model"}},
    {"report", {"metrics"}},
    {"specs", {"percollect", "cepra", "report"}},
    {"gap", {"percollect", "cepra", "specs", "model", "metrics", "report"}},
    {"acceptance", {"percollect", "cepra", "specs", "model", "metrics", "report", "gap"}},
    {"proposals", {"percollect", "cepra", "specs", "model", "gap", "acceptance"}},
    {"app",
     {"percollect", "cepra", "specs", "model", "metrics", "objects", "prediction", "report", "gap", "acceptance",
      "proposals"}},
};

std::vector<std::filesystem::path> sourcesOf(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test_support::sourceFolder() / folder)) {
    const auto ending = entry.path().extension();
    if (ending == ".h" || ending == ".cpp") files.push_back(entry.path());
  }
  return files;
}

std::vector<std::string> includesOf(const std::filesystem::path& file) {
  static const std::regex kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
  std::vector<std::string> includes;
  std::ifstream stream(file);
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    if (std::regex_search(line, match, kInclude)) includes.push_back(match[1]);
  }
  return includes;
}

TEST(IncludeDirections, EveryFolderIncludesOnlyWhatStandsBelowIt) {
  for (const auto& [folder, allowed] : kMayInclude) {
    ASSERT_FALSE(sourcesOf("core").empty());
    for (const auto& file : sourcesOf(folder)) {
      for (const std::string& include : includesOf(file)) {
        const std::string target = include.substr(0, include.find('/'));
        if (!kMayInclude.count(target) || include.find('/') == std::string::npos) continue;  // a library's header
        EXPECT_TRUE(target == folder || target == "core" || allowed.count(target))
            << file << " includes " << include << ", but " << folder << " may not know " << target;
      }
    }
  }
}

// The rooms of the diagnosis stand one upon the other. What is not in a room puts them together.
TEST(IncludeDirections, EveryRoomOfTheDiagnosisIncludesOnlyWhatStandsBelowIt) {
  const std::vector<std::string> rooms = {"replay",     "distance",    "where", "causes", "far",
                                          "candidates", "unexplained", "pairs", "which"};
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const std::set<std::string> allowed(rooms.begin(), rooms.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    ASSERT_FALSE(sourcesOf("gap/" + rooms[i]).empty());
    for (const auto& file : sourcesOf("gap/" + rooms[i])) {
      for (const std::string& include : includesOf(file)) {
        if (!include.starts_with("gap/")) continue;
        const std::string rest = include.substr(4);
        EXPECT_TRUE(allowed.contains(rest.substr(0, rest.find('/')))) << file << " includes " << include;
      }
    }
  }
}

// What judges is blind to where samples come from: a metric must not read files, know detections or print.
TEST(IncludeDirections, NoMetricKnowsAboutFilesScreensOrSensors) {
  const std::set<std::string> allowed_of_core = {"core/error.h", "core/parallel.h", "core/progress.h", "core/random.h",
                                                 "core/text.h"};
  const std::set<std::string> refused = {"fstream", "iostream", "filesystem", "cstdio", "nlohmann/json.hpp"};
  for (const auto& file : sourcesOf("metrics")) {
    for (const std::string& include : includesOf(file)) {
      EXPECT_TRUE(!include.starts_with("core/") || allowed_of_core.contains(include))
          << file << " includes " << include;
      EXPECT_FALSE(refused.contains(include)) << file << " includes " << include;
    }
  }
}

// A library is known to one folder (and to app/ for the screen), so that it can be replaced there.
TEST(IncludeDirections, ThirdPartyLibrariesStayInTheirFolder) {
  const std::map<std::string, std::set<std::string>> home = {{"embree3", {"model"}},
                                                             {"assimp", {"model"}},
                                                             {"SQLiteCpp", {"specs"}},
                                                             {"sqlite3.h", {"specs"}},
                                                             {"tinyxml2.h", {"percollect"}},
                                                             {"xlsxwriter.h", {"specs"}},
                                                             {"tbb", {"core"}},
                                                             {"Random123", {"core"}},
                                                             {"hwy", {"core", "metrics"}},
                                                             {"nanoflann.hpp", {"metrics", "objects"}},
                                                             {"coin", {"metrics"}},
                                                             {"muParser.h", {"acceptance", "specs"}},
                                                             {"CLI", {"app"}},
                                                             {"google", {"core"}},
                                                             {"lzf.h", {"core"}},
                                                             {"csv.h", {"core"}}};
  for (const auto& [folder, allowed] : kMayInclude) {
    for (const auto& file : sourcesOf(folder)) {
      for (const std::string& include : includesOf(file)) {
        const auto library = home.find(include.substr(0, include.find('/')));
        if (library != home.end()) {
          EXPECT_TRUE(library->second.count(folder)) << file << " includes " << include;
        }
        if (include.size() > 1 && include[0] == 'Q' && std::isupper(static_cast<unsigned char>(include[1]))) {
          EXPECT_EQ(folder, "app") << file << " includes " << include;
        }
      }
    }
  }
}

}  // namespace
