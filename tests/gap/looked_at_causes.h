#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gap/pairs/looks.h"
#include "tests/gap/small_world.h"
#include "tests/gap/usual_causes.h"

namespace test_support {

/// A measurement, the causes that may explain it as they are usual, and what they do to few data.
class LookedAtCauses {
 public:
  /// The world lives longer. Of the causes, which are best first, the one of the first name leads, and those of the
  /// other come last.
  LookedAtCauses(const SmallWorld& world, const SmallWorld::Effects& truth, const std::string& first,
                 const std::string& last, const std::map<std::string, double>& sensor = {},
                 double true_reflectivity = 0.4)
      : measured_(world.measuredBy(SmallWorld::modelWith(truth, sensor), true_reflectivity)),
        replay_(measured_, SmallWorld::modelWith({}, sensor)) {
    const auto is = [](const std::string& name) {
      return [name](const gap::Candidate& c) { return c.hypothesis.name == name; };
    };
    std::stable_partition(singles_.begin(), singles_.end(), is(first));
    std::stable_partition(singles_.begin(), singles_.end(), std::not_fn(is(last)));
  }

  /// The place of a cause, with what its fit alone found.
  std::size_t fitted(const std::string& name, const std::vector<double>& values) {
    const auto single = std::find_if(singles_.begin(), singles_.end(), [&](const gap::Candidate& candidate) {
      return candidate.hypothesis.name == name;
    });
    single->values = values;
    return static_cast<std::size_t>(single - singles_.begin());
  }
  /// What a cause leaves alone of the samples that are fitted.
  [[nodiscard]] double leftBy(std::size_t single) const {
    return judge_.leftOfFitted(singles_[single].hypothesis, singles_[single].values);
  }
  [[nodiscard]] gap::Looks looks() const { return {judge_, singles_, progress_}; }
  [[nodiscard]] const std::string& nameOf(std::size_t single) const { return singles_[single].hypothesis.name; }

 private:
  model::Experiment measured_;
  gap::Replay replay_;
  gap::Split split_ = gap::splitOf(replay_, 1);
  gap::Judge judge_{replay_, split_, gap::yardstickOf(replay_, split_.held_out)};
  std::vector<gap::Candidate> singles_ = usualCauses(replay_);
  core::SilentProgress progress_;
};

}  // namespace test_support
