// The bullet of the first PhySim, once through the rules of other engines, Cyclone, Bullet and rungs of the ladder: how
// far each is from what its own drag means, and from drag by the square of the speed; and what a step costs.
#include <cmath>
#include <variant>

#include "engine_rules.hpp"
#include "physim/world.hpp"
#include "world_bench.hpp"

namespace physim::bench {
namespace {

// 2 kg at (35, 5) m/s from 1.5 m, gravity 2 m/s^2, damping 0.9; it flies for 5 s, which all steps divide.
constexpr double kMass = 2, kHeight = 1.5, kGravity = 2, kDamping = 0.9, kFlown = 5;
constexpr double kUsual = 1.0 / 60, kUnity = 0.02;  // steps [s]
constexpr std::size_t kMany = 10000;
const Vec3d kMuzzle{35, 5, 0};

/// Of drag linear in the speed [1/s].
double rate() { return -std::log(kDamping); }
/// Of drag quadratic in the speed: as strong as the linear one at the muzzle [kg/m].
double quadratic() { return rate() * kMass / length(kMuzzle); }

/// Where the linear drag brings it: x0 + u t + (v0 - u) (1 - e^-ct) / c, with u = g / c.
Vec3d linear_end() {
  const double c = rate();
  const Vec3d fall{0, -kGravity / c, 0};
  return Vec3d{0, kHeight, 0} + fall * kFlown + (kMuzzle - fall) * (-std::expm1(-c * kFlown) / c);
}

/// Where the quadratic one does: Runge and Kutta's method with steps of 50 us.
Vec3d quadratic_end() {
  const double k = quadratic() / kMass;
  const auto acceleration = [k](const Vec3d& v) { return Vec3d{0, -kGravity, 0} - v * (k * length(v)); };
  Vec3d x{0, kHeight, 0}, v = kMuzzle;
  const int steps = 100000;
  const double h = kFlown / steps;
  for (int i = 0; i < steps; ++i) {
    const Vec3d a = acceleration(v), u = v + a * (h / 2), b = acceleration(u), w = v + b * (h / 2);
    const Vec3d c = acceleration(w), q = v + c * h, d = acceleration(q);
    x += (v + u * 2 + w * 2 + q) * (h / 6);
    v += (a + b * 2 + c * 2 + d) * (h / 6);
  }
  return x;
}

/// The first is the shot, others are like it.
std::vector<PeerProjectile> bullets(std::size_t count) {
  std::vector<PeerProjectile> list;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = 1 - 0.2 * static_cast<double>(i) / static_cast<double>(count);
    list.push_back({{0, static_cast<float>(kHeight), static_cast<float>(i)},
                    {static_cast<float>(kMuzzle.x * part), static_cast<float>(kMuzzle.y), 0}});
  }
  return list;
}

enum class Drag { linear, quadratic };

struct Engine {
  std::string name;
  double step;  // [s]
  Drag drag;    // that it means
  Vec3d end;    // of the shot [m]
  std::function<void()> go;
  double guess_ns;
  int steps = 1;  // in one turn
  std::vector<double> each = {};
};

PeerPhysics physics_of(Drag drag) {
  PeerPhysics p{static_cast<float>(kGravity), static_cast<float>(kMass), 0.05F, 0, 0};
  if (drag == Drag::linear) p.damping = static_cast<float>(kDamping);
  if (drag == Drag::quadratic) p.k2 = static_cast<float>(quadratic());
  return p;
}

World world_of_bullets(const Fidelity& fidelity, std::size_t count) {
  WorldDef def = free_flight();
  def.environment.gravity.acceleration = kGravity;
  def.environment.atmosphere.model = AirModel::vacuum;
  World world = std::move(World::create(def).value());
  ProjectileDef bullet{.mass = kMass, .fidelity = fidelity};
  bullet.drag.damping = kDamping;
  bullet.drag.k2 = quadratic();
  const KindId kind = *world.add_kind(bullet, {.can_sleep = false});
  world.reserve(kind, count);
  for (const PeerProjectile& p : bullets(count))
    world.spawn(kind, {.position = {p.position[0], p.position[1], p.position[2]},
                       .velocity = Vec3d{p.velocity[0], p.velocity[1], p.velocity[2]}});
  return world;
}

class Comparison {
 public:
  explicit Comparison(const Options& options) : options_(options) {}

