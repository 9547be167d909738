#include "gap/where/end_of_loss.h"

namespace gap {

std::optional<double> endOfLoss(const std::vector<LossAt>& in_order) {
  double sum = 0.0, most = 0.0;
  std::optional<double> end;
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    sum += in_order[i].lost_less_there;
    if (sum <= most) continue;
    most = sum;
    const double next = in_order[i + 1 < in_order.size() ? i + 1 : i].value;
    end = 0.5 * (in_order[i].value + next);
  }
  return end;
}

}  // namespace gap
