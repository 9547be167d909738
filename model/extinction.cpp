#include "model/extinction.h"

#include <cmath>

namespace model {

namespace {

constexpr double kReferenceWavelength_nm = 550.0;

double kimExponent(double visibility_km) {
  if (visibility_km > 50.0) return 1.6;
  if (visibility_km > 6.0) return 1.3;
  if (visibility_km > 1.0) return 0.16 * visibility_km + 0.34;
  if (visibility_km > 0.5) return visibility_km - 0.5;
  return 0.0;
}

}  // namespace

double extinctionFromVisibility(double visibility_m, double wavelength_nm) {
  return 3.912 / visibility_m * std::pow(wavelength_nm / kReferenceWavelength_nm, -kimExponent(visibility_m / 1000.0));
}

double extinctionFromRain(double rain_rate_mm_h) {
  constexpr double kNeperPerDecibel = 0.23025850929940457;  // ln(10)/10, of power
  return 1.076 * std::pow(rain_rate_mm_h, 0.67) * kNeperPerDecibel / 1000.0;
}

}  // namespace model
