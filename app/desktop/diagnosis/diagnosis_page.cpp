#include "app/desktop/diagnosis/diagnosis_page.h"

#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/cli/signature.h"
#include "app/desktop/diagnosis/diagnosis_text.h"
#include "app/desktop/error_dialog.h"

namespace desktop {

namespace {

constexpr const char* kOther = "other";  // data of the entry that asks for a file

QToolButton* button(const QString& text, const QString& tip) {
  auto* made = new QToolButton;
  made->setText(text);
  made->setToolTip(tip);
  return made;
}

QComboBox* fileList(const QString& name, const QString& tip) {
  auto* list = new QComboBox;
  list->setAccessibleName(name);
  list->setToolTip(tip);
  list->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  return list;
}

/// Adds a file once, before the entry that asks for another, and returns its place.
int offer(QComboBox* list, const std::filesystem::path& file, const QString& title) {
  const QString path = QString::fromStdString(file.lexically_normal().string());
  if (const int known = list->findData(path); known >= 0) return known;
  const int place = std::max(0, list->findData(kOther));
  list->insertItem(place, title, path);
  list->setItemData(place, path, Qt::ToolTipRole);
  return place;
}

QString experimentTitle(std::filesystem::path file) {
  if (file.filename() == "experiment.json" || file.filename().empty()) file = file.parent_path();
  return QString::fromStdString(file.filename().string());
}

std::filesystem::path chosen(const QComboBox* list) {
  const QString data = list->currentData().toString();
  return data == kOther ? std::filesystem::path() : std::filesystem::path(data.toStdString());
}

/// Whether a model is a command or a recording; a file that cannot be read is complained of when it is diagnosed.
bool isForeign(const std::filesystem::path& model) {
  try {
    return !model.empty() && model::readModel(model).external;
  } catch (const core::InputError&) {
    return false;
  }
}

/// A file name from a time: "gap-2026-01-02T030405Z.json".
std::string reportName() {
  std::string when = app::signatureOf("").when;
  std::erase(when, ':');
  return "gap-" + when + ".json";
}

}  // namespace

DiagnosisPage::DiagnosisPage(ProjectDocument& document, std::function<bool()> save, QWidget* parent)
    : QWidget(parent),
      document_(document),
      save_(std::move(save)),
      text_(new QTextBrowser),
      panel_(new ProposalsPanel(document)) {
  text_->setAccessibleName(tr("Diagnosis"));
  text_->setOpenLinks(false);
  text_->document()->setDocumentMargin(14);
  auto* splitter = new QSplitter;
  splitter->setObjectName("diagnosisSplitter");
  splitter->addWidget(text_);
  splitter->addWidget(panel_);
  splitter->setSizes({860, 580});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeBar());
  layout->addWidget(splitter, 1);
  connectRunner();
  connect(text_, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
    if (url.scheme() == "test") emit testRequested(url.path());
  });
  connect(panel_, &ProposalsPanel::rowRequested, this, &DiagnosisPage::rowRequested);
  connect(panel_, &ProposalsPanel::itemRequested, this, &DiagnosisPage::itemRequested);
  connect(&document_, &ProjectDocument::reset, this, [this] {
    if (document_.file() != running_on_) runner_.cancel();
    report_.reset();
    offerFilesOfProject();
    showReport();
  });
  showBusy(false);
  offerFilesOfProject();
  showReport();
}

