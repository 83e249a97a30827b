// Random small worlds in which energy is never made: nothing moves but projectiles, and nothing blows or pushes.
//
//   physim_energy_fuzz [COUNT [SEED [FIRST]]]
//
// Masses over twelve decades, points and balls, smooth and rough, elastic or not, on every kind of integrator, in both
// precisions, with steps from 0.1 ms to 50 ms, above ground and among things, alone or meeting each other. Fails where
// the energy of a world rises beyond rounding, for steps of order one beyond what their velocity is off by, and where
// a projectile is gone or no number.
#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "fuzz/arguments.hpp"
#include "fuzz/verdict.hpp"
#include "physim/names.hpp"
#include "physim/world.hpp"

namespace physim::test {
namespace {

constexpr double kGravity = 9.80665;
constexpr double kLowest = -60;  // potential energy is 0 there [m]

class Chance {
 public:
  Chance(long seed, long number) : random_(static_cast<std::uint64_t>(seed) * 1'000'003 + std::uint64_t(number)) {}
  double in(double low, double high) { return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53; }
  double decade(double low, double high) { return std::pow(10.0, in(low, high)); }
  unsigned pick(unsigned below) { return static_cast<unsigned>(random_() % below); }
  bool one_in(unsigned n) { return pick(n) == 0; }
  double part() { return one_in(3) ? 1 : one_in(3) ? 0 : in(0, 1); }
  Vec3d vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }

 private:
  std::mt19937_64 random_;
};

struct Guest {
  ProjectileId id{};
  double mass = 1, radius = 0, inertia = 0.4, gravity = kGravity;
  bool is_first_order = false, is_single = false;
  double fastest = 0;  // up to now [m/s]
};

/// A world, what it holds, and the most energy that it may have.
class Case {
 public:
  Case(long seed, long number) : chance_(seed, number) {}

  void play() {
    make_world();
    if (!world_ || !fill()) return;
    const unsigned steps = 10 + chance_.pick(50);
    const double usual = chance_.decade(-4, -1.3);
    const bool is_varied = chance_.one_in(4);
    double first = energy();
    for (unsigned i = 0; i < steps; ++i) {
      const double dt = usual * (is_varied ? chance_.in(0.3, 1) : 1);
      if (i > 0) longer_ += std::abs(dt - step_);
      step_ = dt;
      world_->step(dt);
      ++tally.steps;
      if (world_->size() != guests_.size()) return fault("a projectile is gone");
      const double now = energy();
      if (!std::isfinite(now)) return fault("an energy is no number");
      if (now > first + allowed()) {
        std::printf("world %ld, step %u of %.3g s: %.17g J after %.17g J at first; allowed %.3g\n", case_number, i, dt,
                    now, first, allowed());
        for (const Guest& guest : guests_) tell(guest);
        return fault("energy is made");
      }
    }
  }

 private:
  void tell(const Guest& guest) const {
    const auto projectile = (*world_)[guest.id];
    const Fidelity f = projectile.fidelity_in_use().fidelity;
    const BodyState s = projectile.state();
    std::printf("  %s, %s, drag %s, %.3g kg, radius %.3g m, at (%.4g, %.4g, %.4g) m, %.4g m/s\n",
                std::string(name(f.integrator)).c_str(), std::string(name(f.precision)).c_str(),
                std::string(name(f.drag)).c_str(), guest.mass, guest.radius, s.position.x, s.position.y, s.position.z,
                length(s.velocity));
  }
  void make_world() {
    WorldDef def;
    def.threading.threads = 1;
    has_ground_ = !chance_.one_in(3);
    def.ground.mode = has_ground_ ? GroundMode::bounce : GroundMode::none;
    def.ground.restitution = chance_.part();
    def.ground.friction = chance_.part();
    def.environment.wind.velocity = {};
    Result<World> made = World::create(def);
    if (!made) return fault("no world");
    world_.emplace(std::move(made.value()));
    if (!chance_.one_in(3)) add_things();
  }

  void add_things() {
    Scene scene;
    const unsigned count = 1 + chance_.pick(4);
    for (unsigned i = 0; i < count; ++i) {
      Material material;
      material.restitution = chance_.part();
      material.friction = chance_.part();
      const auto made = scene.add_material(material);
      const auto shape = scene.add_shape(some_shape());
      if (!made || !shape) return fault("no shape");
      Quatd turn{1, 0, 0, 0};
      if (!chance_.one_in(3)) turn = {chance_.in(-1, 1), chance_.in(-1, 1), chance_.in(-1, 1), 1.5};
      if (!scene.add({.shape = *shape,
                      .transform = {.position = chance_.vector(3), .rotation = turn, .scale = chance_.in(0.3, 2)},
                      .material = *made}))
        return fault("no thing");
    }
    if (!world_->set_scene(scene)) fault("no scene");
  }
  ShapeDef some_shape() {
    const Vec3d half{chance_.in(0.1, 2), chance_.in(0.1, 2), chance_.in(0.1, 2)};
    switch (chance_.pick(7)) {
      case 0: return SphereShape{half.x};
      case 1: return BoxShape{half};
      case 2: return CapsuleShape{half.x, half.y};
      case 3: return CylinderShape{half.x, half.y};
      case 4: return PlaneShape{};
      case 5: {
        HeightFieldShape field{.columns = 4, .rows = 4, .spacing_x = half.x, .spacing_z = half.z, .heights = {}};
        for (int i = 0; i < 16; ++i) field.heights.push_back(chance_.in(-half.y, half.y));
        return field;
      }
      default: {
        ConvexHullShape hull;
        for (int i = 0; i < 10; ++i) hull.points.push_back(chance_.vector(half.x));
        return hull;
      }
    }
  }

