#pragma once

#include <QPalette>
#include <QString>
#include <string>

#include "app/desktop/project_document.h"

namespace desktop {

/// What an item follows from and what follows from it, and its history, as HTML. Links: `item:ID`, `row:KEY`,
/// `result:ID` (the last verdict of a test), `unlink:FROM|TO`, `reviewed:FROM|TO` (a suspect link is looked at).
[[nodiscard]] QString linkDetails(const ProjectDocument& document, const std::string& id, const QPalette& palette);

}  // namespace desktop
