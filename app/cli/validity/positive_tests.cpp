#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/metric/request.h"
#include "app/cli/validity/output.h"
#include "app/cli/validity/read.h"
#include "app/cli/validity/validity.h"
#include "core/error.h"
#include "core/text.h"
#include "metrics/samples/kolmogorov_smirnov.h"
#include "metrics/samples/positive_ks_tests.h"

namespace app {

using nlohmann::ordered_json;

namespace {

constexpr Method kMethod{
    .kind = "ks",
    .title = "Frequency of positive Kolmogorov-Smirnov tests over groups (number 33)",
    .source = "Rosenberger 2022, Tab. 4-3, number 33; p-values: Stephens 1970, doi:10.1111/j.2517-6161.1970.tb00821.x"};

struct Request {
  std::string real;
  std::string simulated;
  std::vector<std::string> by;
  std::vector<std::string> columns;
  double alpha = 0.05;
  std::string json;

  [[nodiscard]] std::string byText() const { return core::join(by); }
};

/// One group's test.
struct GroupTest {
  std::string name;
  std::size_t n_real;
  std::size_t n_sim;
  metrics::KolmogorovSmirnov test;
};

/// One column over all groups.
struct Frequency {
  std::string column;
  metrics::PositiveKsTests tests;
  std::vector<GroupTest> counted;
  std::vector<std::string> too_small;
};

bool isLargeEnough(const metrics::Edf& sample) { return static_cast<double>(sample.n()) >= metrics::kSmallestKsSample; }

/// The samples of the groups that both files have, and what each test says.
Frequency frequencyOf(const KeyedRows& real, const KeyedRows& simulated, const std::vector<GroupPair>& groups,
                      std::size_t column, const Request& request) {
  Frequency result{.column = request.columns[column], .tests = {}, .counted = {}, .too_small = {}};
  std::vector<metrics::Edf> samples;  // measured and simulated in turn; not moved again, pairs refer to them
  samples.reserve(2 * groups.size());
  std::vector<metrics::SamplePair> pairs;
  for (const GroupPair& group : groups) {
    if (group.real.empty() || group.simulated.empty()) continue;
    const metrics::Edf& measured = samples.emplace_back(numbersOf(real, column, group.real));
    const metrics::Edf& model = samples.emplace_back(numbersOf(simulated, column, group.simulated));
    pairs.push_back({.simulated = model, .measured = measured});
    if (isLargeEnough(measured) && isLargeEnough(model)) {
      result.counted.push_back({group.name, measured.n(), model.n(), metrics::kolmogorovSmirnovTest(pairs.back())});
    } else {
      result.too_small.push_back(group.name);
    }
  }
  result.tests = metrics::positiveKsTests(pairs, request.alpha);
  return result;
}

std::vector<std::string> onlyIn(const std::vector<GroupPair>& groups, std::vector<std::size_t> GroupPair::*missing) {
  std::vector<std::string> names;
  for (const GroupPair& group : groups) {
    if ((group.*missing).empty()) names.push_back(group.name);
  }
  return names;
}

/// Nothing decided is no success.
void mustDecideSomething(const Frequency& frequency, const std::vector<GroupPair>& groups, const Request& request) {
  if (frequency.tests.counted > 0) return;
  const bool any_pair = !frequency.too_small.empty();
  throw core::InputError({.item = "--by " + core::join(request.by, ",")},
                         any_pair ? fmt::format("gives no group with {:g} values on both sides; nothing can be tested.",
                                                metrics::kSmallestKsSample)
                                  : fmt::format("finds none of the {} groups in both files; the first is '{}'.",
                                                groups.size(), groups.front().name),
                         any_pair ? "Group by what holds more values: a sample instead of a frame."
                                  : "Write the groups alike in both files.");
}

/// "3 (a, b, c)", with the first few names.
std::string some(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 5;
  const std::vector<std::string> shown(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, names.size())));
  return fmt::format("{} ({}{})", names.size(), core::join(shown), names.size() > kShown ? ", …" : "");
}

void writeTests(const Frequency& frequency, const Request& request, std::ostream& out) {
  constexpr std::size_t kShown = 20;
  std::vector<GroupTest> tests = frequency.counted;
  if (tests.size() > kShown) {
    std::stable_sort(tests.begin(), tests.end(),
                     [](const GroupTest& a, const GroupTest& b) { return a.test.p_value < b.test.p_value; });
    tests.erase(tests.begin() + kShown, tests.end());
    out << fmt::format("  the {} groups that differ most (--json has all {}):\n", kShown, frequency.counted.size());
  }
  std::vector<std::vector<std::string>> table{{request.byText(), "n measured", "n simulated", "D", "p", "verdict"}};
  for (const GroupTest& group : tests) {
    table.push_back({group.name, std::to_string(group.n_real), std::to_string(group.n_sim),
                     core::significant(group.test.statistic, 4), core::significant(group.test.p_value, 3),
                     group.test.p_value <= request.alpha ? "differs" : "-"});
  }
  writeTable(table, out);
}

