#pragma once

#include <string>
#include <vector>

namespace test_support {

/// What a run of the real program left behind.
struct ProgramRun {
  int status = -1;       ///< exit status; 128 + n if signal n ended it
  std::string out;       ///< standard output
  std::string messages;  ///< standard error
};

/// Runs build/bin/`program` with the given words, as a user would.
[[nodiscard]] ProgramRun runProgram(const std::string& program, const std::vector<std::string>& words);
[[nodiscard]] ProgramRun runFidelis(const std::vector<std::string>& words);

}  // namespace test_support
