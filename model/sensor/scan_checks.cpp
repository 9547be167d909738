#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "core/physics.h"
#include "core/text.h"
#include "model/sensor/beams.h"
#include "model/sensor/checks.h"

namespace model::checks {

namespace {

/// Curved layers are looked at in so many places.
constexpr int kPlaces = 64;

std::string layerPointer(std::size_t layer, const char* key = "") {
  return fmt::format("/scan/layers/{}{}", layer, key);
}

struct Interval {
  double low;
  double high;
};

Interval azimuthsOf(const Layer& layer) {
  return {std::min(layer.azimuth_from_deg, layer.azimuth_to_deg),
          std::max(layer.azimuth_from_deg, layer.azimuth_to_deg)};
}

Interval sharedBy(const Layer& a, const Layer& b) {
  const Interval x = azimuthsOf(a), y = azimuthsOf(b);
  return {std::max(x.low, y.low), std::min(x.high, y.high)};
}

enum class Meeting { kNone, kSame, kCrossing };

/// Compares the heights of two layers along the azimuths that both have.
Meeting meetingOf(const Layer& a, const Layer& b) {
  constexpr double kSame_deg = 1e-6;
  const Interval shared = sharedBy(a, b);
  if (shared.high < shared.low) return Meeting::kNone;
  bool above = false, below = false;
  for (int i = 0; i <= kPlaces; ++i) {
    const double azimuth = shared.low + (shared.high - shared.low) * i / kPlaces;
    const double difference = a.elevationAt_deg(azimuth) - b.elevationAt_deg(azimuth);
    above = above || difference > kSame_deg;
    below = below || difference < -kSame_deg;
  }
  if (above && below) return Meeting::kCrossing;
  return above || below ? Meeting::kNone : Meeting::kSame;
}

/// "0 and 3, 1 and 4, … (12 pairs)"
std::string pairText(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min<std::size_t>(pairs.size(), 3); ++i)
    names.push_back(fmt::format("{} and {}", pairs[i].first, pairs[i].second));
  return core::join(names) + (pairs.size() > 3 ? fmt::format(", … ({} pairs)", pairs.size()) : "");
}

double smallestStep_deg(const Scan& scan) {
  if (scan.lissajous) return scan.lissajous->azimuth_step_deg;
  double step = std::numeric_limits<double>::infinity();
  for (const Layer& layer : scan.layers) {
    if (layer.azimuth_from_deg != layer.azimuth_to_deg) step = std::min(step, layer.azimuth_step_deg);
  }
  return step;
}

/// Largest height between layers that lie next to each other at the azimuth nearest to straight ahead.
double largestLayerSpacing_deg(const Scan& scan) {
  std::vector<double> heights;
  for (const Layer& layer : scan.layers) {
    const Interval azimuths = azimuthsOf(layer);
    heights.push_back(layer.elevationAt_deg(std::clamp(0.0, azimuths.low, azimuths.high)));
  }
  std::sort(heights.begin(), heights.end());
  double largest = 0.0;
  for (std::size_t i = 1; i < heights.size(); ++i) largest = std::max(largest, heights[i] - heights[i - 1]);
  return largest;
}

constexpr double kTypicalRange_m = 50.0;

void noteGap(const char* what, double pitch_rad, double width_rad, const std::string& pointer,
             std::vector<Finding>& findings) {
  if (!std::isfinite(pitch_rad) || width_rad <= 0.0 || pitch_rad <= width_rad * 1.001) return;
  findings.push_back({Severity::kNote, pointer,
                      fmt::format("{} lie up to {:.3g}° apart, a beam is {:.3g}° wide: gaps of {:.2g} m at {:g} m.",
                                  what, pitch_rad * core::kDegPerRad, width_rad * core::kDegPerRad,
                                  kTypicalRange_m * (pitch_rad - width_rad), kTypicalRange_m),
                      "A target that is smaller than the gap may be missed in every frame.",
                      "Nothing to do if the sensor is so; else compare the steps with emitter/divergence_rad."});
}

/// Shortest time between two shots that the same row of the receiver waits for, over the end of the frame too.
double shortestPause_s(const SensorProfile& sensor) {
  const double period_s = 1.0 / sensor.scan.frame_rate_hz;
  if (sensor.scan.at_once) return period_s;
  const std::vector<Beam> beams = beamsOf(sensor.scan);
  // A figure has one receiver for all its ways; a layer has its own.
  const bool one_receiver = sensor.scan.lissajous.has_value();
  double shortest_s = period_s;
  for (std::size_t begin = 0, end = 0; begin < beams.size(); begin = end) {
    std::vector<double> times;
    while (end < beams.size() && (one_receiver || beams[end].layer == beams[begin].layer))
      times.push_back(beams[end++].time_s);
    std::sort(times.begin(), times.end());
    for (std::size_t i = 1; i < times.size(); ++i) shortest_s = std::min(shortest_s, times[i] - times[i - 1]);
    shortest_s = std::min(shortest_s, period_s - (times.back() - times.front()));
  }
  return shortest_s;
}

}  // namespace

