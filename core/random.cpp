#include "core/random.h"

#include <Random123/philox.h>
#include <cmath>
#include <numbers>

namespace core {

PhiloxKey philoxKeyOf(const Random::Key& key) {
  // 64 bits of key carry the seed; the counter carries what tells the streams apart. `purpose` and `sample` share
  // nothing with the block index, so no stream can run into another within 2^32 blocks.
  return {static_cast<std::uint32_t>(key.seed) ^ (key.purpose * 0x9E3779B9u),
          static_cast<std::uint32_t>(key.seed >> 32) + key.sample};
}

void Random::refill() {
  r123::Philox4x32 philox;
  const PhiloxKey own = philoxKeyOf(key_);
  const r123::Philox4x32::ukey_type key = {{own[0], own[1]}};
  const r123::Philox4x32::ctr_type counter = {{block_, key_.frame, key_.beam, key_.purpose}};
  const auto words = philox(counter, key);
  for (int i = 0; i < 4; ++i) words_[i] = words[static_cast<std::size_t>(i)];
  ++block_;
  word_ = 0;
}

std::uint32_t Random::bits() {
  if (word_ == 4) refill();
  return words_[word_++];
}

double Random::uniform() { return (static_cast<double>(bits()) + 0.5) * 0x1.0p-32; }

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_normal_;
  }
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  const double angle = 2.0 * std::numbers::pi * uniform();
  spare_normal_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

double Random::gamma(double shape) {
  if (shape < 1.0) return gamma(shape + 1.0) * std::pow(uniform(), 1.0 / shape);
  const double d = shape - 1.0 / 3.0;
  const double c = 1.0 / std::sqrt(9.0 * d);
  while (true) {
    const double x = normal();
    const double v = std::pow(1.0 + c * x, 3.0);
    if (v > 0.0 && std::log(uniform()) < 0.5 * x * x + d - d * v + d * std::log(v)) return d * v;
  }
}

std::uint32_t Random::poisson(double mean) {
  if (mean <= 0.0) return 0;
  if (mean > 60.0) {
    const double value = std::round(mean + std::sqrt(mean) * normal());
    return value < 0.0 ? 0 : static_cast<std::uint32_t>(value);
  }
  const double limit = std::exp(-mean);
  std::uint32_t count = 0;
  for (double product = uniform(); product > limit; product *= uniform()) ++count;
  return count;
}

std::uint32_t Random::below(std::uint32_t n) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(bits()) * n) >> 32);
}

}  // namespace core
