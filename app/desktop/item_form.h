#pragma once

#include <QScrollArea>
#include <map>
#include <string>

#include "app/desktop/project_document.h"

class QLabel;

namespace desktop {

/// All fields of one item, to be edited. Texts are taken while they are typed (typing on is one undo step); ids and
/// fields with rules of their own when the field is left. What a field does not take is said under the form.
class ItemForm final : public QScrollArea {
  Q_OBJECT

 public:
  explicit ItemForm(ProjectDocument& document, QWidget* parent = nullptr);

  void showItem(const std::string& id);
  /// Values again, where they differ from what stands in the fields.
  void refresh();
  [[nodiscard]] const std::string& id() const noexcept { return id_; }
  [[nodiscard]] QWidget* editor(const std::string& field) const;

 private:
  QWidget* makeEditor(const ItemField& field);
  void take(const std::string& field, const QString& text);

  ProjectDocument& document_;
  std::string id_;
  std::string typing_;  ///< field whose text is just being taken
  QLabel* message_ = nullptr;
  std::map<std::string, QWidget*> editors_;
};

}  // namespace desktop
