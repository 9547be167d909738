#include "metrics/samples/samples_metrics.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "metrics/samples/anderson_darling.h"
#include "metrics/samples/classifier_two_sample.h"
#include "metrics/samples/divergences.h"
#include "metrics/samples/kolmogorov_smirnov.h"
#include "metrics/samples/moment_differences.h"
#include "metrics/samples/positive_ks_tests.h"
#include "metrics/samples/sample_values.h"
#include "metrics/samples/wasserstein.h"

namespace metrics {

namespace {

using Entry = MetricOf<SamplePair>;
using Numbers = std::vector<double>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kMoments = "textbook";
constexpr std::string_view kStephens = "Stephens 1970, doi:10.1111/j.2517-6161.1970.tb00821.x";
constexpr std::string_view kScholz = "Scholz & Stephens 1987, doi:10.1080/01621459.1987.10478517";

/// What all of them share: they read values, and know no p-box.
MetricInfo aboutValues(MetricInfo info) {
  info.data = {DataKind::Values};
  return info;
}

Entry number(MetricInfo info, double (*compute)(const SamplePair&)) {
  return {.info = aboutValues(std::move(info)),
          .compute = [compute](const SamplePair& samples) { return Numbers{compute(samples)}; }};
}

Entry object(MetricInfo info, std::vector<std::string_view> parts, Numbers (*compute)(const SamplePair&)) {
  return {.info = aboutValues(std::move(info)),
          .shape = MetricShape::Object,
          .parts = std::move(parts),
          .compute = compute};
}

Numbers ks(const SamplePair& samples) {
  const KolmogorovSmirnov test = kolmogorovSmirnovTest(samples);
  return {test.statistic, test.p_value};
}

/// `exact` is 1 where the p-value is.
Numbers ksExact(const SamplePair& samples) {
  const KolmogorovSmirnov test = kolmogorovSmirnovTest(samples, KsPValue::ExactIfSmall);
  return {test.statistic, test.p_value, test.method == KsPValue::ExactIfSmall ? 1.0 : 0.0};
}

double ksPositive(const SamplePair& samples) { return positiveKsTests(std::array{samples}).frequency; }

double tieShare(const SamplePair& samples) {
  return samples.simulated.n() > 0 && samples.measured.n() > 0 ? kolmogorovSmirnovTest(samples).tie_share : kNaN;
}

Numbers andersonDarling(const SamplePair& samples) {
  const AndersonDarling test = andersonDarlingTest(samples);
  return {test.statistic, test.p_value};
}

double andersonDarlingNormal(const SamplePair& samples) {
  if (!(samples.measured.standardDeviation() > 0.0)) return kNaN;
  return andersonDarlingToFittedNormal(samples).statistic;
}

/// Of the kernel densities; not a number where more than half of a sample is one value.
Divergences kde(const SamplePair& samples) {
  if (kdeBandwidth(samples.simulated) > 0.0 && kdeBandwidth(samples.measured) > 0.0) return kdeDivergences(samples);
  return {.kl = kNaN, .kl_reverse = kNaN, .symmetrised = kNaN, .js = kNaN, .js_distance = kNaN};
}

Numbers kl(const SamplePair& samples) {
  const Divergences of = kde(samples);
  return {of.kl, of.kl_reverse, of.symmetrised};
}

/// Half split with the first seed; not a number for weighted samples, tables and single values.
Numbers c2st(const SamplePair& samples) {
  for (const Edf* edf : {&samples.simulated, &samples.measured}) {
    if (!isPlainSample(*edf) || edf->n() < 2) return {kNaN, kNaN};
  }
  const std::vector<double> simulated = sampleValues(samples.simulated, "simulated");
  const std::vector<double> measured = sampleValues(samples.measured, "measured");
  const ClassifierTwoSample test = classifierTwoSampleTest({.simulated = simulated, .measured = measured});
  return {test.accuracy, test.p_value};
}

/// The list: one entry a metric. x real, y simulated.
std::vector<Entry> makeList() {
  return {
      object({.name = "ks",
              .title = "Kolmogorov-Smirnov test",
              .meaning = "largest distance of the CDFs, pooled; p too large with ties",
              .formula = "max |F_y - F_x|",
              .best = "0, p 1",
              .worst = "1, p 0",
              .unit = MetricUnit::None,
              .scale = Scale::Ordinal,
              .source = kStephens,
              .meets = "12347"},
             {"statistic", "p_value"}, ks),
      number({.number = 9,
              .name = "wasserstein_1",
              .title = "Wasserstein distance",
              .meaning = "1-Wasserstein distance, pooled",
              .formula = "int |F_y(z) - F_x(z)| dz",
              .best = "0",
              .worst = "inf",
              .unit = MetricUnit::Measurand,
              .scale = Scale::Interval,
              .source = "Vallender 1974, doi:10.1137/1118101",
              .meets = "123457"},
             wassersteinDistance),
      number({.name = "mean_difference",
              .title = "Difference of means",
              .meaning = "simulated - measured mean, pooled; > 0: simulation too high",
              .formula = "mean y - mean x",
              .best = "0",
              .worst = "-inf or inf",
              .unit = MetricUnit::Measurand,
              .scale = Scale::Interval,
              .source = kMoments,
              .meets = "157"},
             meanDifference),
      number({.name = "median_difference",
              .title = "Difference of medians",
              .meaning = "simulated - measured median, pooled; > 0: simulation too high",
              .formula = "median y - median x",
              .best = "0",
              .worst = "-inf or inf",
              .unit = MetricUnit::Measurand,
              .scale = Scale::Interval,
              .source = kMoments,
              .meets = "157"},
             medianDifference),
      number({.name = "std_difference",
              .title = "Difference of standard deviations",
              .meaning = "simulated - measured standard deviation (n - 1), pooled; > 0: simulation too wide",
              .formula = "s_y - s_x",
              .best = "0",
              .worst = "-inf or inf",
              .unit = MetricUnit::Measurand,
              .scale = Scale::Interval,
              .source = kMoments,
              .meets = "157"},
             standardDeviationDifference),
      number({.name = "abs_mean_difference",
              .title = "Magnitude of the difference of means",
              .meaning = "what tables print as mean error of two samples; the mean error itself needs pairs",
              .formula = "|mean y - mean x|",
              .best = "0",
              .worst = "inf",
              .unit = MetricUnit::Measurand,
              .scale = Scale::Interval,
              .on_request = true,
              .source = "Rosenberger 2022, Tab. 8-3 (d)",
              .meets = "1457"},
             [](const SamplePair& samples) { return std::abs(meanDifference(samples)); }),
      object({.name = "ks_exact",
              .title = "Kolmogorov-Smirnov test, exact",
              .meaning = "as ks; exact: 1 if the p-value is, 0 if samples are too large, weighted or tables",
              .formula = "max |F_y - F_x|",
              .best = "0, p 1",
              .worst = "1, p 0",
              .unit = MetricUnit::None,
              .scale = Scale::Ordinal,
              .on_request = true,
              .source = "Hodges 1958, doi:10.1007/BF02589501",
              .meets = "12347"},
             {"statistic", "p_value", "exact"}, ksExact),
      number({.number = 33,
              .name = "ks_positive",
              .title = "Frequency of positive KS tests",
              .meaning = "1 if ks rejects at 5 %, 0 if not; n and m from 12; average it over many pairs",
              .formula = "[p <= 0.05]",
              .best = "0",
              .worst = "1",
              .unit = MetricUnit::None,
              .scale = Scale::Ordinal,
              .on_request = true,
              .source = kStephens},
             ksPositive),
      number({.name = "tie_share",
              .title = "Share of ties",
              .meaning = "share of the pooled values that repeat another; from 0.05 distrust p-values of ks",
              .formula = "1 - distinct values / (n + m)",
              .best = "-",
              .worst = "1",
              .unit = MetricUnit::None,
              .scale = Scale::Nominal,
              .on_request = true,
              .source = "this project; see metrics/samples/kolmogorov_smirnov.h"},
             tieShare),
      object({.name = "anderson_darling",
              .title = "Anderson-Darling test",
              .meaning = "distance of the CDFs that heeds the tails, mid-ranks for ties; grows with n",
              .formula = "nm/N int (F_y - F_x)^2 / (H (1 - H)) dH, H pooled, N = n + m",
              .best = "0, p 1",
              .worst = "inf, p 0",
              .unit = MetricUnit::None,
              .scale = Scale::Ordinal,
              .source = kScholz,
              .meets = "123"},
             {"statistic", "p_value"}, andersonDarling),
      number({.name = "anderson_darling_normal",
              .title = "Anderson-Darling distance to a fitted normal",
              .meaning = "of the simulated sample to a normal fitted to the measured one; always finite; not symmetric",
              .formula = "n int (F_y - Phi)^2 / (Phi (1 - Phi)) dPhi",
              .best = "near 1",
              .worst = "inf",
              .unit = MetricUnit::None,
              .scale = Scale::Interval,
              .on_request = true,
              .source = "Anderson & Darling 1954, doi:10.2307/2281537; Rosenberger 2022, Tab. 8-4",
              .meets = "12"},
             andersonDarlingNormal),
      object({.number = 30,
              .name = "kl",
              .title = "Kullback-Leibler divergence",
              .meaning = "of kernel densities, real from simulated, the other way, their mean; inf: missing support",
              .formula = "sum p_x log2(p_x / p_y)",
              .best = "0",
              .worst = "inf",
              .unit = MetricUnit::Bit,
              .scale = Scale::Interval,
              .on_request = true,
              .source = "Kullback & Leibler 1951, doi:10.1214/aoms/1177729694",
              .meets = "237"},
             {"measured_simulated", "simulated_measured", "symmetrised"}, kl),
      number({.number = 31,
              .name = "js",
              .title = "Jensen-Shannon distance",
              .meaning = "of kernel densities: root of js_divergence",
              .formula = "sqrt((D(p_x || p) + D(p_y || p)) / 2), p = (p_x + p_y) / 2",
              .best = "0",
              .worst = "1",
              .unit = MetricUnit::None,
              .scale = Scale::Interval,
              .on_request = true,
              .source = "Endres & Schindelin 2003, doi:10.1109/TIT.2003.813506",
              .meets = "2347"},
             [](const SamplePair& samples) { return kde(samples).js_distance; }),
      number({.name = "js_divergence",
              .title = "Jensen-Shannon divergence",
              .meaning = "of kernel densities: mean divergence from their mixture; always finite",
              .formula = "(D(p_x || p) + D(p_y || p)) / 2, p = (p_x + p_y) / 2",
              .best = "0",
              .worst = "1",
              .unit = MetricUnit::Bit,
              .scale = Scale::Interval,
              .on_request = true,
              .source = "Lin 1991, doi:10.1109/18.61115",
              .meets = "237"},
             [](const SamplePair& samples) { return kde(samples).js; }),
      object({.number = 34,
              .name = "c2st",
              .title = "Classifier two-sample test",
              .meaning = "how often a neighbours' vote tells simulated values; in place of the learned metric 34",
              .formula = "(share of x told right + share of y told right) / 2",
              .best = "0.5",
              .worst = "1, p 0",
              .unit = MetricUnit::None,
              .scale = Scale::Interval,
              .on_request = true,
              .source = "Lopez-Paz & Oquab 2017, arXiv:1610.06545; 34 is Ngo et al. 2021, arXiv:2104.06772",
              .meets = "27"},
             {"accuracy", "p_value"}, c2st),
  };
}

}  // namespace

std::span<const MetricOf<SamplePair>> samplesMetrics() {
  static const std::vector<Entry> list = makeList();
  return list;
}

}  // namespace metrics
