// Detections of one lidar in a trace of osi3::SensorData: feature_data.lidar_sensor[].detection[]. One message is one
// frame.
//
//   position.distance, azimuth, elevation   range_m, azimuth_rad, elevation_rad in the sensor's frame
//   echo_pulse_width [m]                    epw_m
//   intensity                               intensity: the number as it stands (the standard means per cent)
//   beam_id, or the same direction          echoes of one beam, numbered by range
//
// Elevation is positive up, as the lidar models of openMSL write it; the right-hand rule in the standard's text would
// make it positive down. Layers are not part of the standard.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <tuple>

#include "core/detection_files/detection_format.h"
#include "core/detection_files/osi_trace.h"
#include "osi3_lidar.pb.h"

namespace core {

namespace {

namespace osi3 = fidelis::osi3;

constexpr int kInvalidDetection = 2;  // DETECTION_CLASSIFICATION_INVALID

/// What every detection of a trace has, or none.
struct Recorded {
  std::optional<bool> epw;
  std::optional<bool> intensity;
};

Place placeOf(const OsiTrace& trace, std::size_t message, int detection) {
  Place place = trace.placeOf(message);
  place.item += fmt::format(", detection {}", detection + 1);
  return place;
}

void appendIfRecorded(bool has, double value, const char* name, const Place& place, std::optional<bool>& recorded,
                      std::vector<double>& values) {
  if (!recorded) recorded = has;
  if (*recorded != has) {
    throw InputError(
        place,
        fmt::format("{} {}, others of the trace {}.", has ? "has" : "has no", name, has ? "have none" : "have one"),
        "Write it for every detection or for none.");
  }
  if (has) values.push_back(value);
}

/// One detection; `message` is the frame.
void append(const osi3::LidarDetection& from, const Place& place, std::size_t message, Recorded& recorded,
            Detections& to) {
  const osi3::Spherical3d& at = from.position();
  if (!from.has_position() || !at.has_distance() || !at.has_azimuth() || !at.has_elevation()) {
    throw InputError(place, "has no whole position (distance, azimuth, elevation).", "Write all three.");
  }
  for (const double value : {at.distance(), at.azimuth(), at.elevation(), from.intensity(), from.echo_pulse_width()}) {
    if (!std::isfinite(value)) {
      throw InputError(place, fmt::format("holds {}, which is no finite number.", value), "Leave the detection out.");
    }
  }
  if (at.distance() < 0.0) {
    throw InputError(place, fmt::format("has a negative distance, {} m.", at.distance()), "Leave the detection out.");
  }
  to.frame.push_back(static_cast<std::int32_t>(message));
  to.range_m.push_back(at.distance());
  to.azimuth_rad.push_back(at.azimuth());
  to.elevation_rad.push_back(at.elevation());
  appendIfRecorded(from.has_echo_pulse_width(), from.echo_pulse_width(), "echo_pulse_width", place, recorded.epw,
                   to.epw_m);
  appendIfRecorded(from.has_intensity(), from.intensity(), "intensity", place, recorded.intensity, to.intensity);
}

/// Which beam a detection belongs to, in its frame: by its number, else by its direction.
using BeamKey = std::tuple<std::int32_t, std::uint64_t, double, double>;

BeamKey beamOf(const osi3::LidarDetection& detection, std::size_t message) {
  const auto frame = static_cast<std::int32_t>(message);
  if (detection.has_beam_id()) return {frame, detection.beam_id().value() + 1, 0.0, 0.0};
  return {frame, 0, detection.position().azimuth(), detection.position().elevation()};
}

/// Echoes of one beam are counted from the nearest on.
void numberEchoes(const std::vector<BeamKey>& beams, Detections& detections) {
  std::map<BeamKey, std::vector<std::size_t>> echoes;
  for (std::size_t i = 0; i < beams.size(); ++i) echoes[beams[i]].push_back(i);
  detections.echo.assign(beams.size(), 1);
  for (auto& [beam, members] : echoes) {
    std::stable_sort(members.begin(), members.end(),
                     [&](std::size_t a, std::size_t b) { return detections.range_m[a] < detections.range_m[b]; });
    for (std::size_t k = 0; k < members.size(); ++k) detections.echo[members[k]] = static_cast<std::int32_t>(k + 1);
  }
}

/// Several sensors have several frames; which one is meant cannot be guessed.
class OneSensor {
 public:
  void use(int index, const Place& place) {
    if (!index_) index_ = index;
    if (*index_ == index) return;
    throw InputError(place, "holds detections of more than one lidar_sensor.", "Write a trace for each sensor.");
  }

 private:
  std::optional<int> index_;
};

/// Why a trace of views cannot be read as a measurement.
InputError notDetections(const OsiTrace& trace) {
  bool lidar = false;
  std::optional<std::size_t> without_version;
  for (std::size_t m = 0; m < trace.messages.size(); ++m) {
    osi3::SensorView view;
    if (!view.ParseFromArray(trace.messages[m].data(), static_cast<int>(trace.messages[m].size()))) continue;
    lidar = lidar || view.lidar_sensor_view_size() > 0;
    if (!view.has_version() && !without_version) without_version = m;
  }
  if (!lidar) return noLidarIn(trace, without_version);
  return {{.file = trace.file},
          "holds reflections (SensorView): what a lidar model is fed with.",
          "Give detections (SensorData), or use 'fidelis convert --reflections' to see the hits as points."};
}

/// Gathers the detections of a trace message by message.
class TraceReader {
 public:
  explicit TraceReader(const OsiTrace& trace) : trace_(trace) {}

