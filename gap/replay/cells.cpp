#include "gap/replay/cells.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "core/grouped.h"
#include "core/physics.h"
#include "gap/replay/statistics.h"
#include "gap/replay/stretch.h"

namespace gap {

namespace {

constexpr std::size_t kFewForAMedian = 4;
constexpr double kOutlier = 6.0;       // standard deviations
constexpr double kSurely = 8.0;        // of the profile's noise: no outlier is nearer
constexpr double kNormalMad = 1.4826;  // standard deviation of a normal distribution over its median deviation

struct Surface {
  std::int32_t object;
  double weight = 0.0;
  double range = 0.0;  // weighted sums
  double incidence = 0.0;
};

model::Hit hitOf(const model::Hit& hit) { return hit; }
model::Hit hitOf(const model::SecondHit& second) { return second.hit; }

/// The objects that some hits of a beam lie on, the nearest one first.
template <typename Hits>
std::vector<Surface> objectsOf(const Hits& hits, const model::SubRays& rays) {
  std::vector<Surface> surfaces;
  for (const auto& of_ray : hits) {
    const model::Hit hit = hitOf(of_ray);
    auto known =
        std::find_if(surfaces.begin(), surfaces.end(), [&](const Surface& s) { return s.object == hit.object; });
    if (known == surfaces.end()) known = surfaces.insert(surfaces.end(), Surface{hit.object});
    const double weight = rays.weight[hit.ray];
    known->weight += weight;
    known->range += weight * hit.range_m;
    known->incidence += weight * std::acos(std::min(1.0F, hit.cos_incidence));
  }
  for (Surface& surface : surfaces) {
    surface.range /= surface.weight;
    surface.incidence /= surface.weight;
  }
  std::sort(surfaces.begin(), surfaces.end(), [](const Surface& a, const Surface& b) { return a.range < b.range; });
  return surfaces;
}

/// The surfaces that a beam meets, near ones merged: the chain would report them as one echo.
std::vector<Surface> surfacesOf(const std::vector<Surface>& objects, double separation_m) {
  std::vector<Surface> kept;
  for (const Surface& surface : objects) {
    if (!kept.empty() && surface.range - kept.back().range < separation_m) {
      if (surface.weight > kept.back().weight) kept.back() = surface;
    } else {
      kept.push_back(surface);
    }
  }
  return kept;
}

/// Whether it hangs on a part of the beam that nobody knows (kShareError) if this object is detected at all. `whole`:
/// power over threshold of a beam that is wholly on surfaces such as it meets.
bool hardlySeen(const Surface& surface, double whole) {
  return surface.weight < kWholeBeam && (surface.weight - kShareError) * whole < 1.0 &&
         (surface.weight + kShareError) * whole > 1.0;
}

double shareOf(const std::vector<Surface>& objects) {
  double share = 0.0;
  for (const Surface& object : objects) share += object.weight;
  return share;
}

/// What one of a beam's surfaces makes its echo longer by if one program sees it and another one does not: the farthest
/// of those that are hardly seen.
double mayBeLonger_m(const std::vector<Surface>& objects, const Surface& surface, double whole) {
  double longer_m = 0.0;
  for (const Surface& other : objects) {
    if (other.object != surface.object && hardlySeen(other, whole))
      longer_m = std::max(longer_m, std::abs(other.range - surface.range));
  }
  return longer_m;
}

/// Of a beam, that meets something behind a pane or by way of a mirror; 1 where nothing does.
double shareOfSecondWays(const model::BeamHits& hits, std::uint32_t beam) {
  double share = 0.0;
  for (const model::SecondHit& second : hits.secondOf(beam)) share += hits.rays.weight[second.hit.ray];
  return share > 0.0 ? std::min(1.0, share) : 1.0;
}

/// Where echoes of a surface come in groups that are apart, each of a third of them at least, only the group that is
/// nearest to where the surface is recorded stays: every shot may see a false target as well, and their median would be
/// between the two.
void keepNearestGroup(std::vector<double>& ranges_m, double recorded_m, double apart_m) {
  constexpr std::size_t kThird = 3;
  const auto [nearest, farthest] = std::minmax_element(ranges_m.begin(), ranges_m.end());
  if (*farthest - *nearest <= apart_m) return;
  std::sort(ranges_m.begin(), ranges_m.end());
  std::size_t groups = 0;
  std::pair<std::size_t, std::size_t> kept;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t begin = 0, end = 1; end <= ranges_m.size(); ++end) {
    if (end < ranges_m.size() && ranges_m[end] - ranges_m[end - 1] <= apart_m) continue;
    if (kThird * (end - begin) >= ranges_m.size()) {
      ++groups;
      const double distance_m = std::abs(ranges_m[(begin + end - 1) / 2] - recorded_m);
      if (distance_m < least_m) kept = {begin, end};
      least_m = std::min(least_m, distance_m);
    }
    begin = end;
  }
  if (groups < 2) return;
  ranges_m.resize(kept.second);
  ranges_m.erase(ranges_m.begin(), ranges_m.begin() + static_cast<std::ptrdiff_t>(kept.first));
}

/// How far the leading edge of a surface's echoes walks from shot to shot. It lies FWHM/2 · sqrt(log2(P/P_th)) before
/// the peak (formats.md section 3), and noise of the receiver and speckle move the power: near the threshold that is
/// several times the range noise. `width_m`: FWHM.
double edgeWalk_m(double width_m, double power_over_threshold) {
  constexpr double kPowerMayBe = 2.0;  // times as much or as little: 8 looks of speckle, at three standard deviations
  const auto beforePeak_m = [&](double over_threshold) {
    return width_m / 2.0 * std::sqrt(std::max(0.0, std::log2(over_threshold)));
  };
  const double over_threshold = std::max(1.0, power_over_threshold);
  return beforePeak_m(over_threshold * kPowerMayBe) - beforePeak_m(over_threshold / kPowerMayBe);
}

/// Standard deviation of values that are rounded to steps after noise came to them.
double noiseOnceRounded(double noise, double step) { return std::sqrt(noise * noise + step * step / 12.0); }

/// Where the values of a cell usually lie.
struct Usual {
  double median = 0.0, tolerance = std::numeric_limits<double>::infinity();
};

/// Of values that may be reordered; of none, anywhere.
Usual usualOf(std::vector<double>& values, double least_tolerance) {
  if (values.empty()) return {};
  const double median = medianOf(values);
  for (double& value : values) value = std::abs(value - median);
  return {median, std::max(least_tolerance, kOutlier * kNormalMad * medianOf(values))};
}

constexpr std::int32_t kNone = -1, kMixed = -2;

/// The one object that a beam meets with its whole cross-section; -1 for none, -2 for several or a part.
std::int32_t soleOf(const std::vector<Surface>& objects) {
  if (objects.empty()) return kNone;
  return objects.size() == 1 && objects.front().weight > kWholeBeam ? objects.front().object : kMixed;
}

/// Of every beam: whether it is not wholly on one surface (or on none), or meets another one than its next neighbours.
std::vector<bool> edgesOf(const model::BeamHits& hits, const std::vector<std::int32_t>& sole) {
  constexpr double kNext = 2.2;  // steps of the scan
  std::vector<std::uint32_t> order(hits.beams.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(hits.beams[a].layer, hits.beams[a].azimuth_rad, a) <
           std::tie(hits.beams[b].layer, hits.beams[b].azimuth_rad, b);
  });
  const auto step = [&](std::size_t i) {  // to the next of the layer
    const model::Beam &a = hits.beams[order[i]], &b = hits.beams[order[i + 1]];
    return a.layer == b.layer ? b.azimuth_rad - a.azimuth_rad : std::numeric_limits<double>::infinity();
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (step(i) > 1e-6) least = std::min(least, step(i));
  }
  std::vector<bool> at_edge(order.size());
  for (std::uint32_t b = 0; b < order.size(); ++b) at_edge[b] = sole[b] == kMixed;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (step(i) > kNext * least || sole[order[i]] == sole[order[i + 1]]) continue;
    at_edge[order[i]] = at_edge[order[i + 1]] = true;
  }
  return at_edge;
}

}  // namespace

