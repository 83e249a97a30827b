// A game that nobody plays: random calls of everything that changes a world, the same for the same seed.
#pragma once

#include <random>

#include "must.hpp"
#include "random_emitters.hpp"

namespace physim::test {

inline WorldDef session_world() {
  return {.environment = {.atmosphere = {.temperature = 290},
                          .wind = {.velocity = {1, 0, -3}, .profile = {{0, {0, 0, 0}}, {100, {2, 0, -3}}}}},
          .ground = {GroundMode::bounce, 0, 0.8, 0.7},
          .step = 1.0 / 60,
          .apex_events = true,
          .pools = {{"few", 40, WhenFull::replace_oldest}, {"many", 400, WhenFull::refuse}},
          .detail = {.rungs = {{Fidelity::constant_air(), 300, 4}, {Fidelity::game()}}, .layers = 2},
          .max_projectiles = 300};
}

/// What there is; nobody where there is an error.
template <class T>
T or_null(const Result<T>& result) {
  return result ? *result : T{};
}

/// Says something of every kind about hits, now and then what makes no sense; it follows from the hit alone.
inline void answer_somehow(const HitBatch& batch) {
  for (std::size_t i = 0; i < batch.questions.size(); ++i) {
    const HitQuestion& q = batch.questions[i];
    HitAnswer& answer = batch.answers[i];
    const int what = static_cast<int>(std::abs(q.position.x + q.position.z) * 1000) % 24;
    answer.then = what < 12 ? OnHit::bounce : static_cast<OnHit>(what % 6);
    if (what == 20) answer = {OnHit::pass, q.velocity * 0.5};
    if (what == 21) answer = {OnHit::bounce, q.surface_velocity - (q.velocity - q.surface_velocity) * 0.5};
    if (what == 22) answer.velocity = q.normal;
  }
}

class RandomSession {
 public:
  /// `moments`: it goes back to snapshots, which hold for one world alone.
  RandomSession(World& world, unsigned seed, bool moments = true) : world_(world), random_(seed), moments_(moments) {}

  bool meet_others = true;  // some of its projectiles
  bool emitters = true;     // there are some
  bool joints = false;      // likewise
  bool asks = false;        // some of its projectiles ask what their hits do
  bool closed = false;      // most of them fly by closed forms, high above the ground

  /// One call of any kind; most are sensible.
  void act() {
    if (joints && below(20) == 0) return joint();
    if (asks && below(200) == 0) return void(world_.set_hit_function(answer_somehow));
    const int what = below(emitters ? 51 : 48);
    if (what < 10) return spawn();
    if (what < 14) return time();
    if (what < 16) return moment();
    if (what < 19) return surroundings();
    if (what < 22) return force();
    if (what == 22) return void(world_[some()].despawn());
    if (what == 23) return void(world_.despawn(several()));
    if (what == 24 && below(20) == 0) return world_.clear();
    if (what >= 48) return emitter();
    if (what >= 45) return scene();
    change(below(23));
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double real(double low, double high) { return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0); }
  Vec3d vector(double size) { return {real(-size, size), real(-size, size), real(-size, size)}; }
  bool coin() { return below(2) == 0; }
  /// Mostly one that is there; now and then one that is gone, or nobody.
  ProjectileId some() {
    if (ids_.empty() || below(30) == 0) return {};
    return ids_[ids_.size() - 1 -
                static_cast<std::size_t>(below(static_cast<int>(std::min<std::size_t>(ids_.size(), 60))))];
  }
  std::vector<ProjectileId> several() {
    std::vector<ProjectileId> list(static_cast<std::size_t>(below(6)));
    for (ProjectileId& id : list) id = some();
    return list;
  }
  Fidelity fidelity() {
    const auto names = fidelity_presets();
    Fidelity f = *fidelity_preset(names[static_cast<std::size_t>(below(static_cast<int>(names.size())))]);
    if (!closed || below(4) == 0) return f;
    f.motion = Motion::closed_form;
    f.drag = static_cast<DragModel>(below(3));
    f.wind = coin() ? WindModel::off : WindModel::constant;
    f.gravity = below(8) == 0 ? GravityModel::off : GravityModel::constant;
    f.precision = coin() ? Precision::float32 : Precision::float64;
    return f;
  }
  Launch launch() {
    Launch l{.position = vector(50), .speed = real(0, 90), .elevation = real(-0.5, 1.2), .azimuth = real(-3, 3)};
    l.position.y = real(0, closed ? 400 : 60);
    if (below(4) == 0) l.velocity = vector(40);
    return l;
  }
  ProjectileDef projectile() {
    ProjectileDef p{.name = "p" + std::to_string(below(5)),
                    .mass = 0.1 * (1 + below(3)),
                    .diameter = 0.05,
                    .drag = {.damping = 0.9, .k1 = below(2) * 0.001}};
    if (coin()) p.drag.table = DragTable::g7;
    if (below(3) == 0) p.drag = {.table = DragTable::custom, .curve = {{0, 0.3}, {1, 0.5}, {3, 0.4}}};
    if (below(3) == 0) p.force = {0, 2, 0}, p.force_duration = 1;
    p.fidelity = fidelity();
    return p;
  }
  BodyDef body() {
    BodyDef b{.gravity_scale = coin() ? 1 : 0.5, .kinematic = below(12) == 0, .infinite_mass = below(15) == 0};
    if (below(4) == 0) b.angular_velocity = vector(9), b.angular_drag = 0.1, b.frozen_rotation = Axes::x;
    if (below(5) == 0) b.frozen = Axes::z;
    if (below(3) == 0) b.despawn = {.below = -5, .farther = 150, .older = 3};
    b.pool = static_cast<std::uint32_t>(below(2));
    b.environment = static_cast<std::uint32_t>(below(static_cast<int>(environments_ + 1)));  // now and then none
    b.layers = static_cast<std::uint32_t>(1 + below(3));
    b.label = coin() ? "" : "a ball";
    if (below(3) != 0) b.collision = {.on_hit = static_cast<OnHit>(below(asks ? 6 : 5)), .radius = below(3) * 0.1};
    if (b.layers == 1 && meet_others) b.collision.radius *= 20, b.collision.others = 3;  // so large that they meet
    return b;
  }