void angles(const SensorProfile& sensor, std::vector<Finding>& findings) {
  for (std::size_t l = 0; l < sensor.scan.layers.size(); ++l) {
    const Layer& layer = sensor.scan.layers[l];
    const double span = std::abs(layer.azimuth_to_deg - layer.azimuth_from_deg);
    if (span > 360.0 - 1e-6) {
      findings.push_back({Severity::kWarning, layerPointer(l, "/azimuth_deg"),
                          fmt::format("spans {:g}°, a full turn or more, with both ends included.", span),
                          "Some directions are fired twice in a frame.",
                          "Let 'to' end one step before the full turn."});
    }
    if (span > 0.0 && layer.azimuth_step_deg > span * (1.0 + 1e-6)) {
      findings.push_back({Severity::kWarning, layerPointer(l, "/azimuth_deg/step"),
                          fmt::format("is {:g}°, but 'to' is only {:g}° away.", layer.azimuth_step_deg, span),
                          "The step leads out of the layer: it has one beam.",
                          "Make the step smaller, or 'to' 'from'."});
    }
    double steepest = 0.0;
    for (int i = 0; i <= kPlaces; ++i) {
      const double azimuth = layer.azimuth_from_deg + (layer.azimuth_to_deg - layer.azimuth_from_deg) * i / kPlaces;
      steepest = std::max(steepest, std::abs(layer.elevationAt_deg(azimuth)));
    }
    if (steepest > 90.0) {
      findings.push_back({Severity::kError, layerPointer(l, "/elevation_curve_deg"),
                          fmt::format("leads to an elevation of {:.4g}°.", steepest), "Elevations end at 90°.",
                          "Check the coefficients: c0, c1, … of the azimuth in degrees."});
    }
  }
}

void layersThatMeet(const SensorProfile& sensor, std::vector<Finding>& findings) {
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  Pairs same, crossing, same_later, crossing_later;
  const std::vector<Layer>& layers = sensor.scan.layers;
  for (std::size_t a = 0; a < layers.size(); ++a) {
    for (std::size_t b = a + 1; b < layers.size(); ++b) {
      const Meeting meeting = meetingOf(layers[a], layers[b]);
      if (meeting == Meeting::kNone) continue;
      const bool together = layers[a].time_offset_s == layers[b].time_offset_s;
      (meeting == Meeting::kSame ? (together ? same : same_later) : (together ? crossing : crossing_later))
          .emplace_back(a, b);
    }
  }
  const auto add = [&](Severity severity, const Pairs& pairs, const std::string& how, const char* why) {
    if (pairs.empty()) return;
    findings.push_back({severity, layerPointer(pairs[0].second), "layers " + pairText(pairs) + " " + how, why,
                        "Check elevation_deg and elevation_curve_deg; nothing to do if the sensor is so."});
  };
  add(Severity::kWarning, same, "look into the same directions at the same time.",
      "Their detections are copies of each other: counts double, scatter does not shrink.");
  add(Severity::kWarning, crossing, "cross each other.", "A layer is no longer a height: pictures by layer mislead.");
  add(Severity::kNote, same_later, "look into the same directions, one after the other.",
      "What moves is seen twice in one frame.");
  add(Severity::kNote, crossing_later, "cross each other, one after the other.",
      "Where they cross, one direction is measured twice in a frame.");
}

