#pragma once

#include <optional>
#include <string>

#include "gap/diagnosis.h"

namespace gap {

// What a verdict leaves unexplained, in words.

/// "0.21 + 0.34·tan²(incidence_deg)", in the law's unit.
[[nodiscard]] std::string formulaOf(const Law& law);

/// The same law as a reader is told of it: parts of the received power in per cent.
[[nodiscard]] Law forReaders(Law law);

/// The law that a reader is told of where no cause explains the gap; null where one does, or nothing follows a law.
[[nodiscard]] const Law* patternIn(const Verdict& verdict, const std::optional<Rest>& rest);
/// The wave that a law consists of; null for other laws.
[[nodiscard]] const Law::Term* waveIn(const Law& law);
/// The same for a reader: "The mean of the range, measured minus simulated, goes up and down by ± 0.03 m and repeats
/// every 0.9 m of distance: 95 % of what is left there."
[[nodiscard]] std::string patternText(const Law& law);

/// So little of the gap is left that nobody asks what it depends on.
[[nodiscard]] bool hardlyAnyLeft(const Rest& rest);
/// How much is left with the named cause added (or without any), and whether something systematic is in it.
[[nodiscard]] std::string restText(const Rest& rest, bool cause_is_named);

}  // namespace gap
