#include "model/material/fresnel.h"

#include <algorithm>
#include <cmath>

namespace model {

namespace {

/// Cosine inside the glass, from Snell's law with the real part of the index.
double cosInside(double cos_incidence, ComplexIndex index) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cos_incidence * cos_incidence)) / index.real();
  return std::sqrt(std::max(0.0, 1.0 - sine * sine));
}

/// One way through the glass: longer when slanted.
double onWay(const Pane& pane, double cos_incidence) {
  const double inside = cosInside(cos_incidence, pane.index);
  if (pane.internal_transmittance >= 1.0) return 1.0;
  return inside > 0.0 ? std::pow(pane.internal_transmittance, 1.0 / inside) : 0.0;
}

/// Without absorption every number is real: C++ takes its time to divide complex ones.
Polarised dielectricReflectance(double c, double n) {
  const double inside = std::sqrt(1.0 - (1.0 - c * c) / (n * n));
  const double s = (c - n * inside) / (c + n * inside);
  const double p = (n * c - inside) / (n * c + inside);
  return {s * s, p * p};
}

double paneReflectance(double face, double way) {
  const double loops = 1.0 - face * face * way * way;
  return loops > 0.0 ? face + (1.0 - face) * (1.0 - face) * face * way * way / loops : 1.0;
}

double paneTransmittance(double face, double way) {
  const double loops = 1.0 - face * face * way * way;
  return loops > 0.0 ? (1.0 - face) * (1.0 - face) * way / loops : 0.0;
}

}  // namespace

Polarised fresnelReflectance(double cos_incidence, ComplexIndex index) {
  const double c = std::clamp(cos_incidence, 0.0, 1.0);
  if (index.imag() == 0.0 && index.real() >= 1.0) return dielectricReflectance(c, index.real());
  const ComplexIndex cos_inside = std::sqrt(1.0 - (1.0 - c * c) / (index * index));
  const ComplexIndex s = (c - index * cos_inside) / (c + index * cos_inside);
  const ComplexIndex p = (index * c - cos_inside) / (index * c + cos_inside);
  return {std::norm(s), std::norm(p)};
}

Pane Pane::ofTransmission(ComplexIndex index, double transmission) {
  const double face = fresnelReflectance(1.0, index).s;
  // T (1 - R² a²) = (1 - R)² a, solved for a; written so that R = 0 gives a = T.
  const double b = (1.0 - face) * (1.0 - face);
  const double root = std::sqrt(b * b + 4.0 * transmission * transmission * face * face);
  return {index, std::clamp(2.0 * transmission / (b + root), 0.0, 1.0)};
}

Polarised Pane::reflectance(double cos_incidence) const {
  const Polarised face = fresnelReflectance(cos_incidence, index);
  const double way = onWay(*this, cos_incidence);
  return {paneReflectance(face.s, way), paneReflectance(face.p, way)};
}

Polarised Pane::transmittance(double cos_incidence) const {
  const Polarised face = fresnelReflectance(cos_incidence, index);
  const double way = onWay(*this, cos_incidence);
  return {paneTransmittance(face.s, way), paneTransmittance(face.p, way)};
}

double diffuseFresnelReflectance(ComplexIndex index) {
  // Simpson's rule over u = sin² θ, because sin 2θ dθ = du. The steep end (grazing) gets small steps by u = 1 - v².
  constexpr int kSteps = 2000;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double v = static_cast<double>(i) / kSteps;  // cos θ
    const double weight = i == 0 || i == kSteps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * fresnelReflectance(v, index).unpolarised() * 2.0 * v;
  }
  return sum / (3.0 * kSteps);
}

}  // namespace model
