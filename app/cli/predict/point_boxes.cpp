#include "app/cli/predict/point_boxes.h"

#include <cmath>

#include "core/csv.h"
#include "core/error.h"
#include "core/text.h"
#include "metrics/prediction/aggregation.h"
#include "metrics/prediction/predicted_box.h"

namespace app {

namespace {

using metrics::Edf;
using metrics::Margin;
using metrics::PBox;
using Names = std::vector<std::string>;

const Names kForExpected{"d_bias", "d_cavm"};

bool takesArea(const BoxRequest& request) { return request.model_form == "area"; }
Names forModelForm(const BoxRequest& request) {
  return takesArea(request) ? Names{"d_avm"} : Names{"d_plus", "d_minus"};
}

std::vector<Edf> readRuns(const BoxRequest& request) {
  std::vector<Edf> runs;
  for (const std::string& file : request.simulated) {
    std::vector<double> values = core::readNumericColumns(file, std::vector{request.column}).front();
    if (values.empty()) {
      throw core::InputError({.file = file}, "has a header and no rows; there is no box without values.",
                             "Check the export, or leave the file out.");
    }
    runs.emplace_back(std::move(values));
  }
  return runs;
}

Names missingOf(const Names& needed, const NamedErrors& errors) {
  Names missing;
  for (const std::string& name : needed) {
    if (!errors.contains(name)) missing.push_back(name);
  }
  return missing;
}

BoxLeftOut notPredicted(const std::string& box, const Names& missing, const NamedErrors& errors) {
  Names all;
  for (const auto& [name, error] : errors) all.push_back(name);
  all.insert(all.end(), missing.begin(), missing.end());
  return {.name = box,
          .why = core::join(missing, " and ") + (missing.size() == 1 ? " is" : " are") + " not predicted",
          .remedy = "Learn from the validation results again, with --for " + core::join(all, ",") + "."};
}

BoxLeftOut unbounded(const std::string& box) {
  return {.name = box,
          .why = "the bounds of the predicted errors are infinite: there are no degrees of freedom",
          .remedy = "Learn from more samples, or with a simpler --family."};
}

BoxLeftOut withoutModelForm(const Names& missing, const NamedErrors& errors) {
  BoxLeftOut total = notPredicted("total", missing, errors);
  if (errors.contains("d_avm")) total.remedy += " Or append d_avm on both sides: --model-form area.";
  return total;
}

/// What was not predicted. Throws InputError if that is what was asked for, or all.
std::vector<BoxLeftOut> leftOutFor(const NamedErrors& errors, const BoxRequest& request) {
  std::vector<BoxLeftOut> left_out;
  const Names for_expected = missingOf(kForExpected, errors);
  const Names for_total = missingOf(forModelForm(request), errors);
  if (!for_expected.empty()) left_out.push_back(notPredicted("expected", for_expected, errors));
  if (for_total.empty()) return left_out;
  left_out.push_back(withoutModelForm(for_total, errors));
  const BoxLeftOut& total = left_out.back();
  if (!request.model_form.empty() || request.numerical > 0.0) {
    throw core::InputError({.item = request.model_form.empty() ? "--numerical" : "--model-form " + request.model_form},
                           "asks for the aggregated box, and " + total.why + ".", total.remedy);
  }
  if (!for_expected.empty()) {
    throw core::InputError(
        {.item = "--simulated"},
        "the expected box cannot be told: " + left_out.front().why + "; nor can the aggregated one: " + total.why + ".",
        left_out.front().remedy + " For the aggregated box: " + total.remedy);
  }
  return left_out;
}

void addExpected(const NamedErrors& errors, const BoxRequest& request, PointBoxes& at) {
  const metrics::PredictedErrors predicted{.bias = errors.at("d_bias"), .scatter = errors.at("d_cavm")};
  const auto bound = request.bounds == "observation" ? metrics::BoundOf::Observation : metrics::BoundOf::Confidence;
  const metrics::PredictedBox box = metrics::predictedBox(at.boxes.front().box, predicted, bound);
  at.boxes.push_back({"expected", box.expected});
  if (box.bound) {
    at.boxes.push_back({"bound", *box.bound});
  } else {
    at.left_out.push_back(unbounded("bound"));
  }
}

Margin modelForm(const NamedErrors& errors, const BoxRequest& request) {
  if (takesArea(request)) return metrics::modelFormOf(errors.at("d_avm").observation.high);
  return metrics::modelFormOf(
      metrics::PredictedPortions{.d_plus = errors.at("d_plus"), .d_minus = errors.at("d_minus")});
}

void addAggregated(const NamedErrors& errors, const BoxRequest& request, PointBoxes& at) {
  const Margin margin = modelForm(errors, request);
  if (!std::isfinite(margin.below) || !std::isfinite(margin.above)) {
    at.left_out.push_back(unbounded("total"));
    return;
  }
  const auto box =
      metrics::aggregate({.input = at.boxes.front().box, .model_form = margin, .numerical = request.numerical});
  at.model_form = margin;
  at.boxes.push_back({"with_model_form", box.with_model_form});
  at.boxes.push_back({"total", box.total});
}

}  // namespace

PointBoxes boxesAt(const NamedErrors& errors, const BoxRequest& request) {
  PointBoxes at;
  at.left_out = leftOutFor(errors, request);  // told before anything large is read
  const std::vector<Edf> runs = readRuns(request);
  for (const Edf& run : runs) at.n.push_back(run.n());
  at.boxes.push_back({"simulated", PBox::envelope(runs)});
  if (missingOf(kForExpected, errors).empty()) addExpected(errors, request, at);
  if (missingOf(forModelForm(request), errors).empty()) addAggregated(errors, request, at);
  return at;
}

}  // namespace app
