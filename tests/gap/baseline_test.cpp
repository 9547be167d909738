#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <iomanip>
#include <map>
#include <numbers>
#include <sstream>

#include "core/json_object.h"
#include "core/physics.h"
#include "gap/distance/existence.h"
#include "gap/distance/total_gap.h"
#include "gap/replay/replay.h"
#include "tests/support/paths.h"

// The visible cases come from a generator that shares no code with the model. With the withheld cause put in with its
// true parameters, the two must agree to within sampling noise: bias and scatter error below one step of the sensor's
// output, detection rates to 1 %. docs/baseline-comparison.md holds the table; scripts/test-table prints it.
namespace {

using core::Detections;
using nlohmann::json;

/// One case with its cause in place: what the generator simulated, as far as the model can say it.
struct Case {
  json truth;
  model::Experiment experiment;
  model::LidarModel model;
};

Case readCase(const std::filesystem::path& experiments, const std::string& id) {
  const auto folder = experiments / id;
  json truth, model = core::readJson(folder / "model.json"), experiment = core::readJson(folder / "experiment.json");
  const json all = core::readJson(experiments / "truth.json");
  for (const json& one : all.at("cases")) {
    if (one.at("id") == id) truth = one;
  }
  const std::string kind = truth.at("kind");
  if (kind == "effect") model["effects"][truth["names"][0].get<std::string>()] = truth["parameters"];
  if (kind == "parameter") {
    experiment[json::json_pointer(truth["names"][0].get<std::string>())] = truth["parameters"]["true"];
  }
  return {truth, model::parseExperiment(experiment, folder / "experiment.json"),
          model::parseModel(model, folder / "model.json")};
}

/// Sub-rays per beam: those of the case's model file, and those that the generator's data show that it used (see
/// docs/baseline-comparison.md for how they show it).
struct Rays {
  int horizontal, vertical;
};
Rays generatorsRays(const model::LidarModel& model) {
  return model.sensor("").id == "scanner-f" ? Rays{25, 25} : Rays{21, 35};
}

/// Detections of one sample for a seed.
using Simulation = std::function<Detections(std::size_t sample, std::uint64_t seed)>;

Simulation onEvenGrid(const Case& which, Rays rays) {
  model::LidarModel model = which.model;
  model.rays_horizontal = rays.horizontal;
  model.rays_vertical = rays.vertical;
  return [&which, model](std::size_t sample, std::uint64_t seed) {
    return model::simulate(which.experiment, model, sample, {}, seed);
  };
}

/// What the case's unknown cause does to ranges: a cyclic error of an interpolating counter. Amplitude and period are
/// published with the case, the phase is not; it is fitted to the first sample.
double cyclicError(const json& parameters, double range_m, double phase_rad) {
  const double period_m = parameters.at("period_m");
  return parameters.at("amplitude_m").get<double>() * std::sin(2.0 * std::numbers::pi * range_m / period_m + phase_rad);
}

Detections withCyclicError(Detections detections, const Case& which, double phase_rad) {
  const double step_m = which.experiment.measurand("range").resolution;
  for (double& range_m : detections.range_m) {
    range_m = std::round((range_m + cyclicError(which.truth["parameters"], range_m, phase_rad)) / step_m) * step_m;
  }
  return detections;
}

double fittedPhase(const Case& which, const Simulation& simulation) {
  const model::Sample& first = which.experiment.samples.front();
  const Detections measured = model::readMeasurements(which.experiment, first), simulated = simulation(0, 1);
  double best_rad = 0.0, least = INFINITY;
  for (int i = 0; i < 126; ++i) {
    const double phase_rad = 0.05 * i;
    const auto gap = gap::totalGap(which.experiment.measurands, measured, withCyclicError(simulated, which, phase_rad),
                                   first.frames);
    if (gap.measurands[0].d_cavm >= least) continue;
    least = gap.measurands[0].d_cavm;
    best_rad = phase_rad;
  }
  return best_rad;
}

/// The simulation with everything that the truth says, what no effect can say included.
Simulation complete(const Case& which, const Simulation& simulation) {
  if (which.truth.at("kind") != "unknown") return simulation;
  const double phase_rad = fittedPhase(which, simulation);
  return [&which, simulation, phase_rad](std::size_t sample, std::uint64_t seed) {
    return withCyclicError(simulation(sample, seed), which, phase_rad);
  };
}

Detections ofLayer(const Detections& detections, std::int32_t layer) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    if (detections.layer[i] == layer) chosen.push_back(i);
  }
  return core::selected(detections, chosen);
}

/// Share of the beams of each cell (layer, 2° of azimuth) that gave an echo, over all frames.
using Cell = std::pair<std::int32_t, std::int64_t>;
Cell cellOf(std::int32_t layer, double azimuth_rad) {
  return {layer, static_cast<std::int64_t>(std::floor((azimuth_rad * core::kDegPerRad - 0.0137) / 2.0))};
}
std::map<Cell, double> rates(const Detections& detections, int frames, const std::vector<model::Beam>& beams) {
  std::map<Cell, double> fired, seen;
  for (const model::Beam& beam : beams) fired[cellOf(beam.layer, beam.azimuth_rad)] += frames;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    if (detections.echo[i] == 1) seen[cellOf(detections.layer[i], detections.azimuth_rad[i])] += 1.0;
  }
  for (auto& [cell, count] : fired) count = seen[cell] / count;
  return fired;
}
double largestRateDifference(const std::map<Cell, double>& a, const std::map<Cell, double>& b) {
  double largest = 0.0;
  for (const auto& [cell, rate] : a) largest = std::max(largest, std::abs(rate - b.at(cell)));
  return largest;
}

