#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/json_object.h"
#include "core/random.h"
#include "model/experiment.h"
#include "model/geometry/hits.h"
#include "model/sensor/beams.h"
#include "model/sensor/sensor_profile.h"
#include "model/signal/pulse.h"

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
  double absent_at = 0.0;    ///< where the effect does nothing: searched finely if it lies in the plausible range
  bool whole = false;        ///< a count
  bool seed = false;         ///< picks random numbers: no quantity that may be wrong
};

/// A list of numbers that an effect takes.
struct ListInfo {
  std::string name;
  std::string unit;
  double min = 0.0;  ///< of each number
  double max = 0.0;
  std::size_t count = 0;  ///< 0: any number of them
  std::string meaning;
};

/// Other numbers that a diagnosis may fit of the same effect: another law or another mechanism.
struct FittedForm {
  std::string name;                     ///< for people, tells it from the usual form
  std::vector<std::string> parameters;  ///< of it, that are free; may be none
  bool costly = false;                  ///< to fit: only where the usual form explains something already
};

/// What an effect says about itself; the command line, the desktop, the diagnosis and the documentation read this.
struct EffectInfo {
  std::string name;     ///< effects.md, kebab-case
  std::string title;    ///< for people
  std::string summary;  ///< a sentence for a reader who never heard of it: what happens, and what shows
  Stage stage = Stage::kDetection;
  std::vector<std::string> percollect;  ///< node ids of the LidarLimbs JSON release
  std::vector<ParameterInfo> parameters;
  std::vector<std::string> fitted;  ///< parameters that a diagnosis fits (the others keep default or recorded values)
  std::vector<FittedForm> other_forms;
  std::string source;                   ///< literature
  bool moves_geometry = false;          ///< changes which rays are traced
  std::vector<std::string> power_only;  ///< parameters that change what traced rays carry, not where they go
  bool every_shot_alike = false;        ///< takes echoes from all shots with one probability, wherever they go
};

/// The values given in a model file.
struct EffectParameters {
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<double>> lists;

  [[nodiscard]] double numberOr(const std::string& name, double otherwise) const;
  [[nodiscard]] std::optional<double> number(const std::string& name) const;
  [[nodiscard]] std::string textOr(const std::string& name, const std::string& otherwise) const;
  [[nodiscard]] std::vector<double> listOr(const std::string& name, std::vector<double> otherwise) const;
};

/// In what steps the outputs are counted, before they are rounded to the profile's resolution; 0: in fine ones.
struct CounterSteps {
  double range_m = 0.0;
  double epw_m = 0.0;
  double intensity_nw = 0.0;
  double intensity_full_scale_nw = std::numeric_limits<double>::infinity();  ///< the highest level
};

/// The constants of the signal chain, taken from the profile; effects may change them before anything runs.
struct ChainSettings {
  Emitter emitter;
  Receiver receiver;
  DetectionStage detection;
  AngularSize divergence;        ///< zero: the beam is its central ray (beam-divergence off)
  bool broadens_pulses = false;  ///< false: sub-rays on one object count at their mean range
  CounterSteps counters;
  double range_scale = 1.0;  ///< time base: reported = scale * true + offset
  double range_offset_m = 0.0;
  Vector3 sensor_position_m{};  ///< where the sensor really stands; the origin but for a mounting error
  Vector3
      sensor_velocity_m_s{};  ///< of the sensor in the frame of the scene; counts where beams have times of their own
  int most_crossings = 0;     ///< how many panes and mirrors a path may have before it ends on a surface
};

/// A pane or mirror that a path crossed before it met the surface that sent it back.
struct Crossing {
  enum class Way { kThrough, kMirrored };
  Way way = Way::kThrough;
  const Material* material = nullptr;
  double cos_incidence = 1.0;
};

