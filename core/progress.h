#pragma once

#include <string_view>

namespace core {

/// Tells a person how far long work is, and lets them stop it. Implementations are thread-safe.
class Progress {
 public:
  virtual ~Progress() = default;
  /// `fraction` of the whole in [0, 1]; `doing` is one short phrase ("simulating r10").
  virtual void report(double fraction, std::string_view doing) = 0;
  /// True once the person has asked to stop.
  [[nodiscard]] virtual bool cancelled() const = 0;
};

/// Nobody watches, nobody cancels.
class SilentProgress final : public Progress {
 public:
  void report(double, std::string_view) override {}
  [[nodiscard]] bool cancelled() const override { return false; }
};

/// Reports a part [from, to] of another progress as its own [0, 1].
class PartOfProgress final : public Progress {
 public:
  PartOfProgress(Progress& whole, double from, double to) : whole_(whole), from_(from), to_(to) {}
  void report(double fraction, std::string_view doing) override {
    whole_.report(from_ + (to_ - from_) * fraction, doing);
  }
  [[nodiscard]] bool cancelled() const override { return whole_.cancelled(); }

 private:
  Progress& whole_;
  double from_;
  double to_;
};

/// Throws Cancelled if the person has asked to stop. Call it between pieces of work.
void stopIfCancelled(const Progress& progress);

}  // namespace core
