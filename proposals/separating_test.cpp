#include "proposals/separating_test.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "acceptance/evaluate.h"
#include "core/error.h"
#include "core/text.h"

namespace proposals {

namespace {

constexpr double kNoLimit = 1e300;

/// A number that a test could limit from above.
struct Limited {
  std::string expression;  ///< left side: "abs(d_bias)"
  std::string variable;    ///< "d_bias"
  double before = 0.0;     ///< its size, as a mean of the report or in the worst sample
  double after = 0.0;
};

bool isExistence(const ReportedGap& gap) { return gap.name == "missing" || gap.name == "extra"; }

/// What the cause takes away from a measurand's gap, in steps of the total gap.
double gainOf(const ReportedGap& gap) {
  ReportedGap after = gap;
  after.bias = gap.bias_after.value_or(gap.bias);
  after.scatter = gap.scatter_after.value_or(gap.scatter);
  return gap.weight() - after.weight();
}

std::vector<Limited> limitedOf(const ReportedGap& gap) {
  const auto size = [](double value) { return std::abs(value); };
  const double bias_after = size(gap.bias_after.value_or(gap.bias));
  if (isExistence(gap)) return {{gap.name + "_fraction", gap.name + "_fraction", gap.bias, bias_after}};
  return {{"abs(d_bias)", "d_bias", size(gap.bias), bias_after},
          {"d_cavm", "d_cavm", gap.scatter, gap.scatter_after.value_or(gap.scatter)}};
}

specs::AcceptanceTest testFor(const GapReport& report, const Bound& bound, const ReportedGap& gap,
                              const std::string& fallback) {
  specs::AcceptanceTest test;
  test.experiment = bound.experiment;
  test.model = bound.model;
  test.measurand = isExistence(gap) ? fallback : gap.name;
  test.metric = "dvm";
  test.samples = report.held_out;
  return test;
}

/// The size of each limited number in the worst sample, by re-simulation with a model.
std::vector<double> worstOf(const specs::AcceptanceTest& test, const std::vector<Limited>& limited, const Bound& bound,
                            std::shared_ptr<const model::LidarModel> lidar, core::Progress& progress) {
  acceptance::TestTask task;
  task.test = test;
  task.test.id = "proposed test";
  task.folder = bound.folder;
  task.lidar = std::move(lidar);
  for (const Limited& number : limited) {
    task.test.expression +=
        (task.test.expression.empty() ? "" : " && ") + number.expression + " <= " + fmt::format("{:g}", kNoLimit);
  }
  const acceptance::TestResult result = acceptance::evaluate(task, progress);
  if (result.samples.empty()) {
    throw core::InputError({.item = "proposed acceptance test"}, result.text,
                           "Name the package with --experiment and the model with --model, as they were diagnosed.");
  }
  std::vector<double> worst(limited.size(), 0.0);
  for (const acceptance::SampleResult& sample : result.samples) {
    for (std::size_t i = 0; i < limited.size(); ++i) {
      const auto value = sample.values.find(limited[i].variable);
      const bool known = value != sample.values.end() && !std::isnan(value->second);
      worst[i] = std::max(worst[i], known ? std::abs(value->second) : std::numeric_limits<double>::infinity());
    }
  }
  return worst;
}

/// The number that improves most for its size before; nothing if none does.
const Limited* bestOf(const std::vector<Limited>& limited) {
  const Limited* best = nullptr;
  const auto gain = [](const Limited& number) { return number.before - number.after; };
  for (const Limited& number : limited) {
    if (!std::isfinite(number.after) || !(gain(number) > 0.0)) continue;
    if (!best || gain(number) > gain(*best)) best = &number;
  }
  return best;
}

void word(SeparatingTest& separating, const GapReport& report, const Limited& number, double limit,
          const std::string& unit) {
  const auto shown = [&](double value) {
    return std::isinf(value) ? std::string("nothing simulated")
                             : core::significant(value) + (unit.empty() ? "" : " " + unit);
  };
  specs::AcceptanceTest& test = separating.test;
  const std::string cause = core::join(report.verdict.names, " and ");
  test.expression = number.expression + " <= " + core::shortestNumber(limit);
  test.title = fmt::format("{} of {} with {}", number.variable, test.measurand, cause);
  test.text = fmt::format("On the samples {} of {}, {} of {} must not exceed {}.", core::join(test.samples),
                          report.experiment, number.expression, test.measurand, shown(limit));
  test.rationale = fmt::format(
      "Would have caught the missing {}: {} in the {} without it, {} with it; the limit lies between. {}", cause,
      shown(number.before), separating.judged ? "worst sample" : "mean of the held-out samples", shown(number.after),
      separating.judged ? "Judged by re-simulation with both models."
                        : "Taken from the report; not judged by re-simulation yet.");
}

}  // namespace

double roundBetween(double a, double b) {
  const double middle = std::isinf(b) ? 2.0 * std::max(a, 1e-9) : 0.5 * (a + b);
  for (int digits = 2; digits <= 15; ++digits) {
    double rounded = 0.0;
    if (core::parseNumber(core::significant(middle, digits), rounded) && a < rounded && rounded < b) return rounded;
  }
  return middle;
}

std::optional<SeparatingTest> separatingTest(const GapReport& report, const Bound& bound, core::Progress& progress) {
  std::vector<const ReportedGap*> order;
  std::string first_measurand;
  for (const ReportedGap& gap : report.gaps) {
    if (!isExistence(gap) && first_measurand.empty()) first_measurand = gap.name;
    if (gainOf(gap) > 0.0) order.push_back(&gap);
  }
  std::ranges::stable_sort(order, [](const auto* a, const auto* b) { return gainOf(*a) > gainOf(*b); });
  const auto after = bound.after ? std::make_shared<const model::LidarModel>(*bound.after) : nullptr;
  const auto before =
      after ? std::make_shared<const model::LidarModel>(model::readModel(bound.folder / bound.model)) : nullptr;
  constexpr double kHalf = 0.5;
  core::PartOfProgress first(progress, 0.0, kHalf), second(progress, kHalf, 1.0);
  for (const ReportedGap* gap : order) {
    SeparatingTest separating{.test = testFor(report, bound, *gap, first_measurand), .judged = after != nullptr};
    std::vector<Limited> limited = limitedOf(*gap);
    if (after) {
      const auto worst_before = worstOf(separating.test, limited, bound, before, first);
      const auto worst_after = worstOf(separating.test, limited, bound, after, second);
      for (std::size_t i = 0; i < limited.size(); ++i) {
        limited[i].before = worst_before[i];
        limited[i].after = worst_after[i];
      }
    }
    const Limited* number = bestOf(limited);
    if (!number) continue;
    separating.worst_before = number->before;
    separating.worst_after = number->after;
    word(separating, report, *number, roundBetween(number->after, number->before), isExistence(*gap) ? "" : gap->unit);
    return separating;
  }
  return std::nullopt;
}

}  // namespace proposals
