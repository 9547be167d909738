#pragma once

#include "bench/withheld/generator/receiver.h"
#include "bench/withheld/generator/waveform.h"

namespace withheld {

/// One line of a measurement.
struct Detection {
  int frame = 0;
  std::size_t beam = 0;
  int echo = 1;
  double range_m = 0.0, epw_m = 0.0, intensity_nw = 0.0;
};

/// What the sensor's electronics make of stretches above the threshold: merging, dead time, range and width, errors of
/// the time base, noise of the outputs, gate, counters.
///
/// - clock drift: a slow clock counts too few ticks, r/(1 − s), and widths are counted by the same clock;
/// - dead time counts from the front of the last echo, seen or not (paralysable: Knoll 2010, ch. 4);
/// - counters: the width is the difference of two quantised times, not a quantised width.
/// Effects that the library does not have ("x-…") are here too, but for x-gain-ramp (receiver.h).
class Echoes {
 public:
  Echoes(const Profile& profile, const Effects& effects, const Environment& environment, const Pulse& pulse);

  /// `stretches` in any order; `outputs` and `losses` draw the noise of the outputs and what is lost.
  [[nodiscard]] std::vector<Detection> read(std::vector<Waveform::Stretch> stretches, const Beam& beam, int frame,
                                            double threshold_w, Dice& outputs, Dice& losses) const;

 private:
  void merge(std::vector<Waveform::Stretch>& stretches) const;
  void blindAfterEcho(std::vector<Waveform::Stretch>& stretches) const;
  [[nodiscard]] double rangeOf(const Waveform::Stretch& stretch, double threshold_w) const;
  void driftAndOffset(Detection& detection) const;
  void unknownErrors(Detection& detection, const Beam& beam, Dice& outputs) const;
  void quantise(Detection& detection) const;
  [[nodiscard]] bool lost(const Beam& beam, Dice& losses) const;

  const Profile& profile_;
  const Effects& effects_;
  Pulse pulse_;
  double above_20_degC_;
  double from_m_, to_m_;
};

}  // namespace withheld
