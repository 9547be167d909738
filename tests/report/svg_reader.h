#pragma once

#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>
#include <tinyxml2.h>
#include <utility>
#include <vector>

namespace report_test {

/// Calls `see` for every element of an XML text; fails the test if it is not well-formed.
inline void eachElement(const std::string& xml, const std::function<void(const tinyxml2::XMLElement&)>& see) {
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(xml.c_str(), xml.size()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  const std::function<void(const tinyxml2::XMLElement*)> walk = [&](const tinyxml2::XMLElement* element) {
    for (; element; element = element->NextSiblingElement()) {
      see(*element);
      walk(element->FirstChildElement());
    }
  };
  walk(document.RootElement());
}

/// Only what SVG Tiny 1.2 knows and QtSvg draws.
inline void expectSvgTiny(const std::string& svg) {
  const std::set<std::string> known = {"svg", "title", "rect", "line", "polyline", "polygon", "circle", "text", "path"};
  eachElement(svg, [&](const tinyxml2::XMLElement& element) {
    EXPECT_TRUE(known.count(element.Name())) << element.Name();
    EXPECT_EQ(element.Attribute("class"), nullptr);
    EXPECT_EQ(element.Attribute("style"), nullptr);
    EXPECT_EQ(element.Attribute("clip-path"), nullptr);
  });
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf\""), std::string::npos);
}

using Outline = std::vector<std::pair<double, double>>;

/// The points of every polygon of one fill colour.
inline std::vector<Outline> polygonsOf(const std::string& svg, const std::string& fill) {
  std::vector<Outline> found;
  eachElement(svg, [&](const tinyxml2::XMLElement& element) {
    if (std::string(element.Name()) != "polygon" || element.Attribute("fill") != fill) return;
    std::istringstream stream(element.Attribute("points"));
    Outline outline;
    char comma = 0;
    for (double x = 0.0, y = 0.0; stream >> x >> comma >> y;) outline.emplace_back(x, y);
    found.push_back(outline);
  });
  return found;
}

/// Area of a polygon (shoelace formula), in square pixels.
inline double areaOf(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& [x0, y0] = outline[i];
    const auto& [x1, y1] = outline[(i + 1) % outline.size()];
    twice += x0 * y1 - x1 * y0;
  }
  return twice < 0.0 ? -0.5 * twice : 0.5 * twice;
}

}  // namespace report_test
