#include "gap/distance/total_gap.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/distance/existence.h"
#include "metrics/area/double_validation_metric.h"

namespace gap {

namespace {

void addExistence(TotalGap& gap, const core::Detections& measured, const core::Detections& simulated, int frames) {
  if (simulated.size() == 0) {
    gap.extra_fraction = measured.size() > 0 ? 1.0 : 0.0;  // a share of nothing: all that was measured is extra
  } else {
    const ExistenceGap existence = existenceGap({simulated, frames}, {measured, frames});
    gap.missing_fraction = existence.missing;
    gap.extra_fraction = existence.extra;
  }
  gap.total += kExistenceWeight * (gap.missing_fraction + gap.extra_fraction);
}

}  // namespace

TotalGap totalGap(const std::vector<model::Measurand>& measurands, const core::Detections& measured,
                  const core::Detections& simulated, int frames) {
  TotalGap gap;
  for (const model::Measurand& measurand : measurands) {
    const std::vector<double>* real = measured.values(measurand.column);
    const std::vector<double>* sim = simulated.values(measurand.column);
    if (!real || !sim || real->empty() || sim->empty()) continue;
    const metrics::PBox real_box{metrics::Edf(*real)}, sim_box{metrics::Edf(*sim)};
    const auto dvm = metrics::doubleValidationMetric({.simulated = sim_box, .measured = real_box});
    gap.measurands.push_back({measurand.name, measurand.unit, dvm.bias, dvm.scatter, measurand.resolution});
    gap.total += gap.measurands.back().steps();
  }
  if (measured.hasDirections() && simulated.hasDirections()) addExistence(gap, measured, simulated, frames);
  return gap;
}

TotalGap meanOf(const std::vector<TotalGap>& gaps) {
  TotalGap mean;
  std::map<std::string, double> counts;
  for (const TotalGap& gap : gaps) {
    for (const MeasurandGap& m : gap.measurands) {
      auto known = std::find_if(mean.measurands.begin(), mean.measurands.end(),
                                [&](const MeasurandGap& other) { return other.name == m.name; });
      if (known == mean.measurands.end())
        known = mean.measurands.insert(mean.measurands.end(), {m.name, m.unit, 0, 0, m.resolution});
      known->d_bias += m.d_bias;
      known->d_cavm += m.d_cavm;
      counts[m.name] += 1.0;
    }
    mean.missing_fraction += gap.missing_fraction / static_cast<double>(gaps.size());
    mean.extra_fraction += gap.extra_fraction / static_cast<double>(gaps.size());
    mean.total += gap.total / static_cast<double>(gaps.size());
  }
  for (MeasurandGap& m : mean.measurands) {
    m.d_bias /= counts[m.name];
    m.d_cavm /= counts[m.name];
  }
  return mean;
}

double ofMeasurandsLostIn(const TotalGap& after, const TotalGap& before) {
  double lost = 0.0;
  for (const MeasurandGap& m : before.measurands) {
    const auto same = [&](const MeasurandGap& other) { return other.name == m.name; };
    if (std::none_of(after.measurands.begin(), after.measurands.end(), same)) lost += m.steps();
  }
  return lost;
}

core::Detections framesOf(const core::Detections& detections, const std::vector<int>& frames) {
  std::vector<std::vector<std::size_t>> by_frame;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const auto frame = static_cast<std::size_t>(detections.frame[i]);
    if (frame >= by_frame.size()) by_frame.resize(frame + 1);
    by_frame[frame].push_back(i);
  }
  std::vector<std::size_t> chosen;
  for (const int frame : frames) {
    if (static_cast<std::size_t>(frame) >= by_frame.size()) continue;
    const auto& of_frame = by_frame[static_cast<std::size_t>(frame)];
    chosen.insert(chosen.end(), of_frame.begin(), of_frame.end());
  }
  return core::selected(detections, chosen);
}

}  // namespace gap
