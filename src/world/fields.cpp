#include "world/fields.hpp"

#include "base/assert.hpp"
#include "model/attitude.hpp"

namespace physim {

RowLayout layout_of(const Fidelity& granted, const Features& features, bool launch_place, bool meets) {
  const PartSet read = parts_read(granted, features);
  RowLayout layout;
  const auto add = [&](PartSet parts) {
    parts.runs().each([&](unsigned i) { layout.fields.push_back(std::uint8_t(i)); });
  };
  // The plane has stood behind the rail from the start: hashes of worlds take the columns in this order.
  constexpr PartSet kPlane = PartSet::of<PlanePart>();
  constexpr PartSet kBehind = PartSet::of<GravityPart, FreePart>();
  add(read - kPlane - kBehind);
  add(read & kPlane);
  add(read & kBehind);
  PHYSIM_ASSERT(layout.fields.size() == read.runs().numbers());
  const bool closed = granted.motion == Motion::closed_form;
  layout.float32 = granted.precision == Precision::float32;
  layout.clocked = closed || features.has_applied || features.has_motor || features.has_rail ||
                   features.has_wind_function || features.has_force_function ||
                   granted.rotation == RotationModel::magnus;
  layout.carried = is_classic(granted);
  layout.launched = launch_place;
  layout.turning = turns(granted);
  layout.meeting = meets;
  return layout;
}

}  // namespace physim
