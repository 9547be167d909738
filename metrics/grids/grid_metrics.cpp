#include "metrics/grids/grid_metrics.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>
#include <vector>

#include "metrics/grids/cell_ratios.h"
#include "metrics/grids/picture_distance.h"
#include "metrics/series/series_metrics.h"

namespace metrics {

namespace {

using Numbers = std::vector<double>;
using GridEntry = MetricOf<GridInput>;
using ImageEntry = MetricOf<RangeImageInput>;

constexpr std::string_view kMartin = "Martin & Moravec 1996, CMU-RI-TR-96-06";
constexpr std::string_view kBirk = "Birk & Carpin 2006, doi:10.1109/JPROC.2006.876965";
constexpr std::string_view kRatio = "Rosenberger 2022, Tab. 4-3; read as a ratio of the two counts";
constexpr std::string_view kColours = "Birk & Carpin 2006, doi:10.1109/JPROC.2006.876965; abbreviation is our reading";
constexpr std::string_view kBaron = "Baron 1981, as in Brunelli & Poggio 1993, doi:10.1109/34.254061";
constexpr std::string_view kOurs = "a share of pixels; ours, not in Tab. 4-3";

const MetricOf<SeriesInput>& seriesMetric(std::string_view name) {
  const auto all = seriesMetrics();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& metric) { return metric.info.name == name; });
  assert(found != all.end());
  return *found;
}

/// What a metric of series says of itself once it reads cells or pixels. Texts that are empty stay as they are.
struct Retold {
  std::string_view meaning;
  std::string_view worst;
};

MetricInfo retold(MetricInfo info, const Retold& text, DataKind data) {
  info.meaning = text.meaning;
  if (!text.worst.empty()) info.worst = text.worst;
  info.data = {data};
  return info;
}

/// A metric of series on the probabilities, cell by cell. They have no unit.
GridEntry ofCells(std::string_view series_name, const Retold& text) {
  const MetricOf<SeriesInput>& series = seriesMetric(series_name);
  MetricInfo info = retold(series.info, text, DataKind::OccupancyGrid);
  info.unit = MetricUnit::None;
  return {.info = std::move(info), .compute = [&series](const GridInput& in) {
            const SeriesPair cells = cellByCell(in.pair());
            return series.compute({.simulated = cells.simulated, .measured = cells.measured});
          }};
}

/// The image of Pearson's coefficient under another name: <pq> - <p><q> over the product of the deviations.
GridEntry baronCorrelation() {
  GridEntry entry = ofCells("pearson", {.meaning = "correlation of the cells, on grids the same as pearson; "
                                                   "NaN if a grid is constant"});
  entry.info.number = 19;
  entry.info.name = "baron_correlation";
  entry.info.title = "Baron's cross-correlation coefficient";
  entry.info.formula = "(mean(p q) - mean(p) mean(q)) / (std(p) std(q))";
  entry.info.source = kBaron;
  return entry;
}

GridEntry ofGrids(MetricInfo info, double (*compute)(const GridInput&)) {
  info.data = {DataKind::OccupancyGrid};
  return {.info = std::move(info), .compute = [compute](const GridInput& in) { return Numbers{compute(in)}; }};
}

/// A metric of series on the ranges of the pixels with an echo in both images.
ImageEntry ofSharedPixels(std::string_view series_name, const Retold& text) {
  const MetricOf<SeriesInput>& series = seriesMetric(series_name);
  MetricInfo info = retold(series.info, text, DataKind::RangeImage);
  info.meets = info.unit == MetricUnit::None ? "17" : "157";  // pixels with an echo on one side only do not count
  return {.info = std::move(info), .compute = [&series](const RangeImageInput& in) {
            const SharedPixels shared(in.pair());
            if (shared.empty()) return Numbers{std::numeric_limits<double>::quiet_NaN()};
            return series.compute({.simulated = shared.simulated_m, .measured = shared.measured_m});
          }};
}

ImageEntry ofImages(MetricInfo info, double (*compute)(const RangeImageInput&)) {
  info.data = {DataKind::RangeImage};
  return {.info = std::move(info), .compute = [compute](const RangeImageInput& in) { return Numbers{compute(in)}; }};
}

