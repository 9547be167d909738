#include "metrics/grids/range_image.h"

#include <cmath>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "metrics/grids/grid_shape.h"
#include "metrics/grids/picture_distance.h"

namespace metrics {

namespace {

GridShape shapeOf(const RangeImage& image) {
  return {.rows = image.rows, .columns = image.columns, .numbers = image.range_m.size()};
}

void requireRanges(const RangeImage& image, const std::string& name) {
  for (std::size_t i = 0; i < image.range_m.size(); ++i) {
    const double range_m = image.range_m[i];
    if (std::isnan(range_m) || (std::isfinite(range_m) && range_m > 0.0)) continue;
    throw core::InputError({.item = cellName(name, i, image.columns)},
                           "has the range " + core::shortestNumber(range_m) + " m; it must be positive and finite.",
                           "Write NaN for a beam without an echo.");
  }
}

}  // namespace

void requireComparable(const RangeImagePair& images) {
  requireSameShape(shapeOf(images.simulated), shapeOf(images.measured), "range image");
  requireRanges(images.simulated, "simulated range image");
  requireRanges(images.measured, "measured range image");
}

CellMask echoes(const RangeImage& image) {
  return maskWhere(image.rows, image.columns, image.range_m, [](double range_m) { return !std::isnan(range_m); });
}

SharedPixels::SharedPixels(const RangeImagePair& images) {
  requireComparable(images);
  for (std::size_t i = 0; i < images.measured.range_m.size(); ++i) {
    if (std::isnan(images.simulated.range_m[i]) || std::isnan(images.measured.range_m[i])) continue;
    simulated_m.push_back(images.simulated.range_m[i]);
    measured_m.push_back(images.measured.range_m[i]);
  }
}

ExistenceShares existenceShares(const RangeImagePair& images) {
  requireComparable(images);
  const CellMask simulated = echoes(images.simulated);
  const CellMask measured = echoes(images.measured);
  std::size_t measured_only = 0;
  std::size_t simulated_only = 0;
  for (std::size_t i = 0; i < measured.set.size(); ++i) {
    measured_only += measured.set[i] > simulated.set[i] ? 1 : 0;
    simulated_only += simulated.set[i] > measured.set[i] ? 1 : 0;
  }
  const double all = static_cast<double>(measured.set.size());
  return {.measured_only = static_cast<double>(measured_only) / all,
          .simulated_only = static_cast<double>(simulated_only) / all};
}

double echoPictureDistance(const RangeImagePair& images) {
  requireComparable(images);
  const CellMask simulated = echoes(images.simulated);
  const CellMask measured = echoes(images.measured);
  return colourDistance({.simulated = simulated, .measured = measured});
}

}  // namespace metrics
