#include "world/fields.hpp"

namespace physim {
namespace {

class FieldList {
 public:
  template <class Member>
  void add(Member Body<double>::*member) {
    for (unsigned part = 0; part < sizeof(Member) / sizeof(double); ++part) list_.push_back(body_field(member, part));
  }
  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(list_); }

 private:
  std::vector<std::uint8_t> list_;
};

void add_drag_fields(DragModel drag, const Features& features, FieldList& list) {
  if (drag == DragModel::damping) list.add(&Body<double>::damping_rate);
  if (drag == DragModel::linear_quadratic) {
    list.add(&Body<double>::k1_per_mass);
    list.add(&Body<double>::k2_per_mass);
  }
  if (drag != DragModel::equation) return;
  list.add(&Body<double>::half_area_per_mass);
  list.add(&Body<double>::curve_row);
  list.add(&Body<double>::curve_start);
  list.add(&Body<double>::curve_cells);
  list.add(&Body<double>::curve_last);
  if (features.spheres) list.add(&Body<double>::reynolds_length);
  if (features.bands) {
    list.add(&Body<double>::band_above);
    list.add(&Body<double>::band_half_area_per_mass);
  }
}

}  // namespace

RowLayout layout_of(const Fidelity& granted, const Features& features) {
  const bool closed = granted.motion == Motion::closed_form;
  FieldList list;
  if (closed || granted.original_one_shot_forces) list.add(&Body<double>::launch);
  if (closed && granted.drag != DragModel::off)
    list.add(&Body<double>::damping_rate);
  else
    add_drag_fields(granted.drag, features, list);
  if (features.applied) {
    list.add(&Body<double>::applied);
    list.add(&Body<double>::applied_until);
  }
  const bool spinning = granted.rotation == RotationModel::magnus;
  if (spinning) {
    list.add(&Body<double>::spin);
    list.add(&Body<double>::spin_decay);
    list.add(&Body<double>::ball_radius);
    list.add(&Body<double>::magnus_area);
    list.add(&Body<double>::lift);
    list.add(&Body<double>::lift_base);
    list.add(&Body<double>::lift_saturation);
    list.add(&Body<double>::drag_per_spin);
    list.add(&Body<double>::magnus_table);
  }
  if (features.motor || features.rail) {
    list.add(&Body<double>::burn);
    list.add(&Body<double>::burn_piece);
    list.add(&Body<double>::mass);
    list.add(&Body<double>::ignition);
    list.add(&Body<double>::burnout);
    list.add(&Body<double>::rail);
    list.add(&Body<double>::rail_end);
    list.add(&Body<double>::rail_phase);
  }
  if (granted.planar) list.add(&Body<double>::plane);
  if (features.gravity_scale) list.add(&Body<double>::gravity_scale);
  if (features.frozen) list.add(&Body<double>::free);
  RowLayout layout;
  layout.float32 = granted.precision == Precision::float32;
  layout.clocked = closed || features.applied || features.motor || features.rail || spinning;
  layout.carried = !closed && granted.integrator == Integrator::classic;
  layout.launched = features.launch_place;
  layout.turning = turns(granted);
  layout.fields = list.take();
  return layout;
}

}  // namespace physim
