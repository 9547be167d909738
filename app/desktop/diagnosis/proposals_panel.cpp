#include "app/desktop/diagnosis/proposals_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QMessageBox>
#include <QSplitter>
#include <algorithm>

#include "app/desktop/colours.h"
#include "app/desktop/error_dialog.h"
#include "app/desktop/html.h"
#include "app/desktop/page_parts.h"
#include "proposals/decide.h"
#include "proposals/propose.h"

namespace desktop {

namespace {

QString scoreWord(const std::optional<int>& value) { return value ? QString::number(*value) : QObject::tr("none"); }

QString whatText(const specs::Proposal& proposal) {
  if (proposal.test) return QObject::tr("new acceptance test");
  if (proposal.before.value == proposal.occurrence) {
    return QObject::tr("occurrence stays %1").arg(*proposal.occurrence);
  }
  return QObject::tr("occurrence %1 → %2").arg(scoreWord(proposal.before.value)).arg(*proposal.occurrence);
}

QString aboutText(const specs::Proposal& proposal, const cepra::Table& table) {
  if (proposal.test) return QString::fromStdString(proposal.test->measurand + ": " + proposal.test->expression);
  const cepra::Row* row = table.find(proposal.row);
  return row ? QString::fromStdString(specs::rowTitle(*row)) : QObject::tr("(the row is gone)");
}

QString listOf(const std::vector<std::string>& ids) {
  QStringList links;
  for (const std::string& id : ids) {
    links << html::link("item:" + QString::fromStdString(id), QString::fromStdString(id));
  }
  return links.join("<br/>");
}

QString decisionText(const specs::Proposal& proposal) {
  QString text = QObject::tr("<b>%1</b> by %2 on %3")
                     .arg(wordFor(proposal.state), html::text(proposal.decided_by), html::text(proposal.decided_at));
  if (!proposal.reason.empty()) text += ": " + html::text(proposal.reason);
  return text;
}

QString detailsOf(const specs::Proposal& proposal, const ProjectDocument& document, const QPalette& palette) {
  QString page = html::heading(QString::fromStdString(proposal.id) + ": " + whatText(proposal));
  page += html::paragraph(html::text(aboutText(proposal, document.table()).toStdString()));
  const cepra::Row* row = document.table().find(proposal.row);
  if (!proposal.isOpen()) page += html::paragraph(decisionText(proposal));
  if (row && proposal.isOpen()) {
    if (const auto change = proposals::changeSince(proposal, *row)) {
      page += html::paragraph("<b>" + QObject::tr("Changed since this was proposed") + "</b>: " + html::text(*change));
    }
  }
  page += html::section(QObject::tr("Evidence"), palette) + html::paragraph(html::text(proposal.rationale));
  if (proposal.test) {
    page += html::section(QObject::tr("The test"), palette) + html::paragraph(html::text(proposal.test->text));
  }
  const auto requirements = proposal.test
                                ? proposal.requirements
                                : proposals::requirementsFor({proposal.row}, proposal.cause, document.specification());
  if (!requirements.empty()) {
    page +=
        html::section(proposal.test ? QObject::tr("It verifies") : QObject::tr("Requirements of this row"), palette) +
        html::paragraph(listOf(requirements));
  }
  if (row && row->impact.value) {
    page += html::section(QObject::tr("Impact, not touched"), palette) + html::paragraph(scoreWord(row->impact.value));
  }
  page += html::section(QObject::tr("Report"), palette) +
          html::paragraph(html::text(std::filesystem::path(proposal.report).filename().string()) + "<br/>" +
                          html::muted("SHA-256 " + html::text(proposal.report_sha256.substr(0, 16)) + "…", palette));
  return page;
}

}  // namespace

ProposalsPanel::ProposalsPanel(ProjectDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      count_(new QLabel),
      table_(new QTableWidget(0, 3)),
      details_(textPane(tr("Evidence of the proposal"), 8)),
      accept_(new QPushButton(tr("&Accept"))),
      dismiss_(new QPushButton(tr("&Dismiss…"))),
      show_row_(new QPushButton(tr("Show &row"))) {
  table_->setAccessibleName(tr("Proposals"));
  table_->setHorizontalHeaderLabels({tr("State"), tr("Proposed"), tr("For")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(true);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setStretchLastSection(true);
  accept_->setToolTip(tr("Write the occurrence and its evidence into the row, or add the test for review (undoable)"));
  dismiss_->setToolTip(tr("Set the proposal aside; you are asked why, and it is kept in the history"));
  show_row_->setToolTip(tr("The row in the relevance table"));
  count_->setMargin(6);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(6, 6, 6, 6);
  buttons->setSpacing(6);
  for (QPushButton* button : {accept_, dismiss_, show_row_}) buttons->addWidget(button);
  buttons->addStretch(1);
  auto* lower = new QWidget;
  auto* lower_layout = seamlessColumn(lower);
  lower_layout->addLayout(buttons);
  lower_layout->addWidget(details_, 1);
  auto* splitter = new QSplitter(Qt::Vertical);
  splitter->setObjectName("proposalsSplitter");
  splitter->addWidget(table_);
  splitter->addWidget(lower);
  splitter->setSizes({240, 520});
  auto* layout = seamlessColumn(this);
  layout->addWidget(count_);
  layout->addWidget(splitter, 1);

  connect(table_, &QTableWidget::currentCellChanged, this, &ProposalsPanel::showDetails);
  connect(accept_, &QPushButton::clicked, this, &ProposalsPanel::acceptCurrent);
  connect(dismiss_, &QPushButton::clicked, this, &ProposalsPanel::askAndDismissCurrent);
  connect(show_row_, &QPushButton::clicked, this, &ProposalsPanel::showRow);
  connect(table_, &QTableWidget::cellActivated, this, &ProposalsPanel::showRow);
  connect(details_, &QTextBrowser::anchorClicked, this, &ProposalsPanel::followLink);
  connect(&document_, &ProjectDocument::reset, this, [this] { showEvidence(""); });
  connect(&document_, &ProjectDocument::proposalsChanged, this, &ProposalsPanel::fill);
  connect(&document_, &ProjectDocument::rowsChanged, this, &ProposalsPanel::showDetails);
  fill();
}

void ProposalsPanel::showEvidence(const std::string& evidence) {
  evidence_ = evidence;
  table_->setCurrentCell(-1, -1);
  fill();
}

const specs::Proposal* ProposalsPanel::current() const {
  const QTableWidgetItem* item = table_->item(table_->currentRow(), 0);
  if (!item) return nullptr;
  return specs::findProposal(document_.specification().proposals, item->data(Qt::UserRole).toString().toStdString());
}

void ProposalsPanel::fill() {
  const int before = table_->currentRow();
  int open = 0;
  {
    const QSignalBlocker quiet(table_);
    table_->setRowCount(0);
    for (const specs::Proposal& proposal : document_.specification().proposals) {
      if (!evidence_.empty() && proposal.evidence != evidence_) continue;
      const int row = table_->rowCount();
      table_->insertRow(row);
      auto* state = new QTableWidgetItem(iconOf(proposal.state), wordFor(proposal.state));
      state->setData(Qt::UserRole, QString::fromStdString(proposal.id));
      table_->setItem(row, 0, state);
      table_->setItem(row, 1, new QTableWidgetItem(whatText(proposal)));
      table_->setItem(row, 2, new QTableWidgetItem(aboutText(proposal, document_.table())));
      for (int column = 0; column < 3; ++column) {
        table_->item(row, column)->setToolTip(table_->item(row, column)->text());
      }
      open += proposal.isOpen();
    }
    table_->resizeColumnToContents(0);
    table_->resizeColumnToContents(1);
    table_->resizeRowsToContents();
    if (table_->rowCount() > 0) table_->setCurrentCell(std::clamp(before, 0, table_->rowCount() - 1), 0);
  }
  const QString whose = evidence_.empty() ? tr("of the project") : tr("of this report");
  count_->setText(table_->rowCount() == 0
                      ? tr("<b>Proposals</b>: none %1 yet").arg(whose)
                      : tr("<b>Proposals</b> %1: %2, %3 open").arg(whose).arg(table_->rowCount()).arg(open));
  showDetails();
}

void ProposalsPanel::showDetails() {
  const specs::Proposal* proposal = current();
  const bool open = proposal && proposal->isOpen() && !document_.readOnly();
  accept_->setEnabled(open);
  dismiss_->setEnabled(open);
  show_row_->setEnabled(proposal && !proposal->test && document_.table().find(proposal->row));
  details_->setHtml(proposal
                        ? detailsOf(*proposal, document_, palette())
                        : html::paragraph(html::muted(
                              tr("<b>Propose</b> asks what the open diagnosis means for the relevance table: how "
                                 "often the effect occurs, and a test that would have caught it. Nothing is written "
                                 "until you accept it."),
                              palette())));
}

void ProposalsPanel::acceptCurrent() {
  const specs::Proposal* proposal = current();
  if (!proposal) return;
  guarded(this, [&] {
    if (!proposal->test) {
      const auto change = proposals::changeSince(*proposal, proposals::rowFor(*proposal, document_.table()));
      if (change &&
          QMessageBox::question(this, tr("Accept"),
                                tr("The row has changed since this was proposed:\n%1.\n\nAccept all the same?")
                                    .arg(QString::fromStdString(*change)),
                                QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel) != QMessageBox::Yes) {
        return;
      }
    }
    document_.acceptProposal(proposal->id);
  });
}

void ProposalsPanel::askAndDismissCurrent() {
  if (!current()) return;
  bool given = false;
  const QString reason =
      QInputDialog::getText(this, tr("Dismiss"), tr("Why does this evidence not count? It is kept in the history."),
                            QLineEdit::Normal, {}, &given);
  if (given) dismissCurrent(reason);
}

void ProposalsPanel::dismissCurrent(const QString& reason) {
  const specs::Proposal* proposal = current();
  if (proposal) guarded(this, [&] { document_.dismissProposal(proposal->id, reason.toStdString()); });
}

void ProposalsPanel::showRow() {
  const specs::Proposal* proposal = current();
  if (proposal && !proposal->test) emit rowRequested(QString::fromStdString(proposal->row));
}

void ProposalsPanel::followLink(const QUrl& url) {
  if (url.scheme() == "item") emit itemRequested(url.path());
}

void ProposalsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showDetails();
}

}  // namespace desktop
