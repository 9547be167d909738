#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Two surfaces closer than the separation give one echo. The chain merges in any case (formats.md section 3, step 4);
/// this only replaces the profile's separation.
class EchoMerging final : public Effect {
 public:
  explicit EchoMerging(const EffectParameters& parameters) : separation_m_(parameters.number("separation_m")) {}
  void prepare(ChainSettings& settings, const Environment&) override {
    settings.detection.echo_separation_m = separation_m_.value_or(settings.detection.echo_separation_m);
  }

 private:
  std::optional<double> separation_m_;
};

}  // namespace

EffectEntry echoMerging() {
  return {.info = {.name = "echo-merging",
                   .title = "Merging of near echoes",
                   .summary = "Two surfaces shortly behind each other give one echo between them instead of two.",
                   .stage = Stage::kPreProcessing,
                   .percollect = {"105", "118"},
                   .parameters = {{"separation_m", "m", 0.0, 10.0, std::nullopt,
                                   "Least distance of two echoes; without it the profile's", true, 1.5}},
                   .fitted = {"separation_m"},
                   .source = "Jutzi & Stilla 2006, ISPRS Journal of Photogrammetry and Remote Sensing 61"},
          .make = makeFrom<EchoMerging>};
}

}  // namespace model::effects