  ProjectileDef some_projectile() {
    constexpr std::array kIntegrators = {Integrator::explicit_euler, Integrator::semi_implicit_euler,
                                         Integrator::heun,           Integrator::rk4,
                                         Integrator::rk43,           Integrator::tsit5,
                                         Integrator::dop853};
    ProjectileDef p;
    p.mass = chance_.decade(-6, 6);
    p.diameter = 0.1;
    p.fidelity = Fidelity::game();
    p.fidelity.rotation = RotationModel::none;
    p.fidelity.integrator = kIntegrators[chance_.pick(kIntegrators.size())];
    p.fidelity.precision = chance_.one_in(2) ? Precision::float32 : Precision::float64;
    p.fidelity.drag = chance_.one_in(3) ? DragModel::linear_quadratic : DragModel::off;
    p.drag.k1 = p.mass * chance_.decade(-4, 2);
    p.drag.k2 = p.mass * chance_.decade(-4, 2);
    return p;
  }
  BodyDef some_body() {
    BodyDef body;
    body.collision.on_hit = OnHit::bounce;
    body.collision.radius = chance_.one_in(3) ? 0 : chance_.decade(-2.5, -0.3);
    body.collision.inertia = chance_.one_in(2) ? 0.4 : chance_.in(0.05, 1);
    body.collision.others = meets_ ? 1 : 0;
    body.restitution = chance_.part();
    body.friction = chance_.part();
    body.rolling_resistance = chance_.one_in(2) ? 0 : chance_.in(0, 0.2);
    if (chance_.one_in(8)) body.frozen_rotation = Axes::all;
    if (chance_.one_in(8)) body.gravity_scale = 0;
    return body;
  }

  [[nodiscard]] bool is_free(const Vec3d& position, double radius) const {
    if (has_ground_ && position.y <= radius * 1.01 + 1e-3) return false;
    if (world_->scene() && world_->scene()->nearest(position, radius * 1.01 + 1e-3, SceneFilter{})) return false;
    return std::ranges::all_of(guests_, [&](const Guest& guest) {
      const Vec3d apart = world_->operator[](guest.id).state().position - position;
      return length(apart) > 1.01 * (radius + guest.radius) + 1e-3;
    });
  }

  /// Says whether somebody is there.
  bool fill() {
    meets_ = chance_.one_in(2);
    const unsigned count = 1 + chance_.pick(5);
    const double speed = chance_.one_in(5) ? 0 : chance_.decade(-1, 2);
    for (unsigned i = 0; i < count; ++i) {
      const ProjectileDef p = some_projectile();
      const BodyDef body = some_body();
      const Result<KindId> kind = world_->add_kind(p, body);
      if (!kind) return fault("no kind"), false;
      Launch launch;
      launch.velocity = chance_.vector(speed);
      for (int tries = 0; tries < 20; ++tries) {
        launch.position = chance_.vector(4);
        if (has_ground_) launch.position.y = std::abs(launch.position.y);
        if (!is_free(launch.position, body.collision.radius)) continue;
        const Result<ProjectileId> id = world_->spawn(*kind, launch);
        if (!id) return fault("nothing is spawned"), false;
        const Integrator method = p.fidelity.integrator;
        guests_.push_back({*id, p.mass, body.collision.radius, body.collision.inertia, body.gravity_scale * kGravity,
                           method == Integrator::explicit_euler || method == Integrator::semi_implicit_euler,
                           p.fidelity.precision == Precision::float32});
        ++tally.spawned;
        break;
      }
    }
    return !guests_.empty();
  }

  [[nodiscard]] double energy() {
    double sum = 0;
    for (Guest& guest : guests_) {
      const BodyState s = (*world_)[guest.id].state();
      guest.fastest = std::max(guest.fastest, length(s.velocity));
      const Vec3d rim = (*world_)[guest.id].angular_velocity() * guest.radius;
      const double moving = 0.5 * (dot(s.velocity, s.velocity) + guest.inertia * dot(rim, rim));
      sum += guest.mass * (moving + guest.gravity * (s.position.y - kLowest));
    }
    return sum;
  }

  /// What a sum of energies may be off by [J]. Its potential part counts from far below, so that it bounds roundings.
  [[nodiscard]] double allowed() const {
    double sum = 0;
    for (const Guest& guest : guests_) {
      const double v = guest.fastest, g = guest.gravity;
      const double whole = guest.mass * (0.5 * v * v + kGravity * (60 + 4));
      sum += (guest.is_single ? 1e-4 : 1e-9) * whole;
      if (guest.is_first_order) sum += guest.mass * g * (step_ + longer_) * (v + g * step_);
    }
    return sum;
  }

  Chance chance_;
  std::optional<World> world_;
  std::vector<Guest> guests_;
  bool has_ground_ = false, meets_ = false;
  double step_ = 0, longer_ = 0;  // the last step; by how much steps differed from those before, in all [s]
};

int run(int argc, char** argv) {
  const auto arguments = read_arguments("physim_energy_fuzz", argc, argv);
  if (!arguments) return 2;
  for (long i = arguments->first; i < arguments->first + arguments->count && faults < 100; ++i) {
    case_number = i;
    Case(arguments->seed, i).play();
  }
  std::printf("%ld worlds, %llu projectiles, %llu steps: %ld wrong\n", arguments->count,
              static_cast<unsigned long long>(tally.spawned), static_cast<unsigned long long>(tally.steps), faults);
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) { return physim::test::run(argc, argv); }
