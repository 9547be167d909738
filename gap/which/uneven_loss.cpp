#include "gap/which/uneven_loss.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/effects/effect.h"

namespace gap {

namespace {

constexpr double kStrong = 3.0;     // times the threshold: no noise and no other program's model loses such an echo
constexpr double kUneven = 0.5;     // of the mean loss: what programs differ by stays below
constexpr double kStandsOut = 6.0;  // standard deviations, as of frames that do not repeat each other
constexpr double kFewestBeams = 30.0;
constexpr double kMostLost = 4.0;  // of what is expected of a beam, and so many more: single beams of which programs
                                   // differ lose everything and prove nothing

bool takesFromAllShotsAlike(const Candidate& cause) {
  const std::vector<Candidate> members = membersOf(cause);
  return std::any_of(members.begin(), members.end(), [](const Candidate& member) {
    return member.hypothesis.kind == CauseKind::kEffect &&
           model::findEffect(member.hypothesis.name)->info.every_shot_alike;
  });
}

/// Echoes of one beam, all frames and samples.
struct Echoes {
  double shots = 0.0, measured = 0.0, expected = 0.0;

  [[nodiscard]] double lostAsExpected() const { return shots - expected; }
  /// How many more are lost than expected.
  [[nodiscard]] double lostBesides() const {
    return std::min(expected - measured, (kMostLost - 1.0) * lostAsExpected() + kMostLost);
  }
  /// Of that, by chance: both are drawn. Half an echo more, for rates are not known better.
  [[nodiscard]] double variance() const {
    const double rate = 0.5 * (measured + expected) / shots;
    return 2.0 * shots * rate * (1.0 - rate) + 0.5;
  }
};

/// Of a sensor, by number in the whole scan.
using Beam = std::pair<std::string, std::uint32_t>;

std::map<Beam, Echoes> strongEchoesOf(const Judge& judge, const Candidate& cause) {
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
      echoes.shots += frames;
      echoes.measured += std::min(frames, sample.statistics[c].count);
      echoes.expected += std::min(frames, simulated[c].count);
    }
  }
  return beams;
}

}  // namespace

std::optional<UnevenLoss> unevenLossIn(const Judge& judge, const Candidate& cause) {
  if (judge.replay.samples().front().layout->pooled() || !takesFromAllShotsAlike(cause)) return std::nullopt;
  const auto beams = strongEchoesOf(judge, cause);
  const double count = static_cast<double>(beams.size());
  if (count < kFewestBeams) return std::nullopt;
  double shots = 0.0, squared_shots = 0.0, lost = 0.0, besides = 0.0;
  for (const auto& [beam, echoes] : beams) {
    shots += echoes.shots;
    squared_shots += echoes.shots * echoes.shots;
    lost += echoes.lostAsExpected();
    besides += echoes.lostBesides();
  }
  double beyond_chance = 0.0, index = 0.0;
  for (const auto& [beam, echoes] : beams) {
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
      static_cast<double>(std::count_if(beams.begin(), beams.end(),
                                        [&](const auto& beam) {
                                          const Echoes& echoes = beam.second;
                                          return echoes.shots - echoes.measured < 0.5 * loss.mean * echoes.shots;
                                        })) /
      count;
  if (loss.z < kStandsOut || loss.stddev < kUneven * loss.mean) return std::nullopt;
  return loss;
}

}  // namespace gap
