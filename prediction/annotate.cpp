#include "prediction/annotate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>
#include <set>

#include "core/csv.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "prediction/detection_quantities.h"

namespace prediction {

namespace {

using Names = std::vector<std::string>;

Measurand of(const model::Measurand& measurand) {
  return {.name = measurand.name, .column = measurand.column, .unit = measurand.unit};
}

/// What the file recorded, or what was said in its place.
Measurand measurandOf(const PredictionFile& file, const AnnotateOptions& options) {
  if (!file.measurand && options.measurand.empty()) {
    throw core::InputError(
        {.file = file.file}, "does not record whose errors it predicts.",
        "Say it: --measurand range; or save the prediction again with 'fidelis predict --measurand'.");
  }
  if (!file.measurand) return measurandNamed(options.measurand);
  if (!options.measurand.empty() && !compatible(measurandNamed(options.measurand), *file.measurand)) {
    throw core::InputError({.file = file.file, .item = "--measurand " + options.measurand},
                           "contradicts the file, which predicts errors of " + toString(*file.measurand) + ".",
                           "Leave --measurand out.");
  }
  return *file.measurand;
}

/// The experiment's measurand of this column or name.
const model::Measurand& measurandIn(const model::Experiment& experiment, const Measurand& wanted,
                                    const PredictionFile& file) {
  Names known;
  for (const model::Measurand& candidate : experiment.measurands) {
    if (compatible(of(candidate), wanted)) return candidate;
    known.push_back(candidate.name);
    const bool same = candidate.name == wanted.name || candidate.column == wanted.column;
    if (same && !wanted.unit.empty() && candidate.unit != wanted.unit) {
      throw core::InputError({.file = file.file, .item = "/measurand"},
                             "its errors are in " + wanted.unit + ", and the measurand '" + candidate.name + "' of '" +
                                 experiment.id + "' is in " + (candidate.unit.empty() ? "no unit" : candidate.unit) +
                                 ".",
                             "Learn the prediction from errors in the same unit.");
    }
  }
  const std::string nearest = core::nearestName(wanted.name, known);
  throw core::InputError(
      {.file = file.file},
      "predicts errors of " + toString(wanted) + ", which is no measurand of '" + experiment.id + "'.",
      nearest.empty() ? "Its measurands are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
}

/// "d_bias" of range_m -> "range_m_bias".
std::string columnOf(const std::string& target, const std::string& column) {
  return column + "_" + (target.starts_with("d_") ? target.substr(2) : target);
}

Names columnsOf(const PredictionFile& file, const std::string& column) {
  Names names;
  for (const std::string& target : file.targets()) {
    const std::string stem = columnOf(target, column);
    names.insert(names.end(), {stem, stem + "_low", stem + "_high"});
  }
  names.push_back(column + "_extrapolated");
  return names;
}

void append(fmt::memory_buffer& out, double value) {
  out.push_back(',');
  if (std::isfinite(value)) fmt::format_to(std::back_inserter(out), FMT_COMPILE("{:.6g}"), value);
}

/// The fields of a record as they were read, with quotes where they are needed; as many as the header has.
void append(fmt::memory_buffer& out, std::span<const std::string_view> fields, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) {
    if (i > 0) out.push_back(',');
    if (i >= fields.size()) continue;
    if (fields[i].find_first_of(",\"\r\n \t") == std::string_view::npos) {
      out.append(fields[i]);
    } else {
      const std::string quoted = core::csvRecord(std::array{std::string(fields[i])});
      out.append(std::string_view(quoted).substr(0, quoted.size() - 1));
    }
  }
}

/// A prediction of something that the sensor never reports was meant for another one.
void demandReported(const AnnotatedCounts& counts, const model::Measurand& measurand, const PredictionFile& file) {
  if (counts.detections == 0 || counts.unreported < counts.detections) return;
  throw core::InputError(
      {.file = file.file},
      "predicts errors of '" + measurand.name + "', and no detection has the column '" + measurand.column + "'.",
      "Let the sensor report it (/detection/output of its profile), or leave this prediction out.");
}

}  // namespace

/// The predicted errors of one sample's detections under one prediction file, cell after cell.
class Annotation::Rows {
 public:
  Rows(const Job& job, metrics::BoundOf bounds, const model::Experiment& package, const model::Sample& sample,
       const core::Detections& detections)
      : job_(job),
        bounds_(bounds),
        points_(job.coordinates, package, sample, detections),
        reported_(detections.values(job.measurand.column) != nullptr) {}

