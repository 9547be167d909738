#pragma once

#include <array>
#include <cstdint>

namespace core {

/// Counter-based random numbers (Philox 4x32-10, Salmon et al. 2011, doi:10.1145/2063384.2063405): the n-th number is
/// a pure function of the key and n, so results do not depend on threads or order, and two hypotheses that share a
/// key see the same noise.
class Random {
 public:
  /// What a number is for. Streams of different purposes are independent.
  struct Key {
    std::uint64_t seed = 0;
    std::uint32_t sample = 0;  ///< sample, or any other outer index
    std::uint32_t frame = 0;
    std::uint32_t beam = 0;
    std::uint32_t purpose = 0;  ///< e.g. hash of an effect's name; see purposeOf
  };

  explicit Random(Key key) : key_(key) {}

  double uniform();                      ///< in (0, 1), 32 bits
  double normal();                       ///< mean 0, standard deviation 1 (Box–Muller)
  double gamma(double shape);            ///< mean `shape`, unit scale; shape > 0 (Marsaglia & Tsang 2000)
  std::uint32_t poisson(double mean);    ///< inversion for small means, normal approximation above 60
  std::uint32_t below(std::uint32_t n);  ///< 0 … n-1

 private:
  std::uint32_t bits();
  void refill();

  Key key_;
  std::uint32_t block_ = 0;
  std::uint32_t word_ = 4;
  std::uint32_t words_[4] = {};
  double spare_normal_ = 0.0;
  bool has_spare_ = false;
};

/// The two words of the Philox key of a stream.
using PhiloxKey = std::array<std::uint32_t, 2>;
[[nodiscard]] PhiloxKey philoxKeyOf(const Random::Key& key);

/// A stable number for the name of a purpose (FNV-1a).
constexpr std::uint32_t purposeOf(const char* name) {
  std::uint32_t hash = 2166136261u;
  for (; *name; ++name) hash = (hash ^ static_cast<unsigned char>(*name)) * 16777619u;
  return hash;
}

}  // namespace core
