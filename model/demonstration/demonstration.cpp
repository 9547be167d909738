#include "model/demonstration/demonstration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "model/demonstration/columns.h"
#include "model/explanation.h"
#include "model/simulate.h"

namespace model {

namespace {

using nlohmann::json;
using Series = Demonstration::Series;
using Setting = DemonstrationPlan::Setting;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<double> valuesOf(const Steps& steps) {
  std::vector<double> values;
  const auto count = static_cast<int>(std::floor((steps.to - steps.from) / steps.step + 1e-6)) + 1;
  for (int i = 0; i < count; ++i) values.push_back(steps.from + i * steps.step);
  return values;
}

/// One sample, or of a sweep one for each of its values.
Experiment experimentOf(const DemonstrationPlan& plan, const Setting& setting) {
  json value;
  try {
    value = plan.experiment.patch(setting.patch);
  } catch (const json::exception& error) {
    throw core::InputError({.file = plan.file, .item = "setting '" + setting.name + "', patch"},
                           std::string("does not fit the scene: ") + error.what() + ".",
                           "Its paths must exist in " + plan.experiment_file.string() + ".");
  }
  value["samples"] = json::array();
  const json sample{{"role", "validation"}, {"frames", plan.frames}};
  if (plan.view != View::kSweep) {
    value["samples"].push_back(sample);
    value["samples"][0]["id"] = "demonstration";
    return parseExperiment(value, plan.experiment_file);
  }
  const auto at = valuesOf(plan.steps);
  for (std::size_t i = 0; i < at.size(); ++i) {
    json swept = sample;
    swept["id"] = std::to_string(i);
    swept["patch"] = json::array({{{"op", "replace"}, {"path", plan.over}, {"value", at[i]}}});
    value["samples"].push_back(swept);
  }
  return parseExperiment(value, plan.experiment_file);
}

LidarModel modelOf(const DemonstrationPlan& plan, const Experiment& experiment, const Setting& setting, bool on) {
  json value{{"format", "fidelis-model"}, {"version", 1}, {"id", plan.effect}, {"rays_per_beam", plan.rays}};
  value["sensor"] = experiment.json["sensor"];
  value["effects"] = plan.with;
  if (on) value["effects"][plan.effect] = setting.parameters;
  return parseModel(value, plan.file);
}

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? kNone : sum / static_cast<double>(values.size());
}

double stddevOf(const std::vector<double>& values) {
  if (values.size() < 2) return kNone;
  const double mean = meanOf(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// `indices` are detections, `shots` all shots that might have brought one.
double numberOf(const DemonstrationPlan& plan, const core::Detections& all, const std::vector<std::size_t>& indices,
                double shots) {
  const core::Detections some = core::selected(all, indices);
  if (plan.value == Value::kRate)
    return shots > 0.0 ? static_cast<double>(std::count(some.echo.begin(), some.echo.end(), 1)) / shots : kNone;
  if (plan.value == Value::kEchoes) return shots > 0.0 ? static_cast<double>(some.size()) / shots : kNone;
  const auto values = shownColumn(some, plan.of);
  return plan.value == Value::kMean ? meanOf(values) : stddevOf(values);
}

double scaled(const DemonstrationPlan& plan, double value) {
  return plan.factor * (plan.decibel ? 10.0 * std::log10(value) : value);
}

std::vector<std::size_t> allOf(const core::Detections& detections) {
  std::vector<std::size_t> indices(detections.size());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
  return indices;
}

void sweep(const DemonstrationPlan& plan, const Experiment& experiment, const LidarModel& model, Series& series) {
  const auto at = valuesOf(plan.steps);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const core::Detections detections = simulate(experiment, model, i);
    const auto shots = static_cast<double>(beamsOfSample(experiment, model, experiment.samples[i]).size()) *
                       static_cast<double>(plan.frames);
    const double number = numberOf(plan, detections, allOf(detections), shots);
    series.x.push_back(at[i] - plan.zero);
    series.y.push_back(scaled(plan, plan.minus_sweep ? number - at[i] : number));
  }
}

/// For each bin the entries whose value lies next to its centre.
std::vector<std::vector<std::size_t>> binned(const std::vector<double>& values, const Steps& steps) {
  std::vector<std::vector<std::size_t>> bins(valuesOf(steps).size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double bin = std::floor((values[i] - steps.from) / steps.step + 0.5);
    if (bin >= 0.0 && bin < static_cast<double>(bins.size())) bins[static_cast<std::size_t>(bin)].push_back(i);
  }
  return bins;
}

/// The directions of all beams, as detections at 1 m: what a column says of them.
core::Detections directionsOf(const std::vector<Beam>& beams) {
  core::Detections directions;
  for (const Beam& beam : beams) {
    directions.layer.push_back(beam.layer);
    directions.azimuth_rad.push_back(beam.azimuth_rad);
    directions.elevation_rad.push_back(beam.elevation_rad);
    directions.range_m.push_back(1.0);
  }
  return directions;
}

void numbersInBins(const DemonstrationPlan& plan, const Experiment& experiment, const LidarModel& model,
                   Series& series) {
  const core::Detections detections = simulate(experiment, model, 0);
  const bool of_shots = plan.value == Value::kRate || plan.value == Value::kEchoes;
  std::vector<double> directions;
  if (of_shots)
    directions = shownColumn(directionsOf(beamsOfSample(experiment, model, experiment.samples.front())), plan.over);
  const auto fired = binned(directions, plan.steps);
  const auto seen = binned(shownColumn(detections, plan.over), plan.steps);
  series.x = valuesOf(plan.steps);
  for (std::size_t bin = 0; bin < seen.size(); ++bin) {
    const double shots = static_cast<double>(fired[bin].size()) * static_cast<double>(plan.frames);
    series.y.push_back(scaled(plan, numberOf(plan, detections, seen[bin], shots)));
  }
}

/// Bins as steps: two corners each.
void histogram(const DemonstrationPlan& plan, const core::Detections& detections, Series& series) {
  const auto bins = binned(shownColumn(detections, plan.of), plan.steps);
  const auto centres = valuesOf(plan.steps);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const double share =
        static_cast<double>(bins[i].size()) / static_cast<double>(std::max<std::size_t>(1, detections.size()));
    for (const double side : {-0.5, 0.5}) {
      series.x.push_back(centres[i] + side * plan.steps.step);
      series.y.push_back(scaled(plan, share));
    }
  }
}

void points(const DemonstrationPlan& plan, const core::Detections& detections, Series& series) {
  const auto x = shownColumn(detections, plan.over);
  const auto y = shownColumn(detections, plan.of);
  const auto inside = [](double value, const std::array<double, 2>& range) {
    return value >= range[0] && value <= range[1];
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!inside(x[i], *plan.x_range) || !inside(y[i], *plan.y_range)) continue;
    series.x.push_back(x[i]);
    series.y.push_back(plan.factor * y[i]);
  }
}

