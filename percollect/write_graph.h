#pragma once

#include <filesystem>

#include "percollect/graph.h"

namespace percollect {

/// Writes the JSON release format: one array of objects, keys in the order of the releases, two-space indentation.
/// Two things that the format lacks become keys of their own where needed: "placementParentId", and
/// "phenomenon": "false" for an orphan. readGraph gives an equal graph back.
void writeJsonRelease(const Graph& graph, const std::filesystem::path& file);

/// Writes the XML release format into an existing or new folder: one `<id>_node.xml` per node and root_node.xml.
/// Tags and labels, which the format lacks, become attributes. readGraph gives an equal graph back, except that nodes
/// come in the natural order of their ids and edges in the order of their parents.
/// Throws InputError: an id that cannot be a file name, a character that XML forbids, a folder that holds other node
/// files (they would become part of the graph).
void writeXmlRelease(const Graph& graph, const std::filesystem::path& folder);

}  // namespace percollect
