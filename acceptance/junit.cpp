#include "acceptance/junit.h"

#include <fmt/format.h>

#include "core/text.h"

namespace acceptance {

namespace {

using specs::Verdict;

/// Escaped for XML 1.0, which cannot hold control characters.
std::string escaped(std::string_view text) {
  std::string clean(text);
  for (char& c : clean) {
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') c = '?';
  }
  return core::escapeMarkup(clean);
}

std::string property(std::string_view name, std::string_view value) {
  return fmt::format("        <property name=\"{}\" value=\"{}\"/>\n", name, escaped(value));
}

std::string outcome(Verdict verdict, const std::string& text) {
  switch (verdict) {
    case Verdict::Failed:
      return fmt::format("      <failure type=\"acceptance\" message=\"{0}\">{0}</failure>\n", escaped(text));
    case Verdict::Error:
      return fmt::format("      <error type=\"input\" message=\"{0}\">{0}</error>\n", escaped(text));
    case Verdict::Skipped:
      return fmt::format("      <skipped message=\"{}\"/>\n", escaped(text));
    case Verdict::Passed:
      break;
  }
  return {};
}

std::string requirementIds(const TestResult& test) {
  std::vector<std::string> ids;
  for (const specs::Requirement& requirement : test.requirements) ids.push_back(requirement.id);
  return core::join(ids);
}

std::string properties(const TestResult& test, const SampleResult* sample) {
  std::string text = "      <properties>\n" + property("requirement", requirementIds(test));
  text += property("expression", test.test.expression);
  if (sample && sample->decisive) {
    text += property("value", core::shortestNumber(sample->decisive->value));
    text += property("limit", core::shortestNumber(sample->decisive->limit));
    text += property("margin", core::shortestNumber(sample->decisive->margin()));
    text += property("unit", test.unit);
  }
  return text + "      </properties>\n";
}

struct Case {
  std::string name;
  Verdict verdict;
  std::string text;
  const SampleResult* sample;
};

std::vector<Case> casesOf(const TestResult& test) {
  if (test.samples.empty()) return {{"evaluation", test.verdict, test.text, nullptr}};
  std::vector<Case> cases;
  for (const SampleResult& sample : test.samples) cases.push_back({sample.id, sample.verdict, sample.text, &sample});
  return cases;
}

struct Counts {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t skipped = 0;

  void add(const Case& one) {
    ++tests;
    failures += one.verdict == Verdict::Failed ? 1 : 0;
    errors += one.verdict == Verdict::Error ? 1 : 0;
    skipped += one.verdict == Verdict::Skipped ? 1 : 0;
  }
  [[nodiscard]] std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"", tests, failures, errors, skipped);
  }
};

std::string caseXml(const RunResult& run, const TestResult& test, const Case& one, const std::string& attachment) {
  // GitLab takes only the first of several cases of one name, so the name holds the test's id too.
  std::string xml = fmt::format("    <testcase classname=\"{}\" name=\"{}\">\n",
                                escaped(run.project + "." + test.test.id), escaped(test.test.id + ", " + one.name));
  xml += properties(test, one.sample) + outcome(one.verdict, one.text);
  std::string output = one.text;
  if (!attachment.empty()) output += "\n[[ATTACHMENT|" + attachment + "]]";
  xml += "      <system-out>" + escaped(output) + "</system-out>\n";
  return xml + "    </testcase>\n";
}

}  // namespace

std::string junitXml(const RunResult& run, const std::string& attachment) {
  Counts all;
  std::string suites;
  for (const TestResult& test : run.tests) {
    Counts counts;
    std::string cases;
    for (const Case& one : casesOf(test)) {
      counts.add(one);
      all.add(one);
      cases += caseXml(run, test, one, attachment);
    }
    const std::string title = test.test.title.empty() ? test.test.id : test.test.id + ": " + test.test.title;
    suites +=
        fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n", escaped(title), counts.attributes(), cases);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"acceptance of {}\" {}>\n{}</testsuites>\n",
      escaped(run.project), all.attributes(), suites);
}

}  // namespace acceptance
