#include "gap/distance/settle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/physics.h"
#include "gap/distance/discrepancy.h"

namespace gap {

namespace {

constexpr int kSweeps = 4;  // reweighted least squares: three digits after two or three

/// One offset and every sample that it moves.
struct Offset {
  double low, high, variance;
  double value = 0.0;
  std::vector<std::pair<Comparison*, const Tolerance*>> moves;
};

/// Whether the world says of every set-up by itself where a quantity stands. One that is off by as much everywhere may
/// still stand anywhere around that within its interval.
bool placedBySetup(const World& world, const std::string& pointer) {
  return std::any_of(world.references.begin(), world.references.end(), [&](const ReferenceOffset& reference) {
    return reference.pointer == pointer && !reference.by_setup.empty();
  });
}

std::vector<Offset> offsetsOf(const Replay& replay, const World& world, std::span<Comparison> comparisons) {
  std::map<std::pair<std::string, std::string>, Offset> offsets;
  for (Comparison& comparison : comparisons) {
    const ReplaySample& sample = replay.samples()[comparison.sample];
    for (const Tolerance& tolerance : sample.tolerances) {
      if (placedBySetup(world, tolerance.pointer)) continue;
      const auto known = offsets
                             .try_emplace({sample.sample->setup, tolerance.pointer},
                                          Offset{tolerance.low, tolerance.high, tolerance.variance(), 0.0, {}})
                             .first;
      known->second.moves.emplace_back(&comparison, &tolerance);
    }
  }
  std::vector<Offset> list;
  for (auto& [place, offset] : offsets) list.push_back(std::move(offset));
  return list;
}

/// Moves the surfaces of a sample; the received power P falls with r⁻², the echo pulse width with it as
/// c · FWHM · sqrt(log2(P/P_th)) does (formats.md section 3).
void move(const Replay& replay, const Offset& offset, double by) {
  for (const auto& [comparison, tolerance] : offset.moves) {
    const ReplaySample& sample = replay.samples()[comparison->sample];
    const model::SensorProfile& sensor = replay.baseline().model.sensor(sample.sample->sensor);
    const double pulse_m = core::kMetresPerNanosecond * sensor.emitter.pulse_fwhm_ns;
    for (std::size_t c = 0; c < tolerance->range_per_unit.size(); ++c) {
      CellStatistics& s = comparison->simulated[c];
      const double shift_m = by * static_cast<double>(tolerance->range_per_unit[c]);
      if (shift_m == 0.0 || s.count == 0.0) continue;
      s.moveMean(kRange, shift_m);
      if (c >= sample.layout->surfaces()) continue;
      const double of_power = -2.0 * shift_m / sample.layout->cells()[c].anchor_m;  // relative
      const double epw_m = s.mean(kEpw);
      s.moveMean(kIntensity, of_power * s.mean(kIntensity));
      if (epw_m > 0.1 * pulse_m) s.moveMean(kEpw, of_power * pulse_m * pulse_m / (2.0 * std::numbers::ln2 * epw_m));
    }
  }
}

/// Echoes that no surface makes and that no offset brings together have nothing to do with each other.
bool tooFar(const CellStatistics& measured, const CellStatistics& simulated, const Offset& offset) {
  return std::abs(measured.mean(kRange) - simulated.mean(kRange)) > offset.high - offset.low;
}

/// One step of reweighted least squares for the robust loss ρ of `discrepancy`.
double stepOf(const Replay& replay, const Offset& offset, Part part) {
  double pull = -offset.value / offset.variance, stiffness = 1.0 / offset.variance;
  for (const auto& [comparison, tolerance] : offset.moves) {
    const ReplaySample& sample = replay.samples()[comparison->sample];
    for (std::size_t c = 0; c < tolerance->range_per_unit.size(); ++c) {
      const double slope = static_cast<double>(tolerance->range_per_unit[c]);
      const CellStatistics &m = comparison->measured[c], &s = comparison->simulated[c];
      if (slope == 0.0 || m.count == 0.0 || s.count == 0.0) continue;
      if (!takesPart(sample, sample.layout->cells()[c], part)) continue;
      if (c >= sample.layout->surfaces() && tooFar(m, s, offset)) continue;
      const double error = comparableError(replay, sample, c, kRange, m, s);
      const double z = (m.mean(kRange) - s.mean(kRange)) / error;
      const double weight = 1.0 / std::sqrt(1.0 + z * z);
      pull += weight * slope * z / error;
      stiffness += weight * slope * slope / (error * error);
    }
  }
  return std::clamp(offset.value + pull / stiffness, offset.low, offset.high) - offset.value;
}

}  // namespace

double settle(const Replay& replay, const World& world, std::span<Comparison> comparisons, Part part) {
  std::vector<Offset> offsets = offsetsOf(replay, world, comparisons);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (Offset& offset : offsets) {
      if (offset.variance <= 0.0) continue;
      const double step = stepOf(replay, offset, part);
      move(replay, offset, step);
      offset.value += step;
    }
  }
  double price = 0.0;
  for (const Offset& offset : offsets) {
    if (offset.variance > 0.0) price += offset.value * offset.value / (2.0 * offset.variance);
  }
  return price;
}

double drawnOffset(const Tolerance& tolerance, core::Random& random) {
  return std::clamp(std::sqrt(tolerance.variance()) * random.normal(), tolerance.low, tolerance.high);
}

void scatter(const Replay& replay, const World& world, std::span<Comparison> comparisons, std::uint64_t seed) {
  for (const Offset& offset : offsetsOf(replay, world, comparisons)) {
    const auto& [comparison, tolerance] = offset.moves.front();
    const std::string& setup = replay.samples()[comparison->sample].sample->setup;
    core::Random random({.seed = seed,
                         .sample = core::purposeOf(setup.c_str()),
                         .frame = core::purposeOf(tolerance->pointer.c_str()),
                         .purpose = core::purposeOf("reference")});
    move(replay, offset, drawnOffset(*tolerance, random));
  }
}

}  // namespace gap
