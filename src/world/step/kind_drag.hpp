// The drag equation of every kind towards air of any density, whatever rung the kind flies on: for zones of wind.
#pragma once

#include <cstdint>
#include <vector>

#include "model/body.hpp"
#include "model/table_pool.hpp"

namespace physim {

/// Cd is taken by the Mach number in air of 15 degrees Celsius (a zone has no temperature), with the
/// projectile's table, area, form factor, ballistic coefficient or bands: the model is that of every flight.
class KindDrag {
 public:
  KindDrag();
  // The conditions point into the pool: it may move, but not be copied.
  KindDrag(KindDrag&&) noexcept = default;
  KindDrag& operator=(KindDrag&&) noexcept = default;

  /// Adds a projectile; its index.
  std::uint32_t add(const ProjectileDef& projectile);
  /// On a projectile of a mass, at a velocity u through air of a density [N].
  [[nodiscard]] Vec3d force(std::uint32_t index, double mass, double density, const Vec3d& u) const;

 private:
  TablePool pool_;
  Conditions<double> conditions_;
  std::vector<Body<double>> bodies_;
};

}  // namespace physim
