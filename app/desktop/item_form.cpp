#include "app/desktop/item_form.h"

#include <QComboBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

#include "core/error.h"

namespace desktop {

namespace {

template <class Enum>
QStringList namesOf(std::initializer_list<Enum> values) {
  QStringList names;
  for (const Enum value : values) {
    names << QString::fromUtf8(specs::name(value).data(), qsizetype(specs::name(value).size()));
  }
  return names;
}

QStringList choicesOf(const std::string& field) {
  using specs::Level;
  using specs::Status;
  if (field == "status") return namesOf({Status::UnderReview, Status::Accepted, Status::Rejected});
  if (field == "level") return namesOf({Level::General, Level::ObjectModel, Level::DetectionModel});
  return {};
}

/// Lines that a field shows; 1: a line edit.
int linesOf(const std::string& field) {
  if (field == "text" || field == "rationale") return 4;
  return field == "conditions" || field == "effects" ? 2 : 1;
}

/// Half a value would be refused while it is typed.
bool takenWhenLeft(const std::string& field) { return field == "id" || field == "frames" || field == "options"; }

QString valueOf(const QWidget* editor) {
  if (const auto* line = qobject_cast<const QLineEdit*>(editor)) return line->text();
  if (const auto* lines = qobject_cast<const QPlainTextEdit*>(editor)) return lines->toPlainText();
  if (const auto* choice = qobject_cast<const QComboBox*>(editor)) return choice->currentText();
  return {};
}

void setValue(QWidget* editor, const QString& value) {
  const QSignalBlocker quiet(editor);
  if (valueOf(editor) == value) return;
  if (auto* line = qobject_cast<QLineEdit*>(editor)) {
    line->setText(value);
    line->setCursorPosition(0);
  } else if (auto* lines = qobject_cast<QPlainTextEdit*>(editor)) {
    lines->setPlainText(value);
  } else if (auto* choice = qobject_cast<QComboBox*>(editor)) {
    choice->setCurrentText(value);
  }
}

}  // namespace

ItemForm::ItemForm(ProjectDocument& document, QWidget* parent) : QScrollArea(parent), document_(document) {
  setWidgetResizable(true);
  setFrameShape(NoFrame);
}

QWidget* ItemForm::editor(const std::string& field) const {
  const auto found = editors_.find(field);
  return found == editors_.end() ? nullptr : found->second;
}

void ItemForm::showItem(const std::string& id) {
  id_ = id;
  editors_.clear();
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  message_ = new QLabel;
  message_->setWordWrap(true);
  message_->hide();
  if (const auto item = document_.item(id)) {
    for (const ItemField& field : fieldsOf(*item)) {
      QWidget* editor = makeEditor(field);
      editor->setAccessibleName(QString::fromStdString(field.title));
      editor->setEnabled(!document_.readOnly());
      form->addRow(QString::fromStdString(field.title), editor);
      editors_[field.name] = editor;
    }
    refresh();
  }
  form->addRow(message_);
  auto* rest = new QWidget;  // takes the height that is left, so that the fields stay together
  rest->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  form->addRow(rest);
  setWidget(page);
}

QWidget* ItemForm::makeEditor(const ItemField& field) {
  const std::string name = field.name;
  if (const QStringList choices = choicesOf(name); !choices.isEmpty()) {
    auto* choice = new QComboBox;
    choice->addItems(choices);
    connect(choice, &QComboBox::textActivated, this, [this, name](const QString& text) { take(name, text); });
    return choice;
  }
  if (linesOf(name) > 1) {
    auto* lines = new QPlainTextEdit;
    lines->setTabChangesFocus(true);
    lines->setFixedHeight(lines->fontMetrics().lineSpacing() * linesOf(name) + 14);
    connect(lines, &QPlainTextEdit::textChanged, this, [this, name, lines] { take(name, lines->toPlainText()); });
    return lines;
  }
  auto* line = new QLineEdit;
  if (name == "expression") line->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  if (takenWhenLeft(name)) {
    connect(line, &QLineEdit::editingFinished, this, [this, name, line] { take(name, line->text()); });
  } else {
    connect(line, &QLineEdit::textEdited, this, [this, name](const QString& text) { take(name, text); });
  }
  return line;
}

void ItemForm::refresh() {
  const auto item = document_.item(id_);
  if (!item) return;
  for (const ItemField& field : fieldsOf(*item)) {
    // A list reads back differently while it is typed ("a; " becomes "a"): leave what the person has in hand.
    QWidget* editor = this->editor(field.name);
    if (editor && field.name != typing_) setValue(editor, QString::fromStdString(field.value));
  }
}

void ItemForm::take(const std::string& field, const QString& text) {
  typing_ = field;
  try {
    message_->hide();
    document_.editField(id_, field, text.toStdString());
  } catch (const core::InputError& error) {
    message_->setText(QString::fromStdString(error.problem() + " " + error.remedy()));
    message_->show();
  }
  typing_.clear();
}

}  // namespace desktop
