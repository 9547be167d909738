#include "gap/replay/sample_tracing.h"

#include <algorithm>
#include <utility>

#include "core/physics.h"
#include "gap/replay/joined_hits.h"
#include "gap/replay/stretch.h"

namespace gap {

namespace {

constexpr int kFewestRays = 9;  // per direction, whatever the model has
/// Of a pulse's length: a sum of Gaussian pulses so far apart has ripples of 0.004 of its height, 2 exp(-2 (π σ/d)²) by
/// Poisson's summation formula, σ of the pulse, d the distance.
constexpr double kTornApart = 0.75;

/// The corners of the beam, without power: a surface that ends between them and the outermost rays of an even grid
/// would seem to catch the whole beam.
void addCorners(model::SubRays& rays, model::BeamProfile profile, const model::AngularSize& divergence) {
  const model::SubRays halfway = model::subRaysOf(profile, divergence, 2, 2);
  for (std::size_t i = 0; i < halfway.size(); ++i) rays.add(2.0 * halfway.left_rad[i], 2.0 * halfway.up_rad[i], 0.0);
}

/// Whether a beam meets faces of one object that stand at an angle to each other, as at the corner of a box: how much
/// comes back depends on where it is parted between them.
bool isFolded(const model::HitsOfBeam& hits) {
  constexpr float kFold = 0.05F;  // on a plane the cosine changes by less than the beam is wide [rad]
  float least = 1.0F, most = 0.0F;
  for (const model::Hit& hit : hits) {
    least = std::min(least, hit.cos_incidence);
    most = std::max(most, hit.cos_incidence);
  }
  return most - least > kFold;
}

/// The beams whose sub-rays do not all meet one face of one object, and those that an oblique surface tears apart.
std::vector<std::uint32_t> askingForMore(const model::BeamHits& hits, double torn_m) {
  std::vector<std::uint32_t> asking;
  for (std::uint32_t b = 0; b < hits.beams.size(); ++b) {
    const auto of_beam = hits.of(b);
    if (of_beam.empty() && hits.rays.size() > 1) continue;
    bool whole = of_beam.size() == hits.rays.size() && !isFolded(of_beam);
    for (std::size_t i = 0; whole && i < of_beam.size(); ++i) whole = of_beam[i].object == of_beam[0].object;
    if (!whole || isTornApart(of_beam, hits.rays, torn_m)) asking.push_back(b);
  }
  return asking;
}

}  // namespace

GeometryCache::Geometry traceSample(const model::Experiment& experiment, const ReplaySample& replayed,
                                    const World& world, const World& baseline, const Detail& detail) {
  const model::Sample& sample = *replayed.sample;
  auto traced = std::make_shared<model::TracedSample>();
  traced->situation = situationIn(world, experiment, sample);
  const model::SensorProfile& sensor = world.model.sensor(sample.sensor);
  const model::SignalChain chain(sensor, world.model.effectsOf(sample.sensor), traced->situation.environment);
  const model::ChainSettings& settings = chain.settings();
  const bool whole = chain.couplesBeams() && !replayed.taken.empty();
  std::vector<model::Beam> beams = whole ? replayed.whole_scan : replayed.beams;
  chain.aim(beams);
  // Of the recorded pulse: worlds that differ in theirs share their hits.
  const double pulse_m = core::kMetresPerNanosecond * baseline.model.sensor(sample.sensor).emitter.pulse_fwhm_ns / 2.0;
  const double range_bin_m = pulse_m / 40.0;
  const double left_bin_rad = std::max(1e-4, settings.divergence.horizontal_rad / 4.0);
  if (detail.edge_rays == 0) {
    traced->hits = model::traceWith(chain, traced->situation.scene, std::move(beams),
                                    chain.subRays(world.model.rays_horizontal, world.model.rays_vertical));
    if (detail.joined) traced->hits = joined(traced->hits, {}, {}, range_bin_m, left_bin_rad);
    return traced;
  }
  const int horizontal = std::max(kFewestRays, world.model.rays_horizontal);
  const int vertical = std::max(kFewestRays, world.model.rays_vertical);
  const model::Scene& scene = traced->situation.scene;
  model::SubRays rays = chain.subRays(horizontal, vertical);
  addCorners(rays, sensor.emitter.beam_profile, settings.divergence);
  const model::BeamHits all = model::traceWith(chain, scene, std::move(beams), std::move(rays));
  const auto asking = askingForMore(all, kTornApart * pulse_m);
  std::vector<model::Beam> asking_beams;
  for (const std::uint32_t b : asking) asking_beams.push_back(all.beams[b]);
  const model::BeamHits dense =
      model::traceWith(chain, scene, std::move(asking_beams),
                       chain.subRays(std::max(detail.edge_rays, horizontal), std::max(detail.edge_rays, vertical),
                                     model::Grid::kSheared));
  traced->hits = joined(all, asking, dense, range_bin_m, left_bin_rad);
  return traced;
}

}  // namespace gap
