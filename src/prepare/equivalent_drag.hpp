// The quadratic drag that stands in where k1 and k2 are asked for and not given.
#pragma once

#include <memory>

#include "model/body.hpp"
#include "model/conditions.hpp"
#include "model/table_pool.hpp"
#include "prepare/profile_tables.hpp"

namespace physim {

/// The quadratic drag that equals the drag equation where a projectile is: its wind, bands, air and curve included.
class EquivalentDrag {
 public:
  /// Its curve goes into `pool`, which several may share. It keeps the profiles that the conditions point to, or the
  /// caller does.
  EquivalentDrag(const ProjectileDef& projectile, const Body<double>& body, const Conditions<double>& conditions,
                 std::shared_ptr<TablePool> pool = std::make_shared<TablePool>(), ProfileTables profiles = {});
  /// At a launch, at a time of the world where it is in one [1/m].
  [[nodiscard]] double k2_per_mass(const State<double>& s, double birth = 0);

 private:
  Body<double> body_;
  ProfileTables profiles_;
  Conditions<double> conditions_;
  std::shared_ptr<TablePool> pool_;
};

}  // namespace physim
