#pragma once

#include <numbers>

namespace core {

inline constexpr double kSpeedOfLight_m_s = 299'792'458.0;
inline constexpr double kMetresPerNanosecond = kSpeedOfLight_m_s * 1e-9;
inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;

}  // namespace core
