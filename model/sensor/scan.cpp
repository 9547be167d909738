#include "model/sensor/scan.h"

#include <cmath>
#include <fmt/format.h>

#include "core/physics.h"
#include "model/sensor/beams.h"

namespace model {

namespace {

constexpr core::Bounds kPositive{.min = 0.0, .open_min = true};
constexpr core::Bounds kAzimuth{.min = -360.0, .max = 360.0};
constexpr core::Bounds kElevation{.min = -90.0, .max = 90.0};

/// A step of 0.1 over 0.3 is to count as three steps though it is 2.999… of them in binary (formats.md section 2).
double steps(double span, double step) { return std::floor(std::abs(span) / step + 1e-6); }

double waysBeamCount(const Lissajous& figure) {
  // There: both ends. Back: the points between.
  return 2.0 * steps(2.0 * figure.azimuth_amplitude_deg, figure.azimuth_step_deg);
}

Layer readLayer(core::JsonObject& object) {
  Layer layer;
  layer.elevation_deg = object.number("elevation_deg", kElevation);
  core::JsonObject azimuth = object.object("azimuth_deg");
  layer.azimuth_from_deg = azimuth.number("from", kAzimuth);
  layer.azimuth_to_deg = azimuth.number("to", kAzimuth);
  layer.azimuth_step_deg = azimuth.number("step", kPositive);
  azimuth.finish();
  if (object.has("elevation_curve_deg")) layer.elevation_curve_deg = object.numbers("elevation_curve_deg");
  layer.time_offset_s = object.numberOr("time_offset_s", 0.0, {.min = 0.0});
  if (object.has("azimuth_gain")) layer.gain = readAzimuthGain(object.object("azimuth_gain"));
  return layer;
}

Lissajous readLissajous(core::JsonObject object, double frame_rate_hz) {
  Lissajous figure;
  figure.azimuth_amplitude_deg = object.number("azimuth_amplitude_deg", {.min = 0.0, .max = 180.0, .open_min = true});
  figure.elevation_amplitude_deg = object.number("elevation_amplitude_deg", {.min = 0.0, .max = 90.0});
  figure.azimuth_step_deg = object.number("azimuth_step_deg", kPositive);
  figure.mirror_frequency_hz = object.number("mirror_frequency_hz", kPositive);
  figure.ramp_s = object.number("ramp_s", kPositive);
  if (object.has("azimuth_gain")) figure.gain = readAzimuthGain(object.object("azimuth_gain"));
  object.finish();
  if (figure.azimuth_step_deg > 2.0 * figure.azimuth_amplitude_deg)
    object.fail("azimuth_step_deg", "leads out of the swing: not even two beams fit into it.",
                "Make the step smaller.");
  if (figure.ramp_s > (1.0 + 1e-9) / frame_rate_hz) {
    object.fail("ramp_s", fmt::format("is {}; a frame is over after {:.6g} s.", figure.ramp_s, 1.0 / frame_rate_hz),
                "Shorten the ramp or lower frame_rate_hz.");
  }
  if (figure.mirror_frequency_hz * figure.ramp_s > kMostBeams)
    object.fail("mirror_frequency_hz", "gives more swings in a ramp than beams are allowed.", "Lower it.");
  if (figure.periods() < 1) {
    object.fail("ramp_s", "is over before the mirror has swung once.", "Lengthen it or raise mirror_frequency_hz.");
  }
  return figure;
}

void refuseTooMany(const core::JsonObject& object, const Scan& scan) {
  const double count = beamCount(scan);
  if (count <= kMostBeams) return;
  constexpr double kBytesPerGigabyte = 1e9;
  object.fail(scan.lissajous ? "lissajous" : "layers",
              fmt::format("asks for {:.3g} beams a frame; their directions alone would take {:.3g} GB of memory.",
                          count, count * sizeof(Beam) / kBytesPerGigabyte),
              fmt::format("Make the azimuth step larger: up to {:g} beams are allowed.", kMostBeams));
}

}  // namespace

double Layer::elevationAt_deg(double azimuth_deg) const {
  double curve = 0.0;
  for (auto c = elevation_curve_deg.rbegin(); c != elevation_curve_deg.rend(); ++c) curve = curve * azimuth_deg + *c;
  return elevation_deg + curve;
}

int Lissajous::periods() const { return static_cast<int>(std::floor(mirror_frequency_hz * ramp_s + 1e-6)); }

double beamCount(const Scan& scan) {
  if (scan.lissajous) return scan.lissajous->periods() * waysBeamCount(*scan.lissajous);
  double count = 0.0;
  for (const Layer& layer : scan.layers)
    count += steps(layer.azimuth_to_deg - layer.azimuth_from_deg, layer.azimuth_step_deg) + 1.0;
  return count;
}

std::size_t layerCount(const Scan& scan) {
  return scan.lissajous ? 2 * static_cast<std::size_t>(scan.lissajous->periods()) : scan.layers.size();
}

double gainOf(const Scan& scan, std::int32_t layer, double azimuth_rad) {
  const double azimuth_deg = azimuth_rad * core::kDegPerRad;
  if (scan.lissajous) return scan.lissajous->gain.at(azimuth_deg);
  const bool known = layer >= 0 && static_cast<std::size_t>(layer) < scan.layers.size();
  return known ? scan.layers[static_cast<std::size_t>(layer)].gain.at(azimuth_deg) : 1.0;
}

Scan readScan(core::JsonObject object) {
  Scan scan;
  scan.frame_rate_hz = object.number("frame_rate_hz", kPositive);
  scan.duty = object.numberOr("duty", 1.0, {.min = 0.0, .max = 1.0, .open_min = true});
  scan.left_to_right =
      object.choiceOr("direction", {"left-to-right", "right-to-left"}, "left-to-right") == "left-to-right";
  scan.at_once = object.choiceOr("firing", {"in-turn", "at-once"}, "in-turn") == "at-once";
  object.eachObject("layers", [&](core::JsonObject& layer) { scan.layers.push_back(readLayer(layer)); });
  if (object.has("lissajous")) {
    for (const char* key : {"layers", "duty", "direction", "firing"}) {
      if (object.has(key)) object.fail(key, "says nothing beside 'lissajous'.", "Remove one of the two.");
    }
    scan.lissajous = readLissajous(object.object("lissajous"), scan.frame_rate_hz);
  } else if (scan.layers.empty()) {
    object.fail("layers", "is missing or empty.", "Give at least one layer.");
  }
  object.finish();
  refuseTooMany(object, scan);
  return scan;
}

}  // namespace model
