#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <ostream>

#include "acceptance/html_report.h"
#include "acceptance/junit.h"
#include "acceptance/result_json.h"
#include "acceptance/run.h"
#include "app/cli/commands.h"
#include "app/cli/session.h"
#include "app/cli/signature.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace app {

namespace {

using specs::Verdict;

struct Options {
  std::string project;
  std::vector<std::string> tests;
  std::string model;
  std::string junit;
  std::string json;
  std::string html;
};

/// One line a test: verdict, id, and the numbers that decided.
std::string line(const acceptance::TestResult& test) {
  std::string word(specs::name(test.verdict));
  for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return fmt::format("{:<7}  {}  {}\n", word, test.test.id, test.text);
}

/// What cannot be written must be known before minutes are spent.
void checkFolder(const std::string& file) {
  if (file.empty() || file == "-") return;
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw core::InputError({.file = file}, "cannot be written: its folder does not exist.", "Create the folder first.");
  }
}

int exitStatus(const acceptance::RunResult& run) {
  if (run.count(Verdict::Error) > 0) return kBadInput;
  if (run.count(Verdict::Failed) > 0) return kNotAccepted;
  return run.count(Verdict::Passed) > 0 ? kAllGood : kBadInput;  // nothing decided is not a success
}

void accept(const Options& options, Session& session) {
  for (const std::string& file : {options.junit, options.json, options.html}) checkFolder(file);
  specs::ProjectStore store = specs::ProjectStore::open(options.project);
  acceptance::RunOptions run_options = {.tests = options.tests, .model = {}, .seed = session.seed};
  if (!options.model.empty()) run_options.model = options.model;
  const std::string started_at = signatureOf("").when;
  const acceptance::RunResult run = acceptance::runTests(store, run_options, session.progress);

  if (!options.html.empty()) core::writeFile(options.html, acceptance::htmlReport(run));
  if (!options.junit.empty()) core::writeFile(options.junit, acceptance::junitXml(run, options.html));
  const std::string id = acceptance::storeRun(store, run, {.started_at = started_at, .report = options.html});
  session.progress.report(1.0, "stored as " + id);

  std::ostream& lines = options.json == "-" ? session.messages : session.out;
  for (const acceptance::TestResult& test : run.tests) lines << line(test);
  lines.flush();
  for (const acceptance::TestResult& test : run.tests) {
    for (const acceptance::SampleResult& sample : test.samples) {
      for (const std::string& remark : sample.remarks) {
        if (!session.quiet) session.messages << fmt::format("{}, {}: {}.\n", test.test.id, sample.id, remark);
      }
    }
  }
  if (!options.json.empty()) session.writeJsonTo(options.json, acceptance::toJson(run));
  session.status = exitStatus(run);
  if (session.status == kBadInput && run.count(Verdict::Error) == 0) {
    session.messages << "fidelis: no test was run, so nothing is accepted.\n";
  }
}

std::string footer() {
  std::string text =
      "Each test re-simulates its experiment, compares it with the measurement, and decides by its expression.\n"
      "Verdicts, values and the SHA-256 of every file used are stored in the project.\n"
      "Exit status: 0 all that ran passed; 1 a test failed; 2 a test could not be decided, or nothing was run.\n\n"
      "Examples:\n"
      "  fidelis accept demo.fidelis --html report.html\n"
      "  fidelis accept demo.fidelis --test RangeError_Offset_1 --junit acceptance.xml\n"
      "  fidelis accept demo.fidelis --model improved-model.json --json -\n\n"
      "Expressions: relations with <=, <, >=, >, joined by &&, over the parameters of a sample and:\n";
  for (const acceptance::Variable& variable : acceptance::expressionVariables()) {
    text += fmt::format("  {:<22} {}\n", variable.name, variable.meaning);
  }
  return text;
}

}  // namespace

void addAcceptCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("accept", "Run the acceptance tests of a project and store their verdicts");
  command->add_option("project", options->project, "Project file")->required();
  command->add_option("--test", options->tests, "Ids of the tests to run; without it all that are not rejected");
  command->add_option("--model", options->model, "Model file to be judged in place of the one each test names");
  command->add_option("--junit", options->junit, "Write JUnit XML to this file");
  command->add_option("--json", options->json, "Write the result as JSON to this file; - for standard output");
  command->add_option("--html", options->html, "Write a self-contained report to this file");
  command->footer(footer());
  command->callback([options, &session] { accept(*options, session); });
}

}  // namespace app
