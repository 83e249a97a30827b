// The profiles of an environment as tables, in both precisions, of any length: conditions point to them.
#pragma once

#include <span>
#include <vector>

#include "model/air_levels.hpp"

namespace physim {

/// Must outlive the conditions that point to it, and may be moved.
class ProfileTables {
 public:
  void put_wind(std::span<const WindPoint> points);
  void put_air(const std::vector<AirLevel>& levels);

  void point(Conditions<double>& conditions) const { point(in_double_, conditions); }
  void point(Conditions<float>& conditions) const { point(in_float_, conditions); }

 private:
  template <class S>
  struct Tables {
    std::vector<WindPiece<S>> wind;
    std::vector<AirLayer<S>> air;
    std::vector<S> bases;  // of the air's layers
  };
  template <class S>
  static void point(const Tables<S>& tables, Conditions<S>& conditions) {
    conditions.wind_pieces = tables.wind.data();
    conditions.air_layers = tables.air.data();
    conditions.air_bases = tables.bases.data();
  }

  Tables<double> in_double_;
  Tables<float> in_float_;
};

}  // namespace physim
