#include "prepare/profile_tables.hpp"

#include "base/assert.hpp"

namespace physim {
namespace {

template <template <class> class Row>
void narrow(const std::vector<Row<double>>& wide, std::vector<Row<float>>& rows) {
  rows.resize(wide.size());
  for (std::size_t i = 0; i < wide.size(); ++i) cast_members(wide[i], rows[i]);
}

}  // namespace

void ProfileTables::put_wind(std::span<const WindPoint> points) {
  wind_.clear();
  for (const WindPoint& p : points) {
    if (!wind_.empty()) {
      WindPiece<double>& below = wind_.back();
      PHYSIM_ASSERT(p.at > below.at);
      below.per_length = 1 / (p.at - below.at);
      below.slope = (p.velocity - Vec3d(below.velocity)) * below.per_length;
    }
    wind_.push_back({p.at, {p.velocity.x, p.velocity.y, p.velocity.z}, {0, 0, 0}, 0});
  }
  narrow(wind_, wind_float_);
}

}  // namespace physim
