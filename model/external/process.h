#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"

namespace model {

/// A program to run: its words as they are, no shell between.
struct ProcessTask {
  std::vector<std::string> words;  ///< the program (looked up in PATH if it has no slash) and its arguments
  std::filesystem::path folder;    ///< where it runs; a relative program begins here
  std::filesystem::path log;       ///< takes what it prints, standard output and error
  double time_limit_s = 0.0;
};

/// How it ended.
struct ProcessEnd {
  enum class Kind { kExited, kKilled, kNotStarted, kTimeOut };
  Kind kind = Kind::kExited;
  int code = 0;  ///< exit status, number of the signal, or errno
};

/// Runs it in a process group of its own and waits. At the time limit, and once the person has asked to stop, the whole
/// group gets SIGTERM and, a second later, SIGKILL; nothing that it started outlives it. Throws Cancelled in the latter
/// case.
[[nodiscard]] ProcessEnd runProcess(const ProcessTask& task, const core::Progress& progress);

/// The last lines of a log, readable: at most `lines`, no control characters.
[[nodiscard]] std::string lastLines(const std::filesystem::path& log, std::size_t lines = 12);

}  // namespace model