  using MakePeer = std::function<std::unique_ptr<PeerWorld>(const std::vector<PeerProjectile>&)>;
  void add(std::string name, double step, Drag drag, double guess_ns, const MakePeer& make) {
    const auto one = make(bullets(1));
    const int steps = static_cast<int>(std::lround(kFlown / step));
    for (int i = 0; i < steps; ++i) one->step(static_cast<float>(step));
    float at[3];
    one->position(0, at);
    peers_.push_back(make(bullets(kMany)));
    const auto go = [peer = peers_.back().get(), step] { peer->step(static_cast<float>(step)); };
    engines_.push_back({std::move(name), step, drag, {at[0], at[1], at[2]}, go, guess_ns});
  }
  /// All are read after each step, as a game does that draws them.
  void add(std::string name, Drag drag, double guess_ns, const Fidelity& fidelity) {
    World one = world_of_bullets(fidelity, 1);
    for (int i = 0; i < std::lround(kFlown / kUsual); ++i) one.step(kUsual);
    worlds_.push_back(std::make_unique<World>(world_of_bullets(fidelity, kMany)));
    const auto go = [this, world = worlds_.back().get()] {
      world->step(kUsual);
      world->columns(columns_);
      for (const WorldColumns& read : columns_)
        read_ += std::visit([](const auto& all) { return all.position[0].size(); }, read);
    };
    engines_.push_back({std::move(name), kUsual, drag, one[one.ids().front()].position(), go, guess_ns});
  }
  [[nodiscard]] std::vector<std::vector<Cell>> rows() {
    measure();
    const Vec3d linear = linear_end(), squared = quadratic_end();
    std::vector<std::vector<Cell>> list;
    for (const Engine& e : engines_) {
      const double ns = median(e.each), meant = length(e.end - (e.drag == Drag::linear ? linear : squared));
      list.push_back({e.name, e.drag == Drag::linear ? "linear" : "quadratic", fixed(1000 * e.step, 1), metres(meant),
                      metres(length(e.end - squared)), nanoseconds(ns), quartiles(e.each),
                      fixed(1e-3 * ns * kFlown / e.step, 2)});
    }
    return list;
  }

 private:
  void measure() {
    std::vector<std::function<void()>> turns;
    for (Engine& e : engines_) {
      e.steps = std::max(1, static_cast<int>(4e6 / (static_cast<double>(kMany) * e.guess_ns)));
      turns.push_back([&e] {
        for (int i = 0; i < e.steps; ++i) e.go();
      });
    }
    for (const auto& turn : turns) turn();
    const auto taken = take_turns(options_.clock, options_.rounds, turns);
    for (std::size_t i = 0; i < engines_.size(); ++i)
      engines_[i].each = each_ns(taken[i], static_cast<double>(kMany) * engines_[i].steps);
  }

