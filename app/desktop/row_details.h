#pragma once

#include <QPalette>
#include <QString>

#include "app/desktop/project_document.h"

namespace desktop {

/// A row of the relevance table with its texts in full, as HTML. Links: `node:ID`, `item:ID`, `add:KEY` (a requirement
/// for this row).
[[nodiscard]] QString rowDetails(const ProjectDocument& document, const cepra::Row& row, const QPalette& palette);

}  // namespace desktop
