#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/material/monotone_curve.h"

namespace model {

/// Measured reflectance seen from where the light comes, over incidence angle and wavelength.
///
/// Monotone cubic interpolation in angle, linear in wavelength. Up to 25 nm beyond the table's wavelengths its ends
/// hold (laser diodes vary and drift by this much); beyond its angles, or farther away in wavelength, there is no value
/// unless the user says that the border holds (`clamp`).
class BrdfTable {
 public:
  /// What the numbers of the table are.
  enum class Quantity {
    kBrdf,          ///< β [1/sr]
    kBrdfTimesCos,  ///< β cos θ [1/sr]: what some instruments give ("cosine-corrected")
    kFactor,        ///< β π / Γ: over a Lambertian of the material's reflectivity
  };
  struct Slice {
    double wavelength_nm = 0.0;  ///< 0: holds at any wavelength; then the only one
    MonotoneCurve value;         ///< over the incidence angle in rad
  };

  /// Slices in ascending order of wavelength, at least one.
  BrdfTable(std::filesystem::path file, Quantity quantity, std::vector<Slice> slices, bool clamp);

  /// β π / Γ for a material of reflectivity Γ > 0. Throws InputError outside the table's range.
  [[nodiscard]] double monostaticFactor(double reflectivity, double cos_incidence, double wavelength_nm) const;
  [[nodiscard]] Quantity quantity() const noexcept { return quantity_; }

 private:
  [[nodiscard]] double valueAt(double incidence_rad, double wavelength_nm) const;
  [[nodiscard]] double valueAt(const Slice& slice, double incidence_rad) const;

  std::filesystem::path file_;
  Quantity quantity_;
  std::vector<Slice> slices_;
  bool clamp_;
};

/// How a material names its table.
struct BrdfTableSource {
  std::filesystem::path file;
  bool times_cos = false;  ///< the values are β cos θ
  bool clamp = false;      ///< beyond the table its border holds
};

/// Reads a table, told by the content:
///   CSV     header `wavelength_nm,incidence_deg,brdf_1_sr` (or `factor` in place of the last); wavelength_nm may be
///           left out; rows in any order
///   .xompt  OpenMATERIAL 3D BRDF table [wavelength m, incidence, exit zenith, exit azimuth rad, 1/sr]; read at the
///           exit direction that is the incidence direction
///   .xomp   OpenMATERIAL 3D material: those of its BRDF tables that are there and say "lidar", or all that are there
/// Every file that was read is appended to `files`. Throws InputError with line or JSON Pointer.
[[nodiscard]] BrdfTable readBrdfTable(const BrdfTableSource& source, std::vector<std::filesystem::path>& files);

}  // namespace model
