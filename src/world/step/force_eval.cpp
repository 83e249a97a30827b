// One function per law; the law is the same for a whole batch, so it is chosen once.
#include "world/step/force_eval.hpp"

#include "base/assert.hpp"
#include "model/force_laws.hpp"

namespace physim {
namespace {

using Members = std::span<const std::uint32_t>;

/// Rows without a gap need no gathering.
bool side_by_side(Members members) {
  for (std::size_t i = 1; i < members.size(); ++i)
    if (members[i] != members[0] + i) return false;
  return true;
}

/// The members' values of a column: in place, or gathered into the scratch.
template <class T>
std::span<const T> gather(std::span<const T> column, Members members, bool in_place, std::vector<T>& scratch) {
  PHYSIM_ASSERT(!members.empty() && members.back() < column.size());
  if (in_place) return column.subspan(members[0], members.size());
  scratch.clear();
  for (const std::uint32_t row : members) scratch.push_back(column[row]);
  return scratch;
}

/// A projectile of the stage, as laws see it.
struct Member {
  const ForceStage& stage;
  std::uint32_t row;

  [[nodiscard]] const Vec3d& position() const { return stage.position[row]; }
  [[nodiscard]] const Vec3d& velocity() const { return stage.velocity[row]; }
  [[nodiscard]] double mass() const { return stage.mass[row]; }
  [[nodiscard]] double diameter() const { return stage.def[row]->diameter; }
};

class Evaluation {
 public:
  Evaluation(const ForceClock& clock, Members members, const Surroundings& surroundings, ForceStage& stage,
             ForceScratch& scratch)
      : clock_(clock), members_(members), surroundings_(surroundings), stage_(stage), scratch_(scratch) {}

  /// Laws that one projectile alone decides.
  template <class Law>
  bool operator()(const Law& law) const {
    return each([&](std::uint32_t row) {
      const Member member{stage_, row};
      if constexpr (requires { drag_rate_on(law, member); }) stage_.drag_rate[row] += drag_rate_on(law, member);
      return force_on(law, member);
    });
  }
  bool operator()(const Spring& law) const {
    return between(law.other, [&](const Vec3d& d, const Vec3d& v_rel) { return spring_force(law, d, v_rel); });
  }
  bool operator()(const Bungee& law) const {
    if (law.other)
      return between(law.other, [&](const Vec3d& d, const Vec3d& v_rel) { return bungee_force(law, d, v_rel); });
    return each(
        [&](std::uint32_t row) { return bungee_force(law, stage_.position[row] - law.anchor, stage_.velocity[row]); });
  }
  bool operator()(const WindZone& zone) const {
    return each([&](std::uint32_t row) {
      if (stage_.in_zone[row] != 0 || !is_inside(zone, stage_.position[row])) return Vec3d{};
      // The zone's air takes the place of the air around it, so the own drag is taken back, once.
      stage_.in_zone[row] = 1;
      const Vec3d u = stage_.velocity[row] - zone.velocity;
      const Vec3d force = surroundings_.drag_equation(row, zone.density, u);
      const Surroundings::OwnDrag own = surroundings_.own_drag(row);
      stage_.drag_rate[row] += drag_rate_of(force, u) - own.rate;
      return force - own.force;
    });
  }
  bool operator()(const Thrust& law) const {
    const double common = clock_.from_launch ? 0 : thrust_at(law.curve, clock_.since_start);
    return each([&](std::uint32_t row) {
      const double thrust = clock_.from_launch ? thrust_at(law.curve, stage_.age[row]) : common;
      return thrust_direction(law, stage_.velocity[row]) * thrust;
    });
  }
  bool operator()(const CustomForce& law) const {
    if (!law.function || members_.empty()) return true;
    const bool in_place = side_by_side(members_);
    // The function may add or assign: it finds zeros.
    scratch_.force.assign(members_.size(), Vec3d{});
    try {
      law.function({stage_.time, gather(stage_.id, members_, in_place, scratch_.id),
                    gather(stage_.position, members_, in_place, scratch_.position),
                    gather(stage_.velocity, members_, in_place, scratch_.velocity),
                    gather(stage_.mass, members_, in_place, scratch_.mass), scratch_.force});
    } catch (...) {  // a step that ended here would leave half of the world behind
      return true;
    }
    for (std::size_t i = 0; i < members_.size(); ++i) stage_.force[members_[i]] += scratch_.force[i];
    return true;
  }

 private:
  [[nodiscard]] State<double> state(std::uint32_t row) const { return {stage_.position[row], stage_.velocity[row]}; }

  template <class Law>
  bool each(const Law& force_on) const {
    for (const std::uint32_t row : members_) {
      PHYSIM_ASSERT(row < stage_.force.size());
      stage_.force[row] += force_on(row);
    }
    return true;
  }

  /// A pull between each member and a partner, by distance and relative velocity.
  template <class Law>
  bool between(ProjectileId other, const Law& pull) const {
    const Partner partner = surroundings_.partner(other);
    if (!partner.alive) return false;
    const bool feels = partner.row != kNotInStage;
    const State<double> end = feels ? state(partner.row) : partner.state;
    for (const std::uint32_t row : members_) {
      if (stage_.id[row] == other) continue;  // it has no spring to itself
      const Vec3d force = pull(stage_.position[row] - end.x, stage_.velocity[row] - end.v);
      stage_.force[row] += force;
      if (feels) stage_.force[partner.row] -= force;
    }
    return true;
  }

  const ForceClock& clock_;
  Members members_;
  const Surroundings& surroundings_;
  ForceStage& stage_;
  ForceScratch& scratch_;
};

}  // namespace

bool add_force(const ForceLaw& law, const ForceClock& clock, std::span<const std::uint32_t> members,
               const Surroundings& surroundings, ForceStage& stage, ForceScratch& scratch) {
  PHYSIM_ASSERT(stage.position.size() == stage.force.size() && stage.velocity.size() == stage.force.size() &&
                stage.mass.size() == stage.force.size() && stage.drag_rate.size() == stage.force.size());
  return std::visit(Evaluation(clock, members, surroundings, stage, scratch), law);
}

}  // namespace physim