std::string steps(const gap::MeasurandGap& gap) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << std::showpos << gap.d_bias / gap.resolution << std::noshowpos << " / "
       << gap.d_cavm / gap.resolution;
  return text.str();
}

/// A layer with fewer detections has no distribution to compare; the detection rates speak for it.
constexpr std::size_t kFewest = 30;

class Baseline : public testing::TestWithParam<const char*> {};

// The scatter error of two samples of one and the same model is not zero; what the model differs from itself by, with
// other random numbers, is printed beside, and bounds the layers, which hold a twentieth of the detections.
TEST_P(Baseline, AgreesWithAnIndependentGeneratorToWithinSamplingNoise) {
  FIDELIS_NEEDS_SHARED(shared);
  const Case which = readCase(shared / "experiments", GetParam());
  const gap::Replay replay(which.experiment, which.model);
  const Simulation file = complete(which, onEvenGrid(which, {which.model.rays_horizontal, which.model.rays_vertical}));
  const Simulation sheared = complete(which, [&](std::size_t sample, std::uint64_t seed) {
    return replay.detections(replay.baseline(), sample, seed);
  });
  const Simulation generators = complete(which, onEvenGrid(which, generatorsRays(which.model)));
  for (std::size_t s = 0; s < which.experiment.samples.size(); ++s) {
    const model::Sample& sample = which.experiment.samples[s];
    SCOPED_TRACE(sample.id);
    const auto& measurands = which.experiment.measurands;
    const Detections measured = model::readMeasurements(which.experiment, sample);
    const Detections simulated = generators(s, 1), again = generators(s, 2);
    const auto gapTo = [&](const Detections& other) {
      return gap::totalGap(measurands, measured, other, sample.frames);
    };
    const gap::TotalGap with_file = gapTo(file(s, 1)), with_sheared = gapTo(sheared(s, 1)),
                        agreement = gapTo(simulated);
    const gap::TotalGap own = gap::totalGap(measurands, again, simulated, sample.frames);

    const auto beams = model::beamsOfSample(which.experiment, which.model, sample);
    const double rate_measured = gap::detectionRate({measured, sample.frames}, beams.size());
    const double rate_simulated = gap::detectionRate({simulated, sample.frames}, beams.size());
    const double cell =
        largestRateDifference(rates(measured, sample.frames, beams), rates(simulated, sample.frames, beams));
    EXPECT_NEAR(rate_simulated, rate_measured, 0.01);
    EXPECT_LT(cell, 0.01);
    EXPECT_LT(agreement.missing_fraction, 0.01);
    EXPECT_LT(agreement.extra_fraction, 0.01);

    for (std::size_t m = 0; m < measurands.size(); ++m) {
      SCOPED_TRACE(measurands[m].name);
      for (const gap::TotalGap* gap : {&agreement, &with_sheared}) {
        EXPECT_LT(std::abs(gap->measurands[m].d_bias), measurands[m].resolution);
        EXPECT_LT(gap->measurands[m].d_cavm, measurands[m].resolution);
      }
      std::ostringstream row;
      row << "| " << GetParam() << ' ' << sample.id << " | " << measurands[m].name << " | " << measured.size() << " | "
          << simulated.size() << " | " << std::fixed << std::setprecision(4) << rate_measured << " / " << rate_simulated
          << " | " << cell << " | " << steps(with_file.measurands[m]) << " | " << steps(with_sheared.measurands[m])
          << " | " << steps(agreement.measurands[m]) << " | " << steps(own.measurands[m]) << " |";
      RecordProperty("row " + sample.id + " " + measurands[m].name, row.str());
    }
    for (std::int32_t layer = 0; layer <= beams.back().layer; ++layer) {
      const Detections real = ofLayer(measured, layer), ours = ofLayer(simulated, layer);
      if (std::min(real.size(), ours.size()) < kFewest) continue;
      SCOPED_TRACE("layer " + std::to_string(layer));
      const auto gap = gap::totalGap(measurands, real, ours, sample.frames);
      const auto floor = gap::totalGap(measurands, ofLayer(again, layer), ours, sample.frames);
      ASSERT_EQ(gap.measurands.size(), measurands.size());
      for (std::size_t m = 0; m < measurands.size(); ++m) {
        SCOPED_TRACE(measurands[m].name);
        EXPECT_LT(std::abs(gap.measurands[m].d_bias), measurands[m].resolution);
        EXPECT_LT(gap.measurands[m].d_cavm, std::max(measurands[m].resolution, 1.5 * floor.measurands[m].d_cavm));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Visible, Baseline, testing::Values("v01", "v02", "v03", "v04", "v05", "v06"),
                         [](const auto& which) { return std::string(which.param); });

}  // namespace
