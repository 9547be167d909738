#include "model/sensor/beams.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/csv.h"
#include "core/error.h"
#include "core/physics.h"

namespace model {

namespace {

/// Centres of `count` even cells over [-half_width, half_width].
std::vector<double> cellCentres(double half_width, int count) {
  std::vector<double> centres;
  for (int i = 0; i < count; ++i) centres.push_back(half_width * ((2.0 * i + 1.0) / count - 1.0));
  return centres;
}

/// Relative power at an offset from the axis; a, b are half the 1/e² full widths.
double gaussianWeight(double offset, double half_width) {
  return half_width > 0.0 ? std::exp(-2.0 * offset * offset / (half_width * half_width)) : 1.0;
}

void addLayer(const Scan& scan, std::size_t index, std::vector<Beam>& beams) {
  const Layer& layer = scan.layers[index];
  const double span = layer.azimuth_to_deg - layer.azimuth_from_deg;
  const int columns = static_cast<int>(std::floor(std::abs(span) / layer.azimuth_step_deg + 1e-6)) + 1;
  const double step = span < 0.0 ? -layer.azimuth_step_deg : layer.azimuth_step_deg;
  for (int c = 0; c < columns; ++c) {
    // Counted falling in azimuth or rising: column c is the c-th fired one, or the c-th from the end.
    const bool counted_as_fired = (step < 0.0) == scan.left_to_right;
    const int order = counted_as_fired ? c : columns - 1 - c;
    const double azimuth_deg = layer.azimuth_from_deg + c * step;
    const double since_offset_s =
        scan.at_once ? 0.0 : static_cast<double>(order) / columns * scan.duty / scan.frame_rate_hz;
    beams.push_back({.layer = static_cast<std::int32_t>(index),
                     .column = c,
                     .azimuth_rad = azimuth_deg * core::kRadPerDeg,
                     .elevation_rad = layer.elevationAt_deg(azimuth_deg) * core::kRadPerDeg,
                     .time_s = layer.time_offset_s + since_offset_s,
                     .gain = layer.gain.at(azimuth_deg)});
  }
}

/// Both ways of the mirror in one period. On the way right the phase of an azimuth a is acos(a / A); on the way back it
/// is 2π less that.
void addPeriod(const Lissajous& figure, int period, std::vector<Beam>& beams) {
  const double amplitude = figure.azimuth_amplitude_deg;
  const int last = static_cast<int>(std::floor(2.0 * amplitude / figure.azimuth_step_deg + 1e-6));
  const auto add = [&](int way, int column, int place) {
    const double azimuth_deg = amplitude - place * figure.azimuth_step_deg;
    const double there = std::acos(std::clamp(azimuth_deg / amplitude, -1.0, 1.0)) / (2.0 * std::numbers::pi);
    const double phase = way == 0 ? there : 1.0 - there;  // in turns
    const double time_s = (period + phase) / figure.mirror_frequency_hz;
    const double height_deg = figure.elevation_amplitude_deg * time_s / figure.ramp_s;
    beams.push_back({.layer = 2 * period + way,
                     .column = column,
                     .azimuth_rad = azimuth_deg * core::kRadPerDeg,
                     .elevation_rad = height_deg * std::sin(2.0 * std::numbers::pi * phase) * core::kRadPerDeg,
                     .time_s = time_s,
                     .gain = figure.gain.at(azimuth_deg)});
  };
  for (int i = 0; i <= last; ++i) add(0, i, i);
  for (int i = last - 1; i > 0; --i) add(1, last - 1 - i, i);
}

}  // namespace

std::vector<Beam> beamsOf(const Scan& scan) {
  std::vector<Beam> beams;
  beams.reserve(static_cast<std::size_t>(beamCount(scan)));
  for (std::size_t l = 0; l < scan.layers.size(); ++l) addLayer(scan, l, beams);
  for (int p = 0; scan.lissajous && p < scan.lissajous->periods(); ++p) addPeriod(*scan.lissajous, p, beams);
  return beams;
}

void applyGain(const Scan& scan, std::span<Beam> beams) {
  for (Beam& beam : beams) beam.gain = gainOf(scan, beam.layer, beam.azimuth_rad);
}

std::vector<Beam> readBeams(const std::filesystem::path& file) {
  const std::vector<std::string> names{"layer", "azimuth_rad", "elevation_rad"};
  const auto columns = core::readNumericColumns(file, names);
  std::vector<double> times;
  const core::CsvTable table = core::readCsvTable(file);
  if (table.findColumn("time_s")) times = core::readNumericColumns(file, std::vector<std::string>{"time_s"})[0];
  std::vector<Beam> beams;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    if (columns[0][i] < 0.0 || columns[0][i] != std::floor(columns[0][i])) {
      throw core::InputError({.file = file, .line = table.lines[i], .item = "column 'layer'"},
                             "is not a whole number from 0 on.", "Give the index of the layer in the profile.");
    }
    beams.push_back({.layer = static_cast<std::int32_t>(columns[0][i]),
                     .column = static_cast<std::int32_t>(i),
                     .azimuth_rad = columns[1][i],
                     .elevation_rad = columns[2][i],
                     .time_s = times.empty() ? 0.0 : times[i]});
  }
  if (beams.empty()) throw core::InputError({.file = file}, "lists no beam.", "Give at least one line.");
  return beams;
}

