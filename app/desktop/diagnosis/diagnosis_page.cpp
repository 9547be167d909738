#include "app/desktop/diagnosis/diagnosis_page.h"

#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QSplitter>

#include "app/cli/signature.h"
#include "app/desktop/diagnosis/diagnosis_text.h"
#include "app/desktop/error_dialog.h"
#include "app/desktop/file_list.h"

namespace desktop {

namespace {

/// Whether a model is a command or a recording; a file that cannot be read is complained of when it is diagnosed.
bool isForeign(const std::filesystem::path& model) {
  try {
    return !model.empty() && model::readModel(model).external;
  } catch (const core::InputError&) {
    return false;
  }
}

QComboBox* fileList(const QString& name, const QString& tip) {
  auto* list = new QComboBox;
  list->setAccessibleName(name);
  list->setToolTip(tip);
  list->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  return list;
}

}  // namespace

DiagnosisPage::DiagnosisPage(ProjectDocument& document, std::function<bool()> save, QWidget* parent)
    : QWidget(parent),
      document_(document),
      save_(std::move(save)),
      text_(textPane(tr("Diagnosis"), 14)),
      panel_(new ProposalsPanel(document)) {
  auto* splitter = new QSplitter;
  splitter->setObjectName("diagnosisSplitter");
  splitter->addWidget(text_);
  splitter->addWidget(panel_);
  splitter->setSizes({860, 580});
  auto* layout = seamlessColumn(this);
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
  diagnose_ = toolButton(tr("Diagnose"),
                         tr("Where does the simulation differ, which cause explains it, how far does the gap shrink?"));
  open_ = toolButton(tr("Open report…"), tr("A report that 'fidelis gap --json' wrote"));
  propose_ =
      toolButton(tr("Propose"), tr("What the open diagnosis means for the relevance table and the specification"));
  status_ = new WorkStatus(runner_, tr("Progress of the diagnosis"), tr("Stop; nothing of it is stored"));
  auto* experiment_label = new QLabel(tr("&Experiment"));
  experiment_label->setBuddy(experiments_);
  auto* model_label = new QLabel(tr("&Model"));
  model_label->setBuddy(models_);
  proxy_label_ = new QLabel(tr("Pro&xy"));
  proxy_label_->setBuddy(proxies_);
  for (QWidget* widget : std::initializer_list<QWidget*>{experiment_label, experiments_, model_label, models_,
                                                         proxy_label_, proxies_, diagnose_, open_}) {
    layout->addWidget(widget);
  }
  layout->addWidget(status_, 1);
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
  return bar;
}

void DiagnosisPage::connectRunner() {
  connect(&runner_, &DiagnosisRunner::diagnosed, this, [this](const std::filesystem::path& report) {
    if (document_.file() == running_on_) openReport(report);
  });
  connect(&runner_, &DiagnosisRunner::proposed, this, [this](const proposals::Proposed& proposed) {
    if (document_.file() == running_on_) guarded(this, [&] { store(proposed); });
  });
  connect(&runner_, &DiagnosisRunner::failed, this, [this](const core::InputError& error) { showError(this, error); });
  connect(&runner_, &DiagnosisRunner::runningChanged, this, &DiagnosisPage::enableButtons);
}

void DiagnosisPage::offerFilesOfProject() {
  for (QComboBox* list : {experiments_, models_, proxies_}) {
    list->clear();
    if (list == proxies_) list->addItem(tr("Default"), QString());
    addFileQuestion(list, tr("Choose…"));
  }
  const auto& tests = document_.specification().tests;
  // The newest verdict that failed is what somebody wants to understand.
  int first = -1;
  for (const specs::AcceptanceTest& test : tests) {
    const TestFiles files = filesOf(test, document_);
    if (!files.experiment.empty()) {
      const int place = offerFile(experiments_, files.experiment);
      const auto verdict = document_.specification().verdicts.find(test.id);
      const bool failed =
          verdict != document_.specification().verdicts.end() && verdict->second.verdict == specs::Verdict::Failed;
      if (failed && first < 0) first = place;
    }
    if (files.model.empty()) continue;
    const int known = models_->count();
    offerFile(models_, files.model);
    if (models_->count() > known && !isForeign(files.model)) offerFile(proxies_, files.model);
  }
  experiments_->setCurrentIndex(std::max(first, 0));
  models_->setCurrentIndex(0);
  proxies_->setCurrentIndex(0);
  showProxies();
  enableButtons();
}

void DiagnosisPage::showProxies() {
  const bool foreign = isForeign(chosenFile(models_));
  proxy_label_->setVisible(foreign);
  proxies_->setVisible(foreign);
}

void DiagnosisPage::chooseFrom(QComboBox* list, const QString& title, const QString& filter) {
  if (asksForFile(list)) {
    const QString file =
        QFileDialog::getOpenFileName(this, title, QString::fromStdString(document_.folder().string()), filter);
    list->setCurrentIndex(file.isEmpty() ? 0 : offerFile(list, file.toStdString()));
  }
  enableButtons();
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
  status_->tell(QString::fromStdString(file.filename().string()), QString::fromStdString(file.string()));
  showReport();
  return true;
}

void DiagnosisPage::diagnose() {
  if (runner_.isRunning() || chosenFile(experiments_).empty() || chosenFile(models_).empty() || !save_()) return;
  running_on_ = document_.file();
  runner_.diagnose({.experiment = chosenFile(experiments_),
                    .model = chosenFile(models_),
                    .proxy = proxies_->isHidden() ? std::filesystem::path() : chosenFile(proxies_),
                    .project = running_on_,
                    .report = document_.reportFile("gap-" + app::signatureOf("").when + ".json")});
}

void DiagnosisPage::propose() {
  if (runner_.isRunning() || !report_ || !save_()) return;
  running_on_ = document_.file();
  runner_.propose({*report_, document_.specification(), document_.graph(), document_.folder()});
}

void DiagnosisPage::store(const proposals::Proposed& proposed) {
  const std::size_t added = document_.addProposals(proposed.proposals);
  QString told = tr("%1 proposed").arg(added);
  if (added < proposed.proposals.size()) {
    told += tr(", %1 known from this report already").arg(proposed.proposals.size() - added);
  }
  for (const std::string& note : proposed.notes) told += "; " + QString::fromStdString(note);
  status_->tell(told);
}

void DiagnosisPage::showText() {
  text_->setHtml(report_ ? diagnosisText(*report_, palette()) : diagnosisHint(experiments_->count() > 1, palette()));
}

void DiagnosisPage::showReport() {
  showText();
  panel_->showEvidence(report_ ? report_->evidence : "");
  enableButtons();
}

void DiagnosisPage::enableButtons() {
  const bool busy = runner_.isRunning();
  open_->setEnabled(!busy);
  diagnose_->setEnabled(!busy && !chosenFile(experiments_).empty() && !chosenFile(models_).empty());
  propose_->setEnabled(!busy && report_ && !document_.readOnly());
}

void DiagnosisPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && text_) showText();
}

}  // namespace desktop
