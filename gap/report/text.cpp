#include "gap/report/text.h"

#include <algorithm>
#include <ostream>
#include <sstream>
#include <vector>

#include "core/text.h"
#include "gap/report/rest_wording.h"
#include "gap/report/wording.h"

namespace gap {

namespace {

bool isIn(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const char* roleOf(const Verdict& verdict, const std::string& cause) {
  if (verdict.isNamed(cause)) return "cause";
  if (verdict.isBeside(cause)) return "beside it";
  if (isIn(verdict.indistinguishable_from, cause)) return "or instead";
  return "also weighed";
}

/// The other one of two causes that explain the gap together; empty if this is none of two.
std::string otherOf(const Verdict& verdict, const std::string& cause) {
  std::vector<std::string> members = verdict.names;
  members.insert(members.end(), verdict.beside.begin(), verdict.beside.end());
  if (members.size() != 2 || !isIn(members, cause)) return "";
  return members[0] == cause ? members[1] : members[0];
}

void addCause(const Diagnosis& diagnosis, const Cause& cause, std::ostream& out) {
  const std::string other = otherOf(diagnosis.verdict, cause.name);
  out << "  " << roleOf(diagnosis.verdict, cause.name) << ": " << toString(cause.kind) << " " << cause.name
      << ", explains " << (other.empty() ? "" : "with " + other + " ") << core::significant(100.0 * cause.explained, 3)
      << " % of the held-out discrepancy";
  for (const FittedParameter& p : cause.parameters) {
    out << "; " << p.name << " = " << core::significant(p.value, 4);
    if (p.interval)
      out << " [" << core::significant(p.interval->low, 4) << ", " << core::significant(p.interval->high, 4) << "]";
    if (!p.unit.empty()) out << " " << p.unit;
  }
  out << "\n";
}

void addFlips(const std::vector<TwiceJudgedTest>& tests, std::ostream& out) {
  const auto flips = std::count_if(tests.begin(), tests.end(), [](const auto& test) { return test.flips(); });
  out << "  acceptance: with the proposed model " << flips << " of " << tests.size()
      << " tests of this experiment change their verdict\n";
  for (const TwiceJudgedTest& test : tests) {
    if (test.flips()) out << "    " << test.id << ": " << test.before << " -> " << test.after << "\n";
  }
}

}  // namespace

std::string reportText(const Diagnosis& diagnosis) {
  constexpr std::size_t kPlaces = 3;
  std::ostringstream out;
  out << diagnosis.verdict.text << "\n";
  if (diagnosis.present) {
    const std::vector<WhereRow> places = partedByKind(diagnosis.where).first;
    for (std::size_t i = 0; i < std::min(kPlaces, places.size()); ++i)
      out << "  where: " << whereSentence(places[i]) << "\n";
  }
  if (const Law* pattern = patternIn(diagnosis.verdict, diagnosis.rest))
    out << "  pattern: " << patternText(*pattern) << "\n";
  for (const Cause& cause : diagnosis.causes) addCause(diagnosis, cause, out);
  if (diagnosis.approximation) out << "  note: " << diagnosis.approximation->text << "\n";
  for (const std::string& note : diagnosis.notes) out << "  note: " << note << "\n";
  if (diagnosis.acceptance_tests) addFlips(*diagnosis.acceptance_tests, out);
  if (diagnosis.next_experiment) out << "  next: " << diagnosis.next_experiment->text << "\n";
  return out.str();
}

}  // namespace gap
