#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gap/where/gate.h"
#include "gap/where/near_echoes.h"
#include "gap/where/residual_tables.h"
#include "gap/where/sectors.h"
#include "gap/where/strata.h"
#include "gap/where/unexpected_echoes.h"

namespace gap {

/// Where a world differs from the measurement, the reference settled within its tolerance.
struct WhereResult {
  std::vector<WhereRow> rows;
  std::vector<ResidualTable> tables;
  std::vector<ResidualTable> by_beam;  ///< the same with moved echoes as residuals (moved_echoes.h); the rows' tables
  CellsOfSamples expected;             ///< by the world, under other noise,
  CellsOfSamples once_more;            ///< and under the noise of `tables`, before the reference was settled,
  std::vector<int> frames;             ///< in so many frames of every sample
  std::vector<Sector> sectors;         ///< that explain the residuals best (sectors.h)
  Gate gate;                           ///< that explains what is missing best (gate.h)
  NearEchoes near_echoes;              ///< of two echoes so near to each other one is lost (near_echoes.h)
  std::optional<UnexpectedEchoes> unexpected;  ///< that lie together (unexpected_echoes.h)
  double false_echoes_per_shot = 0.0;          ///< that no surface makes, more than the world expects
  double largest_steps = 0.0;  ///< largest deviation of a whole table or a significant stratum, in resolution steps
};
[[nodiscard]] WhereResult whereIn(const Replay& replay, const World& world, std::uint64_t seed);

/// The rows of a world that lacks a cause once that cause is known: what it changes most comes first, as both worlds
/// show it twice, under the same noise as far as the cause leaves that alone. What it leaves as it is, however large,
/// comes after that: two programs, or a second fault, differ in other places.
[[nodiscard]] std::vector<WhereRow> rowsOfCause(const Replay& replay, const WhereResult& without,
                                                const WhereResult& with);

}  // namespace gap