BeamTurn::BeamTurn(const Beam& beam)
    : cos_azimuth(std::cos(beam.azimuth_rad)),
      sin_azimuth(std::sin(beam.azimuth_rad)),
      cos_elevation(std::cos(beam.elevation_rad)),
      sin_elevation(std::sin(beam.elevation_rad)) {}

Vector3 BeamTurn::directionAt(double left_slope, double up_slope) const {
  const double ca = cos_azimuth, sa = sin_azimuth, ce = cos_elevation, se = sin_elevation;
  const double l = left_slope, u = up_slope;
  const Vector3 d = {ce * ca - l * sa - u * se * ca, ce * sa + l * ca - u * se * sa, se + u * ce};
  const double length = std::sqrt(1.0 + l * l + u * u);
  return {d[0] / length, d[1] / length, d[2] / length};
}

Vector3 directionOf(const Beam& beam, double left_rad, double up_rad) {
  return BeamTurn(beam).directionAt(std::tan(left_rad), std::tan(up_rad));
}

std::uint32_t SubRays::add(double left, double up, double share) {
  left_rad.push_back(left);
  up_rad.push_back(up);
  weight.push_back(share);
  return static_cast<std::uint32_t>(weight.size() - 1);
}

SubRays subRaysOf(BeamProfile profile, AngularSize divergence, int horizontal, int vertical, Grid grid) {
  const bool gaussian = profile == BeamProfile::kGaussian;
  const double a = divergence.horizontal_rad / 2.0;
  const double b = divergence.vertical_rad / 2.0;
  const double reach = gaussian ? 1.5 : 1.0;
  const auto lefts = cellCentres(reach * a, a > 0.0 ? horizontal : 1);
  const auto ups = cellCentres(reach * b, b > 0.0 ? vertical : 1);
  const auto columns = static_cast<double>(lefts.size()), rows = static_cast<double>(ups.size());
  const bool sheared = grid == Grid::kSheared;
  SubRays rays;
  double sum = 0.0;
  for (std::size_t r = 0; r < ups.size(); ++r) {
    for (std::size_t c = 0; c < lefts.size(); ++c) {
      // Within its cell a sheared ray moves sideways with its row and up with its column.
      const double aside = sheared ? (static_cast<double>(r) + 0.5) / rows - 0.5 : 0.0;
      const double upward = sheared ? (static_cast<double>(c) + 0.5) / columns - 0.5 : 0.0;
      const double left = lefts[c] + aside * 2.0 * reach * a / columns;
      const double up = ups[r] + upward * 2.0 * reach * b / rows;
      rays.add(left, up, gaussian ? gaussianWeight(left, a) * gaussianWeight(up, b) : 1.0);
      sum += rays.weight.back();
    }
  }
  for (double& weight : rays.weight) weight /= sum;
  return rays;
}

}  // namespace model