  void spawn() {
    if (below(8) == 0) return ids_.push_back(or_null(world_.spawn(world_.predict(some(), 0.3), real(-0.05, 0.3))));
    const double delay = below(4) == 0 ? real(0, 1) : 0;
    if (kinds_.empty() || below(6) == 0)
      return ids_.push_back(or_null(world_.spawn(projectile(), launch(), body(), delay)));
    const KindId kind = kinds_[static_cast<std::size_t>(below(static_cast<int>(kinds_.size())))];
    if (below(6) != 0) return ids_.push_back(or_null(world_.spawn(kind, launch(), delay)));
    std::vector<Launch> launches(static_cast<std::size_t>(below(8)));
    for (Launch& l : launches) l = launch();
    std::vector<ProjectileId> ids(static_cast<std::size_t>(below(10)));
    world_.reserve(kind, launches.size());
    world_.spawn(kind, launches, ids);
    ids_.insert(ids_.end(), ids.begin(), ids.end());
  }
  void time() {
    switch (below(8)) {
      case 0: return world_.set_paused(below(3) == 0);
      case 1: return void(world_.set_time_scale(real(0.2, 2)));
      case 2: return void(world_.single_step());
      case 3: return void(world_.step(coin() ? 1.0 / 60 : real(0.001, 0.05)));
      default: return void(world_.advance(real(0, 0.1)));
    }
  }
  void moment() {
    if (coin() || snapshots_.empty()) return snapshots_.push_back(world_.snapshot());
    if (coin() && moments_)
      world_.restore(snapshots_[static_cast<std::size_t>(below(static_cast<int>(snapshots_.size())))]);
  }
  void surroundings() {
    Environment e{.wind = {.velocity = vector(5)}};
    switch (below(5)) {
      case 0:
        if (environments_ < 4 && world_.add_environment(e)) ++environments_;
        return;
      case 1: return void(world_.set_environment(static_cast<std::uint32_t>(below(3)), e));
      case 2: return void(world_.set_observer(vector(100)));
      case 3: return void(world_.set_detail(coin() ? session_world().detail : DetailRule{}));
      default: return kinds_.push_back(or_null(world_.add_kind(projectile(), body())));
    }
  }
  /// A floor, a wall, and a plank that moves.
  Scene things() {
    Scene scene;
    const MaterialId hard = or_null(scene.add_material({.restitution = 0.8, .friction = 0.3}));
    const MaterialId soft = or_null(scene.add_material(materials::oak()));
    or_null(scene.add({.shape = or_null(scene.add_shape(PlaneShape{})), .transform = {.position = {0, -2, 0}}}));
    const ShapeId box = or_null(scene.add_shape(BoxShape{{0.2, 5, 20}}));
    or_null(scene.add({.shape = box, .transform = {.position = {15, 3, 0}}, .material = soft}));
    if (coin())
      or_null(
          scene.add({.shape = box, .material = hard, .name = "plank", .motion = SteadyMotion{.velocity = vector(5)}}));
    return scene;
  }
  InstanceId thing() {
    return things_.empty() ? InstanceId{} : things_[static_cast<std::size_t>(below(static_cast<int>(things_.size())))];
  }
  void scene() {
    switch (below(9)) {
      case 0: return void(below(4) == 0 && world_.remove_scene());
      case 1: return void(world_.set_scene(things()));
      case 2: return shapes_.push_back(or_null(world_.add_shape(SphereShape{real(0.5, 3)})));
      case 3: return void(shapes_.empty() || world_.remove_shape(shapes_.back()).ok());
      case 4: return void(world_.remove_instance(thing()));
      case 5: return void(world_.move_instance(thing(), {.position = vector(20)}));
      case 6: return void(world_.set_instance_motion(thing(), SteadyMotion{world_.time(), vector(9), vector(1)}));
      case 7:
        if (const unsigned layers = below(8); layers < 4) return void(world_.set_instance_layers(thing(), layers));
        return void(world_.set_instance_conveyor(thing(), {{3, 0, 0}}));
      default:
        if (shapes_.empty()) return void(world_.add_material({.restitution = real(0, 1)}));
        return things_.push_back(or_null(world_.add_instance(
            {.shape = shapes_.back(), .transform = {.position = vector(20)}, .sensor = below(4) == 0})));
    }
  }
  void joint() {
    const std::vector<JointId> there = world_.joints();
    if (!there.empty() && below(4) == 0)
      return void(world_.remove_joint(there[static_cast<std::size_t>(below(static_cast<int>(there.size())))]));
    if (!there.empty() && below(6) == 0) {
      const JointId moved = there[static_cast<std::size_t>(below(static_cast<int>(there.size())))];
      return static_cast<void>(world_.move_joint(moved, {vector(10), vector(2)}));
    }
    Joint joint{.kind = static_cast<JointKind>(below(5)), .a = some(), .b = coin() ? some() : ProjectileId{}};
    joint.point = vector(10);
    if (coin()) joint.length = real(-0.1, 20);
    if (joint.kind == JointKind::cable) joint.restitution = real(0, 1);
    joint.stiffness = real(0, 500);
    joint.damping = real(-0.1, 5);
    if (below(8) == 0) joint.break_force = real(-10, 1000);
    if (!joint.b && coin()) joint.velocity = vector(2);
    if (joint.kind == JointKind::hinge) joint.axis = vector(1), joint.low_angle = real(-3, 0.1);
    if (joint.kind == JointKind::slider) joint.axis = vector(1), joint.length = {}, joint.high = real(-0.1, 20);
    or_null(world_.add_joint(joint));
  }
  EmitterId one_emitter() {
    return emitters_.empty() ? EmitterId{}
                             : emitters_[static_cast<std::size_t>(below(static_cast<int>(emitters_.size())))];
  }
  void emitter() {
    switch (below(12)) {
      case 0: return void(world_.remove_emitter(one_emitter()));
      case 1: return void(world_.play_emitter(one_emitter()));
      case 2: return void(world_.stop_emitter(one_emitter()));
      case 3: return void(world_.move_emitter(one_emitter(), {.position = vector(20)}));
      case 4: return void(world_.emit(one_emitter(), static_cast<std::uint32_t>(below(5))));
      case 5: return void(world_.trigger_emitter(one_emitter()));
      case 6: return void(world_.jump_emitter(one_emitter(), {.position = vector(20)}));
      case 8: return void(world_.lead_emitter(one_emitter(), {.position = vector(20)}, world_.time() + real(-0.1, 1)));
      case 7: return void(world_.seek_emitter(one_emitter(), real(0, 2)));
      default: {
        if (kinds_.empty()) return;
        const KindId kind = kinds_[static_cast<std::size_t>(below(static_cast<int>(kinds_.size())))];
        Random r(random_());
        EmitterDef def = random_emitter(r, kind, world_.emitters());
        if (below(2) == 0) def.flight = random_flight(r);
        if (below(4) == 0) def.follows = some(), def.motion = AtRest{};
        return emitters_.push_back(or_null(world_.add_emitter(def)));
      }
    }
  }
  void force() {
    const ForceLaw laws[] = {ConstantForce{vector(3)},
                             AnchoredSpring{vector(10), 2, 1, 0.1},
                             Spring{some(), 1, 2, 0},
                             Bungee{{}, vector(9), 1, 1, 0},
                             Buoyancy{.surface = 3},
                             PointAttractor{vector(20), 30, 1},
                             WindZone{vector(9), {-20, -20, -20}, {20, 20, 20}},
                             Explosion{vector(20), 50, 30},
                             Thrust{{{0, 5}, {1, 2}, {2, 0}}, {}},
                             LinearQuadraticDragForce{0.1, 0.01, {}},
                             CustomForce{[](const ForceBatch& b) {
                               for (std::size_t i = 0; i < b.id.size(); ++i) b.force[i].y += b.mass[i] * 3;
                             }}};
    const ForceLaw& law = laws[below(static_cast<int>(std::size(laws)))];
    switch (below(4)) {
      case 0: return forces_.push_back(or_null(world_[some()].add_force(law, real(0.1, 2))));
      case 1:
        return forces_.push_back(
            or_null(world_.add_force({law, {several(), {}, static_cast<unsigned>(below(3))}, 0.1, 1.5})));
      case 2: return void(forces_.empty() || world_.remove_force(forces_.back()).ok());
      default: return void(forces_.empty() || world_[some()].remove_force(forces_.front()).ok());
    }
  }
  void set_body(ProjectileId id) {
    BodyDef body = world_[id].body();
    body.gravity_scale = real(0, 2);
    body.frozen = static_cast<Axes>(below(8));
    body.kinematic = below(4) == 0;
    body.layers = static_cast<std::uint32_t>(below(4));
    world_[id].set_body(body);
  }