const char* nameOf(Channel channel) {
  constexpr const char* kNames[] = {"range", "epw", "intensity"};
  return kNames[channel];
}

const char* columnOf(Channel channel) {
  constexpr const char* kColumns[] = {"range_m", "epw_m", "intensity"};
  return kColumns[channel];
}

CellStatistics& CellStatistics::operator+=(const CellStatistics& more) {
  count += more.count;
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    sum[channel] += more.sum[channel];
    sum_of_squares[channel] += more.sum_of_squares[channel];
  }
  return *this;
}

void CellStatistics::moveMean(Channel channel, double by) {
  sum_of_squares[channel] += 2.0 * by * sum[channel] + count * by * by;
  sum[channel] += count * by;
}

double CellStatistics::variance(Channel channel) const {
  if (count < 2.0) return 0.0;
  return std::max(0.0, (sum_of_squares[channel] - sum[channel] * sum[channel] / count) / (count - 1.0));
}

CellLayout::CellLayout(const model::BeamHits& hits, const model::Scene& scene, const model::SignalChain& baseline,
                       Recorded recorded)
    : recorded_(recorded) {
  const model::ChainSettings& settings = baseline.settings();
  const double width_m = core::kMetresPerNanosecond * settings.emitter.pulse_fwhm_ns / 2.0;
  const model::DetectionStage& detection = settings.detection;
  separation_m_ = std::max(detection.echo_separation_m, width_m);
  reach_m_ = std::max(1.0, 2.0 * separation_m_);
  const model::CounterSteps& steps = settings.counters;
  const double of_range_m =
      kSurely * noiseOnceRounded(detection.range_noise_m, std::max(detection.range_resolution_m, steps.range_m));
  const double of_width_m =
      kSurely * noiseOnceRounded(detection.epw_noise_m, std::max(detection.epw_resolution_m, steps.epw_m));
  const bool edge = detection.range_mode == model::RangeMode::kLeadingEdge;
  if (pooled()) {
    cells_ = {{.object = 0}};
    surfaces_ = 1;
    return;
  }
  std::vector<std::int32_t> sole;
  first_.push_back(0);
  first_second_.push_back(0);
  for (std::uint32_t b = 0; b < hits.beams.size(); ++b) {
    double power_w = 0.0;
    for (const model::Pulse& pulse : baseline.pulsesOf(hits, b, scene)) power_w += pulse.power_w;
    const std::vector<Surface> objects = objectsOf(hits.of(b), hits.rays);
    sole.push_back(soleOf(objects));
    const bool at_edge = sole[b] == kMixed || stretchOf_m(hits.of(b)) > width_m;
    const double over_threshold = power_w / settings.receiver.threshold_w;
    const double whole = over_threshold / shareOf(objects);
    for (const Surface& surface : surfacesOf(objects, separation_m_)) {
      cells_.push_back({b, surface.object, surface.range, surface.incidence, over_threshold, surface.weight, at_edge,
                        mayBeLonger_m(objects, surface, whole)});
      const double walk_m = edgeWalk_m(width_m, cells_.back().power_over_threshold);
      tolerances_.push_back({std::max(of_range_m, edge ? walk_m : 0.0), std::max(of_width_m, 2.0 * walk_m)});
    }
    first_.push_back(static_cast<std::uint32_t>(cells_.size()));
    for (const Surface& surface : objectsOf(hits.secondOf(b), hits.rays)) second_m_.push_back(surface.range);
    first_second_.push_back(static_cast<std::uint32_t>(second_m_.size()));
  }
  surfaces_ = cells_.size();
  const std::vector<bool> at_edge = edgesOf(hits, sole);
  for (std::uint32_t b = 0; b < hits.beams.size(); ++b) {
    const double share = shareOfSecondWays(hits, b);
    const bool partly = share > 0.0 && share < kWholeBeam;
    cells_.push_back({.beam = b, .share = share, .at_edge = at_edge[b] || partly});
  }
}

