#include "gap/background.h"

#include <algorithm>

namespace gap {

Background backgroundOf(const Replay& replay, const Split& split, const Decision& decision) {
  Background background;
  background.objects = objectsOf(replay);
  for (const std::size_t s : split.fitted.samples) background.fitted.push_back(replay.samples()[s].sample->id);
  for (const ReplaySample& sample : replay.samples()) {
    background.frames += static_cast<std::size_t>(sample.frames);
    background.detections += sample.measured.size();
  }
  background.hypotheses = decision.singles.size();
  for (const model::ActiveEffect& effect : replay.baseline().model.effects) background.effects.push_back(effect.name);
  return background;
}

std::vector<NamedWorld> worldsOf(const Replay& replay, const Decision& decision, const std::vector<Cause>& causes) {
  std::vector<Candidate> candidates;
  if (decision.pair()) candidates = membersOf(*decision.winner);
  candidates.insert(candidates.end(), decision.singles.begin(), decision.singles.end());
  std::vector<NamedWorld> worlds;
  for (const Cause& cause : causes) {
    const Form form = {cause.name, cause.variant, cause.sensors};
    const auto found = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return formOf(c.hypothesis) == form; });
    if (found != candidates.end()) worlds.push_back({cause.name, worldOf(replay, found->hypothesis, found->values)});
  }
  return worlds;
}

}  // namespace gap
