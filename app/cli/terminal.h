#pragma once

#include <mutex>
#include <string>

#include "core/progress.h"

namespace app {

/// Progress on standard error: one line that is rewritten on a terminal, a line every tenth in a log file.
/// Ctrl-C cancels; a second Ctrl-C kills.
class TerminalProgress final : public core::Progress {
 public:
  explicit TerminalProgress(bool quiet);
  ~TerminalProgress() override;
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  void setQuiet(bool quiet) { quiet_ = quiet; }
  void report(double fraction, std::string_view doing) override;
  [[nodiscard]] bool cancelled() const override;
  /// Clears the line, so that a message can follow.
  void clear();

 private:
  std::mutex mutex_;
  bool quiet_;
  bool on_terminal_;
  bool line_open_ = false;
  int last_percent_ = -1;
  std::string last_doing_;
};

}  // namespace app
