#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cepra/table.h"

namespace specs {

/// Shown ids are `<Phenomenon>_<Causes>_<No.>`: `FalseNegativeDetection_AttenuationByAerosols_1`. Letters and digits
/// of ASCII, each part beginning with a capital; <Causes> may itself be several parts; <No.> counts from 1.
[[nodiscard]] bool isShownId(std::string_view id);

/// Words of a title joined as `AttenuationByAerosols`: letters and digits only, at most `max_words` words; the German
/// umlauts are spelled out.
[[nodiscard]] std::string camelCase(std::string_view title, std::size_t max_words = 6);

/// The first free id for a phenomenon and what causes it, where `taken` are the ids in use.
[[nodiscard]] std::string proposeId(std::string_view phenomenon, std::string_view causes,
                                    std::span<const std::string> taken);

/// The same for a row of the relevance table: its phenomenon and its last effect.
[[nodiscard]] std::string proposeId(const cepra::Row& row, std::span<const std::string> taken);

/// Natural order: "Range_2" before "Range_10".
[[nodiscard]] bool naturallyLess(std::string_view a, std::string_view b);

}  // namespace specs
