#include "model/material/brdf_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "core/csv.h"
#include "core/error.h"
#include "core/text.h"
#include "model/material/brdf_rows.h"
#include "model/material/open_material.h"

namespace model {

namespace {

constexpr double kDiodeTolerance_nm = 25.0;
constexpr double kRounding_rad = 1e-4;  ///< tables give angles with few digits
constexpr double kSmallestCosine = 1e-6;
constexpr double kDegree = std::numbers::pi / 180.0;

double numberIn(const core::CsvTable& table, std::size_t row, std::size_t column) {
  double value = 0.0;
  const std::string& cell = table.rows[row][column];
  if (core::parseNumber(cell, value) && std::isfinite(value)) return value;
  throw core::InputError({.file = table.file, .line = table.lines[row], .item = table.header[column]},
                         "'" + cell + "' is not a number.", "Write a plain number with a decimal point.");
}

BrdfRow csvRow(const core::CsvTable& table, std::size_t row, std::optional<std::size_t> wavelength,
               std::size_t incidence, std::size_t value) {
  BrdfRow result;
  result.place = {.file = table.file, .line = table.lines[row]};
  if (wavelength) result.wavelength_nm = numberIn(table, row, *wavelength);
  result.incidence_rad = numberIn(table, row, incidence) * kDegree;
  result.value = numberIn(table, row, value);
  if (wavelength && result.wavelength_nm <= 0.0) {
    throw core::InputError(result.place, "has a wavelength that is not positive.", "Give it in nm.");
  }
  return result;
}

BrdfTable readCsv(const BrdfTableSource& source) {
  const core::CsvTable table = core::readCsvTable(source.file);
  const auto wavelength = table.findColumn("wavelength_nm");
  const auto factor = table.findColumn("factor");
  const std::size_t incidence = table.column("incidence_deg");
  const std::size_t value = factor ? *factor : table.column("brdf_1_sr");
  if (factor && source.times_cos) {
    throw core::InputError({.file = source.file, .item = "factor"}, "cannot be a BRDF times cosine.",
                           "Leave out 'values', or name the column 'brdf_1_sr'.");
  }
  std::vector<BrdfRow> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    rows.push_back(csvRow(table, i, wavelength, incidence, value));
  }
  const auto quantity = factor             ? BrdfTable::Quantity::kFactor
                        : source.times_cos ? BrdfTable::Quantity::kBrdfTimesCos
                                           : BrdfTable::Quantity::kBrdf;
  return {source.file, quantity, slicesOf(std::move(rows), source.file), source.clamp};
}

}  // namespace

std::vector<BrdfTable::Slice> slicesOf(std::vector<BrdfRow> rows, const std::filesystem::path& file) {
  for (const BrdfRow& row : rows) {
    if (row.incidence_rad < 0.0 || row.incidence_rad > std::numbers::pi / 2.0 + kRounding_rad) {
      throw core::InputError(row.place, "has an incidence angle that is not between 0° and 90°.",
                             "It counts from the surface's normal.");
    }
    if (row.value < 0.0) {
      throw core::InputError(row.place, "has a negative value.", "A BRDF is zero or positive.");
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const BrdfRow& a, const BrdfRow& b) {
    return std::pair(a.wavelength_nm, a.incidence_rad) < std::pair(b.wavelength_nm, b.incidence_rad);
  });
  std::vector<BrdfTable::Slice> slices;
  for (std::size_t begin = 0; begin < rows.size();) {
    std::vector<double> angles, values;
    std::size_t end = begin;
    for (; end < rows.size() && rows[end].wavelength_nm == rows[begin].wavelength_nm; ++end) {
      if (!angles.empty() && rows[end].incidence_rad <= angles.back()) {
        throw core::InputError(rows[end].place, "gives the same wavelength and incidence angle a second time.",
                               "Keep one of the rows.");
      }
      angles.push_back(rows[end].incidence_rad);
      values.push_back(rows[end].value);
    }
    slices.push_back({rows[begin].wavelength_nm, MonotoneCurve(std::move(angles), std::move(values))});
    begin = end;
  }
  if (slices.empty()) throw core::InputError({.file = file}, "holds no values.", "Give at least one row.");
  return slices;
}

