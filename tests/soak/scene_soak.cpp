// Soak of scenes: projectiles bounce about among things that move, come and go, and in a room where all is at rest.
//
//   physim_scene_soak [PROJECTILE_STEPS] [PROJECTILES] [SEED]
//
// Half of the projectiles fly in float32. Fails where a contact gains energy in the frame of the surface that it meets,
// where somebody in the room at rest has more energy than at launch (that of its spring and of gravity counted) or
// leaves the room, where a restored world differs, and where the memory held grows after the first third of 10^7 or
// more. It is meant to run under the sanitizers: ./dev soak --scenes --asan.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdlib>
#include <map>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "physim/world.hpp"
#include "soak/memory.hpp"

namespace {

using namespace physim;

constexpr double kGravity = 9.80665;

[[noreturn, gnu::format(printf, 1, 2)]] void fail(const char* format, ...) {
  std::va_list list;
  va_start(list, format);
  std::fputs("scene_soak: ", stderr);
  std::vfprintf(stderr, format, list);
  va_end(list);
  std::exit(1);
}

template <class T>
T must(Result<T> made) {
  if (!made) fail("%s\n", made.error().text().c_str());
  return std::move(made.value());
}
void must(const Status& status) {
  if (!status) fail("%s\n", status.error().text().c_str());
}

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  unsigned pick(unsigned below) { return static_cast<unsigned>(random_() % below); }
  double in(double low, double high) { return low + (high - low) * static_cast<double>(random_()) / 4294967296.0; }
  Vec3d vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Quatd turn() { return {in(-1, 1), in(-1, 1), in(-1, 1), 1.5}; }

 private:
  std::mt19937 random_;
};

/// What bounces, and how.
struct Company {
  KindId kind{};
  double radius = 0, friction = 0, restitution = 0;
  bool single = false;  // float32
  bool keeps = false;   // its integrator keeps the energy of a spring, but for far less than is looked at
};

Fidelity in_vacuum(Integrator integrator, Precision precision) {
  Fidelity f = Fidelity::game();
  f.integrator = integrator;
  f.drag = DragModel::off;
  f.precision = precision;
  return f;
}

/// Kinds of both precisions that bounce: points and balls, smooth and rough.
std::vector<Company> add_kinds(World& world, Chance& chance, bool drags, double lasts) {
  std::vector<Company> list;
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::tsit5})
      for (const double radius : {0.0, 0.02, 0.2})
        for (const double friction : {0.0, 0.6}) {
          ProjectileDef p{
              .mass = 1, .diameter = 0.1, .drag = {.k2 = 1e-3}, .fidelity = in_vacuum(integrator, precision)};
          if (drags) p.fidelity.drag = DragModel::linear_quadratic;
          BodyDef body{.restitution = chance.pick(3) == 0 ? 1 : chance.in(0, 1),
                       .friction = friction,
                       .collision = {.on_hit = OnHit::bounce, .radius = radius},
                       .despawn = {.older = lasts}};
          list.push_back({must(world.add_kind(p, body)), radius, friction, body.restitution,
                          precision == Precision::float32, integrator != Integrator::semi_implicit_euler});
        }
  return list;
}

ShapeDef cut_stone(Chance& chance) {
  ConvexHullShape stone;
  for (int i = 0; i < 12; ++i) stone.points.push_back(chance.vector(1));
  return stone;
}

/// A box of triangles.
ShapeDef crate() {
  MeshShape box;
  for (int i = 0; i < 8; ++i) box.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 0.7 : -0.7, i & 4 ? 1.2 : -1.2});
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return box;
}

std::vector<ShapeId> add_shapes(Scene& scene, Chance& chance) {
  std::vector<ShapeId> ids;
  for (const ShapeDef& def :
       {ShapeDef(SphereShape{0.8}), ShapeDef(BoxShape{{0.6, 1, 0.8}}), ShapeDef(CapsuleShape{0.4, 0.7}),
        ShapeDef(CylinderShape{0.7, 0.5}), cut_stone(chance), cut_stone(chance), crate()})
    ids.push_back(must(scene.add_shape(def)));
  CompoundShape both{.parts = {{ids[0], {.position = {0.9, 0, 0}}}, {ids[6], {.position = {-0.9, 0, 0}}}}};
  ids.push_back(must(scene.add_shape(both)));
  return ids;
}

MaterialId some_material(Scene& scene, Chance& chance) {
  Material material{.restitution = chance.pick(2) == 0 ? 1 : chance.in(0, 1), .friction = chance.in(0, 1)};
  return must(scene.add_material(material));
}

WorldDef quiet(unsigned threads) {
  return {.ground = {.mode = GroundMode::none}, .threading = {.threads = threads, .rows_per_thread = 64}};
}

