#pragma once

#include <filesystem>
#include <vector>

#include "core/error.h"
#include "model/material/brdf_table.h"

namespace model {

/// One value of a table, seen from where the light comes, with the place that errors name.
struct BrdfRow {
  core::Place place;
  double wavelength_nm = 0.0;  ///< 0: any
  double incidence_rad = 0.0;
  double value = 0.0;
};

/// Sorted by wavelength and angle. Throws InputError for angles outside 0 … π/2, negative and doubled values.
[[nodiscard]] std::vector<BrdfTable::Slice> slicesOf(std::vector<BrdfRow> rows, const std::filesystem::path& file);

}  // namespace model
