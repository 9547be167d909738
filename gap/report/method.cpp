#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"
#include "core/version.h"
#include "gap/report/quantities.h"
#include "gap/report/sections.h"
#include "gap/report/titles.h"

namespace gap {

using report::Align;
using report::Html;

namespace {

/// Numbers to four digits: a fit knows no more.
nlohmann::json rounded(nlohmann::json value) {
  if (value.is_number_float()) {
    double number = 0.0;
    if (core::parseNumber(core::significant(value.get<double>(), 4), number)) value = number;
  }
  if (value.is_structured()) {
    for (auto& part : value) part = rounded(part);
  }
  return value;
}

void addProposal(report::Page& page, const Diagnosis& diagnosis) {
  if (diagnosis.proposed_model.is_null()) return;
  page.subsection("The proposed model file", "proposal");
  page.paragraph("Only this changes in the model file (numbers rounded here):");
  nlohmann::ordered_json change;
  for (const Cause& cause : diagnosis.causes) {
    if (!diagnosis.verdict.holds(cause.name)) continue;
    const nlohmann::json::json_pointer place(cause.kind == CauseKind::kEffect ? "/effects/" + cause.name : cause.name);
    if (!diagnosis.proposed_model.contains(place)) continue;
    change[nlohmann::ordered_json::json_pointer(place.to_string())] = rounded(diagnosis.proposed_model.at(place));
  }
  page.preformatted(change.dump(2));
}

void addPredictions(report::Page& page, const Diagnosis& diagnosis) {
  const NextExperiment& next = *diagnosis.next_experiment;
  if (next.predictions.empty()) return;
  std::vector<std::vector<Html>> rows;
  for (const Prediction& p : next.predictions) {
    const double largest = std::max({std::abs(p.values[0]), std::abs(p.values[1]), std::abs(p.values[2])});
    const auto number = [&](double value) { return withUnitOf(largest, value, p.unit); };
    rows.push_back({report::text(measurandTitle(p.measurand)), report::text(percent(p.beams)),
                    report::text(number(p.values[0])), report::text(number(p.values[1])),
                    report::text(number(p.values[2])), report::text("± " + number(p.noise))});
  }
  page.table({{"measurand", Align::Left, true},
              {"beams that tell", Align::Right},
              {"model as it is", Align::Right},
              {"if it is " + causeTitle(diagnosis, next.separates[0]), Align::Right},
              {"if it is " + causeTitle(diagnosis, next.separates[1]), Align::Right},
              {"noise of a beam", Align::Right}},
             rows,
             "What each candidate predicts, as a mean over the beams in which the two clearly differ (their share: "
             "beams that tell); ranges as a difference from where the surface is. Noise: by how much one beam "
             "may differ by chance.");
}

report::Definition word(const char* term, const char* anchor, const char* meaning) {
  return {term, anchor, report::text(meaning)};
}

std::vector<report::Definition> words() {
  return {
      word("measurand", "",
           "A quantity that is compared: the range of a detection, its echo pulse width, its "
           "intensity, or whether there is a detection at all (existence)."),
      word("echo pulse width", "",
           "How long the echo stays above the detection threshold, written as a length "
           "(time × speed of light). Weak echoes are narrow."),
      word("measured − simulated", "",
           "The sign of all differences on this page, but for the bias: below zero means that "
           "the simulation is too high."),
      word("bias (d_bias)", "word-bias",
           "By how much the simulated values are too high (> 0) or too low (< 0), over "
           "the whole distribution, in the measurand's unit."),
      word("scatter error (d_CAVM)", "word-scatter",
           "The area between the two distributions that is left once the bias "
           "is taken out: spread or shape are wrong. Corrected area "
           "validation metric, in the measurand's unit."),
      word("scatter (of a beam)", "",
           "The standard deviation of one beam's values over the frames. In maps and in “where” it is measured minus "
           "simulated, beam by beam."),
      word("missing, extra echoes", "",
           "Missing: echoes that only the simulation has. Extra: echoes that only the measurement has. Both as a share "
           "of all simulated echoes."),
      word("azimuth, elevation", "",
           "Directions as the sensor sees them: azimuth above zero is left of straight ahead, elevation above zero is "
           "up."),
      word("total gap", "word-total-gap",
           "One number for all measurands: bias and scatter error, each counted in steps of the sensor's resolution, "
           "plus the missing and extra echoes in per cent. 10 means, for instance, ten resolution steps too far. Noise "
           "is not taken off, so a fine resolution makes it large however right the model is."),
      word("held-out samples", "word-held-out",
           "Recordings that were kept aside while the causes were fitted. A cause must prove itself on them: on the "
           "data that it was fitted to, any cause looks good."),
      word("explains", "word-explains",
           "Share of the difference, beam by beam, that vanishes on the held-out samples when the cause is added. "
           "100 %: what is left is noise."),
      word("gap shrinks by", "word-shrinks",
           "By how much the total gap falls on the held-out samples when the cause is added. Below zero: it grows."),
      word("“named”, “corrected too”", "",
           "Named: what the answer says is the cause. Corrected too: a number that was fitted together with it; if it "
           "is one of the model's, it goes into the proposed model. The others are listed for comparison."),
      word(
          "confidence", "word-confidence",
          "How sure the answer is, between 0 and 100 %. The causes that explain the data share it, but of two that are "
          "named together each has its own, and the answer that both are right; what is missing to 100 % is the belief "
          "that it is none of them. It is lower where data are few."),
      word("95 % interval", "",
           "The range in which the true number lies in 95 of 100 cases. For fitted numbers it "
           "tells how much they change if any one set-up is left out."),
      word("90 % interval of the shrink", "",
           "The range in which the shrink would lie in 90 of 100 repetitions of the held-out recordings."),
      word("set-up", "word-setup",
           "Everything that was recorded without moving target or reference device; its "
           "recordings share the same error of the reference."),
      word("sample, frame, shot", "",
           "A sample is one recorded situation; a frame is one scan of it; a shot is one beam "
           "fired once."),
      word("part of the data (stratum)", "word-stratum",
           "All data with one quantity in a certain range, for instance "
           "all detections beyond 20 m."),
      word("chance?", "",
           "Whether noise could make a difference like this: “possibly”, “hardly”, “no”, or “no, "
           "certainly” (less than one in a million; corrected for how many parts were searched).")};
}

}  // namespace

void addNext(report::Page& page, const Diagnosis& diagnosis) {
  if (!diagnosis.next_experiment && diagnosis.proposed_model.is_null()) return;
  page.section("What to do next", "next");
  page.lead(
      diagnosis.proposed_model.is_null()
          ? "The one further measurement that would make the answer surer."
          : "What to change in the simulation, and the one further measurement that would make the answer surer.");
  addProposal(page, diagnosis);
  if (!diagnosis.next_experiment) return;
  const NextExperiment& next = *diagnosis.next_experiment;
  page.subsection("The next experiment", "experiment");
  std::vector<std::string> settings;
  for (const auto& [name, value] : next.parameters)
    settings.push_back(fmt::format("{} = {}", name, core::significant(value, 4)));
  page.paragraph(fmt::format(
      "Measure {} again{}. Of all settings in this experiment it is the one at which {} and {} differ most, compared "
      "to "
      "the noise.{}",
      settings.empty() ? "the sample " + next.sample : "with " + core::join(settings),
      settings.empty() ? "" : " (as in the sample " + next.sample + ")", causeTitle(diagnosis, next.separates[0]),
      causeTitle(diagnosis, next.separates[1]),
      next.predictions.empty() ? " No single beam on a surface shows it beyond its noise there: record for longer, or "
                                 "under a condition that was not measured yet."
                               : ""));
  addPredictions(page, diagnosis);
}

void addMethod(report::Page& page, const Diagnosis& diagnosis) {
  page.section("How this was found, and the words used", "method");
  page.lead(
      "The way from the data to the answer, for whoever wants to check it; all words of this page are explained "
      "below.");
  const Background& data = diagnosis.background;
  page.block(report::orderedList({
      report::text("The same shots as in the measurement were simulated, and both were compared beam by beam."),
      report::text("Every part of the data was searched for differences larger than noise and resolution."),
      report::text(data.hypotheses == 0
                       ? std::string("There was no gap, so no causes were fitted.")
                       : fmt::format("{} possible causes (effects that the model lacks, wrong numbers, wrong reference "
                                     "data) were each fitted on {}, all with the same random numbers.",
                                     data.hypotheses,
                                     diagnosis.weak_hold_out ? std::string("one half of the beams")
                                                             : "the samples " + core::join(data.fitted))),
      report::text(diagnosis.weak_hold_out
                       ? std::string("Each was judged on the other half of the beams: too few samples show the gap to "
                                     "keep some aside whole, so the confidence is lower.")
                       : "Each was judged on samples that were kept aside: " + core::join(diagnosis.held_out) + "."),
      report::text("A second cause is named only if one alone leaves a clear part of the gap. If no cause comes close, "
                   "the answer is “unknown” rather than the best of bad ones."),
  }));
  page.paragraph(
      "Limits: how often answers are right was counted on made-up cases of known cause, none of them from a real "
      "sensor; read 90 % as “quite sure”, not as an exact rate.");
  page.subsection("Words", "words");
  page.block(report::definitions(words()));
  page.subsection("Facts of this run", "facts");
  page.keyValues(
      {{"experiment", report::text(diagnosis.experiment)},
       {"model", report::text(diagnosis.model)},
       {"effects that the model has", report::text(data.effects.empty() ? "none" : core::join(data.effects))},
       {"verdict, as in the JSON report", report::code(toString(diagnosis.verdict.kind))},
       {"p-value of the gap",
        report::text(diagnosis.p_value < 1e-12 ? "< 1e-12" : core::significant(diagnosis.p_value))},
       {"fidelis", report::text(core::kVersion)}});
}

}  // namespace gap
