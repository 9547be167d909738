#include "bench/withheld/generator/shots.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace withheld {

namespace {

constexpr int kFew = 48, kMany = 768, kHalo = 192;
constexpr int kForeign = -2;

/// What does not change from frame to frame in one beam.
struct Prepared {
  Ray axis;
  std::vector<Arrival> arrivals;
  double constant = 0.0;  ///< P η A gain: what β cos θ / r² is multiplied with [W m²]
  double end_m = 1e9;     ///< where the axis meets something
  double reflectivity = 0.3;
  double noise_w = 0.0;
};

class Gun {
 public:
  explicit Gun(const Situation& s)
      : s_(s),
        e_(s.effects),
        p_(s.profile),
        surfaces_(s.effects),
        air_(s.effects, s.profile, s.environment),
        receiver_(s.profile, s.effects, s.environment, s.seed),
        echoes_(s.profile, s.effects, s.environment, s.pulse) {
    mounting_ = Turn::yawPitchRoll(e_.number("mounting-error", "yaw_deg", 0.0) * kDegree,
                                   e_.number("mounting-error", "pitch_deg", 0.0) * kDegree,
                                   e_.number("mounting-error", "roll_deg", 0.0) * kDegree);
    const std::vector<double> place = e_.list("mounting-error", "position_m");
    if (place.size() == 3) place_ = {place[0], place[1], place[2]};
    if (!e_.on("beam-divergence")) few_ = many_ = 1;
    scene_ = s.scene;
    const double ego = e_.number("motion-scan", "ego_speed_m_s", 0.0);
    for (Object& object : scene_) object.velocity_m_s = object.velocity_m_s - Vec{ego, 0, 0};
  }

  std::vector<Detection> fireAll() {
    prepareAll();
    std::vector<Detection> detections;
    std::vector<std::optional<Waveform>> kept(s_.beams.size());
    for (int frame = 0; frame < s_.frames; ++frame) {
      const Spray spray =
          sprayOfFrame(e_, scene_, Dice(s_.seed, Use::spray, {s_.sample, static_cast<std::uint64_t>(frame)}));
      for (std::size_t b = 0; b < s_.beams.size(); ++b) {
        for (Detection detection : shoot(b, frame, spray, kept[b])) {
          detection.beam = b;
          detections.push_back(detection);
        }
      }
    }
    return detections;
  }

 private:
  [[nodiscard]] Ray rayOf(const Beam& beam, Offset offset) const {
    const Vec axis = direction(beam.azimuth_rad, beam.elevation_rad);
    const Vec left{-std::sin(beam.azimuth_rad), std::cos(beam.azimuth_rad), 0.0};
    const Vec up{-std::sin(beam.elevation_rad) * std::cos(beam.azimuth_rad),
                 -std::sin(beam.elevation_rad) * std::sin(beam.azimuth_rad), std::cos(beam.elevation_rad)};
    const Vec along = unit(axis + std::tan(offset.left_rad) * left + std::tan(offset.up_rad) * up);
    return {place_, mounting_.outward(along)};
  }

  [[nodiscard]] double movedBy_s(const Beam& beam) const {
    return (e_.on("motion-scan") ? beam.time_s : 0.0) - e_.number("latency", "delay_s", 0.0);
  }

  // All that one sub-ray of the given weight brings back: surfaces, through glass, by way of mirrors.
  void trace(const Ray& first, double moved_s, double strength, std::vector<Arrival>& arrivals) const {
    struct Leg {
      Ray ray;
      double before_m, share;
      int path, mirrors;
    };
    std::vector<Leg> legs{{first, 0.0, strength, 0, 0}};
    const int most_mirrors = e_.on("multipath") ? static_cast<int>(e_.number("multipath", "max_bounces", 2.0)) - 1 : 0;
    for (int guard = 0; !legs.empty() && guard < 16; ++guard) {
      const Leg leg = legs.back();
      legs.pop_back();
      const auto hit = nearestHit(scene_, leg.ray, moved_s);
      if (!hit) continue;
      const Material& material = scene_[static_cast<std::size_t>(hit->object)].material;
      const double cosine = std::clamp(-dot(hit->normal, leg.ray.along), 0.0, 1.0), range = leg.before_m + hit->range_m;
      const double through_air = air_.left(leg.ray, hit->range_m);
      const double power = leg.share * through_air * surfaces_.backward(material, cosine) * cosine / (range * range);
      arrivals.push_back({range, power * receiver_.overlap(range), leg.path + hit->object});
      const Vec at = leg.ray.from + hit->range_m * leg.ray.along;
      if (const double passes = surfaces_.passing(material, cosine); passes > 0.0) {
        const Ray beyond{at + 1e-7 * leg.ray.along, leg.ray.along};
        legs.push_back({beyond, range, leg.share * through_air * passes * passes, leg.path, leg.mirrors});
      }
      if (const double mirrored = surfaces_.mirrored(material); mirrored > 0.0 && leg.mirrors < most_mirrors) {
        const Vec bounced = leg.ray.along + 2.0 * cosine * hit->normal;
        legs.push_back({{at + 1e-7 * hit->normal, bounced},
                        range,
                        leg.share * through_air * mirrored * mirrored,
                        (leg.path + hit->object + 1) * 1000,
                        leg.mirrors + 1});
      }
    }
  }

