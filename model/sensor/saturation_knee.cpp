#include "model/sensor/saturation_knee.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace model {

double outputOf_w(double received_w, const Receiver& receiver) {
  if (!receiver.saturation_w || !receiver.knee_sharpness || received_w <= 0.0) return received_w;
  const double most_w = *receiver.saturation_w, n = *receiver.knee_sharpness;
  const double least = std::min(received_w, most_w), other = std::max(received_w, most_w);
  return std::isinf(n) ? least : least / std::pow(1.0 + std::pow(least / other, n), 1.0 / n);  // no ratio overflows
}

double receivedFor_w(double output_w, const Receiver& receiver) {
  if (!receiver.saturation_w || !receiver.knee_sharpness) return output_w;
  const double most_w = *receiver.saturation_w, n = *receiver.knee_sharpness;
  if (output_w >= most_w) return std::numeric_limits<double>::infinity();
  return std::isinf(n) ? output_w : output_w / std::pow(1.0 - std::pow(output_w / most_w, n), 1.0 / n);
}

}  // namespace model
