#include "model/reflections.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <span>
#include <unordered_map>

#include "core/physics.h"
#include "model/sensor/beam_finder.h"
#include "model/signal/power_stage.h"
#include "model/simulate.h"

namespace model {

namespace {

constexpr double kNanometre_m = 1e-9;

/// A sub-ray with one reflection of it.
struct Met {
  std::size_t ray;   ///< beam · sub-rays + sub-ray
  std::size_t turn;  ///< 0: what it met first
  Hit hit;
  double power_w;
};

bool before(const Met& a, const Met& b) { return a.ray != b.ray ? a.ray < b.ray : a.turn < b.turn; }

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// -- out

std::vector<Met> metBy(const BeamHits& hits, const PowerStage& power) {
  std::vector<double> powers_w;
  power.powersOf({hits.beams, hits.rays, hits.hits, 0, {}, {}, hits.power_w, hits.second_power_w}, powers_w);
  std::vector<Met> met;
  std::vector<std::size_t> next(hits.rays.size());
  for (std::size_t b = 0; b < hits.beams.size(); ++b) {
    std::fill(next.begin(), next.end(), 0);
    const std::size_t first_ray = b * hits.rays.size(), first_hit = hits.hits.first[b];
    std::size_t i = 0;
    for (const Hit& hit : hits.of(b))
      met.push_back({first_ray + hit.ray, next[hit.ray]++, hit, powers_w[first_hit + i++]});
    for (const SecondHit& second : hits.secondOf(b)) {
      met.push_back({first_ray + second.hit.ray, next[second.hit.ray]++, second.hit,
                     power.powerOf(hits.beams[b], hits.rays, second)});
    }
  }
  return met;
}

/// Normals of what the sub-rays met first, turned towards the sensor, and its Doppler shift. The first pass does not
/// keep the normals, so these rays are traced again. `all` is in the order of the reflections.
void describeSurfaces(std::span<const Met> all, const BeamHits& hits, const SignalChain& chain, const Scene& scene,
                      core::LidarSensorView& view) {
  const ChainSettings& settings = chain.settings();
  std::vector<Ray> rays;
  for (const Met& met : all) {
    const Vector3& direction = view.directions[met.ray];
    rays.push_back({settings.sensor_position_m, direction, hits.beams[met.ray / hits.rays.size()].scene_time_s});
  }
  std::vector<RayHit> surfaces(rays.size());
  tracerOf(scene, settings, hits.beams).trace(rays, surfaces);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vector3& direction = rays[i].direction;
    Vector3 normal = surfaces[i].normal;
    if (dot(normal, direction) > 0.0) normal = {-normal[0], -normal[1], -normal[2]};
    if (surfaces[i].object == all[i].hit.object) view.reflections[i].surface_normal = normal;  // rounding at edges
    const Vector3& velocity = scene.objects[static_cast<std::size_t>(all[i].hit.object)].velocity_m_s;
    const double nearing_m_s = dot(settings.sensor_velocity_m_s, direction) - dot(velocity, direction);
    view.reflections[i].doppler_shift_hz = 2.0 * nearing_m_s / core::kSpeedOfLight_m_s * *view.emitter_frequency_hz;
  }
}

// -- in

/// Whether the rays are those of the sensor in its own order, once or several times over.
bool inOrder(const core::LidarSensorView& view, const Fired& fired) {
  constexpr double kSame = 1e-6;  // what single precision and texts leave of a direction
  const std::size_t count = fired.beams.size() * fired.rays.size();
  if (view.directions.empty() || view.directions.size() % count != 0) return false;
  for (std::size_t i = 0; i < view.directions.size(); ++i) {
    const std::size_t ray = i % count, sub_ray = ray % fired.rays.size();
    const Vector3 expected =
        directionOf(fired.beams[ray / fired.rays.size()], fired.rays.left_rad[sub_ray], fired.rays.up_rad[sub_ray]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(view.directions[i][k] - expected[k]) > kSame) return false;
    }
  }
  return true;
}