/// Where the sub-rays of all beams meet something, as if each were a detection.
core::Detections hitsOf(const Experiment& experiment, const LidarModel& model) {
  const Explainer explainer(experiment, model, 0);
  core::Detections hits;
  for (std::size_t beam = 0; beam < explainer.beams().size(); ++beam) {
    for (const SubRayExplanation& ray : explainer.explain(beam, 0).rays) {
      if (ray.object.empty()) continue;
      hits.azimuth_rad.push_back(ray.azimuth_rad);
      hits.elevation_rad.push_back(ray.elevation_rad);
      hits.range_m.push_back(ray.range_m);
    }
  }
  return hits;
}

/// The signal on a common grid, straight between its samples; 0 between its parts counts as far below the noise.
void waveform(const DemonstrationPlan& plan, const Experiment& experiment, const LidarModel& model, Series& series) {
  constexpr double kWattsPerNanowatt = 1e-9;
  constexpr double kFloor_nw = 1e-3;
  const auto samples = Explainer(experiment, model, 0).explain(0, 0).waveform;
  series.x = valuesOf(plan.steps);
  for (const double range_m : series.x) {
    const auto after = std::upper_bound(samples.begin(), samples.end(), range_m,
                                        [](double value, const WaveformSample& s) { return value < s.range_m; });
    double power_nw = 0.0;
    if (after != samples.begin() && after != samples.end()) {
      const WaveformSample& before = *(after - 1);
      const double share = (range_m - before.range_m) / (after->range_m - before.range_m);
      power_nw = (before.power_w + share * (after->power_w - before.power_w)) / kWattsPerNanowatt;
    }
    series.y.push_back(scaled(plan, plan.decibel ? std::max(power_nw, kFloor_nw) : power_nw));
  }
}

