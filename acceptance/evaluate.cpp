#include "acceptance/evaluate.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <memory>

#include "acceptance/attainability.h"
#include "acceptance/sample_values.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "model/external/external_runs.h"
#include "model/simulate.h"
#include "report/edf_figure.h"

namespace acceptance {

namespace {

namespace fs = std::filesystem;
using specs::Verdict;

constexpr double kObjectMargin_m = 0.10;  // around an object that is named in place of a gate

/// The test's own words for where something is wrong.
core::Place placeOf(const TestTask& task) { return {.item = "acceptance test " + task.test.id}; }

/// Relative to the project where that is shorter to read, so that reports do not depend on whose disk they came from.
std::string shownPath(const fs::path& file, const fs::path& folder) {
  const fs::path base = fs::weakly_canonical(fs::absolute(folder));
  const fs::path whole = fs::weakly_canonical(fs::absolute(file));
  const std::string relative = whole.lexically_relative(base).generic_string();
  return relative.empty() || relative.starts_with("../../..") ? whole.generic_string() : relative;
}

metrics::MetricOptions metricOptions(const TestTask& task) {
  metrics::MetricOptions options;
  for (const auto& [key, value] : task.test.options) {
    double number = 0.0;
    if (key == "shift" && (value == "one" || value == "balanced")) {
      options.shift = value == "one" ? metrics::Shift::One : metrics::Shift::Balanced;
    } else if (key == "experiments" && core::parseNumber(value, number)) {
      options.experiments = number;
    } else {
      throw core::InputError(placeOf(task), "option '" + key + "' = '" + value + "' is not known.",
                             "Options are shift (one or balanced) and experiments (a number).");
    }
  }
  return options;
}

std::vector<std::size_t> selectedSamples(const TestTask& task, const model::Experiment& experiment) {
  std::vector<bool> selected(experiment.samples.size(), false);
  const std::vector<std::string> words =
      task.test.samples.empty() ? std::vector<std::string>{"validation"} : task.test.samples;
  for (const std::string& word : words) {
    const bool is_role = word == "calibration" || word == "validation" || word == "prediction";
    if (!is_role) selected[experiment.sampleIndex(word)] = true;
    for (std::size_t i = 0; is_role && i < selected.size(); ++i) {
      if (model::toString(experiment.samples[i].role) == word) selected[i] = true;
    }
  }
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < selected.size(); ++i) {
    if (selected[i]) indices.push_back(i);
  }
  if (indices.empty()) {
    throw core::InputError({.file = experiment.file, .item = "/samples"},
                           "has no sample of role " + core::join(words) + ".",
                           "Give a sample this role, or name samples in the test.");
  }
  return indices;
}

/// A gate by its id, or an object by its; nothing for the whole scene.
std::optional<model::Gate> gateOf(const TestTask& task, const model::Experiment& experiment) {
  if (task.test.gate.empty()) return std::nullopt;
  std::vector<std::string> known;
  for (const model::Gate& gate : experiment.gates) {
    if (gate.id == task.test.gate) return gate;
    known.push_back(gate.id);
  }
  const model::Situation situation = model::situationOf(experiment, experiment.samples.front());
  for (const model::SceneObject& object : situation.scene.objects) {
    if (object.id == task.test.gate) return model::Gate{object.id, object.id, kObjectMargin_m};
    known.push_back(object.id);
  }
  const std::string nearest = core::nearestName(task.test.gate, known);
  throw core::InputError({.file = experiment.file, .item = "/gates"},
                         "has neither gate nor object '" + task.test.gate + "', which test " + task.test.id + " names.",
                         nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
}

/// One test on its way from task to result.
class Evaluation {
 public:
  Evaluation(const TestTask& task, TestResult& result, core::Progress& progress)
      : task_(task), result_(result), progress_(progress) {}

  void run();

 private:
  void readInputs();
  void readLidar();
  void noteUsedFiles();
  SampleResult evaluateSample(std::size_t index);
  std::vector<core::Detections> simulateCorners(std::size_t index);
  void askExternalModel();
  [[nodiscard]] model::Experiment withFrames() const;
  core::Detections gated(core::Detections detections, const model::Situation& situation, const char* side) const;
  void decide(SampleResult& sample, const Sides& sides, const Distributions& distributions) const;
  void draw(SampleResult& sample, const Distributions& distributions) const;
  void checkExpression() const;
  void checkScale(const Expression& expression) const;
  void summarise();

  const TestTask& task_;
  TestResult& result_;
  core::Progress& progress_;
  model::Experiment experiment_;
  model::LidarModel model_;
  model::Measurand measurand_;
  std::optional<model::Gate> gate_;
  std::vector<std::size_t> indices_;
  std::size_t simulations_ = 0;
  std::size_t simulated_ = 0;
  std::map<std::size_t, std::vector<core::Detections>> external_;  // by sample, in the order of its corners
};

void Evaluation::readInputs() {
  experiment_ = model::readExperiment(task_.folder / task_.test.experiment);
  result_.experiment_id = experiment_.id;
  result_.experiment_title = experiment_.title;
  result_.experiment_source = experiment_.source;
  result_.synthetic = experiment_.synthetic();
  readLidar();
  result_.model_id = model_.id;
  result_.seed = task_.seed.value_or(model_.seed);
  measurand_ = experiment_.measurand(task_.test.measurand);
  result_.unit = measurand_.unit;
  result_.column = measurand_.column;
  gate_ = gateOf(task_, experiment_);
  indices_ = selectedSamples(task_, experiment_);
  for (const std::size_t index : indices_) simulations_ += model::cornersOf(model_, experiment_.samples[index]).size();
}

void Evaluation::readLidar() {
  if (task_.lidar) {
    model_ = *task_.lidar;
    return;
  }
  if (task_.test.model.empty() && !task_.model) {
    throw core::InputError(placeOf(task_), "names no model.", "Name the model file that is to be accepted.");
  }
  const fs::path model_file = task_.model ? *task_.model : task_.folder / task_.test.model;
  model_ = model::readModel(model_file);
  result_.model_file = shownPath(model_file, task_.folder);
}

void Evaluation::noteUsedFiles() {
  std::vector<fs::path> files;
  for (const std::size_t index : indices_) {
    for (const fs::path& file : model::filesOf(experiment_, experiment_.samples[index])) files.push_back(file);
  }
  if (!task_.lidar) files.push_back(model_.file);
  for (const fs::path& file : model::filesOf(model_)) files.push_back(file);
  for (const nlohmann::json* json : {&experiment_.json, &model_.json}) {
    const auto sensor = json->find("sensor");
    if (sensor != json->end() && sensor->is_string()) {
      files.push_back(core::resourceFolder() / "sensors" / (sensor->get<std::string>() + ".json"));
    }
  }
  for (const fs::path& file : files) {
    const std::string shown = shownPath(file, task_.folder);
    const bool known = std::any_of(result_.used.begin(), result_.used.end(), [&](auto& u) { return u.path == shown; });
    if (!known) result_.used.push_back({shown, core::sha256OfFile(file)});
  }
}

core::Detections Evaluation::gated(core::Detections detections, const model::Situation& situation,
                                   const char* side) const {
  if (!gate_) return detections;
  if (!detections.hasDirections()) {
    throw core::InputError(placeOf(task_),
                           fmt::format("the gate '{}' needs directions, which the {} lacks.", gate_->id, side),
                           "Record layer, azimuth_rad and elevation_rad, or remove the gate.");
  }
  return model::insideGate(detections, situation, *gate_);
}

std::vector<core::Detections> Evaluation::simulateCorners(std::size_t index) {
  const model::Experiment experiment = withFrames();
  const model::Sample& sample = experiment.samples[index];
  const model::Situation nominal = model::situationOf(experiment, sample);
  std::vector<core::Detections> runs;
  if (model_.external) {
    simulated_ += external_.at(index).size();
    for (core::Detections& run : external_.at(index)) runs.push_back(gated(std::move(run), nominal, "simulation"));
    return runs;
  }
  for (const model::EpistemicOffsets& corner : model::epistemicCorners(sample)) {
    core::stopIfCancelled(progress_);
    progress_.report(static_cast<double>(simulated_++) / static_cast<double>(simulations_),
                     task_.test.id + ": simulating " + sample.id);
    runs.push_back(gated(model::simulate(experiment, model_, index, corner, result_.seed), nominal, "simulation"));
  }
  return runs;
}

model::Experiment Evaluation::withFrames() const {
  model::Experiment experiment = experiment_;
  for (const std::size_t index : indices_) {
    if (task_.test.frames) experiment.samples[index].frames = *task_.test.frames;
  }
  return experiment;
}

/// A model that is not ours is started once for all samples and corners, not once for each.
void Evaluation::askExternalModel() {
  if (!model_.external) return;
  const model::Experiment experiment = withFrames();
  std::vector<model::WantedRun> wanted;
  for (const std::size_t index : indices_) {
    for (const auto& corner : model::cornersOf(model_, experiment.samples[index])) wanted.push_back({index, corner});
  }
  const auto asked = task_.external ? task_.external : std::make_shared<model::ExternalRuns>();
  const auto runs = asked->run(experiment, model_, wanted, result_.seed, progress_);
  for (std::size_t i = 0; i < runs.size(); ++i) external_[wanted[i].sample].push_back(runs[i].detections);
}

SampleResult Evaluation::evaluateSample(std::size_t index) {
  const model::Sample& sample = experiment_.samples[index];
  SampleResult result;
  result.id = sample.id;
  result.parameters = sample.parameters;
  const core::Detections measured =
      gated(model::readMeasurements(experiment_, sample), model::situationOf(experiment_, sample), "measurement");
  const std::vector<core::Detections> runs = simulateCorners(index);
  const Sides sides = {.measured = measured,
                       .simulated = runs,
                       .column = measurand_.column,
                       .scale = metrics::scaleNamed(measurand_.scale),
                       .measured_frames = sample.frames,
                       .simulated_frames = task_.test.frames.value_or(sample.frames),
                       .beams_per_frame = model::beamsOfSample(experiment_, model_, sample).size()};
  const Distributions distributions = distributionsOf(sides);
  result.n_real = measured.size();
  for (const core::Detections& run : runs) result.n_sim.push_back(run.size());
  decide(result, sides, distributions);
  const double done = static_cast<double>(simulated_) / static_cast<double>(simulations_);
  core::PartOfProgress here(progress_, done, done);
  result.remarks = unattainableLimits(result.relations, distributions, measurand_.unit, result_.seed, here);
  if (model_.external && runs.size() < model::epistemicCorners(sample).size()) {
    result.remarks.emplace_back("The recorded simulation has no corners of the epistemic box: one run stands for it.");
  }
  if (distributions.complete()) draw(result, distributions);
  return result;
}

void Evaluation::decide(SampleResult& sample, const Sides& sides, const Distributions& distributions) const {
  const Expression expression(task_.test.expression, placeOf(task_));
  std::vector<std::string> wanted = expression.variables();
  if (!task_.test.metric.empty()) wanted.push_back(task_.test.metric);
  sample.values = valuesOf(sides, distributions, wanted, metricOptions(task_));
  std::map<std::string, double> known = sample.values;
  known.insert(sample.parameters.begin(), sample.parameters.end());
  const Decision decision = expression.evaluate(known);
  sample.relations = decision.relations;
  sample.decisive = decision.decisive();
  const auto fails = [](const Relation& r) { return !r.holds && !std::isnan(r.value) && !std::isnan(r.limit); };
  const bool failed = std::any_of(decision.relations.begin(), decision.relations.end(), fails);
  const bool nothing_simulated = *std::min_element(sample.n_sim.begin(), sample.n_sim.end()) == 0;
  if (decision.holds || failed) {
    sample.verdict = decision.holds ? Verdict::Passed : Verdict::Failed;
    if (std::isnan(sample.decisive->value) || std::isnan(sample.decisive->limit)) {
      sample.decisive = *std::find_if(decision.relations.begin(), decision.relations.end(), fails);
    }
    sample.text = sample.decisive->text();
  } else if (sample.n_real > 0 && nothing_simulated) {
    sample.verdict = Verdict::Failed;
    sample.text = fmt::format("the measurement has {} detections, the simulation has none", sample.n_real);
  } else if (sample.n_real == 0) {
    sample.verdict = Verdict::Error;
    sample.text = "the measurement has no detection to compare with";
  } else {
    sample.verdict = Verdict::Error;
    sample.text = "not defined here: " + sample.decisive->text();
  }
}

void Evaluation::draw(SampleResult& sample, const Distributions& distributions) const {
  std::vector<metrics::Edf> runs;
  for (const std::vector<double>& run : distributions.simulated) runs.emplace_back(run);
  const metrics::PBox simulated = metrics::PBox::envelope(runs);
  const metrics::PBox measured = metrics::Edf(distributions.measured);
  const std::string unit = measurand_.unit.empty() ? "" : " " + measurand_.unit;
  report::EdfFigureText text;
  text.title = fmt::format("{}, sample {}", measurand_.name, sample.id);
  text.quantity = measurand_.name;
  text.unit = measurand_.unit;
  text.simulated_n = sample.n_sim;
  text.note = fmt::format("d_bias = {}{}, d_CAVM = {}{}", core::significant(sample.values.at("d_bias")), unit,
                          core::significant(sample.values.at("d_cavm")), unit);
  for (const Relation& relation : sample.relations) {
    const bool upper = relation.order == Order::LessOrEqual || relation.order == Order::Less;
    if (upper && relation.left == "abs(d_bias)" && relation.limit > 0.0) text.bias_limit = relation.limit;
  }
  sample.figure = report::edfFigure({.simulated = simulated, .measured = measured}, text);
}

void Evaluation::summarise() {
  const auto count = [&](Verdict verdict) {
    return std::count_if(result_.samples.begin(), result_.samples.end(),
                         [&](const SampleResult& sample) { return sample.verdict == verdict; });
  };
  const auto errors = count(Verdict::Error);
  const auto failures = count(Verdict::Failed);
  const std::size_t all = result_.samples.size();
  const SampleResult& worst = *result_.decisiveSample();
  const std::string where = fmt::format("{}: {}", worst.id, worst.text);
  if (errors > 0) {
    result_.verdict = Verdict::Error;
    result_.text = fmt::format("{} of {} samples cannot be decided; {}", errors, all, where);
  } else if (failures > 0) {
    result_.verdict = Verdict::Failed;
    result_.text = fmt::format("{} of {} samples fail; worst {}", failures, all, where);
  } else {
    result_.verdict = Verdict::Passed;
    result_.text = fmt::format("all {} samples hold; closest {}", all, where);
    if (all == 1) result_.text = where;
  }
}

/// An expression must make sense for every sample before minutes are spent on simulating them.
void Evaluation::checkExpression() const {
  const Expression expression(task_.test.expression, placeOf(task_));
  for (const std::size_t index : indices_) {
    std::vector<std::string> known;
    for (const auto& [name, value] : experiment_.samples[index].parameters) known.push_back(name);
    for (const Variable& variable : expressionVariables()) known.push_back(variable.name);
    expression.requireKnown(known);
  }
  checkScale(expression);
}

/// The mean of ranks says nothing: a metric must not ask more of the measurand than its scale of measurement gives.
void Evaluation::checkScale(const Expression& expression) const {
  const metrics::Scale scale = metrics::scaleNamed(measurand_.scale);
  const std::vector<std::string> used = expression.variables();
  for (const metrics::Metric& metric : metrics::metricCatalog()) {
    if (metrics::isMeaningful(metric.info, scale) || !isWanted(metric, used)) continue;
    throw core::InputError(placeOf(task_),
                           fmt::format("{} needs an {} scale, and the measurand '{}' is {}.", metric.info.name,
                                       metrics::toString(metric.info.scale), measurand_.name, measurand_.scale),
                           "Use a metric of ranks, such as ks_statistic, or correct `scale` in the experiment.");
  }
}

void Evaluation::run() {
  // What is wrong with the test itself is said before anything is simulated.
  (void)Expression(task_.test.expression, placeOf(task_));
  (void)metricOptions(task_);
  readInputs();
  checkExpression();
  noteUsedFiles();
  askExternalModel();
  for (const std::size_t index : indices_) result_.samples.push_back(evaluateSample(index));
  summarise();
}

}  // namespace

TestResult evaluate(const TestTask& task, core::Progress& progress) {
  TestResult result;
  result.test = task.test;
  result.requirements = task.requirements;
  if (task.test.experiment.empty()) {
    result.text = "names no experiment: to be decided by inspection";
    return result;
  }
  const auto cannot = [&](const std::string& why) {
    result.verdict = Verdict::Error;
    result.text = why;
    result.samples.clear();
  };
  try {
    Evaluation(task, result, progress).run();
  } catch (const core::InputError& error) {
    cannot(error.what());
  } catch (const fs::filesystem_error& error) {
    cannot(error.what());
  }
  progress.report(1.0, task.test.id);
  return result;
}

std::vector<Variable> expressionVariables() {
  std::vector<Variable> variables;
  for (const metrics::Metric& metric : metrics::metricCatalog()) {
    for (std::size_t part = 0; part < std::max<std::size_t>(1, metric.parts.size()); ++part) {
      variables.push_back({variableName(metric, part), std::string(metric.info.meaning)});
    }
  }
  const std::vector<Variable> own = {
      {"n_real", "measured detections (inside the gate)"},
      {"n_sim", "simulated detections at nominal values (inside the gate)"},
      {"frames_real", "measured frames"},
      {"frames_sim", "simulated frames"},
      {"detection_rate_real", "share of fired beams with a measured echo (inside the gate)"},
      {"detection_rate_sim", "share of fired beams with a simulated echo (inside the gate)"},
      {"missing_fraction", "echoes that only the simulation has, share of all simulated ones"},
      {"extra_fraction", "echoes that only the measurement has, share of all simulated ones"}};
  variables.insert(variables.end(), own.begin(), own.end());
  return variables;
}

}  // namespace acceptance
