#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "metrics/metric_info.h"
#include "metrics/value_input.h"

namespace app {

/// Unit of a column, from the suffix of its name (_m, _rad, …); "" if it has none that is known.
[[nodiscard]] std::string unitOfName(const std::string& column);

/// What `fidelis metric` was asked for.
struct MetricRequest {
  std::string real;
  std::vector<std::string> simulated;
  std::string data = "values";
  std::vector<std::string> columns;
  std::vector<std::string> units;
  std::vector<std::string> metrics;
  std::vector<std::string> scales;    ///< "ordinal", or "column=ordinal"
  std::vector<std::string> settings;  ///< "cut_off=2"
  std::string combine = "envelope";   ///< of several SIM files: envelope (E-outer), a-outer, mixture
  std::vector<double> shares;         ///< of the SIM files in a mixture
  std::string weights;                ///< column with the weight of each row; "": all alike
  double simulated_margin = 0.0;      ///< what every simulated value may be off
  double measured_margin = 0.0;
  std::optional<double> band;     ///< alpha: the measurement is its confidence band
  std::vector<double> at_levels;  ///< quantiles to be told
  std::vector<double> at_values;  ///< probabilities to be told
  std::string shift = "one";
  std::optional<double> experiments;
  std::size_t intervals = 0;  ///< bootstrap replicates; 0: no intervals
  std::string chance_unit;    ///< column of the unit on which chance acts: frame, set-up; "": each value
  std::size_t block = 1;      ///< neighbouring units drawn together
  bool paired = false;        ///< the same units were measured and simulated
  bool bca = false;
  double confidence = 0.95;
  bool floor = false;
  std::vector<std::string> half_widths;  ///< "d_bias=0.005"
  std::uint64_t seed = 1;                ///< of what is drawn
  bool list = false;
  std::string json;

  [[nodiscard]] std::string unitOfColumn(std::size_t index) const;
  [[nodiscard]] metrics::Scale scaleOfColumn(const std::string& column) const;
  [[nodiscard]] metrics::MetricOptions metricOptions() const;
  /// Something is to be drawn anew: intervals, floors, repetitions.
  [[nodiscard]] bool asksForChance() const { return intervals > 0 || floor || !half_widths.empty(); }
  [[nodiscard]] std::vector<std::pair<std::string, double>> wantedHalfWidths() const;
  /// The boxes are more than the envelope of plain runs against a plain sample.
  [[nodiscard]] bool shapesBoxes() const {
    return combine != "envelope" || !weights.empty() || simulated_margin > 0.0 || measured_margin > 0.0 || band;
  }
};

/// Settings of the metrics of one kind of data, by name with their defaults. Throws InputError for a setting that is
/// not among them (with the nearest) and for what is no number.
class MetricSettings {
 public:
  MetricSettings(const MetricRequest& request, std::map<std::string, double> defaults);
  [[nodiscard]] double operator[](const std::string& name) const { return values_.at(name); }
  /// A whole number >= 0. Throws InputError for any other.
  [[nodiscard]] std::size_t count(const std::string& name) const;

 private:
  std::map<std::string, double> values_;
};

}  // namespace app
