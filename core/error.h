#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace core {

/// Where in the user's material something is wrong. Every part may be absent.
struct Place {
  std::filesystem::path file;  ///< the user's file, never ours
  int line = 0;                ///< 1-based; 0: not known
  std::string item;            ///< row, cell, JSON Pointer, node or requirement id
};

/// "file:line, item" with the absent parts left out.
[[nodiscard]] std::string toString(const Place& place);

/// Something that a user can repair. Libraries throw it; only app/ prints it (exit status 2).
/// what() is "place: problem\n  remedy".
class InputError : public std::runtime_error {
 public:
  InputError(Place place, std::string problem, std::string remedy);

  [[nodiscard]] const Place& place() const noexcept { return place_; }
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }
  [[nodiscard]] const std::string& remedy() const noexcept { return remedy_; }

 private:
  Place place_;
  std::string problem_;
  std::string remedy_;
};

/// The user asked to stop (Ctrl-C, the Cancel button). Nothing is half-written.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace core
