#include "metrics/prediction/regression.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/json_object.h"
#include "core/random.h"
#include "metrics/prediction/prediction.h"
#include "tests/metrics/prediction/error_cases.h"
#include "tests/support/paths.h"

namespace {

using metrics::coefficientsOf;
using metrics::ErrorSamples;
using metrics::Family;
using metrics::fittedValue;
using metrics::regress;
using metrics::Regression;
using metrics_test::overRange;
using metrics_test::overTwo;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

Family familyNamed(const std::string& wanted) {
  for (const Family family : metrics::kFamilies) {
    if (metrics::name(family) == wanted) return family;
  }
  throw std::invalid_argument(wanted);
}

ErrorSamples samplesOf(const nlohmann::json& reference) {
  ErrorSamples samples{.target = "d_bias", .parameters = {"range_m"}, .points = {}, .errors = reference.at("errors")};
  for (const auto& point : reference.at("points")) {
    for (const double x : point) samples.points.push_back(x);
  }
  if (reference.at("points").at(0).size() == 2) samples.parameters.emplace_back("angle_deg");
  samples.weights = reference.at("weights").get<std::vector<double>>();
  return samples;
}

// statsmodels and scipy (tests/data/metrics/prediction/make_regressions.py). Linear families agree to rounding; for
// curves both sides stop where the sum of squares is flat, and the reference differentiates numerically.
TEST(Regression, AgreesWithStatsmodelsAndScipy) {
  for (const auto& reference : core::readJson(test_support::testData("metrics/prediction/regressions.json"))) {
    SCOPED_TRACE(reference.at("name"));
    const Family family = familyNamed(reference.at("family"));
    const double relative = metrics::isLinearInCoefficients(family) ? 1e-9 : 1e-5;
    const metrics::Prediction prediction =
        predict(samplesOf(reference), {.family = family, .level = reference.at("level")});
    const Regression& regression = prediction.regression;
    EXPECT_EQ(regression.dof, reference.at("dof").get<std::size_t>());
    const double sd = reference.at("residual_sd");
    EXPECT_NEAR(regression.residual_sd, sd, relative * sd);
    const auto coefficients = coefficientsOf(regression);
    ASSERT_EQ(coefficients.size(), reference.at("coefficients").size());
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      const double error = reference.at("standard_errors").at(k);
      EXPECT_NEAR(coefficients[k].value, reference.at("coefficients").at(k).get<double>(), relative * error) << k;
      EXPECT_NEAR(coefficients[k].standard_error, error, relative * error) << k;
    }
    for (const auto& at : reference.at("at")) {
      const auto error = prediction.at(at.at("x").get<std::vector<double>>());
      const double tolerance = relative * (error.observation.high - error.observation.low);
      EXPECT_NEAR(error.value, at.at("value").get<double>(), tolerance);
      EXPECT_NEAR(error.confidence.low, at.at("confidence").at(0).get<double>(), tolerance);
      EXPECT_NEAR(error.confidence.high, at.at("confidence").at(1).get<double>(), tolerance);
      EXPECT_NEAR(error.observation.low, at.at("observation").at(0).get<double>(), tolerance);
      EXPECT_NEAR(error.observation.high, at.at("observation").at(1).get<double>(), tolerance);
    }
  }
}

TEST(Regression, RecoversALineExactly) {
  const Regression regression =
      regress(overRange({10, 20, 40}, [](double x) { return 0.5 - 0.25 * x; }), Family::Linear);
  const auto coefficients = coefficientsOf(regression);
  EXPECT_EQ(coefficients[0].name, "intercept");
  EXPECT_EQ(coefficients[1].name, "range_m");
  EXPECT_NEAR(coefficients[0].value, 0.5, 1e-13);
  EXPECT_NEAR(coefficients[1].value, -0.25, 1e-14);
  EXPECT_NEAR(regression.residual_sd, 0.0, 1e-13);
}

TEST(Regression, RecoversEveryTermOfASurfaceInTwoParameters) {
  const auto truth = [](double x, double y) {
    return 1.0 + 2.0 * x + 3.0 * y + 4.0 * x * x + 5.0 * x * y + 6.0 * y * y;
  };
  const Regression regression = regress(overTwo(25, truth), Family::Quadratic);
  const auto coefficients = coefficientsOf(regression);
  const std::vector<std::string> names{"intercept", "range_m",           "angle_deg",
                                       "range_m^2", "range_m*angle_deg", "angle_deg^2"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    EXPECT_EQ(coefficients[k].name, names[k]);
    EXPECT_NEAR(coefficients[k].value, static_cast<double>(k + 1), 1e-8) << names[k];  // x^2 up to 1e4: 1e4 eps / eps
  }
}

