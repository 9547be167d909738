#include "model/external/process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "core/error.h"
#include "core/text.h"

extern char** environ;

namespace model {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kGrace{1000};  // between asking a group to end and ending it

/// Settings of a child: own process group, no signal blocked or ignored, its streams, its folder.
class ChildSettings {
 public:
  explicit ChildSettings(const ProcessTask& task) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, task.log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions_, task.folder.c_str());
    posix_spawnattr_init(&attributes_);
    sigset_t none, standard;
    sigemptyset(&none);
    sigemptyset(&standard);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) sigaddset(&standard, signal);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &standard);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~ChildSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  ChildSettings(const ChildSettings&) = delete;
  ChildSettings& operator=(const ChildSettings&) = delete;

  /// 0, or errno.
  int spawn(const std::vector<std::string>& words, pid_t& child) const {
    std::vector<std::string> copies = words;
    std::vector<char*> arguments;
    for (std::string& copy : copies) arguments.push_back(copy.data());
    arguments.push_back(nullptr);
    return posix_spawnp(&child, arguments.front(), &actions_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

/// Whether the child has ended. It stays unreaped, so that its number still names its group and no other.
bool hasEnded(pid_t child) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == child;
}

/// Waits until `stop` says so or the child has ended; true if it has.
template <typename Stop>
bool waitFor(pid_t child, Stop stop) {
  milliseconds pause{1};
  while (!hasEnded(child)) {
    if (stop()) return false;
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, milliseconds{50});
  }
  return true;
}

/// Ends what is left of the group and takes the child's status.
int reap(pid_t child) {
  ::kill(-child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void endGroup(pid_t child) {
  ::kill(-child, SIGTERM);
  const auto until = Clock::now() + kGrace;
  (void)waitFor(child, [&] { return Clock::now() >= until; });
  (void)reap(child);
}

}  // namespace

ProcessEnd runProcess(const ProcessTask& task, const core::Progress& progress) {
  pid_t child = 0;
  if (const int code = ChildSettings(task).spawn(task.words, child); code != 0) {
    return {ProcessEnd::Kind::kNotStarted, code};
  }
  const auto start = Clock::now();
  const std::chrono::duration<double> limit(task.time_limit_s);
  const bool ended = waitFor(child, [&] { return progress.cancelled() || Clock::now() - start >= limit; });
  if (!ended) {
    endGroup(child);
    core::stopIfCancelled(progress);
    return {ProcessEnd::Kind::kTimeOut, 0};
  }
  const int status = reap(child);
  if (WIFSIGNALED(status)) return {ProcessEnd::Kind::kKilled, WTERMSIG(status)};
  return {ProcessEnd::Kind::kExited, WEXITSTATUS(status)};
}

std::string lastLines(const std::filesystem::path& log, std::size_t lines) {
  constexpr std::streamoff kMost = 4096;
  std::ifstream stream(log, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(0, size - kMost));
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (size > kMost) text.erase(0, text.find('\n') + 1);  // no half line
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' && c != '\n') c = ' ';
  }
  while (const auto invalid = core::findInvalidUtf8(text)) text[*invalid] = '?';
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  std::size_t begin = text.size();
  for (std::size_t k = 0; k < lines && begin != std::string::npos && begin > 0; ++k)
    begin = text.rfind('\n', begin - 1);
  return begin == std::string::npos || begin == 0 ? text : text.substr(begin + 1);
}

}  // namespace model
