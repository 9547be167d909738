#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// A strong echo spills into the receiver elements beside its own: a reflector appears wider than it is.
///
///   P_spilled(d) = fraction · P / d²,      d = 1 … neighbours: distance in beams of the same layer
///
/// at the range of the echo, on both sides. A target of received power P so grows on each side by the
/// floor(sqrt(fraction · P / P_threshold)) beams in which the spill passes the threshold. Neighbours are counted in the
/// order of columns; other layers receive nothing. What lies below a hundredth of the threshold is left out, for no
/// waveform is followed so far down. Holds for arrays, whose elements listen at once; for a scanner it stands for the
/// halo of its optics. Source: Peterson 2004, Proc. SPIE 5178 (inverse-square skirts of scattering optics).
class Blooming final : public Effect {
 public:
  explicit Blooming(const EffectParameters& parameters)
      : fraction_(parameters.numberOr("fraction", 1e-2)),
        neighbours_(static_cast<std::size_t>(std::lround(parameters.numberOr("neighbours", 5.0)))) {}

  [[nodiscard]] bool couplesBeams() const override { return fraction_ > 0.0; }
  void couple(std::span<const Beam> beams, const ChainSettings& settings,
              std::vector<std::vector<Pulse>>& pulses) const override {
    const double bin_m = core::kMetresPerNanosecond * settings.emitter.pulse_fwhm_ns / 8.0;
    const double least_w = kWorthFollowing * settings.receiver.threshold_w;
    const std::vector<std::size_t> order = byLayerAndColumn(beams);
    std::vector<std::vector<Pulse>> spilled(beams.size());
    for (std::size_t at = 0; at < order.size(); ++at) {
      const std::vector<Pulse> sources = merged(pulses[order[at]], bin_m);
      for (const int side : {-1, 1}) spill(beams, order, at, side, sources, least_w, spilled);
    }
    for (std::size_t b = 0; b < beams.size(); ++b) {
      pulses[b].insert(pulses[b].end(), spilled[b].begin(), spilled[b].end());
    }
  }

 private:
  static constexpr double kWorthFollowing = 0.01;

  static std::vector<std::size_t> byLayerAndColumn(std::span<const Beam> beams) {
    std::vector<std::size_t> order(beams.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(beams[a].layer, beams[a].column) < std::pair(beams[b].layer, beams[b].column);
    });
    return order;
  }

  /// Pulses nearer than `bin_m` to the first of them are one: a footprint of many sub-rays spills once.
  static std::vector<Pulse> merged(std::vector<Pulse> pulses, double bin_m) {
    std::sort(pulses.begin(), pulses.end(), [](const Pulse& a, const Pulse& b) { return a.range_m < b.range_m; });
    std::vector<Pulse> sums;
    double first_m = 0.0;
    for (const Pulse& pulse : pulses) {
      if (pulse.power_w <= 0.0) continue;
      if (sums.empty() || pulse.range_m - first_m >= bin_m) {
        sums.push_back({pulse.range_m, 0.0, false});
        first_m = pulse.range_m;
      }
      Pulse& sum = sums.back();
      sum.power_w += pulse.power_w;
      sum.of_surface = sum.of_surface || pulse.of_surface;
      sum.range_m += (pulse.range_m - sum.range_m) * pulse.power_w / sum.power_w;
    }
    return sums;
  }

  void spill(std::span<const Beam> beams, const std::vector<std::size_t>& order, std::size_t at, int side,
             const std::vector<Pulse>& sources, double least_w, std::vector<std::vector<Pulse>>& spilled) const {
    for (std::size_t d = 1; d <= neighbours_; ++d) {
      if (side < 0 ? d > at : at + d >= order.size()) return;
      const std::size_t to = order[side < 0 ? at - d : at + d];
      if (beams[to].layer != beams[order[at]].layer) return;
      const double share = fraction_ / static_cast<double>(d * d);
      for (const Pulse& source : sources) {
        if (share * source.power_w < least_w) continue;
        spilled[to].push_back({source.range_m, share * source.power_w, source.of_surface});
      }
    }
  }

  double fraction_;
  std::size_t neighbours_;
};

}  // namespace

EffectEntry blooming() {
  return {
      .info =
          {.name = "blooming",
           .title = "Blooming",
           .summary =
               "A very strong echo spills into the beams beside it, so that bright objects look larger than they are.",
           .stage = Stage::kReception,
           .percollect = {"72"},
           .parameters = {{"fraction", "", 0.0, 0.1, 1e-2, "Share of an echo in the next beam; seldom below 1e-4", true,
                           1e-2},
                          {"neighbours", "", 1.0, 20.0, 5.0, "Beams on each side that it reaches at most", false, 5.0,
                           0.0, true}},
           .fitted = {"fraction"},
           .other_forms = {{"of another reach", {"fraction", "neighbours"}, true}},
           .source = "Peterson 2004, Proc. SPIE 5178 (in-field scattered light)"},
      .make = makeFrom<Blooming>};
}

}  // namespace model::effects