void gapsBetweenBeams(const SensorProfile& sensor, std::vector<Finding>& findings) {
  const AngularSize& beam = sensor.emitter.divergence;
  const double step_rad = smallestStep_deg(sensor.scan) * core::kRadPerDeg;
  const bool figure = sensor.scan.lissajous.has_value();
  noteGap("columns", step_rad, beam.horizontal_rad,
          figure ? "/scan/lissajous/azimuth_step_deg" : layerPointer(0, "/azimuth_deg/step"), findings);
  if (!figure)
    noteGap("layers", largestLayerSpacing_deg(sensor.scan) * core::kRadPerDeg, beam.vertical_rad, "/scan/layers",
            findings);
  if (std::isfinite(step_rad) && beam.horizontal_rad >= 2.0 * step_rad) {
    findings.push_back({Severity::kNote, "/emitter/divergence_rad/horizontal",
                        fmt::format("is {:.2g} azimuth steps wide.", beam.horizontal_rad / step_rad),
                        "Neighbouring beams light the same spot: edges blur, and detections are not independent.",
                        "Nothing to do if the sensor is so; else compare it with the step."});
  }
}

void darkBeams(const SensorProfile& sensor, std::vector<Finding>& findings) {
  const std::vector<Beam> beams = beamsOf(sensor.scan);
  const auto dark = std::count_if(beams.begin(), beams.end(), [](const Beam& beam) { return beam.gain == 0.0; });
  if (dark == 0) return;
  const bool all = static_cast<std::size_t>(dark) == beams.size();
  findings.push_back({all ? Severity::kError : Severity::kNote,
                      sensor.scan.lissajous ? "/scan/lissajous" : "/scan/layers",
                      fmt::format("{} of {} beams have an azimuth_gain of 0.", dark, beams.size()),
                      "They are fired and counted, but nothing comes back.",
                      "Shorten the layers, or check the table's azimuths (positive to the left)."});
}

void timing(const SensorProfile& sensor, std::vector<Finding>& findings) {
  const double flight_s = 2.0 * sensor.detection.max_range_m / core::kSpeedOfLight_m_s;
  const double pause_s = shortestPause_s(sensor);
  if (pause_s < flight_s) {
    findings.push_back(
        {pause_s > 0.0 ? Severity::kWarning : Severity::kError, "/detection/max_range_m",
         fmt::format("light needs {:.3g} µs for it and back, but a row fires again after {:.3g} µs.", 1e6 * flight_s,
                     1e6 * std::max(pause_s, 0.0)),
         fmt::format("An echo from beyond {:.3g} m comes with the next shot and is taken for a near one.",
                     std::max(pause_s, 0.0) * core::kSpeedOfLight_m_s / 2.0),
         "Lower max_range_m, frame_rate_hz or the number of columns, or raise duty. The chain does not "
         "simulate such echoes."});
  }
  const double period_s = 1.0 / sensor.scan.frame_rate_hz;
  for (std::size_t l = 0; l < sensor.scan.layers.size(); ++l) {
    if (sensor.scan.layers[l].time_offset_s < period_s) continue;
    findings.push_back(
        {Severity::kError, layerPointer(l, "/time_offset_s"),
         fmt::format("is {:g} s; a frame is over after {:g} s.", sensor.scan.layers[l].time_offset_s, period_s),
         "The layer would belong to the next frame.", "Lower frame_rate_hz or the offset."});
  }
}

}  // namespace model::checks