std::vector<CellLayout::Seen> CellLayout::seenIn(const model::BeamHits& hits) const {
  std::vector<Seen> seen(surfaces_, {std::numeric_limits<double>::quiet_NaN(), 0.0});
  for (std::size_t c = 0; c < surfaces_; ++c) {
    double weight = 0.0, sum = 0.0;
    for (const model::Hit& hit : hits.of(cells_[c].beam)) {
      if (hit.object != cells_[c].object) continue;
      weight += hits.rays.weight[hit.ray];
      sum += hits.rays.weight[hit.ray] * hit.range_m;
      seen[c].power += hits.rays.weight[hit.ray] * static_cast<double>(hit.cos_incidence) / (hit.range_m * hit.range_m);
    }
    if (weight > 0.0) seen[c].range_m = sum / weight;
  }
  return seen;
}

std::size_t CellLayout::cellOf(std::uint32_t beam, double range_m) const {
  if (pooled()) return 0;
  std::size_t best = surfaces_ + beam;
  double best_distance = reach_m_;
  for (std::size_t c = first_[beam]; c < first_[beam + 1]; ++c) {
    const double distance = std::abs(cells_[c].anchor_m - range_m);
    if (distance < best_distance) {
      best_distance = distance;
      best = c;
    }
  }
  if (best >= surfaces_) return best;
  for (std::uint32_t i = first_second_[beam]; i < first_second_[beam + 1]; ++i) {
    const bool apart = std::abs(second_m_[i] - cells_[best].anchor_m) >= separation_m_;
    if (apart && std::abs(second_m_[i] - range_m) < best_distance) return surfaces_ + beam;
  }
  return best;
}

