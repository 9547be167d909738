#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "percollect/finding.h"
#include "percollect/graph.h"

namespace percollect {

/// One file of the XML release.
struct XmlNodeFile {
  struct Include {
    std::string href;
    int line = 0;
  };

  std::filesystem::path file;
  std::string content;
  Node node;
  std::vector<Include> includes;  ///< the node's direct causes
  std::vector<Finding> findings;

  std::string problem;  ///< why the file cannot be used; empty: it can
  int problem_line = 0;
};

/// Reads one node file. A file that is not well-formed, is no node or brings a document type (entities are never
/// expanded) comes back with its problem; only a file that cannot be opened throws.
[[nodiscard]] XmlNodeFile readXmlNodeFile(const std::filesystem::path& file);

}  // namespace percollect
