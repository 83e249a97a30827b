// The quadratic drag that stands in where k1 and k2 are asked for and not given.
#pragma once

#include "model/body.hpp"
#include "model/conditions.hpp"
#include "model/table_pool.hpp"

namespace physim {

/// The quadratic drag that equals the drag equation where a projectile is: its wind, bands, air and curve included.
class EquivalentDrag {
 public:
  EquivalentDrag(const ProjectileDef& projectile, const Body<double>& body, const Conditions<double>& conditions);
  [[nodiscard]] double k2_per_mass(const State<double>& s);  // [1/m]

 private:
  Body<double> body_;
  Conditions<double> conditions_;
  TablePool pool_;
};

}  // namespace physim
