#include "gap/report/wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <span>
#include <utility>

#include "core/text.h"
#include "gap/report/titles.h"

namespace gap {

namespace {

constexpr double kSure = 0.6;    // below, confidenceInWords says "not sure"
constexpr double kLikely = 0.4;  // below, "hardly more than a guess"

/// A covariate in a sentence, "{0}" and "{1}" being the ends of the stratum; and where both are the same.
struct StratumWording {
  const char* covariate;
  const char* interval;
  const char* point;
};
constexpr std::array<StratumWording, 6> kStrata = {{
    {"range_m", "at ranges from {0} to {1} m", "at the range {0} m"},
    {"azimuth_deg", "at azimuths from {0}° to {1}°", "at the azimuth {0}°"},
    {"elevation_deg", "at elevations from {0}° to {1}°", "at the elevation {0}°"},
    {"incidence_deg", "where beams meet the surface {0}° to {1}° from its normal",
     "where beams meet the surface {0}° from its normal"},
    {"time_s", "from {0} to {1} s after the start of the frame", "{0} s after the start of the frame"},
    {"epw_m", "where the echo pulse width is {0} to {1} m", "where the echo pulse width is {0} m"},
}};

/// "3.2 to 4.1 mW", or one number where both are the same.
std::string intensitiesText(double low_nw, double high_nw) {
  const std::string low = withUnitOf(high_nw, low_nw, "nW"), high = withUnit(high_nw, "nW");
  return low == high ? high : intervalText({low_nw, high_nw}, "nW");
}

/// Their names; of many the first few.
std::string setupsText(const std::vector<std::string>& names) {
  constexpr std::size_t kFew = 6;
  if (names.size() <= kFew) return core::join(names);
  return fmt::format("{} and {} more", core::join(std::span(names).first(kFew)), names.size() - kFew);
}

}  // namespace

std::string confidenceInWords(double confidence) {
  if (confidence >= 0.95) return "very sure";
  if (confidence >= 0.8) return "quite sure";
  if (confidence >= kSure) return "fairly sure";
  if (confidence >= kLikely) return "not sure";
  return "hardly more than a guess";
}

std::string certaintyInWords(double p_value) {
  if (p_value < 1e-6) return "no, certainly";
  if (p_value < 1e-3) return "no";
  if (p_value < 0.05) return "hardly";
  return "possibly";
}

PartedRows partedByKind(const std::vector<WhereRow>& rows) {
  PartedRows parted;
  std::set<std::pair<std::string, std::string>> seen;
  const bool sure = std::any_of(rows.begin(), rows.end(), [](const WhereRow& row) { return !row.mayBeChance(); });
  for (const WhereRow& row : rows) {
    const bool shown = !(sure && row.mayBeChance()) && seen.emplace(row.measurand, row.component).second;
    (shown ? parted.first : parted.others).push_back(row);
  }
  return parted;
}

std::string stratumText(const WhereRow& row) {
  if (row.covariate == "intensity") return "where the intensity is " + intensitiesText(row.low, row.high);
  if (row.numeric) {
    const std::string low = core::significant(row.low), high = core::significant(row.high);
    for (const StratumWording& wording : kStrata) {
      if (row.covariate == wording.covariate)
        return fmt::format(fmt::runtime(low == high ? wording.point : wording.interval), low, high);
    }
    return low == high ? fmt::format("where the setting {} is {}", row.covariate, low)
                       : fmt::format("where the setting {} is {} to {}", row.covariate, low, high);
  }
  const std::string names = setupsText(row.names);
  if (row.covariate == "object") return fmt::format("on {}", names);
  if (row.covariate == "material") return fmt::format("on the material {}", names);
  if (row.covariate == "setup") return fmt::format("in the set-up{} {}", row.names.size() == 1 ? "" : "s", names);
  return fmt::format("where {} is {}", row.covariate, names);
}

std::optional<ContradictionWords> wordsFor(Contradiction contradiction) {
  switch (contradiction) {
    case Contradiction::kFramesMove:
      return ContradictionWords{
          "from frame to frame", "all detections of a frame deviate together", "but it does not act on whole frames",
          "Look for what moves, drifts or alternates between frames: a mirror with several facets, a warm-up, a "
          "vibration, frames of several set-ups in one file."};
    case Contradiction::kLossesUneven:
      return ContradictionWords{"in what is lost", "some beams lose many echoes and others none",
                                "but it takes as many echoes from every beam",
                                "Look for what loses echoes in some directions only: a mirror's facet or mount, the "
                                "window, a faulty channel, packets that are dropped."};
    case Contradiction::kFollowsDirection:
      return ContradictionWords{
          "with the direction of the beams", "a plain formula of their azimuth describes it",
          "but that formula describes it with fewer numbers",
          "Look at what the light passes in the sensor, and how that changes over the scan: the lens, the filter, the "
          "window, the mirror, the alignment of emitter and receiver."};
    case Contradiction::kOneStratum:
      return ContradictionWords{
          "in one place",
          "one part of the data (among those that are listed) deviates far beyond noise, the rest hardly",
          "but it is not what deviates there",
          "Look at what is special in that place; more frames of it would show more of the cause."};
    case Contradiction::kNone:
      break;
  }
  return std::nullopt;
}

namespace {

std::string findingSentence(const Diagnosis& diagnosis) {
  const Verdict& verdict = diagnosis.verdict;
  constexpr double kHardly = 0.005;  // would be said as 0 %
  const std::string shrink =
      diagnosis.shrink.fraction >= kHardly
          ? fmt::format("the gap on held-out samples shrinks by {}", percent(diagnosis.shrink.fraction))
          : std::string("single beams agree on held-out samples, though the pooled gap hardly shrinks");
  const std::string sure = fmt::format("(confidence {})", percent(verdict.confidence));
  std::string ties;
  if (!verdict.indistinguishable_from.empty()) {
    ties =
        fmt::format(" These data cannot tell {} from {}.", whatIsTied(verdict), listOf(verdict.indistinguishable_from));
  }
  const bool wrong_numbers = verdict.kind == VerdictKind::kParameter || verdict.kind == VerdictKind::kReference;
  if (wrong_numbers && verdict.names.size() > 1)
    return fmt::format("Both {} are wrong; corrected, {} {}.{}", listOf(verdict.names), shrink, sure, ties);
  switch (verdict.kind) {
    case VerdictKind::kNone:
      return (diagnosis.p_value >= kSignificance
                  ? "Measurement and simulation do not differ by more than their uncertainty "
                  : "Measurement and simulation differ by more than noise, but by too little to matter against the "
                    "sensor's resolution ") +
             sure + ".";
    case VerdictKind::kEffect:
      return fmt::format(
          "The model lacks {}; with {}{} {} {}.{}", namesOf(diagnosis), verdict.names.size() == 1 ? "it" : "them",
          verdict.beside.empty() ? "" : ", and " + listOf(verdict.beside) + " corrected,", shrink, sure, ties);
    case VerdictKind::kParameter:
      return fmt::format("The parameter {} has a wrong value; with the fitted one {} {}.{}", listOf(verdict.names),
                         shrink, sure, ties);
    case VerdictKind::kReference:
      return fmt::format("The reference quantity {} is off; corrected, {} {}.{}", listOf(verdict.names), shrink, sure,
                         ties);
    case VerdictKind::kUnknown:
      if (const auto words = wordsFor(verdict.contradiction))
        return fmt::format("They differ {} {}: {}, which no cause that was tried does.", words->in, sure, words->what);
      if (diagnosis.causes.empty()) return "They differ, and nothing in the library explains it " + sure + ".";
      if (diagnosis.causes.front().shrink.fraction <= 0.0) {
        return fmt::format(
            "They differ, and nothing in the library explains it {}; with the nearest, {}, the gap on "
            "held-out samples does not shrink.",
            sure, diagnosis.causes.front().name);
      }
      return fmt::format("They differ, and nothing in the library explains it {}; the nearest, {}, explains {}{}.",
                         sure, diagnosis.causes.front().name,
                         percent(std::max(0.0, diagnosis.causes.front().explained)),
                         verdict.nearest_pair ? fmt::format(", {} together {}", listOf(verdict.nearest_pair->names),
                                                            percent(verdict.nearest_pair->explained))
                                              : "");
  }
  return "";
}

}  // namespace

std::string verdictSentence(const Diagnosis& diagnosis) {
  const std::string finding = findingSentence(diagnosis);
  const auto& limits = diagnosis.verdict.limits;
  return limits.empty() ? finding : fmt::format("{} The data tell little: {}.", finding, fmt::join(limits, "; "));
}

namespace {

/// What was fitted together with the effects that are named.
std::string correctedToo(const Diagnosis& diagnosis) {
  const std::vector<std::string>& beside = diagnosis.verdict.beside;
  return beside.empty() ? "" : fmt::format(" Besides, the {} is wrong.", titlesOf(diagnosis, beside));
}

/// The listed cause of this name; null if there is none.
const Cause* causeOf(const Diagnosis& diagnosis, const std::string& name) {
  const auto cause = std::find_if(diagnosis.causes.begin(), diagnosis.causes.end(),
                                  [&](const Cause& listed) { return listed.name == name; });
  return cause == diagnosis.causes.end() ? nullptr : &*cause;
}

/// What a cause would mean, as a clause.
std::string clauseOf(const Diagnosis& diagnosis, const Cause& cause) {
  const std::string title = titlesOf(diagnosis, {cause.name});
  switch (cause.kind) {
    case CauseKind::kEffect:
      return fmt::format("an effect is missing in the simulation ({})", title);
    case CauseKind::kParameter:
      return fmt::format("a number is wrong in the simulation ({})", title);
    case CauseKind::kReference:
      return fmt::format("the reference data are wrong ({})", title);
  }
  return title;
}

/// Of a verdict that is one of two, which say different things of the model; else empty.
std::string eitherAnswer(const Diagnosis& diagnosis) {
  const Cause* const other = otherOfTwo(diagnosis);
  if (other == nullptr) return "";
  return fmt::format("Either {}, or {}: these data cannot tell which.",
                     clauseOf(diagnosis, *causeOf(diagnosis, diagnosis.verdict.names.front())),
                     clauseOf(diagnosis, *other));
}

std::string plainAnswer(const Diagnosis& diagnosis) {
  if (std::string either = eitherAnswer(diagnosis); !either.empty()) return either;
  const Verdict& verdict = diagnosis.verdict;
  const bool several = verdict.names.size() > 1;
  std::string causes = titlesOf(diagnosis, verdict.names);
  if (isOneOfTwo(verdict))
    causes +=
        fmt::format(" or {}, which these data cannot tell apart", titlesOf(diagnosis, verdict.indistinguishable_from));
  switch (diagnosis.verdict.kind) {
    case VerdictKind::kNone:
      return diagnosis.p_value >= kSignificance
                 ? "Measurement and simulation agree as far as these data can tell: there is no gap to explain."
                 : "Measurement and simulation agree to within what matters at the sensor's resolution: no gap "
                   "is to be explained.";
    case VerdictKind::kEffect:
      return fmt::format("The measurement shows {} that the simulation lacks: {}.{}", several ? "effects" : "an effect",
                         causes, correctedToo(diagnosis));
    case VerdictKind::kParameter:
      return fmt::format("No effect is missing, but {} in the simulation: {}.",
                         several ? "numbers are wrong" : "a number is wrong", causes);
    case VerdictKind::kReference:
      return fmt::format("The sensor model is not to blame: the reference data are wrong, namely the {}.", causes);
    case VerdictKind::kUnknown:
      if (const auto words = wordsFor(diagnosis.verdict.contradiction))
        return fmt::format("Measurement and simulation differ {}: {}, which none of the causes that were tried does.",
                           words->in, words->what);
      return "Measurement and simulation differ, and none of the causes that were tried explains it.";
  }
  return "";
}

}  // namespace

const char* whatIsTied(const Verdict& verdict) { return verdict.names.size() == 1 ? "it" : "one of them"; }

bool isOneOfTwo(const Verdict& verdict) {
  return verdict.names.size() == 1 && verdict.beside.empty() && verdict.indistinguishable_from.size() == 1;
}

const Cause* otherOfTwo(const Diagnosis& diagnosis) {
  const Verdict& verdict = diagnosis.verdict;
  if (!isOneOfTwo(verdict)) return nullptr;
  const Cause* const named = causeOf(diagnosis, verdict.names.front());
  const Cause* const other = causeOf(diagnosis, verdict.indistinguishable_from.front());
  return named != nullptr && other != nullptr && named->kind != other->kind ? other : nullptr;
}

std::string answerSentence(const Diagnosis& diagnosis) {
  const std::string answer = plainAnswer(diagnosis);
  const bool claims = diagnosis.verdict.kind != VerdictKind::kUnknown && diagnosis.verdict.kind != VerdictKind::kNone;
  if (!claims || diagnosis.verdict.confidence >= kSure) return answer;
  const bool likely = diagnosis.verdict.confidence >= kLikely;
  return (likely ? "Likely, but not sure: " : "Possibly, hardly more than a guess: ") + lowerFirst(answer);
}

std::string whereClause(const WhereRow& row) {
  const std::string size = withUnit(std::abs(row.value), row.unit), where = stratumText(row);
  if (row.component == "missing")
    return fmt::format("The measurement lacks {} that the simulation has, {}", size, where);
  if (row.component == "extra") return fmt::format("The measurement has {} that the simulation lacks, {}", size, where);
  const std::string title = measurandTitle(row.measurand);
  if (row.component == "scatter")
    return fmt::format("The simulated {} scatters {} too {} {}", title, size, row.value > 0 ? "little" : "much", where);
  const bool range = row.measurand == "range";
  const char* wrong = row.value > 0 ? (range ? "too short" : "too small") : (range ? "too long" : "too large");
  return fmt::format("The simulated {} is {} {} {}", title, size, wrong, where);
}

std::string whereSentence(const WhereRow& row) {
  return fmt::format("{}: {} of this gap, in {} of the data.", whereClause(row), percent(row.share), percent(row.size));
}

std::string asRunSentence(const Diagnosis& diagnosis) {
  constexpr double kMatters = 0.05;    // of the gap
  constexpr double kOfTheGrid = 0.25;  // of the gap as run: two draws of noise differ by a tenth of a small one
  if (!diagnosis.as_run) return "";
  const AsRun& as_run = *diagnosis.as_run;
  const std::string run = fmt::format(
      "Beams that meet the edge of an object, or a surface very obliquely, are traced more finely here than the model "
      "does with its {} × {} rays per beam. Run as it is, it shows a total gap of {}",
      as_run.rays_horizontal, as_run.rays_vertical, core::significant(as_run.before_total, 3));
  const auto& corrected = as_run.corrected;
  if (corrected && std::abs(corrected->shrink.fraction - diagnosis.shrink.fraction) >= kMatters)
    return fmt::format("{} and, corrected, {}: {}. More rays bring it nearer to what is said here.", run,
                       core::significant(corrected->after_total, 3),
                       corrected->shrink.fraction > 0.0 ? percent(corrected->shrink.fraction) + " less" : "no less");
  if (diagnosis.before.total < (1.0 - kOfTheGrid) * as_run.before_total)
    return fmt::format("{} in place of {}. More rays take that away.", run,
                       core::significant(diagnosis.before.total, 3));
  return "";
}

std::string atEndSentence(const Diagnosis& diagnosis) {
  std::vector<std::string> numbers;
  for (const Cause& cause : diagnosis.causes) {
    for (const FittedParameter& p : cause.parameters) {
      if (!p.at_end || !p.plausible || !diagnosis.verdict.holds(cause.name)) continue;
      numbers.push_back(fmt::format("{} ({}; searched from {})", parameterTitle(cause, p), withUnit(p.value, unitOf(p)),
                                    intervalText(*p.plausible, unitOf(p))));
    }
  }
  if (numbers.empty()) return "";
  return fmt::format(
      "At the end of what is plausible: {}. If the data ask for more than that, something else is at work.",
      core::join(numbers));
}

std::vector<std::string> recalibrationSentences(const Diagnosis& diagnosis, const std::vector<Rival>& numbers) {
  const std::vector<std::string>& named = diagnosis.verdict.names;
  std::vector<std::string> sentences;
  if (named.size() != 2) return sentences;
  for (const std::size_t effect : {0U, 1U}) {
    std::vector<std::string> instead;
    for (const Rival& number : numbers)
      if (number.instead_of == named[effect]) instead.push_back(causeTitle(diagnosis, number.name));
    if (instead.empty()) continue;
    sentences.push_back(fmt::format(
        "Instead of {} a number may be wrong: beside {}, another {} does as well, and these data cannot tell which it "
        "is. Check the number before you add the effect.",
        causeTitle(diagnosis, named[effect]), causeTitle(diagnosis, named[1 - effect]), fmt::join(instead, " or ")));
  }
  return sentences;
}

std::string frameModeSentence(const FrameMode& mode) {
  return fmt::format(
      "All detections of a frame deviate together, in {} by {:.3g} {} (standard deviation over the frames): the frames "
      "of a sample do not repeat each other. No cause that was tried does that; look for what moves, drifts or "
      "alternates between frames.",
      measurandTitle(nameOf(mode.channel)), mode.stddev, mode.channel == kIntensity ? "nW" : "m");
}

std::string unevenLossSentence(const UnevenLoss& loss) {
  return fmt::format(
      "Echoes are lost unevenly: {} of them on average, but the {} beams deviate from that by {} (standard deviation, "
      "beyond chance), and {} of the beams lose less than half as many{}. No cause that was tried does that; look for "
      "what loses echoes in some directions only.",
      percent(loss.mean), loss.beams, percent(loss.stddev), percent(loss.unhurt),
      loss.period_deg ? fmt::format("; that comes and goes about every {:.2g}° of azimuth", *loss.period_deg) : "");
}

std::string nextExperimentSentence(const NextExperiment& next) {
  std::vector<std::string> settings;
  for (const auto& [name, value] : next.parameters)
    settings.push_back(fmt::format("{} = {}", name, core::significant(value, 4)));
  return fmt::format("Repeat with {}{}: there {} and {} differ most compared to the noise{}.",
                     settings.empty() ? "the setting of sample " + next.sample : core::join(settings),
                     settings.empty() ? "" : " (as in sample " + next.sample + ")", next.separates[0],
                     next.separates[1], next.predictions.empty() ? ", though no single beam shows it" : "");
}

}  // namespace gap