void CellLayout::add(std::vector<CellStatistics>& statistics, std::size_t cell,
                     const std::array<double, kChannels>& values) const {
  CellStatistics& s = statistics[cell];
  s.count += 1.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const double value = c == kRange ? values[c] - cells_[cell].anchor_m : values[c];
    s.sum[c] += value;
    s.sum_of_squares[c] += value * value;
  }
}

CellLayout::Assigned CellLayout::assigned(const std::vector<Value>& values) const {
  Assigned result;
  std::vector<std::size_t>& cell_of = result.cell_of;
  cell_of.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) cell_of[i] = cellOf(values[i].beam, values[i].of[kRange]);
  if (pooled()) return result;

  const core::Grouped by_cell(cell_of, cells_.size());
  std::vector<double> ranges, widths;
  for (std::size_t c = 0; c < surfaces_; ++c) {
    if (by_cell.of(c).size() < kFewForAMedian) continue;
    const bool asks_widths = recorded_.widths && !cells_[c].at_edge;
    ranges.clear();
    widths.clear();
    for (const std::uint32_t i : by_cell.of(c)) {
      ranges.push_back(values[i].of[kRange]);
      if (asks_widths) widths.push_back(values[i].of[kEpw]);
    }
    if (!cells_[c].at_edge) keepNearestGroup(ranges, cells_[c].anchor_m, tolerances_[c].range_m);
    const Usual range = usualOf(ranges, tolerances_[c].range_m), width = usualOf(widths, tolerances_[c].width_m);
    for (const std::uint32_t i : by_cell.of(c)) {
      const auto& value = values[i].of;
      if (std::abs(value[kRange] - range.median) > range.tolerance) {
        cell_of[i] = surfaces_ + values[i].beam;
      } else if (value[kEpw] > width.median + width.tolerance) {
        result.usual_width_m.emplace_back(i, width.median);
      }
    }
  }
  return result;
}

std::vector<CellStatistics> CellLayout::statisticsOf(std::vector<Value> values) const {
  const auto [cell_of, usual_width_m] = assigned(values);
  for (const auto& [i, width_m] : usual_width_m) values[i].of[kEpw] = width_m;
  std::vector<CellStatistics> statistics(cells_.size());
  for (std::size_t i = 0; i < values.size(); ++i) add(statistics, cell_of[i], values[i].of);
  return statistics;
}

