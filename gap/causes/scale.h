#pragma once

#include <vector>

#include "gap/causes/hypotheses.h"

namespace gap {

/// Maps a parameter to [0, 1]: logarithmic, linear, or (where the value at which an effect is absent lies inside or at
/// an end of the range) fine around that.
class Scale {
 public:
  explicit Scale(const FreeParameter& parameter);

  [[nodiscard]] double toUnit(double value) const;
  [[nodiscard]] double toValue(double unit) const;

 private:
  [[nodiscard]] bool mayBeAbsent() const;
  [[nodiscard]] double bend(double value) const;
  [[nodiscard]] double unbend(double bent) const;

  FreeParameter p_;
  double fine_;  ///< distance from where it is absent up to which steps are even
};

/// Whether a value lies at the upper end of a parameter's range (within 0.005 of it), beyond which there may be more:
/// not that of a share, of a count or of a sector, and not where the cause does nothing.
[[nodiscard]] bool atUpperEnd(const FreeParameter& parameter, double value);

/// All free numbers of a hypothesis, each mapped to [0, 1].
class UnitCube {
 public:
  explicit UnitCube(std::vector<FreeParameter> parameters);

  /// The ends of a sector in order.
  [[nodiscard]] std::vector<double> valuesAt(const std::vector<double>& unit) const;
  [[nodiscard]] std::vector<double> unitOf(const std::vector<double>& values) const;

 private:
  std::vector<FreeParameter> parameters_;
  std::vector<Scale> scales_;
};

}  // namespace gap
