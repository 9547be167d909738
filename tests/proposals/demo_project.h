#pragma once

#include <filesystem>

#include "gap/diagnosis.h"
#include "specs/project_store.h"
#include "tests/support/paths.h"

namespace test_proposals {

inline const specs::Signature kEve{.who = "eve", .when = "2026-01-02T03:04:05Z"};

/// The demo project in a folder of its own, and the diagnosis of its foggy experiment, whose model lacks the fog. The
/// measurement comes from a script that shares no code with the simulation.
class DemoProject {
 public:
  DemoProject();

  [[nodiscard]] const test_support::TemporaryFolder& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "demo.fidelis"; }
  [[nodiscard]] specs::ProjectStore open() const { return specs::ProjectStore::open(file()); }
  /// Diagnosed once for all tests of the program.
  [[nodiscard]] static const gap::Diagnosis& diagnosis();
  /// Its report, written into the folder.
  [[nodiscard]] std::filesystem::path report() const;

 private:
  test_support::TemporaryFolder folder_;
};

/// Keys of the rows whose path ends at the node "Extinction by fog, rain or dust" of the demo's graph.
inline const char* const kFogNode = "87";

}  // namespace test_proposals
