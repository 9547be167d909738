#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/random.h"

namespace core {

/// Column n holds the n-th of the four normals of every stream.
using NormalColumns = std::array<std::span<float>, 4>;

/// Standard normal numbers for many streams at once, those that core::Random draws from block `block` of each stream,
/// in single precision. `key` names the streams but for their beams. A stream's numbers do not depend on the others.
/// (Philox 4x32-10 and Box–Muller, as in core/random.h.)
void normalsOf(const Random::Key& key, std::span<const std::uint32_t> beams, std::uint32_t block,
               const NormalColumns& columns);
/// The same for one beam in as many frames as a column is long, from `key.frame` on.
void normalsInFrames(const Random::Key& key, std::uint32_t block, const NormalColumns& columns);

/// out[i] = log2(in[i]) for positive numbers; `out` may be `in`. Both to a few units in the last place.
void log2Of(std::span<const double> in, std::span<double> out);
/// out[i] = exp(in[i]).
void expOf(std::span<const double> in, std::span<double> out);

}  // namespace core
