#include "world.hpp"

#include <algorithm>
#include <chrono>

#include "base/ieee_mode.hpp"
#include "flight/zero.hpp"
#include "model/force_laws.hpp"
#include "physim/scenario.hpp"
#include "scenario/reader.hpp"
#include "scenario/scene_maker.hpp"

namespace physim::python {

class PyWorld::Stepping {
 public:
  explicit Stepping(PyWorld& world) : world_(world), is_outer_(world.stepping_.load() == std::thread::id()) {
    if (is_outer_) world_.stepping_ = std::this_thread::get_id();
  }
  ~Stepping() {
    if (is_outer_) world_.stepping_ = std::thread::id();
  }
  Stepping(const Stepping&) = delete;
  Stepping& operator=(const Stepping&) = delete;

 private:
  PyWorld& world_;
  bool is_outer_;
};

void PyWorld::close() {
  check();
  if (stepping_.load() != std::thread::id()) fail("a world cannot be closed inside its own step", "world");
  is_closed_ = true;
  run_.reset();
  own_.reset();
  replay_.reset();
  functions_.clear();
  events_.clear();
}

bool PyWorld::has_raised() const {
  const auto raised = [](const std::optional<Function>& function) { return function && function->has_raised(); };
  return raised(setup_->wind_field) || raised(setup_->force) ||
         std::ranges::any_of(functions_, [](const Function& each) { return each.has_raised(); });
}

void PyWorld::raise_kept() {
  setup_->raise_kept();
  for (const Function& each : functions_) each.raise_kept();
}

void PyWorld::take_events() {
  const World& world = replay_ ? replay_->world() : run_ ? std::as_const(*run_).world() : *own_;
  const std::span<const Event> news = world.events();
  events_.insert(events_.end(), news.begin(), news.end());
  if (!run_) return;
  hits_.insert(hits_.end(), run_->thing_hits().begin(), run_->thing_hits().end());
  wall_hits_.insert(wall_hits_.end(), run_->hits().begin(), run_->hits().end());
}

void PyWorld::step(std::size_t count, std::optional<double> dt) {
  World& world = get();
  if (run_ && dt) fail("a scenario's world has steps of its own", "dt", "it is world.step of the scenario");
  if (stepping_.load() != std::thread::id()) fail("a world cannot be stepped inside its own step", "world");
  forget();
  Status status;
  using Clock = std::chrono::steady_clock;
  for (std::size_t i = 0; i < count && status && !has_raised();) {
    const Stepping stepping(*this);
    {
      const Released free;
      const auto until = Clock::now() + std::chrono::milliseconds(100);
      for (; i < count && status && !has_raised() && Clock::now() < until; ++i) {
        if (run_)
          run_->step();
        else
          status = world.step(dt.value_or(world.def().step));
        if (status) take_events();
      }
    }
    if (!has_raised() && PyErr_CheckSignals() != 0) throw nb::python_error();  // Ctrl-C
  }
  raise_kept();
  taken(status);
}

int PyWorld::advance(double real_dt) {
  World& world = get();
  if (run_) fail("a scenario's world is stepped", "world", "call step()");
  if (stepping_.load() != std::thread::id()) fail("a world cannot be stepped inside its own step", "world");
  forget();
  int steps = 0;
  {
    const Stepping stepping(*this);
    const Released free;
    steps = world.advance(real_dt);
    take_events();
  }
  raise_kept();
  return steps;
}

bool PyWorld::moved_by(const std::function<bool(Replay&)>& move) {
  check();
  if (!replay_) fail("no recording moves this world", "world", "physim.Replay(file) is one");
  forget();
  const Stepping stepping(*this);
  const Released free;
  const bool is_there = move(*replay_);
  if (is_there) take_events();
  return is_there;
}

bool PyWorld::next() {
  return moved_by([](Replay& replay) { return replay.next_frame(); });
}

bool PyWorld::seek(std::uint64_t steps) {
  return moved_by([&](Replay& replay) { return replay.seek(steps); });
}

const Function& PyWorld::keep(nb::object function, const char* name) {
  if (PyCallable_Check(function.ptr()) == 0) fail("is no function", name);
  return functions_.emplace_back(std::move(function));
}

std::uint32_t PyWorld::environment(const Environment& environment) {
  World& world = get();
  if (environment == world.def().environment || environment == Environment{}) return 0;
  const auto known = std::ranges::find(environments_, environment);
  if (known != environments_.end()) return static_cast<std::uint32_t>(known - environments_.begin()) + 1;
  const std::uint32_t index = taken(world.add_environment(environment));
  environments_.resize(std::max<std::size_t>(environments_.size(), index));
  environments_[index - 1] = environment;
  return index;
}

KindId PyWorld::kind(const ScenarioShot& shot, const Setup& of, bool asks) {
  World& world = get();
  BodyDef body = shot.body;
  if (!shot.pool.empty()) {
    const auto& pools = world.def().pools;
    const auto pool = std::ranges::find(pools, shot.pool, &PoolDef::name);
    if (pool == pools.end()) fail("no pool is named \"" + shot.pool + "\"", "shot.body.pool");
    body.pool = static_cast<std::uint32_t>(pool - pools.begin());
  }
  body.cheapest_within = shot.cheapest_within.value_or(0);
  body.environment = environment(of.scenario.environment);
  if (asks) body.collision.on_hit = OnHit::ask;
  return taken(world.add_kind(shot.projectile, body));
}

namespace {

// -------------------------------------------------------------------------------------------------------- coming in
std::unique_ptr<PyWorld> make_world(SetupPtr setup) {
  WorldDef def = setup->scenario.world.def;
  def.environment = setup->scenario.environment;
  def.tolerance = setup->scenario.tolerance;
  World world = taken(World::create(def));
  if (!setup->scenario.things.empty()) taken(world.set_scene(taken(scene_of(setup->scenario))));
  taken(world.set_observer(setup->scenario.world.observer));
  return std::make_unique<PyWorld>(std::move(setup), std::move(world));
}

/// The scenario with its functions, which no text has.
std::unique_ptr<PyWorld> run_world(SetupPtr setup, const std::string& recording) {
  WorldRun run = [&] {
    const Released free;
    return taken(WorldRun::create(setup->scenario, recording));
  }();
  setup->raise_kept();
  return std::make_unique<PyWorld>(std::move(setup), std::move(run));
}

struct Column1 {
  const char* name;
  std::span<const double> LaunchColumns::*member;
};

nb::object spawn(PyWorld& py, const Setup& setup, const std::string& name, const nb::dict& inputs, std::size_t count,
                 double delay, bool raises, bool asks) {
  const ScenarioShot& shot = setup.shot(name);
  World& world = py.get();
  const KindId kind = py.kind(shot, setup, asks);
  const std::uint32_t index = py.environment(setup.scenario.environment);
  const Environment& air = index == 0 ? world.def().environment : setup.scenario.environment;
  LaunchColumns columns;
  columns.common = taken(aimed_launch(shot.projectile, shot.launch, air, shot.projectile.fidelity));
  constexpr Column1 kNames[] = {{"x", &LaunchColumns::x},
                                {"y", &LaunchColumns::y},
                                {"z", &LaunchColumns::z},
                                {"speed", &LaunchColumns::speed},
                                {"elevation", &LaunchColumns::elevation},
                                {"azimuth", &LaunchColumns::azimuth}};
  std::vector<Numbers> kept;
  for (const auto& [key, object] : inputs) {
    const std::string column = nb::cast<std::string>(key);
    const auto known = std::ranges::find_if(kNames, [&](const Column1& each) { return column == each.name; });
    if (known == std::end(kNames)) fail("unknown column", column, "known are x, y, z, speed, elevation, azimuth");
    Numbers numbers;
    if (!nb::try_cast<Numbers>(object, numbers, false)) fail("is no column of float64", column);
    check_length(numbers.size(), count, column);
    kept.push_back(numbers);
    columns.*(known->member) = span_of(numbers);
  }
  std::vector<Launch> launches(count);
  for (std::size_t i = 0; i < count; ++i) launches[i] = columns.at(i);
  std::vector<ProjectileId> ids(count);
  if (delay > 0)
    for (std::size_t i = 0; i < count; ++i) ids[i] = taken(world.spawn(kind, launches[i], delay));
  else
    world.spawn(kind, launches, ids);
  if (raises)
    for (std::size_t i = 0; i < count; ++i)
      if (!ids[i]) {
        const Result<ProjectileId> again = world.spawn(kind, launches[i]);
        for (const ProjectileId id : ids) static_cast<void>(world[id].despawn());
        if (again) static_cast<void>(world[*again].despawn());
        fail(again ? Error{"was refused", "spawn", ""} : again.error());
      }
  return column_of<std::uint64_t>(ids, [](const ProjectileId& id) { return number_of(id); });
}

std::vector<ProjectileId> ids_in(const World& world, nb::handle object) {
  std::vector<ProjectileId> ids;
  if (object.is_none()) return world.ids(ids), ids;
  Ids numbers;
  if (!nb::try_cast<Ids>(object, numbers, false)) fail("is no column of ids (uint64)", "ids");
  for (std::size_t i = 0; i < numbers.size(); ++i) ids.push_back(id_of<ProjectileId>(numbers.data()[i]));
  return ids;
}

// ------------------------------------------------------------------------------------------------------- bulk reads
enum class What { position, velocity, render };

nb::object id_column(const std::vector<ProjectileId>& ids) {
  return column_of<std::uint64_t>(ids, [](const ProjectileId& id) { return number_of(id); });
}

nb::object rows(PyWorld& py, What what, nb::handle ids, nb::handle out) {
  const World& world = py.read();
  const std::vector<ProjectileId> all = ids_in(world, ids);
  std::vector<BodyState> states(all.size());
  if (what == What::render) {
    std::vector<Vec3d> places(all.size());
    world.render_positions(all, places);
    for (std::size_t i = 0; i < all.size(); ++i) states[i].position = places[i];
  } else {
    world.states(all, states);
  }
  const auto get = [what](const BodyState& s) { return what == What::velocity ? s.velocity : s.position; };
  if (out.is_none()) return rows_of(states, get);
  OutputRows into(out, "out");
  if (into.size() < states.size())
    fail("has " + std::to_string(into.size()) + " rows", "out", "there are " + std::to_string(states.size()));
  for (std::size_t i = 0; i < states.size(); ++i) into.put(i, get(states[i]));
  return nb::borrow(out);
}

nb::dict state_columns(PyWorld& py) {
  const World& world = py.read();
  std::vector<ProjectileId> ids;
  world.ids(ids);
  std::vector<BodyState> states(ids.size());
  world.states(ids, states);
  nb::dict out;
  out["id"] = column_of<std::uint64_t>(ids, [](const ProjectileId& id) { return number_of(id); });
  out["position"] = rows_of(states, [](const BodyState& s) { return s.position; });
  out["velocity"] = rows_of(states, [](const BodyState& s) { return s.velocity; });
  return out;
}

nb::dict particle_columns(PyWorld& py, std::uint64_t emitter, const nb::object& eye) {
  const World& world = py.read();
  const EmitterId id = id_of<EmitterId>(emitter);
  if (world.emitter(id) == nullptr) fail("there is no such emitter", "emitter");
  const std::size_t count = world.emitter_counts(id).alive;
  std::vector<ProjectileId> ids(count);
  std::vector<Vec3d> position(count), previous(count), velocity(count), size(count), rotation(count);
  std::vector<std::uint32_t> colour(count);
  std::vector<double> age(count);
  std::vector<std::uint64_t> number(count);
  ParticleColumns into;
  into.id = ids, into.position = position, into.previous = previous, into.velocity = velocity, into.size = size;
  into.rotation = rotation, into.colour = colour, into.age = age, into.number = number;
  if (!eye.is_none()) into.eye = vec_of(nb::cast<std::vector<double>>(eye), "eye");
  const std::size_t written = std::min(world.particles(id, into), count);
  const auto rows_in = [&](std::vector<Vec3d>& v) { return v.resize(written), array_of(std::span<const Vec3d>(v)); };
  ids.resize(written), colour.resize(written), age.resize(written), number.resize(written);
  nb::dict out;
  out["id"] = column_of<std::uint64_t>(ids, [](const ProjectileId& each) { return number_of(each); });
  out["position"] = rows_in(position), out["previous"] = rows_in(previous), out["velocity"] = rows_in(velocity);
  out["size"] = rows_in(size), out["rotation"] = rows_in(rotation);
  out["colour"] = owned(std::move(colour)), out["age"] = owned(std::move(age)),
  out["number"] = owned(std::move(number));
  return out;
}

nb::dict trail_columns(PyWorld& py, std::uint64_t emitter) {
  const World& world = py.read();
  const EmitterId id = id_of<EmitterId>(emitter);
  if (world.emitter(id) == nullptr) fail("there is no such emitter", "emitter");
  const TrailCounts counts = world.trails(id, {});
  std::vector<ProjectileId> ids(counts.particles);
  std::vector<std::uint32_t> first(counts.particles), count(counts.particles);
  std::vector<Vec3d> position(counts.places);
  std::vector<double> time(counts.places);
  TrailColumns into;
  into.id = ids, into.first = first, into.count = count, into.position = position, into.time = time;
  world.trails(id, into);
  nb::dict out;
  out["id"] = column_of<std::uint64_t>(ids, [](const ProjectileId& each) { return number_of(each); });
  out["first"] = owned(std::move(first)), out["count"] = owned(std::move(count));
  out["position"] = array_of(std::span<const Vec3d>(position)), out["time"] = owned(std::move(time));
  return out;
}

// --------------------------------------------------------------------------------------------------- one projectile
nb::dict projectile_table(PyWorld& py, std::uint64_t number) {
  const World& world = py.read();
  const ProjectileView one = world[id_of<ProjectileId>(number)];
  nb::dict out;
  out["alive"] = one.is_alive();
  out["status"] = std::string(name(one.status()));
  out["asleep"] = one.is_asleep();
  out["position"] = array_of(one.position()), out["velocity"] = array_of(one.velocity());
  out["previous_position"] = array_of(one.previous_position());
  out["render_position"] = array_of(one.render_position());
  out["orientation"] = array_of(one.orientation()), out["angular_velocity"] = array_of(one.angular_velocity());
  out["age"] = one.age(), out["mach"] = one.mach(), out["mass"] = one.mass();
  out["label"] = one.label(), out["user_data"] = one.user_data(), out["layers"] = one.layers();
  out["colour"] = one.colour(), out["kind"] = one.kind().index;
  out["notes"] = notes_table(one.fidelity_in_use());
  return out;
}

nb::object projectile_value(PyWorld& py, std::uint64_t number, const std::string& what) {
  const World& world = py.read();
  const ProjectileView one = world[id_of<ProjectileId>(number)];
  if (what == "position") return array_of(one.position());
  if (what == "velocity") return array_of(one.velocity());
  if (what == "alive") return nb::cast(one.is_alive());
  if (what == "force") return array_of(one.resultant_force());
  if (what == "acceleration") return array_of(one.accelerations().total);
  if (what == "jerk") return array_of(one.jerk());
  const nb::dict all = projectile_table(py, number);
  if (!all.contains(what.c_str())) fail("there is no such value", what);
  return all[what.c_str()];
}

void change_projectile(PyWorld& py, std::uint64_t number, const std::string& what, nb::handle value) {
  World& world = py.get();
  Projectile one = world[id_of<ProjectileId>(number)];
  const auto vec = [&] { return vec_of(nb::cast<std::vector<double>>(value), what.c_str()); };
  if (what == "position") return taken(one.set_position(vec()));
  if (what == "velocity") return taken(one.set_velocity(vec()));
  if (what == "impulse") return taken(one.apply_impulse(vec()));
  if (what == "angular_velocity") return taken(one.set_angular_velocity(vec()));
  if (what == "label") return taken(one.set_label(nb::cast<std::string>(value)));
  if (what == "user_data") return taken(one.set_user_data(nb::cast<std::uint64_t>(value)));
  if (what == "colour") return taken(one.set_colour(nb::cast<std::uint32_t>(value)));
  if (what == "layers") return taken(one.set_layers(nb::cast<std::uint32_t>(value)));
  if (what == "sleep") return taken(one.sleep());
  if (what == "wake") return taken(one.wake());
  if (what == "despawn") return taken(one.despawn());
  fail("cannot be changed", what);
}

/// Settings of one in flight: those that the list marks as live, and its fidelity.
void set_projectile(PyWorld& py, std::uint64_t number, const nb::dict& settings) {
  World& world = py.get();
  Projectile one = world[id_of<ProjectileId>(number)];
  if (one.definition() == nullptr) fail("the projectile is gone", "id");
  ScenarioShot shot{.projectile = *one.definition(), .launch = {}, .body = one.body()};
  Scenario scenario;
  scenario.world.given = true;
  const Value changes = shot_of_settings(settings);
  const Scope scope{.scenario = &scenario, .shot = &shot};
  const SchemaNode* node = find_node("shot");
  {
    const IeeeMode mode;
    taken(read_table(*node, scope, changes));
  }
  if (shot.projectile.fidelity != one.definition()->fidelity) taken(one.set_fidelity(shot.projectile.fidelity));
  shot.projectile.fidelity = one.definition()->fidelity;
  if (!(shot.projectile == *one.definition())) taken(one.set_projectile(shot.projectile));
  if (!(shot.body == one.body())) taken(one.set_body(shot.body));
}

// ------------------------------------------------------------------------------------------------- forces and joints
ForceTarget target_of(World& world, nb::handle ids, std::uint32_t layers) {
  if (!ids.is_none()) return {ids_in(world, ids), {}, 0};
  return {{}, {}, layers};
}

std::uint64_t add_law(PyWorld& py, const Setup& setup, nb::handle ids, std::uint32_t layers, std::uint64_t other) {
  World& world = py.get();
  const ScenarioForce& force = setup.scenario.forces.front();
  ForceTarget target = target_of(world, ids, layers);  // apart: see PythonReader
  ForceDef def{.law = force.law, .target = std::move(target), .delay = force.delay, .duration = force.duration};
  if (ProjectileId* end = other_end_of(def.law); end != nullptr && other != 0) *end = id_of<ProjectileId>(other);
  return number_of(taken(world.add_force(def)));
}

CustomForce custom_force(const Function& function) {
  return {[function](const ForceBatch& batch) {
    function.call([&](const nb::object& f) {
      const nb::object ids = column_of<std::uint64_t>(batch.id, [](const ProjectileId& id) { return number_of(id); });
      std::vector<Vec3d> forces(batch.force.size());
      copy_rows(f(batch.time, ids, array_of(batch.position), array_of(batch.velocity),
                  owned(std::vector<double>(batch.mass.begin(), batch.mass.end()))),
                forces, "the force");
      for (std::size_t i = 0; i < forces.size(); ++i) batch.force[i] += forces[i];
    });
  }};
}

std::uint64_t add_function(PyWorld& py, nb::object function, nb::handle ids, std::uint32_t layers, double delay,
                           double duration) {
  World& world = py.get();
  const Function& kept = py.keep(std::move(function), "force");
  ForceTarget target = target_of(world, ids, layers);
  ForceDef def{.law = custom_force(kept), .target = std::move(target), .delay = delay, .duration = duration};
  return number_of(taken(world.add_force(def)));
}

std::uint64_t add_joint(PyWorld& py, const Setup& setup, std::uint64_t a, std::uint64_t b, std::uint64_t thing) {
  Joint joint = setup.scenario.joints.front().def;
  joint.a = id_of<ProjectileId>(a), joint.b = id_of<ProjectileId>(b), joint.thing = id_of<InstanceId>(thing);
  return number_of(taken(py.get().add_joint(joint)));
}

/// The last emitter of a setup, whose others are in the world already, by name.
std::uint64_t add_emitter(PyWorld& py, const Setup& setup, const Setup& fires, const nb::dict& ids,
                          std::uint64_t follows) {
  const Scenario& scenario = setup.scenario;
  const ScenarioEmitter& emitter = scenario.emitters.back();
  const ScenarioShot& shot = fires.shot("");
  EmitterDef def = def_of(emitter);
  def.kind = py.kind(shot, fires);
  def.launch.rail_length = shot.launch.rail_length;
  def.launch.attitude = shot.launch.attitude;
  def.launch.spin = shot.launch.spin;
  def.follows = id_of<ProjectileId>(follows);
  for (std::size_t i = 0; i < def.subs.size(); ++i)
    if (emitter.subs[i].emitter != emitter.def.name)
      def.subs[i].emitter = id_of<EmitterId>(nb::cast<std::uint64_t>(ids[emitter.subs[i].emitter.c_str()]));
  return number_of(taken(py.get().add_emitter(def)));
}

nb::dict counts_table(PyWorld& py, std::uint64_t emitter) {
  const World& world = py.read();
  const EmitterCounts c = world.emitter_counts(id_of<EmitterId>(emitter));
  nb::dict out;
  out["born"] = c.born, out["refused"] = c.refused, out["aged"] = c.aged, out["landed"] = c.landed;
  out["expired"] = c.expired, out["replaced"] = c.replaced, out["taken"] = c.taken, out["cut"] = c.cut;
  out["alive"] = c.alive;
  return out;
}

// -------------------------------------------------------------------------------------------------------------- hits
HitFunction hit_function(const Function& function) {
  return [function](const HitBatch& batch) {
    function.call([&](const nb::object& f) {
      const auto& all = batch.questions;
      nb::dict q;
      q["projectile"] = column_of<std::uint64_t>(all, [](const HitQuestion& h) { return number_of(h.projectile); });
      q["time"] = column_of<double>(all, [](const HitQuestion& h) { return h.time; });
      q["position"] = rows_of(all, [](const HitQuestion& h) { return h.position; });
      q["velocity"] = rows_of(all, [](const HitQuestion& h) { return h.velocity; });
      q["normal"] = rows_of(all, [](const HitQuestion& h) { return h.normal; });
      q["surface_velocity"] = rows_of(all, [](const HitQuestion& h) { return h.surface_velocity; });
      q["instance"] = column_of<std::uint64_t>(all, [](const HitQuestion& h) { return number_of(h.instance); });
      q["material"] = column_of<std::uint32_t>(all, [](const HitQuestion& h) { return h.material.index; });
      q["energy"] = column_of<double>(all, [](const HitQuestion& h) { return h.energy; });
      q["obliquity"] = column_of<double>(all, [](const HitQuestion& h) { return h.obliquity; });
      q["thickness"] = column_of<double>(all, [](const HitQuestion& h) { return h.thickness; });
      q["inside"] = flags_of(all, [](const HitQuestion& h) { return h.inside; });
      const nb::list answers(f(q));  // made one list of names by the package
      for (std::size_t i = 0; i < all.size(); ++i) {
        const nb::tuple answer = nb::cast<nb::tuple>(answers[i]);
        const auto then = value_of<OnHit>(nb::cast<std::string>(answer[0]));
        if (!then) throw nb::value_error("a hit is answered by pass, stop, stick, bounce or impact");
        batch.answers[i].then = *then;
        if (!answer[1].is_none())
          batch.answers[i].velocity = vec_of(nb::cast<std::vector<double>>(answer[1]), "velocity");
      }
    });
  };
}

nb::dict hit_columns(const PyWorld& py) {
  const std::vector<ThingHit>& all = py.hits();
  const Scenario& scenario = py.setup().scenario;
  nb::list things, outcomes;
  for (const ThingHit& hit : all) {
    things.append(hit.thing == ThingHit::kNone ? std::string() : scenario.things[hit.thing].name);
    outcomes.append(std::string(name(hit.outcome)));
  }
  nb::dict out;
  out["time"] = column_of<double>(all, [](const ThingHit& h) { return h.time; });
  out["id"] = column_of<std::uint64_t>(all, [](const ThingHit& h) { return number_of(h.id); });
  out["thing"] = things;
  out["outcome"] = outcomes;
  out["position"] = rows_of(all, [](const ThingHit& h) { return h.position; });
  out["velocity"] = rows_of(all, [](const ThingHit& h) { return h.velocity; });
  out["velocity_after"] = rows_of(all, [](const ThingHit& h) { return h.velocity_after; });
  out["obliquity"] = column_of<double>(all, [](const ThingHit& h) { return h.obliquity; });
  out["depth"] = column_of<double>(all, [](const ThingHit& h) { return h.depth; });
  out["energy"] = column_of<double>(all, [](const ThingHit& h) { return h.energy; });
  return out;
}

nb::list group_tables(PyWorld& py) {
  WorldRun* run = py.run();
  if (run == nullptr) fail("a world of its own has no groups", "world", "they are those of a scenario's world");
  nb::list all;
  for (const WorldGroup& g : run->groups()) {
    nb::dict row;
    const auto say = [&](const char* key, const Series& s) {
      nb::dict series;
      series["count"] = s.count, series["mean"] = s.mean, series["low"] = s.low, series["high"] = s.high;
      series["spread"] = s.spread();
      row[key] = series;
    };
    row["name"] = g.name;
    row["hits"] = g.hits, row["alive"] = g.alive, row["retired"] = g.retired;
    say("range", g.range), say("time", g.time), say("speed", g.speed), say("apex", g.apex);
    say("hit_y", g.hit_y), say("hit_z", g.hit_z);
    row["position"] = array_of(g.position), row["velocity"] = array_of(g.velocity), row["mean_speed"] = g.mean_speed;
    row["emitter"] = number_of(g.emitter);
    all.append(row);
  }
  return all;
}

// ----------------------------------------------------------------------------------------------- moments and saves
struct PySnapshot {
  Snapshot own;
  RunSnapshot run;
};

nb::bytes bytes_of(const std::vector<std::byte>& data) { return nb::bytes(data.data(), data.size()); }
std::span<const std::byte> span_of(const nb::bytes& data) {
  return {static_cast<const std::byte*>(static_cast<const void*>(data.c_str())), data.size()};
}

std::unique_ptr<PyWorld> load_world(SetupPtr setup, const nb::bytes& save, bool is_run, const nb::list& forces,
                                    const nb::list& wind_fields, const nb::list& force_fields, nb::object on_hit,
                                    nb::object engine) {
  if (is_run) {
    WorldRun run = taken(WorldRun::load(setup->scenario, span_of(save)));
    return std::make_unique<PyWorld>(std::move(setup), std::move(run));
  }
  LoadOptions options{.threading = setup->scenario.world.def.threading};
  std::vector<Function> kept;
  const auto keep = [&](nb::handle f) { return kept.emplace_back(nb::borrow(f)); };
  for (const nb::handle f : forces) options.custom_forces.push_back(custom_force(keep(f)));
  if (nb::len(wind_fields) + nb::len(force_fields) > 0)
    fail("functions of place are given by the world's own settings", "wind_field");
  if (setup->scenario.environment.wind.field) options.wind_fields.push_back(setup->scenario.environment.wind.field);
  if (setup->scenario.environment.force) options.force_fields.push_back(setup->scenario.environment.force);
  if (!on_hit.is_none()) options.hit_function = hit_function(keep(on_hit));
  if (!engine.is_none()) options.engine_queries.push_back(engine_query(keep(engine)));
  World world = taken(World::load(span_of(save), options));
  auto made = std::make_unique<PyWorld>(std::move(setup), std::move(world));
  for (const Function& each : kept) made->keep(each.get(), "function");
  return made;
}

nb::dict report_table(const ReplayReport& r) {
  nb::dict out;
  out["made_by"] = r.made_by, out["complete"] = r.complete, out["calls"] = r.calls, out["steps"] = r.steps;
  out["hashes"] = r.hashes, out["restores"] = r.restores, out["spawned"] = r.spawned;
  out["difference"] = nb::none();
  if (r.difference) out["difference"] = nb::make_tuple(r.difference->step, r.difference->call, r.difference->what);
  return out;
}

nb::dict replay_file(const std::string& file) {
  const std::vector<std::byte> bytes = taken(load_recording(file));
  const ReplayReport report = [&] {
    const Released free;
    return taken(replay(bytes));
  }();
  return report_table(report);
}

std::unique_ptr<PyWorld> replay_world(const std::string& file) {
  std::vector<std::byte> bytes = taken(load_recording(file));
  Replay replay = [&] {
    const Released free;
    return taken(Replay::open(std::move(bytes)));
  }();
  return std::make_unique<PyWorld>(Setup::plain(), std::move(replay));
}

nb::dict counters_table(PyWorld& py) {
  const WorldCounters& c = py.read().counters();
  nb::dict out;
  out["steps"] = c.steps, out["projectile_steps"] = c.projectile_steps, out["refused"] = c.refused;
  out["retired"] = c.retired, out["dropped_time"] = c.dropped_time, out["dropped_events"] = c.dropped_events;
  return out;
}

Transform transform_of(const std::vector<double>& position, const std::vector<double>& rotation, double scale) {
  if (rotation.size() != 4)
    fail("found " + std::to_string(rotation.size()) + " components", "rotation", "expected a quaternion: w, x, y, z");
  return {vec_of(position, "position"), {rotation[0], rotation[1], rotation[2], rotation[3]}, scale};
}

Flight predict(PyWorld& py, std::uint64_t id, std::optional<double> time, const Setup* until, double step) {
  const World& world = py.read();
  Until end = until != nullptr ? until->scenario.until : Until{};
  if (until == nullptr) end.time = time.value_or(3600);
  const bool by_ground = until == nullptr && !time;
  const Flight flight = by_ground || until != nullptr ? world.predict(id_of<ProjectileId>(id), end, step)
                                                      : world.predict(id_of<ProjectileId>(id), *time, step);
  if (flight.error()) fail(*flight.error());
  return flight;
}

void add_reads(nb::class_<PyWorld>& c) {
  c.def("state", &state_columns, "Ids, positions and velocities of all alive.")
      .def(
          "positions", [](PyWorld& w, nb::handle ids, nb::handle out) { return rows(w, What::position, ids, out); },
          "ids"_a.none(), "out"_a.none())
      .def(
          "velocities", [](PyWorld& w, nb::handle ids, nb::handle out) { return rows(w, What::velocity, ids, out); },
          "ids"_a.none(), "out"_a.none())
      .def(
          "render_positions",
          [](PyWorld& w, nb::handle ids, nb::handle out) { return rows(w, What::render, ids, out); }, "ids"_a.none(),
          "out"_a.none())
      .def("ids",
           [](PyWorld& w) {
             std::vector<ProjectileId> ids;
             w.read().ids(ids);
             return column_of<std::uint64_t>(ids, [](const ProjectileId& id) { return number_of(id); });
           })
      .def(
          "events", [](const PyWorld& w) { return event_columns(w.events()); }, "Of the last steps, as columns.")
      .def(
          "call_events", [](PyWorld& w) { return event_columns(w.read().events()); },
          "Of the last step and of calls since.")
      .def("hits", &hit_columns, "On things, of the last steps of a scenario's world.")
      .def(
          "wall_hits",
          [](const PyWorld& w) {
            const std::vector<WallHit>& all = w.wall_hits();
            nb::dict out;
            out["time"] = column_of<double>(all, [](const WallHit& h) { return h.time; });
            out["id"] = column_of<std::uint64_t>(all, [](const WallHit& h) { return number_of(h.id); });
            out["position"] = rows_of(all, [](const WallHit& h) { return h.position; });
            out["velocity"] = rows_of(all, [](const WallHit& h) { return h.velocity; });
            return out;
          },
          "On the wall, of the last steps of a scenario's world.")
      .def_prop_ro(
          "ground",
          [](PyWorld& w) -> std::optional<double> {
            const Ground& ground = w.read().def().ground;
            return ground.mode == GroundMode::none ? std::nullopt : std::optional(ground.height);
          },
          "Its height [m], or None.")
      .def("groups", &group_tables)
      .def("particles", &particle_columns, "emitter"_a, "eye"_a.none())
      .def("trails", &trail_columns, "emitter"_a)
      .def("projectile", &projectile_table, "id"_a)
      .def("value", &projectile_value, "id"_a, "what"_a)
      .def("counters", &counters_table)
      .def("emitter_counts", &counts_table, "emitter"_a)
      .def("predict", &predict, "id"_a, "time"_a.none(), "until"_a.none(), "step"_a)
      .def_prop_ro(
          "size", [](PyWorld& w) { return w.read().size(); }, "Projectiles alive.")
      .def_prop_ro(
          "time", [](PyWorld& w) { return w.read().time(); }, "Of the simulation [s].")
      .def_prop_ro(
          "step_size", [](PyWorld& w) { return w.read().def().step; }, "Of a fixed step [s].")
      .def_prop_ro(
          "steps", [](PyWorld& w) { return w.run() != nullptr ? w.run()->steps() : 0; },
          "Within the scenario's duration.")
      .def_prop_ro(
          "memory", [](PyWorld& w) { return w.read().memory(); }, "Of what grows with use [bytes].")
      .def_prop_ro("closed", &PyWorld::is_closed, "Whether it was closed.")
      .def_prop_ro(
          "is_run", [](PyWorld& w) { return w.run() != nullptr; }, "Whether it is of a scenario.")
      .def(
          "hash", [](PyWorld& w) { return w.read().hash(); }, "Of all that decides what happens next.");
}

void add_changes(nb::class_<PyWorld>& c) {
  c.def("step", &PyWorld::step, "count"_a, "dt"_a.none())
      .def("advance", &PyWorld::advance, "real_dt"_a)
      .def("close", &PyWorld::close)
      .def("spawn", &spawn, "setup"_a, "shot"_a, "inputs"_a, "count"_a, "delay"_a, "raises"_a, "asks"_a)
      .def(
          "despawn", [](PyWorld& w, nb::handle ids) { return w.get().despawn(ids_in(w.get(), ids)); }, "ids"_a.none())
      .def("change", &change_projectile, "id"_a, "what"_a, "value"_a.none())
      .def("set_projectile", &set_projectile, "id"_a, "settings"_a)
      .def("add_law", &add_law, "setup"_a, "ids"_a.none(), "layers"_a, "other"_a)
      .def("add_function", &add_function, "function"_a, "ids"_a.none(), "layers"_a, "delay"_a, "duration"_a)
      .def(
          "remove_force", [](PyWorld& w, std::uint64_t id) { taken(w.get().remove_force(id_of<ForceId>(id))); }, "id"_a)
      .def(
          "felt_by", [](PyWorld& w, std::uint64_t id) { return w.read().felt_by(id_of<ForceId>(id)); }, "id"_a)
      .def("add_joint", &add_joint, "setup"_a, "a"_a, "b"_a, "thing"_a)
      .def(
          "move_joint",
          [](PyWorld& w, std::uint64_t id, const std::vector<double>& position, const std::vector<double>& velocity) {
            taken(w.get().move_joint(id_of<JointId>(id), {vec_of(position, "position"), vec_of(velocity, "velocity")}));
          },
          "id"_a, "position"_a, "velocity"_a)
      .def(
          "joint_motion",
          [](PyWorld& w, std::uint64_t id) {
            const JointState s = w.read().joint_state(id_of<JointId>(id));
            return nb::make_tuple(s.angle, s.way, s.force);
          },
          "id"_a)
      .def(
          "remove_joint", [](PyWorld& w, std::uint64_t id) { taken(w.get().remove_joint(id_of<JointId>(id))); }, "id"_a)
      .def(
          "joint_state",
          [](PyWorld& w, std::uint64_t id) {
            const JointState s = w.read().joint_state(id_of<JointId>(id));
            return nb::make_tuple(s.length, s.tension, s.is_taut);
          },
          "id"_a)
      .def("add_emitter", &add_emitter, "setup"_a, "fires"_a, "ids"_a, "follows"_a)
      .def(
          "remove_emitter", [](PyWorld& w, std::uint64_t id) { taken(w.get().remove_emitter(id_of<EmitterId>(id))); },
          "id"_a)
      .def(
          "play_emitter", [](PyWorld& w, std::uint64_t id) { taken(w.get().play_emitter(id_of<EmitterId>(id))); },
          "id"_a)
      .def(
          "stop_emitter", [](PyWorld& w, std::uint64_t id) { taken(w.get().stop_emitter(id_of<EmitterId>(id))); },
          "id"_a)
      .def(
          "emit",
          [](PyWorld& w, std::uint64_t id, std::uint32_t count) {
            return taken(w.get().emit(id_of<EmitterId>(id), count));
          },
          "id"_a, "count"_a)
      .def(
          "move_emitter",
          [](PyWorld& w, std::uint64_t id, const std::vector<double>& position, const std::vector<double>& rotation) {
            taken(w.get().move_emitter(id_of<EmitterId>(id), transform_of(position, rotation, 1)));
          },
          "id"_a, "position"_a, "rotation"_a)
      .def(
          "set_scene",
          [](PyWorld& w, const Setup& setup, nb::object engine, double skin) {
            if (setup.scenario.things.empty() && engine.is_none()) return taken(w.get().remove_scene());
            Scene scene = taken(scene_of(setup.scenario));
            if (!engine.is_none()) taken(scene.set_engine({engine_query(w.keep(engine, "engine")), skin}));
            taken(w.get().set_scene(scene));
          },
          "setup"_a, "engine"_a.none(), "skin"_a)
      .def(
          "move_thing",
          [](PyWorld& w, std::uint64_t id, const std::vector<double>& position, const std::vector<double>& rotation,
             double scale) {
            taken(w.get().move_instance(id_of<InstanceId>(id), transform_of(position, rotation, scale)));
          },
          "id"_a, "position"_a, "rotation"_a, "scale"_a)
      .def(
          "in_ball",
          [](PyWorld& w, const std::vector<double>& middle, double radius, std::uint32_t layers) {
            return id_column(taken(w.read().projectiles_in(vec_of(middle, "middle"), radius, layers)));
          },
          "middle"_a, "radius"_a, "layers"_a)
      .def(
          "in_box",
          [](PyWorld& w, const std::vector<double>& middle, const std::vector<double>& half,
             const std::vector<double>& rotation, std::uint32_t layers) {
            const Transform at = transform_of(middle, rotation, 1);
            return id_column(taken(w.read().projectiles_in(at, vec_of(half, "half"), layers)));
          },
          "middle"_a, "half"_a, "rotation"_a, "layers"_a)
      .def(
          "cast",
          [](PyWorld& w, const std::vector<double>& from, const std::vector<double>& to, double radius,
             std::uint32_t layers) {
            const auto hits =
                taken(w.read().projectiles_along(vec_of(from, "start"), vec_of(to, "end"), radius, layers));
            nb::dict out;
            out["id"] = column_of<std::uint64_t>(hits, [](const ProjectileHit& h) { return number_of(h.id); });
            out["part"] = column_of<double>(hits, [](const ProjectileHit& h) { return h.part; });
            out["position"] = rows_of(hits, [](const ProjectileHit& h) { return h.position; });
            out["normal"] = rows_of(hits, [](const ProjectileHit& h) { return h.normal; });
            return out;
          },
          "start"_a, "end"_a, "radius"_a, "layers"_a)
      .def(
          "set_conveyor",
          [](PyWorld& w, std::uint64_t id, const std::vector<double>& velocity) {
            taken(w.get().set_instance_conveyor(id_of<InstanceId>(id), {vec_of(velocity, "velocity")}));
          },
          "id"_a, "velocity"_a)
      .def(
          "remove_thing", [](PyWorld& w, std::uint64_t id) { taken(w.get().remove_instance(id_of<InstanceId>(id))); },
          "id"_a)
      .def(
          "set_hit_function",
          [](PyWorld& w, nb::object function) {
            World& world = w.get();
            taken(world.set_hit_function(hit_function(w.keep(std::move(function), "on_hit"))));
          },
          "function"_a)
      .def(
          "set_environment",
          [](PyWorld& w, const Setup& setup) { taken(w.get().set_environment(0, setup.scenario.environment)); },
          "setup"_a)
      .def(
          "set_observer",
          [](PyWorld& w, const std::vector<double>& place) { taken(w.get().set_observer(vec_of(place, "observer"))); },
          "place"_a);
}

void add_moments(nb::class_<PyWorld>& c) {
  c.def("snapshot",
        [](PyWorld& w) {
          PySnapshot s;
          if (WorldRun* run = w.run())
            s.run = run->snapshot();
          else
            s.own = w.read().snapshot();
          if (!s.own && !s.run) fail("no snapshot is taken inside a step", "world");
          return s;
        })
      .def(
          "restore",
          [](PyWorld& w, const PySnapshot& s) {
            if (WorldRun* run = w.run()) {
              if (!s.run || !run->restore(s.run)) fail("the snapshot is of another world", "snapshot");
            } else {
              if (!s.own) fail("the snapshot is of another world", "snapshot");
              taken(w.get().restore(s.own));
            }
            w.forget();
          },
          "snapshot"_a)
      .def("save",
           [](PyWorld& w) {
             WorldRun* run = w.run();
             return bytes_of(run != nullptr ? taken(run->save()) : taken(w.read().save()));
           })
      .def(
          "record", [](PyWorld& w, const std::string& file) { taken(record_to_file(w.get(), file)); }, "file"_a)
      .def("stop_recording", [](PyWorld& w) { taken(w.get().stop_recording()); });
}

// A function of a world often holds that world, as a method of what holds both: the garbage collector sees the way.
int visit_functions(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (!nb::inst_ready(self)) return 0;
  for (const Function& each : nb::inst_ptr<PyWorld>(self)->functions()) Py_VISIT(each.held().ptr());
  return 0;
}
int let_functions_go(PyObject* self) {
  if (!nb::inst_ready(self)) return 0;
  for (const Function& each : nb::inst_ptr<PyWorld>(self)->functions()) each.let_go();
  return 0;
}
PyType_Slot kCollected[] = {
    {Py_tp_traverse, (void*)visit_functions}, {Py_tp_clear, (void*)let_functions_go}, {0, nullptr}};

}  // namespace

void add_world(nb::module_& m) {
  nb::class_<PySnapshot>(m, "Snapshot", "A frozen moment of a world.").def_prop_ro("time", [](const PySnapshot& s) {
    return s.run ? s.run.time() : s.own.time();
  });
  nb::class_<PyWorld> c(m, "World", nb::type_slots(kCollected), "Many projectiles, stepped by frame.");
  c.def_static("make", &make_world, "setup"_a, "A world of its own.")
      .def_static("run", &run_world, "setup"_a, "recording"_a, "The world of a scenario.")
      .def_static("load", &load_world, "setup"_a, "save"_a, "is_run"_a, "forces"_a, "wind_fields"_a, "force_fields"_a,
                  "on_hit"_a.none(), "engine"_a.none())
      .def_static("replay", &replay_world, "file"_a, "The world that a recording moves.")
      .def("next", &PyWorld::next, "Plays the recording up to the next steps.")
      .def("seek", &PyWorld::seek, nb::arg("steps"), "Goes behind a step of the recording.")
      .def("report", [](const PyWorld& w) {
        if (!w.replay()) fail("no recording moves this world", "world");
        return report_table(w.replay()->report());
      });
  add_reads(c);
  add_changes(c);
  add_moments(c);
  m.def("replay", &replay_file, "file"_a, "Plays a recording again and compares.");
  m.def(
      "things",
      [](const Setup& setup) {
        nb::dict all;
        const SceneParts parts = taken(scene_parts(setup.scenario));
        for (std::size_t i = 0; i < parts.things.size(); ++i)
          all[setup.scenario.things[i].name.c_str()] = number_of(parts.things[i]);
        return all;
      },
      "setup"_a, "Ids of a scenario's things, by name.");
}

}  // namespace physim::python
