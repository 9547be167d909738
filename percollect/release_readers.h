#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "percollect/finding.h"
#include "percollect/graph.h"

namespace percollect {

/// A release as read, before it is known to be a graph: ids may be doubled and edges may go in circles.
struct Release {
  GraphData data;  ///< without the tree's name
  std::vector<Finding> findings;
};

/// Reads all *_node.xml of the folder. See readGraph for what it survives.
[[nodiscard]] Release readXmlRelease(const std::filesystem::path& folder);
[[nodiscard]] Release readJsonRelease(const std::filesystem::path& file);

/// Keys that the JSON release or this program gives a meaning; all others are labels.
inline constexpr std::array<std::string_view, 11> kJsonKeys{
    "id",   "parentIds",         "title",      "decomBlock", "description", "references", "nodeType",
    "tags", "placementParentId", "phenomenon", "labels"};

/// Attributes that the XML release or this program gives a meaning.
inline constexpr std::array<std::string_view, 10> kXmlAttributes{
    "id",   "title",  "adBlock",          "description", "references", "designParameterCause", "systemIndependentCause",
    "tags", "labels", "placementParentId"};

/// The blocks of the sensor's signal chain, from emission to objects.
inline constexpr std::array<std::string_view, 7> kBlocks{"Emission",
                                                         "Signal propagation",
                                                         "Reception",
                                                         "Pre-processing",
                                                         "Detection identification",
                                                         "Feature identification",
                                                         "Object identification"};

}  // namespace percollect
