#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/progress.h"

namespace app {

/// What every command gets: where to write, how to tell progress, and the options that are understood everywhere.
struct Session {
  std::ostream& out;         ///< results; standard output
  std::ostream& messages;    ///< everything else; standard error
  core::Progress& progress;  ///< silent with --quiet; cancelled by Ctrl-C
  bool quiet = false;
  bool verbose = false;
  int threads = 0;                    ///< 0: all cores
  std::optional<std::uint64_t> seed;  ///< --seed, if given
  int status = 0;                     ///< exit status that the command leaves: 0 or 1

  /// Writes a JSON result to a file, or to `out` if the name is "-".
  void writeJsonTo(const std::string& name, const nlohmann::ordered_json& value) const;
};

/// Exit statuses that scripts rely on (formats.md section 5).
enum ExitStatus { kAllGood = 0, kNotAccepted = 1, kBadInput = 2, kInternalError = 3, kInterrupted = 130 };

}  // namespace app
