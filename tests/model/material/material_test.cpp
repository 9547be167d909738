#include "model/material/material.h"

#include <gtest/gtest.h>

#include "tests/model/lab.h"

namespace model {
namespace {

std::string refusalOf(nlohmann::json materials) {
  lab::Case setup;
  setup.materials = std::move(materials);
  return lab::refusal([&] { (void)lab::experimentOf(setup); });
}

TEST(Material, FaultsAreNamedWithPointer) {
  EXPECT_NE(refusalOf({{"grey", {{"reflectivity", 1.5}}}}).find("/materials/grey/reflectivity"), std::string::npos);
  EXPECT_NE(refusalOf({{"grey", {{"reflectivity", 0.5}, {"brdf", {{"model", "phong"}, {"exponent", 3}}}}}})
                .find("diffuse_fraction: is missing"),
            std::string::npos);
}

TEST(Material, ModelsThatMirrorNeedADiffuseRest) {
  EXPECT_NE(refusalOf({{"pane", {{"reflectivity", 0.0}, {"brdf", {{"model", "glass"}}}}}}).find("/materials/pane/brdf"),
            std::string::npos);
  EXPECT_NE(refusalOf({{"paint", {{"reflectivity", 0.1}, {"brdf", {{"model", "cook-torrance"}}}}}})
                .find("roughness: is missing"),
            std::string::npos);
}

TEST(Material, RetroreflectorsDoNotMakeLight) {
  EXPECT_NE(refusalOf({{"sheet",
                        {{"reflectivity", 0.5},
                         {"brdf",
                          {{"model", "retroreflector"},
                           {"gain", 1e4},
                           {"half_width_rad", 0.5},
                           {"observation_half_width_rad", 0.01}}}}}})
                .find("times the light"),
            std::string::npos);
}

TEST(Material, RefractiveIndexIsANumberOrAnObject) {
  EXPECT_NE(
      refusalOf({{"m", {{"reflectivity", 0.5}, {"refractive_index", 0.5}}}}).find("/materials/m/refractive_index"),
      std::string::npos);
  EXPECT_NE(refusalOf({{"m", {{"reflectivity", 0.5}, {"refractive_index", {{"k", 1.0}}}}}}).find("n: is missing"),
            std::string::npos);
}

}  // namespace
}  // namespace model
