#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"
#include "gap/report/quantities.h"
#include "gap/report/rest_wording.h"
#include "gap/report/sections.h"
#include "gap/report/titles.h"
#include "gap/report/wording.h"

namespace gap {

using report::Html;
using report::Tone;

namespace {

constexpr double kSureEnough = 0.9;  // above it nobody is sent to measure again

Html causeBadge(CauseKind kind) {
  switch (kind) {
    case CauseKind::kEffect:
      return report::badge("missing effect", Tone::Bad);
    case CauseKind::kParameter:
      return report::badge("wrong parameter", Tone::Bad);
    case CauseKind::kReference:
      break;
  }
  return report::badge("wrong reference data", Tone::Bad);
}

Html verdictBadge(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::kNone:
      return report::badge("no gap", Tone::Good);
    case VerdictKind::kEffect:
      return causeBadge(CauseKind::kEffect);
    case VerdictKind::kParameter:
      return causeBadge(CauseKind::kParameter);
    case VerdictKind::kReference:
      return causeBadge(CauseKind::kReference);
    case VerdictKind::kUnknown:
      break;
  }
  return report::badge("cause unknown", Tone::Warning);
}

/// Of both causes, where the data cannot tell which of two that say different things of the model it is.
Html answerBadge(const Diagnosis& diagnosis) {
  const Html named = verdictBadge(diagnosis.verdict.kind);
  const Cause* const other = otherOfTwo(diagnosis);
  return other != nullptr ? named + report::text(" or ") + causeBadge(other->kind) : named;
}

std::string setupText(const Cause& cause) {
  std::vector<std::string> offsets;
  for (const auto& [setup, p] : cause.setups) {
    offsets.push_back(fmt::format("{} {}{}", setup, p.value > 0 ? "+" : "", withUnit(p.value, unitOf(p), 2)));
  }
  return core::join(offsets, "; ");
}

std::string upperFirst(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// The fitted numbers of what the verdict names.
std::string strengthText(const Diagnosis& diagnosis) {
  std::vector<std::string> all;
  for (const Cause& cause : diagnosis.causes) {
    if (!diagnosis.verdict.holds(cause.name)) continue;
    std::vector<std::string> numbers;
    for (const FittedParameter& p : cause.parameters) {
      const std::string unit = unitOf(p);
      const std::string recorded = p.recorded ? fmt::format("; the model says {}", withUnit(*p.recorded, unit)) : "";
      numbers.push_back(fittedText(cause, p) + recorded);
    }
    if (!cause.setups.empty()) numbers.push_back("true minus recorded, by set-up: " + setupText(cause));
    const std::string title = diagnosis.verdict.holdsSeveral() ? causeTitle(diagnosis, cause.name) + ": " : "";
    if (!numbers.empty()) all.push_back(title + core::join(numbers, "; "));
  }
  for (std::string& sentence : all) sentence = upperFirst(std::move(sentence));
  return all.empty() ? "" : core::join(all, ". ") + ".";
}

/// What the named effects are, for who never heard of them.
std::string summaryText(const Diagnosis& diagnosis) {
  std::vector<std::string> all;
  for (const std::string& name : diagnosis.verdict.names) {
    const std::string summary = causeSummary(name);
    if (summary.empty()) continue;
    const bool several = diagnosis.verdict.names.size() > 1;
    all.push_back(several ? upperFirst(causeTitle(diagnosis, name)) + ": " + summary : summary);
  }
  return core::join(all, " ");
}

/// What answers of one kind say with their confidence.
const char* claimOf(const Verdict& verdict) {
  if (verdict.kind == VerdictKind::kNone) return "are right that nothing is missing";
  if (verdict.kind == VerdictKind::kUnknown) return "are right that the cause is none of those tried";
  if (isOneOfTwo(verdict)) return "have the right cause among the two";
  return verdict.names.size() > 1 ? "name the right causes" : "name the right cause";
}

/// "Of ten diagnoses with this confidence about nine name the right cause."
std::string confidenceMeaning(const Diagnosis& diagnosis) {
  const double confidence = diagnosis.verdict.confidence;
  std::string text =
      fmt::format("{}: {}. Of 100 such answers about {:.0f} {}, as far as this could be counted on made-up cases.",
                  percent(confidence), confidenceInWords(confidence), 100.0 * confidence, claimOf(diagnosis.verdict));
  if (!diagnosis.verdict.indistinguishable_from.empty()) {
    std::vector<std::string> others;
    for (const std::string& name : diagnosis.verdict.indistinguishable_from)
      others.push_back(causeTitle(diagnosis, name));
    text += fmt::format(" But these data cannot tell {} from: {}.", whatIsTied(diagnosis.verdict),
                        core::join(others, " or "));
  }
  if (!diagnosis.verdict.limits.empty())
    text += " The data tell little: " + core::join(diagnosis.verdict.limits, "; ") + ".";
  if (diagnosis.weak_hold_out) {
    text +=
        " Too few samples show the gap to keep some aside whole, so the answer was checked on other beams of the same "
        "samples: record further set-ups to be surer.";
  }
  return text;
}

std::string evidenceText(const Diagnosis& diagnosis) {
  const Background& data = diagnosis.background;
  // Where beams judge, all samples are fitted and held out.
  const std::size_t samples = data.fitted.size() + (diagnosis.weak_hold_out ? 0 : diagnosis.held_out.size());
  return fmt::format("{} detections in {} frames of {} sample{}.", data.detections, data.frames, samples,
                     samples == 1 ? "" : "s");
}

/// What a reader asks who sees a cause that is believed and a shrink that may be none.
std::string whyItShrinksSoLittle(const Diagnosis& diagnosis) {
  constexpr double kFarMore = 0.3;  // of the gap
  const double of_beams = std::min(1.0, diagnosis.verdict.evidence.explained);
  const Shrink& shrink = diagnosis.shrink;
  if (shrink.interval.low > 0.0 || of_beams < shrink.fraction + kFarMore) return "";
  return fmt::format(
      " Beam by beam the cause explains {} of what differs. Pooled over all beams, a few far echoes, set-ups and "
      "chance decide as much: a repetition may show more, or that the gap does not shrink.",
      percent(of_beams));
}

std::string shrinkText(const Diagnosis& diagnosis) {
  const std::vector<std::string>& beside = diagnosis.verdict.beside;
  const char* judged =
      diagnosis.weak_hold_out ? "samples of which the fit saw one half of the beams" : "samples that the fit never saw";
  if (diagnosis.shrink.fraction <= 0.0)
    return fmt::format(
        "Not at all, pooled over all beams: {} before, {} after. Beam by beam the simulation with the cause agrees "
        "with {}; pooled data hide what evens out between beams.",
        core::significant(diagnosis.before.total), core::significant(diagnosis.after->total), judged);
  return fmt::format(
      "By {} (90 % interval {}), from {} to {}, on {}{}. "
      "100 % would be perfect agreement, which noise does not allow.{}",
      percent(diagnosis.shrink.fraction), percentInterval(diagnosis.shrink.interval),
      core::significant(diagnosis.before.total), core::significant(diagnosis.after->total), judged,
      beside.empty() ? "" : fmt::format(", with the {} corrected as well", causeTitle(diagnosis, beside.front())),
      whyItShrinksSoLittle(diagnosis));
}

/// What is left, where there is no gap to speak of.
std::string agreementText(const Diagnosis& diagnosis) {
  std::vector<std::string> parts;
  for (const MeasurandGap& m : diagnosis.before.measurands) {
    parts.push_back(fmt::format("{} {}", measurandTitle(m.name), withUnit(std::abs(m.d_bias), m.unit, 2)));
  }
  const bool chance = diagnosis.p_value >= kSignificance;
  return fmt::format("Means differ by: {}. {}", core::join(parts, "; "),
                     chance ? "Noise alone makes differences as large as these."
                            : "The data are so many that even this is more than noise, but it is too small against the "
                              "sensor's resolution to matter.");
}

std::vector<Html> nextSteps(const Diagnosis& diagnosis) {
  std::vector<Html> items;
  const VerdictKind kind = diagnosis.verdict.kind;
  if (kind == VerdictKind::kNone) {
    return {
        report::text("Nothing needs to be added to the model for this experiment."),
        report::text("The answer holds for the conditions that were measured; other distances, materials or weather "
                     "need their own experiment.")};
  }
  if (kind == VerdictKind::kUnknown) {
    if (const auto contradicted = wordsFor(diagnosis.verdict.contradiction))
      items.push_back(report::text(contradicted->look_for));
    const Law* pattern = patternIn(diagnosis.verdict, diagnosis.rest);
    if (const Law::Term* wave = pattern ? waveIn(*pattern) : nullptr) {
      items.push_back(report::text(
          wave->covariate == "range_m"
              ? "Look at how the sensor measures time first: what repeats over distance is seldom the scene's doing."
              : "Look at the sensor's mirror and angle encoder first: what repeats over azimuth is seldom the scene's "
                "doing."));
    }
    items.push_back(
        report::text("Look where they differ (next section): it tells in which part of the sensor or scene to "
                     "search."));
    items.push_back(report::text("Check what was recorded: positions, materials, weather, the sensor's data sheet."));
    items.push_back(
        report::text("If an effect is at work that the program does not know, add it to the model and run this "
                     "again."));
  }
  const Cause* const other = otherOfTwo(diagnosis);
  if (other != nullptr && (kind == VerdictKind::kReference || other->kind == CauseKind::kReference)) {
    const Cause& reference = kind == VerdictKind::kReference ? diagnosis.causes.front() : *other;
    items.push_back(
        report::text(fmt::format("Measure the reference again first ({}): that tells which of the two it is, and "
                                 "takes less than a change of the model.",
                                 causeTitle(diagnosis, reference.name))));
  } else if (kind == VerdictKind::kReference) {
    items.push_back(
        report::text("Measure the reference again, or correct it in experiment.json by the numbers above; do "
                     "not change the sensor model for it."));
  }
  if (!diagnosis.proposed_model.is_null()) {
    items.push_back(report::text("Try the proposed model file (") + report::link("#next", "what changes in it") +
                    report::text("): ") + report::code("fidelis gap … --write-model better.json") +
                    report::text(" writes it, ") + report::code("fidelis accept PROJECT --model better.json") +
                    report::text(" shows which acceptance tests it passes."));
  } else if (kind == VerdictKind::kEffect && diagnosis.approximation) {
    items.push_back(report::text("Add the effect to the model under test, about as strong as found above."));
  } else if (kind == VerdictKind::kParameter) {
    items.push_back(report::text("Correct the number in experiment.json, and check it by a measurement of its own."));
  }
  if (diagnosis.next_experiment && diagnosis.verdict.confidence < kSureEnough) {
    items.push_back(report::text("To be surer, measure once more: ") +
                    report::link("#next", "which setting separates the candidates best") + report::text("."));
  }
  return items;
}

/// What two causes would explain, a clause; empty where no two say more than one.
std::string nearestPairText(const Diagnosis& diagnosis) {
  const auto& pair = diagnosis.verdict.nearest_pair;
  return pair ? fmt::format(", {} together {}", titlesOf(diagnosis, pair->names), percent(pair->explained)) : "";
}

}  // namespace

std::string fittedText(const Cause& cause, const FittedParameter& parameter) {
  const std::string unit = unitOf(parameter);
  const std::string interval =
      parameter.interval ? fmt::format(" (95 % interval {})", intervalText(*parameter.interval, unit)) : "";
  return fmt::format("{} {}{}", parameterTitle(cause, parameter), withUnit(parameter.value, unit), interval);
}

void addAnswer(report::Page& page, const Diagnosis& diagnosis) {
  std::vector<report::KeyValue> facts;
  const std::string strength = strengthText(diagnosis), summary = summaryText(diagnosis);
  if (!summary.empty()) facts.push_back({"What that is", report::text(summary)});
  if (!strength.empty()) facts.push_back({"How strong", report::text(strength)});
  facts.push_back({"How sure", report::text(confidenceMeaning(diagnosis))});
  if (diagnosis.after) facts.push_back({"How far the gap shrinks", report::text(shrinkText(diagnosis))});
  if (diagnosis.verdict.kind == VerdictKind::kNone)
    facts.push_back({"How well they agree", report::text(agreementText(diagnosis))});
  if (diagnosis.verdict.kind == VerdictKind::kUnknown && !diagnosis.causes.empty()) {
    const Cause& nearest = diagnosis.causes.front();
    const auto contradicted = wordsFor(diagnosis.verdict.contradiction);
    const char* why_not = contradicted ? contradicted->why_not : "a right one would explain nearly all";
    facts.push_back({"The nearest cause",
                     report::text(fmt::format(
                         "{} would explain {} of what there is to explain{}; {}.", causeTitle(diagnosis, nearest.name),
                         percent(std::max(0.0, nearest.explained)), nearestPairText(diagnosis), why_not))});
  }
  if (const Law* pattern = patternIn(diagnosis.verdict, diagnosis.rest))
    facts.push_back({"A pattern in it", report::text(patternText(*pattern))});
  if (diagnosis.present && !diagnosis.where.empty()) {
    const WhereRow& most = diagnosis.where.front();
    facts.push_back({"Where it shows most",
                     report::text(fmt::format("{}. This part holds {} of the data and {} of that difference.{}",
                                              whereClause(most), percent(most.size), percent(most.share),
                                              most.mayBeChance() ? " It may be chance." : ""))});
  }
  facts.push_back({"From which data", report::text(evidenceText(diagnosis))});
  std::vector<std::string> notes = diagnosis.notes;
  if (diagnosis.approximation) notes.insert(notes.begin(), diagnosis.approximation->text);
  if (!notes.empty()) facts.push_back({"To bear in mind", report::text(core::join(notes, " "))});
  facts.push_back({"What to do next", report::orderedList(nextSteps(diagnosis))});
  page.answer("Answer", answerBadge(diagnosis), answerSentence(diagnosis), facts);
}

}  // namespace gap
