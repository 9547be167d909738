#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace model {

/// What is drawn of the detections.
enum class View {
  kSweep,      ///< a number of each run over a quantity of the experiment that is varied
  kBins,       ///< a number over a column of the detections, in bins
  kHistogram,  ///< how a column is distributed
  kPoints,     ///< every detection: one column over another
  kWaveform,   ///< received signal of the first beam
};

/// The number that stands for many detections.
enum class Value {
  kRate,    ///< shots with a detection over all shots
  kEchoes,  ///< detections per shot
  kMean,
  kStddev,
};

/// Evenly spaced numbers from `from` to `to`, both included if the step fits.
struct Steps {
  double from = 0.0;
  double to = 0.0;
  double step = 1.0;
};

/// How an effect is shown (docs/formats.md, Demonstration): a scene, the settings of the effect, and what is drawn.
struct DemonstrationPlan {
  struct Setting {
    std::string name;               ///< as in the legend
    nlohmann::json parameters;      ///< of the effect
    nlohmann::json patch;           ///< of the experiment, RFC 6902; besides that of the whole demonstration
    bool where_light_hits = false;  ///< in place of the detections: where the sub-rays meet something
  };
  std::filesystem::path file;
  std::string effect;
  std::string title;
  std::string caption;        ///< scene, and what to see
  nlohmann::json experiment;  ///< of the scene, patched, without samples
  std::filesystem::path experiment_file;
  int frames = 1;
  std::array<int, 2> rays{1, 1};
  nlohmann::json with;  ///< effects that are on in every run
  Setting off;
  std::vector<Setting> on;

  View view = View::kPoints;
  Value value = Value::kMean;
  std::string over;          ///< column, or JSON Pointer into the experiment (sweep)
  std::string of;            ///< column
  Steps steps;               ///< of the sweep, of the bins, of the waveform
  double zero = 0.0;         ///< of the sweep: x = value - zero
  bool minus_sweep = false;  ///< y minus x: the error of the range
  bool decibel = false;
  double factor = 1.0;  ///< on y
  std::string x_name;   ///< with unit
  std::string y_name;
  std::optional<std::array<double, 2>> x_range;
  std::optional<std::array<double, 2>> y_range;
};

/// Reads resources/effects/NAME.json; throws InputError with file, JSON Pointer and remedy.
[[nodiscard]] DemonstrationPlan readDemonstration(const std::filesystem::path& file);

}  // namespace model
