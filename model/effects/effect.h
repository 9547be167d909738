#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/json_object.h"
#include "core/random.h"
#include "model/experiment.h"
#include "model/sensor/beams.h"
#include "model/sensor/sensor_profile.h"

namespace model {

/// Where in the signal chain an effect acts, in the order of the chain.
enum class Stage { kEmission, kPropagation, kInteraction, kReception, kPreProcessing, kDetection };
[[nodiscard]] std::string toString(Stage stage);

/// A number that an effect takes.
struct ParameterInfo {
  std::string name;  ///< with its unit as suffix
  std::string unit;
  double min = 0.0;  ///< plausible range, both ends included
  double max = 0.0;
  std::optional<double> default_value;  ///< absent: must be given, or comes from profile or environment (see meaning)
  std::string meaning;
  bool logarithmic = false;  ///< varies over decades: search it on a logarithmic scale
  double typical = 0.0;      ///< a start for a fit
};

/// What an effect says about itself; the command line, the desktop, the diagnosis and the documentation read this.
struct EffectInfo {
  std::string name;   ///< effects.md, kebab-case
  std::string title;  ///< for people
  Stage stage = Stage::kDetection;
  std::vector<std::string> percollect;  ///< node ids of the LidarLimbs JSON release
  std::vector<ParameterInfo> parameters;
  std::vector<std::string> fitted;  ///< parameters that a diagnosis fits (the others keep default or recorded values)
  std::string source;               ///< literature
  bool moves_geometry = false;      ///< changes which rays are traced
};

/// The values given in a model file.
struct EffectParameters {
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;

  [[nodiscard]] double numberOr(const std::string& name, double otherwise) const;
  [[nodiscard]] std::optional<double> number(const std::string& name) const;
  [[nodiscard]] std::string textOr(const std::string& name, const std::string& otherwise) const;
};

/// The constants of the signal chain, taken from the profile; effects may change them before anything runs.
struct ChainSettings {
  Emitter emitter;
  Receiver receiver;
  DetectionStage detection;
  AngularSize divergence;        ///< zero: the beam is its central ray (beam-divergence off)
  bool broadens_pulses = false;  ///< false: sub-rays on one object count at their mean range
  double range_scale = 1.0;      ///< time base: reported = scale * true + offset
  double range_offset_m = 0.0;
};

/// One sub-ray's return, as effects see it.
struct Reflection {
  const Beam& beam;
  double azimuth_rad;  ///< of the sub-ray itself
  double range_m;
  double cos_incidence;
  const Material& material;
};

/// An echo on its way to becoming a detection.
struct Echo {
  double range_m = 0.0;
  double epw_m = 0.0;   ///< c · width, not halved
  double peak_w = 0.0;  ///< of s(t) + n
};

/// One effect of the library, switched on with its parameters. Hooks that an effect does not need stay empty.
/// Immutable and safe to share between threads; randomness comes in as an argument.
class Effect {
 public:
  virtual ~Effect() = default;
  /// Changes constants of the chain.
  virtual void prepare(ChainSettings&, const Environment&) const {}
  /// Turns or moves the beams before they are traced.
  virtual void aim(std::span<Beam>) const {}
  /// Multiplies the received power of a sub-ray; 1 is no change. Says whether it does so at all.
  [[nodiscard]] virtual bool changesPower() const { return false; }
  [[nodiscard]] virtual double powerFactor(const Reflection&) const { return 1.0; }
  /// Multiplies all of a beam's power in one frame (speckle, jitter); 1 is no change.
  [[nodiscard]] virtual bool fluctuates() const { return false; }
  [[nodiscard]] virtual double fluctuation(const Beam&, core::Random&) const { return 1.0; }
  /// Changes an echo before noise is added. `threshold_w` is the receiver's.
  virtual void process(Echo&, const ChainSettings&) const {}
  /// Removes or adds echoes of one beam in one frame, before they are numbered.
  [[nodiscard]] virtual bool reports() const { return false; }
  virtual void report(std::vector<Echo>&, const ChainSettings&, core::Random&) const {}
};

using MakeEffect = std::unique_ptr<Effect> (*)(const EffectParameters&);

/// Declaration and maker of one effect.
struct EffectEntry {
  EffectInfo info;
  MakeEffect make;
  std::vector<std::pair<std::string, std::vector<std::string>>> texts;  ///< text parameters with their choices
};

/// Every effect of the library, in the order of the signal chain (model/effects/all_effects.cpp).
[[nodiscard]] const std::vector<EffectEntry>& allEffects();

/// nullptr if there is none of that name.
[[nodiscard]] const EffectEntry* findEffect(const std::string& name);

/// Reads the parameters of one effect: unknown names, wrong types and values outside the range are InputErrors.
[[nodiscard]] EffectParameters readEffectParameters(const EffectEntry& entry, core::JsonObject object);

}  // namespace model
