// How the point cloud tab is put together; cloud_page.cpp says what it does.
#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/desktop/cloud/cloud_page.h"
#include "app/desktop/page_parts.h"

namespace desktop {

namespace {

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

/// A spin box and the line edit in it, which speaks for itself.
void name(QSpinBox* box, const QString& text) {
  box->setAccessibleName(text);
  box->findChild<QLineEdit*>()->setAccessibleName(text);
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
      point_size_(new QSpinBox),
      view_(new CloudView) {
  auto* splitter = new QSplitter;
  splitter->setObjectName("cloudSplitter");
  splitter->addWidget(view_);
  splitter->addWidget(makeSide());
  splitter->setSizes({1120, 320});
  splitter->setStretchFactor(0, 1);
  auto* layout = seamlessColumn(this);
  layout->addWidget(makeSourceBar());
  layout->addWidget(makeViewBar());
  layout->addWidget(splitter, 1);
  samples_->setObjectName("cloudSamples");
  show_simulated_->setObjectName("cloudSimulated");
  frames_->setObjectName("cloudFrames");
  colour_->setObjectName("cloudColour");
  show_silent_->setObjectName("cloudSilent");
  point_size_->setObjectName("cloudPointSize");
  copy_->setObjectName("cloudCopy");
  connectParts();
  connectThreads();
  showBusy(false);
  offerFilesOfProject();
}

QWidget* CloudPage::makeSourceBar() {
  auto* bar = new QWidget;
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 6, 8, 3);
  auto* open_experiment = toolButton(tr("Open…"), tr("An experiment package from elsewhere"));
  auto* open_model = toolButton(tr("Open…"), tr("A model file from elsewhere"));
  simulate_ = toolButton(tr("Simulate"), tr("Simulate this experiment with the model, this sample first"));
  cancel_ = toolButton(tr("Cancel"), tr("Stop; what is simulated already stays"));
  progress_ = new QProgressBar;
  progress_->setAccessibleName(tr("Progress of the simulation"));
  progress_->setFixedWidth(140);
  status_ = new QLabel;
  status_->setObjectName("cloudStatus");
  status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long name does not widen the window
  experiments_->setToolTip(tr("Experiment packages of the project's acceptance tests, and opened ones"));
  samples_->setToolTip(tr("One configuration of the experiment; its frames are repetitions"));
  models_->setToolTip(tr("Models of the project's acceptance tests, and opened ones"));
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
  for (QWidget* widget : std::initializer_list<QWidget*>{open_model, simulate_, progress_, cancel_}) {
    layout->addWidget(widget);
  }
  layout->addWidget(status_, 1);
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
  show_measured_->setToolTip(tr("Detections of the sample's measurement file, as squares"));
  show_simulated_->setToolTip(tr("Detections of the model, as crosses; Simulate makes them"));
  show_silent_ = new QCheckBox(tr("No detection"));
  show_silent_->setIcon(patch(CloudView::kSilent));
  show_silent_->setToolTip(
      tr("Beams from which the model reports nothing, where their light is lost; click one to see why.\n"
         "Of the chosen frame, or the first one"));
  for (QCheckBox* check : {show_measured_, show_simulated_, show_silent_}) {
    check->setChecked(check != show_silent_);
    layout->addWidget(check);
  }
  layout->addSpacing(12);
  auto* colour_label = new QLabel(tr("Colour by"));
  colour_label->setBuddy(colour_);
  layout->addWidget(colour_label);
  colour_->setToolTip(tr("What the colour of a point tells; the range difference is that of the same beam and echo"));
  for (const ColourBy by : {ColourBy::Source, ColourBy::Range, ColourBy::Intensity, ColourBy::EchoPulseWidth,
                            ColourBy::Layer, ColourBy::Echo, ColourBy::Difference}) {
    colour_->addItem(wordFor(by), int(by));
  }
  layout->addWidget(colour_);
  layout->addSpacing(12);
  auto* size_label = new QLabel(tr("Size"));
  size_label->setBuddy(point_size_);
  layout->addWidget(size_label);
  point_size_->setRange(0, 15);
  point_size_->setSpecialValueText(tr("auto"));
  point_size_->setSuffix(tr(" px"));
  point_size_->setToolTip(tr("Size of a point; auto: the fewer, the larger"));
  name(point_size_, tr("Size of the points"));
  layout->addWidget(point_size_);
  layout->addSpacing(12);
  frames_->setToolTip(tr("All frames over each other, or one"));
  frames_->addItems({tr("All frames"), tr("Frame")});
  frame_->setToolTip(tr("Number of the frame, from 0"));
  name(frame_, tr("Number of the frame"));
  layout->addWidget(frames_);
  layout->addWidget(frame_);
  layout->addStretch(1);
  using Look = CloudView::Look;
  for (const auto& [look, text, tip] :
       {std::tuple(Look::Perspective, tr("Perspective"), tr("From behind the sensor, from above (1)")),
        std::tuple(Look::Top, tr("Top"), tr("From above, true to scale; x is up (2)")),
        std::tuple(Look::Side, tr("Side"), tr("From the right, true to scale (3)")),
        std::tuple(Look::Sensor, tr("Front"), tr("Along x, as the sensor looks, true to scale (4)"))}) {
    auto* made = toolButton(text, tip);
    connect(made, &QToolButton::clicked, view_, [this, look = look] { view_->look(look); });
    layout->addWidget(made);
  }
  auto* fit = toolButton(tr("Fit"), tr("Everything in the window (0)"));
  connect(fit, &QToolButton::clicked, view_, &CloudView::fit);
  layout->addWidget(fit);
  return bar;
}

QWidget* CloudPage::makeSide() {
  view_->setAccessibleName(tr("Point cloud"));
  copy_ = toolButton(tr("Copy"), tr("The values as text (Ctrl+C in the picture)"));
  values_ = new QTextBrowser;
  values_->setObjectName("cloudValues");
  values_->setAccessibleName(tr("Values of the picked detection"));
  values_->setFrameShape(QFrame::NoFrame);
  values_->document()->setDocumentMargin(10);
  side_ = new QSplitter(Qt::Vertical);
  side_->setObjectName("cloudSide");
  auto* top = new QWidget;
  top->setBackgroundRole(QPalette::Base);
  top->setAutoFillBackground(true);
  auto* layout = new QVBoxLayout(top);
  layout->setContentsMargins(0, 4, 4, 0);
  layout->setSpacing(0);
  layout->addWidget(values_, 1);
  layout->addWidget(copy_, 0, Qt::AlignRight);
  side_->addWidget(top);
  waveform_ = new WaveformView;
  side_->addWidget(waveform_);
  side_->setSizes({480, 300});
  return side_;
}

}  // namespace desktop
