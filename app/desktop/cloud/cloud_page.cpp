#include "app/desktop/cloud/cloud_page.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>
#include <numbers>

#include "app/desktop/colours.h"
#include "app/desktop/error_dialog.h"
#include "app/desktop/html.h"
#include "core/json_object.h"

namespace desktop {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

QToolButton* button(const QString& text, const QString& tip) {
  auto* made = new QToolButton;
  made->setText(text);
  made->setToolTip(tip);
  return made;
}

QComboBox* box(const QString& name, int letters) {
  auto* made = new QComboBox;
  made->setAccessibleName(name);
  made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  made->setMinimumContentsLength(letters);
  return made;
}

QIcon patch(const QColor& colour) {
  QPixmap pixmap(12, 12);
  pixmap.fill(colour);
  return QIcon(pixmap);
}

/// The folder of an experiment.json, or the file's own name.
QString shortName(const std::filesystem::path& file) {
  const bool usual = file.filename() == "experiment.json" && file.has_parent_path();
  return QString::fromStdString((usual ? file.parent_path().filename() : file.filename()).string());
}

/// Adds it once and returns its index.
int offer(QComboBox* list, const std::filesystem::path& file) {
  const QString path = QString::fromStdString(file.lexically_normal().string());
  if (const int known = list->findData(path); known >= 0) return known;
  list->addItem(shortName(file), path);
  list->setItemData(list->count() - 1, path, Qt::ToolTipRole);
  return list->count() - 1;
}

std::filesystem::path chosen(const QComboBox* list) { return list->currentData().toString().toStdString(); }

QString row(const QString& name, const QString& value) {
  return "<tr><td style='padding-right:14px'>" + name + "</td><td align='right'>" + value + "</td></tr>";
}

QString number(double value, int decimals, const QString& unit) {
  return QString::number(value, 'f', decimals) + " " + unit;
}

QString difference(double other, double own, int decimals, const QString& unit) {
  const double by = other - own;
  return number(other, decimals, unit) + " <small>(" + (by >= 0 ? "+" : "−") +
         QString::number(std::abs(by), 'f', decimals) + ")</small>";
}

}  // namespace

CloudPage::CloudPage(ProjectDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      experiments_(box(tr("Experiment"), 16)),
      models_(box(tr("Model"), 16)),
      samples_(box(tr("Sample"), 10)),
      frames_(box(tr("Frames"), 8)),
      frame_(new QSpinBox),
      colour_(box(tr("Colour by"), 12)),
      view_(new CloudView) {
  auto* splitter = new QSplitter;
  splitter->setObjectName("cloudSplitter");
  splitter->addWidget(view_);
  splitter->addWidget(makeSide());
  splitter->setSizes({1120, 320});
  splitter->setStretchFactor(0, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeSourceBar());
  layout->addWidget(makeViewBar());
  layout->addWidget(splitter, 1);
  samples_->setObjectName("cloudSamples");
  show_simulated_->setObjectName("cloudSimulated");
  frames_->setObjectName("cloudFrames");
  colour_->setObjectName("cloudColour");
  connectParts();
  showBusy(false);
  offerFilesOfProject();
}

CloudPage::~CloudPage() = default;

QWidget* CloudPage::makeSourceBar() {
  auto* bar = new QWidget;
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 6, 8, 3);
  auto* open_experiment = button(tr("Open…"), tr("An experiment package from elsewhere"));
  auto* open_model = button(tr("Open…"), tr("A model file from elsewhere"));
  simulate_ = button(tr("Simulate"), tr("Simulate this experiment with the model, this sample first"));
  cancel_ = button(tr("Cancel"), tr("Stop; what is simulated already stays"));
  progress_ = new QProgressBar;
  progress_->setAccessibleName(tr("Progress of the simulation"));
  progress_->setFixedWidth(180);
  status_ = new QLabel;
  status_->setObjectName("cloudStatus");
  const auto label = [&](const QString& text, QWidget* buddy) {
    auto* made = new QLabel(text);
    made->setBuddy(buddy);
    layout->addWidget(made);
    layout->addWidget(buddy);
  };
  label(tr("Experiment"), experiments_);
  layout->addWidget(open_experiment);
  label(tr("Sample"), samples_);
  layout->addSpacing(12);
  label(tr("Model"), models_);
  for (QWidget* widget : std::initializer_list<QWidget*>{open_model, simulate_, progress_, cancel_, status_}) {
    layout->addWidget(widget);
  }
  layout->addStretch(1);
  connect(open_experiment, &QToolButton::clicked, this, &CloudPage::askForExperiment);
  connect(open_model, &QToolButton::clicked, this, &CloudPage::askForModel);
  connect(simulate_, &QToolButton::clicked, this, &CloudPage::simulate);
  connect(cancel_, &QToolButton::clicked, this, &CloudPage::cancel);
  return bar;
}

