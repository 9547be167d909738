#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "percollect/finding.h"
#include "percollect/graph.h"

namespace percollect {

struct ReadGraph {
  Graph graph;
  std::vector<Finding> findings;  ///< first what the reader met, then orphans, titles and references
};

struct ReadOptions {
  std::string tree;             ///< name of the tree; empty: taken from the path, see treeNameFor
  bool attach_orphans = false;  ///< give orphans the parent that their placementParentId names, where that is possible
};

/// Reads a graph; the content decides about the format:
///
///   XML   release of 2021: the folder of the node files, its root_node.xml (or any node file in it), or the
///         repository whose data/ holds them
///   JSON  releases since December 2021: the file, or the folder that holds data.json
///
/// Survived with a finding: a malformed file that no other includes, a node that includes itself, an id that is not its
/// file's name, nodes that no phenomenon reaches, references that fit no edge, missing texts.
/// Throws InputError with file, line, node and remedy, and returns nothing half: no such file, broken JSON, a missing
/// or broken file that is included, a parent that does not exist, doubled ids, cycles, hrefs that leave the folder,
/// DTDs. Source: the formats as published by PerCollECT (LidarLimbs, RadarRami; MIT).
[[nodiscard]] ReadGraph readGraph(const std::filesystem::path& path, const ReadOptions& options = {});

/// A name that stays the same from release to release: "lidarlimbs" for ".../lidarlimbs-2021-xml",
/// ".../lidarlimbs-2022-10-14.json" and ".../LidarLimbs/data/root_node.xml".
[[nodiscard]] std::string treeNameFor(const std::filesystem::path& path);

}  // namespace percollect
