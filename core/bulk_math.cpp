#include "core/bulk_math.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/bulk_math.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles this file once for every kind of processor.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace core::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::ScalableTag<std::uint32_t>;
using Numbers = hn::ScalableTag<float>;
using WordVector = hn::Vec<Words>;

/// High halves of the 64-bit products of every lane with `factor`.
HWY_INLINE WordVector highProduct(WordVector factor, WordVector x) {
  const Words d;
  const hn::RepartitionToWide<Words> wide;
  const auto even = hn::MulEven(factor, x);
  const auto odd = hn::MulEven(factor, hn::BitCast(d, hn::ShiftRight<32>(hn::BitCast(wide, x))));
  return hn::OddEven(hn::BitCast(d, odd), hn::BitCast(d, hn::ShiftRight<32>(even)));
}

/// Ten rounds of Philox 4x32 on the counters in `c` (Salmon et al. 2011, sec. 3.4).
HWY_INLINE void philox(std::array<WordVector, 4>& c, std::uint32_t key0, std::uint32_t key1) {
  const Words d;
  const WordVector m0 = hn::Set(d, 0xD2511F53U), m1 = hn::Set(d, 0xCD9E8D57U);
  for (int round = 0; round < 10; ++round) {
    const WordVector high0 = highProduct(m0, c[0]), low0 = hn::Mul(m0, c[0]);
    const WordVector high1 = highProduct(m1, c[2]), low1 = hn::Mul(m1, c[2]);
    c[0] = hn::Xor(hn::Xor(high1, c[1]), hn::Set(d, key0));
    c[1] = low1;
    c[2] = hn::Xor(hn::Xor(high0, c[3]), hn::Set(d, key1));
    c[3] = low0;
    key0 += 0x9E3779B9U;
    key1 += 0xBB67AE85U;
  }
}

/// A word as a number in (0, 1].
HWY_INLINE hn::Vec<Numbers> uniform(WordVector word) {
  const Numbers d;
  // Only signed words convert everywhere: the upper bit is put back as a number.
  const hn::RebindToSigned<Words> integers;
  const auto half = hn::ConvertTo(d, hn::BitCast(integers, hn::ShiftRight<1>(word)));
  return hn::MulAdd(half, hn::Set(d, 0x1.0p-31F), hn::Set(d, 0x1.0p-33F));
}

/// Box–Muller on block `block` of `count` streams; `frames` and `beams` name those from the i-th on, of which n count.
template <class Frames, class Beams>
HWY_INLINE void normals(const PhiloxKey& words_of_key, std::uint32_t purpose, std::uint32_t block, std::size_t count,
                        const Frames& frames, const Beams& beams, float* const* columns) {
  const Words d;
  const Numbers numbers;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < count; i += lanes) {
    const std::size_t n = count - i < lanes ? count - i : lanes;
    std::array<WordVector, 4> words = {hn::Set(d, block), frames(i, n), beams(i, n), hn::Set(d, purpose)};
    philox(words, words_of_key[0], words_of_key[1]);
    for (std::size_t pair = 0; pair < 2; ++pair) {
      const auto radius = hn::Sqrt(hn::Mul(hn::Set(numbers, -2.0F), hn::Log(numbers, uniform(words[2 * pair]))));
      const auto angle = hn::Mul(hn::Set(numbers, 6.2831853071795864769F), uniform(words[2 * pair + 1]));
      const auto first = hn::Mul(radius, hn::Cos(numbers, angle));
      const auto second = hn::Mul(radius, hn::Sin(numbers, angle));
      if (n == lanes) {
        hn::StoreU(first, numbers, columns[2 * pair] + i);
        hn::StoreU(second, numbers, columns[2 * pair + 1] + i);
      } else {
        hn::BlendedStore(first, hn::FirstN(numbers, n), numbers, columns[2 * pair] + i);
        hn::BlendedStore(second, hn::FirstN(numbers, n), numbers, columns[2 * pair + 1] + i);
      }
    }
  }
}

void normalsOfBeams(const PhiloxKey& words, const Random::Key& key, const std::uint32_t* beams, std::size_t count,
                    std::uint32_t block, float* const* columns) {
  const Words d;
  const auto frames = [&](std::size_t, std::size_t) HWY_ATTR { return hn::Set(d, key.frame); };
  const auto named = [&](std::size_t i, std::size_t n) HWY_ATTR {
    return n == hn::Lanes(d) ? hn::LoadU(d, beams + i) : hn::MaskedLoad(hn::FirstN(d, n), d, beams + i);
  };
  normals(words, key.purpose, block, count, frames, named, columns);
}

void normalsOfFrames(const PhiloxKey& words, const Random::Key& key, std::size_t count, std::uint32_t block,
                     float* const* columns) {
  const Words d;
  const auto frames = [&](std::size_t i, std::size_t)
                          HWY_ATTR { return hn::Iota(d, key.frame + static_cast<std::uint32_t>(i)); };
  const auto beams = [&](std::size_t, std::size_t) HWY_ATTR { return hn::Set(d, key.beam); };
  normals(words, key.purpose, block, count, frames, beams, columns);
}

using Doubles = hn::ScalableTag<double>;

/// One function over a column; the rest at the end goes through a vector of its own.
template <class Function>
HWY_INLINE void overColumn(const double* in, double* out, std::size_t count, const Function& function) {
  const Doubles d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) hn::StoreU(function(d, hn::LoadU(d, in + i)), d, out + i);
  if (i == count) return;
  const auto rest = hn::FirstN(d, count - i);
  const auto filled = hn::IfThenElse(rest, hn::MaskedLoad(rest, d, in + i), hn::Set(d, 1.0));
  hn::BlendedStore(function(d, filled), rest, d, out + i);
}

void log2Column(const double* in, double* out, std::size_t count) {
  overColumn(in, out, count, [](auto d, auto x) HWY_ATTR { return hn::Log2(d, x); });
}

void expColumn(const double* in, double* out, std::size_t count) {
  overColumn(in, out, count, [](auto d, auto x) HWY_ATTR { return hn::Exp(d, x); });
}

}  // namespace core::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace core {

HWY_EXPORT(normalsOfBeams);
HWY_EXPORT(normalsOfFrames);
HWY_EXPORT(log2Column);
HWY_EXPORT(expColumn);

void log2Of(std::span<const double> in, std::span<double> out) {
  HWY_DYNAMIC_DISPATCH(log2Column)(in.data(), out.data(), in.size());
}

void expOf(std::span<const double> in, std::span<double> out) {
  HWY_DYNAMIC_DISPATCH(expColumn)(in.data(), out.data(), in.size());
}

namespace {

std::array<float*, 4> startsOf(const NormalColumns& columns) {
  return {columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data()};
}

}  // namespace

void normalsOf(const Random::Key& key, std::span<const std::uint32_t> beams, std::uint32_t block,
               const NormalColumns& columns) {
  HWY_DYNAMIC_DISPATCH(normalsOfBeams)
  (philoxKeyOf(key), key, beams.data(), beams.size(), block, startsOf(columns).data());
}

void normalsInFrames(const Random::Key& key, std::uint32_t block, const NormalColumns& columns) {
  HWY_DYNAMIC_DISPATCH(normalsOfFrames)
  (philoxKeyOf(key), key, columns[0].size(), block, startsOf(columns).data());
}

}  // namespace core
#endif
