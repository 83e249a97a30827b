// Random calls of a world, each drawn from a seed of its own: a list of seeds is a program of calls, and one that is
// left out changes no other.
#pragma once

#include <span>

#include "fuzz/odd_change.hpp"
#include "fuzz/odd_scene.hpp"
#include "random_emitters.hpp"

namespace physim::test {

/// Ids that calls have given so far. It goes back with the world, as the caller's own memory does.
struct Known {
  std::vector<ProjectileId> ids;
  std::vector<KindId> kinds;
  std::vector<ForceId> forces;
  std::vector<JointId> joints;
  std::vector<EmitterId> emitters;
  int environments = 1;
  OddScene scene;
};

// Functions of a user's own, each of what it is given alone.
inline const WindFunction& soak_wind() {
  static const WindFunction wind = [](const WindBatch& b) {
    for (std::size_t i = 0; i < b.velocity.size(); ++i)
      b.velocity[i] = {b.position[i].y * 0.5, b.time[i] - b.position[i].x * 0.1, 1};
  };
  return wind;
}
inline const ForceFunction& soak_force() {
  static const ForceFunction force = [](const FieldForceBatch& b) {
    for (std::size_t i = 0; i < b.force.size(); ++i)
      b.force[i] = (b.position[i] * -2 + b.velocity[i] * -0.1) * b.mass[i];
  };
  return force;
}
inline CustomForce soak_custom() {
  return {[](const ForceBatch& b) {
    for (std::size_t i = 0; i < b.force.size(); ++i)
      b.force[i] += b.velocity[i] * (-0.1 * b.mass[i]) + Vec3d{b.position[i].z, 0, -b.position[i].x} * b.mass[i];
  }};
}
inline void soak_answer(const HitBatch& batch) {
  for (std::size_t i = 0; i < batch.questions.size(); ++i) {
    const HitQuestion& q = batch.questions[i];
    const int what = static_cast<int>(std::abs(std::fmod(q.position.x * 977, 10)));
    batch.answers[i].then = static_cast<OnHit>(what % 5);
    if (what >= 8) batch.answers[i].velocity = q.velocity * 0.25;
  }
}
/// Functions for loads and replays: as many as may be wanted.
inline LoadOptions soak_functions(const Threading& threading) {
  LoadOptions o{.threading = threading};
  o.custom_forces.assign(300, soak_custom());
  o.wind_fields.assign(300, soak_wind());
  o.force_fields.assign(300, soak_force());
  o.hit_function = soak_answer;
  return o;
}

/// One call of a program.
class SoakCall {
 public:
  SoakCall(World& world, Known& known, std::uint64_t seed) : w_(world), known_(known), r_(seed, 0) {}

  /// Makes it; its name.
  std::string make() {
    // A world without anybody in it shows nothing.
    if (known_.kinds.size() < 3 && r_.coin()) return add_kind(), "add_kind";
    if (known_.ids.size() < 12 && r_.one_in(3)) return spawn();
    switch (r_.below(40)) {
      case 0:
      case 1:
      case 2: return add_kind(), "add_kind";
      case 3:
      case 4:
      case 5:
      case 6:
      case 7:
      case 8: return spawn();
      case 9: return environment();
      case 10: return detail();
      case 11:
      case 12:
      case 13: return force();
      case 14:
      case 15: return joint();
      case 16:
      case 17: return emitter();
      case 18: return emitter_change();
      case 19:
      case 20: return scene();
      case 21:
      case 22:
      case 23: return change_oddly(w_[some()], r_), "change";
      case 24: return few();
      default: return time();
    }
  }
  /// Whether it may have taken steps.
  [[nodiscard]] bool stepped() const { return stepped_; }

 private:
  template <class T>
  T one_of(const std::vector<T>& list) {
    return list.empty() ? T{} : list[static_cast<std::size_t>(r_.below(static_cast<int>(list.size())))];
  }
  ProjectileId some() { return one_of(known_.ids); }
  KindId kind() { return one_of(known_.kinds); }
  template <class T>
  static void keep(const Result<T>& made, std::vector<T>& list) {
    if (made) list.push_back(*made);
  }

