// Worlds whose projectiles meet the things of a scene: what a step costs near them and far from them.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "cast_scenes.hpp"
#include "sections.hpp"
#include "world_bench.hpp"

namespace physim::bench {
namespace {

constexpr std::size_t kBullets = 100000;
constexpr double kStep = 1.0 / 60;  // bullets of 300 to 900 m/s fly 5 to 15 m in it
constexpr double kSide = kSpacing * (kPoints - 1);

double height_at(double x, double z) {
  return ground(static_cast<std::uint32_t>(x / kSpacing), static_cast<std::uint32_t>(z / kSpacing));
}

Vec3d vec(const float (&p)[3]) { return {p[0], p[1], p[2]}; }

/// Bullets whose first step is one of the segments that are cast; with `clear` steps, only those that meet nothing in
/// so many.
std::vector<Launch> low_launches(const Scene& scene, std::size_t count, int clear) {
  std::vector<Launch> launches;
  for (const CastSegment& s : segments_over(clear > 0 ? 8 * count : count, kSide, kSide, height_at)) {
    const Vec3d from = vec(s.from), way = vec(s.to) - from;
    if (clear > 0 && scene.any_hit({from, from + way * (clear + 0.5), 0.5})) continue;
    Launch launch;
    launch.position = from;
    launch.velocity = way * (1 / kStep);
    launches.push_back(launch);
    if (launches.size() == count) return launches;
  }
  std::fputs("scene_worlds: too few bullets fly clear of the ground\n", stderr), std::exit(1);
}

/// They fly level, half a kilometre above the highest hill.
std::vector<Launch> high_launches(std::size_t count) {
  std::vector<Launch> launches = volley(count);
  for (Launch& launch : launches) launch.position.y = 550, launch.velocity->y = 20;
  return launches;
}

World world_over(const Scene* scene, const std::vector<Launch>& launches, unsigned threads) {
  WorldDef def = free_flight();
  def.threading.threads = threads;
  World world = std::move(World::create(def).value());
  BodyDef body;
  body.collision.on_hit = OnHit::bounce;
  body.restitution = 0.9;
  const KindId kind = *world.add_kind(world_bullet(Fidelity::game()), body);
  if (scene && !world.set_scene(*scene)) std::fputs("scene_worlds: no scene\n", stderr), std::exit(1);
  std::vector<ProjectileId> ids(launches.size());
  world.spawn(kind, launches, ids);
  return world;
}

/// Crates of 2 m near the ground that go level at 5 m/s, each another way.
Transform crate(std::size_t i, double time) {
  const auto part = [](double x) { return x - std::floor(x); };
  const double n = static_cast<double>(i) + 0.5, angle = 2.4 * n;
  const double x = kSide * part(0.7548776662466927 * n), z = kSide * part(0.5698402909980532 * n);
  return {.position = {x + 5 * time * std::cos(angle), height_at(x, z) + 2, z + 5 * time * std::sin(angle)}};
}

/// Who takes crates along: their paths, or whoever moves them before each step.
enum class Moved { by_path, by_caller };

std::vector<InstanceId> add_crates(World& world, std::size_t count, Moved moved) {
  std::vector<InstanceId> crates;
  if (count == 0) return crates;  // the world may have no scene
  const ShapeId shape = world.add_shape(BoxShape{{1, 1, 1}}).value();
  for (std::size_t i = 0; i < count; ++i) {
    InstanceDef def{.shape = shape, .transform = crate(i, 0)};
    if (moved == Moved::by_path) def.motion = SteadyMotion{.velocity = crate(i, 1).position - crate(i, 0).position};
    crates.push_back(world.add_instance(def).value());
  }
  return crates;
}

/// Steps from one moment on, again and again.
struct Entry {
  std::string name;
  World world;
  int steps = 1;
  std::vector<InstanceId> crates = {};  // that are moved before each step
  Snapshot begin = {};
  double hits = 0, taken = 0;  // of all turns

