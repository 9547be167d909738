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

}  // namespace
}  // namespace model