QWidget* CloudPage::makeViewBar() {
  auto* bar = new QWidget;
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 3, 8, 6);
  show_measured_ = new QCheckBox(tr("Measured"));
  show_measured_->setIcon(patch(CloudView::kMeasured));
  show_simulated_ = new QCheckBox(tr("Simulated"));
  show_simulated_->setIcon(patch(CloudView::kSimulated));
  for (QCheckBox* check : {show_measured_, show_simulated_}) {
    check->setChecked(true);
    layout->addWidget(check);
  }
  layout->addSpacing(12);
  layout->addWidget(new QLabel(tr("Colour by")));
  for (const ColourBy by : {ColourBy::Source, ColourBy::Range, ColourBy::Intensity, ColourBy::EchoPulseWidth,
                            ColourBy::Layer, ColourBy::Echo}) {
    colour_->addItem(wordFor(by), int(by));
  }
  layout->addWidget(colour_);
  layout->addSpacing(12);
  frames_->addItems({tr("All frames"), tr("Frame")});
  frame_->setAccessibleName(tr("Number of the frame"));
  frame_->findChild<QLineEdit*>()->setAccessibleName(frame_->accessibleName());
  layout->addWidget(frames_);
  layout->addWidget(frame_);
  layout->addStretch(1);
  using Look = CloudView::Look;
  for (const auto& [look, text, tip] :
       {std::tuple(Look::Perspective, tr("Perspective"), tr("From behind the sensor, from above")),
        std::tuple(Look::Top, tr("Top"), tr("From above, true to scale; x is up")),
        std::tuple(Look::Side, tr("Side"), tr("From the right, true to scale")),
        std::tuple(Look::Sensor, tr("Front"), tr("Along x, as the sensor looks, true to scale"))}) {
    auto* made = button(text, tip);
    connect(made, &QToolButton::clicked, view_, [this, look = look] { view_->look(look); });
    layout->addWidget(made);
  }
  auto* fit = button(tr("Fit"), tr("Everything in the window (0)"));
  connect(fit, &QToolButton::clicked, view_, &CloudView::fit);
  layout->addWidget(fit);
  return bar;
}

QWidget* CloudPage::makeSide() {
  view_->setAccessibleName(tr("Point cloud"));
  values_ = new QTextBrowser;
  values_->setObjectName("cloudValues");
  values_->setAccessibleName(tr("Values of the picked detection"));
  values_->setFrameShape(QFrame::NoFrame);
  values_->document()->setDocumentMargin(10);
  side_ = new QSplitter(Qt::Vertical);
  side_->setObjectName("cloudSide");
  side_->addWidget(values_);
  waveform_ = new WaveformView;
  side_->addWidget(waveform_);
  side_->setSizes({480, 300});
  return side_;
}

void CloudPage::connectParts() {
  connect(experiments_, &QComboBox::activated, this, [this] { openExperiment(chosen(experiments_)); });
  connect(models_, &QComboBox::activated, this, [this] { chooseModel(chosen(models_)); });
  connect(samples_, &QComboBox::currentIndexChanged, this, &CloudPage::showSample);
  connect(frames_, &QComboBox::currentIndexChanged, this, &CloudPage::showFrames);
  connect(frame_, &QSpinBox::valueChanged, this, &CloudPage::showFrames);
  connect(colour_, &QComboBox::currentIndexChanged, this,
          [this] { view_->setColourBy(ColourBy(colour_->currentData().toInt())); });
  connect(show_measured_, &QCheckBox::toggled, view_,
          [this](bool on) { view_->setVisible(CloudSource::Measured, on); });
  connect(show_simulated_, &QCheckBox::toggled, view_,
          [this](bool on) { view_->setVisible(CloudSource::Simulated, on); });
  connect(view_, &CloudView::pickChanged, this, &CloudPage::showPick);
  connect(&explainer_, &BeamExplainer::explained, this, [this](const model::BeamExplanation& beam) {
    const auto point = view_->picked();
    if (!point) return;
    waveform_->show(beam, cloud(point->source)->detections.range_m[point->index],
                    point->source == CloudSource::Measured ? CloudView::kMeasured : CloudView::kSimulated);
  });
  connect(&explainer_, &BeamExplainer::failed, waveform_, &WaveformView::clear);
  connect(&document_, &ProjectDocument::reset, this, &CloudPage::offerFilesOfProject);
  connect(&runner_, &SimulationRunner::progressed, this, [this](double fraction, const QString& doing) {
    progress_->setValue(int(fraction * 100));
    status_->setText(doing);
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
    status_->setText(tr("Cancelled"));
  });
  connect(&runner_, &SimulationRunner::failed, this, [this](const core::InputError& error) {
    showBusy(false);
    showError(this, error);
  });
}

