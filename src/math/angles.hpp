// Angles that are named in many places [rad].
#pragma once

namespace physim {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kRightAngle = kPi / 2;
inline constexpr double kDegree = kPi / 180;

}  // namespace physim
