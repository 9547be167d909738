#include "metrics/series/series_metrics.h"

#include <utility>
#include <vector>

#include "metrics/series/correlation.h"
#include "metrics/series/dynamic_time_warping.h"
#include "metrics/series/lagged_correlation.h"
#include "metrics/series/paired_differences.h"

namespace metrics {

namespace {

using Input = SeriesInput;
using Numbers = std::vector<double>;
using Entry = MetricOf<Input>;
constexpr std::string_view kDistances = "Deza & Deza 2016, doi:10.1007/978-3-662-52844-0";
constexpr std::string_view kTable = "Rosenberger 2022, Tab. 4-3; read as a sum of magnitudes";
constexpr std::string_view kWillmott = "Willmott & Matsuura 2005, doi:10.3354/cr030079";
constexpr std::string_view kBox = "Box, Jenkins & Reinsel 2008, doi:10.1002/9781118619193";

/// Where lags count, values must be evenly spaced in time; unknown times are believed to be.
const Input& evenlySampled(const Input& input) {
  if (!input.times_s.empty()) requireEvenSteps(input.times_s, input.measured.size());
  return input;
}

Numbers crossCorrelationAndLag(const Input& input) {
  const CrossCorrelation best = crossCorrelation(evenlySampled(input).pair(), input.largest_lag);
  return {best.maximum, best.lag};
}

/// What all of them share: they read series whose differences mean something.
MetricInfo aboutSeries(MetricInfo info) {
  info.scale = Scale::Interval;
  info.data = {DataKind::Series};
  return info;
}

Entry number(MetricInfo info, double (*compute)(const Input&)) {
  return {.info = aboutSeries(std::move(info)),
          .compute = [compute](const Input& input) { return Numbers{compute(input)}; }};
}

/// Of the pairs alone, without options.
Entry ofPairs(MetricInfo info, double (*compute)(const SeriesPair&)) {
  return {.info = aboutSeries(std::move(info)),
          .compute = [compute](const Input& input) { return Numbers{compute(input.pair())}; }};
}

Entry object(MetricInfo info, std::vector<std::string_view> parts, Numbers (*compute)(const Input&)) {
  return {.info = aboutSeries(std::move(info)),
          .shape = MetricShape::Object,
          .parts = std::move(parts),
          .compute = compute};
}

/// The list: one entry a metric. x real, y simulated.
std::vector<Entry> makeList() {
  return {
      ofPairs({.number = 1,
               .name = "manhattan",
               .title = "Manhattan distance",
               .meaning = "sum of |difference|; grows with n, see mean_error",
               .formula = "sum |y - x|",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Measurand,
               .source = kDistances,
               .meets = "12345"},
              manhattanDistance),
      ofPairs({.number = 2,
               .name = "overall_error",
               .title = "Overall error",
               .meaning = "sum of |difference|, on paired values the same as manhattan",
               .formula = "sum |y - x|",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Measurand,
               .source = kTable,
               .meets = "12345"},
              manhattanDistance),
      ofPairs({.number = 3,
               .name = "mean_error",
               .title = "Mean error",
               .meaning = "mean of |difference|, not |difference of means| as the dissertation's tables print",
               .formula = "sum |y - x| / n",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Measurand,
               .source = kWillmott,
               .meets = "123457"},
              meanAbsoluteError),
      ofPairs({.name = "mean_signed_error",
               .title = "Mean signed error",
               .meaning = "mean of simulated - measured; > 0: simulation too high",
               .formula = "sum (y - x) / n",
               .best = "0",
               .worst = "-inf or inf",
               .unit = MetricUnit::Measurand,
               .source = kWillmott,
               .meets = "157"},
              meanSignedError),
      ofPairs({.number = 4,
               .name = "euclidean",
               .title = "Euclidean distance",
               .meaning = "root of the sum of squared differences; grows with n, see rmse",
               .formula = "sqrt(sum (y - x)^2)",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Measurand,
               .source = kDistances,
               .meets = "12345"},
              euclideanDistance),
      ofPairs({.number = 5,
               .name = "rss",
               .title = "Residual sum of squares",
               .meaning = "sum of squared differences; grows with n, see mean_square_error",
               .formula = "sum (y - x)^2",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Square,
               .source = "Draper & Smith 1998, doi:10.1002/9781118625590",
               .meets = "123"},
              residualSumOfSquares),
      ofPairs({.name = "mean_square_error",
               .title = "Mean square error",
               .meaning = "mean of squared differences",
               .formula = "sum (y - x)^2 / n",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Square,
               .source = kWillmott,
               .meets = "1237"},
              meanSquareError),
      ofPairs({.number = 6,
               .name = "chebyshev",
               .title = "Chebyshev distance",
               .meaning = "largest |difference|: one outlier decides",
               .formula = "max |y - x|",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Measurand,
               .source = kDistances,
               .meets = "13457"},
              chebyshevDistance),
      ofPairs({.number = 7,
               .name = "rmse",
               .title = "Root mean square error",
               .meaning = "root of the mean of squared differences",
               .formula = "sqrt(sum (y - x)^2 / n)",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Measurand,
               .source = kWillmott,
               .meets = "123457"},
              rootMeanSquareError),
      ofPairs({.number = 20,
               .name = "pearson",
               .title = "Pearson correlation coefficient",
               .meaning = "linear relation, blind to offset and gain; NaN if a series is constant",
               .formula = "sum (x - mean x)(y - mean y) / sqrt(sum (x - mean x)^2 sum (y - mean y)^2)",
               .best = "1",
               .worst = "-1",
               .unit = MetricUnit::None,
               .source = "Pearson 1895, doi:10.1098/rspl.1895.0041",
               .meets = "127"},
              pearsonCorrelation),
      object({.number = 21,
              .name = "cross_correlation",
              .title = "Cross-correlation",
              .meaning = "largest normalised one and its lag, > 0: simulation late; NaN if a series is constant",
              .formula = "max over k of sum_i (x_i - mean x)(y_(i+k) - mean y) / sqrt(...), as for pearson",
              .best = "1 at lag 0",
              .worst = "-1",
              .unit = MetricUnit::None,
              .source = kBox,
              .meets = "27"},
             {"maximum", "lag"}, crossCorrelationAndLag),
      number({.number = 22,
              .name = "autocorrelation_difference",
              .title = "Autocorrelation difference",
              .meaning = "mean |difference| of the autocorrelations, blind to phase; NaN if a series is constant",
              .formula = "sum_(k=1..K) |a_y(k) - a_x(k)| / K",
              .best = "0",
              .worst = "2",
              .unit = MetricUnit::None,
              .source = kBox,
              .meets = "27"},
             [](const Input& in) { return autocorrelationDifference(evenlySampled(in).pair(), in.largest_lag); }),
      number({.number = 23,
              .name = "dtw",
              .title = "Dynamic time warping",
              .meaning = "least sum of |difference| if either series may wait; grows with n",
              .formula = "D(i,j) = |y_i - x_j| + min(D(i-1,j), D(i,j-1), D(i-1,j-1))",
              .best = "0",
              .worst = "inf",
              .unit = MetricUnit::Measurand,
              .source = "Sakoe & Chiba 1978, doi:10.1109/TASSP.1978.1163055",
              .meets = "125"},
             [](const Input& in) { return dynamicTimeWarping(in.pair(), in.warping_window); }),
      ofPairs({.name = "r_squared",
               .title = "Coefficient of determination",
               .meaning = "share of the measured variance that is simulated; NaN if the measured series is constant",
               .formula = "1 - sum (y - x)^2 / sum (x - mean x)^2",
               .best = "1",
               .worst = "-inf",
               .unit = MetricUnit::None,
               .source = "Nash & Sutcliffe 1970, doi:10.1016/0022-1694(70)90255-6",
               .meets = "1237"},
              coefficientOfDetermination),
  };
}

}  // namespace

std::span<const MetricOf<SeriesInput>> seriesMetrics() {
  static const std::vector<Entry> list = makeList();
  return list;
}

}  // namespace metrics
