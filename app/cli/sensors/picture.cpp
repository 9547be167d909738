#include <algorithm>
#include <fmt/format.h>

#include "app/cli/sensors/describe.h"
#include "core/physics.h"
#include "model/sensor/beams.h"
#include "report/beam_figure.h"

namespace app::sensors {

std::string picture(const model::SensorProfile& profile) {
  const auto beams = model::beamsOf(profile.scan);
  const model::Emitter& emitter = profile.emitter;
  report::BeamFigure figure{.title = profile.title,
                            .width_deg = emitter.divergence.horizontal_rad * core::kDegPerRad,
                            .height_deg = emitter.divergence.vertical_rad * core::kDegPerRad,
                            .elliptic = emitter.beam_profile == model::BeamProfile::kGaussian};
  figure.note = fmt::format("{} beams a frame in {}, {:.3g} Hz", beams.size(),
                            counted(model::layerCount(profile.scan), "layer"), profile.scan.frame_rate_hz);
  if (figure.width_deg > 0.0)
    figure.note += fmt::format("; a beam is {:.3g}° x {:.3g}°", figure.width_deg, figure.height_deg);
  figure.rows.resize(model::layerCount(profile.scan));
  for (const model::Beam& beam : beams) {
    figure.rows[static_cast<std::size_t>(beam.layer)].push_back(
        {beam.azimuth_rad * core::kDegPerRad, beam.elevation_rad * core::kDegPerRad, beam.gain});
  }
  return report::beamFigure(figure);
}

}  // namespace app::sensors
