#pragma once

#include <filesystem>
#include <vector>

#include "model/material/brdf_rows.h"
#include "model/material/refractive_index.h"

namespace model {

/// ASAM OpenMATERIAL 3D 1.0: materials (`.xomp`) that refer to property tables (`.xompt`), both JSON.
/// Source: ASAM OpenMATERIAL 3D 1.0.0, schemas material_schema, material_brdf_schema, material_optical_schema.
[[nodiscard]] bool isOpenMaterial(const std::filesystem::path& file);

/// The values of a BRDF table where the light goes back to where it came from: exit zenith = incidence zenith, exit
/// azimuth 0 (relative to the direction of incidence; both directions count away from the surface). Between exit
/// zeniths the value is interpolated linearly; an incidence whose exit zeniths do not reach so far gives none.
/// Files that were read are appended to `files`.
[[nodiscard]] std::vector<BrdfRow> readOpenMaterialBrdf(const std::filesystem::path& file,
                                                        std::vector<std::filesystem::path>& files);

/// n and k at the temperature that lies nearest to 293.15 K.
[[nodiscard]] OpticalConstants readOpenMaterialOptics(const std::filesystem::path& file,
                                                      std::vector<std::filesystem::path>& files);

}  // namespace model
