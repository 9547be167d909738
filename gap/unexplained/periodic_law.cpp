#include "gap/unexplained/periodic_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "gap/replay/statistics.h"

namespace gap {

namespace {

constexpr std::array kPeriodicIn = {"range_m", "azimuth_deg"};
constexpr double kFewestPeriods = 3.0;  // in the span of the values: what is longer is a curve
constexpr double kMostPeriods = 500.0;
constexpr double kStep = 0.2;            // of a period over the whole span, from one frequency to the next
constexpr std::size_t kMostRows = 2000;  // a frequency is looked at with
constexpr std::size_t kFewestValues = 12;
constexpr int kRefinements = 12;  // halvings of the step

using Row = ResidualTable::Row;
using Column = Eigen::VectorXd;

/// Values of one covariate, each once.
std::vector<double> differentValues(const Covariate& covariate, const std::vector<Row>& rows) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(covariate.number(row));
  std::sort(values.begin(), values.end());
  const double same = 1e-6 * (values.back() - values.front());
  values.erase(std::unique(values.begin(), values.end(), [&](double a, double b) { return b - a <= same; }),
               values.end());
  return values;
}

/// Frequencies that the values of a covariate can tell, per unit of it.
std::vector<double> frequenciesOf(const std::vector<double>& values) {
  if (values.size() < kFewestValues) return {};
  std::vector<double> gaps;
  for (std::size_t i = 1; i < values.size(); ++i) gaps.push_back(values[i] - values[i - 1]);
  return frequenciesIn(values.back() - values.front(), 0.5 / medianOf(gaps));
}

/// Some of the residuals over one covariate, ready for many frequencies.
class Periodogram {
 public:
  Periodogram(const Covariate& covariate, const Residuals& residuals) {
    const std::size_t step = 1 + residuals.rows.size() / kMostRows;
    const auto count = static_cast<Eigen::Index>((residuals.rows.size() + step - 1) / step);
    x_.resize(count), y_.resize(count), weights_.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Row& row = residuals.rows[static_cast<std::size_t>(i) * step];
      const double error = residuals.error(row);
      x_[i] = covariate.number(row);
      y_[i] = row.value;
      weights_[i] = 1.0 / (error * error);
    }
  }

  /// Weighted squares that a sine of this frequency and a constant take from the residuals.
  [[nodiscard]] double power(double frequency) const {
    const Eigen::ArrayXd angle = 2.0 * std::numbers::pi * frequency * x_;
    Eigen::MatrixXd features(x_.size(), 3);
    features.col(0).setOnes();
    features.col(1) = angle.sin();
    features.col(2) = angle.cos();
    const Eigen::Matrix<double, 3, Eigen::Dynamic> weighted = features.transpose() * weights_.matrix().asDiagonal();
    const Eigen::Vector3d along = weighted * y_.matrix();
    return along.dot((weighted * features).ldlt().solve(along));
  }

 private:
  Eigen::ArrayXd x_, y_, weights_;
};

/// The best of these frequencies, and of those beside it.
double strongest(const Periodogram& periodogram, const std::vector<double>& frequencies) {
  std::vector<double> powers(frequencies.size());
  core::parallelFor(frequencies.size(), 1,
                    [&](std::size_t i, std::size_t) { powers[i] = periodogram.power(frequencies[i]); });
  double best = frequencies[static_cast<std::size_t>(std::max_element(powers.begin(), powers.end()) - powers.begin())];
  double most = periodogram.power(best);
  double step = frequencies.size() > 1 ? frequencies[1] - frequencies[0] : 0.0;
  for (int round = 0; round < kRefinements; ++round, step /= 2.0) {
    for (const double tried : {best - step / 2.0, best + step / 2.0}) {
      const double power = periodogram.power(tried);
      if (power <= most) continue;
      best = tried;
      most = power;
    }
  }
  return best;
}

Eigen::MatrixXd waveOf(const Covariate& covariate, double frequency, const std::vector<Row>& rows) {
  Eigen::MatrixXd features(static_cast<Eigen::Index>(rows.size()), 3);
  for (Eigen::Index i = 0; i < features.rows(); ++i) {
    const double angle = 2.0 * std::numbers::pi * frequency * covariate.number(rows[static_cast<std::size_t>(i)]);
    features.row(i) << 1.0, std::sin(angle), std::cos(angle);
  }
  return features;
}

Law lawOf(const Covariate& covariate, double frequency, const Column& coefficients) {
  Law law;
  law.constant = coefficients[0];
  const double period = 1.0 / frequency;
  // a sin(ωx) + b cos(ωx) = A sin(ω(x - zero)), zero in the first period.
  const double turn = -std::atan2(coefficients[2], coefficients[1]) / (2.0 * std::numbers::pi);
  law.terms.push_back({covariate.name, "sin x", std::hypot(coefficients[1], coefficients[2]), period,
                       period * (turn - std::floor(turn))});
  return law;
}

bool isKnown(const Covariate& covariate, const std::vector<Row>& rows) {
  return std::all_of(rows.begin(), rows.end(), [&](const Row& row) { return std::isfinite(covariate.number(row)); });
}

}  // namespace

std::vector<double> frequenciesIn(double span, double highest) {
  std::vector<double> frequencies;
  for (double f = kFewestPeriods / span; f <= std::min(kMostPeriods / span, highest); f += kStep / span)
    frequencies.push_back(f);
  return frequencies;
}

std::optional<Law> periodicLaw(const std::vector<Covariate>& covariates, const Residuals& fit, const Residuals& judge) {
  std::optional<Law> best;
  double least = fit.squares();
  for (const Covariate& covariate : covariates) {
    const bool periodic = std::find(kPeriodicIn.begin(), kPeriodicIn.end(), covariate.name) != kPeriodicIn.end();
    if (!periodic || !isKnown(covariate, fit.rows) || !isKnown(covariate, judge.rows)) continue;
    const std::vector<double> frequencies = frequenciesOf(differentValues(covariate, fit.rows));
    if (frequencies.empty()) continue;
    const double frequency = strongest(Periodogram(covariate, fit), frequencies);
    const Eigen::MatrixXd wave = waveOf(covariate, frequency, fit.rows);
    const Column coefficients = fitted(wave, fit);
    const double left = fit.squares(wave * coefficients);
    if (left >= least) continue;
    least = left;
    best = lawOf(covariate, frequency, coefficients);
    best->explained = judge.explainedBy(waveOf(covariate, frequency, judge.rows) * coefficients);
  }
  return best;
}

}  // namespace gap
