#include "prepare/profile_tables.hpp"

#include "base/assert.hpp"

namespace physim {
namespace {

template <class Wide, class Narrow>
void narrow(const std::vector<Wide>& wide, std::vector<Narrow>& rows) {
  rows.resize(wide.size());
  for (std::size_t i = 0; i < wide.size(); ++i) cast_members(wide[i], rows[i]);
}

}  // namespace

PHYSIM_COLD void ProfileTables::put_wind(std::span<const WindPoint> points) {
  auto& wind = in_double_.wind;
  wind.clear();
  for (const WindPoint& p : points) {
    if (!wind.empty()) {
      WindPiece<double>& below = wind.back();
      PHYSIM_ASSERT(p.at > below.at);
      below.per_length = 1 / (p.at - below.at);
      below.slope = (p.velocity - Vec3d(below.velocity)) * below.per_length;
    }
    wind.push_back({p.at, {p.velocity.x, p.velocity.y, p.velocity.z}, {0, 0, 0}, 0});
  }
  narrow(wind, in_float_.wind);
}

PHYSIM_COLD void ProfileTables::put_air(const std::vector<AirLevel>& levels) {
  in_double_.air.clear(), in_double_.bases.clear();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    in_double_.air.push_back(layer_above(levels, i));
    in_double_.bases.push_back(levels[i].height);
  }
  PHYSIM_ASSERT(in_double_.air.size() == in_double_.bases.size());
  narrow(in_double_.air, in_float_.air);
  narrow(in_double_.bases, in_float_.bases);
}

}  // namespace physim