  void step() {
    for (std::size_t i = 0; i < crates.size(); ++i)
      static_cast<void>(world.move_instance(crates[i], crate(i, world.time() + kStep)));
    world.step(kStep);
  }
  /// Seconds of one turn.
  double turn(Clock clock) {
    world.restore(begin);
    const double seconds_taken = seconds(clock, [&] {
      for (int i = 0; i < steps; ++i) {
        step();
        for (const Event& e : world.events()) hits += e.kind == EventKind::hit ? 1 : 0;
      }
    });
    taken += steps;
    return seconds_taken;
  }
};

std::vector<Entry> entries(const Scene& land, const Scene& field, std::size_t count) {
  std::vector<Entry> list;
  const auto add = [&](std::string name, const Scene* scene, const std::vector<Launch>& launches, int steps, int warm,
                       std::size_t crates = 0, Moved moved = Moved::by_path) {
    list.push_back({std::move(name), world_over(scene, launches, 1), steps});
    Entry& e = list.back();
    std::vector<InstanceId> added = add_crates(e.world, crates, moved);
    if (moved == Moved::by_caller) e.crates = std::move(added);
    for (int i = 0; i < warm; ++i) e.step();
    e.begin = e.world.snapshot();
  };
  const std::vector<Launch> clear = low_launches(field, count, 5), low = low_launches(field, count, 0);
  const std::vector<Launch> high = high_launches(count);
  // From launch on: what rows find out about the way ahead is paid for within the steps that it serves.
  add("no scene", nullptr, clear, 5, 0);
  add("mesh, near the ground, none meets it", &land, clear, 5, 0);
  add("mesh, near the ground, a third meets it", &land, low, 1, 0);
  add("height field, near the ground, none meets it", &field, clear, 5, 0);
  add("height field, near the ground, a third meets it", &field, low, 1, 0);
  add("no scene, high up", nullptr, high, 60, 20);
  add("mesh, high above it", &land, high, 60, 20);
  add("height field, high above it", &field, high, 60, 20);
  add("mesh, near the ground, one thing moves", &land, clear, 5, 0, 1);
  add("mesh, near the ground, 200 things move", &land, clear, 5, 0, 200);
  add("mesh, near the ground, 200 things are moved before each step", &land, clear, 5, 0, 200, Moved::by_caller);
  add("mesh, high above it, one thing moves", &land, high, 60, 20, 1);
  add("mesh, high above it, 200 things move", &land, high, 60, 20, 200);
  add("mesh, high above it, 200 things are moved before each step", &land, high, 60, 20, 200, Moved::by_caller);
  return list;
}

void add_world_rows(const Options& options, const Scene& land, const Scene& field, Section& s) {
  const std::size_t count = options.quick ? kBullets / 10 : kBullets;
  std::vector<Entry> list = entries(land, field, count);
  std::vector<std::vector<double>> taken(list.size());
  for (int round = 0; round < options.rounds; ++round)
    for (std::size_t i = 0; i < list.size(); ++i) taken[i].push_back(list[i].turn(options.clock));
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Entry& e = list[i];
    const auto each = each_ns(taken[i], static_cast<double>(count) * e.steps);
    s.rows.push_back({e.name, fixed(static_cast<double>(count), 0), nanoseconds(median(each)), quartiles(each),
                      percent(e.hits / (e.taken * static_cast<double>(count)))});
  }
}

/// On the clock on the wall, whatever the others are timed by: two threads have two clocks of their own.
void add_threads_row(const Options& options, const Scene& land, Section& s) {
  const std::size_t count = options.quick ? kBullets / 10 : kBullets;
  const std::vector<Launch> launches = low_launches(land, count, 5);
  World one = world_over(&land, launches, 1), two = world_over(&land, launches, 2);
  const Snapshot begin_one = one.snapshot(), begin_two = two.snapshot();
  const auto steps = [](World& world, const Snapshot& begin) {
    for (int i = 0; i < 10; ++i) {
      world.restore(begin);
      for (int k = 0; k < 5; ++k) world.step(kStep);
    }
  };
  std::vector<double> threads, processes;
  for (int round = 0; round < options.rounds; ++round) {
    threads.push_back(seconds(Clock::wall, [&] { steps(two, begin_two); }));
    processes.push_back(seconds_of_two([&] { steps(one, begin_one); }));
  }
  const auto each = each_ns(threads, 50 * static_cast<double>(count));
  s.rows.push_back({"mesh, near the ground, two threads", fixed(static_cast<double>(count), 0),
                    nanoseconds(median(each)), quartiles(each), ""});
  s.notes.push_back("Two threads do " + fixed(0.5 * median(ratios(processes, threads)), 2).text +
                    " of what two processes of one thread each do at the same time, on the clock on the wall.");
}

/// A hundred of ten thousand houses go and a hundred come before each step.
void add_replaced_row(const Options& options, Section& s) {
  const std::size_t count = options.quick ? 1000 : 10000;
  const std::vector<CastPlace> places = streets(10000);
  const CastMesh building = house();
  std::vector<Launch> launches;
  for (const CastSegment& each : segments_over(count, 32 * 22.0, 312 * 24.0, [](double, double) { return 0.0; })) {
    Launch launch;
    launch.position = vec(each.from);
    launch.velocity = (vec(each.to) - vec(each.from)) * (1 / kStep);
    launches.push_back(launch);
  }
  Scene scene;
  const ShapeId shape = scene.add_shape(as_shape(building)).value();
  std::vector<InstanceId> houses;
  for (const CastPlace& place : places)
    houses.push_back(scene.add({.shape = shape, .transform = as_transform(place)}).value());
  World world = world_over(&scene, launches, 1);
  std::vector<double> replaced, stepped;
  std::size_t next = 0;
  for (int round = 0; round < 4 * options.rounds; ++round) {
    replaced.push_back(seconds(options.clock, [&] {
      for (int i = 0; i < 100; ++i, next = (next + 1) % houses.size()) {
        static_cast<void>(world.remove_instance(houses[next]));
        houses[next] = world.add_instance({.shape = shape, .transform = as_transform(places[next])}).value();
      }
    }));
    stepped.push_back(seconds(options.clock, [&] { world.step(kStep); }));
  }
  const auto row = [&](const char* name, const std::vector<double>& each, const char* what) {
    s.rows.push_back({name, what, nanoseconds(median(each)), quartiles(each), ""});
  };
  row("town of 10 000, 100 replaced before each step: a replacement", each_ns(replaced, 100), "100 houses");
  row("town of 10 000, 100 replaced before each step: the step", each_ns(stepped, static_cast<double>(count)),
      count == 1000 ? "1000" : "10000");
}

}  // namespace

Section scene_worlds_section(const Options& options) {
  Section s;
  s.title = "Scenes: worlds";
  s.intro =
      "Bullets of the game preset over the terrain, each 5 to 15 m a step of 1/60 s, stepped by one thread: 0.2 to 9 m "
      "above the ground, from launch on as long as none of them meets it, or half a kilometre above it. What moves are "
      "crates of 2 m at 5 m/s near the ground. All that a step does, and the calls that move crates before it.";
  s.columns = {"world", "projectiles", "ns a projectile-step", "quartiles", "hits"};
  const Scene land = scene_of(terrain(kPoints), {}), field = field_scene();
  add_world_rows(options, land, field, s);
  add_threads_row(options, land, s);
  add_replaced_row(options, s);
  return s;
}

}  // namespace physim::bench
