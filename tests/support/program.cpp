#include "tests/support/program.h"

#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include "core/file.h"
#include "tests/support/paths.h"

extern char** environ;

namespace test_support {

ProgramRun runProgram(const std::string& program, const std::vector<std::string>& words) {
  const TemporaryFolder folder;
  const std::string path = (std::filesystem::path(FIDELIS_BINARY_DIR) / program).string();
  std::vector<std::string> copies{path};
  copies.insert(copies.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& copy : copies) arguments.push_back(copy.data());
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, (folder / "out").c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, (folder / "err").c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t child = 0;
  const int code = posix_spawn(&child, path.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (code != 0) throw std::runtime_error("cannot start " + path);
  int state = 0;
  ::waitpid(child, &state, 0);
  return {.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state),
          .out = core::readFile(folder / "out"),
          .messages = core::readFile(folder / "err")};
}

ProgramRun runFidelis(const std::vector<std::string>& words) { return runProgram("fidelis", words); }

}  // namespace test_support
