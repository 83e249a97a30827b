// SUVAT: motion in a straight line under constant acceleration. Three of its five quantities give the other two.
#pragma once

#include <optional>
#include <vector>

#include "physim/result.hpp"

namespace physim {

/// All five quantities of one motion: v = u + a t, s = u t + a t^2 / 2. Each may have either sign.
struct Suvat {
  double s = 0;  ///< displacement from the start, between 0 and t [m]
  double u = 0;  ///< velocity at time 0 [m/s]
  double v = 0;  ///< velocity at time t [m/s]
  double a = 0;  ///< acceleration, constant [m/s^2]
  double t = 0;  ///< time since the start; negative: before it [s]
};

/// The quantities that are known: exactly three. Each is 0, or its size lies between 1e-50 and 1e50.
struct SuvatGiven {
  std::optional<double> s{};  ///< as Suvat::s [m]
  std::optional<double> u{};  ///< as Suvat::u [m/s]
  std::optional<double> v{};  ///< as Suvat::v [m/s]
  std::optional<double> a{};  ///< as Suvat::a [m/s^2]
  std::optional<double> t{};  ///< as Suvat::t [s]
};

/// Returns every motion that has the given quantities, by rising time: one, or two where s and a are given with one of
/// the velocities, as a ball thrown upwards passes a height twice. An error if no motion has them, if any number of
/// motions has, or if there are not three.
[[nodiscard]] Result<std::vector<Suvat>> suvat(const SuvatGiven& given);

}  // namespace physim