QWidget* DiagnosisPage::makeBar() {
  auto* bar = new QWidget;
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 6, 8, 6);
  experiments_ = fileList(tr("Experiment"), tr("Experiments of the project's acceptance tests, or another"));
  models_ = fileList(tr("Model"), tr("Models of the project's acceptance tests, or another"));
  proxies_ = fileList(tr("Proxy"),
                      tr("The built-in model in which effects are switched and fitted, for one that is a command or a "
                         "recording.\nDefault: what its file names as proxy, or the experiment's sensor"));
  diagnose_ = button(tr("Diagnose"),
                     tr("Where does the simulation differ, which cause explains it, how far does the gap shrink?"));
  open_ = button(tr("Open report…"), tr("A report that 'fidelis gap --json' wrote"));
  propose_ = button(tr("Propose"), tr("What the open diagnosis means for the relevance table and the specification"));
  cancel_ = button(tr("Cancel"), tr("Stop; nothing of it is stored"));
  progress_ = new QProgressBar;
  progress_->setAccessibleName(tr("Progress of the diagnosis"));
  progress_->setFixedWidth(200);
  doing_ = new QLabel;
  doing_->setObjectName("diagnosisDoing");
  auto* experiment_label = new QLabel(tr("&Experiment"));
  experiment_label->setBuddy(experiments_);
  auto* model_label = new QLabel(tr("&Model"));
  model_label->setBuddy(models_);
  proxy_label_ = new QLabel(tr("Pro&xy"));
  proxy_label_->setBuddy(proxies_);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{experiment_label, experiments_, model_label, models_, proxy_label_, proxies_,
                                       diagnose_, open_, cancel_, progress_, doing_}) {
    layout->addWidget(widget);
  }
  layout->addStretch(1);
  layout->addWidget(propose_);
  connect(experiments_, &QComboBox::activated, this, [this] {
    chooseFrom(experiments_, tr("Choose an experiment"), tr("Experiments (experiment.json);;All files (*)"));
  });
  connect(models_, &QComboBox::activated, this,
          [this] { chooseFrom(models_, tr("Choose a model"), tr("Models (*.json);;All files (*)")); });
  connect(models_, &QComboBox::currentIndexChanged, this, &DiagnosisPage::showProxies);
  connect(proxies_, &QComboBox::activated, this,
          [this] { chooseFrom(proxies_, tr("Choose a proxy"), tr("Models (*.json);;All files (*)")); });
  connect(diagnose_, &QToolButton::clicked, this, &DiagnosisPage::diagnose);
  connect(open_, &QToolButton::clicked, this, &DiagnosisPage::askAndOpen);
  connect(propose_, &QToolButton::clicked, this, &DiagnosisPage::propose);
  connect(cancel_, &QToolButton::clicked, this, &DiagnosisPage::cancel);
  return bar;
}

void DiagnosisPage::connectRunner() {
  connect(&runner_, &DiagnosisRunner::progressed, this, [this](double fraction, const QString& doing) {
    progress_->setValue(int(fraction * 100));
    doing_->setText(doing);
  });
  connect(&runner_, &DiagnosisRunner::diagnosed, this, [this](const std::filesystem::path& report) {
    showBusy(false);
    if (document_.file() == running_on_) openReport(report);
  });
  connect(&runner_, &DiagnosisRunner::proposed, this, [this](const proposals::Proposed& proposed) {
    showBusy(false);
    if (document_.file() == running_on_) guarded(this, [&] { store(proposed); });
  });
  connect(&runner_, &DiagnosisRunner::failed, this, [this](const core::InputError& error) {
    showBusy(false);
    showError(this, error);
  });
  connect(&runner_, &DiagnosisRunner::cancelled, this, [this] {
    showBusy(false);
    doing_->setText(tr("Cancelled; nothing was stored."));
  });
}

void DiagnosisPage::offerFilesOfProject() {
  for (QComboBox* list : {experiments_, models_, proxies_}) {
    list->clear();
    if (list == proxies_) list->addItem(tr("Default"), QString());
    list->addItem(tr("Choose…"), kOther);
  }
  const auto& tests = document_.specification().tests;
  // The newest verdict that failed is what somebody wants to understand.
  int first = -1;
  for (const specs::AcceptanceTest& test : tests) {
    const std::filesystem::path experiment = document_.folder() / test.experiment;
    const std::filesystem::path model = document_.folder() / test.model;
    if (!test.experiment.empty() && std::filesystem::exists(experiment)) {
      const int place = offer(experiments_, experiment, experimentTitle(experiment));
      const auto verdict = document_.specification().verdicts.find(test.id);
      const bool failed =
          verdict != document_.specification().verdicts.end() && verdict->second.verdict == specs::Verdict::Failed;
      if (failed && first < 0) first = place;
    }
    if (!test.model.empty() && std::filesystem::exists(model)) {
      offer(models_, model, QString::fromStdString(model.filename().string()));
    }
  }
  for (int i = 0; i < models_->count(); ++i) {
    const std::filesystem::path model = models_->itemData(i).toString().toStdString();
    if (model != kOther && !isForeign(model)) offer(proxies_, model, models_->itemText(i));
  }
  experiments_->setCurrentIndex(std::max(first, 0));
  models_->setCurrentIndex(0);
  proxies_->setCurrentIndex(0);
  showProxies();
  showBusy(runner_.isRunning());
}