/// Over hills, among things that move and jump, are taken away and come back.
class Fair {
 public:
  Fair(std::size_t projectiles, unsigned seed)
      : projectiles_(projectiles), chance_(seed), world_(must(World::create(quiet(3)))) {
    Scene scene;
    shapes_ = add_shapes(scene, chance_);
    for (int i = 0; i < 4; ++i) materials_.push_back(some_material(scene, chance_));
    must(scene.add({.shape = must(scene.add_shape(PlaneShape{})), .transform = {.position = {0, -8, 0}}}));
    HeightFieldShape hills{.columns = 33, .rows = 33, .spacing_x = 2.5, .spacing_z = 2.5, .heights = {}};
    for (int i = 0; i < 33 * 33; ++i) hills.heights.push_back(2 * std::sin(0.4 * (i % 33)) * std::cos(0.3 * (i / 33)));
    must(scene.add(
        {.shape = must(scene.add_shape(hills)), .transform = {.position = {-40, -4, -40}}, .material = materials_[0]}));
    for (int i = 0; i < 40; ++i) things_.push_back(must(scene.add(some_thing())));
    must(world_.set_scene(scene));
    kinds_ = add_kinds(world_, chance_, true, 3);
  }

  void step() {
    while (world_.size() < projectiles_) spawn();
    for (int i = 0; i < 3; ++i) change();
    if (chance_.pick(20) == 0) pull();
    if (chance_.pick(200) == 0) go_back();
    world_.step(chance_.in(1.0 / 240, 1.0 / 30));
    look_at(world_.events());
    std::erase_if(forces_, [this](ForceId id) { return !world_.is_active(id); });
  }
  [[nodiscard]] std::uint64_t projectile_steps() const { return before_ + world_.counters().projectile_steps; }
  [[nodiscard]] std::uint64_t contacts() const { return contacts_; }

 private:
  struct Contact {
    Event came, left;
    int hits = 0, bounces = 0;
  };

  InstanceDef some_thing() {
    InstanceDef def{
        .shape = shapes_[chance_.pick(static_cast<unsigned>(shapes_.size()))],
        .transform = {.position = chance_.vector(15), .rotation = chance_.turn(), .scale = chance_.in(0.5, 3)},
        .material = materials_[chance_.pick(static_cast<unsigned>(materials_.size()))]};
    def.motion = some_motion(def.transform.position);
    return def;
  }
  SceneMotion some_motion(const Vec3d& from) {
    const double now = world_.time();
    const unsigned what = chance_.pick(4);
    if (what == 0) return AtRest{};
    if (what == 1) return SteadyMotion{now, chance_.vector(20), {}};
    if (what == 2) return SteadyMotion{now, chance_.vector(5), chance_.vector(4)};
    KeyedMotion path{.keys = {}, .curve = chance_.pick(2) == 0 ? MotionCurve::smooth : MotionCurve::straight};
    for (int i = 0; i < 4; ++i)
      path.keys.push_back({now + 0.7 * i, from + chance_.vector(4), chance_.turn(), chance_.vector(8)});
    return path;
  }
  void spawn() {
    const Company& of = kinds_[chance_.pick(static_cast<unsigned>(kinds_.size()))];
    Launch launch{.position = chance_.vector(15) + Vec3d{0, 16, 0},
                  .velocity = chance_.vector(chance_.pick(5) == 0 ? 300 : 30)};
    ids_[must(world_.spawn(of.kind, launch)).index] = &of;
  }
  void change() {
    InstanceId& thing = things_[chance_.pick(static_cast<unsigned>(things_.size()))];
    switch (chance_.pick(4)) {
      case 0: return must(world_.move_instance(thing, some_thing().transform));
      case 1: return must(world_.set_instance_layers(thing, chance_.pick(4) == 0 ? 2 : 1));
      case 2:
        return must(
            world_.set_instance_motion(thing, some_motion(world_.scene()->instance(thing)->transform.position)));
      default: must(world_.remove_instance(thing)); thing = must(world_.add_instance(some_thing()));
    }
  }
  /// Bungees between some of them.
  void pull() {
    const std::vector<ProjectileId> all = world_.ids();
    const std::size_t first = chance_.pick(static_cast<unsigned>(all.size()) - 1);
    ForceDef force{.law = Bungee{.other = all[first + 1], .stiffness = 5, .rest_length = 1},
                   .target = {.ids = {all[first]}},
                   .duration = chance_.in(0.1, 1)};
    forces_.push_back(must(world_.add_force(force)));
  }
  /// Some steps into the future, and back.
  void go_back() {
    const std::uint64_t hash = world_.hash();
    const Snapshot now = world_.snapshot();
    for (int i = 0; i < 3; ++i) world_.step(1.0 / 60);
    before_ += world_.counters().projectile_steps;
    world_.restore(now);
    before_ -= world_.counters().projectile_steps;
    if (world_.hash() != hash) fail("a restored world differs\n");
  }

