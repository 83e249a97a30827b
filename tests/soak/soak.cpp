// Soak: a crowded world in which everything changes at random, for as many projectile-steps as asked.
//
//   physim_soak [PROJECTILE_STEPS] [PROJECTILES] [SEED]
//
// Spawns, despawns, forces that come and go, fidelity moves, impulses, switches, snapshots and numbers that overflow.
// Fails where the memory held grows after the first third of 10^8 or more, or where a projectile that stays in the
// world has bad numbers. It is meant to run under the sanitizers: ./dev soak --asan, ./dev soak --tsan.
#include <cmath>
#include <cstdlib>
#include <random>

#include "physim/world.hpp"
#include "soak/memory.hpp"

namespace {

using namespace physim;
using soak::resident_bytes;

class Soak {
 public:
  Soak(std::size_t projectiles, unsigned seed) : projectiles_(projectiles), random_(seed), world_(make_world()) {
    ProjectileDef bullet{
        .mass = 0.01, .diameter = 0.008, .drag = {.table = DragTable::g7, .ballistic_coefficient = 170}};
    ProjectileDef stone{.drag = {.damping = 0.95}};
    for (const Fidelity& f : rungs_) {
      bullet.fidelity = stone.fidelity = f;
      kinds_.push_back(*world_.add_kind(bullet));
      BodyDef body{.despawn = {.older = 3}};
      kinds_.push_back(*world_.add_kind(stone, body));
    }
  }

  void step() {
    for (std::size_t i = 0; world_.size() < projectiles_ && i < projectiles_ / 16 + 1; ++i) spawn();
    for (std::size_t i = 0; i < projectiles_ / 100 + 1; ++i) change();
    if (pick(50) == 0) force();
    if (pick(100) == 0 && !forces_.empty()) drop_force();
    if (pick(200) == 0) moment();
    if (pick(40) == 0) world_.set_observer(direction() * 100.0);
    if (pick(3) == 0)
      world_.step(0.005 + 0.02 * uniform());
    else
      world_.advance(1.0 / 60);
    forget_the_gone();
  }

  [[nodiscard]] std::uint64_t projectile_steps() const { return done_before_ + world_.counters().projectile_steps; }
  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] bool all_finite() const {
    for (const ProjectileId id : world_.ids()) {
      const BodyState s = world_[id].state();
      for (const double x : {s.position.x, s.position.y, s.position.z, s.velocity.x, s.velocity.y, s.velocity.z})
        if (!std::isfinite(x)) return false;
    }
    return true;
  }

 private:
  static World make_world() {
    WorldDef def{.ground = {.mode = GroundMode::bounce},
                 .apex_events = true,
                 .pools = {{"all", 4'000'000, WhenFull::refuse}},
                 .detail = {.rungs = {{Fidelity::constant_air(), 80}, {Fidelity::game(), 300}, {Fidelity::arcade()}},
                            .layers = 2},
                 .threading = {.threads = 3, .rows_per_thread = 256}};
    auto made = World::create(def);
    if (!made) std::fprintf(stderr, "%s\n", made.error().text().c_str()), std::exit(1);
    return std::move(made.value());
  }

  unsigned pick(unsigned below) { return static_cast<unsigned>(random_() % below); }
  double uniform() { return static_cast<double>(random_()) / 4294967296.0; }
  Vec3d direction() { return {uniform() * 2 - 1, uniform(), uniform() * 2 - 1}; }

  /// Three of four are of the cheap rungs, as in a game: so many steps do not take days.
  KindId some_kind() {
    const auto cheap = 2u * kCheapRungs;
    return kinds_[pick(pick(4) == 0 ? static_cast<unsigned>(kinds_.size()) : cheap)];
  }

  void spawn() {
    Launch launch{.position = direction() * 20.0};
    // One in a thousand overflows.
    launch.velocity = direction() * (pick(1000) == 0 ? 1e306 : 200 * uniform());
    const double delay = pick(20) == 0 ? uniform() : 0;
    if (const auto id = world_.spawn(some_kind(), launch, delay)) ids_.push_back(*id);
  }

  void change() {
    if (ids_.empty()) return;
    const ProjectileId id = ids_[pick(static_cast<unsigned>(ids_.size()))];
    switch (pick(15)) {
      case 0: return void(world_[id].despawn());
      case 1:
      case 2: return void(world_[id].set_fidelity(rungs_[pick(static_cast<unsigned>(std::size(rungs_)))]));
      case 3: return void(world_[id].apply_impulse(direction()));
      case 4: return void(world_[id].set_gravity_scale(2 * uniform()));
      case 5: return void(world_[id].set_kinematic(pick(2) == 0));
      case 6: return void(world_[id].set_frozen(pick(4) == 0 ? Axes::z : Axes::none, Axes::none));
      case 7: return void(pick(2) == 0 ? world_[id].sleep() : world_[id].wake());
      case 8: return void(world_[id].set_layers(1u << pick(3)));
      case 9: return void(world_[id].set_angular_velocity(direction()));
      case 10: return void(world_[id].set_label("marked"));
      case 11: {
        BodyDef body = world_[id].body();
        body.gravity_scale = 2 * uniform();
        body.kinematic = pick(3) == 0;
        return void(world_[id].set_body(body));
      }
      case 12: return void(world_[id].set_mass(0.1 + uniform()));
      case 13: return void(world_[id].set_damping(pick(20) == 0 ? 0 : 1 - 0.5 * uniform()));
      default: return void(world_[id].set_state({direction() * 10.0, direction() * 30.0}));
    }
  }

