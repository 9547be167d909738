#include "metrics/area/area_metrics.h"

#include "metrics/area/area_range.h"
#include "metrics/area/double_metric.h"
#include "metrics/area/largest_area_metric.h"
#include "metrics/area/modified_area_metric.h"
#include "metrics/area/signed_scatter.h"
#include "metrics/area/white_west_metric.h"

namespace metrics {

namespace {

using Input = MetricInput;
using Numbers = std::vector<double>;

constexpr std::string_view kFerson = "Ferson et al. 2008, doi:10.1016/j.cma.2007.07.030";
constexpr std::string_view kVoyles = "Voyles & Roy 2015, doi:10.2514/6.2015-1817";
constexpr std::string_view kRosenberger = "Rosenberger 2023, doi:10.26083/tuprints-00023034, ch. 9";
constexpr std::string_view kBothWays = "-inf or inf";

/// What all of them have in common: they need differences, so an interval scale, and take p-boxes.
MetricInfo info(std::string_view name, std::string_view title, std::string_view meaning, std::string_view formula,
                std::string_view worst, std::string_view source, std::string_view meets) {
  return {.name = name,
          .title = title,
          .meaning = meaning,
          .formula = formula,
          .best = "0",
          .worst = worst,
          .unit = MetricUnit::Measurand,
          .scale = Scale::Interval,
          .data = {DataKind::Values},
          .p_box = true,
          .source = source,
          .meets = meets};
}

Metric number(MetricInfo about, double (*compute)(const Input&)) {
  return {.info = std::move(about), .compute = [compute](const Input& input) { return Numbers{compute(input)}; }};
}

Metric list(MetricInfo about, std::vector<std::string_view> parts, Numbers (*compute)(const Input&)) {
  return {.info = std::move(about), .shape = MetricShape::List, .parts = std::move(parts), .compute = compute};
}

MetricInfo numbered(int number, MetricInfo about) {
  about.number = number;
  return about;
}

Numbers dvm(const Input& input) {
  const DoubleValidation& dvm = input.options.shift == Shift::One ? input.one_shift : input.balanced;
  return {dvm.bias, dvm.scatter};
}

Numbers bothEdges(const Input& input) {
  const DoubleMetric metric = doubleMetric(input.boxes);
  return {metric.left, metric.right};
}

Numbers mavm(const Input& input) {
  const ModifiedArea interval = modifiedAreaMetric(input.portions, input.experiments);
  return {interval.lower, interval.upper};
}

Numbers range(const Input& input) {
  const AreaRange range = areaRange(input.boxes);
  return {range.smallest, range.largest};
}

Metric onRequest(Metric metric) {
  metric.info.on_request = true;
  return metric;
}

std::vector<Metric> makeList() {
  return {
      number(numbered(32, info("d_avm", "Area validation metric (AVM)",
                               "area between the distributions; 0 where p-boxes overlap", "d+ + d-", "inf", kFerson,
                               "1234567")),
             [](const Input& in) { return in.portions.area(); }),
      number(info("d_plus", "AVM, upper portion", "part of it with simulated values too small",
                  "int max(0, L_x(p) - R_y(p)) dp", "inf", kVoyles, "12567"),
             [](const Input& in) { return in.portions.d_plus; }),
      number(info("d_minus", "AVM, lower portion", "part of it with simulated values too large",
                  "int max(0, L_y(p) - R_x(p)) dp", "inf", kVoyles, "12567"),
             [](const Input& in) { return in.portions.d_minus; }),
      number(info("d_bias", "Bias of the double validation metric", "d_minus - d_plus; > 0: simulation too high",
                  "d- - d+", kBothWays, kRosenberger, "1567"),
             [](const Input& in) { return in.one_shift.bias; }),
      number(info("d_cavm", "Corrected AVM (CAVM)", "scatter: area left after the simulation is moved by -d_bias",
                  "d_avm(x, y - d_bias)", "inf", kRosenberger, "124567"),
             [](const Input& in) { return in.one_shift.scatter; }),
      number(info("residual_bias", "Residual bias", "bias left after that one shift; not 0 for p-boxes only",
                  "d_bias(x, y - d_bias)", kBothWays, "this project; see docs/metrics.md", "1567"),
             [](const Input& in) { return in.one_shift.residual; }),
      number(info("d_bias_balanced", "Balanced bias", "shift that leaves no bias", "b with d_bias(x, y - b) = 0",
                  kBothWays, "this project; see docs/metrics.md", "1567"),
             [](const Input& in) { return in.balanced.bias; }),
      number(info("d_cavm_balanced", "Balanced CAVM", "scatter: area left after the balanced shift", "d_avm(x, y - b)",
                  "inf", "this project; see docs/metrics.md", "124567"),
             [](const Input& in) { return in.balanced.scatter; }),
      list(info("dvm", "Double validation metric (DVM)", "double validation metric: bias and scatter",
                "[d_bias, d_cavm]", "[-inf or inf, inf]", kRosenberger, "123567"),
           {"bias", "scatter"}, dvm),
      list(info("double_metric", "Double metric", "area between left edges, between right edges",
                "[int |L_x - L_y| dp, int |R_x - R_y| dp]", "[inf, inf]", "Danquah; Rosenberger 2023, eq. 8-11",
                "1234567"),
           {"left", "right"}, bothEdges),
      list(info("d_mavm", "Modified area validation metric (MAVM)",
                "interval to add to a simulated value, with safety factor",
                "(d+ - d-)/2 -+ Fs (d+ + d-)/2, Fs = 1.25 + 3.3 n^(-1/3)", "[-inf, inf]", kVoyles, "23567"),
           {"lower", "upper"}, mavm),
      number(info("d_avm_max", "Largest AVM", "largest area of any distribution inside the simulated p-box",
                  "max over F in box of d_avm(x, F)", "inf", "Rosenberger 2023, ch. 8", "1234567"),
             [](const Input& in) { return largestAreaMetric(in.boxes).area; }),
      number(info("d_avm_max_error", "Error of the largest AVM", "half width of what is known of it; 0: exact", "-",
                  "inf", "this project; see metrics/area/largest_area_metric.h", ""),
             [](const Input& in) { return largestAreaMetric(in.boxes).error; }),
      onRequest(list(info("d_avm_range", "Range of the AVM",
                          "smallest and largest area over all pairs of distributions in both p-boxes",
                          "[min, max] over F, G in the boxes of d_avm(F, G)", "[inf, inf]",
                          "this project; see metrics/area/area_range.h", "1234567"),
                     {"smallest", "largest"}, range)),
      number(info("signed_scatter", "Signed scatter error",
                  "> 0: simulated scatter too wide; near 0 beside a large d_cavm: another shape, not another width",
                  "int sign(p - 1/2) (q_y(p) - d_bias - q_x(p)) dp", kBothWays,
                  "this project; see metrics/area/signed_scatter.h", "1567"),
             [](const Input& in) { return signedScatterAfterShift(in.boxes, in.one_shift.bias); }),
      number(info("signed_scatter_balanced", "Balanced signed scatter error",
                  "the same after the balanced shift: independent of an offset of either side",
                  "int sign(p - 1/2) (q_y(p) - b - q_x(p)) dp", kBothWays,
                  "this project; see metrics/area/signed_scatter.h", "1567"),
             [](const Input& in) { return signedScatterAfterShift(in.boxes, in.balanced.bias); }),
      number(info("d_avm_white_west", "AVM for mixed uncertainty",
                  "what the simulated p-box fails to cover of the measured one",
                  "int max(0, L_y - L_x) + max(0, R_x - R_y) dp", "inf", "White & West 2019, DATAWorks; our reading",
                  "1234567"),
             [](const Input& in) { return whiteWestPortions(in.boxes).area(); }),
      number(info("pbox_area", "Area of the p-box", "mean width of the simulated p-box", "int R_y(p) - L_y(p) dp",
                  "inf", "Ferson et al. 2003, SAND2002-4015", ""),
             [](const Input& in) { return in.boxes.simulated.area(); }),
  };
}

}  // namespace

std::span<const Metric> areaMetrics() {
  static const std::vector<Metric> list = makeList();
  return list;
}

}  // namespace metrics
