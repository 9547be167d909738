#pragma once

#include <QComboBox>
#include <filesystem>
#include <vector>

#include "app/desktop/project_document.h"

namespace desktop {

/// What a file is called in a list: an experiment package by its folder, anything else by its name.
[[nodiscard]] QString shortName(std::filesystem::path file);

/// Lists of files by their short names, the whole path as tip. An entry may come last that asks for a file elsewhere.
void addFileQuestion(QComboBox* list, const QString& text);
[[nodiscard]] bool asksForFile(const QComboBox* list);  ///< whether that entry is the current one
/// Adds a file once and returns its index.
int offerFile(QComboBox* list, const std::filesystem::path& file);
/// The current one; empty if none is chosen.
[[nodiscard]] std::filesystem::path chosenFile(const QComboBox* list);

/// An acceptance test's experiment and model, as far as these files exist; else an empty path.
struct TestFiles {
  std::filesystem::path experiment;  ///< its experiment.json
  std::filesystem::path model;
};
[[nodiscard]] TestFiles filesOf(const specs::AcceptanceTest& test, const ProjectDocument& document);

}  // namespace desktop
