#pragma once

#include <string>
#include <vector>

namespace app {

/// One curve of a file: a run, a repetition.
struct Curve {
  std::string name;  ///< of the repetition; "" if the file holds one curve
  std::vector<double> parameter;
  std::vector<double> values;
  std::vector<int> lines;  ///< of each point in the file
};

/// All curves of a file, over the same parameters.
struct Curves {
  std::string file;
  std::vector<Curve> curves;

  [[nodiscard]] const std::vector<double>& parameter() const { return curves.front().parameter; }
  [[nodiscard]] std::vector<std::vector<double>> values() const;
};

/// What the columns are called.
struct CurveColumns {
  std::string over;
  std::string value;
  std::string repetition;  ///< "": one curve a file; a file without this column holds one curve, too
};

struct CurvePair {
  Curves real;
  Curves simulated;
};

/// Reads both files; points may come in any order. Throws InputError with file and line for a parameter that a curve
/// has twice, and where a curve has a parameter that another has not.
[[nodiscard]] CurvePair readCurves(const std::string& real, const std::string& simulated, const CurveColumns& columns);

}  // namespace app
