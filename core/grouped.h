#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// Places of a list by the group that each belongs to, in the order of the list.
class Grouped {
 public:
  /// `group_of` [place]: below `groups`.
  Grouped(std::span<const std::size_t> group_of, std::size_t groups) : first_(groups + 1, 0), places_(group_of.size()) {
    for (const std::size_t group : group_of) ++first_[group + 1];
    for (std::size_t g = 0; g < groups; ++g) first_[g + 1] += first_[g];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < group_of.size(); ++i) places_[next[group_of[i]]++] = static_cast<std::uint32_t>(i);
  }

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t group) const {
    return std::span(places_).subspan(first_[group], first_[group + 1] - first_[group]);
  }

 private:
  std::vector<std::size_t> first_;  ///< those of group g are places_[first_[g] … first_[g + 1])
  std::vector<std::uint32_t> places_;
};

}  // namespace core
