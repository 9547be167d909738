#include "app/cli/predict/outcome.h"

#include <algorithm>
#include <set>

#include "core/error.h"
#include "prediction/prediction_file.h"

namespace app {

namespace {

using metrics::Family;
using metrics::Prediction;

bool isJson(const std::string& file) { return file.ends_with(".json") || file.ends_with(".json.gz"); }

Answer learn(const metrics::ErrorSamples& samples, const PredictRequest& request) {
  Answer answer;
  metrics::PredictionOptions how{.level = request.level.value_or(0.95),
                                 .never_negative = isNeverNegative(samples.target)};
  if (request.family == "auto") {
    auto choice = metrics::chooseFamily(samples, {.folds = request.folds, .never_negative = how.never_negative});
    how.family = choice.family;
    answer.candidates = std::move(choice.candidates);
  }
  for (const Family family : metrics::kFamilies) {
    if (metrics::name(family) == request.family) how.family = family;
  }
  answer.prediction = metrics::predict(samples, how);
  return answer;
}

std::size_t countSetups(const metrics::ErrorSamples& samples) {
  std::set<std::string> names(samples.setups.begin(), samples.setups.end());
  std::size_t alone = 0;
  if (names.erase("") > 0)
    alone = static_cast<std::size_t>(std::count(samples.setups.begin(), samples.setups.end(), ""));
  return names.size() + alone;
}

/// With the file's name in front, so that the message says where the rows come from.
template <typename Work>
void inFile(const std::filesystem::path& file, Work work) {
  try {
    work();
  } catch (const core::InputError& error) {
    if (!error.place().file.empty()) throw;
    throw core::InputError({.file = file, .item = error.place().item}, error.problem(), error.remedy());
  }
}

void append(metrics::ErrorSamples& to, const metrics::ErrorSamples& from) {
  to.target = from.target;
  to.parameters = from.parameters;
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  to.errors.insert(to.errors.end(), from.errors.begin(), from.errors.end());
  to.setups.insert(to.setups.end(), from.setups.begin(), from.setups.end());
  to.weights.clear();  // a check counts samples
}

/// Every row of the file counts as held out, whatever its role.
std::vector<metrics::ErrorSamples> readHeldOut(const std::string& file, const Outcome& outcome) {
  ResultColumns columns{.parameters = outcome.parameters(), .targets = {}, .every_role = true};
  for (const Answer& answer : outcome.answers) columns.targets.push_back(answer.prediction.target);
  return readResultsTable(file, columns).seen;
}

void checkOn(Outcome& outcome, std::vector<metrics::ErrorSamples> held_out, const PredictRequest& request) {
  if (!request.held_out.empty()) {
    const auto more = readHeldOut(request.held_out, outcome);
    held_out.resize(more.size());
    for (std::size_t t = 0; t < more.size(); ++t) append(held_out[t], more[t]);
  }
  for (std::size_t t = 0; t < held_out.size(); ++t) {
    if (held_out[t].size() == 0) continue;
    outcome.answers[t].held_out = metrics::checkHeldOut(outcome.answers[t].prediction, held_out[t]);
  }
}

/// The measurand as the file records it, else as --measurand says.
std::optional<prediction::Measurand> agreed(const std::optional<prediction::Measurand>& recorded,
                                            const PredictRequest& request) {
  if (request.measurand.empty()) return recorded;
  const prediction::Measurand named = prediction::measurandNamed(request.measurand);
  if (recorded && !prediction::compatible(*recorded, named)) {
    throw core::InputError({.item = "--measurand " + request.measurand},
                           "contradicts the file, whose errors are of " + toString(*recorded) + ".",
                           "Leave --measurand out.");
  }
  return recorded ? recorded : named;
}

Outcome learnFromResults(const PredictRequest& request) {
  const ValidationResults results = isJson(request.results)
                                        ? readAcceptanceReport(request.results, request.columns, request.test)
                                        : readResultsTable(request.results, request.columns);
  Outcome outcome{.answers = {}, .queries = {}, .boxes = {}, .left_out = results.left_out};
  outcome.measurand = agreed(results.measurand, request);
  outcome.setups = countSetups(results.seen.front());
  inFile(request.results, [&] {
    for (const metrics::ErrorSamples& samples : results.seen) outcome.answers.push_back(learn(samples, request));
    checkOn(outcome, results.held_out, request);
  });
  return outcome;
}

Outcome askSaved(const PredictRequest& request) {
  Outcome outcome;
  prediction::PredictionFile saved = prediction::readPredictionFile(request.with);
  outcome.measurand = agreed(saved.measurand, request);
  for (Prediction& error : saved.predictions) {
    if (request.level) error = metrics::atLevel(std::move(error), *request.level);
    outcome.answers.push_back({.prediction = std::move(error), .candidates = {}, .held_out = {}});
  }
  checkOn(outcome, {}, request);
  return outcome;
}

void ask(Outcome& outcome, const PredictRequest& request) {
  for (std::vector<double>& point : queryPoints(request, outcome.parameters())) {
    Query query{.point = std::move(point), .errors = {}};
    for (const Answer& answer : outcome.answers) query.errors.push_back(answer.prediction.at(query.point));
    outcome.queries.push_back(std::move(query));
  }
}

NamedErrors errorsOf(const Outcome& outcome, const Query& query) {
  NamedErrors errors;
  for (std::size_t t = 0; t < query.errors.size(); ++t) {
    errors.emplace(outcome.answers[t].prediction.target, query.errors[t]);
  }
  return errors;
}

}  // namespace

Outcome outcomeOf(const PredictRequest& request) {
  check(request);
  Outcome outcome = request.with.empty() ? learnFromResults(request) : askSaved(request);
  ask(outcome, request);
  if (!request.boxes.simulated.empty()) {
    outcome.boxes = boxesAt(errorsOf(outcome, outcome.queries.front()), request.boxes);
  }
  return outcome;
}

}  // namespace app