/// The list of grids: p simulated, q measured probability, # number of cells.
std::vector<GridEntry> makeGridList() {
  return {
      ofCells("overall_error", {.meaning = "sum of |difference of probabilities|; grows with the grid, see mean_error",
                                .worst = "number of cells"}),
      ofCells("mean_error", {.meaning = "mean of |difference of probabilities|", .worst = "1"}),
      ofGrids({.number = 13,
               .name = "map_score",
               .title = "Map score",
               .meaning = "how well the grids predict each other, probabilities clipped; high is good",
               .formula = "sum 1 + log2(p q + (1 - p)(1 - q))",
               .best = "number of cells, if all are certain",
               .worst = "-inf; -7.97 a cell with the usual clip",
               .unit = MetricUnit::Bit,
               .scale = Scale::Ratio,
               .source = kMartin,
               .meets = "2"},
              [](const GridInput& in) { return mapScore(in.pair(), in.clip); }),
      ofGrids({.name = "map_score_per_cell",
               .title = "Map score per cell",
               .meaning = "map_score divided by the number of cells",
               .formula = "map_score / #",
               .best = "1, if all cells are certain",
               .worst = "-inf; -7.97 with the usual clip",
               .unit = MetricUnit::Bit,
               .scale = Scale::Ratio,
               .source = kMartin,
               .meets = "27"},
              [](const GridInput& in) { return mapScorePerCell(in.pair(), in.clip); }),
      ofGrids({.number = 14,
               .name = "occupied_cells_ratio",
               .title = "Occupied cells ratio",
               .meaning = "simulated over measured number of occupied cells; NaN if none was measured",
               .formula = "#(p > occupied_above) / #(q > occupied_above)",
               .best = "1",
               .worst = "0 or inf",
               .unit = MetricUnit::None,
               .scale = Scale::Ordinal,
               .source = kRatio,
               .meets = "7"},
              [](const GridInput& in) { return occupiedCellsRatio(in.pair(), in.limits); }),
      ofGrids({.number = 15,
               .name = "free_cells_ratio",
               .title = "Free cells ratio",
               .meaning = "simulated over measured number of free cells; NaN if none was measured",
               .formula = "#(p < free_below) / #(q < free_below)",
               .best = "1",
               .worst = "0 or inf",
               .unit = MetricUnit::None,
               .scale = Scale::Ordinal,
               .source = kRatio,
               .meets = "7"},
              [](const GridInput& in) { return freeCellsRatio(in.pair(), in.limits); }),
      ofGrids({.number = 16,
               .name = "opd",
               .title = "Occupied picture distance",
               .meaning = "how far occupied cells lie from the nearest of the other grid, both ways",
               .formula = "d(q, p) + d(p, q) over occupied cells, d: mean Manhattan distance",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Cells,
               .scale = Scale::Ordinal,
               .source = kColours,
               .meets = "27"},
              [](const GridInput& in) { return occupiedPictureDistance(in.pair(), in.limits); }),
      ofGrids({.number = 17,
               .name = "upd",
               .title = "Unoccupied picture distance",
               .meaning = "how far free cells lie from the nearest of the other grid, both ways",
               .formula = "d(q, p) + d(p, q) over free cells, d: mean Manhattan distance",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Cells,
               .scale = Scale::Ordinal,
               .source = kColours,
               .meets = "27"},
              [](const GridInput& in) { return unoccupiedPictureDistance(in.pair(), in.limits); }),
      ofGrids({.number = 18,
               .name = "picture_distance",
               .title = "Picture distance",
               .meaning = "sum of opd and upd",
               .formula = "sum over colours c of d_c(q, p) + d_c(p, q), d: mean Manhattan distance",
               .best = "0",
               .worst = "inf",
               .unit = MetricUnit::Cells,
               .scale = Scale::Ordinal,
               .source = kBirk,
               .meets = "27"},
              [](const GridInput& in) { return pictureDistance(in.pair(), in.limits); }),
      baronCorrelation(),
      ofCells("pearson", {.meaning = "linear relation of the cells; NaN if a grid is constant"}),
      ofGrids({.number = 24,
               .name = "jaccard",
               .title = "Jaccard distance",
               .meaning = "share of the cells occupied in either grid that are not occupied in both",
               .formula = "1 - #(p and q occupied) / #(p or q occupied)",
               .best = "0",
               .worst = "1",
               .unit = MetricUnit::None,
               .scale = Scale::Ordinal,
               .source = "Jaccard 1912, doi:10.1111/j.1469-8137.1912.tb05611.x",
               .meets = "2347"},
              [](const GridInput& in) { return jaccardDistance(in.pair(), in.limits); }),
  };
}

/// The list of range images: x measured, y simulated range.
std::vector<ImageEntry> makeImageList() {
  return {
      ofSharedPixels("mean_error", {.meaning = "mean of |range difference| over pixels with an echo in both; "
                                               "NaN if there are none"}),
      ofSharedPixels("mean_signed_error", {.meaning = "mean of simulated - measured range over pixels with an echo in "
                                                      "both; NaN if there are none"}),
      ofSharedPixels("chebyshev", {.meaning = "largest |range difference| over pixels with an echo in both; "
                                              "NaN if there are none"}),
      ofSharedPixels("rmse", {.meaning = "root mean square of the range differences over pixels with an echo in both; "
                                         "NaN if there are none"}),
      ofImages({.number = 18,
                .name = "picture_distance",
                .title = "Picture distance",
                .meaning = "how far pixels with an echo lie from the nearest of the other image, both ways",
                .formula = "d(x, y) + d(y, x) over pixels with an echo, d: mean Manhattan distance",
                .best = "0",
                .worst = "inf",
                .unit = MetricUnit::Cells,
                .scale = Scale::Nominal,
                .source = kBirk,
                .meets = "27"},
               [](const RangeImageInput& in) { return echoPictureDistance(in.pair()); }),
      ofSharedPixels("pearson", {.meaning = "linear relation of the ranges over pixels with an echo in both; "
                                            "NaN if there are none or a side is constant"}),
      ofImages({.name = "measured_only_pixels",
                .title = "Share of pixels that only the measurement has",
                .meaning = "share of all pixels with an echo in the measurement only",
                .formula = "#(x valid, y not) / #",
                .best = "0",
                .worst = "1",
                .unit = MetricUnit::None,
                .scale = Scale::Nominal,
                .source = kOurs,
                .meets = "17"},
               [](const RangeImageInput& in) { return existenceShares(in.pair()).measured_only; }),
      ofImages({.name = "simulated_only_pixels",
                .title = "Share of pixels that only the simulation has",
                .meaning = "share of all pixels with an echo in the simulation only",
                .formula = "#(y valid, x not) / #",
                .best = "0",
                .worst = "1",
                .unit = MetricUnit::None,
                .scale = Scale::Nominal,
                .source = kOurs,
                .meets = "17"},
               [](const RangeImageInput& in) { return existenceShares(in.pair()).simulated_only; }),
  };
}

}  // namespace

std::span<const MetricOf<GridInput>> gridMetrics() {
  static const std::vector<GridEntry> list = makeGridList();
  return list;
}

std::span<const MetricOf<RangeImageInput>> rangeImageMetrics() {
  static const std::vector<ImageEntry> list = makeImageList();
  return list;
}

}  // namespace metrics
