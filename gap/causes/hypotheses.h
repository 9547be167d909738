#pragma once

#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "gap/replay/replay.h"

namespace gap {

enum class CauseKind { kEffect, kParameter, kReference };
[[nodiscard]] std::string toString(CauseKind kind);

/// A number that a hypothesis leaves open.
struct FreeParameter {
  std::string name;
  std::string unit;
  double low = 0.0;
  double high = 0.0;
  bool logarithmic = false;
  double start = 0.0;
  double absent_at = 0.0;  ///< where the cause does nothing
  bool whole = false;      ///< a count
  bool azimuth = false;    ///< of a sector: it may lie anywhere, and nothing is special about zero
};

/// One possible cause of the gap: how the world would differ from the baseline.
struct Hypothesis {
  CauseKind kind = CauseKind::kEffect;
  std::string name;     ///< effect, or JSON Pointer
  std::string variant;  ///< tells several forms of one cause apart ("oren-nayar", "per set-up")
  std::vector<FreeParameter> parameters;
  std::function<void(World&, const std::vector<double>&)> apply;
  std::vector<std::string> percollect;  ///< graph nodes that the cause stands for
  std::string decomposition_block;
  bool per_setup = false;            ///< one parameter a set-up, named after it
  bool costly = false;               ///< to fit: only where another form of the same cause explains something already
  bool anywhere = false;             ///< place and extent of what acts are free, so that it can pose as much else
  bool seen_in_values = false;       ///< the measured values show it by themselves, however little they move a mean
  double improbable_nats = 0.0;      ///< how rarely this cause looks as it was read off the data: -ln of how often
  std::vector<std::string> sensors;  ///< on which alone it holds; empty: on all
  std::vector<Hypothesis> members;   ///< of a pair, in the order of its parameters; empty for a single cause
};

/// What tells a cause from all others of a search: name, variant, sensors.
using Form = std::tuple<std::string, std::string, std::vector<std::string>>;
[[nodiscard]] inline Form formOf(const Hypothesis& h) { return {h.name, h.variant, h.sensors}; }

/// Everything that the library offers for this experiment and model: effects that the model lacks, parameters of
/// sensor, materials and active effects, reference quantities. `only` names effects (empty: all).
[[nodiscard]] std::vector<Hypothesis> hypothesesFor(const Replay& replay, const std::vector<std::string>& only);

/// Whether these values move a reference quantity only to where it may stand by what is recorded of it, in all samples:
/// that is no error of the reference, and every hypothesis may settle there (settle.h).
[[nodiscard]] bool asRecorded(const Replay& replay, const Hypothesis& hypothesis, const std::vector<double>& values);

/// Both at once; its values are those of one after those of the other.
[[nodiscard]] Hypothesis together(const Hypothesis& a, const Hypothesis& b);
/// One of them where the other one holds with these values.
[[nodiscard]] Hypothesis beside(const Hypothesis& known, const std::vector<double>& values, const Hypothesis& added);
/// Values with the ends of a sector in order, which a search may cross.
[[nodiscard]] std::vector<double> inOrder(const std::vector<FreeParameter>& parameters, std::vector<double> values);
[[nodiscard]] std::vector<double> joined(std::vector<double> a, const std::vector<double>& b);

}  // namespace gap
