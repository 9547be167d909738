#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gap/replay/replay.h"

namespace gap {

/// The built-in lidar that stands for a model that is not ours where effects must be switched and fitted. In this
/// order: the one given; the `proxy` of the model file (a model file's name, or its keys: sensor, rays_per_beam,
/// effects; a sensor that is not named is the experiment's); the experiment's sensor with beam divergence and pulse
/// broadening. Throws InputError if it is itself not built in.
[[nodiscard]] model::LidarModel proxyOf(const model::Experiment& experiment, const model::LidarModel& foreign,
                                        const std::optional<model::LidarModel>& given);

/// The built-in model in `file`, which a person names as the proxy of `lidar`; none if `file` is empty. Throws
/// InputError if `lidar` is built in: nothing needs to stand for it.
[[nodiscard]] std::optional<model::LidarModel> chosenProxy(const std::filesystem::path& file,
                                                           const model::LidarModel& lidar);

/// How far a diagnosis of a foreign model rests on its proxy.
struct Approximation {
  std::string proxy;       ///< id of the built-in model
  double proxy_gap = 0.0;  ///< total gap between the foreign model and its proxy, mean over the held-out samples
  double noise = 0.0;      ///< the same between two simulations of the proxy
  double gap = 0.0;        ///< the same between the foreign model and the measurement
  double ratio = 0.0;      ///< (proxy_gap - noise) / (gap - noise), at least 0: 0 is a perfect proxy
  std::string text;        ///< sentences

  /// The proxy is nearer to the foreign model than the measurement is.
  [[nodiscard]] bool reliable() const { return ratio < 1.0; }
  /// Factor on the confidence in a cause: 1 for a proxy that differs by less than a tenth of the gap, 0.3 for one that
  /// differs by most of it.
  [[nodiscard]] double trust() const;
};

/// Compares the foreign model with its proxy, and both with the measurement. `present`: there is a gap to explain; if
/// not, the text gives no advice on causes.
[[nodiscard]] Approximation approximationOf(const Replay& replay, const std::vector<std::size_t>& held_out,
                                            std::uint64_t seed, bool present);

}  // namespace gap
