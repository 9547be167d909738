#include "acceptance/html_report.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "core/text.h"
#include "report/page.h"

namespace acceptance {

namespace {

using report::Align;
using report::Html;
using report::Page;
using report::Tone;
using specs::Verdict;

Html verdictBadge(Verdict verdict) {
  std::string word(specs::name(verdict));
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
  switch (verdict) {
    case Verdict::Passed:
      return report::badge(word, Tone::Good);
    case Verdict::Failed:
      return report::badge(word, Tone::Bad);
    case Verdict::Error:
      return report::badge(word, Tone::Warning);
    case Verdict::Skipped:
      break;
  }
  return report::badge(word, Tone::Neutral);
}

std::string anchorOf(const TestResult& test) { return "test-" + test.test.id; }

std::string number(double value) { return std::isnan(value) ? "not defined" : core::significant(value, 4); }

std::string percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

/// What part of the limit is used: the number that a reader compares between tests.
std::string usedShare(const Relation& relation) {
  const bool upper = relation.order == Order::LessOrEqual || relation.order == Order::Less;
  if (!upper || !(relation.limit > 0.0) || !(relation.value >= 0.0)) return "–";
  return percent(relation.value / relation.limit);
}

void addBanners(Page& page, const RunResult& run) {
  std::set<std::string> synthetic;
  for (const TestResult& test : run.tests) {
    if (test.synthetic) synthetic.insert(test.experiment_id);
  }
  if (synthetic.empty()) return;
  const std::vector<std::string> ids(synthetic.begin(), synthetic.end());
  page.banner("Synthetic data. A program made the \"measurement\" of " + core::join(ids) +
                  "; no sensor did. These verdicts say nothing about a real sensor.",
              Tone::Warning);
}

void addSummary(Page& page, const RunResult& run) {
  page.section("Verdicts", "verdicts");
  page.paragraph(fmt::format("{} passed, {} failed, {} could not be decided, {} not run.", run.count(Verdict::Passed),
                             run.count(Verdict::Failed), run.count(Verdict::Error), run.count(Verdict::Skipped)));
  std::vector<std::vector<Html>> rows;
  for (const TestResult& test : run.tests) {
    const SampleResult* worst = test.decisiveSample();
    const Relation* relation = worst && worst->decisive ? &*worst->decisive : nullptr;
    rows.push_back({report::link("#" + anchorOf(test), test.test.id), report::text(test.test.title),
                    verdictBadge(test.verdict), report::text(worst ? worst->id : "–"),
                    relation ? report::code(relation->left) : report::text("–"),
                    report::text(relation ? number(relation->value) : "–"),
                    report::text(relation ? std::string(symbol(relation->order)) + " " + number(relation->limit) : "–"),
                    report::text(relation ? usedShare(*relation) : "–")});
  }
  page.table({{"test"},
              {"title"},
              {"verdict"},
              {"decided at"},
              {"quantity"},
              {"value", Align::Right},
              {"limit", Align::Right},
              {"limit used", Align::Right}},
             rows);
}

void addFacts(Page& page, const TestResult& test) {
  std::vector<report::KeyValue> facts = {{"verdict", verdictBadge(test.verdict) + report::text(" " + test.text)}};
  for (const specs::Requirement& requirement : test.requirements) {
    facts.push_back({"requirement", report::strong(requirement.id) + report::text(" " + requirement.title)});
  }
  if (test.requirements.empty()) facts.push_back({"requirement", report::text("none is linked")});
  facts.push_back({"holds if", report::code(test.test.expression)});
  if (!test.test.text.empty()) facts.push_back({"in words", report::text(test.test.text)});
  if (!test.experiment_id.empty()) {
    const std::string title = test.experiment_title == test.experiment_id ? "" : " " + test.experiment_title;
    Html experiment = report::strong(test.experiment_id) + report::text(title);
    if (test.synthetic) experiment += report::text(" ") + report::badge("synthetic", Tone::Warning);
    facts.push_back({"experiment", experiment});
    facts.push_back({"source", report::text(test.experiment_source.empty() ? "not stated" : test.experiment_source)});
  }
  if (!test.model_id.empty()) {
    facts.push_back({"model", report::strong(test.model_id) + report::text(" ") + report::code(test.model_file) +
                                  report::text(fmt::format(", seed {}", test.seed))});
  }
  facts.push_back({"measurand", report::text(test.test.measurand + (test.unit.empty() ? "" : " in " + test.unit) +
                                             (test.test.gate.empty() ? "" : ", gate " + test.test.gate))});
  page.keyValues(facts);
}

/// Parameters that at least one sample of the test has: the columns of its table.
std::vector<std::string> parameterNames(const TestResult& test) {
  std::set<std::string> names;
  for (const SampleResult& sample : test.samples) {
    for (const auto& [name, value] : sample.parameters) names.insert(name);
  }
  return {names.begin(), names.end()};
}

std::string runSizes(const SampleResult& sample) {
  if (sample.n_sim.empty()) return "–";
  const auto [least, most] = std::minmax_element(sample.n_sim.begin(), sample.n_sim.end());
  const std::string size = *least == *most ? std::to_string(*least) : fmt::format("{}–{}", *least, *most);
  return sample.n_sim.size() == 1 ? size : fmt::format("{} × {}", sample.n_sim.size(), size);
}

void addSampleTable(Page& page, const TestResult& test) {
  const std::vector<std::string> parameters = parameterNames(test);
  std::vector<report::TableColumn> header = {{"sample"}};
  for (const std::string& name : parameters) header.push_back({name, Align::Right});
  for (const char* name : {"n measured", "n simulated"}) header.push_back({name, Align::Right});
  header.push_back({"quantity"});
  for (const char* name : {"value", "limit", "limit used"}) header.push_back({name, Align::Right});
  header.push_back({"verdict"});

  std::vector<std::vector<Html>> rows;
  for (const SampleResult& sample : test.samples) {
    std::vector<Html> start = {report::strong(sample.id)};
    for (const std::string& name : parameters) {
      const auto found = sample.parameters.find(name);
      start.push_back(report::text(found == sample.parameters.end() ? "–" : core::shortestNumber(found->second)));
    }
    start.push_back(report::text(std::to_string(sample.n_real)));
    start.push_back(report::text(runSizes(sample)));
    if (sample.relations.empty()) {
      for (int i = 0; i < 4; ++i) start.push_back(report::text("–"));
      start.push_back(verdictBadge(sample.verdict));
      rows.push_back(start);
    }
    for (const Relation& relation : sample.relations) {
      std::vector<Html> row = start;
      row.push_back(report::code(relation.left));
      row.push_back(report::text(number(relation.value)));
      row.push_back(report::text(std::string(symbol(relation.order)) + " " + number(relation.limit)));
      row.push_back(report::text(usedShare(relation)));
      const bool defined = !std::isnan(relation.value) && !std::isnan(relation.limit);
      row.push_back(verdictBadge(relation.holds ? Verdict::Passed : defined ? Verdict::Failed : sample.verdict));
      rows.push_back(row);
    }
  }
  page.table(header, rows);
}

void addValues(Page& page, const TestResult& test) {
  std::set<std::string> names;
  std::vector<report::TableColumn> header = {{"name"}};
  for (const SampleResult& sample : test.samples) {
    header.push_back({sample.id, Align::Right});
    for (const auto& [name, value] : sample.values) names.insert(name);
  }
  std::vector<std::vector<Html>> rows;
  for (const std::string& name : names) {
    std::vector<Html>& row = rows.emplace_back(std::vector<Html>{report::code(name)});
    for (const SampleResult& sample : test.samples) {
      const auto found = sample.values.find(name);
      row.push_back(report::text(found == sample.values.end() ? "–" : number(found->second)));
    }
  }
  page.beginDetails("All values" + (test.unit.empty() ? "" : " (distances of the distributions in " + test.unit + ")"));
  page.table(header, rows);
  page.endDetails();
}

void addUsedFiles(Page& page, const TestResult& test) {
  std::vector<std::vector<Html>> rows;
  for (const specs::UsedFile& file : test.used) rows.push_back({report::text(file.path), report::code(file.sha256)});
  page.beginDetails(fmt::format("{} files that this verdict rests on", test.used.size()));
  page.table({{"file, relative to the project"}, {"SHA-256"}}, rows);
  page.endDetails();
}

void addTest(Page& page, const TestResult& test) {
  page.section(test.test.id + (test.test.title.empty() ? "" : ": " + test.test.title), anchorOf(test));
  addFacts(page, test);
  if (test.samples.empty()) return;
  addSampleTable(page, test);
  for (const SampleResult& sample : test.samples) {
    if (!sample.figure.empty()) page.figure(sample.figure);
    if (sample.verdict != Verdict::Passed) page.paragraph(report::strong(sample.id) + report::text(": " + sample.text));
    for (const std::string& remark : sample.remarks) {
      page.paragraph(report::badge("remark", Tone::Warning) + report::text(" " + sample.id + ": " + remark + "."));
    }
  }
  addValues(page, test);
  addUsedFiles(page, test);
}

void addReadingHelp(Page& page) {
  page.section("How to read this", "reading");
  page.paragraph(
      "Each sample of the experiment is simulated again at its nominal values and at every corner of what is only "
      "known "
      "to within an interval. The runs open a p-box: the band between the two blue edges. Where the measured curve "
      "lies "
      "outside the band, the area between them is d+ (simulated values too small) or d− (too large), in the unit of "
      "the "
      "measurand.");
  page.paragraph(
      "d_bias = d− − d+ says how far off the simulation is: positive means too high. d_CAVM is the area that remains "
      "once "
      "the simulation is moved by −d_bias: how differently it scatters. \"Limit used\" is the value as a share of its "
      "limit. Below the curves: median, quartiles, whiskers to 1.5 interquartile ranges, and the mean as a diamond; of "
      "a "
      "p-box the outer quartiles, with median and mean as intervals.");
}

}  // namespace

std::string htmlReport(const RunResult& run) {
  Page page("Acceptance report: " + run.project,
            fmt::format("{} acceptance test{}", run.tests.size(), run.tests.size() == 1 ? "" : "s"));
  addBanners(page, run);
  addSummary(page, run);
  for (const TestResult& test : run.tests) addTest(page, test);
  addReadingHelp(page);
  return page.html();
}

}  // namespace acceptance
