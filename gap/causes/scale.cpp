#include "gap/causes/scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gap {

Scale::Scale(const FreeParameter& p)
    : p_(p), fine_(0.01 * std::max(std::abs(p.high - p.absent_at), std::abs(p.low - p.absent_at))) {}

double Scale::toUnit(double value) const {
  value = std::clamp(value, p_.low, p_.high);
  return (bend(value) - bend(p_.low)) / (bend(p_.high) - bend(p_.low));
}

double Scale::toValue(double unit) const {
  const double bent = bend(p_.low) + std::clamp(unit, 0.0, 1.0) * (bend(p_.high) - bend(p_.low));
  const double value = std::clamp(unbend(bent), p_.low, p_.high);
  return p_.whole ? std::round(value) : value;
}

bool Scale::mayBeAbsent() const { return p_.low <= p_.absent_at && p_.high >= p_.absent_at && !p_.azimuth; }

double Scale::bend(double value) const {
  if (p_.logarithmic) return std::log(value);
  return mayBeAbsent() ? std::asinh((value - p_.absent_at) / fine_) : value;
}

double Scale::unbend(double bent) const {
  if (p_.logarithmic) return std::exp(bent);
  return mayBeAbsent() ? p_.absent_at + fine_ * std::sinh(bent) : bent;
}

bool atUpperEnd(const FreeParameter& p, double value) {
  constexpr double kNear = 0.005;
  const bool share = p.unit.empty() && p.low >= 0.0 && p.high == 1.0;
  if (p.azimuth || p.whole || share || p.high == p.absent_at) return false;
  return p.high - value <= kNear * (p.high - p.low);
}

UnitCube::UnitCube(std::vector<FreeParameter> parameters) : parameters_(std::move(parameters)) {
  for (const FreeParameter& parameter : parameters_) scales_.emplace_back(parameter);
}

std::vector<double> UnitCube::valuesAt(const std::vector<double>& unit) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < unit.size(); ++i) values.push_back(scales_[i].toValue(unit[i]));
  return inOrder(parameters_, std::move(values));
}

std::vector<double> UnitCube::unitOf(const std::vector<double>& values) const {
  std::vector<double> unit;
  for (std::size_t i = 0; i < values.size(); ++i) unit.push_back(scales_[i].toUnit(values[i]));
  return unit;
}

}  // namespace gap
