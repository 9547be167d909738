#include "acceptance/run.h"

#include <algorithm>

#include "acceptance/result_json.h"
#include "core/error.h"
#include "core/text.h"
#include "core/version.h"
#include "model/external/external_runs.h"

namespace acceptance {

namespace {

std::vector<specs::AcceptanceTest> chosenTests(const specs::ProjectStore& store, const RunOptions& options) {
  const std::vector<specs::AcceptanceTest> all = store.all<specs::AcceptanceTest>();
  if (all.empty()) {
    throw core::InputError({.file = store.file()}, "has no acceptance tests.",
                           "Add one to the specification ('fidelis spec import', or in fidelis-desktop).");
  }
  if (options.tests.empty()) return all;
  std::vector<std::string> known;
  for (const specs::AcceptanceTest& test : all) known.push_back(test.id);
  for (const std::string& id : options.tests) {
    if (std::find(known.begin(), known.end(), id) != known.end()) continue;
    const std::string nearest = core::nearestName(id, known);
    throw core::InputError(
        {.file = store.file()}, "has no acceptance test '" + id + "'.",
        nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
  }
  std::vector<specs::AcceptanceTest> chosen;
  for (const specs::AcceptanceTest& test : all) {
    if (std::count(options.tests.begin(), options.tests.end(), test.id) > 0) chosen.push_back(test);
  }
  return chosen;
}

std::vector<specs::Requirement> requirementsOf(const specs::ProjectStore& store, const std::string& test) {
  std::vector<specs::Requirement> requirements;
  for (const specs::ItemReference& origin : store.originsOf(test)) {
    if (origin.kind != specs::Kind::Requirement) continue;
    if (auto requirement = store.find<specs::Requirement>(origin.id)) requirements.push_back(*requirement);
  }
  return requirements;
}

/// Relative to the project file if it lies beside or below it.
std::string reportPath(const std::filesystem::path& report, const std::filesystem::path& folder) {
  if (report.empty()) return {};
  const auto whole = std::filesystem::weakly_canonical(std::filesystem::absolute(report));
  const auto relative = whole.lexically_relative(std::filesystem::weakly_canonical(std::filesystem::absolute(folder)));
  return relative.empty() || relative.begin()->string() == ".." ? whole.generic_string() : relative.generic_string();
}

/// The specification names the test's own model beside its last result; another model must not pass in its name.
std::string judgedModel(const TestResult& result) {
  const std::string own = std::filesystem::path(result.test.model).lexically_normal().generic_string();
  return result.model_file.empty() || result.model_file == own ? "" : " (judged with " + result.model_file + ")";
}

specs::TestVerdict toVerdict(const TestResult& result) {
  specs::TestVerdict verdict;
  verdict.test = result.test.id;
  verdict.verdict = result.verdict;
  verdict.text = result.text + judgedModel(result);
  verdict.used = result.used;
  verdict.evaluation = toJson(result, Figures::Included).dump();
  for (const SampleResult& sample : result.samples) {
    specs::SampleVerdict& entry = verdict.samples.emplace_back();
    entry.sample = sample.id;
    entry.verdict = sample.verdict;
    entry.values = sample.values;
    entry.values.insert(sample.parameters.begin(), sample.parameters.end());
    entry.text = sample.text;
    if (sample.decisive) {
      entry.value = sample.decisive->value;
      entry.limit = sample.decisive->limit;
    }
  }
  return verdict;
}

}  // namespace

RunResult runTests(const specs::ProjectStore& store, const RunOptions& options, core::Progress& progress) {
  RunResult result = {.project = store.file().stem().string(), .program_version = core::kVersion, .tests = {}};
  const std::vector<specs::AcceptanceTest> tests = chosenTests(store, options);
  const auto external = std::make_shared<model::ExternalRuns>();
  const auto share = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(tests.size()); };
  for (std::size_t i = 0; i < tests.size(); ++i) {
    core::stopIfCancelled(progress);
    const TestTask task = {.test = tests[i],
                           .requirements = requirementsOf(store, tests[i].id),
                           .folder = store.folder(),
                           .model = options.model,
                           .seed = options.seed,
                           .external = external};
    if (tests[i].status == specs::Status::Rejected && options.tests.empty()) {
      TestResult& skipped = result.tests.emplace_back();
      skipped.test = task.test;
      skipped.requirements = task.requirements;
      skipped.text = "is rejected; name it with --test to run it all the same";
      continue;
    }
    core::PartOfProgress part(progress, share(i), share(i + 1));
    result.tests.push_back(evaluate(task, part));
  }
  core::stopIfCancelled(progress);
  return result;
}

std::string storeRun(specs::ProjectStore& store, const RunResult& result, const RunRecord& record) {
  specs::TestRun run;
  run.started_at = record.started_at;
  run.program_version = result.program_version;
  for (const TestResult& test : result.tests) {
    run.verdicts.push_back(toVerdict(test));
    run.verdicts.back().report = reportPath(record.report, store.folder());
  }
  return store.storeRun(run);
}

}  // namespace acceptance
