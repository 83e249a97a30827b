// Extreme numbers: sensible questions to flights, aims, fits, studies, worlds, scenes, forces, emitters and joints, in
// which one number or a few are far from what is usual: 1e-300, 1e300, subnormal, zero, as large as a double holds.
//
//   physim_extreme_fuzz [COUNT [SEED [FIRST]]]
//
// Each is refused with words, or answered with finite numbers or with an outcome that says that there are none. None
// aborts, and none takes more than kPatience of processor time.
#include <sys/time.h>
#include <unistd.h>

#include <csignal>

#include "fuzz/arguments.hpp"
#include "fuzz/odd_input.hpp"
#include "fuzz/verdict.hpp"
#include "random_emitters.hpp"

namespace physim::test {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int kPatience = 300;  // [s]
#else
constexpr int kPatience = 20;  // [s]
#endif

const char* part_at_work = "";

/// Names the case before the program ends.
extern "C" void give_up(int signal) {
  char text[120];
  const int length =
      std::snprintf(text, sizeof text, "world %ld: signal %d in %s\n", case_number, signal, part_at_work);
  static_cast<void>(::write(STDOUT_FILENO, text, static_cast<std::size_t>(length)) == length);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

class Extreme {
 public:
  explicit Extreme(std::uint64_t seed) : r_(seed, 0) {}

  void play() {
    static constexpr struct {
      const char* name;
      void (Extreme::*play)();
    } kParts[] = {{"fly", &Extreme::fly_one},
                  {"fly", &Extreme::fly_one},
                  {"batch", &Extreme::fly_many},
                  {"columns", &Extreme::columns},
                  {"aim", &Extreme::aim_at},
                  {"choose", &Extreme::choose},
                  {"fit", &Extreme::measure},
                  {"study", &Extreme::study},
                  {"tables", &Extreme::tables},
                  {"world", &Extreme::world},
                  {"scene", &Extreme::scene},
                  {"scene", &Extreme::scene},
                  {"flight in a scene", &Extreme::fly_in_scene},
                  {"forces", &Extreme::forces},
                  {"emitters", &Extreme::emitters},
                  {"emitters", &Extreme::emitters},
                  {"joints", &Extreme::joints},
                  {"impact", &Extreme::strike},
                  {"frames", &Extreme::frames}};
    const auto& part = kParts[r_.below(std::size(kParts))];
    part_at_work = part.name;
    (this->*part.play)();
  }

 private:
  // ------------------------------------------------------------------------------------------------------------ input
  /// What a question is made of; each as it comes, or with extreme numbers.
  struct Question {
    ProjectileDef projectile;
    Launch launch;
    Environment environment;
    Fidelity fidelity;
    Tolerance tolerance;
    Until until;
  };
  template <class Def>
  Def maybe_extreme(Def def, int one_in = 2) {
    if (r_.one_in(one_in)) put_extremes(r_, def);
    return def;
  }
  Question question() {
    Question q{r_.projectile(), r_.launch(), r_.environment(), r_.fidelity(), r_.tolerance(), r_.until()};
    if (r_.one_in(3)) q.fidelity = q.projectile.fidelity = Fidelity{};
    put_extremes(r_, q);
    if (q.tolerance.max_steps > 100000) q.tolerance.max_steps = 100000;  // so many are asked for
    return q;
  }

  // ---------------------------------------------------------------------------------------------------------- flights
  void check(const Flight& flight) {
    ++tally.flights, tally.flown += flight.outcome() != Outcome::refused;
    expect((flight.outcome() == Outcome::refused) == flight.error().has_value(), "a refusal without a reason");
    expect(flight.outcome() != Outcome::refused || !flight.error()->message.empty(), "a refusal without words");
    expect(std::isfinite(flight.duration()), "a flight without a duration");
    for (const double time : {flight.duration() * r_.unit(), 0.0, flight.duration(), extreme(r_, 1)}) {
      const Sample s = flight.at(time);
      expect(is_finite(s.position) && is_finite(s.velocity) && std::isfinite(s.time), "a sample that is not finite");
      static_cast<void>(flight.accelerations(time)), static_cast<void>(flight.stability(time));
    }
    static_cast<void>(flight.at_range(extreme(r_, 100))), static_cast<void>(flight.at_range(r_.in(-10, 300)));
    static_cast<void>(flight.at_height(extreme(r_, 1), Crossing::falling));
    static_cast<void>(danger_space(flight, extreme(r_, 100), extreme(r_, 1)));
    for (const Event& e : flight.events()) expect(std::isfinite(e.time) && is_finite(e.position), "an event nowhere");
  }
  void fly_one() {
    const Question q = question();
    check(fly(q.projectile, q.launch, q.environment, q.fidelity, q.tolerance, q.until));
  }
  static void check(const BatchResult& result, std::size_t shots) {
    expect(result.shots.size() == shots, "a batch of another size");
    for (const ShotResult& shot : result.shots) {
      ++tally.flights, tally.flown += shot.outcome != Outcome::refused;
      const bool none = shot.outcome == Outcome::refused;
      expect(none || (std::isfinite(shot.time) && is_finite(shot.position) && is_finite(shot.velocity)),
             "the end of a shot is not finite");
      expect(!none || result.error.has_value(), "a refused shot without a reason");
    }
  }
  void fly_many() {
    const Question q = question();
    std::vector<Shot> shots(static_cast<std::size_t>(1 + r_.below(6)));
    for (Shot& shot : shots) shot = {q.projectile, maybe_extreme(r_.launch())};
    if (r_.one_in(3)) shots[0].projectile = maybe_extreme(r_.projectile());
    check(fly_batch(shots, q.environment, q.fidelity, q.tolerance, q.until), shots.size());
    std::vector<Launch> launches(static_cast<std::size_t>(r_.below(20)), q.launch);
    if (!launches.empty()) put_extremes(r_, launches);
    BatchResult result;
    fly_batch(q.projectile, launches, q.environment, q.fidelity, q.tolerance, q.until, result);
    check(result, launches.size());
  }
  void columns() {
    const Question q = question();
    const auto count = static_cast<std::size_t>(1 + r_.below(20));
    struct Given {
      std::vector<double> speed, elevation, y, wind, temperature, pressure, humidity, density, coefficient, factor;
    } given;
    const auto fill = [&](std::vector<double>& column, double low, double high, bool wanted = false) {
      if (!wanted && r_.one_in(2)) return;
      for (std::size_t i = 0; i < count; ++i) column.push_back(r_.in(low, high));
    };
    fill(given.speed, 1, 900, true), fill(given.elevation, -0.1, 1), fill(given.y, 0, 30), fill(given.wind, -9, 9);
    fill(given.temperature, 250, 310), fill(given.pressure, 5e4, 1e5), fill(given.humidity, 0, 1);
    fill(given.density, 0.1, 2), fill(given.coefficient, 1, 500), fill(given.factor, 0.1, 3);
    put_extremes(r_, given);
    const LaunchColumns from{.common = {.position = {0, 5, 0}},
                             .y = given.y,
                             .speed = given.speed,
                             .elevation = given.elevation,
                             .ballistic_coefficient = given.coefficient,
                             .form_factor = given.factor};
    const Weather weather{.wind_z = given.wind,
                          .temperature = given.temperature,
                          .pressure = given.pressure,
                          .humidity = given.humidity,
                          .density = given.density};
    std::vector<double> time(count), x(count);
    const ColumnsResult ends = fly_columns(q.projectile, from, q.environment, q.fidelity, q.tolerance, q.until,
                                           {.time = time, .x = x}, nullptr, weather);
    expect((ends.refused > 0) == ends.error.has_value(), "columns refused without a reason");
  }
  void aim_at() {
    Question q = question();
    q.tolerance.max_steps = std::min<std::int64_t>(q.tolerance.max_steps, 2000);
    const Target target = maybe_extreme(Target{r_.vector3(200), r_.vector3(10), {}});
    AimOptions options = maybe_extreme(r_.aim_options());
    options.flight.max_steps = std::clamp<std::int64_t>(options.flight.max_steps, 1, 2000);
    if (const auto answer = aim(q.projectile, q.launch, q.environment, q.fidelity, target, options)) {
      expect(!answer->explanation().empty(), "an aim without words");
      expect(answer->in_reach() || std::isfinite(answer->nearest.miss), "a miss by no number");
    }
    const auto number = [&](double x) { return r_.one_in(3) ? extreme(r_, x) : x; };
    static_cast<void>(
        max_range(q.projectile, q.launch, q.environment, q.fidelity, number(-5), number(0.1), number(30)));
    static_cast<void>(time_to_range(q.projectile, q.launch, q.environment, q.fidelity, number(100)));
    static_cast<void>(zero_elevation(q.projectile, q.launch, q.environment, q.fidelity, number(100)));
  }
  void choose() {
    const Question q = question();
    Purpose purpose = maybe_extreme(r_.purpose());
    purpose.tolerance.max_steps = std::clamp<std::int64_t>(purpose.tolerance.max_steps, 1, 2000);
    if (const auto answer = cheapest_within(q.projectile, q.launch, q.environment, purpose)) {
      expect(!answer->explanation().empty(), "a choice without words");
      check(fly_chosen(q.projectile, q.launch, q.environment, *answer, q.until));
    }
    AutoFidelityCache cache(2);
    static_cast<void>(cache.cheapest_within(q.projectile, q.launch, q.environment, purpose));
    static_cast<void>(pilot_step(q.projectile, q.launch, q.environment, q.fidelity, q.tolerance, q.until));
  }
  void measure() {
    const Question q = question();
    std::vector<Measurement> measured(static_cast<std::size_t>(1 + r_.below(3)));
    for (Measurement& m : measured) m = {r_.in(1, 200), r_.maybe(10, 300), r_.maybe(-2, 0), r_.maybe(0, 2)};
    if (r_.one_in(2)) put_extremes(r_, measured);
    static_cast<void>(fit_drag(q.projectile, q.launch, q.environment, q.fidelity, measured,
                               maybe_extreme(FitOptions{r_.coin(), 0.5, 0.5, 0.5})));
    const FlightSetting settings[] = {{q.fidelity, q.tolerance}, {r_.fidelity(), maybe_extreme(r_.tolerance())}};
    static_cast<void>(compare(q.projectile, q.launch, q.environment, settings, {q.fidelity, q.tolerance}, q.until));
  }
  void tables() {
    const DragDef drag = maybe_extreme(r_.drag());
    static_cast<void>(drag_coefficient(drag, r_.any<Interpolation>(), extreme(r_, 1)));
    static_cast<void>(sphere_drag_coefficient(extreme(r_, 1e4)));
    static_cast<void>(air_at(maybe_extreme(r_.environment()), extreme(r_, 1000)));
    static_cast<void>(moist_air_density(extreme(r_, 290), extreme(r_, 1e5), extreme(r_, 1)));
    static_cast<void>(moist_air_sound_speed(extreme(r_, 290), extreme(r_, 1e5), extreme(r_, 1)));
    static_cast<void>(stability_factor(maybe_extreme(r_.projectile()), maybe_extreme(r_.launch()), r_.environment()));
    const MotorDef motor = maybe_extreme(r_.motor());
    static_cast<void>(burn_time(motor)), static_cast<void>(total_impulse(motor)),
        static_cast<void>(specific_impulse(motor));
    static_cast<void>(thrust_at(motor, extreme(r_, 1))), static_cast<void>(propellant_left(motor, extreme(r_, 1)));
  }
  void frames() {
    const EarthFrames frames(maybe_extreme(r_.environment()), r_.any<EarthModel>());
    Vec3d x = r_.vector3(1e6), v = r_.vector3(1e3);
    put_extremes(r_, x), put_extremes(r_, v);
    const Geodetic place = frames.geodetic(x);
    static_cast<void>(frames.position(place)), static_cast<void>(frames.earth_fixed(x, v));
    static_cast<void>(frames.inertial(x, v, extreme(r_, 1))), static_cast<void>(frames.local(x, v));
    static_cast<void>(frames.ground_distance(x, v));
    static_cast<void>(frames.position({extreme(r_, 1), extreme(r_, 1), extreme(r_, 100)}));
  }
  void study() {
    Study study;
    const Question q = question();
    study.projectile = q.projectile, study.launch = q.launch, study.environment = q.environment;
    study.fidelity = q.fidelity, study.tolerance = q.tolerance, study.until = q.until;
    study.tolerance.max_steps = std::min<std::int64_t>(study.tolerance.max_steps, 2000);
    study.shots = 64, study.shard_shots = 32, study.group_sizes = {3};
    study.inputs = {{"shot.speed", NormalDistribution{0, r_.in(0.1, 3)}, DrawnFor::round, true},
                    {"shot.mass", UniformDistribution{0.01, 0.02}},
                    {"environment.wind.velocity.z", NormalDistribution{0, 2}},
                    {"shot.elevation", TriangularDistribution{0, 0.1, 0.2}}};
    study.inputs.resize(static_cast<std::size_t>(1 + r_.below(4)));
    study.targets = {{"plate", CircleTarget{{r_.in(-1, 1), r_.in(-1, 1)}, r_.in(0.1, 3)}}};
    study.sampling = static_cast<Sampling>(r_.below(3));
    if (r_.one_in(3)) study.over_inputs = 2;
    if (r_.coin()) put_extremes(r_, study.inputs);
    if (r_.one_in(3)) put_extremes(r_, study.targets);
    if (r_.one_in(4)) put_extremes(r_, study.aim);
    static_cast<void>(run_study(study));
  }
  void strike() {
    Impact hit{.mass = r_.in(0.005, 1),
               .diameter = r_.in(0.005, 0.1),
               .length = r_.in(0, 0.3),
               .velocity = {r_.in(10, 900), r_.in(-100, 0), 0},
               .normal = {-1, 0, 0},
               .thickness = r_.in(0.001, 0.1)};
    put_extremes(r_, hit);
    const auto result = impact(hit, maybe_extreme(r_.material()));
    if (!result) return expect(!result.error().message.empty(), "a refusal without words");
    expect(is_finite(result->velocity) && is_finite(result->spin) && std::isfinite(result->energy) &&
               std::isfinite(result->depth),
           "an impact of no numbers");
  }

  // ----------------------------------------------------------------------------------------------------------- worlds
  World make_world(int one_in) {
    WorldDef def = r_.world();
    def.max_projectiles = 300;
    if (r_.one_in(one_in)) put_extremes(r_, def);
    def.threading = {.threads = 1};
    def.max_steps = std::min(def.max_steps, 20u);
    Result<World> made = World::create(def);
    if (made) return std::move(*made);
    expect(!made.error().message.empty(), "a refusal without words");
    return World();
  }
  void spawn(World& w, int one_in, bool meets = false) {
    for (int i = 0, n = 1 + r_.below(4); i < n; ++i) {
      ProjectileDef projectile = r_.projectile();
      if (r_.one_in(2)) projectile.fidelity = Fidelity{};
      BodyDef body = r_.body();
      if (meets) body.collision.on_hit = static_cast<OnHit>(r_.below(5)), body.collision.radius = r_.in(0, 0.3);
      Launch launch = r_.launch();
      if (r_.one_in(one_in)) put_extremes(r_, projectile);
      if (r_.one_in(one_in)) put_extremes(r_, body);
      if (r_.one_in(one_in)) put_extremes(r_, launch);
      body.environment = body.pool = 0;
      const auto id = w.spawn(projectile, launch, body);
      if (id) ids_.push_back(*id), ++tally.spawned;
      expect(id || !id.error().message.empty(), "a refusal without words");
    }
  }
  void run(World& w) {
    for (int i = 0, n = 3 + r_.below(20); i < n; ++i) {
      const double dt = r_.one_in(12) ? extreme(r_, 0.01) : r_.in(0.001, 0.05);
      if (r_.one_in(4))
        w.advance(dt);
      else
        tally.steps += w.step(dt).ok();
      if (r_.one_in(6)) change(w);
      for (const Event& e : w.events()) {
        expect(std::isfinite(e.time), "an event at no time");
        expect(std::isfinite(length_squared(e.normal)) && std::isfinite(e.energy), "a hit of no numbers");
      }
    }
    for (const ProjectileId id : w.ids()) {
      const ProjectileView p = std::as_const(w)[id];
      expect(is_finite(p.position()) && is_finite(p.velocity()), "a projectile has bad numbers");
      static_cast<void>(p.mach()), static_cast<void>(p.accelerations()), static_cast<void>(p.orientation());
      static_cast<void>(p.resultant_force()), static_cast<void>(p.render_position());
    }
    expect(std::isfinite(w.time()), "a world at no time");
    if (!ids_.empty() && r_.one_in(4)) {
      Until until = r_.until();
      put_extremes(r_, until);
      check(w.predict(ids_[0], until, r_.one_in(3) ? extreme(r_, 0.01) : 0));
    }
    if (!r_.one_in(5)) return;
    const auto saved = w.save();
    if (!saved) return;
    const auto loaded = World::load(*saved);
    if (!loaded) return fault(("a save is refused: " + loaded.error().text()).c_str());
    expect(loaded->hash() == w.hash(), "a loaded world is another");
  }
  void change(World& w) {
    if (ids_.empty()) return;
    Projectile p = w[ids_[static_cast<std::size_t>(r_.below(static_cast<int>(ids_.size())))]];
    switch (r_.below(9)) {
      case 0: return void(p.set_position(maybe_extreme(r_.vector3(30))));
      case 1: return void(p.set_velocity(maybe_extreme(r_.vector3(90))));
      case 2: return void(p.apply_impulse(maybe_extreme(r_.vector3(3))));
      case 3: return void(p.set_angular_velocity(maybe_extreme(r_.vector3(30))));
      case 4: return void(p.set_body(maybe_extreme(p.body())));
      case 5: return void(p.set_fidelity(r_.fidelity()));
      case 6: return void(p.set_mass(maybe_extreme(Vec3d{r_.number(0, 9), 0, 0}).x));
      case 7: {
        const ProjectileDef* now = p.definition();
        return void(now && p.set_drag(maybe_extreme(*now).drag));
      }
      default: return void(w.set_observer(maybe_extreme(r_.vector3(30))));
    }
  }
  void world() {
    World w = make_world(3);
    spawn(w, 3);
    run(w);
  }
  Scene make_scene(int one_in) {
    Scene scene;
    static_cast<void>(scene.add_material(r_.one_in(one_in) ? maybe_extreme(r_.material(), 1) : r_.material()));
    for (int i = 0, n = 1 + r_.below(3); i < n; ++i) {
      ShapeDef def = r_.shape();
      if (r_.one_in(one_in)) put_extremes(r_, def);
      const auto shape = scene.add_shape(def);
      if (!shape) continue;
      InstanceDef thing{.shape = *shape, .transform = r_.transform(), .sensor = r_.one_in(6)};
      if (r_.one_in(3)) thing.motion = r_.motion();
      if (r_.one_in(one_in)) put_extremes(r_, thing);
      static_cast<void>(scene.add(thing));
    }
    return scene;
  }
  void scene() {
    World w = make_world(12);
    const Scene scene = make_scene(2);
    static_cast<void>(w.set_scene(scene));
    spawn(w, 4, true);
    run(w);
    Vec3d from = r_.vector3(30), to = r_.vector3(30);
    put_extremes(r_, from);
    if (r_.coin()) put_extremes(r_, to);
    const double radius = r_.coin() ? 0 : extreme(r_, 0.1), time = extreme(r_, 1);
    static_cast<void>(scene.first_hit({from, to, radius, time, r_.one_in(2) ? 0 : extreme(r_, 1)}));
    static_cast<void>(scene.all_hits({from, to, radius, time, 0}));
    static_cast<void>(scene.nearest(from, extreme(r_, 1), {}, time)), static_cast<void>(scene.overlaps(to, radius));
    static_cast<void>(scene.clearance(from, extreme(r_, 1))), static_cast<void>(scene.clear_part({from, to, radius}));
  }
  void fly_in_scene() {
    Question q = question();
    const Scene scene = make_scene(2);
    q.until.scene = &scene;
    q.until.contact = maybe_extreme(
        ContactDef{.collision = {.on_hit = static_cast<OnHit>(r_.below(5)), .radius = r_.coin() ? 0 : r_.in(0, 0.3)}});
    check(fly(q.projectile, q.launch, q.environment, q.fidelity, q.tolerance, q.until));
  }
  ForceLaw law() {
    switch (r_.below(11)) {
      case 0: return ConstantForce{r_.vector3(9)};
      case 1: return ConstantAcceleration{r_.vector3(9)};
      case 2: return LinearQuadraticDragForce{r_.in(0, 0.1), r_.in(0, 0.1), r_.vector3(5)};
      case 3: return AnchoredSpring{r_.vector3(9), r_.in(0, 9), r_.in(0, 2), r_.in(0, 1)};
      case 4: return Spring{ids_.back(), r_.in(0, 9), r_.in(0, 2), r_.in(0, 1)};
      case 5: return Bungee{ids_.back(), r_.vector3(9), r_.in(0, 9), r_.in(0, 2), r_.in(0, 1)};
      case 6: return Buoyancy{r_.in(-1, 30), r_.coin() ? 0.0 : 1.0, r_.coin() ? 0.0 : 1.0, r_.in(1, 1000), 1, 10};
      case 7: return PointAttractor{r_.vector3(9), r_.in(-50, 50), r_.in(0, 1)};
      case 8: return WindZone{{-50, -50, -50}, {50, 50, 50}, r_.vector3(30), r_.in(0, 2)};
      case 9: return Explosion{r_.vector3(9), r_.in(0, 90), r_.in(0, 300)};
      default: return Thrust{{{0, 1}, {0.1, 9}, {r_.in(0.2, 1), r_.in(0, 9)}}, r_.vector3(1)};
    }
  }
  void forces() {
    World w = make_world(12);
    spawn(w, 5);
    if (ids_.empty()) return;
    for (int i = 0, n = 1 + r_.below(3); i < n; ++i) {
      ForceDef force{law(), {{ids_[0]}, {}, 0}, 0, kInfinity};
      if (r_.coin()) force.target = ForceTarget::everything();
      put_extremes(r_, force);
      static_cast<void>(w.add_force(force));
    }
    run(w);
  }
  void emitters() {
    World w = make_world(12);
    if (r_.one_in(3)) static_cast<void>(w.set_scene(make_scene(6)));
    ProjectileDef projectile = maybe_extreme(r_.projectile(), 6);
    if (!r_.one_in(3))
      projectile.fidelity = *fidelity_preset(fidelity_presets()[static_cast<std::size_t>(r_.below(4))]);
    const auto kind = w.add_kind(projectile, {.pool = 0, .environment = 0});
    if (!kind) return;
    std::vector<EmitterId> made;
    for (int i = 0, n = 1 + r_.below(2); i < n; ++i) {
      EmitterDef def = random_emitter(r_, *kind, made);
      if (r_.one_in(3) && projectile.fidelity.motion == Motion::force) def.flight = random_flight(r_);
      put_extremes(r_, def);
      def.maximum = std::min(def.maximum, 200u);
      const auto emitter = w.add_emitter(def);
      expect(emitter || !emitter.error().message.empty(), "a refusal without words");
      if (emitter) made.push_back(*emitter);
    }
    if (!made.empty()) {
      if (r_.one_in(4)) static_cast<void>(w.seek_emitter(made[0], extreme(r_, 1)));
      if (r_.one_in(4)) static_cast<void>(w.lead_emitter(made[0], maybe_extreme(r_.transform()), extreme(r_, 1)));
      if (r_.one_in(4)) static_cast<void>(w.move_emitter(made[0], maybe_extreme(r_.transform())));
    }
    run(w);
    for (const EmitterId emitter : made) {
      std::vector<Vec3d> position(300), size(300);
      std::vector<double> age(300);
      const ParticleColumns into{.position = position, .size = size, .age = age};
      const std::size_t count = std::min<std::size_t>(w.particles(emitter, into), 300);
      for (std::size_t i = 0; i < count; ++i)
        expect(is_finite(position[i]) && std::isfinite(age[i]), "a particle of no numbers");
    }
  }
  void joints() {
    World w = make_world(12);
    spawn(w, 6), spawn(w, 6);
    if (ids_.size() < 2) return;
    for (std::size_t i = 1; i < ids_.size(); ++i) {
      Joint joint{.kind = static_cast<JointKind>(r_.below(5)), .a = ids_[i], .b = ids_[i - 1]};
      if (r_.one_in(3)) joint.b = {}, joint.point = r_.vector3(3);
      if (r_.coin()) joint.length = r_.in(0.1, 3);
      joint.stiffness = r_.in(1, 100), joint.damping = r_.in(0, 3), joint.restitution = r_.unit();
      if (joint.kind >= JointKind::hinge) joint.axis = r_.vector3(1);
      if (joint.kind == JointKind::slider) joint.length = {};
      if (!joint.b) joint.velocity = r_.vector3(3);
      if (r_.coin()) put_extremes(r_, joint);
      static_cast<void>(w.add_joint(joint));
    }
    run(w);
    for (const JointId joint : w.joints())
      expect(std::isfinite(w.joint_state(joint).tension), "a tension of no number");
  }

  Odd r_;
  std::vector<ProjectileId> ids_;
};

void play(long seed, long number) {
  case_number = number;
  part_at_work = "";
  const itimerval patience{{0, 0}, {kPatience, 0}};
  setitimer(ITIMER_PROF, &patience, nullptr);
  Extreme(static_cast<std::uint64_t>(seed) * 1000003u + static_cast<std::uint64_t>(number)).play();
}

}  // namespace
}  // namespace physim::test

int main(int argc, char** argv) {
  using namespace physim::test;
  const auto asked = read_arguments("physim_extreme_fuzz", argc, argv);
  if (!asked) return 2;
  for (const int signal : {SIGPROF, SIGABRT, SIGSEGV, SIGFPE}) std::signal(signal, give_up);
  for (long i = asked->first; i < asked->first + asked->count; ++i) play(asked->seed, i);
  const auto n = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
  std::printf("%ld cases: %llu spawned, %llu steps, %llu of %llu flights flown; %ld wrong\n", asked->count,
              n(tally.spawned), n(tally.steps), n(tally.flown), n(tally.flights), faults);
  return faults > 0 ? 1 : 0;
}
