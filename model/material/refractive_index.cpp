#include "model/material/refractive_index.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "model/material/open_material.h"
#include "model/material/refractive_index_info.h"

namespace model {

namespace {

constexpr double kRounding = 1e-9;  ///< files give ends of ranges with few digits: this share of the wavelength is none

std::pair<double, double> rangeOf(const OpticalCurve& curve) {
  if (const auto* table = std::get_if<OpticalTable>(&curve)) {
    return {table->wavelength_um.front(), table->wavelength_um.back()};
  }
  const auto& formula = std::get<OpticalFormula>(curve);
  return {formula.from_um, formula.to_um};
}

double between(const OpticalTable& table, double um) {
  const auto& x = table.wavelength_um;
  const auto upper = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), um) - x.begin());
  if (upper == 0) return table.value.front();
  if (upper == x.size()) return table.value.back();
  const double share = (um - x[upper - 1]) / (x[upper] - x[upper - 1]);
  return table.value[upper - 1] + share * (table.value[upper] - table.value[upper - 1]);
}

double valueAt(const OpticalCurve& curve, double um, const std::filesystem::path& file, const char* name) {
  const auto [from, to] = rangeOf(curve);
  if (um < from * (1.0 - kRounding) || um > to * (1.0 + kRounding)) {
    throw core::InputError({.file = file},
                           fmt::format("gives {} from {} to {} µm; the emitter's {} µm lies outside.", name,
                                       core::significant(from, 4), core::significant(to, 4), core::significant(um, 4)),
                           "Name a file that covers the wavelength, or give the refractive index as a number.");
  }
  const auto* table = std::get_if<OpticalTable>(&curve);
  const double value = table ? between(*table, um) : std::get<OpticalFormula>(curve).dispersion.at(um);
  if (!std::isfinite(value)) {
    throw core::InputError({.file = file}, fmt::format("its formula has no value at {} µm.", core::significant(um, 4)),
                           "Check the coefficients against refractiveindex.info.");
  }
  return value;
}

}  // namespace

ComplexIndex RefractiveIndex::at(double wavelength_nm) const {
  if (!constants_) return constant_;
  const double um = wavelength_nm * 1e-3;
  const double n = valueAt(constants_->n, um, constants_->file, "n");
  const double k = constants_->k ? valueAt(*constants_->k, um, constants_->file, "k") : 0.0;
  return {n, std::max(0.0, k)};
}

OpticalConstants readOpticalConstants(const std::filesystem::path& file, std::vector<std::filesystem::path>& files) {
  if (isOpenMaterial(file)) return readOpenMaterialOptics(file, files);
  files.push_back(file);
  return readRefractiveIndexInfo(file);
}

}  // namespace model
