#include "gap/unexplained/uneven_loss.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "core/physics.h"
#include "gap/unexplained/periodic_law.h"
#include "model/effects/effect.h"

namespace gap {

namespace {

constexpr double kStrong = 3.0;     // times the threshold: no noise and no other program's model loses such an echo
constexpr double kUneven = 0.5;     // of the mean loss: what programs differ by stays below
constexpr double kStandsOut = 6.0;  // standard deviations, as of frames that do not repeat each other
constexpr double kFewestBeams = 30.0;
constexpr double kMostLost = 4.0;  // of what is expected of a beam, and so many more: single beams of which programs
                                   // differ lose everything and prove nothing

/// The effect of the library that a cause is, or whose number it corrects; null if there is none.
const model::EffectEntry* effectOf(const Hypothesis& cause) {
  if (cause.kind == CauseKind::kEffect) return model::findEffect(cause.name);
  if (cause.kind != CauseKind::kParameter) return nullptr;
  const auto effect = nlohmann::json::json_pointer(cause.name).parent_pointer();  // of /effects/<name>/<number>
  if (effect.parent_pointer().to_string() != "/effects") return nullptr;
  return model::findEffect(effect.back());
}

bool takesFromAllShotsAlike(const Candidate& cause) {
  const std::vector<Candidate> members = membersOf(cause);
  return std::any_of(members.begin(), members.end(), [](const Candidate& member) {
    const model::EffectEntry* const effect = effectOf(member.hypothesis);
    return effect != nullptr && effect->info.every_shot_alike;
  });
}

/// Echoes of one beam, all frames and samples.
struct Echoes {
  double azimuth_deg = 0.0;
  double shots = 0.0, measured = 0.0, expected = 0.0;

  [[nodiscard]] double lostAsExpected() const { return shots - expected; }
  /// How many more are lost than expected.
  [[nodiscard]] double lostBesides() const {
    return std::min(expected - measured, (kMostLost - 1.0) * lostAsExpected() + kMostLost);
  }
  /// Of that, by chance: both are drawn.
  [[nodiscard]] double byChance() const {
    const double rate = 0.5 * (measured + expected) / shots;
    return 2.0 * shots * rate * (1.0 - rate);
  }
  /// Half an echo more, for the rate of a single beam is not known better.
  [[nodiscard]] double variance() const { return byChance() + 0.5; }
};

/// Of a sensor, by number in the whole scan.
using Beam = std::pair<std::string, std::uint32_t>;

std::vector<Echoes> strongEchoesOf(const Judge& judge, const Candidate& cause) {
  std::map<Beam, Echoes> beams;
  const Replay& replay = judge.replay;
  const World world = worldOf(replay, cause.hypothesis, cause.values);
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    const double frames = sample.frames;
    const auto simulated = replay.simulate(world, s, sample.frames, judge.split.held_out.seed);
    for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
      const Cell& cell = sample.layout->cells()[c];
      if (cell.at_edge || cell.share < kWholeBeam || cell.power_over_threshold < kStrong) continue;
      Echoes& echoes = beams[{sample.sample->sensor, sample.taken.empty() ? cell.beam : sample.taken[cell.beam]}];
      echoes.azimuth_deg = sample.beams[cell.beam].azimuth_rad * core::kDegPerRad;
      echoes.shots += frames;
      echoes.measured += std::min(frames, sample.statistics[c].count);
      echoes.expected += std::min(frames, simulated[c].count);
    }
  }
  std::vector<Echoes> in_order;
  for (const auto& [beam, echoes] : beams) in_order.push_back(echoes);
  return in_order;
}

/// A wave over azimuth.
struct Wave {
  double period_deg = 0.0;
  double power = 0.0;      ///< of standard normal deviates 1 on average
  double amplitude = 0.0;  ///< of the shots
};

