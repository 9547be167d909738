#pragma once

#include <string>

#include "core/error.h"

namespace test_support {

/// What an InputError says: "place: problem\n  remedy"; "" if nothing was thrown.
template <typename Action>
std::string thrownMessage(Action action) {
  try {
    action();
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace test_support
