#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace core {

/// The candidate with the smallest edit distance to `name`, or "" if none is near enough to be meant
/// (more than half of the letters differ).
[[nodiscard]] std::string nearestName(std::string_view name, std::span<const std::string> candidates);

/// "a, b, c".
[[nodiscard]] std::string join(std::span<const std::string> parts, std::string_view separator = ", ");

/// Escapes & < > " ' for HTML and XML text and attributes.
[[nodiscard]] std::string escapeMarkup(std::string_view text);

/// Shortest decimal that reads back as the same double; no locale. NaN and infinities as "nan", "inf", "-inf".
[[nodiscard]] std::string shortestNumber(double value);

/// At most `digits` significant digits, without exponent where it is readable: 0.0123, 12.3, 2060, 1.2e-09, 5e+07.
[[nodiscard]] std::string significant(double value, int digits = 3);

[[nodiscard]] std::string trimmed(std::string_view text);
[[nodiscard]] std::string lowerCase(std::string_view text);  // ASCII only

/// Parses the whole text as a finite or infinite number, without locale; false if it is anything else.
[[nodiscard]] bool parseNumber(std::string_view text, double& value);

/// Offset of the first byte that is not part of valid UTF-8 (overlong forms and surrogates are invalid too).
[[nodiscard]] std::optional<std::size_t> findInvalidUtf8(std::string_view text);

/// 1-based line of the byte at `offset`.
[[nodiscard]] int lineAt(std::string_view text, std::size_t offset);

}  // namespace core