// Files -------------------------------------------------------------------------------------------------------------

void CloudPage::offerFilesOfProject() {
  runner_.cancel();
  experiments_->clear();
  models_->clear();
  experiment_.reset();
  model_.clear();
  for (const specs::AcceptanceTest& test : document_.specification().tests) {
    if (!test.experiment.empty()) {
      std::filesystem::path file = document_.folder() / test.experiment;
      if (std::filesystem::is_directory(file)) file /= "experiment.json";
      if (std::filesystem::exists(file)) offer(experiments_, file);
    }
    const std::filesystem::path model = document_.folder() / test.model;
    if (!test.model.empty() && std::filesystem::exists(model)) offer(models_, model);
  }
  if (models_->count() > 0) chooseModel(chosen(models_));
  if (experiments_->count() > 0) {
    openExperiment(chosen(experiments_));
  } else {
    fillSamples();
  }
}

bool CloudPage::openExperiment(const std::filesystem::path& file) {
  const bool read = guarded(this, [&] { experiment_ = model::readExperiment(file); });
  if (!read) {
    experiments_->setCurrentIndex(
        experiment_ ? experiments_->findData(QString::fromStdString(experiment_->file.lexically_normal().string()))
                    : -1);
    return false;
  }
  experiments_->setCurrentIndex(offer(experiments_, experiment_->file));
  forgetSimulation();
  fillSamples();
  return true;
}

void CloudPage::chooseModel(const std::filesystem::path& file) {
  model_ = file;
  models_->setCurrentIndex(offer(models_, file));
  forgetSimulation();
  showSimulated();
}

void CloudPage::askForExperiment() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open an experiment package"), {},
                                                    tr("Experiments (experiment.json *.json);;All files (*)"));
  if (!file.isEmpty()) openExperiment(file.toStdString());
}

void CloudPage::askForModel() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a model"), {}, tr("Models (*.json);;All files (*)"));
  if (!file.isEmpty()) chooseModel(file.toStdString());
}

// What is shown -----------------------------------------------------------------------------------------------------

void CloudPage::fillSamples() {
  {
    const QSignalBlocker quiet(samples_);
    samples_->clear();
    if (experiment_) {
      for (const model::Sample& each : experiment_->samples) samples_->addItem(QString::fromStdString(each.id));
    }
  }
  showSample();
  view_->fit();
}

void CloudPage::showSample() {
  measured_.reset();
  if (experiment_ && sample() < experiment_->samples.size()) {
    const model::Sample& shown = experiment_->samples[sample()];
    guarded(this, [&] {
      if (!shown.measurements.empty()) {
        measured_ = std::make_shared<const PointCloud>(pointCloudOf(model::readMeasurements(*experiment_, shown)));
      }
    });
  }
  view_->setMessage(!experiment_ ? tr("Open an experiment package to see its detections.")
                    : measured_ && measured_->detections.size() > 0
                        ? tr("The directions of these detections were not recorded: they have no place in space.")
                        : tr("There are no detections in this sample. Simulate it to see what a model reports."));
  view_->setCloud(CloudSource::Measured, measured_);
  showSimulated();
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
  showPick();
}

void CloudPage::showStatus() {
  simulate_->setEnabled(experiment_ && !model_.empty());
  QString text;
  if (experiment_ && experiment_->synthetic()) text = tr("Synthetic data: made by a program, not measured.");
  status_->setText(text);
}

