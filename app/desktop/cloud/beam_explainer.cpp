#include "app/desktop/cloud/beam_explainer.h"

#include <algorithm>

#include "core/error.h"

namespace desktop {

/// One sample under one model, ready to be asked.
struct BeamExplainer::Traced {
  BeamQuestion of;
  model::Experiment experiment;
  model::LidarModel lidar;
  std::unique_ptr<model::Explainer> explainer;

  [[nodiscard]] bool fits(const BeamQuestion& question) const {
    return explainer && of.experiment == question.experiment && of.model == question.model &&
           of.sample == question.sample;
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
    const int last = experiment.samples[question.sample].frames - 1;
    return explainer->explain(explainer->beamNear(question.layer, question.azimuth_rad),
                              std::clamp(question.frame, 0, last));
  }
};

BeamExplainer::BeamExplainer(QObject* parent) : QObject(parent), traced_(std::make_shared<Traced>()) {}

BeamExplainer::~BeamExplainer() {
  if (thread_) thread_->wait();
}

void BeamExplainer::drop() {
  next_.reset();
  wanted_ = false;
}

void BeamExplainer::ask(const BeamQuestion& question) {
  wanted_ = true;
  if (thread_) {
    next_ = question;
  } else {
    begin(question);
  }
}

void BeamExplainer::begin(const BeamQuestion& question) {
  struct Outcome {
    std::optional<model::BeamExplanation> beam;
    QString why;
  };
  auto outcome = std::make_shared<Outcome>();
  thread_.reset(QThread::create([question, outcome, traced = traced_] {
    try {
      outcome->beam = traced->answer(question);
    } catch (const std::exception& error) {  // no exception may leave the thread
      outcome->why = QString::fromUtf8(error.what());
    }
  }));
  connect(thread_.get(), &QThread::finished, this, [this, outcome] {
    thread_.release()->deleteLater();
    if (next_) {
      begin(*std::exchange(next_, std::nullopt));
    } else if (wanted_ && outcome->beam) {
      emit explained(*outcome->beam);
    } else if (wanted_) {
      emit failed(outcome->why);
    }
  });
  thread_->start();
}

}  // namespace desktop