  void set_drag(ProjectileId id) {
    if (const ProjectileDef* what = world_[id].definition()) {
      ProjectileDef changed = *what;
      changed.diameter = real(0.01, 0.2);
      changed.drag.coefficient = real(0, 1);
      changed.drag.k1 = coin() ? 0 : real(0, 0.1);
      coin() ? world_[id].set_projectile(changed) : world_[id].set_drag(changed.drag);
    }
  }

  void change(int what) {
    const ProjectileId id = some();
    const auto bits = static_cast<std::uint32_t>(random_());
    switch (what) {
      case 0: return void(world_[id].set_position({real(-20, 20), real(1, 40), 0}));
      case 1: return void(world_[id].set_velocity(vector(30)));
      case 2: return void(world_[id].set_state({{1, 20, 2}, vector(10)}));
      case 3: return void(world_[id].apply_impulse(vector(1)));
      case 4: return void(world_[id].set_angular_velocity(vector(3)));
      case 5: return void(world_[id].set_gravity_scale(real(0, 2)));
      case 6: return void(world_[id].set_use_gravity(coin()));
      case 7: return void(world_[id].set_kinematic(below(3) == 0));
      case 8: return void(world_[id].set_frozen(static_cast<Axes>(below(8)), static_cast<Axes>(below(8))));
      case 9: return void(world_[id].set_can_sleep(coin()));
      case 10: return void(world_[id].sleep());
      case 11: return void(world_[id].wake());
      case 12: return void(world_[id].set_smoothing(static_cast<Smoothing>(below(3))));
      case 13: return void(world_[id].set_user_data(bits));
      case 14: return void(world_[id].set_layers(bits % 4));
      case 15: return void(world_[id].set_colour(bits));
      case 16: return void(world_[id].set_label("number " + std::to_string(bits)));
      case 17: return void(world_[id].set_fidelity(fidelity()));
      case 18: return set_body(id);
      case 19: return void(world_[id].set_mass(below(9) == 0 ? -1 : real(0.1, 9)));
      case 20: return void(world_[id].set_damping(below(9) == 0 ? 2 : real(0.5, 1)));
      case 21: return set_drag(id);
      default: return void(world_.set_fidelity(several(), fidelity()));
    }
  }

  World& world_;
  std::mt19937 random_;
  bool moments_;
  std::vector<ProjectileId> ids_;
  std::vector<KindId> kinds_;
  std::vector<ForceId> forces_;
  std::vector<Snapshot> snapshots_;
  std::vector<ShapeId> shapes_;
  std::vector<InstanceId> things_;
  std::vector<EmitterId> emitters_;
  std::uint32_t environments_ = 1;
};

}  // namespace physim::test
