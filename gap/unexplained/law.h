#pragma once

#include <string>
#include <vector>

namespace gap {

/// How a residual depends on covariates: the shortest sum of simple functions that predicts it on samples that it was
/// not fitted to.
struct Law {
  struct Term {
    std::string covariate;
    std::string function;  ///< of x: "x", "x²", "1/x", "ln x", "tan² x", "sin x"
    double coefficient = 0.0;
    double period = 0.0;  ///< of "sin x", in the covariate's unit: sin(2π (x - zero)/period)
    double zero = 0.0;    ///< of "sin x": where it is zero and rises
  };
  std::string measurand;
  std::string component;  ///< "bias" or "scatter"
  std::string unit;
  double constant = 0.0;
  std::vector<Term> terms;
  double explained = 0.0;  ///< of the squared residuals beyond noise, on held-out cells
  bool relative = false;   ///< in parts of the received power, and of no unit
};

}  // namespace gap