  Options options_;
  std::vector<Engine> engines_;
  std::vector<std::unique_ptr<PeerWorld>> peers_;
  std::vector<std::unique_ptr<World>> worlds_;
  std::vector<WorldColumns> columns_{};
  std::size_t read_ = 0;
};

void add_engines(Comparison& all) {
  const auto rule = [&](const char* name, EngineRule r, double step) {
    all.add(name, step, Drag::linear, 1, [r](const auto& list) {
      return rule_world(r, physics_of(Drag::linear), static_cast<float>(rate()), list);
    });
  };
  rule("Unity's rule", EngineRule::unity, kUnity);
  rule("Unity 2D's rule", EngineRule::unity_2d, kUnity);
  rule("Godot's rule", EngineRule::godot, kUsual);
  rule("Jolt's rule", EngineRule::jolt, kUsual);
  rule("Box2D's rule, 4 sub-steps", EngineRule::box2d, kUsual);
  all.add("Bullet 3, btRigidBody", kUsual, Drag::linear, 1500,
          [](const auto& list) { return bullet_world(physics_of(Drag::linear), list, true); });
  if (!cyclone_commit()) return;
  for (const Drag drag : {Drag::linear, Drag::quadratic})
    all.add(drag == Drag::linear ? "Cyclone, damping" : "Cyclone, generators", kUsual, drag, 20,
            [drag](const auto& list) { return cyclone_world(physics_of(drag), list); });
}

void add_rungs(Comparison& all) {
  Fidelity f = Fidelity::classic();
  all.add("PhySim, classic (the first loop)", Drag::linear, 2, f);
  f = Fidelity::game();
  f.integrator = Integrator::semi_implicit_euler;
  f.precision = Precision::float32;
  f.drag = DragModel::damping;
  all.add("PhySim, semi-implicit Euler", Drag::linear, 1, f);
  f.motion = Motion::closed_form;
  all.add("PhySim, closed form", Drag::linear, 1, f);
  f.motion = Motion::force;
  f.drag = DragModel::linear_quadratic;
  all.add("PhySim, semi-implicit Euler", Drag::quadratic, 1, f);
  f.integrator = Integrator::heun;
  all.add("PhySim, Heun", Drag::quadratic, 2, f);
  f.integrator = Integrator::rk4;
  all.add("PhySim, RK4", Drag::quadratic, 5, f);
  f.precision = Precision::float64;
  all.add("PhySim, RK4, double", Drag::quadratic, 10, f);
  f.integrator = Integrator::tsit5;
  all.add("PhySim, Tsit5, double", Drag::quadratic, 100, f);
  f.integrator = Integrator::dop853;
  all.add("PhySim, DOP853, double", Drag::quadratic, 300, f);
}

}  // namespace

Section engines_section(const Options& options) {
  Comparison all(options);
  add_engines(all);
  add_rungs(all);
  Section s;
  s.title = "One shot by other engines' rules";
  s.intro =
      "The first PhySim's bullet: 2 kg, (35, 5) m/s, gravity 2 m/s^2, damping 0.9 a second, 5 s. Linear drag is what a "
      "damping means, dv/dt = -c v with c = -ln 0.9; quadratic drag is that of a body in air, as strong at the muzzle. "
      "How far each is from the drag that it means, how far from the quadratic one, and what it costs for one of " +
      std::to_string(kMany) + " on one thread.";
  s.columns = {"engine",        "drag it means",        "step [ms]", "off what it means",
               "off quadratic", "ns a projectile-step", "quartiles", "us for the 5 s"};
  s.rows = all.rows();
  const char* const commit = cyclone_commit();
  s.notes = {
      "Rules: formulas of the engines' documentation in plain loops over arrays, float32 (bench/engine_rules.hpp names "
      "the pages). Their cost is that of the formula alone; an engine's own step is that of Bullet 3 or so. Bullet 3 "
      "is "
      "the library, with its detection of collisions.",
      commit ? std::string("Cyclone: its own sources at ") + commit + ", in double as they come: position before " +
                   "velocity. Damping: its particle's acceleration and damping power. Generators: ParticleGravity and "
                   "ParticleDrag."
             : "Cyclone is left out: ./dev bench --cyclone FOLDER, with a checkout of idmillington/cyclone-physics.",
      "PhySim: a World that is stepped, and all positions read after each step. Exact: the closed form of linear drag; "
      "of quadratic drag Runge and Kutta's method by steps of 50 us."};
  return s;
}

}  // namespace physim::bench