TEST(Regression, RecoversExponentialsOfEitherSign) {
  for (const double rate : {-0.2, -0.03, 0.01, 0.1}) {
    const auto truth = [rate](double x) { return 0.1 - 0.3 * std::exp(rate * x); };
    const Regression regression = regress(overRange({2, 7, 12, 20, 31, 45}, truth), Family::Exponential);
    const auto coefficients = coefficientsOf(regression);
    EXPECT_NEAR(coefficients[0].value, 0.1, 1e-6);
    EXPECT_NEAR(coefficients[1].value, -0.3, 1e-6);
    EXPECT_NEAR(coefficients[2].value, rate, 1e-6);
    EXPECT_EQ(coefficients[2].name, "rate range_m");
  }
}

TEST(Regression, RecoversSigmoidsThatRiseAndFall) {
  for (const double height : {-0.5, 0.5}) {
    const auto truth = [height](double x) { return 0.2 + height / (1.0 + std::exp(-(0.3 * x - 6.0))); };
    const Regression regression = regress(overRange({0, 5, 12, 16, 19, 22, 30, 42}, truth), Family::Sigmoid);
    const auto coefficients = coefficientsOf(regression);
    EXPECT_NEAR(coefficients[0].value, 0.2, 1e-6);
    EXPECT_NEAR(coefficients[1].value, height, 1e-6);
    EXPECT_NEAR(coefficients[2].value, -6.0, 1e-5);
    EXPECT_NEAR(coefficients[3].value, 0.3, 1e-6);  // never negative: the other way to write it has -height
  }
}

TEST(Regression, RecoversCurvesAlongAnyDirectionOfTwoParameters) {
  const auto decay = [](double x, double y) { return 0.1 + 0.7 * std::exp(-0.02 * x + 0.015 * y); };
  const auto step = [](double x, double y) { return 0.1 + 0.7 / (1.0 + std::exp(-(0.1 * x - 0.1 * y - 2.0))); };
  const auto growth = coefficientsOf(regress(overTwo(40, decay), Family::Exponential));
  EXPECT_NEAR(growth[2].value, -0.02, 1e-7);
  EXPECT_NEAR(growth[3].value, 0.015, 1e-7);
  const auto edge = coefficientsOf(regress(overTwo(60, step), Family::Sigmoid));
  EXPECT_NEAR(edge[2].value, -2.0, 1e-6);
  EXPECT_NEAR(edge[3].value, 0.1, 1e-7);
  EXPECT_NEAR(edge[4].value, -0.1, 1e-7);
}

// A row of weight 2 is two rows of weight 1; only the degrees of freedom know the difference.
TEST(Regression, WeightsAreRepetitions) {
  ErrorSamples weighted = overRange({1, 2, 4, 7}, [](double x) { return std::sin(x); });
  weighted.weights = {2.0, 1.0, 1.0, 3.0};
  const ErrorSamples repeated = overRange({1, 1, 2, 4, 7, 7, 7}, [](double x) { return std::sin(x); });
  for (const Family family : {Family::Constant, Family::Linear, Family::Quadratic}) {
    const Regression once = regress(weighted, family);
    const Regression often = regress(repeated, family);
    for (const double x : {0.0, 3.0, 9.0}) {
      EXPECT_NEAR(fittedValue(once, std::array{x}).value, fittedValue(often, std::array{x}).value, 1e-12);
    }
  }
}

TEST(Regression, ACommonFactorOfAllWeightsChangesNothing) {
  ErrorSamples samples = overRange({1, 2, 4, 7, 9}, [](double x) { return std::sin(x); });
  samples.weights = {1.0, 2.0, 3.0, 2.0, 1.0};
  const Regression before = regress(samples, Family::Linear);
  for (double& w : samples.weights) w *= 1000.0;
  const Regression after = regress(samples, Family::Linear);
  EXPECT_NEAR(after.residual_sd, before.residual_sd, 1e-15);
  EXPECT_NEAR(fittedValue(after, std::array{3.0}).leverage, fittedValue(before, std::array{3.0}).leverage, 1e-14);
}

// Their sum is the number of coefficients: the trace of the hat matrix.
TEST(Regression, LeveragesOfTheSamplesAddUpToTheNumberOfCoefficients) {
  core::Random random({.seed = 1});
  const ErrorSamples samples =
      overTwo(30, [&](double x, double y) { return 1e-3 * x + std::exp(-0.05 * y) + 0.01 * random.normal(); });
  for (const Family family : {Family::Constant, Family::Linear, Family::Quadratic, Family::Exponential}) {
    const Regression regression = regress(samples, family);
    double sum = 0.0;
    for (std::size_t row = 0; row < samples.size(); ++row) sum += fittedValue(regression, samples.point(row)).leverage;
    EXPECT_NEAR(sum, static_cast<double>(regression.coefficients.size()), 1e-9) << metrics::name(family);
  }
}