Series seriesOf(const DemonstrationPlan& plan, const Setting& setting, bool on) {
  Series series{.name = setting.name, .x = {}, .y = {}};
  const Experiment experiment = experimentOf(plan, setting);
  const LidarModel model = modelOf(plan, experiment, setting, on);
  switch (plan.view) {
    case View::kSweep:
      sweep(plan, experiment, model, series);
      break;
    case View::kBins:
      numbersInBins(plan, experiment, model, series);
      break;
    case View::kHistogram:
      histogram(plan, simulate(experiment, model, 0), series);
      break;
    case View::kPoints:
      points(plan, setting.where_light_hits ? hitsOf(experiment, model) : simulate(experiment, model, 0), series);
      break;
    case View::kWaveform:
      waveform(plan, experiment, model, series);
      break;
  }
  return series;
}

double differenceOfLines(const std::vector<Series>& all, const Series& off, const Series& on) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Series& series : all) {
    for (const double y : series.y) {
      if (!std::isfinite(y)) continue;
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  if (!(high > low) || off.y.empty()) return 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < off.y.size(); ++i) {
    const bool both = std::isfinite(off.y[i]) && std::isfinite(on.y[i]);
    if (both)
      sum += std::abs(off.y[i] - on.y[i]) / (high - low);
    else if (std::isfinite(off.y[i]) || std::isfinite(on.y[i]))
      sum += 1.0;
  }
  return sum / static_cast<double>(off.y.size());
}

/// Places that an eye tells apart: points closer than half a hundredth of the picture are one.
class Places {
 public:
  explicit Places(const DemonstrationPlan& plan)
      : width_(0.005 * ((*plan.x_range)[1] - (*plan.x_range)[0])),
        height_(0.005 * ((*plan.y_range)[1] - (*plan.y_range)[0])) {}

  void add(const Series& series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!holds({series.x[i], series.y[i]})) places_.push_back({series.x[i], series.y[i]});
    }
  }
  [[nodiscard]] bool holds(const std::array<double, 2>& point) const {
    return std::any_of(places_.begin(), places_.end(), [&](const auto& place) {
      return std::abs(place[0] - point[0]) <= width_ && std::abs(place[1] - point[1]) <= height_;
    });
  }
  [[nodiscard]] std::size_t size() const { return places_.size(); }
  [[nodiscard]] std::size_t notIn(const Places& other) const {
    return static_cast<std::size_t>(
        std::count_if(places_.begin(), places_.end(), [&](const auto& place) { return !other.holds(place); }));
  }

 private:
  double width_;
  double height_;
  std::vector<std::array<double, 2>> places_;
};

double differenceOfPoints(const DemonstrationPlan& plan, const Series& off, const Series& on) {
  Places without(plan);
  Places with(plan);
  without.add(off);
  with.add(on);
  const std::size_t all = without.size() + with.size();
  return all == 0 ? 0.0 : static_cast<double>(without.notIn(with) + with.notIn(without)) / static_cast<double>(all);
}

}  // namespace

Demonstration demonstrate(const DemonstrationPlan& plan) {
  Demonstration demonstration{.plan = plan, .series = {}};
  demonstration.series.push_back(seriesOf(plan, plan.off, false));
  for (const Setting& setting : plan.on) demonstration.series.push_back(seriesOf(plan, setting, true));
  return demonstration;
}

double difference(const Demonstration& demonstration, std::size_t series) {
  const Series& off = demonstration.series.front();
  const Series& on = demonstration.series.at(series);
  return demonstration.plan.view == View::kPoints ? differenceOfPoints(demonstration.plan, off, on)
                                                  : differenceOfLines(demonstration.series, off, on);
}

}  // namespace model