  void write(std::size_t detection, fmt::memory_buffer& out, AnnotatedCounts& counts) const {
    std::array<double, metrics::kMaxParameters> place{};
    const std::span<double> point = std::span(place).first(job_.coordinates.size());
    ++counts.detections;
    if (!reported_) ++counts.unreported;
    if (!reported_ || !points_.at(detection, point)) {
      ++counts.unknown;
      for (std::size_t i = 0; i + 1 < job_.columns.size(); ++i) out.push_back(',');
      return flag(Extrapolation::Unknown, out);
    }
    bool outside = false;
    bool joint = false;
    for (const metrics::Prediction& prediction : job_.file.predictions) {
      const metrics::PredictedError error = prediction.at(point);
      const metrics::Interval& bound = bounds_ == metrics::BoundOf::Confidence ? error.confidence : error.observation;
      for (const double value : {error.value, bound.low, bound.high}) append(out, value);
      outside = outside || error.outside != 0;  // one for all: they were learnt from the same samples
      joint = joint || error.outside_joint;
    }
    if (outside || joint) ++counts.outside;
    flag(outside ? Extrapolation::Outside : joint ? Extrapolation::Joint : Extrapolation::Inside, out);
  }

 private:
  static void flag(Extrapolation value, fmt::memory_buffer& out) {
    out.push_back(',');
    out.push_back(static_cast<char>('0' + static_cast<int>(value)));
  }

  const Job& job_;
  metrics::BoundOf bounds_;
  SamplePoints points_;
  bool reported_;
};

Annotation::Annotation(const model::Experiment& experiment, std::vector<PredictionFile> files,
                       const AnnotateOptions& options)
    : bounds_(options.bounds) {
  Names parameters;
  for (const PredictionFile& file : files) {
    for (const std::string& name : file.parameters()) {
      if (std::find(parameters.begin(), parameters.end(), name) == parameters.end()) parameters.push_back(name);
    }
  }
  const std::vector<Coordinate> all = coordinatesFor(parameters, experiment, options.coordinates);
  std::set<std::string> taken;
  for (PredictionFile& file : files) {
    Job job{.file = std::move(file), .sha256 = {}, .measurand = {}, .coordinates = {}, .columns = {}};
    job.sha256 = core::sha256OfFile(job.file.file);
    job.measurand = measurandIn(experiment, measurandOf(job.file, options), job.file);
    job.columns = columnsOf(job.file, job.measurand.column);
    for (const std::string& column : job.columns) {
      if (taken.insert(column).second) continue;
      throw core::InputError(
          {.file = job.file.file},
          "predicts '" + job.measurand.name + "' a second time: two columns would be '" + column + "'.",
          "Give one prediction a measurand.");
    }
    for (const std::string& name : job.file.parameters()) {
      job.coordinates.push_back(
          *std::find_if(all.begin(), all.end(), [&](const Coordinate& c) { return c.parameter == name; }));
    }
    jobs_.push_back(std::move(job));
  }
}

void Annotation::annotate(const model::Experiment& package, const model::Sample& sample,
                          std::vector<AnnotatedCounts>& counts) const {
  const core::Detections detections = model::readMeasurements(package, sample);
  std::vector<Rows> rows;
  for (const Job& job : jobs_) rows.emplace_back(job, bounds_, package, sample, detections);
  std::string header;
  for (const Job& job : jobs_) header += "," + core::join(job.columns, ",");
  fmt::memory_buffer out;
  std::size_t width = 0;
  std::size_t detection = 0;
  const std::string text = core::readFile(sample.measurements);
  core::eachCsvRecord(text, [&](int, std::span<const std::string_view> fields) {
    if (width == 0) {
      width = fields.size();
      append(out, fields, width);
      out.append(header);
    } else {
      append(out, fields, width);
      for (std::size_t k = 0; k < jobs_.size(); ++k) rows[k].write(detection, out, counts[k]);
      ++detection;
    }
    out.push_back('\n');
  });
  core::writeFile(sample.measurements, {out.data(), out.size()});
}

std::vector<AnnotatedCounts> Annotation::apply(const std::filesystem::path& folder) const {
  model::Experiment package = model::readExperiment(folder);
  std::vector<AnnotatedCounts> counts;
  for (const Job& job : jobs_) counts.push_back({.measurand = job.measurand.name, .columns = job.columns});
  if (!jobs_.empty()) {
    for (const model::Sample& sample : package.samples) annotate(package, sample, counts);
  }
  for (std::size_t k = 0; k < jobs_.size(); ++k) demandReported(counts[k], jobs_[k].measurand, jobs_[k].file);
  const bool had = package.json.erase("x-prediction") > 0;
  if (!jobs_.empty()) package.json["x-prediction"] = provenance();
  if (had || !jobs_.empty()) core::writeJson(package.file, package.json);
  return counts;
}

nlohmann::json Annotation::provenance() const {
  nlohmann::json list = nlohmann::json::array();
  for (const Job& job : jobs_) {
    nlohmann::json entry{{"file", job.file.file.filename().string()},
                         {"sha256", job.sha256},
                         {"title", job.file.title()},
                         {"measurand", toJson(of(job.measurand))},
                         {"level", job.file.predictions.front().level},
                         {"bounds", bounds_ == metrics::BoundOf::Confidence ? "confidence" : "observation"},
                         {"columns", job.columns}};
    for (const Coordinate& c : job.coordinates) {
      entry["coordinates"][c.parameter] = toString(c.source) + ":" + c.key;
    }
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace prediction
