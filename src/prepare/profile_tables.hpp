// The profiles of an environment as tables, in both precisions, of any length: conditions point to them.
#pragma once

#include <span>
#include <vector>

#include "model/conditions.hpp"

namespace physim {

/// Must outlive the conditions that point to it, and may be moved.
class ProfileTables {
 public:
  void put_wind(std::span<const WindPoint> points);

  void point(Conditions<double>& conditions) const { conditions.wind_pieces = wind_.data(); }
  void point(Conditions<float>& conditions) const { conditions.wind_pieces = wind_float_.data(); }

 private:
  std::vector<WindPiece<double>> wind_;
  std::vector<WindPiece<float>> wind_float_;
};

}  // namespace physim
