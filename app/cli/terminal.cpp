#include "app/cli/terminal.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace app {

namespace {
volatile std::sig_atomic_t interrupted = 0;

void onInterrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);  // the second one kills
}
}  // namespace

TerminalProgress::TerminalProgress(bool quiet) : quiet_(quiet), on_terminal_(::isatty(STDERR_FILENO) != 0) {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
}

TerminalProgress::~TerminalProgress() { clear(); }

void TerminalProgress::report(double fraction, std::string_view doing) {
  const std::lock_guard lock(mutex_);
  if (quiet_) return;
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (on_terminal_) {
    if (fraction >= 1.0) {  // done: what follows begins on a clean line
      if (line_open_) fmt::print(stderr, "\r\033[K");
      std::fflush(stderr);
      line_open_ = false;
      return;
    }
    if (percent == last_percent_ && doing == last_doing_) return;
    const int filled = percent / 5;
    fmt::print(stderr, "\r\033[K[{:#<{}}{: <{}}] {:3d} %  {:.50}", "", filled, "", 20 - filled, percent, doing);
    line_open_ = true;
  } else {
    if (percent / 10 == last_percent_ / 10 && last_percent_ >= 0) return;
    fmt::print(stderr, "{:3d} %  {}\n", percent, doing);
  }
  std::fflush(stderr);
  last_percent_ = percent;
  last_doing_ = std::string(doing);
}

bool TerminalProgress::cancelled() const { return interrupted != 0; }

void TerminalProgress::clear() {
  const std::lock_guard lock(mutex_);
  if (line_open_) fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  line_open_ = false;
}

}  // namespace app