  // One even face under the whole beam, or not?
  [[nodiscard]] bool even(const Beam& beam, const Footprint& footprint, double moved_s) const {
    std::optional<Hit> seen;
    bool any = false;
    double nearest = 1e300, farthest = 0.0;
    for (int i = -4; i < few_; ++i) {
      const Offset offset = i < 0 ? footprint.corner(i + 4) : footprint.at(i);
      const auto hit = nearestHit(scene_, rayOf(beam, offset), moved_s);
      if (i > -4 && (hit.has_value() != any || (hit && (hit->object != seen->object || hit->face != seen->face))))
        return false;
      if (hit && hit->face < 0) return false;
      if (hit) nearest = std::min(nearest, hit->range_m), farthest = std::max(farthest, hit->range_m);
      seen = hit;
      any = hit.has_value();
    }
    return !any || farthest - nearest < 0.1;
  }

  [[nodiscard]] std::vector<Arrival> surfacesIn(const Beam& beam, std::size_t index, double constant) const {
    const double moved_s = movedBy_s(beam);
    std::vector<Arrival> arrivals;
    const double halo = e_.on("stray-radiation") ? e_.number("stray-radiation", "fraction", 1e-4) : 0.0;
    const Footprint footprint(p_, Dice(s_.seed, Use::footprint, {s_.sample, index}));
    if (many_ == 1) {
      trace(rayOf(beam, {0.0, 0.0}), moved_s, constant * (1.0 - halo), arrivals);
    } else {
      const bool simple = even(beam, footprint, moved_s) && !e_.on("multipath") && !e_.on("transmission");
      const int rays = simple ? few_ : many_;
      for (int i = 0; i < rays; ++i) {
        trace(rayOf(beam, footprint.at(i)), moved_s, constant * (1.0 - halo) / rays, arrivals);
      }
    }
    Dice dice(s_.seed, Use::wobble, {s_.sample, index});
    const double reach = e_.number("stray-radiation", "half_angle_rad", 0.02);
    for (int i = 0; halo > 0.0 && i < kHalo; ++i) {  // equal shares of each ring's angle: density one over the angle
      const double away = reach * (i + dice.uniform()) / kHalo, around = 2.0 * std::numbers::pi * dice.uniform();
      trace(rayOf(beam, {away * std::cos(around), away * std::sin(around)}), moved_s, constant * halo / kHalo,
            arrivals);
    }
    return arrivals;
  }

  // Without pulse-broadening all that one object sends back counts at its power-weighted mean range.
  [[nodiscard]] std::vector<Arrival> flattened(const std::vector<Arrival>& arrivals) const {
    if (e_.on("pulse-broadening")) return arrivals;
    std::map<int, Arrival> sums;
    for (const Arrival& arrival : arrivals) {
      Arrival& sum = sums.try_emplace(arrival.source, Arrival{0.0, 0.0, arrival.source}).first->second;
      sum.power_w += arrival.power_w;
      sum.range_m += arrival.power_w * arrival.range_m;
    }
    std::vector<Arrival> result;
    for (auto [source, sum] : sums) {
      if (sum.power_w > 0.0) result.push_back({sum.range_m / sum.power_w, sum.power_w, source});
    }
    return result;
  }

