#include "world/core/fields.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "base/assert.hpp"
#include "model/attitude.hpp"

namespace physim {
namespace {

/// Numbers of a Body that follow from the kind and the rung. Among them are all that name a place in a table.
constexpr auto kOfKind = [] {
  std::array<bool, kNumbers<Body>> of_kind{};
  const NumberRuns parts =
      PartSet::of<DampingPart, AreaPart, CurvePart, SpherePart, BandPart, AppliedPart, MotorPart>().runs();
  for (unsigned k = 0; k < parts.count; ++k)
    for (unsigned i = parts.run[k].first; i < parts.run[k].end; ++i) of_kind[i] = true;
  for (unsigned i = kBodyNumber.spin_decay; i <= kBodyNumber.magnus_table; ++i) of_kind[i] = true;
  return of_kind;
}();

}  // namespace

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
  std::ranges::copy_if(layout.fields, std::back_inserter(layout.own), [](std::uint8_t i) { return !kOfKind[i]; });
  if (features.has_force_end) layout.own.push_back(std::uint8_t(kBodyNumber.applied_until));
  layout.burning = std::ranges::find(layout.fields, kBodyNumber.burn_piece) != layout.fields.end();
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
