// What a step costs on other rungs, with ground and with events, beside the game preset.
#include "world_bench.hpp"

namespace physim::bench {
namespace {

SteppedWorld free_entry(std::string name, const std::vector<Fidelity>& fidelities) {
  return {std::move(name), world_of(free_flight(), fidelities, kStepped)};
}

Fidelity with_precision(Fidelity f, Precision precision) {
  f.precision = precision;
  return f;
}

/// Balls that hop on a plane, a tenth of a second each.
SteppedWorld bouncing_entry() {
  WorldDef def = free_flight();
  def.ground.mode = GroundMode::bounce;
  World world = std::move(World::create(def).value());
  BodyDef body;
  body.restitution = 0.999;
  body.friction = 0;
  body.can_sleep = false;
  const KindId kind = *world.add_kind(world_bullet(Fidelity::game()), body);
  world.reserve(kind, kStepped);
  for (std::size_t i = 0; i < kStepped; ++i) {
    Launch launch = volley_launch(i);
    const double climb = 0.5 - static_cast<double>(i % 1000) / 1000;  // all parts of a hop
    launch.position.y = (0.25 - climb * climb) / (2 * 9.80665) + 1e-4;
    launch.velocity = Vec3d{5, climb, 0};
    world.spawn(kind, launch);
  }
  return {"game, bouncing ground", std::move(world)};
}

std::vector<SteppedWorld> entries() {
  std::vector<SteppedWorld> list;
  list.push_back(free_entry("game", {Fidelity::game()}));
  Fidelity no_drag = Fidelity::game();
  no_drag.drag = DragModel::off;
  list.push_back(free_entry("game without drag", {no_drag}));
  list.push_back(free_entry("game in double", {with_precision(Fidelity::game(), Precision::float64)}));
  list.push_back(free_entry("arcade (closed form)", {Fidelity::arcade()}));
  list.push_back(free_entry("classic", {Fidelity::classic()}));
  list.push_back(free_entry("G7, standard air, semi-implicit", {curve_fidelity(Integrator::semi_implicit_euler)}));
  list.push_back(free_entry("G7, standard air, RK4", {curve_fidelity(Integrator::rk4)}));
  list.push_back(free_entry("G7, standard air, RK4, double",
                            {with_precision(curve_fidelity(Integrator::rk4), Precision::float64)}));
  list.push_back(free_entry("small_arms (Tsit5, double)", {Fidelity::small_arms()}));
  list.push_back(free_entry("16 fidelities mixed", sixteen_fidelities()));
  list.push_back(bouncing_entry());
  list.push_back(with_apexes("game, apex events", Fidelity::game()));
  list.push_back(landing("game, 1 % land and are replaced", Fidelity::game()));
  return list;
}

}  // namespace

Section rungs_section(const Options& options) {
  Section s = steps_section(entries(), "game", "rung", options);
  s.title = "Worlds: rungs, ground and events";
  s.notes = {
      "Mixed: semi-implicit and explicit Euler, no drag, damping, linear and quadratic, G7 in standard air, "
      "constant gravity and Newton's, float."};
  return s;
}

}  // namespace physim::bench
