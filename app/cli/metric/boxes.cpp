#include "app/cli/metric/boxes.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "core/error.h"
#include "metrics/distributions/confidence_band.h"
#include "metrics/distributions/mixture.h"
#include "metrics/distributions/propagation.h"

namespace app {

namespace {

using metrics::Edf;
using metrics::PBox;

Edf edfOf(ColumnValues column) {
  if (column.weights.empty()) return Edf(std::move(column.values));
  return Edf::weighted(column.values, column.weights);
}

std::vector<double> sharesOf(const MetricRequest& request, std::size_t runs) {
  if (request.shares.empty()) return std::vector<double>(runs, 1.0);
  if (request.shares.size() == runs) return request.shares;
  throw core::InputError({.item = "--shares"},
                         fmt::format("gives {} shares for {} SIM files.", request.shares.size(), runs),
                         "Give one for each file, in the same order: --shares 0.7,0.3");
}

/// Row i of every file is the same aleatory sample under another epistemic choice.
PBox aleatoryOuterOf(const std::vector<ColumnValues>& runs, const MetricRequest& request) {
  std::vector<std::vector<double>> outputs(runs.front().values.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].values.size() != outputs.size()) {
      throw core::InputError(
          {.file = request.simulated[k]},
          fmt::format("has {} rows; {} has {}.", runs[k].values.size(), request.simulated.front(), outputs.size()),
          "For --combine a-outer row i of every file is the same aleatory sample.");
    }
    for (std::size_t i = 0; i < outputs.size(); ++i) outputs[i].push_back(runs[k].values[i]);
  }
  return metrics::aleatoryOuter(outputs);
}

PBox combined(const std::vector<Edf>& runs, const MetricRequest& request) {
  if (request.combine == "mixture") return PBox(metrics::mixture(runs, sharesOf(request, runs.size())));
  return PBox::envelope(runs);
}

/// All runs as one sample; in a mixture each run with its share.
ColumnValues pooledOf(const std::vector<ColumnValues>& runs, const MetricRequest& request) {
  const bool mixed = request.combine == "mixture";
  const std::vector<double> shares = sharesOf(request, runs.size());
  const bool weighted = mixed || std::any_of(runs.begin(), runs.end(), [](auto& run) { return !run.weights.empty(); });
  ColumnValues pooled;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const ColumnValues& run = runs[k];
    pooled.values.insert(pooled.values.end(), run.values.begin(), run.values.end());
    if (!weighted) continue;
    std::vector<double> weights = run.weights.empty() ? std::vector<double>(run.values.size(), 1.0) : run.weights;
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) weight *= mixed ? shares[k] / total : 1.0;
    pooled.weights.insert(pooled.weights.end(), weights.begin(), weights.end());
  }
  return pooled;
}

/// Where values may lie at all, as far as the files show.
metrics::Interval supportOf(const PBox& simulated, const Edf& measured) {
  return {std::min(simulated.left().min(), measured.min()), std::max(simulated.right().max(), measured.max())};
}

PBox withMargin(PBox box, double margin) {
  if (margin == 0.0) return box;
  return metrics::widened(box, {.below = margin, .above = margin});
}

}  // namespace

Boxes boxesOf(ColumnValues measured, std::vector<ColumnValues> runs, const MetricRequest& request) {
  std::optional<PBox> simulated;
  if (request.combine == "a-outer") simulated = aleatoryOuterOf(runs, request);
  Edf pooled = runs.size() == 1 ? edfOf(runs.front()) : edfOf(pooledOf(runs, request));
  std::vector<Edf> edfs;
  for (ColumnValues& run : runs) edfs.push_back(edfOf(std::move(run)));
  if (!simulated) simulated = combined(edfs, request);
  Edf sample = edfOf(std::move(measured));
  PBox measured_box =
      request.band ? metrics::confidenceBand(sample, *request.band, supportOf(*simulated, sample)) : PBox(sample);
  return {.simulated = withMargin(*simulated, request.simulated_margin),
          .measured = withMargin(std::move(measured_box), request.measured_margin),
          .pooled = std::move(pooled),
          .measured_sample = std::move(sample)};
}

}  // namespace app