  void read(std::size_t message) {
    osi3::SensorData data;
    const std::string_view bytes = trace_.messages[message];
    if (!data.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
      throw InputError(trace_.placeOf(message), "is no valid SensorData.", "Copy or record the trace again.");
    }
    if (data.has_version()) checkOsiVersion(trace_, message, true, data.version().version_major());
    if (!data.has_version() && !without_version_) without_version_ = message;
    for (int s = 0; s < data.feature_data().lidar_sensor_size(); ++s) {
      readSensor(data.feature_data().lidar_sensor(s), s, message);
    }
  }

  /// All that was read, once every message is.
  Detections take() {
    if (!lidar_) throw noLidarIn(trace_, without_version_);
    if (without_version_) checkOsiVersion(trace_, *without_version_, false, 0);
    numberEchoes(beams_, detections_);
    return std::move(detections_);
  }

 private:
  void readSensor(const osi3::LidarDetectionData& sensor, int index, std::size_t message) {
    lidar_ = true;
    for (int d = 0; d < sensor.detection_size(); ++d) {
      const osi3::LidarDetection& detection = sensor.detection(d);
      if (detection.classification() == kInvalidDetection) continue;
      const Place place = placeOf(trace_, message, d);
      one_sensor_.use(index, place);
      append(detection, place, message, recorded_, detections_);
      beams_.push_back(beamOf(detection, message));
    }
  }

  const OsiTrace& trace_;
  Detections detections_;
  std::vector<BeamKey> beams_;
  Recorded recorded_;
  OneSensor one_sensor_;
  bool lidar_ = false;
  std::optional<std::size_t> without_version_;
};

Detections read(const DetectionSource& source) {
  const OsiTrace trace = readOsiTrace(source.file, source.content);
  if (trace.kind == OsiKind::kSensorView) throw notDetections(trace);
  TraceReader reader(trace);
  for (std::size_t message = 0; message < trace.messages.size(); ++message) reader.read(message);
  return reader.take();
}

// -- writing

osi3::SensorData frameOf(std::int32_t frame) {
  constexpr std::uint64_t kSensor = 1;
  osi3::SensorData data;
  data.mutable_version()->set_version_major(kOsiMajor);
  data.mutable_version()->set_version_minor(kOsiMinor);
  data.mutable_version()->set_version_patch(0);
  data.mutable_timestamp()->set_seconds(frame);  // detections do not know the frame rate
  data.mutable_timestamp()->set_nanos(0);
  data.mutable_sensor_id()->set_value(kSensor);
  osi3::FeatureData& features = *data.mutable_feature_data();
  *features.mutable_version() = data.version();
  osi3::SensorDetectionHeader& header = *features.add_lidar_sensor()->mutable_header();
  *header.mutable_measurement_time() = data.timestamp();
  header.set_cycle_counter(static_cast<std::uint64_t>(frame));
  header.mutable_sensor_id()->set_value(kSensor);
  return data;
}

void append(const Detections& from, std::size_t i, osi3::LidarDetectionData& to) {
  osi3::LidarDetection& detection = *to.add_detection();
  detection.mutable_position()->set_distance(from.range_m[i]);
  detection.mutable_position()->set_azimuth(from.azimuth_rad[i]);
  detection.mutable_position()->set_elevation(from.elevation_rad[i]);
  if (!from.epw_m.empty()) detection.set_echo_pulse_width(from.epw_m[i]);
  if (!from.intensity.empty()) detection.set_intensity(from.intensity[i]);
}

std::string write(const Detections& detections, const std::string&) {
  if (!detections.hasDirections()) {
    throw InputError({}, "the detections have no directions, which OSI needs.", "Write CSV, PCD or PLY.");
  }
  std::map<std::int32_t, std::vector<std::size_t>> frames;
  for (std::size_t i = 0; i < detections.size(); ++i) frames[detections.frame[i]].push_back(i);
  const std::int32_t last = frames.empty() ? 0 : frames.rbegin()->first;
  std::string trace;
  for (std::int32_t frame = 0; frame <= last; ++frame) {  // frames without detections are messages all the same
    osi3::SensorData data = frameOf(frame);
    osi3::LidarDetectionData& sensor = *data.mutable_feature_data()->mutable_lidar_sensor(0);
    const auto found = frames.find(frame);
    if (found != frames.end()) {
      for (const std::size_t i : found->second) append(detections, i, sensor);
    }
    sensor.mutable_header()->set_number_of_valid_detections(static_cast<std::uint32_t>(sensor.detection_size()));
    appendOsiMessage(trace, data.SerializeAsString());
  }
  return trace;
}

}  // namespace

DetectionFormat osiFormat() {
  return {.name = "osi",
          .title = "ASAM OSI 3 trace of SensorData",
          .endings = {".osi"},
          .encodings = {},
          .recognises = beginsWithOsiMessage,
          .read = read,
          .write = write};
}

}  // namespace core