  // ------------------------------------------------------------------------------------------- projectiles
  /// Rungs that most worlds have, in any precision.
  Fidelity common_rung() {
    Fidelity f = r_.fidelity();
    if (r_.one_in(3)) f = r_.coin() ? Fidelity::game() : Fidelity::constant_air();
    if (r_.one_in(3)) f.integrator = r_.any<Integrator>();
    if (r_.one_in(3)) f.precision = r_.any<Precision>();
    if (r_.one_in(5)) f.rotation = RotationModel::magnus;
    return f;
  }
  /// Balls that meet each other and things.
  std::pair<ProjectileDef, BodyDef> ball() {
    ProjectileDef p{.mass = r_.in(0.1, 1), .fidelity = common_rung()};
    p.diameter = 0.2;
    if (r_.one_in(4)) p.drag = r_.drag();
    if (r_.one_in(4)) p.motor = r_.motor();
    if (r_.one_in(4)) p.magnus = r_.magnus();
    BodyDef body{.restitution = r_.unit(), .friction = r_.unit()};
    const OnHit often = r_.one_in(3) ? r_.any<OnHit>() : OnHit::bounce;
    body.collision = {.on_hit = often, .radius = r_.one_in(6) ? 0 : r_.in(0.1, 0.4), .others = 1};
    body.sleep_time = r_.in(0, 0.3), body.sleep_speed = r_.one_in(3) ? 1 : 0.05;
    body.pool = static_cast<std::uint32_t>(r_.below(static_cast<int>(w_.def().pools.size())));
    body.environment = static_cast<std::uint32_t>(r_.below(known_.environments));
    if (r_.one_in(4)) body.despawn.older = r_.in(0.1, 1);
    return {p, body};
  }
  std::pair<ProjectileDef, BodyDef> anything() {
    if (!r_.one_in(3)) return ball();
    return {r_.projectile(), r_.body()};
  }
  Launch launch() {
    if (r_.one_in(4)) return r_.launch();
    Launch l{.position = r_.vector(1.5) + Vec3d{0, 2, 0}, .velocity = r_.vector(r_.one_in(5) ? 60 : 8)};
    if (r_.one_in(4)) l.spin = {r_.in(-100, 100), r_.in(-100, 100), r_.in(-100, 100)};
    return l;
  }
  void add_kind() {
    const auto [p, body] = anything();
    keep(w_.add_kind(p, body), known_.kinds);
  }
  std::string spawn() {
    const double delay = r_.one_in(6) ? r_.in(0, 0.3) : 0;
    if (known_.kinds.empty() || r_.one_in(4)) {
      const auto [p, body] = anything();
      keep(w_.spawn(p, launch(), body, delay), known_.ids);
      return "spawn (own definition)";
    }
    const KindId of = kind();
    const int count = r_.one_in(3) ? 1 : 1 + r_.below(r_.one_in(6) ? 40 : 6);
    for (int i = 0; i < count; ++i) keep(w_.spawn(of, launch(), delay), known_.ids);
    return "spawn " + std::to_string(count);
  }
  std::string few() {
    std::vector<ProjectileId> list;
    for (int i = r_.below(6); i > 0; --i) list.push_back(some());
    switch (r_.below(8)) {
      case 0: return w_.clear(), "clear";
      case 1:
      case 2: return w_.despawn(list), "despawn";
      default: return w_.set_fidelity(list, common_rung()), "set_fidelity";
    }
  }

  // ------------------------------------------------------------------------------------------- surroundings
  std::string environment() {
    Environment e = r_.environment();
    if (r_.one_in(3)) e.wind.field = soak_wind();
    if (r_.one_in(3)) e.force = soak_force();
    if (r_.coin()) return known_.environments += w_.add_environment(e) ? 1 : 0, "add_environment";
    const int which = r_.below(known_.environments);
    return static_cast<void>(w_.set_environment(static_cast<std::uint32_t>(which), e)), "set_environment";
  }
  std::string detail() {
    if (r_.one_in(3)) return static_cast<void>(w_.set_observer(r_.vector(20))), "set_observer";
    return static_cast<void>(w_.set_detail(r_.one_in(4) ? DetailRule{} : r_.detail())), "set_detail";
  }
  std::string force() {
    const ForceLaw law = r_.law([this] { return some(); }, soak_custom());
    if (r_.one_in(5)) return static_cast<void>(w_.remove_force(one_of(known_.forces))), "remove_force";
    const std::string what = "add_force (law " + std::to_string(law.index()) + ")";
    if (r_.one_in(4)) return keep(w_[some()].add_force(law), known_.forces), what + " to one";
    ForceDef def{.law = law, .target = ForceTarget::everything()};
    if (r_.one_in(3)) def.target = {{some(), some()}, r_.coin() ? kind() : KindId{}, r_.count(3)};
    if (r_.one_in(3)) def.delay = r_.in(0, 0.1);
    if (r_.coin()) def.duration = r_.in(0, 0.5);
    return keep(w_.add_force(def), known_.forces), what;
  }
  std::string scene() { return known_.scene.act(w_, r_), "scene"; }

