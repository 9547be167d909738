#include "gap/unexplained/shortest_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/physics.h"

namespace gap {

namespace {

constexpr std::size_t kMostTerms = 2;
constexpr double kTermGain = 0.1;  // of what is to be explained: less does not earn a term
constexpr double kSteepest_deg = 85.0;

using Row = ResidualTable::Row;
using Column = Eigen::VectorXd;

/// A function of one covariate that a law may have; NaN where it is not defined.
struct SimpleFunction {
  const char* name;
  double (*of)(double);
};

constexpr SimpleFunction kFunctions[] = {
    {"x", [](double x) { return x; }},
    {"x²", [](double x) { return x * x; }},
    {"1/x", [](double x) { return x > 0.0 ? 1.0 / x : NAN; }},
    {"ln x", [](double x) { return x > 0.0 ? std::log(x) : NAN; }},
};
constexpr SimpleFunction kOfIncidence = {"tan² x", [](double x) {
                                           const double slope = std::tan(x * std::numbers::pi / 180.0);
                                           return x < kSteepest_deg ? slope * slope : NAN;
                                         }};

/// A function of a covariate, its values standardised as on the fitted rows.
struct Feature {
  const Covariate* covariate;
  SimpleFunction function;
  double mean = 0.0;
  double spread = 1.0;

  [[nodiscard]] Column on(const std::vector<Row>& rows) const {
    Column column(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      column[static_cast<Eigen::Index>(i)] = (function.of(covariate->number(rows[i])) - mean) / spread;
    return column;
  }
};

/// Functions that are defined on all rows and not constant.
std::vector<Feature> featuresOf(const std::vector<Covariate>& covariates, const Residuals& fit,
                                const Residuals& judge) {
  std::vector<Feature> features;
  const auto offer = [&](const Covariate& covariate, const SimpleFunction& function) {
    Feature feature{&covariate, function};
    const Column values = feature.on(fit.rows);
    if (!values.allFinite() || !feature.on(judge.rows).allFinite()) return;
    feature.mean = values.mean();
    feature.spread = std::sqrt((values.array() - feature.mean).square().mean());
    if (feature.spread > 1e-9 * std::max(1.0, std::abs(feature.mean))) features.push_back(feature);
  };
  for (const Covariate& covariate : covariates) {
    if (!covariate.numeric) continue;
    for (const SimpleFunction& function : kFunctions) offer(covariate, function);
    if (covariate.name == "incidence_deg") offer(covariate, kOfIncidence);
  }
  return features;
}

/// A constant and the features, in the unit of the residuals.
Eigen::MatrixXd matrixOf(const std::vector<Feature>& features, const Residuals& residuals) {
  const auto rows = static_cast<Eigen::Index>(residuals.rows.size());
  Eigen::MatrixXd matrix(rows, static_cast<Eigen::Index>(features.size()) + 1);
  matrix.col(0).setOnes();
  for (std::size_t f = 0; f < features.size(); ++f)
    matrix.col(static_cast<Eigen::Index>(f) + 1) = features[f].on(residuals.rows);
  if (!residuals.scales.empty())
    matrix.array().colwise() *= Eigen::Map<const Column>(residuals.scales.data(), rows).array();
  return matrix;
}

Law lawOf(const std::vector<Feature>& chosen, const Column& coefficients) {
  Law law;
  law.constant = coefficients[0];
  for (std::size_t f = 0; f < chosen.size(); ++f) {
    const double coefficient = coefficients[static_cast<Eigen::Index>(f) + 1] / chosen[f].spread;
    law.constant -= coefficient * chosen[f].mean;
    law.terms.push_back({chosen[f].covariate->name, chosen[f].function.name, coefficient});
  }
  return law;
}

/// In the unit of the residuals, or of their scales.
Law selected(const std::vector<Covariate>& covariates, const Residuals& fit, const Residuals& judge) {
  const std::vector<Feature> offered = featuresOf(covariates, fit, judge);
  std::vector<Feature> chosen;
  Column coefficients = fitted(matrixOf(chosen, fit), fit);
  double left = fit.squares(matrixOf(chosen, fit) * coefficients);
  const double worth_a_term = kTermGain * fit.squares();
  while (chosen.size() < kMostTerms) {
    std::vector<Feature> best;
    double least = left - worth_a_term;
    for (const Feature& feature : offered) {
      std::vector<Feature> tried = chosen;
      tried.push_back(feature);
      const Eigen::MatrixXd matrix = matrixOf(tried, fit);
      const double now = fit.squares(matrix * fitted(matrix, fit));
      if (now >= least) continue;
      least = now;
      best = std::move(tried);
    }
    if (best.empty()) break;
    chosen = std::move(best);
    coefficients = fitted(matrixOf(chosen, fit), fit);
    left = least;
  }
  Law law = lawOf(chosen, coefficients);
  law.explained = judge.explainedBy(matrixOf(chosen, judge) * coefficients);
  return law;
}

/// What a part of 1 of the received power is in a channel, where this value is expected.
double perPower(const Replay& replay, std::size_t sample, Channel channel, double expected) {
  if (channel == kIntensity) return expected;
  const model::SensorProfile& profile = replay.baseline().model.sensor(replay.samples()[sample].sample->sensor);
  const double pulse_m = core::kMetresPerNanosecond * profile.emitter.pulse_fwhm_ns;
  return pulse_m * pulse_m / (2.0 * std::numbers::ln2 * expected);
}

/// With that of every row as its scale; nothing where a row has no expected value.
std::optional<Residuals> inPartsOfPower(const Replay& replay, const CellsOfSamples& expected, Channel channel,
                                        Residuals residuals) {
  for (const Row& row : residuals.rows) {
    const CellStatistics& cell = expected[row.sample][row.cell];
    if (cell.count <= 0.0 || cell.mean(channel) <= 0.0) return std::nullopt;
    residuals.scales.push_back(perPower(replay, row.sample, channel, cell.mean(channel)));
  }
  return residuals;
}

/// In which a gain shows as such.
std::optional<Channel> channelOfPower(const ResidualTable& table) {
  for (const Channel channel : {kEpw, kIntensity})
    if (table.isOf(nameOf(channel), "bias")) return channel;
  return std::nullopt;
}

}  // namespace

Law shortestLaw(const Replay& replay, const std::vector<Covariate>& covariates, const ResidualTable& table,
                const CellsOfSamples& expected, const Residuals& fit, const Residuals& judge) {
  Law law = selected(covariates, fit, judge);
  law.unit = table.unit;
  if (const std::optional<Channel> channel = channelOfPower(table)) {
    const auto fit_parts = inPartsOfPower(replay, expected, *channel, fit);
    const auto judge_parts = inPartsOfPower(replay, expected, *channel, judge);
    Law in_parts = fit_parts && judge_parts ? selected(covariates, *fit_parts, *judge_parts) : Law{};
    in_parts.relative = true;
    if (in_parts.explained > law.explained) law = std::move(in_parts);
  }
  law.measurand = table.measurand;
  law.component = table.component;
  return law;
}

}  // namespace gap
