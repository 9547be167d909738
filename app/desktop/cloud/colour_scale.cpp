#include "app/desktop/cloud/colour_scale.h"

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace desktop {

QColor rampColour(double share) {
  static constexpr std::array<std::array<double, 3>, 5> kStops{
      {{88, 104, 214}, {58, 152, 214}, {52, 190, 164}, {150, 216, 84}, {253, 231, 55}}};
  const double place = std::clamp(share, 0.0, 1.0) * double(kStops.size() - 1);
  const std::size_t below = std::min(std::size_t(place), kStops.size() - 2);
  const double part = place - double(below);
  const auto channel = [&](std::size_t k) {
    return int(std::lround(kStops[below][k] + part * (kStops[below + 1][k] - kStops[below][k])));
  };
  return {channel(0), channel(1), channel(2)};
}

QColor differenceColour(double share) {
  constexpr std::array<double, 3> kBelow{64, 132, 255};
  constexpr std::array<double, 3> kZero{200, 204, 210};
  constexpr std::array<double, 3> kAbove{255, 140, 20};
  const double part = std::clamp(std::abs(share), 0.0, 1.0);
  const auto& end = share < 0 ? kBelow : kAbove;
  const auto channel = [&](std::size_t k) { return int(std::lround(kZero[k] + part * (end[k] - kZero[k]))); };
  return {channel(0), channel(1), channel(2)};
}

QColor ColourScale::at(double share) const {
  return by == ColourBy::Difference ? differenceColour(2.0 * share - 1.0) : rampColour(share);
}

QRgb ColourScale::operator()(double value) const {
  static const QRgb kNothing = QColor(0x5c, 0x63, 0x6e).rgb();
  return std::isnan(value) ? kNothing : at(shareOf(value)).rgb();
}

double ColourScale::shareOf(double value) const noexcept {
  if (!(high > low)) return 0.5;
  if (!logarithmic) return (value - low) / (high - low);
  return std::log(std::max(value, low) / low) / std::log(high / low);
}

double roundStep(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= value * (1.0 - 1e-9)) return factor * decade;
  }
  return 10.0 * decade;
}

std::vector<double> ColourScale::ticks() const {
  std::vector<double> ticks;
  if (!(high > low)) return {low};
  if (logarithmic) {
    for (double decade = std::pow(10.0, std::floor(std::log10(low))); decade <= high; decade *= 10.0) {
      if (decade >= low) ticks.push_back(decade);
    }
    if (ticks.size() >= 2) return ticks;
    return {low, high};
  }
  const bool whole = by == ColourBy::Layer || by == ColourBy::Echo;
  const double step = std::max(whole ? 1.0 : 0.0, roundStep((high - low) / 5.0));
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push_back(k * step);
  return ticks;
}

namespace {

ColourScale differenceScale(std::span<const std::vector<double>> values) {
  std::vector<double> sizes;
  for (const std::vector<double>& list : values) {
    for (const double value : list) {
      if (!std::isnan(value)) sizes.push_back(std::abs(value));
    }
  }
  if (sizes.empty()) return {.by = ColourBy::Difference};
  const auto most = sizes.begin() + std::ptrdiff_t(0.98 * double(sizes.size() - 1));
  std::nth_element(sizes.begin(), most, sizes.end());
  const double high = std::max(*most, 1e-3);  // a millimetre: less is rounding
  return {.by = ColourBy::Difference, .low = -high, .high = high, .known = true};
}

}  // namespace

ColourScale scaleFor(ColourBy by, std::span<const std::vector<double>> values) {
  if (by == ColourBy::Difference) return differenceScale(values);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::vector<double>& list : values) {
    for (const double value : list) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(low <= high)) return {.by = by};
  return {.by = by,
          .low = low,
          .high = high,
          .logarithmic = by == ColourBy::Intensity && low > 0 && high > 30 * low,
          .known = true};
}

QString wordFor(ColourBy by) {
  switch (by) {
    case ColourBy::Source:
      return QObject::tr("Source");
    case ColourBy::Range:
      return QObject::tr("Range");
    case ColourBy::Intensity:
      return QObject::tr("Intensity");
    case ColourBy::EchoPulseWidth:
      return QObject::tr("Echo pulse width");
    case ColourBy::Layer:
      return QObject::tr("Layer");
    case ColourBy::Echo:
      return QObject::tr("Echo");
    case ColourBy::Difference:
      return QObject::tr("Range difference");
  }
  return {};
}

QString titleOf(ColourBy by) {
  switch (by) {
    case ColourBy::Range:
    case ColourBy::EchoPulseWidth:
      return wordFor(by) + " [m]";
    case ColourBy::Intensity:
      return wordFor(by) + " [nW]";
    case ColourBy::Difference:
      return QObject::tr("Sim. − meas. [m]");
    default:
      return wordFor(by);
  }
}

}  // namespace desktop