BrdfTable::BrdfTable(std::filesystem::path file, Quantity quantity, std::vector<Slice> slices, bool clamp)
    : file_(std::move(file)), quantity_(quantity), slices_(std::move(slices)), clamp_(clamp) {}

double BrdfTable::valueAt(const Slice& slice, double incidence_rad) const {
  // The angle itself stays out of the message: which beam comes first depends on the threads.
  const bool inside =
      incidence_rad >= slice.value.first() - kRounding_rad && incidence_rad <= slice.value.last() + kRounding_rad;
  if (!inside && !clamp_) {
    throw core::InputError(
        {.file = file_},
        fmt::format("covers incidence angles from {} to {} degrees; beams hit the material outside of them.",
                    core::significant(slice.value.first() / kDegree, 4),
                    core::significant(slice.value.last() / kDegree, 4)),
        R"(Extend the table, or let its border hold with "outside": "clamp" beside "table".)");
  }
  return slice.value.at(incidence_rad);
}

double BrdfTable::valueAt(double incidence_rad, double wavelength_nm) const {
  const Slice& first = slices_.front();
  const Slice& last = slices_.back();
  if (first.wavelength_nm == 0.0) return valueAt(first, incidence_rad);
  const bool near = wavelength_nm >= first.wavelength_nm - kDiodeTolerance_nm &&
                    wavelength_nm <= last.wavelength_nm + kDiodeTolerance_nm;
  if (!near && !clamp_) {
    throw core::InputError({.file = file_},
                           fmt::format("covers wavelengths from {} to {} nm; the emitter has {} nm.",
                                       core::significant(first.wavelength_nm, 6),
                                       core::significant(last.wavelength_nm, 6), core::significant(wavelength_nm, 6)),
                           R"(Extend the table, or let its border hold with "outside": "clamp" beside "table".)");
  }
  const auto upper = std::find_if(slices_.begin(), slices_.end(),
                                  [&](const Slice& slice) { return slice.wavelength_nm >= wavelength_nm; });
  if (upper == slices_.begin()) return valueAt(first, incidence_rad);
  if (upper == slices_.end()) return valueAt(last, incidence_rad);
  const Slice& lower = *(upper - 1);
  const double share = (wavelength_nm - lower.wavelength_nm) / (upper->wavelength_nm - lower.wavelength_nm);
  if (share >= 1.0) return valueAt(*upper, incidence_rad);
  return (1.0 - share) * valueAt(lower, incidence_rad) + share * valueAt(*upper, incidence_rad);
}

double BrdfTable::monostaticFactor(double reflectivity, double cos_incidence, double wavelength_nm) const {
  const double cosine = std::clamp(cos_incidence, 0.0, 1.0);
  const double value = valueAt(std::acos(cosine), wavelength_nm);
  switch (quantity_) {
    case Quantity::kFactor:
      return value;
    case Quantity::kBrdfTimesCos:
      return value / std::max(cosine, kSmallestCosine) * std::numbers::pi / reflectivity;
    case Quantity::kBrdf:
      return value * std::numbers::pi / reflectivity;
  }
  return value;
}

BrdfTable readBrdfTable(const BrdfTableSource& source, std::vector<std::filesystem::path>& files) {
  if (!isOpenMaterial(source.file)) {
    files.push_back(source.file);
    return readCsv(source);
  }
  auto rows = readOpenMaterialBrdf(source.file, files);
  const auto quantity = source.times_cos ? BrdfTable::Quantity::kBrdfTimesCos : BrdfTable::Quantity::kBrdf;
  return {source.file, quantity, slicesOf(std::move(rows), source.file), source.clamp};
}

}  // namespace model
