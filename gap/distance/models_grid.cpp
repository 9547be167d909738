#include "gap/distance/models_grid.h"

#include <algorithm>
#include <cmath>

#include "gap/distance/discrepancy.h"

namespace gap {

namespace {

constexpr double kFar = 10.0;    // standard errors: what is farther may have other causes
constexpr double kNearer = 0.5;  // of the way from the denser grid to the model's
constexpr double kProven = 5.0;  // standard errors of that share

/// How much of what the model's grid makes of cut and stretched beams is in the measurement: least squares through the
/// origin.
class ShareOfGrid {
 public:
  void add(double of_grid, double of_measurement) {
    const double x = std::clamp(of_grid, -kFar, kFar), y = std::clamp(of_measurement, -kFar, kFar);
    xx_ += x * x;
    xy_ += x * y;
    yy_ += y * y;
    ++count_;
  }
  [[nodiscard]] bool isProven() const {
    if (count_ < 2 || xx_ <= 0.0) return false;
    const double share = xy_ / xx_;
    const double left = std::max(0.0, yy_ - share * xy_) / static_cast<double>(count_ - 1);
    return share > kNearer && share > kProven * std::sqrt(left / xx_);
  }

 private:
  double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
  std::size_t count_ = 0;
};

void addSample(const Replay& dense, const Replay& as_run, std::size_t s, ShareOfGrid& share) {
  const ReplaySample& sample = dense.samples()[s];
  if (sample.layout->pooled()) return;
  const std::uint64_t seed = dense.seed() + 1;  // of the recorded noise, too, none is like it
  const auto on_dense = dense.simulate(dense.baseline(), s, sample.frames, seed);
  const core::Detections detections = as_run.detections(as_run.baseline(), s, seed);
  const auto on_grid =
      sample.layout->statisticsOf(detections, beamsOfDetections(detections, sample.beams, sample.sample->measurements));
  for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
    const Cell& cell = sample.layout->cells()[c];
    if (cell.share >= kWholeBeam && !cell.at_edge) continue;
    const CellStatistics &m = sample.statistics[c], &d = on_dense[c], &g = on_grid[c];
    if (std::min({m.count, d.count, g.count}) < 1.0) continue;
    for (const Channel channel : dense.channels()) {
      const double error = meanError(dense, sample, c, channel, m, d);
      share.add((g.mean(channel) - d.mean(channel)) / error, (m.mean(channel) - d.mean(channel)) / error);
    }
  }
}

}  // namespace

bool madeOnTheModelsGrid(const Replay& dense, const Replay& as_run) {
  ShareOfGrid share;
  for (std::size_t s = 0; s < dense.samples().size(); ++s) addSample(dense, as_run, s, share);
  return share.isProven();
}

}  // namespace gap
