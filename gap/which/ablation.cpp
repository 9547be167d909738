#include "gap/which/ablation.h"

#include "core/error.h"
#include "core/text.h"

namespace gap {

Ablation Ablation::of(std::span<const std::string> names) {
  Ablation without;
  for (const std::string& name : names) {
    if (name == "references") {
      without.references = true;
    } else if (name == "parameters") {
      without.parameters = true;
    } else if (name == "hold-out") {
      without.hold_out = true;
    } else {
      throw core::InputError({.item = "--without"}, "'" + name + "' is no part that can be left out.",
                             "Known are references, parameters, hold-out.");
    }
  }
  return without;
}

model::Experiment Ablation::applied(model::Experiment experiment) const {
  if (!references) return experiment;
  for (model::Sample& sample : experiment.samples) sample.epistemic.clear();
  return experiment;
}

std::vector<Hypothesis> Ablation::applied(std::vector<Hypothesis> hypotheses) const {
  std::erase_if(hypotheses, [&](const Hypothesis& hypothesis) {
    return (references && hypothesis.kind == CauseKind::kReference) ||
           (parameters && hypothesis.kind == CauseKind::kParameter);
  });
  return hypotheses;
}

Split Ablation::applied(Split split) const {
  if (!hold_out) return split;
  split.held_out.samples = split.fitted.samples;
  split.held_out.part = split.fitted.part;
  return split;
}

std::string Ablation::note() const {
  std::vector<std::string> names;
  if (references) names.emplace_back("references");
  if (parameters) names.emplace_back("parameters");
  if (hold_out) names.emplace_back("hold-out");
  if (names.empty()) return "";
  return "Made without " + core::join(names) + ", to see what it brings: no verdict to rely upon.";
}

}  // namespace gap
