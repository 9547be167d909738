#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <string_view>

namespace withheld {

/// What a stream of random numbers is for: changing one use must not move the others.
enum class Use : std::uint64_t {
  footprint,
  shot,
  echo,
  outputs,
  losses,
  foreign,
  drops,
  spray,
  pattern,
  setup,
  wobble
};

/// FNV-1a, so that a text (sample id) can be part of a stream's name.
inline std::uint64_t nameOf(std::string_view text) {
  std::uint64_t hash = 1469598103934665603ULL;
  for (const unsigned char c : text) hash = (hash ^ c) * 1099511628211ULL;
  return hash;
}

/// One stream of random numbers, told from all others by its name (seed, use, sample, frame, beam).
/// SplitMix64 (Steele, Lea, Flood 2014, doi:10.1145/2660193.2660195); normals by Box and Muller 1958.
class Dice {
 public:
  Dice(std::uint64_t seed, Use use, std::initializer_list<std::uint64_t> name) : state_(mix(seed + kStep)) {
    state_ = mix(state_ ^ (static_cast<std::uint64_t>(use) + 1) * kStep);
    for (const std::uint64_t part : name) state_ = mix(state_ ^ mix(part + kStep)) + kStep;
  }

  std::uint64_t next() { return mix(state_ += kStep); }
  /// In (0, 1), never an end.
  double uniform() { return (static_cast<double>(next() >> 11) + 0.5) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double exponential() { return -std::log(uniform()); }

  double normal() {
    if (spare_ready_) {
      spare_ready_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(uniform())), angle = 2.0 * std::numbers::pi * uniform();
    spare_ = radius * std::sin(angle);
    spare_ready_ = true;
    return radius * std::cos(angle);
  }

  /// Counts arrivals of a unit-rate process in [0, mean].
  int poisson(double mean) {
    int count = 0;
    for (double time = exponential(); time < mean; time += exponential()) ++count;
    return count;
  }

  /// Unit mean, shape `shape` > 0. Marsaglia and Tsang 2000, doi:10.1145/358407.358414.
  double gammaOfMeanOne(double shape) {
    const double boost = shape < 1.0 ? std::pow(uniform(), 1.0 / shape) : 1.0;
    const double d = (shape < 1.0 ? shape + 1.0 : shape) - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
    for (;;) {
      const double x = normal(), v = std::pow(1.0 + c * x, 3.0);
      if (v > 0.0 && std::log(uniform()) < 0.5 * x * x + d - d * v + d * std::log(v)) return boost * d * v / shape;
    }
  }

 private:
  static constexpr std::uint64_t kStep = 0x9E3779B97F4A7C15ULL;

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
  double spare_ = 0.0;
  bool spare_ready_ = false;
};

}  // namespace withheld