  /// Events of one time stand in the order of their kinds: only where a projectile hit and bounced once at that time is
  /// it sure which hit made the bounce.
  void look_at(std::span<const Event> events) {
    std::map<std::pair<std::uint32_t, double>, Contact> contacts;  // by slot and time
    for (const Event& event : events) {
      if (event.kind != EventKind::hit && event.kind != EventKind::bounced) continue;
      Contact& contact = contacts[{event.id.index, event.time}];
      if (event.kind == EventKind::hit)
        contact.came = event, ++contact.hits;
      else
        contact.left = event, ++contact.bounces;
    }
    for (const auto& [key, contact] : contacts)
      if (contact.hits == 1 && contact.bounces == 1 && contact.came.reason != Reason::inside) look_at(contact);
  }
  /// A ball that is not smooth takes speed from its spin, but never along the normal.
  void look_at(const Contact& contact) {
    const Event &came = contact.came, &event = contact.left;
    const auto of = ids_.find(event.id.index);
    if (came.instance != event.instance || of == ids_.end()) return;
    const auto surface = world_.scene()->state(event.instance, event.time);
    if (!surface) fail("a thing that was hit is gone\n");
    const Company& company = *of->second;
    const Vec3d u = velocity_at(*surface, came.position - came.normal * company.radius);
    const Vec3d in = came.velocity - u, out = event.velocity - u;
    // Where a curve is met it is known to a micrometre; velocities as well as numbers hold them.
    const double aside = 1e-6 * length(surface->angular_velocity) +
                         (company.single ? 2e-7 : 1e-12) * (length(u) + length(came.velocity));
    ++contacts_;
    if (std::abs(dot(out, event.normal)) > std::abs(dot(in, event.normal)) + 4 * aside)
      fail("a contact gains speed along its normal: %.17g, then %.17g m/s\n", dot(in, event.normal),
           dot(out, event.normal));
    if (company.radius > 0 && company.friction > 0) return;
    if (length(out) > length(in) + 4 * aside)
      fail("a contact gains energy: %.17g, then %.17g m/s\n", length(in), length(out));
  }

  std::size_t projectiles_;
  Chance chance_;
  World world_;
  std::vector<ShapeId> shapes_;
  std::vector<MaterialId> materials_;
  std::vector<InstanceId> things_;
  std::vector<Company> kinds_;
  std::vector<ForceId> forces_;
  std::map<std::uint32_t, const Company*> ids_;  // by slot
  std::uint64_t before_ = 0, contacts_ = 0;
};

/// Walls, a floor and a ceiling about things at rest; nobody leaves, and nobody gains energy.
class Room {
 public:
  Room(std::size_t projectiles, unsigned seed)
      : projectiles_(projectiles), chance_(seed), world_(must(World::create(quiet(2)))) {
    Scene scene;
    const ShapeId wall = must(scene.add_shape(PlaneShape{}));
    const double h = std::sqrt(0.5);
    for (const auto& [way, turn] : std::array<std::pair<Vec3d, Quatd>, 6>{{{{0, -1, 0}, {1, 0, 0, 0}},
                                                                           {{0, 1, 0}, {0, 1, 0, 0}},
                                                                           {{-1, 0, 0}, {h, 0, 0, -h}},
                                                                           {{1, 0, 0}, {h, 0, 0, h}},
                                                                           {{0, 0, -1}, {h, h, 0, 0}},
                                                                           {{0, 0, 1}, {h, -h, 0, 0}}}})
      must(scene.add({.shape = wall,
                      .transform = {.position = way * kHalf, .rotation = turn},
                      .material = some_material(scene, chance_)}));
    const std::vector<ShapeId> shapes = add_shapes(scene, chance_);
    for (int i = 0; i < 24; ++i)
      must(scene.add({.shape = shapes[static_cast<std::size_t>(i) % shapes.size()],
                      .transform = {.position = chance_.vector(7), .rotation = chance_.turn()},
                      .material = some_material(scene, chance_)}));
    must(world_.set_scene(scene));
    kinds_ = add_kinds(world_, chance_, false, 8);
  }

  void step() {
    for (int tries = 0; world_.size() < projectiles_ && tries < 1000; ++tries) spawn();
    const double dt = chance_.in(1.0 / 240, 1.0 / 30);
    world_.step(dt);
    longer_ = std::abs(dt - step_);
    step_ = dt;
    // Behind a contact what generators push with stays, for the rest of the step, as it was there.
    for (const Event& event : world_.events()) {
      const auto found = guests_.find(event.id.index);
      if (event.kind != EventKind::hit || found == guests_.end() || !found->second.tied) continue;
      const double way = (length(event.velocity) + 2 * kGravity * dt) * dt;
      found->second.held += kStiffness * way * way;
    }
    for (const ProjectileId id : world_.ids()) look_at(id);
  }
  [[nodiscard]] std::uint64_t projectile_steps() const { return world_.counters().projectile_steps; }

