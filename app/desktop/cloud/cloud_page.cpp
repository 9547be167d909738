#include "app/desktop/cloud/cloud_page.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QFileDialog>

#include "app/desktop/error_dialog.h"
#include "app/desktop/file_list.h"
#include "app/desktop/html.h"

namespace desktop {

CloudPage::~CloudPage() = default;

void CloudPage::connectParts() {
  connect(experiments_, &QComboBox::activated, this, [this] { openExperiment(chosenFile(experiments_)); });
  connect(models_, &QComboBox::activated, this, [this] { chooseModel(chosenFile(models_)); });
  connect(samples_, &QComboBox::currentIndexChanged, this, &CloudPage::showSample);
  connect(frames_, &QComboBox::currentIndexChanged, this, &CloudPage::showFrames);
  connect(frame_, &QSpinBox::valueChanged, this, &CloudPage::showFrames);
  connect(colour_, &QComboBox::currentIndexChanged, this,
          [this] { view_->setColourBy(ColourBy(colour_->currentData().toInt())); });
  connect(point_size_, &QSpinBox::valueChanged, view_, &CloudView::setPointSize);
  connect(show_measured_, &QCheckBox::toggled, view_,
          [this](bool on) { view_->setVisible(CloudSource::Measured, on); });
  connect(show_simulated_, &QCheckBox::toggled, view_,
          [this](bool on) { view_->setVisible(CloudSource::Simulated, on); });
  connect(show_silent_, &QCheckBox::toggled, this, &CloudPage::showSilent);
  connect(copy_, &QToolButton::clicked, this, &CloudPage::copyReadout);
  connect(view_, &CloudView::copyRequested, this, &CloudPage::copyReadout);
  connect(view_, &CloudView::pickChanged, this, &CloudPage::showPick);
  connect(&document_, &ProjectDocument::reset, this, &CloudPage::offerFilesOfProject);
}

void CloudPage::connectThreads() {
  connect(&loader_, &CloudLoader::loaded, this, [this](std::shared_ptr<const PointCloud> cloud) {
    measured_ = std::move(cloud);
    sayWhatIsMissing();
    view_->setCloud(CloudSource::Measured, measured_);
    showFrames();
  });
  connect(&loader_, &CloudLoader::failed, this, [this](const core::InputError& error) {
    tellTrouble(readoutOf(tr("The measurements cannot be read"), error));
  });
  connect(&explainer_, &BeamExplainer::explained, this, [this](const model::BeamExplanation& beam) {
    const auto point = view_->picked();
    if (!point) return;
    beam_ = beam;
    const bool silent = point->source == CloudSource::Silent;
    waveform_->show(beam, silent ? std::nullopt : std::optional(cloud(point->source)->detections.range_m[point->index]),
                    CloudView::colourOf(point->source));
    showReadout();
  });
  connect(&explainer_, &BeamExplainer::failed, waveform_, &WaveformView::clear);
  connect(&explainer_, &BeamExplainer::silentFound, this, [this](std::shared_ptr<const SilentBeams> beams) {
    silent_ = std::move(beams);
    view_->setCloud(CloudSource::Silent, std::shared_ptr<const PointCloud>(silent_, &silent_->cloud));
    if (!runner_.isRunning()) showStatus();
  });
  connect(&explainer_, &BeamExplainer::silentFailed, this, [this](const QString& why) {
    tellTrouble({{.title = tr("Beams without detection cannot be found"), .note = why, .rows = {}}});
    if (!runner_.isRunning()) showStatus();
  });
  connect(&runner_, &SimulationRunner::progressed, this, [this](double fraction, const QString& doing) {
    progress_->setValue(int(fraction * 100));
    setStatus(doing);
  });
  connect(&runner_, &SimulationRunner::simulated, this,
          [this](std::size_t sample, std::shared_ptr<const PointCloud> cloud) {
            simulated_[sample] = std::move(cloud);
            if (sample == this->sample()) showSimulated();
          });
  connect(&runner_, &SimulationRunner::finished, this, [this] {
    showBusy(false);
    showStatus();
  });
  connect(&runner_, &SimulationRunner::cancelled, this, [this] {
    showBusy(false);
    showStatus();
    if (std::exchange(stopped_by_hand_, false)) setStatus(tr("Cancelled"));
    if (std::exchange(again_, false)) simulate();
  });
  connect(&runner_, &SimulationRunner::failed, this, [this](const core::InputError& error) {
    showBusy(false);
    showStatus();
    showError(this, error);
  });
}

void CloudPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && values_) showReadout();  // its colours are written into its text
}

void CloudPage::setStatus(const QString& text) {
  status_->setText(text);
  status_->setToolTip(text);
}

