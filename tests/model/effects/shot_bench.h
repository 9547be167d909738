#pragma once

#include "tests/model/effects/effect_bench.h"

namespace model::lab {

/// A case ready to be fired shot by shot, with everything that happens in a shot written down.
class ShotBench {
 public:
  explicit ShotBench(const Case& setup)
      : experiment_(experimentOf(setup)),
        model_(modelOf(setup)),
        traced_(traceSample(experiment_, model_, experiment_.samples[0])),
        chain_(model_.sensor(""), model_.effects, traced_.situation.environment) {}

  [[nodiscard]] ShotRecord shot(int frame = 0, std::size_t beam = 0) const {
    return chain_.record(traced_.hits, beam, traced_.situation.scene, {.seed = 7, .frames = frame + 1}, frame);
  }

 private:
  Experiment experiment_;
  LidarModel model_;
  TracedSample traced_;
  SignalChain chain_;
};

/// Simpson's rule.
template <typename Function>
double integral(double from, double to, Function f, int steps = 4000) {
  const double h = (to - from) / steps;
  double sum = f(from) + f(to);
  for (int i = 1; i < steps; ++i) sum += (i % 2 ? 4.0 : 2.0) * f(from + i * h);
  return sum * h / 3.0;
}

}  // namespace model::lab