 private:
  static constexpr double kHalf = 10;      // of the room's edges [m]
  static constexpr double kStiffness = 2;  // of springs [N/m]

  struct Guest {
    ProjectileId id{};
    const Company* of = nullptr;
    double energy = 0;  // at launch [J]
    bool tied = false;  // to the middle of the room
    double held = 0;    // what its spring may have given it by being held, or steps of other lengths [J]
  };

  void spawn() {
    const Company& of = kinds_[chance_.pick(static_cast<unsigned>(kinds_.size()))];
    Launch launch{.position = chance_.vector(9), .velocity = chance_.vector(chance_.pick(5) == 0 ? 100 : 10)};
    const SceneFilter all;
    if (world_.scene()->nearest(launch.position, of.radius + 0.01, all)) return;  // nobody begins inside of something
    Guest guest{must(world_.spawn(of.kind, launch)), &of, 0, !of.single && of.keeps && chance_.pick(8) == 0, 0};
    if (guest.tied) {
      ForceDef force{.law = AnchoredSpring{.anchor = {}, .stiffness = kStiffness, .rest_length = 0},
                     .target = {.ids = {guest.id}}};
      must(world_.add_force(force));
    }
    guest.energy = energy_of(guest);
    guests_[guest.id.index] = guest;
  }
  [[nodiscard]] double energy_of(const Guest& guest) const {
    const BodyState s = world_[guest.id].state();
    const Vec3d spin = world_[guest.id].angular_velocity() * guest.of->radius;
    const double tie = guest.tied ? kStiffness * dot(s.position, s.position) : 0;
    return 0.5 * (dot(s.velocity, s.velocity) + 0.4 * dot(spin, spin) + tie) + kGravity * (s.position.y + kHalf);
  }
  void look_at(ProjectileId id) {
    Guest& guest = guests_.at(id.index);
    const BodyState s = world_[id].state();
    // A velocity of steps of order one is half a step from that of the path: it is off by so much, and a contact behind
    // a step of another length leaves what that changed.
    if (!guest.of->keeps) guest.held += 0.5 * kGravity * longer_ * length(s.velocity);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!(std::abs(s.position[axis]) <= kHalf + 1e-4)) fail("somebody left the room: %.9g m\n", s.position[axis]);
    const double energy = energy_of(guest);
    const double half_step = guest.of->keeps ? 0 : kGravity * step_ * (length(s.velocity) + kGravity * step_);
    const double off =
        guest.held + half_step +
        (guest.of->single ? 1e-4 * guest.energy + 1e-2 : (guest.tied ? 1e-6 : 1e-9) * guest.energy + 1e-6);
    if (!(energy <= guest.energy + off))
      fail("in a room at rest somebody has %.17g J, from %.17g J; radius %g m, friction %g, float32 %d, tied %d\n",
           energy, guest.energy, guest.of->radius, guest.of->friction, guest.of->single, guest.tied);
  }

  std::size_t projectiles_;
  Chance chance_;
  World world_;
  std::vector<Company> kinds_;
  std::map<std::uint32_t, Guest> guests_;  // by slot
  double step_ = 0, longer_ = 0;           // the last step, and by how much it differs from the one before [s]
};

}  // namespace

int main(int argc, char** argv) {
  const double target = argc > 1 ? std::atof(argv[1]) : 1e6;
  const double projectiles = argc > 2 ? std::atof(argv[2]) : 1000;
  const unsigned seed = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1;
  if (!(target >= 1 && target <= 1e13) || !(projectiles >= 4 && projectiles <= 1e6)) {
    std::fprintf(stderr, "usage: physim_scene_soak [PROJECTILE_STEPS] [PROJECTILES] [SEED]\n");
    return 2;
  }
  const auto half = static_cast<std::size_t>(projectiles / 2);
  Fair fair(half, seed);
  Room room(half, seed + 1);
  soak::Memory memory(target);
  double next_report = 0;
  const auto done = [&] { return static_cast<double>(fair.projectile_steps() + room.projectile_steps()); };
  while (done() < target) {
    fair.step();
    room.step();
    memory.look(done());
    if (done() < next_report) continue;
    next_report = done() + target / 10;
    std::printf("%12.0f projectile-steps, %llu bounces looked at, %.1f MB held\n", done(),
                static_cast<unsigned long long>(fair.contacts()), memory.held());
    std::fflush(stdout);
  }
  std::printf(
      "%.0f projectile-steps, %llu bounces looked at; held at most %.1f MB in the first third, %.1f MB in all\n",
      done(), static_cast<unsigned long long>(fair.contacts()), memory.early(), memory.most());
  if (target >= 1e7 && memory.grows()) fail("memory grows\n");
  return 0;
}
