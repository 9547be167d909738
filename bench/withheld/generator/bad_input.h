#pragma once

#include <stdexcept>
#include <string>

namespace withheld {

/// What a user can repair: where it is, what is wrong, what to do. The program ends with status 2.
class BadInput : public std::runtime_error {
 public:
  BadInput(const std::string& place, const std::string& problem, const std::string& remedy)
      : std::runtime_error(place + ": " + problem + "\n  " + remedy) {}
};

}  // namespace withheld
