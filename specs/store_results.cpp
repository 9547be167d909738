// What the acceptance runs found, in a project file.

#include <cmath>
#include <limits>

#include "specs/connection.h"

namespace specs {

namespace {

Verdict storedVerdict(const Record& record, int column) {
  return verdictOf(record.text(column)).value_or(Verdict::Error);  // the table admits no other word
}

/// SQLite has no NaN; it would become NULL, which is read as NaN again.
Value numberOrNull(double value) { return std::isnan(value) ? Value(nullptr) : Value(value); }

void storeSample(ProjectStore::Connection& connection, std::int64_t verdict, const SampleVerdict& sample) {
  connection.run("INSERT INTO verdict_sample (of, sample, verdict, value, bound, text) VALUES (?, ?, ?, ?, ?, ?)",
                 {verdict, sample.sample, std::string(name(sample.verdict)), orNull(sample.value), orNull(sample.limit),
                  sample.text});
  const std::int64_t number = connection.lastRowId();
  for (const auto& [key, value] : sample.values) {
    connection.run("INSERT INTO verdict_value VALUES (?, ?, ?)", {number, key, numberOrNull(value)});
  }
}

void storeVerdict(ProjectStore::Connection& connection, std::int64_t run, const TestVerdict& verdict) {
  const auto test = connection.uidOf(verdict.test);
  connection.run(
      "INSERT INTO verdict (run, test_uid, test_id, verdict, text, evaluation, report) VALUES (?, ?, ?, ?, ?, ?, ?)",
      {run, test ? Value(*test) : Value(nullptr), verdict.test, std::string(name(verdict.verdict)), verdict.text,
       verdict.evaluation, verdict.report});
  const std::int64_t number = connection.lastRowId();
  for (const SampleVerdict& sample : verdict.samples) storeSample(connection, number, sample);
  for (std::size_t i = 0; i < verdict.used.size(); ++i) {
    connection.run("INSERT INTO verdict_file VALUES (?, ?, ?, ?)",
                   {number, static_cast<std::int64_t>(i), verdict.used[i].path, verdict.used[i].sha256});
  }
}

std::vector<SampleVerdict> loadSamples(const ProjectStore::Connection& connection, std::int64_t verdict) {
  std::vector<SampleVerdict> samples;
  connection.each("SELECT number, sample, verdict, value, bound, text FROM verdict_sample WHERE of = ? ORDER BY number",
                  {verdict}, [&](const Record& record) {
                    SampleVerdict& sample = samples.emplace_back();
                    sample.sample = record.text(1);
                    sample.verdict = storedVerdict(record, 2);
                    sample.value = record.optionalNumber(3);
                    sample.limit = record.optionalNumber(4);
                    sample.text = record.text(5);
                    connection.each("SELECT name, value FROM verdict_value WHERE sample = ?", {record.integer(0)},
                                    [&](const Record& value) {
                                      sample.values[value.text(0)] =
                                          value.optionalNumber(1).value_or(std::numeric_limits<double>::quiet_NaN());
                                    });
                  });
  return samples;
}

/// `condition` selects from verdict; the test's present id stands for the one that it had then.
std::vector<TestVerdict> loadVerdicts(const ProjectStore::Connection& connection, const std::string& condition,
                                      const std::vector<Value>& values, bool with_evaluation) {
  std::vector<TestVerdict> verdicts;
  const std::string evaluation = with_evaluation ? "evaluation" : "''";
  connection.each("SELECT v.number, coalesce(item.id, v.test_id), v.verdict, v.text, v.report, " + evaluation +
                      " FROM verdict v LEFT JOIN item ON item.uid = v.test_uid WHERE " + condition +
                      " ORDER BY v.number",
                  values, [&](const Record& record) {
                    TestVerdict& verdict = verdicts.emplace_back();
                    verdict.test = record.text(1);
                    verdict.verdict = storedVerdict(record, 2);
                    verdict.text = record.text(3);
                    verdict.report = record.text(4);
                    verdict.evaluation = record.text(5);
                    verdict.samples = loadSamples(connection, record.integer(0));
                    connection.each("SELECT path, sha256 FROM verdict_file WHERE of = ? ORDER BY position",
                                    {record.integer(0)}, [&](const Record& used) {
                                      verdict.used.push_back({used.text(0), used.text(1)});
                                    });
                  });
  return verdicts;
}

}  // namespace

std::string ProjectStore::storeRun(const TestRun& run) {
  std::string id = run.id;
  connection_->action([&] {
    if (id.empty()) {
      const auto last = connection_->integer("SELECT coalesce(max(number), 0) FROM test_run", {});
      for (std::int64_t number = last.value() + 1; id.empty(); ++number) {
        const std::string proposal = "run-" + std::to_string(number);
        if (!connection_->integer("SELECT 1 FROM test_run WHERE id = ?", {proposal})) id = proposal;
      }
    } else if (connection_->integer("SELECT 1 FROM test_run WHERE id = ?", {id})) {
      connection_->fail(id, "a run of this name is stored already.", "Give another name, or none.");
    }
    connection_->run("INSERT INTO test_run (id, started_at, program_version) VALUES (?, ?, ?)",
                     {id, run.started_at, run.program_version});
    const std::int64_t number = connection_->lastRowId();
    for (const TestVerdict& verdict : run.verdicts) storeVerdict(*connection_, number, verdict);
  });
  return id;
}

std::vector<TestRun> ProjectStore::latestRuns(int count) const {
  std::vector<TestRun> runs;
  connection_->snapshot([&] {
    connection_->each("SELECT number, id, started_at, program_version FROM test_run ORDER BY number DESC LIMIT ?",
                      {std::int64_t{count > 0 ? count : -1}}, [&](const Record& record) {
                        runs.push_back({record.text(1), record.text(2), record.text(3),
                                        loadVerdicts(*connection_, "v.run = ?", {record.integer(0)}, false)});
                      });
  });
  return runs;
}

std::optional<TestRun> ProjectStore::findRun(const std::string& id) const {
  std::optional<TestRun> run;
  connection_->snapshot([&] {
    connection_->each("SELECT number, id, started_at, program_version FROM test_run WHERE id = ?", {id},
                      [&](const Record& record) {
                        run = TestRun{record.text(1), record.text(2), record.text(3),
                                      loadVerdicts(*connection_, "v.run = ?", {record.integer(0)}, true)};
                      });
  });
  return run;
}

std::map<std::string, TestVerdict> ProjectStore::latestVerdicts() const {
  std::map<std::string, TestVerdict> latest;
  for (TestVerdict& verdict : loadVerdicts(
           *connection_, "item.uid IS NOT NULL AND v.number IN (SELECT max(number) FROM verdict GROUP BY test_uid)", {},
           false)) {
    latest[verdict.test] = std::move(verdict);
  }
  return latest;
}

}  // namespace specs