std::vector<CellLayout::Value> CellLayout::valuesOf(const std::vector<model::Shot>& shots) const {
  std::vector<Value> values;
  values.reserve(shots.size());
  for (const model::Shot& shot : shots)
    values.push_back({pooled() ? 0 : shot.beam, {shot.range_m, shot.epw_m, shot.intensity_nw}});
  return values;
}

std::vector<CellStatistics> CellLayout::statisticsOf(const std::vector<model::Shot>& shots) const {
  return statisticsOf(valuesOf(shots));
}

std::vector<std::size_t> CellLayout::cellsOf(const std::vector<model::Shot>& shots) const {
  return assigned(valuesOf(shots)).cell_of;
}

std::vector<CellLayout::Value> CellLayout::valuesOf(const core::Detections& detections,
                                                    const std::vector<std::uint32_t>& beam_of) const {
  std::vector<Value> values;
  values.reserve(detections.size());
  for (std::size_t i = 0; i < detections.size(); ++i) {
    values.push_back({pooled() ? 0 : beam_of[i],
                      {detections.range_m[i], detections.epw_m.empty() ? 0.0 : detections.epw_m[i],
                       detections.intensity.empty() ? 0.0 : detections.intensity[i]}});
  }
  return values;
}

std::vector<CellStatistics> CellLayout::statisticsOf(const core::Detections& detections,
                                                     const std::vector<std::uint32_t>& beam_of) const {
  return statisticsOf(valuesOf(detections, beam_of));
}

std::vector<std::size_t> CellLayout::cellsOf(const core::Detections& detections,
                                             const std::vector<std::uint32_t>& beam_of) const {
  return assigned(valuesOf(detections, beam_of)).cell_of;
}

std::vector<std::uint32_t> beamsOfDetections(const core::Detections& detections, const std::vector<model::Beam>& beams,
                                             const std::filesystem::path& file) {
  if (!detections.hasDirections()) return std::vector<std::uint32_t>(detections.size(), 0);
  std::map<std::int32_t, std::vector<std::uint32_t>> layers;
  for (std::uint32_t b = 0; b < beams.size(); ++b) layers[beams[b].layer].push_back(b);
  for (auto& [layer, list] : layers) {
    std::sort(list.begin(), list.end(),
              [&](std::uint32_t a, std::uint32_t b) { return beams[a].azimuth_rad < beams[b].azimuth_rad; });
  }
  const auto distance = [&](std::uint32_t b, std::size_t i) {
    return std::hypot(beams[b].azimuth_rad - detections.azimuth_rad[i],
                      beams[b].elevation_rad - detections.elevation_rad[i]);
  };
  constexpr double kFarthest_rad = 0.035;  // two degrees: beyond that the profile is not this sensor's
  std::vector<std::uint32_t> result(detections.size());
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const auto layer = layers.find(detections.layer[i]);
    if (layer == layers.end()) {
      throw core::InputError(
          {.file = file, .line = static_cast<int>(i) + 2},
          fmt::format("layer {} does not exist; the sensor profile has {} layers.", detections.layer[i], layers.size()),
          "Use the profile of the sensor that measured this.");
    }
    const auto& list = layer->second;
    auto right = std::lower_bound(list.begin(), list.end(), detections.azimuth_rad[i],
                                  [&](std::uint32_t b, double azimuth) { return beams[b].azimuth_rad < azimuth; });
    std::uint32_t best = right == list.end() ? list.back() : *right;
    if (right != list.begin() && distance(*(right - 1), i) < distance(best, i)) best = *(right - 1);
    if (distance(best, i) > kFarthest_rad) {
      throw core::InputError({.file = file, .line = static_cast<int>(i) + 2},
                             fmt::format("no beam of layer {} points near azimuth {:.4f} rad.", detections.layer[i],
                                         detections.azimuth_rad[i]),
                             "Use the profile of the sensor that measured this.");
    }
    result[i] = best;
  }
  return result;
}

}  // namespace gap
