#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "percollect/difference.h"
#include "specs/project_store.h"

namespace specs {

/// What an import did to a project.
struct ImportedGraph {
  bool first = true;                  ///< the project had no graph before
  bool unchanged = false;             ///< the same release is in the project already: nothing was written
  percollect::Difference difference;  ///< to the release before; empty at the first import
  std::vector<std::string> suspect;   ///< keys of CEPRA rows that somebody has to look at again
  std::vector<std::string> added;     ///< keys of rows that are new (not at the first import)
  std::vector<std::string> dropped;   ///< keys of rows that are gone and held nothing
  std::vector<Link> suspect_links;    ///< links from those rows to requirements
  std::size_t rows = 0;               ///< of the table afterwards
};

/// Puts a graph and its relevance table into a project, as one action. A later release of the same tree is merged: what
/// people wrote stays with the rows that it was written for; rows whose meaning may have changed become suspect, and so
/// do the links to what follows from them. Throws InputError if the project holds another tree.
ImportedGraph importGraph(ProjectStore& store, const percollect::Graph& graph, const Signature& by);

}  // namespace specs