// Files -------------------------------------------------------------------------------------------------------------

void CloudPage::offerFilesOfProject() {
  forgetSimulation();
  experiments_->clear();
  models_->clear();
  experiment_.reset();
  model_.clear();
  for (const specs::AcceptanceTest& test : document_.specification().tests) {
    const TestFiles files = filesOf(test, document_);
    if (!files.experiment.empty()) offerFile(experiments_, files.experiment);
    if (!files.model.empty()) offerFile(models_, files.model);
  }
  if (models_->count() > 0) chooseModel(chosenFile(models_));
  if (experiments_->count() > 0) {
    openExperiment(chosenFile(experiments_));
  } else {
    fillSamples();
  }
}

bool CloudPage::openExperiment(const std::filesystem::path& file) {
  forgetSimulation();
  experiment_.reset();
  Readout trouble;
  try {
    experiment_ = model::readExperiment(file);
  } catch (const core::InputError& error) {
    trouble = readoutOf(tr("The experiment cannot be read"), error);
  }
  experiments_->setCurrentIndex(offerFile(experiments_, experiment_ ? experiment_->file : file));
  fillSamples();
  if (!trouble.empty()) tellTrouble(std::move(trouble));
  return experiment_.has_value();
}

void CloudPage::chooseModel(const std::filesystem::path& file) {
  forgetSimulation();
  model_ = file;
  models_->setCurrentIndex(offerFile(models_, file));
  showSimulated();
}

void CloudPage::askForExperiment() {
  const std::filesystem::path near = experiment_ ? experiment_->file.parent_path() : document_.folder();
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open an experiment package"), QString::fromStdString(near.string()),
                                   tr("Experiments (experiment.json *.json);;All files (*)"));
  if (!file.isEmpty()) openExperiment(file.toStdString());
}

void CloudPage::askForModel() {
  const std::filesystem::path near = model_.empty() ? document_.folder() : model_.parent_path();
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a model"), QString::fromStdString(near.string()),
                                                    tr("Models (*.json);;All files (*)"));
  if (!file.isEmpty()) chooseModel(file.toStdString());
}

// What is shown -----------------------------------------------------------------------------------------------------

void CloudPage::fillSamples() {
  {
    const QSignalBlocker quiet(samples_);
    samples_->clear();
    if (experiment_) {
      for (const model::Sample& each : experiment_->samples) {
        samples_->addItem(QString::fromStdString(each.id));
        samples_->setItemData(samples_->count() - 1, samples_->itemText(samples_->count() - 1), Qt::ToolTipRole);
      }
    }
  }
  showSample();
}

void CloudPage::showSample() {
  measured_.reset();
  trouble_.clear();
  loader_.drop();
  view_->fit();  // and stay so while clouds arrive
  view_->setCloud(CloudSource::Measured, nullptr);
  if (experiment_ && sample() < experiment_->samples.size() && !experiment_->samples[sample()].measurements.empty()) {
    loader_.load(*experiment_, sample());
  }
  sayWhatIsMissing();
  showSimulated();
}

void CloudPage::sayWhatIsMissing() {
  view_->setMessage(!experiment_          ? tr("Open an experiment package to see its detections.")
                    : loader_.isLoading() ? tr("Reading the measurements…")
                    : measured_ && measured_->detections.size() > 0
                        ? tr("The directions of these detections were not recorded: they have no place in space.")
                        : tr("There are no detections in this sample. Simulate it to see what a model reports."));
}

void CloudPage::tellTrouble(Readout trouble) {
  trouble_ = std::move(trouble);
  view_->setMessage(toText(trouble_));
  showReadout();
}

void CloudPage::showSimulated() {
  const auto found = simulated_.find(sample());
  view_->setCloud(CloudSource::Simulated, found == simulated_.end() ? nullptr : found->second);
  showFrames();
  if (!runner_.isRunning()) showStatus();
}

void CloudPage::showFrames() {
  int frames = 1;
  for (const CloudSource source : {CloudSource::Measured, CloudSource::Simulated}) {
    if (const PointCloud* each = cloud(source)) frames = std::max(frames, each->frames());
  }
  {
    const QSignalBlocker quiet(frame_);
    frame_->setRange(0, frames - 1);
  }
  const bool one = frames_->currentIndex() == 1;
  frame_->setEnabled(one);
  view_->setFrame(one ? std::optional(frame_->value()) : std::nullopt);
  showSilent();
  showPick();
}