void DiagnosisPage::showProxies() {
  const bool foreign = isForeign(chosen(models_));
  proxy_label_->setVisible(foreign);
  proxies_->setVisible(foreign);
}

void DiagnosisPage::chooseFrom(QComboBox* list, const QString& title, const QString& filter) {
  if (list->currentData().toString() == kOther) {
    const QString file =
        QFileDialog::getOpenFileName(this, title, QString::fromStdString(document_.folder().string()), filter);
    const std::filesystem::path path = file.toStdString();
    const QString shown =
        list == experiments_ ? experimentTitle(path) : QString::fromStdString(path.filename().string());
    list->setCurrentIndex(file.isEmpty() ? 0 : offer(list, path, shown));
  }
  showBusy(runner_.isRunning());
}

void DiagnosisPage::askAndOpen() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open a gap report"), QString::fromStdString(document_.folder().string()),
                                   tr("Gap reports (*.json);;All files (*)"));
  if (!file.isEmpty()) openReport(file.toStdString());
}

bool DiagnosisPage::openReport(const std::filesystem::path& file) {
  const bool read = guarded(this, [&] { report_ = proposals::readGapReport(file); });
  if (!read) return false;
  doing_->setText(QString::fromStdString(file.filename().string()));
  doing_->setToolTip(QString::fromStdString(file.string()));
  showReport();
  return true;
}

void DiagnosisPage::diagnose() {
  if (runner_.isRunning() || chosen(experiments_).empty() || chosen(models_).empty() || !save_()) return;
  running_on_ = document_.file();
  showBusy(true);
  runner_.diagnose({.experiment = chosen(experiments_),
                    .model = chosen(models_),
                    .proxy = proxies_->isHidden() ? std::filesystem::path() : chosen(proxies_),
                    .project = running_on_,
                    .report = document_.folder() / "reports" / reportName()});
}

void DiagnosisPage::propose() {
  if (runner_.isRunning() || !report_ || !save_()) return;
  running_on_ = document_.file();
  showBusy(true);
  runner_.propose({*report_, document_.specification(), document_.graph(), document_.folder()});
}

void DiagnosisPage::store(const proposals::Proposed& proposed) {
  const std::size_t added = document_.addProposals(proposed.proposals);
  QString told = tr("%1 proposed").arg(added);
  if (added < proposed.proposals.size()) {
    told += tr(", %1 known from this report already").arg(proposed.proposals.size() - added);
  }
  for (const std::string& note : proposed.notes) told += "; " + QString::fromStdString(note);
  doing_->setText(told);
  doing_->setToolTip(told);
}

void DiagnosisPage::showReport() {
  text_->setHtml(report_ ? diagnosisText(*report_, palette()) : diagnosisHint(experiments_->count() > 1, palette()));
  panel_->showEvidence(report_ ? report_->evidence : "");
  showBusy(runner_.isRunning());
}

void DiagnosisPage::showBusy(bool busy) {
  progress_->setVisible(busy);
  cancel_->setVisible(busy);
  if (!busy) progress_->setValue(0);
  open_->setEnabled(!busy);
  diagnose_->setEnabled(!busy && !chosen(experiments_).empty() && !chosen(models_).empty());
  propose_->setEnabled(!busy && report_ && !document_.readOnly());
}

void DiagnosisPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && text_) {
    text_->setHtml(report_ ? diagnosisText(*report_, palette()) : diagnosisHint(experiments_->count() > 1, palette()));
  }
}

}  // namespace desktop
