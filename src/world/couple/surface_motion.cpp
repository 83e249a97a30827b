#include "world/couple/surface_motion.hpp"

#include <utility>

#include "base/restored.hpp"
#include "collide/scene_contact.hpp"
#include "flight/step_parts.hpp"
#include "model/constraint.hpp"
#include "world/couple/world_impl.hpp"
#include "world/step/ground_contact.hpp"

namespace physim {
namespace {

/// A projectile between steps, as contacts see it in a step that only looks: nothing of it is kept.
class SeenRow final : public ContactHost {
 public:
  SeenRow(const WorldImpl& world, const Slot& slot, const Body<double>& body, const FreeAcceleration& free,
          double length)
      : w_(world),
        slot_(slot),
        kind_(world.registry.kind(slot.kind)),
        cohort_(world.registry.cohort(slot.cohort)),
        body_(body),
        free_(free),
        length_(length) {}

  /// The change of its velocity over the step, if a contact lasts through all of it.
  [[nodiscard]] std::optional<Vec3d> change() {
    const BodyState now = w_.state.state_of(slot_);
    const State<double> s{now.position, now.velocity};
    const auto v = velocity_after(s);
    if (!v || has_told_) return std::nullopt;
    return *v - s.v;
  }

  /// It lies on something when the step begins; known behind change().
  [[nodiscard]] bool lies() const { return lies_; }

  [[nodiscard]] const Conditions<double>& conditions() const { return cohort_.conditions; }
  [[nodiscard]] const Scene* scene() const override { return cohort_.key.meets ? w_.state.scene.get() : nullptr; }
  [[nodiscard]] Precision precision() const override { return cohort_.key.fidelity.precision; }
  [[nodiscard]] const CollisionDef& collision() const override { return kind_.body.collision; }
  [[nodiscard]] OwnSurface surface() const override { return OwnSurface::of(kind_.body); }
  [[nodiscard]] Vec3d turns() const override { return w_.state.extras.turns(index(), kind_.body.frozen_rotation); }
  [[nodiscard]] double scene_time() const override { return w_.state.clock.time(); }
  [[nodiscard]] double step_length() const override { return length_; }
  [[nodiscard]] Vec3d spin(double) const override {
    return spin_ ? *spin_ : ProjectileView(&w_, w_.state.slots.id_of(index())).angular_velocity();
  }
  void put_spin(const Vec3d& spin, double) override { spin_ = spin; }
  [[nodiscard]] Vec3d acceleration_at(const State<double>& s, double) const override { return free_(s); }
  [[nodiscard]] Vec3d kept(const Vec3d& v) const override { return constrained(cohort_.conditions, body_, v); }
  [[nodiscard]] Impact impact(int) const override { return {.mass = kind_.flown.mass}; }
  void tell(EventKind, Reason, double, const State<double>&, const SceneHit& = {}, double = 0, double = 0) override {
    has_told_ = true;
  }

 private:
  [[nodiscard]] std::uint32_t index() const { return w_.state.slots.index_of(slot_); }
  [[nodiscard]] std::optional<Vec3d> velocity_after(const State<double>& s) {
    StepParts parts(length_, false);
    GroundContacts<SeenRow> ground(*this, w_.def.ground, parts);
    if (ground.is_met_at_start(s)) {
      if (w_.def.ground.mode != GroundMode::bounce) return std::nullopt;
      lies_ = true;
      const auto after = ground.struck(s, ground.up_at(s.x), 0);
      using Then = GroundContacts<SeenRow>::Then;
      return after.then == Then::rolls ? std::optional(after.rolled.v) : std::nullopt;
    }
    SceneContacts things(*this);
    const auto on = things ? things.lies_on(s, 0) : std::nullopt;
    if (!on) return std::nullopt;
    lies_ = true;
    const SceneContacts::After after = things.goes_along(s, *on, 0);
    return after.then == SceneContacts::Then::lies ? std::optional(after.state.v) : std::nullopt;
  }

  const WorldImpl& w_;
  const Slot& slot_;
  const Kind& kind_;
  const WorldCohort& cohort_;
  const Body<double>& body_;
  const FreeAcceleration& free_;
  double length_;
  std::optional<Vec3d> spin_;
  bool has_told_ = false;
  bool lies_ = false;
};

}  // namespace

FreeMotion::FreeMotion(const WorldImpl& world, const Slot& slot)
    : conditions_(world.registry.cohort(slot.cohort).conditions),
      clock_(world.placement.clock_of(slot)),
      body_(world.placement.body_of(slot)) {
  const CohortKey& key = world.registry.cohort(slot.cohort).key;
  const std::uint32_t index = world.state.slots.index_of(slot);
  const Rows& rows = world.state.rows_of(slot);
  if (rows.layout().turning) rotor_ = rows.rotor(slot.row), turn_ = rows.turn(slot.row);
  if (!key.forced) return;
  const double inverse_mass = 1 / mass_of(world.registry, world.state, slot);
  const Vec3d force = world.generator_force(index, world.state.state_of(slot));
  add_push(conditions_, {clock_, clock_}, clock_, force * inverse_mass + world.emitter_push(index),
           key.features.has_applied, body_);
}
Accelerations FreeMotion::operator()(const State<double>& s) const {
  return accelerations_of(conditions_, body_, rotor_, clock_, s, turn_);
}

std::optional<Vec3d> acceleration_on_surface(const WorldImpl& world, const Slot& slot, const Body<double>& body,
                                             const FreeAcceleration& free) {
  const Restored<const Gate*> asking(Gate::in_question, &world);  // an engine may be asked
  // What velocities are rounded to counts less over a longer time; what comes to a wall in it takes a shorter one.
  const bool is_float32 = world.registry.cohort(slot.cohort).key.fidelity.precision == Precision::float32;
  for (const double length : {is_float32 ? 1e-2 : 1e-4, 1e-4, 1e-7}) {
    SeenRow row(world, slot, body, free, length);
    if (const auto change = row.change()) return *change * (1 / length);
    if (!row.lies()) break;
  }
  return std::nullopt;
}

}  // namespace physim
