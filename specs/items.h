#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace specs {

/// What a specification is made of. Links run from left to right and may have several parents:
///
///   CEPRA row -> requirement -> acceptance test -> experiment data requirement
///                 |   ^                  |                  |
///                 +---+ (refines)        +------------------+--> reference data requirement
enum class Kind { CepraRow, Requirement, AcceptanceTest, ExperimentData, ReferenceData };

enum class Status { UnderReview, Accepted, Rejected };

/// What a requirement speaks about: the simulation as a whole, its object list, or its single detections.
enum class Level { General, ObjectModel, DetectionModel };

/// What all kinds have in common.
struct Item {
  std::string uid;  ///< stable for ever, never shown; "" until the store gives one
  std::string id;   ///< shown, unique in the project, may be changed: `<Phenomenon>_<Causes>_<No.>`
  std::string title;
  std::string text;       ///< what must hold
  std::string rationale;  ///< why
  std::string author;
  Status status = Status::UnderReview;
  bool operator==(const Item&) const = default;
};

struct Requirement : Item {
  Level level = Level::DetectionModel;
  std::vector<std::string> effects;  ///< effects of the sensor model (names) that it binds
  bool operator==(const Requirement&) const = default;
};

/// Compares a re-simulation with a measurement and decides by an expression. Paths are relative to the project file's
/// folder. A test without `experiment` cannot run; it is an inspection whose verdict is "skipped".
struct AcceptanceTest : Item {
  std::string experiment;            ///< folder of an experiment package
  std::string model;                 ///< model file
  std::string measurand;             ///< as named in the experiment: "range", "epw", …
  std::string gate;                  ///< id of a gate or object; "": the whole scene
  std::string metric;                ///< name of the metric that leads ("dvm"); the expression may use others too
  std::string expression;            ///< holds if the test passes: `abs(d_bias) <= 0.005 * range_m`
  std::vector<std::string> samples;  ///< roles ("validation") or sample ids; empty: all samples of role validation
  std::optional<int> frames;         ///< frames to simulate per sample; empty: as many as were measured
  std::map<std::string, std::string> options;  ///< further settings of the evaluation, by name
  bool operator==(const AcceptanceTest&) const = default;
};

/// What an experiment must deliver so that a test can be decided.
struct ExperimentData : Item {
  std::string experiment;  ///< folder of the package that delivers it, relative to the project file; "" if not measured
  std::string device;      ///< measurement device: the sensor under test
  std::string conditions;  ///< scene, environment and ranges of the parameters
  std::string repetitions;  ///< set-ups and frames that are needed
  bool operator==(const ExperimentData&) const = default;
};

/// What must be known independently of the sensor, and how well.
struct ReferenceData : Item {
  std::string quantity;     ///< "range from sensor to target"
  std::string device;       ///< reference measurement device
  std::string uncertainty;  ///< with unit and coverage: "± 2 mm (95 %)"
  bool operator==(const ReferenceData&) const = default;
};

/// One step of the trace, by shown ids (of a CEPRA row: its key). `suspect`: an end has changed since somebody looked.
struct Link {
  std::string from;  ///< the origin
  std::string to;    ///< what follows from it
  bool suspect = false;
  bool operator==(const Link&) const = default;
  auto operator<=>(const Link&) const = default;
};

/// May an item of one kind follow from an item of the other? (See the picture above.)
[[nodiscard]] bool mayLink(Kind from, Kind to);

/// "requirement", "acceptance test", …; "under review", …; "general", "object-model", "detection-model".
[[nodiscard]] std::string_view name(Kind kind);
[[nodiscard]] std::string_view name(Status status);
[[nodiscard]] std::string_view name(Level level);
[[nodiscard]] Kind kindNamed(std::string_view name);  ///< the name must be one of name(Kind)
[[nodiscard]] std::optional<Status> statusOf(std::string_view name);
[[nodiscard]] std::optional<Level> levelOf(std::string_view name);

/// Kind of an item type, for generic code: kindOf<Requirement>() is Kind::Requirement.
template <class T>
constexpr Kind kindOf();
template <>
constexpr Kind kindOf<Requirement>() {
  return Kind::Requirement;
}
template <>
constexpr Kind kindOf<AcceptanceTest>() {
  return Kind::AcceptanceTest;
}
template <>
constexpr Kind kindOf<ExperimentData>() {
  return Kind::ExperimentData;
}
template <>
constexpr Kind kindOf<ReferenceData>() {
  return Kind::ReferenceData;
}

}  // namespace specs
