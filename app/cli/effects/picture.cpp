#include "app/cli/effects/picture.h"

#include "report/curve_figure.h"
#include "report/point_figure.h"

namespace app::effects {

namespace {

using Series = model::Demonstration::Series;

report::PointFigure::Cloud cloudOf(const Series& series) {
  report::PointFigure::Cloud cloud{.name = series.name, .points = {}};
  for (std::size_t i = 0; i < series.x.size(); ++i) cloud.points.push_back({series.x[i], series.y[i]});
  return cloud;
}

std::string pointsOf(const model::Demonstration& demonstration) {
  const model::DemonstrationPlan& plan = demonstration.plan;
  report::PointFigure figure{.title = plan.title, .x_name = plan.x_name, .y_name = plan.y_name};
  figure.x = {(*plan.x_range)[0], (*plan.x_range)[1]};
  figure.y = {(*plan.y_range)[0], (*plan.y_range)[1]};
  figure.one_scale = plan.over == "x_m";
  figure.reference = cloudOf(demonstration.series.front());
  for (std::size_t i = 1; i < demonstration.series.size(); ++i)
    figure.panels.push_back(cloudOf(demonstration.series[i]));
  return report::pointFigure(figure);
}

std::string curvesOf(const model::Demonstration& demonstration) {
  const model::DemonstrationPlan& plan = demonstration.plan;
  report::CurveFigure figure{.title = plan.title, .x_name = plan.x_name, .y_name = plan.y_name};
  figure.x = demonstration.series.front().x;
  for (const Series& series : demonstration.series) figure.curves.push_back({series.name, series.y});
  if (plan.y_range) figure.y_range = report::Range{(*plan.y_range)[0], (*plan.y_range)[1]};
  return report::curveFigure(figure);
}

}  // namespace

std::string picture(const model::Demonstration& demonstration) {
  return demonstration.plan.view == model::View::kPoints ? pointsOf(demonstration) : curvesOf(demonstration);
}

}  // namespace app::effects
