#pragma once

#include <algorithm>
#include <mutex>
#include <string_view>

#include "core/progress.h"

namespace core {

/// Another progress that never goes back: work of which nobody knows how often a step will be needed reports each time
/// from the step's beginning.
class ForwardProgress final : public Progress {
 public:
  explicit ForwardProgress(Progress& whole) : whole_(whole) {}

  void report(double fraction, std::string_view doing) override {
    const std::lock_guard lock(mutex_);
    farthest_ = std::max(farthest_, fraction);
    whole_.report(farthest_, doing);
  }
  [[nodiscard]] bool cancelled() const override { return whole_.cancelled(); }

 private:
  Progress& whole_;
  std::mutex mutex_;
  double farthest_ = 0.0;
};

}  // namespace core
