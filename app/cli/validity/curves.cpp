#include "app/cli/validity/curves.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "app/cli/metric/read.h"
#include "app/cli/validity/read.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/text.h"

namespace app {

namespace {

core::Place pointOf(const Curves& curves, const Curve& curve, std::size_t i) {
  return {
      .file = curves.file, .line = curve.lines[i], .item = curve.name.empty() ? "" : "repetition '" + curve.name + "'"};
}

/// The points of these rows in the order of their parameter.
Curve curveOf(const KeyedRows& rows, const std::string& name, std::vector<std::size_t> chosen) {
  const std::vector<double>& parameter = rows.numbers[0];
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](std::size_t a, std::size_t b) { return parameter[a] < parameter[b]; });
  Curve curve{.name = name, .parameter = numbersOf(rows, 0, chosen), .values = numbersOf(rows, 1, chosen), .lines = {}};
  for (const std::size_t row : chosen) curve.lines.push_back(rows.lines[row]);
  return curve;
}

void mustAscend(const Curves& curves, const Curve& curve, const CurveColumns& columns) {
  const auto twice = std::adjacent_find(curve.parameter.begin(), curve.parameter.end());
  if (twice == curve.parameter.end()) return;
  const auto i = static_cast<std::size_t>(twice - curve.parameter.begin());
  throw core::InputError(
      pointOf(curves, curve, i + 1),
      fmt::format("has {} = {} again; line {} has it, too.", columns.over, core::shortestNumber(*twice),
                  curve.lines[i]),
      columns.repetition.empty()
          ? "Tell repeated curves apart by a column and name it with --repetition, or average them."
          : "A curve has one value at every parameter; check the column '" + columns.repetition + "'.");
}

Curves curvesOf(const std::string& file, const CurveColumns& columns, bool repeated) {
  std::vector<std::string> keys;
  if (repeated) keys.push_back(columns.repetition);
  const KeyedRows rows = readKeyedRows(file, keys, std::vector{columns.over, columns.value});
  Curves curves{.file = file, .curves = {}};
  if (repeated) {
    for (RowGroup& group : groupedBy(rows, 0))
      curves.curves.push_back(curveOf(rows, group.name, std::move(group.rows)));
  } else {
    std::vector<std::size_t> all(rows.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    curves.curves.push_back(curveOf(rows, "", std::move(all)));
  }
  for (const Curve& curve : curves.curves) mustAscend(curves, curve, columns);
  return curves;
}

/// Numbers that went through text on different ways may differ in the last digits.
bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

void mustShareParameters(const Curves& a_file, const Curve& a, const Curves& b_file, const Curve& b,
                         const CurveColumns& columns) {
  const std::size_t n = std::min(a.parameter.size(), b.parameter.size());
  std::size_t i = 0;
  while (i < n && same(a.parameter[i], b.parameter[i])) ++i;
  if (i == a.parameter.size() && i == b.parameter.size()) return;
  const bool only_a = i < a.parameter.size() && (i == b.parameter.size() || a.parameter[i] < b.parameter[i]);
  const Curves& here = only_a ? a_file : b_file;
  const Curve& with = only_a ? a : b;
  const Curve& without = only_a ? b : a;
  throw core::InputError(
      pointOf(here, with, i),
      fmt::format("has {} = {}; {}{} has no such point.", columns.over, core::shortestNumber(with.parameter[i]),
                  (only_a ? b_file : a_file).file, without.name.empty() ? "" : ", repetition '" + without.name + "',"),
      "Interpolate all curves to the same " + columns.over + " first, or take the point out.");
}

}  // namespace

std::vector<std::vector<double>> Curves::values() const {
  std::vector<std::vector<double>> all;
  for (const Curve& curve : curves) all.push_back(curve.values);
  return all;
}

CurvePair readCurves(const std::string& real, const std::string& simulated, const CurveColumns& columns) {
  const auto isRepeated = [&](const std::string& file) {
    return !columns.repetition.empty() && hasColumns(headerOf(file), {columns.repetition});
  };
  const bool real_repeats = isRepeated(real);
  const bool simulation_repeats = isRepeated(simulated);
  // In neither file it is misspelt: reading it says so with the nearest name.
  const bool nowhere = !columns.repetition.empty() && !real_repeats && !simulation_repeats;
  CurvePair pair{.real = curvesOf(real, columns, real_repeats || nowhere),
                 .simulated = curvesOf(simulated, columns, simulation_repeats)};
  const Curve& first = pair.real.curves.front();
  for (const Curves* curves : {&pair.real, &pair.simulated}) {
    for (const Curve& curve : curves->curves) mustShareParameters(pair.real, first, *curves, curve, columns);
  }
  return pair;
}

}  // namespace app
