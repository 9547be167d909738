#include "app/desktop/file_list.h"

namespace desktop {

namespace {

namespace fs = std::filesystem;

constexpr const char* kQuestion = "?";  // data of the entry that asks; files in the lists have folders

QString textOf(const fs::path& path) { return QString::fromStdString(path.string()); }

}  // namespace

QString shortName(fs::path file) {
  const bool package = file.filename().empty() || file.filename() == "experiment.json";
  if (package && file.has_parent_path()) file = file.parent_path();
  return textOf(file.filename());
}

void addFileQuestion(QComboBox* list, const QString& text) { list->addItem(text, kQuestion); }

bool asksForFile(const QComboBox* list) { return list->currentData().toString() == kQuestion; }

int offerFile(QComboBox* list, const fs::path& file) {
  const QString path = textOf(file.lexically_normal());
  if (const int known = list->findData(path); known >= 0) return known;
  const int question = list->findData(kQuestion);
  const int place = question >= 0 ? question : list->count();
  list->insertItem(place, shortName(file), path);
  list->setItemData(place, path, Qt::ToolTipRole);
  return place;
}

fs::path chosenFile(const QComboBox* list) {
  return asksForFile(list) ? fs::path() : fs::path(list->currentData().toString().toStdString());
}

TestFiles filesOf(const specs::AcceptanceTest& test, const ProjectDocument& document) {
  TestFiles files;
  const auto existing = [&](const fs::path& named) {
    const fs::path file = document.folder() / named;
    return !named.empty() && fs::exists(file) ? file : fs::path();
  };
  files.experiment = existing(test.experiment);
  if (fs::is_directory(files.experiment)) files.experiment /= "experiment.json";
  files.model = existing(test.model);
  return files;
}

}  // namespace desktop