/// One sub-ray's return, as effects see it.
struct Reflection {
  const Beam& beam;
  double left_rad;  ///< offset of the sub-ray in the beam's own plane
  double up_rad;
  double range_m;  ///< length of the whole path, one way
  double cos_incidence;
  const Material& material;
  std::span<const Crossing> crossings;  ///< nearest first; empty on the straight way

  /// Direction of the sub-ray, unit length.
  [[nodiscard]] Vector3 direction() const { return directionOf(beam, left_rad, up_rad); }
  [[nodiscard]] double azimuth_rad() const;
};

/// Straight returns of neighbouring beams, column by column, for effects whose factor is worth working out in bulk.
struct Returns {
  std::span<const double> range_m;
  std::span<const float> cos_incidence;
  std::span<const std::int32_t> object;
  std::span<const Material* const> material_of;  ///< by object
  std::span<double> power_w;                     ///< received peak powers so far
};

/// A beam in its surroundings, for effects that add pulses of their own.
struct BeamView {
  const Beam& beam;
  const HitsOfBeam& hits;  ///< what its sub-rays met first
  const Scene& scene;
  const ChainSettings& settings;
  const SubRays& rays;  ///< of the beam; a hit names its own
  /// η A_r P_t of this beam: received power of a surface = this · w · β cos θ / r². [W m²]
  double power_constant_w_m2;
};

/// What an effect does to the pulses of one frame's shots. What all beams of the frame share (drops that hang in the
/// air) is drawn already. Lives no longer than the effect and the scene that it comes from.
class Disturbance {
 public:
  virtual ~Disturbance() = default;
  /// Adds, moves or weakens pulses of a shot at random. `key` is that of the effect's stream for this shot.
  virtual void disturb(const BeamView&, const core::Random::Key& key, std::vector<Pulse>&) const = 0;
};

/// Where an echo ended up.
enum class Fate {
  kDetected,
  kBelowThreshold,
  kMerged,         ///< part of the echo before it
  kBlinded,        ///< the receiver could not see it
  kLost,           ///< by chance
  kOutsideWindow,  ///< nearer or farther than the sensor reports
  kTooMany,        ///< behind the last echo that is reported
};

/// An echo on its way to becoming a detection.
struct Echo {
  double range_m = 0.0;
  double epw_m = 0.0;           ///< c · width, not halved
  double peak_w = 0.0;          ///< of s(t) + n
  Fate fate = Fate::kDetected;  ///< an effect that drops an echo says why; nobody behind it sees the echo
  double noise_w = 0.0;         ///< n in its peak
  // What becomes of it where the emitted pulse is longer by a small share of its width, divided by that share. Not of
  // what a shot that nothing but noise disturbs sent back.
  double epw_per_width_m = 0.0;
  double peak_per_width = 0.0;  ///< of s(t), relative; 0 where no pulses overlap

  /// Of s(t) alone.
  [[nodiscard]] double signal_w() const { return peak_w - noise_w; }
};

/// One effect of the library, switched on with its parameters. Hooks that an effect does not need stay empty; those
/// that cost time say first whether they do anything. Immutable and safe to share between threads once prepared;
/// randomness comes in as an argument.
class Effect {
 public:
  virtual ~Effect() = default;

  // --- before anything runs
  /// Changes constants of the chain; keeps what it needs of them. Called once, in the order of the chain.
  virtual void prepare(ChainSettings&, const Environment&) {}
  /// Turns or moves the beams before they are traced, or tells them another time of the scene.
  virtual void aim(std::span<Beam>) const {}
  /// Adds or changes sub-rays of the beam; their weights are of its power. Called in the order of the chain.
  virtual void spread(SubRays&, const ChainSettings&) const {}
  /// Whether sub-rays go on behind a surface of this material, or are mirrored by it (needs most_crossings > 0).
  [[nodiscard]] virtual bool letsThrough(const Material&) const { return false; }
  [[nodiscard]] virtual bool mirrors(const Material&) const { return false; }