/// The wave of this period in what beams lose beyond the mean of all of them, that of `besides` of a shot.
Wave waveIn(const std::vector<Echoes>& beams, double besides, double period_deg) {
  const auto phaseOf = [&](const Echoes& echoes) {
    return std::polar(1.0, 2.0 * std::numbers::pi * echoes.azimuth_deg / period_deg);
  };
  double shots = 0.0;
  std::complex<double> centre = 0.0;
  for (const Echoes& echoes : beams) {
    shots += echoes.shots;
    centre += echoes.shots * phaseOf(echoes);
  }
  centre /= shots;
  std::complex<double> sum = 0.0;
  double cos_cos = 0.0, cos_sin = 0.0, sin_sin = 0.0;  // covariance of its parts
  for (const Echoes& echoes : beams) {
    const std::complex<double> phase = phaseOf(echoes) - centre;
    sum += (echoes.lostBesides() - besides * echoes.shots) * phase;
    cos_cos += echoes.byChance() * phase.real() * phase.real();
    cos_sin += echoes.byChance() * phase.real() * phase.imag();
    sin_sin += echoes.byChance() * phase.imag() * phase.imag();
  }
  const double determinant = cos_cos * sin_sin - cos_sin * cos_sin;
  if (!(determinant > 1e-6 * cos_cos * sin_sin)) return {.period_deg = period_deg};  // it has one phase
  const double squares = (sin_sin * sum.real() * sum.real() - 2.0 * cos_sin * sum.real() * sum.imag() +
                          cos_cos * sum.imag() * sum.imag()) /
                         determinant;
  return {period_deg, 0.5 * squares, 2.0 * std::abs(sum) / shots};
}

/// Of the strongest wave, if chance makes none such among as many periods, and it is as uneven as `unevenLossIn` asks.
std::optional<double> periodIn(const std::vector<Echoes>& beams, double step_deg, double lost, double besides) {
  const auto [first, last] = std::minmax_element(
      beams.begin(), beams.end(), [](const Echoes& a, const Echoes& b) { return a.azimuth_deg < b.azimuth_deg; });
  const std::vector<double> frequencies = frequenciesIn(last->azimuth_deg - first->azimuth_deg, 0.5 / step_deg);
  if (frequencies.empty()) return std::nullopt;
  std::vector<Wave> waves(frequencies.size());
  core::parallelFor(waves.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) waves[i] = waveIn(beams, besides, 1.0 / frequencies[i]);
  });
  const Wave& strongest =
      *std::max_element(waves.begin(), waves.end(), [](const Wave& a, const Wave& b) { return a.power < b.power; });
  const double by_chance = std::log(static_cast<double>(waves.size())) + 0.5 * kStandsOut * kStandsOut;
  if (strongest.power < by_chance || strongest.amplitude < kUneven * lost) return std::nullopt;
  return strongest.period_deg;
}

}  // namespace

std::optional<UnevenLoss> unevenLossIn(const Judge& judge, const Candidate& cause) {
  if (judge.replay.samples().front().layout->pooled() || !takesFromAllShotsAlike(cause)) return std::nullopt;
  const auto beams = strongEchoesOf(judge, cause);
  const double count = static_cast<double>(beams.size());
  if (count < kFewestBeams) return std::nullopt;
  double shots = 0.0, squared_shots = 0.0, lost = 0.0, besides = 0.0;
  for (const Echoes& echoes : beams) {
    shots += echoes.shots;
    squared_shots += echoes.shots * echoes.shots;
    lost += echoes.lostAsExpected();
    besides += echoes.lostBesides();
  }
  double beyond_chance = 0.0, index = 0.0;
  for (const Echoes& echoes : beams) {
    const double square = std::pow(echoes.lostBesides() - besides / shots * echoes.shots, 2.0);
    beyond_chance += square - echoes.variance();
    index += square / echoes.variance();
  }
  UnevenLoss loss;
  loss.beams = beams.size();
  loss.mean = lost / shots;
  loss.stddev = std::sqrt(std::max(0.0, beyond_chance / squared_shots));
  loss.z = (index - count) / std::sqrt(2.0 * count);
  loss.unhurt =
      static_cast<double>(std::count_if(
          beams.begin(), beams.end(),
          [&](const Echoes& echoes) { return echoes.shots - echoes.measured < 0.5 * loss.mean * echoes.shots; })) /
      count;
  loss.period_deg = periodIn(beams, azimuthStep_deg(judge.replay), loss.mean, besides / shots);
  const bool from_beam_to_beam = loss.z >= kStandsOut && loss.stddev >= kUneven * loss.mean;
  if (!from_beam_to_beam && !loss.period_deg) return std::nullopt;
  return loss;
}

}  // namespace gap
