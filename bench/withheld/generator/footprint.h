#pragma once

#include "bench/withheld/generator/dice.h"
#include "bench/withheld/generator/profile.h"

namespace withheld {

/// Angular offset of a sub-ray from its beam's axis, in the beam's own left/up plane. [rad]
struct Offset {
  double left_rad, up_rad;
};

/// Sub-rays of equal weight over a beam's cross-section, as many as one asks for: Halton's points of bases 2 and 3
/// (Halton 1960, Numer. Math. 2, 84), turned at random for each beam (Cranley & Patterson 1976, doi:10.1137/0713071). A
/// Gaussian beam, exp(-2(x²/a² + y²/b²)) over ±1.5 a by ±1.5 b, is met by inverting its distribution, not by weights.
class Footprint {
 public:
  Footprint(const Profile& profile, Dice dice) : profile_(profile), turn_u_(dice.uniform()), turn_v_(dice.uniform()) {}

  [[nodiscard]] Offset at(int index) const;
  /// One of four corners, to see whether the beam is hit evenly.
  [[nodiscard]] Offset corner(int index) const;

 private:
  const Profile& profile_;
  double turn_u_, turn_v_;
};

}  // namespace withheld
