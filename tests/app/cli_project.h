#pragma once

#include <string>

#include "specs/project_store.h"
#include "tests/support/paths.h"

namespace test_app {

/// A graph in the JSON release format: Range error <- Attenuation <- Fog density.
inline std::string smallRelease(const std::string& effect_title = "Attenuation by aerosols") {
  const auto node = [](const std::string& id, const std::string& parents, const std::string& title,
                       const std::string& kind) {
    return R"({"id": ")" + id + R"(", "parentIds": [)" + parents + R"(], "title": ")" + title +
           R"(", "decomBlock": "Signal propagation", "description": "d", "references": "", "nodeType": ")" + kind +
           R"(", "tags": []})";
  };
  return "[" + node("0", "", "Range error", "effect") + ",\n" + node("1", "\"0\"", effect_title, "effect") + ",\n" +
         node("2", "\"1\"", "Fog density", "systemIndependent") + "]\n";
}

/// One accepted requirement without a test.
inline void addRequirement(const std::filesystem::path& project) {
  const specs::Signature eve{.who = "eve", .when = "2026-01-02T03:04:05Z"};
  auto store = specs::ProjectStore::open(project);
  store.add(specs::Requirement{{.id = "RangeError_Fog_1",
                                .title = "Range bias in fog",
                                .text = "It is small.",
                                .status = specs::Status::Accepted}},
            eve);
  store.link({store.cepra().rows.front().key, "RangeError_Fog_1"}, eve);
}

}  // namespace test_app
