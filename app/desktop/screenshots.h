#pragma once

#include <filesystem>

namespace desktop {

class MainWindow;

/// Renders every tab of the open project to FOLDER/<tab>.png (graph, relevance, specification, results, point-cloud),
/// for documents and tests. Throws InputError if a file cannot be written.
void renderTabs(MainWindow& window, const std::filesystem::path& folder);

/// Lets the window draw everything that is under way; for at most ten seconds.
void settle(MainWindow& window);

}  // namespace desktop