void writeFrequency(const Frequency& frequency, const Request& request, const std::vector<GroupPair>& groups,
                    std::ostream& out) {
  const metrics::PositiveKsTests& tests = frequency.tests;
  out << fmt::format("{}: frequency of positive Kolmogorov-Smirnov tests {}\n", frequency.column,
                     core::significant(tests.frequency, 4));
  out << fmt::format("  in {} of {} groups (by {}) measurement and simulation differ at alpha = {:g}; {:g} is chance\n",
                     tests.rejected, tests.counted, request.byText(), request.alpha, request.alpha);
  if (!frequency.too_small.empty()) {
    out << fmt::format("  left out, fewer than {:g} values on a side: {}\n", metrics::kSmallestKsSample,
                       some(frequency.too_small));
  }
  const auto only_real = onlyIn(groups, &GroupPair::simulated);
  const auto only_simulated = onlyIn(groups, &GroupPair::real);
  if (!only_real.empty()) out << "  left out, only measured: " << some(only_real) << "\n";
  if (!only_simulated.empty()) out << "  left out, only simulated: " << some(only_simulated) << "\n";
  if (tests.heavy_ties > 0) {
    out << fmt::format("  in {} groups many values are equal (a coarse counter): their p is too large\n",
                       tests.heavy_ties);
  }
  out << "\n";
  writeTests(frequency, request, out);
}

ordered_json jsonOf(const Frequency& frequency, const Request& request) {
  ordered_json entry{{"name", frequency.column},
                     {"unit", unitOfName(frequency.column)},
                     {"frequency", frequency.tests.frequency},
                     {"rejected", frequency.tests.rejected},
                     {"counted", frequency.tests.counted},
                     {"heavy_ties", frequency.tests.heavy_ties},
                     {"too_small", frequency.too_small}};
  for (const GroupTest& group : frequency.counted) {
    entry["groups"].push_back({{"name", group.name},
                               {"n_real", group.n_real},
                               {"n_sim", group.n_sim},
                               {"statistic", group.test.statistic},
                               {"p_value", group.test.p_value},
                               {"rejected", group.test.p_value <= request.alpha}});
  }
  return entry;
}

ordered_json documentOf(const std::vector<Frequency>& frequencies, const Request& request,
                        const std::vector<GroupPair>& groups) {
  ordered_json document = validityDocument(kMethod);
  document["real"] = request.real;
  document["simulated"] = request.simulated;
  document["options"] = {{"by", request.by}, {"alpha", request.alpha}, {"smallest_sample", metrics::kSmallestKsSample}};
  document["only_real"] = onlyIn(groups, &GroupPair::simulated);
  document["only_simulated"] = onlyIn(groups, &GroupPair::real);
  for (const Frequency& frequency : frequencies) document["measurands"].push_back(jsonOf(frequency, request));
  return document;
}

/// Several --by make one key: "10 m dry, 3".
KeyedRows readWithJoinedKeys(const std::string& file, const Request& request) {
  KeyedRows rows = readKeyedRows(file, request.by, request.columns);
  for (std::size_t k = 1; k < rows.keys.size(); ++k) {
    for (std::size_t row = 0; row < rows.size(); ++row) rows.keys[0][row] += ", " + rows.keys[k][row];
  }
  return rows;
}

void runPositiveTests(const Request& request, const Session& session) {
  mustBeDistinctColumns(request.columns);
  const KeyedRows real = readWithJoinedKeys(request.real, request);
  const KeyedRows simulated = readWithJoinedKeys(request.simulated, request);
  const std::vector<GroupPair> groups = pairedGroups(real, simulated);
  std::vector<Frequency> frequencies;
  for (std::size_t k = 0; k < request.columns.size(); ++k) {
    core::stopIfCancelled(session.progress);
    frequencies.push_back(frequencyOf(real, simulated, groups, k, request));
    mustDecideSomething(frequencies.back(), groups, request);
  }
  if (!request.json.empty()) {
    session.writeJsonTo(request.json, documentOf(frequencies, request, groups));
    return;
  }
  for (const Frequency& frequency : frequencies) {
    if (&frequency != &frequencies.front()) session.out << "\n";
    writeFrequency(frequency, request, groups, session.out);
  }
}

const char* const kFooter =
    "A test is positive if its p-value is at most alpha: it tells measurement and simulation of the group apart. 0 is\n"
    "best, 1 worst, no unit; a perfect model still reaches alpha by chance. The more values a group has, the smaller\n"
    "the difference that is found. Groups with fewer than 12 values on a side are left out and counted. It takes "
    "values\n"
    "as independent; detections of one frame seldom are. Where frames are numbered anew in every sample, group by\n"
    "sample,frame: frame 0 of all samples is no group.\n\n"
    "Examples:\n"
    "  fidelis validity ks real.csv sim.csv --by sample,frame --column range_m\n"
    "  fidelis validity ks real.csv sim.csv --by sample --column range_m --column epw_m --alpha 0.01 --json ks.json";

}  // namespace

void addPositiveTests(CLI::App& validity, Session& session) {
  auto request = std::make_shared<Request>();
  CLI::App* command = validity.add_subcommand(
      "ks", "In how many groups (samples, frames, objects) a Kolmogorov-Smirnov test tells the two apart");
  command->add_option("REAL", request->real, "What was measured: a CSV file; gzip is understood")->required();
  command->add_option("SIM", request->simulated, "What was simulated, with the same columns")->required();
  command->add_option("--by", request->by, "Column that names the group of each row: sample, gate; or several: a,b")
      ->required()
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--column", request->columns, "Measurand, by its name in the header; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--alpha", request->alpha, "Level of significance of each test")->capture_default_str();
  command->add_option("--json", request->json, "Write the result as JSON to this file (-: standard output)");
  command->footer(kFooter);
  command->callback([request, &session] { runPositiveTests(*request, session); });
}

}  // namespace app