/// Asks for the beams without detection again if they are not those of this model, sample and frame.
void CloudPage::showSilent() {
  std::optional<BeamQuestion> wanted;
  if (show_silent_->isChecked() && experiment_ && !experiment_->samples.empty() && !model_.empty()) {
    wanted = question(frames_->currentIndex() == 1 ? frame_->value() : 0);
  }
  if (wanted == silent_of_) return;
  silent_of_ = wanted;
  explainer_.dropSilent();
  silent_.reset();
  view_->setCloud(CloudSource::Silent, nullptr);
  if (wanted) {
    if (!runner_.isRunning()) setStatus(tr("Looking for beams without detection…"));
    explainer_.askSilent(*wanted);
  } else if (!runner_.isRunning()) {
    showStatus();
  }
}

void CloudPage::showStatus() {
  simulate_->setEnabled(experiment_ && !model_.empty());
  simulate_->setToolTip(!experiment_     ? tr("Open an experiment first")
                        : model_.empty() ? tr("Choose a model first")
                                         : tr("Simulate this experiment with the model, this sample first"));
  setStatus(experiment_ && experiment_->synthetic() ? tr("Synthetic data: made by a program, not measured.")
                                                    : QString());
}

void CloudPage::showBusy(bool busy) {
  progress_->setVisible(busy);
  progress_->setValue(0);
  cancel_->setVisible(busy);
  simulate_->setVisible(!busy);
  if (busy) setStatus(tr("Starting…"));
}

void CloudPage::forgetSimulation() {
  again_ = false;
  if (runner_.isRunning()) showBusy(false);  // it ends by itself, unseen
  runner_.cancel();
  simulated_.clear();
  ++edition_;
}

void CloudPage::cancel() {
  again_ = false;
  stopped_by_hand_ = runner_.isRunning();
  runner_.cancel();
  if (stopped_by_hand_) setStatus(tr("Stopping…"));
}

void CloudPage::simulate() {
  if (!experiment_ || model_.empty()) return;
  if (runner_.isRunning()) {
    if (!runner_.isStopping()) return;
    again_ = true;
    showBusy(true);
    return;
  }
  simulated_.clear();
  ++edition_;
  showSimulated();
  showBusy(true);
  runner_.start(experiment_->file, model_, sample());
}

const PointCloud* CloudPage::cloud(CloudSource source) const {
  if (source == CloudSource::Measured) return measured_.get();
  if (source == CloudSource::Silent) return silent_ ? &silent_->cloud : nullptr;
  const auto found = simulated_.find(sample());
  return found == simulated_.end() ? nullptr : found->second.get();
}

// The picked point --------------------------------------------------------------------------------------------------

void CloudPage::showPick() {
  beam_.reset();
  showReadout();
  explainPick();
}

void CloudPage::showReadout() {
  const auto point = view_->picked();
  readout_ = point ? readoutOfPick(*point) : trouble_;
  values_->setHtml(readout_.empty() ? html::muted(tr("Click a point to see its values, or press Space."), palette())
                                    : toHtml(readout_, palette()));
  copy_->setVisible(!readout_.empty());
}

void CloudPage::copyReadout() const {
  if (!readout_.empty()) QApplication::clipboard()->setText(readoutText());
}

BeamQuestion CloudPage::question(int frame) const {
  return {.experiment = experiment_->file,
          .model = model_,
          .edition = edition_,
          .sample = sample(),
          .frame = frame,
          .layer = {},
          .azimuth_rad = 0.0};
}

void CloudPage::explainPick() {
  const auto point = view_->picked();
  waveform_->setVisible(point.has_value());
  explainer_.drop();
  if (!point) return;
  if (model_.empty()) {
    waveform_->clear(tr("Choose a model to see what it receives from this beam."));
    return;
  }
  const core::Detections& d = cloud(point->source)->detections;
  waveform_->clear(tr("Asking the model…"));
  BeamQuestion about = question(d.frame[point->index]);
  if (!d.layer.empty()) about.layer = d.layer[point->index];
  about.azimuth_rad = d.azimuth_rad[point->index];
  explainer_.ask(about);
}

Readout CloudPage::readoutOfPick(const PickedPoint& point) const {
  const PointCloud& own = *cloud(point.source);
  Readout readout{partOf(own, point.source, point.index, samples_->currentText())};
  if (point.source == CloudSource::Silent) {
    readout.front().rows.emplace_back(tr("Reason"),
                                      QString::fromStdString(model::toString(silent_->reasons[point.index])));
  }
  const CloudSource source = point.source == CloudSource::Measured ? CloudSource::Simulated : CloudSource::Measured;
  if (const PointCloud* other = cloud(source)) readout.push_back(partOfOther(*other, source, own, point.index));
  if (beam_) {
    for (ReadoutPart& part : partsOf(*beam_)) readout.push_back(std::move(part));
  }
  return readout;
}

}  // namespace desktop