  // ------------------------------------------------------------------------------------------- joints
  std::string joint() {
    if (r_.one_in(5)) return static_cast<void>(w_.remove_joint(one_of(known_.joints))), "remove_joint";
    if (r_.one_in(5)) {
      const BodyState to{r_.vector(2) + Vec3d{0, 3, 0}, r_.vector(1)};
      return static_cast<void>(w_.move_joint(one_of(known_.joints), to)), "move_joint";
    }
    Joint j{.kind = static_cast<JointKind>(r_.below(5)), .a = some()};
    if (r_.coin()) j.b = some();
    j.point = r_.vector(2) + Vec3d{0, 3, 0};
    if (r_.one_in(4)) j.length = r_.in(0.2, 2);
    j.restitution = r_.coin() ? 0 : r_.unit();
    j.stiffness = r_.in(1, 100), j.damping = r_.in(0, 1);
    if (r_.one_in(8)) j.break_force = r_.in(1, 1000);
    if (!j.b && r_.coin()) j.velocity = r_.vector(1);
    if (j.kind == JointKind::hinge) j.axis = r_.vector(1), j.low_angle = r_.in(-3, 0), j.high_angle = r_.in(0, 3);
    if (j.kind == JointKind::slider) j.axis = r_.vector(1), j.length = {}, j.low = r_.in(-2, 0), j.high = r_.in(0, 2);
    return keep(w_.add_joint(j), known_.joints), "add_joint";
  }

  // ------------------------------------------------------------------------------------------- emitters
  std::string emitter() {
    EmitterDef def = random_emitter(r_, kind(), known_.emitters);
    if (r_.one_in(2)) def.flight = random_flight(r_);
    if (r_.one_in(3)) def.cycle.prewarm = true, def.cycle.looping = true, def.cycle.delay = {};
    if (r_.one_in(4)) def.follows = some(), def.motion = AtRest{};
    if (r_.one_in(2)) def.position = r_.vector(1) + Vec3d{0, 2, 0};
    return keep(w_.add_emitter(def), known_.emitters), "add_emitter";
  }
  std::string emitter_change() {
    const EmitterId e = one_of(known_.emitters);
    const Transform to{r_.vector(9), {1, r_.in(-1, 1), r_.in(-1, 1), 0}, 1};
    switch (r_.below(9)) {
      case 0: return static_cast<void>(w_.remove_emitter(e)), "remove_emitter";
      case 1: return static_cast<void>(w_.play_emitter(e)), "play_emitter";
      case 2: return static_cast<void>(w_.stop_emitter(e)), "stop_emitter";
      case 3: return static_cast<void>(w_.move_emitter(e, to)), "move_emitter";
      case 4: return static_cast<void>(w_.lead_emitter(e, to, w_.time() + r_.in(0.01, 0.3))), "lead_emitter";
      case 5: return static_cast<void>(w_.jump_emitter(e, to)), "jump_emitter";
      case 6: return static_cast<void>(w_.seek_emitter(e, r_.in(0, 2))), "seek_emitter";
      case 7: return static_cast<void>(w_.emit(e, r_.count(5))), "emit";
      default: return static_cast<void>(w_.trigger_emitter(e)), "trigger_emitter";
    }
  }

  // ------------------------------------------------------------------------------------------- time
  std::string time() {
    stepped_ = true;
    switch (r_.below(10)) {
      case 0:
        return static_cast<void>(w_.step(r_.one_in(8) ? r_.in(0.1, 2) : r_.in(0.002, 0.05))), "step of another length";
      case 1: return static_cast<void>(w_.advance(r_.in(0, 0.1))), "advance";
      case 2: return static_cast<void>(w_.set_time_scale(r_.in(0.2, 3))), stepped_ = false, "set_time_scale";
      case 3: return w_.set_paused(r_.one_in(3)), stepped_ = false, "set_paused";
      default: break;
    }
    const int count = r_.one_in(4) ? 1 + r_.below(12) : 1;
    for (int i = 0; i < count; ++i) w_.single_step();
    return "single_step, " + std::to_string(count);
  }

  World& w_;
  Known& known_;
  Odd r_;
  bool stepped_ = false;
};

}  // namespace physim::test
