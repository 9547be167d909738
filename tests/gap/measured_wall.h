#pragma once

#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/causes/fit.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace test_support {

/// The small world as a true model measures it, beside what the model under test makes of it.
class MeasuredWall : public testing::Test {
 protected:
  MeasuredWall() = default;  // to be measured by the test
  explicit MeasuredWall(const SmallWorld::Effects& truth) { measure(truth); }

  void measure(SmallWorld::Effects truth, const std::map<std::string, double>& offset_m = {},
               const std::map<std::string, double>& sensor = {}, const SmallWorld::Effects& known = {}) {
    truth.insert(known.begin(), known.end());
    measured_ = world_.measuredBy(SmallWorld::modelWith(truth, sensor), 0.4, offset_m);
    replay_.emplace(measured_, SmallWorld::modelWith(known, sensor));
    split_ = gap::splitOf(*replay_, 1);
  }
  /// Nothing is missing but that the wall stands elsewhere in all samples.
  void moveBy(double offset_m) {
    std::map<std::string, double> everywhere;
    for (const char* sample : {"r8", "r13", "r19", "r27", "r36", "r46"}) everywhere[sample] = offset_m;
    measure({}, everywhere);
  }
  [[nodiscard]] gap::Hypothesis effect(const std::string& name) const {
    return hypothesisNamed(gap::hypothesesFor(*replay_, {name}), name);
  }
  /// The same with these values.
  [[nodiscard]] gap::Candidate with(const std::string& name, std::vector<double> values) const {
    return {effect(name), std::move(values)};
  }
  /// A cause that moves the wall by so much for each unit of its one number.
  [[nodiscard]] static gap::Hypothesis movedBy(const std::string& name, double most = 0.5, double m_per_unit = 1.0) {
    gap::Hypothesis cause;
    cause.name = name;
    cause.parameters = {{"value", "", -most, most, false, 0.0}};
    cause.apply = [m_per_unit](gap::World& world, const std::vector<double>& values) {
      world.references.push_back({"/scene/0/pose/position_m/0", m_per_unit * values[0], {}});
    };
    return cause;
  }
  [[nodiscard]] gap::Judge judge() const { return {*replay_, split_, gap::yardstickOf(*replay_, split_.held_out)}; }
  [[nodiscard]] gap::Scouted scouted(const gap::Hypothesis& hypothesis) const {
    return gap::scout(*replay_, hypothesis, split_.fitted, {}, core::SilentProgress());
  }

  SmallWorld world_;
  model::Experiment measured_;
  std::optional<gap::Replay> replay_;
  gap::Split split_;
};

}  // namespace test_support
