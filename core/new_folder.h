#pragma once

#include <filesystem>

namespace core {

/// A folder that appears all at once or not at all: it is filled beside its place under another name, which is gone
/// again unless appear() was called. Throws InputError if the place holds anything but an empty folder, or cannot be
/// written.
class NewFolder {
 public:
  explicit NewFolder(std::filesystem::path target);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// Where to write until then.
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return part_; }
  void appear();

 private:
  std::filesystem::path target_;
  std::filesystem::path part_;
};

}  // namespace core