  [[nodiscard]] Prepared prepare(const Beam& beam, std::size_t index) const {
    Prepared prepared;
    prepared.axis = rayOf(beam, {0.0, 0.0});
    if (const auto hit = nearestHit(scene_, prepared.axis, movedBy_s(beam))) {
      prepared.end_m = hit->range_m;
      prepared.reflectivity = scene_[static_cast<std::size_t>(hit->object)].material.reflectivity;
    }
    const double area_m2 = std::numbers::pi / 4.0 * p_.aperture_m * p_.aperture_m;
    prepared.constant = p_.peak_power_w * p_.efficiency * area_m2 * receiver_.gain(beam);
    prepared.noise_w = receiver_.noise_w(beam, prepared.reflectivity);
    prepared.arrivals = flattened(surfacesIn(beam, index, prepared.constant));
    for (Arrival soft : air_.sentBack(prepared.axis, std::min(prepared.end_m, p_.max_range_m), prepared.constant)) {
      soft.power_w *= receiver_.overlap(soft.range_m);
      prepared.arrivals.push_back(soft);
    }
    addSpoof(beam, prepared.arrivals);
    return prepared;
  }

  void addSpoof(const Beam& beam, std::vector<Arrival>& arrivals) const {
    const std::string name = "spoofing";
    if (!e_.on(name)) return;
    const double from_middle = std::abs(beam.azimuth_rad / kDegree - e_.number(name, "azimuth_deg", 0.0));
    if (from_middle > 0.5 * e_.number(name, "width_deg", 2.0)) return;
    arrivals.push_back({e_.number(name, "range_m", 15.0), e_.number(name, "power_w", 1e-6), kForeign});
  }

  void prepareAll() {
    for (std::size_t b = 0; b < s_.beams.size(); ++b) prepared_.push_back(prepare(s_.beams[b], b));
    if (!e_.on("blooming")) return;
    const double fraction = e_.number("blooming", "fraction", 0.01);
    const int reach = static_cast<int>(e_.number("blooming", "neighbours", 5.0));
    std::map<std::pair<int, int>, std::size_t> at;
    for (std::size_t b = 0; b < s_.beams.size(); ++b) at[{s_.beams[b].layer, s_.beams[b].column}] = b;
    std::vector<std::vector<Arrival>> spilled(s_.beams.size());
    for (std::size_t b = 0; b < s_.beams.size(); ++b) {
      for (int k = -reach; k <= reach; ++k) {
        const auto neighbour = at.find({s_.beams[b].layer, s_.beams[b].column + k});
        if (k == 0 || neighbour == at.end()) continue;
        for (Arrival arrival : prepared_[b].arrivals) {
          arrival.power_w *= fraction / (k * k);
          spilled[neighbour->second].push_back(arrival);
        }
      }
    }
    for (std::size_t b = 0; b < s_.beams.size(); ++b) {
      prepared_[b].arrivals.insert(prepared_[b].arrivals.end(), spilled[b].begin(), spilled[b].end());
    }
  }

  [[nodiscard]] bool changesFromShotToShot() const {
    return e_.on("pulse-jitter") || e_.on("speckle") || e_.on("precipitation-clutter") || e_.on("road-spray");
  }

  // The impulses of one shot, and its pulse.
  [[nodiscard]] Waveform shotWaveform(const Prepared& beam, const Spray& spray, Dice& shot, Dice& drops) const {
    std::vector<Arrival> arrivals = beam.arrivals;
    Pulse pulse = s_.pulse;
    double power = 1.0;
    if (e_.on("pulse-jitter")) {  // log-normal power: it cannot become negative
      const double spread = e_.number("pulse-jitter", "power_stddev", 0.0),
                   width = std::sqrt(std::log1p(spread * spread));
      power = std::exp(width * shot.normal() - 0.5 * width * width);
      pulse.fwhm_ns += e_.number("pulse-jitter", "duration_stddev_ns", 0.0) * shot.normal();
      pulse.fwhm_ns = std::max(pulse.fwhm_ns, 0.2 * s_.pulse.fwhm_ns);
    }
    if (e_.on("speckle")) {
      std::map<int, double> brightness;
      const double looks = e_.number("speckle", "looks", 20.0);
      for (Arrival& arrival : arrivals) {
        if (arrival.source == kVolume || arrival.source == kForeign) continue;
        const auto [known, fresh] = brightness.try_emplace(arrival.source, 1.0);
        if (fresh) known->second = shot.gammaOfMeanOne(looks);
        arrival.power_w *= known->second;
      }
    }
    std::vector<Grain> grains = dropsInBeam(e_, p_, s_.environment, beam.constant, beam.end_m, drops);
    const std::vector<Grain> clusters = sprayInBeam(spray, beam.axis, beam.constant, beam.end_m);
    grains.insert(grains.end(), clusters.begin(), clusters.end());
    for (const Grain& grain : grains) {
      for (Arrival& arrival : arrivals) {
        if (arrival.range_m > grain.range_m) arrival.power_w *= grain.remaining;
      }
    }
    for (const Grain& grain : grains) {
      arrivals.push_back({grain.range_m, grain.power_w * receiver_.overlap(grain.range_m), kVolume});
    }
    for (Arrival& arrival : arrivals) arrival.power_w *= power;
    return saturated(Waveform(std::move(arrivals), pulse, tail_ns()));
  }