  void force() {
    if (ids_.empty() || forces_.size() > 40) return;
    ForceDef f;
    const auto any = [&] { return ids_[pick(static_cast<unsigned>(ids_.size()))]; };
    for (int i = 0; i < 20; ++i) f.target.ids.push_back(any());
    if (pick(4) == 0) f.target.layers = 4;
    f.duration = 2 * uniform();
    switch (pick(6)) {
      case 0: f.law = ConstantForce{direction()}; break;
      case 1: f.law = Spring{any(), 0.5, 2, 0.01}; break;
      case 2: f.law = PointAttractor{direction(), 50, 1}; break;
      case 3: f.law = WindZone{{10, 0, 0}, {-20, 0, -20}, {20, 20, 20}}; break;
      case 4: f.law = Explosion{direction(), 5, 10}; break;
      default:
        f.law = CustomForce{[](const ForceBatch& b) {
          for (std::size_t i = 0; i < b.force.size(); ++i) b.force[i] += b.velocity[i] * (-0.01 * b.mass[i]);
        }};
    }
    if (const auto id = world_.add_force(f)) forces_.push_back(*id);
  }

  void drop_force() {
    const unsigned i = pick(static_cast<unsigned>(forces_.size()));
    world_.remove_force(forces_[i]);
    forces_[i] = forces_.back();
    forces_.pop_back();
  }

  /// Some steps into the future, and back.
  void moment() {
    const std::uint64_t before = world_.hash();
    const Snapshot now = world_.snapshot();
    for (int i = 0; i < 3; ++i) world_.step(1.0 / 60);
    done_before_ += world_.counters().projectile_steps;
    world_.restore(now);
    done_before_ -= world_.counters().projectile_steps;
    if (world_.hash() != before) std::fprintf(stderr, "soak: a restored world differs\n"), std::exit(1);
  }

  void forget_the_gone() {
    std::erase_if(ids_, [this](ProjectileId id) { return !world_[id].is_alive(); });
    std::erase_if(forces_, [this](ForceId id) { return !world_.is_active(id); });
  }

  const Fidelity rungs_[6] = {Fidelity::arcade(),       Fidelity::game(),       Fidelity::classic(),
                              Fidelity::constant_air(), Fidelity::small_arms(), Fidelity::artillery()};
  static constexpr unsigned kCheapRungs = 3;  // the first ones
  std::size_t projectiles_;
  std::mt19937 random_;
  World world_;
  std::vector<KindId> kinds_;
  std::vector<ProjectileId> ids_;
  std::vector<ForceId> forces_;
  std::uint64_t done_before_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const double target = argc > 1 ? std::atof(argv[1]) : 2e6;
  const double projectiles = argc > 2 ? std::atof(argv[2]) : 5000;
  const unsigned seed = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1;
  if (!(target >= 1 && target <= 1e13) || !(projectiles >= 1 && projectiles <= 4e6)) {
    std::fprintf(stderr, "usage: physim_soak [PROJECTILE_STEPS] [PROJECTILES] [SEED]\n");
    return 2;
  }
  Soak crowd(static_cast<std::size_t>(projectiles), seed);
  soak::Memory memory(target);
  std::uint64_t next_report = 0;
  while (static_cast<double>(crowd.projectile_steps()) < target) {
    crowd.step();
    const std::uint64_t done = crowd.projectile_steps();
    memory.look(static_cast<double>(done));
    if (done < next_report) continue;
    next_report = done + static_cast<std::uint64_t>(target / 10);
    if (!crowd.all_finite()) {
      std::fprintf(stderr, "soak: a projectile with bad numbers stayed in the world\n");
      return 1;
    }
    std::printf("%12llu projectile-steps, %zu projectiles, %zu cohorts, %.1f MB held, %.1f MB resident\n",
                static_cast<unsigned long long>(done), crowd.world().size(), crowd.world().cohorts().size(),
                memory.held(), static_cast<double>(resident_bytes()) / 1e6);
    std::fflush(stdout);
  }
  const WorldCounters& counters = crowd.world().counters();
  std::printf(
      "steps %llu, retired for bad numbers %llu, refused %llu; held at most %.1f MB in the first third, %.1f MB in "
      "all\n",
      static_cast<unsigned long long>(counters.steps), static_cast<unsigned long long>(counters.retired),
      static_cast<unsigned long long>(counters.refused), memory.early(), memory.most());
  // A young world still grows: kinds, rungs and cohorts meet for the first time.
  if (target >= 1e8 && memory.grows()) {
    std::fprintf(stderr, "soak: memory grows\n");
    return 1;
  }
  return 0;
}
