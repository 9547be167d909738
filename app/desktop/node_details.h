#pragma once

#include <QPalette>
#include <QString>
#include <cstddef>

#include "app/desktop/project_document.h"

namespace desktop {

/// Everything about a node as HTML for a text browser. Links: `node:ID` (another node), `rows:ID` (its CEPRA rows),
/// `item:ID` (requirement), http(s) addresses.
[[nodiscard]] QString nodeDetails(const ProjectDocument& document, std::size_t node, const QPalette& palette);

/// What the graph is, where it comes from, and how large it is; for when no node is selected.
[[nodiscard]] QString graphDetails(const ProjectDocument& document, const QPalette& palette);

}  // namespace desktop