  [[nodiscard]] double tail_ns() const {
    return e_.on("saturation") ? 8.0 * e_.number("saturation", "recovery_ns", 0.0) : 0.0;
  }

  [[nodiscard]] Waveform saturated(Waveform waveform) const {
    const auto level = e_.number("saturation", "saturation_w");
    const auto at = level ? level : p_.saturation_w;
    if (e_.on("saturation") && at) waveform.saturate(*at, e_.number("saturation", "recovery_ns", 0.0));
    return waveform;
  }

  // Echoes that no light of this sensor caused.
  void addForeign(std::vector<Waveform::Stretch>& stretches, double noise_w, Dice& foreign) const {
    const auto add = [&](double range_m, double over, double width_share) {
      const double time_ns = 2.0 * range_m / kLight_m_ns, threshold = receiver_.threshold_w(range_m, noise_w);
      const double width_ns = width_share * s_.pulse.widthAt(over);
      stretches.push_back({time_ns - 0.5 * width_ns, time_ns + 0.5 * width_ns, time_ns, over * threshold});
    };
    const double false_echoes = e_.number("false-alarm", "rate_per_beam", 0.0) + receiver_.noiseEchoes(noise_w);
    for (int n = false_echoes > 0.0 ? foreign.poisson(false_echoes) : 0; n > 0; --n) {
      // Above a high level, excess over it is exponential: Rice 1945, sec. 3.7.
      const double range_m = foreign.uniform(p_.min_range_m, p_.max_range_m), noise = noise_w / p_.threshold_w;
      add(range_m, 1.0 + 1e-3 + noise * noise * foreign.exponential(), 1.0);
    }
    const double pulses = e_.number("crosstalk", "rate_1_s", 0.0) * 2e-9 * p_.max_range_m / kLight_m_ns;
    for (int n = pulses > 0.0 ? foreign.poisson(pulses) : 0; n > 0; --n) {
      const double range_m = foreign.uniform(0.0, p_.max_range_m), over = std::pow(100.0, foreign.uniform());
      add(range_m, over, foreign.uniform(0.8, 1.5));
    }
  }

  [[nodiscard]] std::vector<Detection> shoot(std::size_t index, int frame, const Spray& spray,
                                             std::optional<Waveform>& kept) const {
    const Prepared& beam = prepared_[index];
    const auto dice = [&](Use use) {
      return Dice(s_.seed, use, {s_.sample, static_cast<std::uint64_t>(frame), index});
    };
    if (!kept || changesFromShotToShot()) {
      Dice shot = dice(Use::shot), drops = dice(Use::drops);
      kept = shotWaveform(beam, spray, shot, drops);
    }
    Dice echo = dice(Use::echo), outputs = dice(Use::outputs), losses = dice(Use::losses), foreign = dice(Use::foreign);
    auto stretches =
        kept->above([&](double range_m) { return receiver_.threshold_w(range_m, beam.noise_w); },
                    [&](double threshold_w) { return std::min(beam.noise_w * echo.normal(), 0.9 * threshold_w); });
    addForeign(stretches, beam.noise_w, foreign);
    const double threshold = receiver_.threshold_w(std::min(beam.end_m, p_.max_range_m), beam.noise_w);
    return echoes_.read(std::move(stretches), s_.beams[index], frame, threshold, outputs, losses);
  }

  const Situation& s_;
  const Effects& e_;
  const Profile& p_;
  Surfaces surfaces_;
  Air air_;
  Receiver receiver_;
  Echoes echoes_;
  Turn mounting_;
  Vec place_;
  Scene scene_;
  int few_ = kFew, many_ = kMany;
  std::vector<Prepared> prepared_;
};

}  // namespace

std::vector<Detection> fireAll(const Situation& situation) { return Gun(situation).fireAll(); }

}  // namespace withheld
