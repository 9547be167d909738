#pragma once

#include <numbers>

namespace model {

/// Equal radiance in all directions: β = Γ/π, Γ the hemispherical reflectivity in [0, 1]. [1/sr]
/// Source: Lambert 1760, Photometria.
[[nodiscard]] inline double lambertianBrdf(double reflectivity) { return reflectivity / std::numbers::pi; }

}  // namespace model
