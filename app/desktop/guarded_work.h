#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/error.h"

namespace desktop {

/// Does the work of a thread, which no exception may leave. Returns what went wrong; nothing if all went well or the
/// work was cancelled. An internal error is said at `file`, with `remedy`.
[[nodiscard]] std::optional<core::InputError> errorOf(const std::function<void()>& work,
                                                      const std::filesystem::path& file, const std::string& remedy);

}  // namespace desktop
