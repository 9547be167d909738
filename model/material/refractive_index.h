#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "model/material/dispersion.h"
#include "model/material/fresnel.h"

namespace model {

/// n or k over wavelength: a table (linear between its points, at least one, ascending) or a formula with its range.
struct OpticalTable {
  std::vector<double> wavelength_um;
  std::vector<double> value;
};
struct OpticalFormula {
  Dispersion dispersion;
  double from_um = 0.0;
  double to_um = 0.0;
};
using OpticalCurve = std::variant<OpticalTable, OpticalFormula>;

/// What a file says about a substance. Without k nothing is absorbed.
struct OpticalConstants {
  std::filesystem::path file;
  OpticalCurve n;
  std::optional<OpticalCurve> k;
};

/// Refractive index of a material: one number, or a file over wavelength. Cheap to copy.
class RefractiveIndex {
 public:
  RefractiveIndex(ComplexIndex constant = {1.5, 0.0}) : constant_(constant) {}
  explicit RefractiveIndex(OpticalConstants constants)
      : constants_(std::make_shared<const OpticalConstants>(std::move(constants))) {}

  /// Throws InputError outside the file's wavelengths.
  [[nodiscard]] ComplexIndex at(double wavelength_nm) const;

 private:
  ComplexIndex constant_;
  std::shared_ptr<const OpticalConstants> constants_;
};

/// Reads n and k, told by the content:
///   refractiveindex.info YAML   DATA entries `tabulated nk`, `tabulated n`, `tabulated k`, `formula 1` to `formula 9`
///   OpenMATERIAL 3D `.xompt`    opticalProperties [wavelength m, temperature K, n, k]; the temperature nearest to 20
///   °C OpenMATERIAL 3D `.xomp`     the file behind opticalPropertiesUri
/// Every file that was read is appended to `files`. Throws InputError with line or JSON Pointer.
[[nodiscard]] OpticalConstants readOpticalConstants(const std::filesystem::path& file,
                                                    std::vector<std::filesystem::path>& files);

}  // namespace model