// Time stamps of today in seconds: 1.7e9 with a span of minutes. Centred, nothing is lost.
TEST(Regression, FarFromZeroTheSlopeIsKept) {
  const double today = 1.7e9;
  const Regression regression =
      regress(overRange({today, today + 60, today + 120, today + 200}, [=](double x) { return 1e-3 * (x - today); }),
              Family::Linear);
  EXPECT_NEAR(fittedValue(regression, std::array{today + 100}).value, 0.1, 1e-12);
}

TEST(Regression, AsManyRowsAsCoefficientsLeaveNoDegreesOfFreedom) {
  const Regression regression = regress(overRange({1, 2}, [](double x) { return x * x; }), Family::Linear);
  EXPECT_EQ(regression.dof, 0u);
  EXPECT_TRUE(std::isnan(regression.residual_sd));
  EXPECT_NEAR(fittedValue(regression, std::array{3.0}).value, 7.0, 1e-14);
  EXPECT_TRUE(std::isnan(coefficientsOf(regression)[1].standard_error));
}

TEST(Regression, NamesCollinearParameters) {
  ErrorSamples samples{
      .target = "d_bias", .parameters = {"range_m", "rain_mm_h", "range_cm"}, .points = {}, .errors = {}};
  for (int i = 0; i < 6; ++i) {
    samples.points.insert(samples.points.end(), {10.0 + i, (i % 3) * 1.0, 1000.0 + 100.0 * i});
    samples.errors.push_back(i);
  }
  EXPECT_THAT([&] { (void)regress(samples, Family::Linear); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("range_cm"), HasSubstr("follows from range_m in"))));
}

TEST(Regression, NamesAParameterThatNeverChanges) {
  const ErrorSamples samples = overRange({5, 5, 5}, [](double) { return 1.0; });
  EXPECT_THAT([&] { (void)regress(samples, Family::Linear); },
              ThrowsMessage<core::InputError>(HasSubstr("range_m: is 5 in every row")));
  EXPECT_NO_THROW((void)regress(samples, Family::Constant));
}

TEST(Regression, NamesTheTermThatTheRowsDoNotDetermine) {
  const ErrorSamples samples = overRange({1, 1, 2, 2}, [](double x) { return x; });
  EXPECT_THAT([&] { (void)regress(samples, Family::Quadratic); },
              ThrowsMessage<core::InputError>(HasSubstr("quadratic: these rows do not determine")));
}

TEST(Regression, RefusesFewerRowsThanCoefficients) {
  const ErrorSamples samples = overRange({1, 2}, [](double x) { return x; });
  EXPECT_THAT([&] { (void)regress(samples, Family::Quadratic); },
              ThrowsMessage<core::InputError>(HasSubstr("has 3 coefficients; 2 rows are too few")));
}

TEST(Regression, AStraightLineIsNoCurve) {
  const ErrorSamples samples = overRange({1, 2, 3, 4, 5, 6, 7}, [](double x) { return x; });
  EXPECT_THROW((void)regress(samples, Family::Exponential), core::InputError);
  EXPECT_THROW((void)regress(samples, Family::Sigmoid), core::InputError);
  const ErrorSamples flat = overRange({1, 2, 3, 4, 5, 6, 7}, [](double) { return 0.7; });
  EXPECT_THROW((void)regress(flat, Family::Exponential), core::InputError);
  EXPECT_THROW((void)regress(flat, Family::Sigmoid), core::InputError);
}

TEST(Regression, RefusesBadRowsByNumber) {
  const ErrorSamples good = overRange({1, 2, 3}, [](double x) { return x; });
  const auto expect = [](const ErrorSamples& bad, const std::string& words) {
    EXPECT_THAT([&] { (void)regress(bad, Family::Linear); }, ThrowsMessage<core::InputError>(HasSubstr(words)));
  };
  ErrorSamples bad = good;
  bad.points[1] = std::nan("");
  expect(bad, "range_m, row 2");
  bad = good;
  bad.errors[2] = INFINITY;
  expect(bad, "d_bias, row 3");
  bad = good;
  bad.weights = {1.0, 0.0, 1.0};
  expect(bad, "weight, row 2");
  bad = good;
  bad.weights = {1.0};
  expect(bad, "weights: has 1 entries; 3");
  bad = good;
  bad.parameters = {"a", "a"};
  expect(bad, "given twice");
  expect({.target = "d_bias", .parameters = {"range_m"}, .points = {}, .errors = {}}, "no samples");
  expect({.target = "d_bias", .parameters = {}, .points = {}, .errors = {}}, "0 are given");
}

}  // namespace
