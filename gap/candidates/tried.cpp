#include "gap/candidates/tried.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/csv.h"
#include "core/parallel.h"
#include "core/text.h"
#include "gap/candidates/signatures.h"
#include "gap/distance/discrepancy.h"

namespace gap {

namespace {

constexpr double kFar = 20.0;  // errors: of a surface that only one side detects, in every channel
constexpr std::size_t kSignatureSamples = 4;
constexpr int kSignatureFrames = 4;
constexpr int kDigits = 8;  // of numbers in the list

/// Difference of two shares of shots detected in its binomial standard error; half a detection is added to each side,
/// so that none and all have an error, too.
double rateDifference(double measured, int measured_frames, double simulated, int simulated_frames) {
  const double rate = std::min(1.0, (measured + simulated + 1.0) / (measured_frames + simulated_frames + 2.0));
  const double variance = std::max(1e-4, rate * (1.0 - rate));
  return (measured / measured_frames - simulated / simulated_frames) /
         std::sqrt(variance / measured_frames + variance / simulated_frames);
}

void addCells(const Replay& replay, const Comparison& comparison, Part part, MeansApart& means) {
  const auto& [index, measured, measured_frames, simulated, simulated_frames] = comparison;
  const ReplaySample& sample = replay.samples()[index];
  for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
    const CellStatistics &m = measured[c], &s = simulated[c];
    if (!takesPart(sample, sample.layout->cells()[c], part) || (m.count == 0.0 && s.count == 0.0)) continue;
    if (!sample.layout->pooled()) means.add(rateDifference(m.count, measured_frames, s.count, simulated_frames));
    const bool lost = m.count == 0.0 || s.count == 0.0;
    const double rate = std::max(m.count / measured_frames, s.count / simulated_frames);
    for (const Channel channel : replay.channels()) {
      means.add(lost ? kFar * std::max(0.0, rate - kOftenDetected)
                     : (m.mean(channel) - s.mean(channel)) / comparableError(replay, sample, c, channel, m, s));
    }
  }
}

/// How many numbers act on the fitted samples: the offset of another set-up does not.
std::size_t numbersFitted(const Judge& judge, const Hypothesis& hypothesis) {
  return hypothesis.per_setup ? setupsOf(judge.replay, judge.split.fitted.samples).size()
                              : hypothesis.parameters.size();
}

double cosineOf(const Signature& a, const Signature& b) {
  const double product = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  const double squares =
      std::inner_product(a.begin(), a.end(), a.begin(), 0.0) * std::inner_product(b.begin(), b.end(), b.begin(), 0.0);
  return squares > 0.0 ? product / std::sqrt(squares) : 0.0;
}

/// At values all over its range, and at those that were fitted.
double similarityOf(const Replay& replay, const SignatureSpace& space, const Candidate& candidate) {
  std::vector<std::vector<double>> places = valuesAllOver(candidate.hypothesis);
  places.push_back(candidate.values);
  double best = -1.0;
  for (const auto& values : places)
    best = std::max(best, cosineOf(space.of(worldOf(replay, candidate.hypothesis, values)), space.ofMeasurement()));
  return best;
}

/// "visibility_m", of a pair "atmospheric-attenuation.visibility_m": both may have a number of one name.
std::vector<std::pair<std::string, double>> namedValues(const Candidate& candidate) {
  std::vector<std::pair<std::string, double>> values;
  for (const Candidate& member : membersOf(candidate)) {
    const std::string prefix = candidate.hypothesis.members.empty() ? "" : member.hypothesis.name + ".";
    for (std::size_t i = 0; i < member.values.size(); ++i)
      values.emplace_back(prefix + member.hypothesis.parameters[i].name, member.values[i]);
  }
  return values;
}

Tried told(const Judge& judge, const Candidate& candidate, std::size_t rank) {
  const Hypothesis& hypothesis = candidate.hypothesis;
  Tried tried;
  tried.kind = hypothesis.members.empty() ? toString(hypothesis.kind) : "pair";
  tried.rank = rank;
  tried.name = hypothesis.name;
  tried.variant = hypothesis.variant;
  tried.sensors = hypothesis.sensors;
  tried.values = namedValues(candidate);
  tried.explained = candidate.explained;
  const World world = worldOf(judge.replay, hypothesis, candidate.values);
  tried.discrepancy = discrepancyOf(judge.replay, world, judge.split.held_out);
  tried.bic = bicOf(meansApart(judge.replay, world, judge.split.refined), numbersFitted(judge, hypothesis));
  return tried;
}

}  // namespace

MeansApart meansApart(const Replay& replay, const World& world, const Evidence& fitted) {
  MeansApart means;
  for (const Comparison& comparison : comparisonsOf(replay, world, fitted))
    addCells(replay, comparison, fitted.part, means);
  return means;
}

double bicOf(const MeansApart& means, std::size_t free_numbers) {
  const double terms = static_cast<double>(std::max<std::size_t>(1, means.terms));
  return means.sum + static_cast<double>(free_numbers) * std::log(terms);
}

std::vector<Tried> triedOf(const Judge& judge, const std::vector<Candidate>& singles,
                           const std::vector<Candidate>& pairs, const core::Progress& progress) {
  const Replay& replay = judge.replay;
  const Evidence few = spreadOver(judge.split.fitted, kSignatureSamples, kSignatureFrames);
  const SignatureSpace space(replay, few.samples, kSignatureFrames, few.seed);
  std::vector<Tried> tried(1 + singles.size() + pairs.size());
  tried.front().kind = "none";
  tried.front().discrepancy = judge.yardstick.baseline;
  tried.front().bic = bicOf(meansApart(replay, replay.baseline(), judge.split.refined), 0);
  core::parallelFor(tried.size() - 1, 1, [&](std::size_t i, std::size_t) {
    core::stopIfCancelled(progress);
    const bool single = i < singles.size();
    const Candidate& candidate = single ? singles[i] : pairs[i - singles.size()];
    tried[1 + i] = told(judge, candidate, 1 + (single ? i : i - singles.size()));
    if (single) tried[1 + i].similarity = similarityOf(replay, space, candidate);
  });
  return tried;
}

std::string toCsv(const std::vector<Tried>& tried) {
  std::vector<std::string> fields = {"rank",   "kind",      "name",        "variant", "sensors",   "free_numbers",
                                     "values", "explained", "discrepancy", "bic",     "similarity"};
  std::string text = core::csvRecord(fields);
  for (const Tried& one : tried) {
    std::vector<std::string> values;
    for (const auto& [name, value] : one.values) values.push_back(name + "=" + core::significant(value, kDigits));
    fields = {one.rank == 0 ? "" : std::to_string(one.rank),
              one.kind,
              one.name,
              one.variant,
              core::join(one.sensors, ";"),
              std::to_string(one.values.size()),
              core::join(values, ";"),
              core::significant(one.explained, kDigits),
              core::significant(one.discrepancy, kDigits),
              core::significant(one.bic, kDigits),
              one.similarity ? core::significant(*one.similarity, kDigits) : ""};
    text += core::csvRecord(fields);
  }
  return text;
}

}  // namespace gap
