#pragma once

#include <span>
#include <string>
#include <vector>

#include "metrics/distributions/comparison.h"

namespace metrics {

/// Viehof's labels of one parameter sample and measurand.
enum class ValidityLabel { Green = 1, Yellow = 2, Red = 3, Black = 4 };

/// From where to where; low <= high. [unit of the measurand]
struct ToleranceInterval {
  double low;
  double high;
};

/// Interval in which the next repetition falls with the given confidence (beta-expectation tolerance interval):
///
///   mean -+ t(n - 1, (1 + confidence) / 2) s sqrt(1 + 1/n)
///
/// for normally distributed repetitions. Throws InputError for fewer than two, or unless 0 < confidence < 1.
/// Source: Guttman 1970, Statistical Tolerance Regions.
[[nodiscard]] ToleranceInterval toleranceInterval(const Edf& repetitions, double confidence);

/// Share of the simulated tolerance interval that must lie inside the measured one.
/// The dissertation's idea is to label by the tolerance intervals of both sides' t-distributions; the numbers here are
/// our choice and therefore inputs: say them with the result.
struct ViehofOptions {
  double confidence = 0.95;
  double green = 1.0;   ///< share >= green: what is simulated could have been measured
  double yellow = 0.5;  ///< share >= yellow
  double red = 0.0;     ///< share > red; else black: the intervals do not meet
};

struct ViehofResult {
  ToleranceInterval simulated;
  ToleranceInterval measured;
  double share_inside;  ///< of the simulated interval in the measured one, in [0, 1]
  ValidityLabel label;
};

/// Values are repetitions of one experiment (means of frames or of set-ups), not detections. A single simulated value
/// is a model without scatter: an interval of width 0. A poor measurement with a wide interval excuses much, and a
/// simulation with too little scatter is not blamed: look at the intervals too.
/// Throws InputError if the measurement has fewer than two values, or unless 0 <= red <= yellow <= green <= 1.
/// Source: Viehof 2018, Objektive Qualitätsbewertung von Fahrdynamiksimulationen durch statistische Validierung,
/// dissertation, TU Darmstadt (labels and map); thresholds: ours.
[[nodiscard]] ViehofResult viehofLabel(const SamplePair& samples, const ViehofOptions& options = {});

/// Validity assessment map: where in the space of parameters is the model valid, and for which measurand?
///
///                 range   pulse width
///   10 m, dry     green   green
///   10 m, rain    yellow  black
class ValidityMap {
 public:
  /// All labels green at first. Throws InputError if a list is empty or a name occurs twice.
  ValidityMap(std::vector<std::string> parameter_samples, std::vector<std::string> measurands);

  [[nodiscard]] const std::vector<std::string>& parameterSamples() const noexcept { return rows_; }
  [[nodiscard]] const std::vector<std::string>& measurands() const noexcept { return columns_; }
  [[nodiscard]] ValidityLabel& at(std::size_t parameter_sample, std::size_t measurand);
  [[nodiscard]] ValidityLabel at(std::size_t parameter_sample, std::size_t measurand) const;

  /// The worst label of a parameter sample: a model is as valid as its worst measurand.
  [[nodiscard]] ValidityLabel worstOf(std::size_t parameter_sample) const;
  /// Share of all cells with this label or a better one.
  [[nodiscard]] double shareUpTo(ValidityLabel label) const;

 private:
  std::vector<std::string> rows_;
  std::vector<std::string> columns_;
  std::vector<ValidityLabel> labels_;  // row by row
};

}  // namespace metrics
