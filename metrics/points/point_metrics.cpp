#include "metrics/points/point_metrics.h"

#include "metrics/points/cloud_to_cloud.h"
#include "metrics/points/extent.h"
#include "metrics/points/hausdorff.h"

namespace metrics {

namespace {

using Input = PointCloudInput;
using Numbers = std::vector<double>;

/// What all of them share.
MetricInfo info(int number, std::string_view name, std::string_view title, std::string_view meaning) {
  return {.number = number,
          .name = name,
          .title = title,
          .meaning = meaning,
          .best = "0",
          .worst = "infinity",
          .unit = MetricUnit::Measurand,
          .scale = Scale::Interval,
          .data = {DataKind::PointCloud}};
}

MetricOf<Input> hausdorffEntry() {
  MetricInfo about = info(8, "hausdorff", "Hausdorff distance", "distance of the farthest point to the other cloud");
  about.formula = "max(max_y min_x |y - x|, max_x min_y |x - y|)";
  about.source = "Huttenlocher et al. 1993, doi:10.1109/34.232073";
  about.meets = "13457";
  return {.info = about, .compute = [](const Input& in) { return Numbers{hausdorff(in.clouds).distance()}; }};
}

MetricOf<Input> directedHausdorffEntry() {
  MetricInfo about = info(8, "directed_hausdorff", "directed Hausdorff distances",
                          "distance of the farthest point of either cloud to the other");
  about.formula = "max_y min_x |y - x|; max_x min_y |x - y|";
  about.source = "Huttenlocher et al. 1993, doi:10.1109/34.232073";
  about.meets = "157";
  return {.info = about,
          .shape = MetricShape::Object,
          .parts = {"of_simulated", "of_measured"},
          .compute = [](const Input& in) {
            const Hausdorff both = hausdorff(in.clouds);
            return Numbers{both.of_simulated, both.of_measured};
          }};
}

MetricOf<Input> wassersteinEntry() {
  MetricInfo about = info(9, "point_wasserstein", "Wasserstein distance of point sets",
                          "mean way to carry one cloud onto the other, exact, for at most 1000 points a side");
  about.formula = "min over plans f (sum_ij f_ij |x_i - y_j|^p)^(1/p)";
  about.source = "Villani 2009, doi:10.1007/978-3-540-71050-9, ch. 6";
  about.meets = "123457";
  return {.info = about, .compute = [](const Input& in) {
            return Numbers{pointWassersteinDistance(in.clouds, in.options.wasserstein_order)};
          }};
}

MetricOf<Input> slicedWassersteinEntry() {
  MetricInfo about = info(0, "sliced_wasserstein", "sliced Wasserstein distance",
                          "Wasserstein distance along drawn lines, averaged; for any number of points");
  about.formula = "(mean over lines u of W_p(x.u, y.u)^p)^(1/p)";
  about.source = "Bonneel et al. 2015, doi:10.1007/s10851-014-0506-3";
  about.meets = "23457";
  return {.info = about, .compute = [](const Input& in) {
            return Numbers{slicedWassersteinDistance(in.clouds, in.options.wasserstein_order, in.options.slices)};
          }};
}

MetricOf<Input> cloudToCloudEntry() {
  MetricInfo about = info(10, "cloud_to_cloud", "point cloud to point cloud distance",
                          "nearest-neighbour distances added up; grows with the number of points");
  about.formula = "sum_y min_x |y - x|; sum_x min_y |x - y|";
  about.source = "Rosenberger 2022, Tab. 4-3";
  about.meets = "1235";
  return {.info = about,
          .shape = MetricShape::Object,
          .parts = {"of_simulated", "of_measured"},
          .compute = [](const Input& in) {
            const CloudToCloud both = cloudToCloud(in.clouds);
            return Numbers{both.sum_of_simulated, both.sum_of_measured};
          }};
}

MetricOf<Input> meanCloudToCloudEntry() {
  MetricInfo about = info(10, "mean_cloud_to_cloud", "mean point cloud to point cloud distance",
                          "mean nearest-neighbour distance; does not grow with the number of points");
  about.formula = "mean_y min_x |y - x|; mean_x min_y |x - y|";
  about.source = "Dubuisson & Jain 1994, doi:10.1109/ICPR.1994.576361";
  about.meets = "12357";
  return {.info = about,
          .shape = MetricShape::Object,
          .parts = {"of_simulated", "of_measured"},
          .compute = [](const Input& in) {
            const CloudToCloud both = cloudToCloud(in.clouds);
            return Numbers{both.mean_of_simulated, both.mean_of_measured};
          }};
}

MetricOf<Input> centreEntry() {
  MetricInfo about = info(11, "centre_of_gravity_distance", "centre of gravity distance",
                          "distance between the mean points; blind to shape");
  about.formula = "|mean(y) - mean(x)|";
  about.source = "Rosenberger 2022, Tab. 4-3";
  about.meets = "1457";
  return {.info = about, .compute = [](const Input& in) { return Numbers{centreOfGravityDistance(in.clouds)}; }};
}

MetricOf<Input> boundingBoxEntry() {
  MetricInfo about = info(12, "bounding_box_error", "bounding box error",
                          "largest distance between equal faces of the boxes; signed differences of size and centre");
  about.formula = "max |face(y) - face(x)|; size(y) - size(x); centre(y) - centre(x)";
  about.source = "Rosenberger 2022, Tab. 4-3; parts and scalar are a choice of this program";
  about.meets = "1457";
  return {.info = about,
          .shape = MetricShape::Object,
          .parts = {"face", "size_x", "size_y", "size_z", "centre_x", "centre_y", "centre_z"},
          .compute = [](const Input& in) {
            const BoundingBoxError e = boundingBoxError(in.clouds);
            return Numbers{e.face, e.size.x_m, e.size.y_m, e.size.z_m, e.centre.x_m, e.centre.y_m, e.centre.z_m};
          }};
}

MetricOf<Input> pointCountEntry() {
  MetricInfo about = info(0, "point_count_ratio", "ratio of the numbers of points",
                          "simulated over measured points; undefined if nothing was measured");
  about.formula = "n_y / n_x";
  about.best = "1";
  about.worst = "0 or infinity";
  about.unit = MetricUnit::None;
  about.scale = Scale::Nominal;
  about.source = "none: a count";
  about.meets = "17";
  return {.info = about, .compute = [](const Input& in) { return Numbers{pointCountRatio(in.clouds)}; }};
}

/// The list: one line a metric.
std::vector<MetricOf<Input>> makeMetrics() {
  return {hausdorffEntry(),    directedHausdorffEntry(), wassersteinEntry(), slicedWassersteinEntry(),
          cloudToCloudEntry(), meanCloudToCloudEntry(),  centreEntry(),      boundingBoxEntry(),
          pointCountEntry()};
}

}  // namespace

std::span<const MetricOf<PointCloudInput>> pointMetrics() {
  static const std::vector<MetricOf<Input>> metrics = makeMetrics();
  return metrics;
}

}  // namespace metrics