  // --- received power
  /// Multiplies the received power of a sub-ray; 1 is no change. Says whether it does so at all.
  [[nodiscard]] virtual bool changesPower() const { return false; }
  [[nodiscard]] virtual double powerFactor(const Reflection&) const { return 1.0; }
  /// The same for many straight returns at once, if the factor needs no more than `Returns`.
  [[nodiscard]] virtual bool weakensInBulk() const { return false; }
  virtual void weaken(const Returns&) const {}
  /// Adds pulses to those of a beam that are the same in every frame (backscatter, false targets), or weakens them.
  [[nodiscard]] virtual bool addsPulses() const { return false; }
  virtual void addPulses(const BeamView&, std::vector<Pulse>&) const {}
  /// Lets beams speak to each other: pulses of all beams of a frame, before anything random.
  [[nodiscard]] virtual bool couplesBeams() const { return false; }
  virtual void couple(std::span<const Beam>, const ChainSettings&, std::vector<std::vector<Pulse>>&) const {}

  // --- one shot: a beam in a frame
  /// Disturbs the pulses of shots at random. What it does to those of one frame; `key` is that of a stream of its own
  /// for what all beams of the frame share. Not null where it disturbs.
  [[nodiscard]] virtual bool disturbs() const { return false; }
  [[nodiscard]] virtual std::unique_ptr<const Disturbance> inFrame(const Scene&, const ChainSettings&,
                                                                   const core::Random::Key& /*key*/) const {
    return nullptr;
  }
  /// Multiplies all of a beam's power in one frame (jitter), or what surfaces send back alone (speckle); 1 is no
  /// change.
  [[nodiscard]] virtual bool fluctuates() const { return false; }
  [[nodiscard]] virtual bool fluctuatesOnSurfaces() const { return false; }
  [[nodiscard]] virtual double fluctuation(const Beam&, core::Random&) const { return 1.0; }
  /// Changes the receiver for one beam: noise, threshold, saturation.
  [[nodiscard]] virtual bool changesReceiver() const { return false; }
  virtual void receive(const Beam&, Receiver&) const {}

  /// Variance of a beam's noise beyond what `prepare` gave all of them; may be negative. Of an effect that changes no
  /// more of the receiver than that. [W²]
  [[nodiscard]] virtual bool addsNoise() const { return false; }
  [[nodiscard]] virtual double addedNoise_w2(const BeamView&) const { return 0.0; }

  // --- echoes
  /// Changes an echo before noise is added. `receiver` is the one of this beam.
  [[nodiscard]] virtual bool changesEchoes() const { return false; }
  virtual void process(Echo&, const Receiver&, const ChainSettings&) const {}
  /// Echoes with a signal up to this power are left by `process` as they are: most of them need not be asked about. [W]
  [[nodiscard]] virtual double processesAbove_w(const Receiver&) const { return 0.0; }
  /// Drops (says the fate) or adds echoes of one shot, before they are rounded and numbered.
  [[nodiscard]] virtual bool reports() const { return false; }
  virtual void report(std::vector<Echo>&, const ChainSettings&, core::Random&) const {}
};

using MakeEffect = std::unique_ptr<Effect> (*)(const EffectParameters&);

/// Declaration and maker of one effect.
struct EffectEntry {
  EffectInfo info;
  MakeEffect make;
  std::vector<std::pair<std::string, std::vector<std::string>>> texts;  ///< text parameters with their choices
  std::vector<ListInfo> lists;                                          ///< parameters that are lists of numbers
};

/// Every effect of the library, in the order of the signal chain (model/effects/all_effects.cpp).
[[nodiscard]] const std::vector<EffectEntry>& allEffects();

/// nullptr if there is none of that name.
[[nodiscard]] const EffectEntry* findEffect(const std::string& name);

/// Reads the parameters of one effect: unknown names, wrong types and values outside the range are InputErrors.
[[nodiscard]] EffectParameters readEffectParameters(const EffectEntry& entry, core::JsonObject object);

}  // namespace model