void CloudPage::showBusy(bool busy) {
  progress_->setVisible(busy);
  progress_->setValue(0);
  cancel_->setVisible(busy);
  simulate_->setVisible(!busy);
  if (busy) status_->setText(tr("Starting…"));
}

void CloudPage::forgetSimulation() {
  runner_.cancel();
  simulated_.clear();
}

void CloudPage::simulate() {
  if (runner_.isRunning() || !experiment_ || model_.empty()) return;
  simulated_.clear();
  showSimulated();
  showBusy(true);
  runner_.start(experiment_->file, model_, sample());
}

const PointCloud* CloudPage::cloud(CloudSource source) const {
  if (source == CloudSource::Measured) return measured_.get();
  const auto found = simulated_.find(sample());
  return found == simulated_.end() ? nullptr : found->second.get();
}

// The picked detection ----------------------------------------------------------------------------------------------

void CloudPage::showPick() {
  const auto point = view_->picked();
  values_->setHtml(point ? valuesOf(*point) + otherSideOf(*point)
                         : html::muted(tr("Click a point to see its values."), palette()));
  explainPick();
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
  explainer_.ask({.experiment = experiment_->file,
                  .model = model_,
                  .sample = sample(),
                  .frame = d.frame[point->index],
                  .layer = d.layer[point->index],
                  .azimuth_rad = d.azimuth_rad[point->index]});
}

QString CloudPage::valuesOf(const PickedPoint& point) const {
  const PointCloud& from = *cloud(point.source);
  const core::Detections& d = from.detections;
  const std::size_t i = point.index;
  QString text =
      html::heading(point.source == CloudSource::Measured ? tr("Measured detection") : tr("Simulated detection"));
  text += "<table>";
  text += row(tr("Sample"), html::text(experiment_->samples[sample()].id));
  text += row(tr("Frame"), QString::number(d.frame[i]));
  if (d.time_s.size() == d.size()) text += row(tr("Time in frame"), number(1e3 * d.time_s[i], 3, "ms"));
  text += row(tr("Layer"), QString::number(d.layer[i]));
  text += row(tr("Azimuth"), number(kDegrees * d.azimuth_rad[i], 3, "°"));
  text += row(tr("Elevation"), number(kDegrees * d.elevation_rad[i], 3, "°"));
  text += row(tr("Echo"), QString::number(d.echo[i]));
  text += row("<b>" + tr("Range") + "</b>", "<b>" + number(d.range_m[i], 3, "m") + "</b>");
  if (!d.epw_m.empty()) text += row(tr("Echo pulse width"), number(d.epw_m[i], 3, "m"));
  if (!d.intensity.empty()) text += row(tr("Intensity"), number(d.intensity[i], 2, "nW"));
  text += row("x", number(double(from.x[i]), 3, "m")) + row("y", number(double(from.y[i]), 3, "m")) +
          row("z", number(double(from.z[i]), 3, "m"));
  return text + "</table>";
}

QString CloudPage::otherSideOf(const PickedPoint& point) const {
  const bool measured = point.source == CloudSource::Measured;
  const PointCloud* other = cloud(measured ? CloudSource::Simulated : CloudSource::Measured);
  if (!other) return {};
  const PointCloud& own = *cloud(point.source);
  QString text = html::section(measured ? tr("The same beam, simulated") : tr("The same beam, measured"), palette());
  const auto there = sameBeam(*other, own, point.index);
  const auto here = sameBeam(own, own, point.index);
  if (!there || !here) return text + html::paragraph(tr("No detection with this echo number."));
  const bool one = there->count == 1 && here->count == 1;
  text +=
      html::muted(one ? tr("and its difference to the detection above")
                      : tr("means over all frames: %1 detections here, %2 there").arg(here->count).arg(there->count),
                  palette());
  text += "<table>" + row(tr("Range"), difference(there->range_m, here->range_m, 3, "m"));
  if (there->epw_m && here->epw_m) {
    text += row(tr("Echo pulse width"), difference(*there->epw_m, *here->epw_m, 3, "m"));
  }
  if (there->intensity_nw && here->intensity_nw) {
    text += row(tr("Intensity"), difference(*there->intensity_nw, *here->intensity_nw, 2, "nW"));
  }
  return text + "</table>";
}

}  // namespace desktop
