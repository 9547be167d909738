#include "gap/candidates/signature_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "gap/causes/fit.h"
#include "gap/causes/scale.h"
#include "gap/causes/search.h"

namespace gap {

namespace {

constexpr int kMostLooks = 60;       // at a world
constexpr double kEnough = 1e-3;     // of the sum of squares: a search that gains less has ended
constexpr double kClose = 0.05;      // of the step: so has one whose steps are smaller
constexpr double kFirstTrust = 0.1;  // of the distance from the origin, which is between one and two a number

/// Far shifts count less, but never nothing: that would show no way back.
double asItCounts(double errors) { return SignatureSpace::kFar * std::asinh(errors / SignatureSpace::kFar); }

Eigen::VectorXd leftBy(const SignatureSpace& space, const World& world) {
  const Signature made = space.of(world);
  const Signature& wanted = space.ofMeasurement();
  Eigen::VectorXd left(static_cast<Eigen::Index>(made.size()));
  for (std::size_t i = 0; i < made.size(); ++i)
    left[static_cast<Eigen::Index>(i)] = asItCounts(static_cast<double>(wanted[i] - made[i]));
  return left;
}

/// What a world's shifts leave of those of the measurement, over the numbers that are searched, each in [0, 1]. All of
/// them are moved up by one: the library takes differences over steps in proportion to them.
struct Shifts {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const Replay& replay;
  const SignatureSpace& space;
  const Hypothesis& hypothesis;
  const core::Progress& progress;
  UnitCube cube;
  std::vector<double> start;          ///< of all numbers
  std::vector<std::size_t> searched;  ///< which of them

  [[nodiscard]] int inputs() const { return static_cast<int>(searched.size()); }
  [[nodiscard]] int values() const { return static_cast<int>(space.size()); }
  [[nodiscard]] Eigen::VectorXd first() const {
    Eigen::VectorXd moved(inputs());
    for (std::size_t i = 0; i < searched.size(); ++i) moved[static_cast<Eigen::Index>(i)] = 1.0 + start[searched[i]];
    return moved;
  }
  [[nodiscard]] std::vector<double> valuesAt(const Eigen::VectorXd& moved) const {
    std::vector<double> unit = start;
    for (std::size_t i = 0; i < searched.size(); ++i)
      unit[searched[i]] = std::clamp(moved[static_cast<Eigen::Index>(i)] - 1.0, 0.0, 1.0);
    return cube.valuesAt(unit);
  }
  int operator()(const Eigen::VectorXd& moved, Eigen::VectorXd& left) const {
    core::stopIfCancelled(progress);
    left = leftBy(space, worldOf(replay, hypothesis, valuesAt(moved)));
    return 0;
  }
};

/// Numbers that shift the data by degrees. The end of a sector does it beam by beam, a count by ones.
std::vector<std::size_t> gradualIn(const Hypothesis& hypothesis) {
  std::vector<std::size_t> gradual;
  for (std::size_t i = 0; i < hypothesis.parameters.size(); ++i)
    if (!jumps(hypothesis.parameters[i])) gradual.push_back(i);
  return gradual;
}

}  // namespace

std::vector<double> signatureFitFrom(const Replay& replay, const SignatureSpace& space, const Hypothesis& hypothesis,
                                     const std::vector<double>& start, const core::Progress& progress, double step) {
  const UnitCube cube(hypothesis.parameters);
  const Shifts shifts{replay, space, hypothesis, progress, cube, cube.unitOf(start), gradualIn(hypothesis)};
  if (shifts.inputs() == 0 || shifts.inputs() > shifts.values()) return start;
  Eigen::VectorXd at = shifts.first();
  Eigen::NumericalDiff<Shifts> differences(shifts, step * step);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Shifts>> search(differences);
  search.parameters.maxfev = kMostLooks;
  search.parameters.ftol = kEnough;
  search.parameters.xtol = kClose * step;
  search.parameters.factor = kFirstTrust;
  search.minimize(at);
  return shifts.valuesAt(at);
}

double shiftsLeftBy(const SignatureSpace& space, const World& world) { return leftBy(space, world).squaredNorm(); }

}  // namespace gap