/// Half the width over which sub-rays lie (subRaysOf).
double halfWidth(const ChainSettings& settings, double AngularSize::*direction) {
  constexpr double kGaussianReach = 1.5;
  const double width_rad = std::max(settings.divergence.*direction, settings.emitter.divergence.*direction);
  return width_rad / 2.0 * (settings.emitter.beam_profile == BeamProfile::kGaussian ? kGaussianReach : 1.0);
}

std::uint32_t nearestSubRay(const SubRays& rays, const PlaceInBeam& place) {
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t r = 0; r < rays.size(); ++r) {
    const double apart = std::hypot(rays.left_rad[r] - place.left_rad, rays.up_rad[r] - place.up_rad);
    if (apart < least) least = apart, nearest = r;
  }
  return nearest;
}

/// Small numbers for the objects of a view, in the order in which they come; -1 if the object is not known.
class ObjectNumbers {
 public:
  std::int32_t of(const std::optional<std::uint64_t>& object) {
    if (!object) return -1;
    return numbers_.try_emplace(*object, static_cast<std::int32_t>(numbers_.size())).first->second;
  }

 private:
  std::unordered_map<std::uint64_t, std::int32_t> numbers_;
};

Met metBy(const core::LidarReflection& from, const core::LidarSensorView& view, const Emitter& emitter,
          ObjectNumbers& objects) {
  Met met{0, 0, {}, emitter.peak_power_w * std::pow(10.0, from.signal_strength_db / 10.0)};
  met.hit.range_m = core::kSpeedOfLight_m_s / 2.0 * from.time_of_flight_s;
  met.hit.cos_incidence = 1.0F;
  met.hit.object = objects.of(from.object);
  if (from.surface_normal) {
    const double cosine = std::abs(dot(*from.surface_normal, view.directions[from.ray]));
    met.hit.cos_incidence = static_cast<float>(std::min(1.0, cosine));
  }
  return met;
}

/// Every reflection with its sub-ray, in no order yet.
std::vector<Met> metBy(const core::LidarSensorView& view, const Fired& fired, const ChainSettings& settings) {
  const std::size_t per_beam = fired.rays.size(), count = fired.beams.size() * per_beam;
  const bool ordered = inOrder(view, fired);
  const BeamFinder finder(fired.beams, halfWidth(settings, &AngularSize::horizontal_rad),
                          halfWidth(settings, &AngularSize::vertical_rad));
  ObjectNumbers objects;
  std::vector<Met> all;
  for (const core::LidarReflection& reflection : view.reflections) {
    Met met = metBy(reflection, view, settings.emitter, objects);
    if (ordered) {
      met.ray = reflection.ray % count;
      met.turn = reflection.ray / count;
    } else {
      const std::optional<PlaceInBeam> place = finder.find(view.directions[reflection.ray]);
      if (!place) continue;
      met.ray = place->beam * per_beam + nearestSubRay(fired.rays, *place);
    }
    met.hit.ray = static_cast<std::uint32_t>(met.ray % per_beam);
    all.push_back(met);
  }
  return all;
}

void checkStrengths(const core::LidarSensorView& view, const core::Place& place) {
  const bool weaker = std::any_of(view.reflections.begin(), view.reflections.end(),
                                  [](const core::LidarReflection& r) { return r.signal_strength_db < 0.0; });
  if (weaker || view.reflections.empty()) return;
  throw core::InputError(
      place,
      fmt::format("has no reflection that is weaker than what was sent: the first has a signal_strength of {:g} dB.",
                  view.reflections.front().signal_strength_db),
      "Write 10 log10 of received over emitted power, in dB: a negative number.");
}

