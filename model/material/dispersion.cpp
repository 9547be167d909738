#include "model/material/dispersion.h"

#include <cmath>

namespace model {

namespace {

/// C1, C2, … with zeros behind the last one given.
class Coefficients {
 public:
  explicit Coefficients(const std::vector<double>& values) : values_(values) {}
  double operator()(std::size_t number) const { return number <= values_.size() ? values_[number - 1] : 0.0; }
  [[nodiscard]] std::size_t count() const { return values_.size(); }

 private:
  const std::vector<double>& values_;
};

/// Σ term(C_i, C_{i+1}) over the pairs from C_first on. Terms with C_i = 0 are absent, whatever their partner.
template <typename Term>
double sumOfPairs(const Coefficients& c, std::size_t first, Term term) {
  double sum = 0.0;
  for (std::size_t i = first; i <= c.count(); i += 2) {
    if (c(i) != 0.0) sum += term(c(i), c(i + 1));
  }
  return sum;
}

double powers(const Coefficients& c, std::size_t first, double um) {
  return sumOfPairs(c, first, [um](double a, double b) { return a * std::pow(um, b); });
}

double resonance(const Coefficients& c, std::size_t first, double um) {
  if (c(first) == 0.0) return 0.0;
  return c(first) * std::pow(um, c(first + 1)) / (um * um - std::pow(c(first + 2), c(first + 3)));
}

double herzberger(const Coefficients& c, double um) {
  const double square = um * um, l = 1.0 / (square - 0.028);
  return c(1) + c(2) * l + c(3) * l * l + square * (c(4) + square * (c(5) + square * c(6)));
}

double retro(const Coefficients& c, double um) {
  const double square = um * um, ratio = c(1) + c(2) * square / (square - c(3)) + c(4) * square;
  return std::sqrt((1.0 + 2.0 * ratio) / (1.0 - ratio));
}

double exotic(const Coefficients& c, double um) {
  const double away = um - c(5);
  return std::sqrt(c(1) + c(2) / (um * um - c(3)) + c(4) * away / (away * away + c(6)));
}

}  // namespace

std::size_t Dispersion::largestCount(int formula) {
  switch (formula) {
    case 5:
    case 6:
      return 11;
    case 7:
    case 9:
      return 6;
    case 8:
      return 4;
    default:
      return 17;
  }
}

double Dispersion::at(double wavelength_um) const {
  const Coefficients c(coefficients);
  const double um = wavelength_um, square = um * um;
  switch (formula) {
    case 1:
      return std::sqrt(1.0 + c(1) +
                       sumOfPairs(c, 2, [&](double a, double b) { return a * square / (square - b * b); }));
    case 2:
      return std::sqrt(1.0 + c(1) + sumOfPairs(c, 2, [&](double a, double b) { return a * square / (square - b); }));
    case 3:
      return std::sqrt(c(1) + powers(c, 2, um));
    case 4:
      return std::sqrt(c(1) + resonance(c, 2, um) + resonance(c, 6, um) + powers(c, 10, um));
    case 5:
      return c(1) + powers(c, 2, um);
    case 6:
      return 1.0 + c(1) + sumOfPairs(c, 2, [&](double a, double b) { return a / (b - 1.0 / square); });
    case 7:
      return herzberger(c, um);
    case 8:
      return retro(c, um);
    case 9:
      return exotic(c, um);
    default:
      return std::nan("");
  }
}

}  // namespace model
