#include "app/desktop/cloud/beam_explainer.h"

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace desktop {

namespace {

/// Where the light of a beam that was not detected got lost; 0: it met nothing.
double lossRange(const model::BeamExplanation& beam) {
  const auto weaker = [](const model::Pulse& a, const model::Pulse& b) { return a.power_w < b.power_w; };
  const auto& pulses = beam.shot.pulses;
  if (!pulses.empty()) return std::max_element(pulses.begin(), pulses.end(), weaker)->range_m;
  for (const model::SubRayExplanation& ray : beam.rays) {
    if (!ray.object.empty()) return ray.range_m;
  }
  return 0.0;
}

SilentBeams silentBeams(const model::Explainer& explainer, int frame, const std::atomic<bool>& stop) {
  core::Detections d{.frame = {}, .layer = {}, .azimuth_rad = {}, .elevation_rad = {}, .echo = {}, .range_m = {}};
  std::vector<model::Reason> reasons;
  std::vector<double> losses_m;
  for (std::size_t b = 0; b < explainer.beams().size() && !stop; ++b) {
    const model::Reason reason = explainer.reasonOf(b, frame);
    if (reason == model::Reason::kDetected) continue;
    const model::BeamExplanation beam = explainer.explain(b, frame);
    reasons.push_back(reason);
    d.frame.push_back(frame);
    d.layer.push_back(beam.beam.layer);
    d.azimuth_rad.push_back(beam.beam.azimuth_rad);
    d.elevation_rad.push_back(beam.beam.elevation_rad);
    d.echo.push_back(0);
    d.range_m.push_back(lossRange(beam));
    if (d.range_m.back() > 0.0) losses_m.push_back(d.range_m.back());
  }
  double usual_m = 10.0;
  if (!losses_m.empty()) {
    const auto middle = losses_m.begin() + static_cast<std::ptrdiff_t>(losses_m.size() / 2);
    std::nth_element(losses_m.begin(), middle, losses_m.end());
    usual_m = *middle;
  }
  for (double& range_m : d.range_m) {
    if (range_m == 0.0) range_m = usual_m;
  }
  return {.cloud = pointCloudOf(std::move(d)), .reasons = std::move(reasons)};
}

}  // namespace

/// One sample under one model, ready to be asked.
struct BeamExplainer::Traced {
  BeamQuestion of;
  model::Experiment experiment;
  model::LidarModel lidar;
  std::unique_ptr<model::Explainer> explainer;

  [[nodiscard]] bool fits(const BeamQuestion& question) const {
    return explainer && of.experiment == question.experiment && of.model == question.model &&
           of.edition == question.edition && of.sample == question.sample;
  }
  void trace(const BeamQuestion& question) {
    explainer.reset();
    of = question;
    experiment = model::readExperiment(question.experiment);
    lidar = model::readModel(question.model);
    explainer = std::make_unique<model::Explainer>(experiment, lidar, question.sample);
  }
  [[nodiscard]] model::BeamExplanation answer(const BeamQuestion& question) {
    if (!fits(question)) trace(question);
    return explainer->explain(explainer->beamNear(question.layer, question.azimuth_rad), frameOf(question));
  }
  [[nodiscard]] SilentBeams silent(const BeamQuestion& question, const std::atomic<bool>& stop) {
    if (!fits(question)) trace(question);
    return silentBeams(*explainer, frameOf(question), stop);
  }
  [[nodiscard]] int frameOf(const BeamQuestion& question) const {
    return std::clamp(question.frame, 0, std::max(0, experiment.samples.at(question.sample).frames - 1));
  }
};

struct BeamExplainer::Outcome {
  std::optional<model::BeamExplanation> beam;
  std::shared_ptr<const SilentBeams> silent;
  QString why;
};

BeamExplainer::BeamExplainer(QObject* parent) : QObject(parent), traced_(std::make_shared<Traced>()) {}

BeamExplainer::~BeamExplainer() {
  *stop_silent_ = true;
  if (thread_) thread_->wait();
}

void BeamExplainer::drop() {
  next_.reset();
  wanted_ = false;
}

void BeamExplainer::dropSilent() {
  *stop_silent_ = true;
  next_silent_.reset();
  silent_wanted_ = false;
}

void BeamExplainer::ask(const BeamQuestion& question) {
  wanted_ = true;
  next_ = question;
  goOn();
}

void BeamExplainer::askSilent(const BeamQuestion& question) {
  dropSilent();
  silent_wanted_ = true;
  next_silent_ = question;
  goOn();
}

/// A picked beam first: somebody looks at it.
void BeamExplainer::goOn() {
  if (thread_) return;
  if (next_) {
    begin(*std::exchange(next_, std::nullopt), false);
  } else if (next_silent_) {
    begin(*std::exchange(next_silent_, std::nullopt), true);
  }
}

void BeamExplainer::hand(const Outcome& outcome, bool silent) {
  if (silent && silent_wanted_ && !next_silent_) {
    if (outcome.silent) {
      emit silentFound(outcome.silent);
    } else {
      emit silentFailed(outcome.why);
    }
  } else if (!silent && wanted_ && !next_) {
    if (outcome.beam) {
      emit explained(*outcome.beam);
    } else {
      emit failed(outcome.why);
    }
  }
}

void BeamExplainer::begin(const BeamQuestion& question, bool silent) {
  auto outcome = std::make_shared<Outcome>();
  if (silent) stop_silent_ = std::make_shared<std::atomic<bool>>(false);
  thread_.reset(QThread::create([question, silent, outcome, traced = traced_, stop = stop_silent_] {
    try {
      if (silent) {
        outcome->silent = std::make_shared<const SilentBeams>(traced->silent(question, *stop));
      } else {
        outcome->beam = traced->answer(question);
      }
    } catch (const std::exception& error) {  // no exception may leave the thread
      outcome->why = QString::fromUtf8(error.what());
    }
  }));
  connect(thread_.get(), &QThread::finished, this, [this, outcome, silent] {
    thread_.release()->deleteLater();
    hand(*outcome, silent);
    goOn();
  });
  thread_->start();
}

}  // namespace desktop
