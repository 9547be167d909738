#pragma once

#include <optional>
#include <vector>

namespace gap {

/// What is lost of the echoes that have a value of some covariate, less what is there.
struct LossAt {
  double value;
  double lost_less_there;
};

/// The value that parts best what is lost, in the begin of the list, from what is there: halfway between two of them,
/// or the last. Nothing if no part from the begin on has lost more than is there.
[[nodiscard]] std::optional<double> endOfLoss(const std::vector<LossAt>& in_order);

}  // namespace gap