BeamHits sorted(std::vector<Met> met, Fired fired) {
  std::stable_sort(met.begin(), met.end(), before);
  BeamHits result;
  result.first_second.push_back(0);
  std::size_t next = 0;
  const std::size_t per_beam = fired.rays.size();
  for (std::size_t b = 0; b < fired.beams.size(); ++b) {
    for (; next < met.size() && met[next].ray < (b + 1) * per_beam; ++next) {
      if (met[next].turn == 0) {
        result.hits.add(met[next].hit);
        result.power_w.push_back(met[next].power_w);
      } else {
        result.second.push_back({.hit = met[next].hit, .turns = {}, .turn_count = 0});
        result.second_power_w.push_back(met[next].power_w);
      }
    }
    result.hits.endBeam();
    result.first_second.push_back(static_cast<std::uint32_t>(result.second.size()));
  }
  if (result.second.empty()) result.first_second.clear();
  result.beams = std::move(fired.beams);
  result.rays = std::move(fired.rays);
  return result;
}

}  // namespace

core::LidarSensorView reflectionsOf(const BeamHits& hits, const SignalChain& chain, const Scene& scene) {
  const PowerStage power(chain.settings(), chain.effects(), scene);
  const Emitter& emitter = chain.settings().emitter;
  core::LidarSensorView view;
  view.emitter_frequency_hz = core::kSpeedOfLight_m_s / (kNanometre_m * emitter.wavelength_nm);
  std::vector<Met> all = metBy(hits, power);
  std::erase_if(all, [](const Met& met) { return met.power_w <= 0.0; });  // minus infinity in dB
  const std::size_t count = hits.beams.size() * hits.rays.size();
  std::size_t turns = 1;
  for (const Met& met : all) turns = std::max(turns, met.turn + 1);
  for (std::size_t ray = 0; ray < turns * count; ++ray) {
    const std::size_t sub_ray = ray % hits.rays.size();
    view.directions.push_back(directionOf(hits.beams[ray % count / hits.rays.size()], hits.rays.left_rad[sub_ray],
                                          hits.rays.up_rad[sub_ray]));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Met& a, const Met& b) { return a.turn != b.turn ? a.turn < b.turn : a.ray < b.ray; });
  for (const Met& met : all) {
    core::LidarReflection& to = view.reflections.emplace_back();
    to.ray = met.turn * count + met.ray;
    to.signal_strength_db = 10.0 * std::log10(met.power_w / emitter.peak_power_w);
    to.time_of_flight_s = 2.0 * met.hit.range_m / core::kSpeedOfLight_m_s;
    to.object = static_cast<std::uint64_t>(met.hit.object);
  }
  const auto straight = std::find_if(all.begin(), all.end(), [](const Met& met) { return met.turn > 0; });
  describeSurfaces(std::span(all.begin(), straight), hits, chain, scene, view);
  return view;
}

BeamHits hitsOf(const core::LidarSensorView& view, Fired fired, const ChainSettings& settings,
                const core::Place& place) {
  checkStrengths(view, place);
  std::vector<Met> met = metBy(view, fired, settings);
  if (met.empty() && !view.reflections.empty()) {
    throw core::InputError(
        place, fmt::format("none of its {} reflections lies in a beam of the sensor.", view.reflections.size()),
        "Check that the directions are in the sensor's frame (x forward, y left, z up) and that the "
        "model names the sensor for which they were made.");
  }
  return sorted(std::move(met), std::move(fired));
}

core::Place ReflectionTrace::placeOf(std::size_t message) const {
  return {.file = file, .line = 0, .item = fmt::format("message {}", message + 1)};
}

ReflectionTrace readReflections(const std::filesystem::path& file) { return {file, core::readLidarSensorViews(file)}; }

std::vector<std::string> effectsInReflections(const LidarModel& model) {
  std::vector<std::string> names;
  for (const ActiveEffect& active : model.effects) {
    if (findEffect(active.name)->make(active.parameters)->changesPower()) names.push_back(active.name);
  }
  return names;
}

}  // namespace model
