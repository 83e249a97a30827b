// Worlds: made, spawned into, stepped, read and written.
#include <algorithm>
#include <array>

#include "base/ieee_mode.hpp"
#include "capi/objects.hpp"
#include "capi/parts.hpp"
#include "scenario/document.hpp"
#include "scenario/names.hpp"
#include "scenario/reader.hpp"
#include "scenario/writer.hpp"

namespace physim::capi {
namespace {

static_assert(sizeof(physim_id) == sizeof(ProjectileId) && offsetof(physim_id, generation) == sizeof(std::uint32_t));
constexpr std::size_t kChunk = 256;  // rows that are read at a time, without memory of their own

Result<std::shared_ptr<WorldObject>> make_world(const Scenario& scenario, physim_firing firing) {
  auto made = std::make_shared<WorldObject>();
  if (firing == PHYSIM_FIRE_ALL) {
    Result<WorldRun> run = WorldRun::create(scenario);
    if (!run) return run.error();
    made->run.emplace(std::move(*run));
  } else {
    WorldDef def = scenario.world.def;
    def.environment = scenario.environment;
    def.tolerance = scenario.tolerance;
    Result<World> world = World::create(def);
    if (!world) return world.error();
    made->own = std::move(*world);
    if (scenario.world.observer != Vec3d{})
      if (Status status = made->own.set_observer(scenario.world.observer); !status) return status.error();
  }
  if (Status status = add_things(*made, scenario); !status) return status.error();
  PHYSIM_ASSERT(made->things.size() == scenario.things.size());
  return made;
}

/// The bytes from one row of a column to the next.
struct Strides {
  std::size_t given;
  template <class T>
  T* at(T* column, std::size_t row, std::size_t width = 1) const {
    using Byte = std::conditional_t<std::is_const_v<T>, const std::byte, std::byte>;
    using Void = std::conditional_t<std::is_const_v<T>, const void, void>;
    PHYSIM_ASSERT(column != nullptr && width > 0);
    if (given == 0) return column + row * width;
    return static_cast<T*>(static_cast<Void*>(static_cast<Byte*>(static_cast<Void*>(column)) + row * given));
  }
};

void need_stride(Call& call, const physim_states& columns) {
  const bool has_doubles = columns.position || columns.velocity || columns.previous || columns.shown ||
                           columns.angular_velocity || columns.orientation || columns.user_data;
  const std::size_t unit = has_doubles ? sizeof(double) : sizeof(float);
  call.need(columns.stride % unit == 0 && columns.stride < (std::size_t{1} << 32), "stride",
            "is no size of a struct with such members");
}

/// What of a row is not in the columns of a world.
void put_rest(const ProjectileView& p, const physim_states& into, std::size_t row) {
  const Strides by{into.stride};
  if (into.shown) put(by.at(into.shown, row, 3), p.render_position());
  if (into.shown_f) put(by.at(into.shown_f, row, 3), p.render_position());
  if (into.angular_velocity) put(by.at(into.angular_velocity, row, 3), p.angular_velocity());
  if (into.orientation) put(by.at(into.orientation, row, 4), p.orientation());
  if (into.user_data) *by.at(into.user_data, row) = p.user_data();
}

/// Rows first, first + 1, ... of these projectiles.
void put_states(const World& world, std::span<const ProjectileId> ids, const physim_states& into, std::size_t first) {
  const Strides by{into.stride};
  std::array<BodyState, kChunk> states;
  PHYSIM_ASSERT(ids.size() <= kChunk);
  const std::span<BodyState> read = std::span(states).first(ids.size());
  world.states(ids, read);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::size_t row = first + i;
    const ProjectileView p = world[ids[i]];
    if (into.id) *by.at(into.id, row) = put_id(ids[i]);
    if (into.position) put(by.at(into.position, row, 3), read[i].position);
    if (into.velocity) put(by.at(into.velocity, row, 3), read[i].velocity);
    if (into.position_f) put(by.at(into.position_f, row, 3), read[i].position);
    if (into.velocity_f) put(by.at(into.velocity_f, row, 3), read[i].velocity);
    if (into.previous) put(by.at(into.previous, row, 3), p.previous_position());
    put_rest(p, into, row);
  }
}

/// A vector of each row, from three columns of a world.
template <class To, class From>
void put_vectors(const std::array<std::span<const From>, 3>& from, std::size_t rows, To* into, const Strides& by) {
  if (into == nullptr) return;
  for (std::size_t i = 0; i < rows; ++i) {
    To* const to = by.at(into, i, 3);
    for (std::size_t axis = 0; axis < 3; ++axis) to[axis] = static_cast<To>(from[axis][i]);
  }
}

/// Columns that begin so many rows further on.
physim_states after(physim_states columns, std::size_t rows) {
  const Strides by{columns.stride};
  const auto move = [&](auto*& column, std::size_t width) {
    if (column != nullptr) column = by.at(column, rows, width);
  };
  move(columns.id, 1), move(columns.user_data, 1), move(columns.orientation, 4);
  for (double** column :
       {&columns.position, &columns.velocity, &columns.previous, &columns.shown, &columns.angular_velocity})
    move(*column, 3);
  for (float** column : {&columns.position_f, &columns.velocity_f, &columns.shown_f}) move(*column, 3);
  return columns;
}

/// All that are alive, as they lie in memory; returns how many there are.
std::size_t put_all(const World& world, std::size_t room, const physim_states& into) {
  const Strides by{into.stride};
  const bool has_rest = into.shown || into.shown_f || into.angular_velocity || into.orientation || into.user_data;
  std::vector<WorldColumns> cohorts;
  world.columns(cohorts);
  std::size_t first = 0;
  for (const WorldColumns& cohort : cohorts)
    std::visit(
        [&](const auto& c) {
          const std::size_t rows = std::min(c.index.size(), room - std::min(room, first));
          if (rows == 0) return;
          const physim_states here = after(into, first);
          put_vectors(c.position, rows, here.position, by);
          put_vectors(c.velocity, rows, here.velocity, by);
          put_vectors(c.position, rows, here.position_f, by);
          put_vectors(c.velocity, rows, here.velocity_f, by);
          put_vectors(c.previous, rows, here.previous, by);
          for (std::size_t i = 0; (here.id || has_rest) && i < rows; ++i) {
            const ProjectileId id = world.id_at(c.index[i]);
            if (here.id) *by.at(here.id, i) = put_id(id);
            if (has_rest) put_rest(world[id], here, i);
          }
          first += rows;
        },
        cohort);
  PHYSIM_ASSERT(first == std::min(room, world.size()));
  return world.size();
}

/// A place or velocity of a row, whichever of two columns has it; nothing if neither is there.
std::optional<Vec3d> row_of(const Strides& by, const double* exact, const float* rounded, std::size_t row) {
  if (exact != nullptr) return vector_at(by.at(exact, row, 3));
  if (rounded == nullptr) return std::nullopt;
  const float* v = by.at(rounded, row, 3);
  return Vec3d{v[0], v[1], v[2]};
}

/// Writes a row; false if the projectile does not take it.
bool put_row_into(World& world, ProjectileId id, const physim_states& from, std::size_t row) {
  PHYSIM_ASSERT(from.stride % sizeof(float) == 0);
  const Strides by{from.stride};
  const std::optional<Vec3d> position = row_of(by, from.position, from.position_f, row);
  const std::optional<Vec3d> velocity = row_of(by, from.velocity, from.velocity_f, row);
  Projectile p = world[id];
  bool taken = p.is_alive();
  if (taken && position && velocity)
    taken = p.set_state({*position, *velocity}).ok();
  else if (taken && position)
    taken = p.set_position(*position).ok();
  else if (taken && velocity)
    taken = p.set_velocity(*velocity).ok();
  if (taken && from.angular_velocity)
    taken = p.set_angular_velocity(vector_at(by.at(from.angular_velocity, row, 3))).ok();
  if (taken && from.user_data) taken = p.set_user_data(*by.at(from.user_data, row)).ok();
  return taken;
}

/// A projectile of a world as a shot of a scenario, whose settings have paths.
struct AsShot {
  Scenario scenario;
  ScenarioShot shot;
  explicit AsShot(const ProjectileView& p) {
    if (p.definition() != nullptr) shot.projectile = *p.definition();
    shot.projectile.fidelity = p.fidelity_in_use().fidelity;
    shot.body = p.body();
  }
};

/// The setting of a path below [[shot]].
Result<const SchemaNode*> node_of_shot(std::string_view path) {
  const SchemaNode* node = find_node(path.starts_with("shot.") ? std::string(path) : "shot." + std::string(path));
  PHYSIM_ASSERT(node == nullptr || node->path.starts_with("shot."));
  if (node == nullptr || node->entry == nullptr)
    return Error{"no projectile has such a setting", std::string(path), "physim list settings shows all of shot"};
  return node;
}

Status set_live(Projectile p, std::string_view path, std::string_view value) {
  const auto node = node_of_shot(path);
  if (!node) return node.error();
  AsShot as(p);
  const Scope scope{.scenario = &as.scenario, .shot = &as.shot};
  const Place place{std::make_shared<const std::string>(path), 0, 0};
  if (Status status = read_setting(**node, scope, parse_override_value(value, place)); !status) return status;
  if ((*node)->path.starts_with("shot.fidelity")) return p.set_fidelity(as.shot.projectile.fidelity);
  if ((*node)->path.starts_with("shot.body")) return p.set_body(as.shot.body);
  PHYSIM_ASSERT(p.definition() != nullptr);
  as.shot.projectile.fidelity = p.definition()->fidelity;
  return p.set_projectile(as.shot.projectile);
}

}  // namespace

Status add_things(WorldObject& world, const Scenario& scenario) {
  if (world.run) world.things.assign(world.run->things().begin(), world.run->things().end());
  if (world.run || scenario.things.empty()) return {};
  const Result<SceneParts> parts = scene_parts(scenario);
  if (!parts) return parts.error();
  world.things = parts->things;
  return world.own.set_scene(parts->scene);
}

Result<KindId> add_kind(WorldObject& object, const Scenario& scenario, std::size_t index, std::uint32_t environment,
                        std::uint32_t flags) {
  PHYSIM_ASSERT(index < scenario.shots.size());
  ScenarioShot shot = scenario.shots[index];
  const ScenarioNames names(scenario);
  if (const auto pool = names.pools.find(shot.pool); pool && !shot.pool.empty())
    shot.body.pool = static_cast<std::uint32_t>(*pool);
  shot.body.environment = environment;
  if (flags & PHYSIM_ASK_HITS) shot.body.collision.on_hit = OnHit::ask;
  shot.body.cheapest_within = shot.cheapest_within.value_or(0);
  const Result<KindId> kind = object.world().add_kind(shot.projectile, shot.body);
  if (kind) object.launches.emplace(kind->index, shot.launch);
  return kind;
}

}  // namespace physim::capi

using namespace physim;
using namespace physim::capi;

physim_result physim_world_create(const physim_def* def, physim_firing firing, physim_world** world) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(world, "world");
    call.need(firing == PHYSIM_FIRE_NOTHING || firing == PHYSIM_FIRE_ALL, "firing", "is neither of the two");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    auto made = make_world((*checked)->scenario, firing);
    if (call.take(made)) call.give(world, std::move(*made));
  });
}

physim_result physim_world_read(const physim_world* world, physim_world_info* info) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need_struct(info, "info");
    if (!call.ok()) return;
    const World& w = of->world();
    const WorldCounters& counters = w.counters();
    call.write(info, {.size = 0,
                      .joints = static_cast<std::uint32_t>(w.joint_counts().joints),
                      .time = w.time(),
                      .fraction = w.fraction(),
                      .step = w.def().step,
                      .planned_steps = of->run ? of->run->steps() : 0,
                      .projectiles = w.size(),
                      .events = w.events().size(),
                      .forces = w.force_count(),
                      .memory = w.memory(),
                      .steps = counters.steps,
                      .projectile_steps = counters.projectile_steps,
                      .refused = counters.refused,
                      .dropped_events = counters.dropped_events});
  });
}

physim_result physim_world_hash(const physim_world* world, uint64_t* hash) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(hash, "hash");
    if (call.ok()) *hash = of->world().hash();
  });
}

physim_result physim_world_set_environment(physim_world* world, uint32_t index, const physim_def* def) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(def, "def");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (call.take(checked)) call.take(into->world().set_environment(index, (*checked)->scenario.environment));
  });
}

physim_result physim_world_add_environment(physim_world* world, const physim_def* def, uint32_t* index) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(def, "def");
    call.need(index, "index");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    const Result<std::uint32_t> added = into->world().add_environment((*checked)->scenario.environment);
    if (call.take(added)) *index = *added;
  });
}

physim_result physim_world_set_detail(physim_world* world, const physim_def* def) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(def, "def");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (call.take(checked)) call.take(into->world().set_detail((*checked)->scenario.world.def.detail));
  });
}

physim_result physim_world_do(physim_world* world, physim_world_action action, double value) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(!std::isnan(value), "value", "is not a number");
    call.need(action >= PHYSIM_CLEAR && action <= PHYSIM_TIME_SCALE, "action", "is none");
    if (!call.ok()) return;
    World& w = into->world();
    if (action == PHYSIM_CLEAR) w.clear();
    if (action == PHYSIM_PAUSE) w.set_paused(value != 0);
    if (action == PHYSIM_SINGLE_STEP) w.single_step();
    if (action == PHYSIM_TIME_SCALE) call.take(w.set_time_scale(value));
  });
}

physim_result physim_world_rest(physim_world* world, const physim_id* ids, size_t count, int32_t sleep,
                                size_t* changed) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need_rows(ids, count, "ids");
    if (!call.ok()) return;
    std::size_t total = 0;
    for (std::size_t i = 0; i < count; ++i) {
      Projectile p = into->world()[id_of<ProjectileId>(ids[i])];
      total += (sleep != 0 ? p.sleep() : p.wake()).ok();
    }
    if (changed != nullptr) *changed = total;
  });
}

physim_result physim_world_spawn_moving(physim_world* world, const physim_def* def, const char* shot,
                                        const double position[3], const double velocity[3], double age, physim_id* id) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(def, "def");
    call.need(position, "position");
    call.need(velocity, "velocity");
    call.need(!std::isnan(age), "age", "is not a number");
    call.need(id, "id");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    const auto index = shot_in((*checked)->scenario, shot);
    if (!call.take(index, PHYSIM_NOT_FOUND)) return;
    const ScenarioShot& one = (*checked)->scenario.shots[*index];
    const Departure departure{.position = vector_at(position), .velocity = vector_at(velocity), .age = age};
    const Result<ProjectileId> born = into->world().spawn_departed(one.projectile, departure, one.body);
    if (call.take(born)) *id = put_id(*born);
  });
}

physim_result physim_world_set_observer(physim_world* world, const double position[3]) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(position, "position");
    if (call.ok()) call.take(into->world().set_observer(vector_at(position)));
  });
}

physim_result physim_world_add_kind(physim_world* world, const physim_def* def, const char* shot, uint32_t environment,
                                    uint32_t flags, uint32_t* kind) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(def, "def");
    call.need(flags <= PHYSIM_ASK_HITS, "flags", "has a bit that is none");
    call.need(kind, "kind");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (!call.take(checked)) return;
    const auto index = shot_in((*checked)->scenario, shot);
    if (!call.take(index, PHYSIM_NOT_FOUND)) return;
    const Result<KindId> added = add_kind(*into, (*checked)->scenario, *index, environment, flags);
    if (call.take(added)) *kind = added->index;
  });
}

physim_result physim_world_spawn(physim_world* world, uint32_t kind, size_t count, const physim_launches* launches,
                                 physim_id* ids, size_t* spawned) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const physim_launches given = call.read(launches, "launches");
    call.need(count > 0, "count", "is 0");
    call.need_rows(into ? into.get() : nullptr, count, "count");
    if (!call.ok()) return;
    const auto usual = into->launches.find(kind);
    if (usual == into->launches.end())
      return call.fail(PHYSIM_NOT_FOUND, "this world has no such kind", "kind", "physim_world_add_kind() makes kinds");
    LaunchColumns columns = columns_of(given, count);
    if (columns.has_drag()) return call.fail(PHYSIM_REFUSED, "all of a kind have one drag", "launches", "add kinds");
    columns.common = usual->second;
    if (count == 1) {  // alone it says why it is refused
      const double delay = given.delay != nullptr ? given.delay[0] : 0;
      const Result<ProjectileId> one = into->world().spawn(KindId{kind}, columns.at(0), delay);
      if (ids != nullptr) *ids = one ? put_id(*one) : physim_id{0, 0};
      if (spawned != nullptr) *spawned = one.ok();
      return static_cast<void>(call.take(one));
    }
    std::array<Launch, kChunk> chunk;
    std::array<ProjectileId, kChunk> born;
    std::size_t total = 0;
    for (std::size_t first = 0; first < count; first += kChunk) {
      const std::size_t rows = std::min(kChunk, count - first);
      PHYSIM_ASSERT(rows > 0 && rows <= kChunk);
      for (std::size_t i = 0; i < rows; ++i) chunk[i] = columns.at(first + i);
      if (given.delay == nullptr) {
        total += into->world().spawn(KindId{kind}, std::span(chunk).first(rows), std::span(born).first(rows));
      } else {
        for (std::size_t i = 0; i < rows; ++i) {
          const Result<ProjectileId> one = into->world().spawn(KindId{kind}, chunk[i], given.delay[first + i]);
          born[i] = one ? *one : ProjectileId{};
          total += one.ok();
        }
      }
      for (std::size_t i = 0; ids != nullptr && i < rows; ++i) ids[first + i] = put_id(born[i]);
    }
    if (spawned != nullptr) *spawned = total;
  });
}

physim_result physim_world_spawn_flight(physim_world* world, const physim_flight* flight, double time, physim_id* id) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    const auto from = call.find(flight, "flight");
    call.need(!std::isnan(time), "time", "is not a number");
    call.need(id, "id");
    if (!call.ok()) return;
    const Result<ProjectileId> born = into->world().spawn(from->flight, time);
    if (call.take(born)) *id = put_id(*born);
  });
}

physim_result physim_world_despawn(physim_world* world, const physim_id* ids, size_t count, size_t* gone) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need_rows(ids, count, "ids");
    if (!call.ok()) return;
    const std::size_t there = into->world().despawn({same_memory<const ProjectileId>(ids), count});
    if (gone != nullptr) *gone = there;
  });
}

physim_result physim_world_step(physim_world* world, uint64_t count, double dt) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(dt >= 0, "dt", "is negative, or not a number");
    if (!call.ok()) return;
    if (into->run && dt != 0)
      return call.fail(PHYSIM_REFUSED, "a world that fires by itself takes its own steps", "dt", "give 0");
    for (std::uint64_t i = 0; i < count && call.ok(); ++i) {
      if (into->run)
        into->run->step();
      else
        call.take(into->own.step(dt > 0 ? dt : into->own.def().step));
    }
  });
}

physim_result physim_world_advance(physim_world* world, double seconds, uint32_t* steps) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need(seconds >= 0 && seconds < 1e9, "seconds", "is not 0 to 1e9");
    if (!call.ok()) return;
    if (into->run) return call.fail(PHYSIM_REFUSED, "it fires by itself", "world", "call physim_world_step()");
    const int taken = into->own.advance(seconds);
    if (steps != nullptr) *steps = static_cast<std::uint32_t>(taken);
  });
}

physim_result physim_world_events(const physim_world* world, size_t first, physim_event* into, size_t each, size_t room,
                                  size_t* count) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    if (call.ok()) put_events(call, of->world().events(), first, into, each, room, count);
  });
}

namespace {

/// A canvas of the caller's functions; those that are null draw nothing.
class GivenCanvas final : public SceneCanvas {
 public:
  explicit GivenCanvas(const physim_canvas& canvas) : canvas_(canvas) {}

  void begin_projectile(ProjectileId projectile) override {
    if (canvas_.begin != nullptr) canvas_.begin(canvas_.user, put_id(projectile));
  }
  void line(const Vec3d& a, const Vec3d& b, SceneInk ink) override {
    if (canvas_.line != nullptr) canvas_.line(canvas_.user, &a.x, &b.x, int(ink));
  }
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, SceneInk ink) override {
    if (canvas_.triangle != nullptr) canvas_.triangle(canvas_.user, &a.x, &b.x, &c.x, int(ink));
  }
  void ball(const Vec3d& middle, double radius, SceneInk ink) override {
    if (canvas_.ball != nullptr) return canvas_.ball(canvas_.user, &middle.x, radius, int(ink));
    SceneCanvas::ball(middle, radius, ink);
  }
  void text(const Vec3d& place, std::string_view text) override {
    if (canvas_.text != nullptr) canvas_.text(canvas_.user, &place.x, std::string(text).c_str());
  }

 private:
  const physim_canvas canvas_;
};
static_assert(int(SceneInk::joint) == PHYSIM_INK_JOINT && int(SceneInk::flying) == PHYSIM_INK_FLYING);

}  // namespace

physim_result physim_world_draw(const physim_world* world, const physim_drawing* what, const physim_canvas* canvas) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(what, "what");
    call.need(canvas, "canvas");
    const physim_drawing given = call.read(what, "what");
    GivenCanvas onto(call.read(canvas, "canvas"));
    for (const double size : {given.point_size, given.ahead, given.normals})
      call.need(size >= 0 && size <= 1e9, "what", "its lengths and times lie between 0 and 1e9");
    if (!call.ok()) return;
    WorldDrawing drawing;
    drawing.layers = given.layers;
    drawing.things = given.without_things == 0;
    drawing.joints = given.without_joints == 0;
    drawing.labels = drawing.scene.names = given.labels != 0;
    drawing.scene.boxes = given.boxes != 0;
    drawing.point_size = given.point_size;
    drawing.ahead = given.ahead;
    drawing.normals = given.normals;
    of->world().draw(onto, drawing);
  });
}

physim_result physim_world_states(const physim_world* world, const physim_id* ids, size_t count,
                                  const physim_states* into, size_t* read) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(into, "into");
    const physim_states columns = call.read(into, "into");
    call.need_rows(into, count, "count");
    need_stride(call, columns);
    if (!call.ok()) return;
    const World& w = of->world();
    if (ids == nullptr) {
      const std::size_t alive = put_all(w, count, columns);
      if (read != nullptr) *read = alive;
      return;
    }
    const std::span all(same_memory<const ProjectileId>(ids), count);
    for (std::size_t first = 0; first < count; first += kChunk)
      put_states(w, all.subspan(first, std::min(kChunk, count - first)), columns, first);
    if (read != nullptr) *read = count;
  });
}

physim_result physim_world_put(physim_world* world, const physim_id* ids, size_t count, const physim_states* from,
                               size_t* written) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need_rows(ids, count, "ids");
    call.need(from, "from");
    const physim_states columns = call.read(from, "from");
    need_stride(call, columns);
    if (!call.ok()) return;
    std::size_t total = 0;
    for (std::size_t i = 0; i < count; ++i)
      total += put_row_into(into->world(), id_of<ProjectileId>(ids[i]), columns, i);
    if (written != nullptr) *written = total;
  });
}

physim_result physim_world_push(physim_world* world, const physim_id* ids, size_t count, const double* impulses,
                                size_t* pushed) {
  return guarded([&](Call& call) {
    const auto into = call.find(world, "world");
    call.need_rows(ids, count, "ids");
    call.need_rows(impulses, count, "impulses");
    if (!call.ok()) return;
    std::size_t total = 0;
    for (std::size_t i = 0; i < count; ++i)
      total += into->world()[id_of<ProjectileId>(ids[i])].apply_impulse(vector_at(impulses + 3 * i)).ok();
    if (pushed != nullptr) *pushed = total;
  });
}

physim_result physim_world_projectile(const physim_world* world, physim_id id, physim_projectile* into) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need_struct(into, "into");
    if (!call.ok()) return;
    const ProjectileView p = of->world()[id_of<ProjectileId>(id)];
    if (p.status() == LifeStatus::unknown) return call.fail(PHYSIM_NOT_FOUND, "there is no such projectile", "id");
    physim_projectile out{};
    out.life = static_cast<std::int32_t>(p.status());
    out.kind = p.kind().index;
    out.layers = p.layers();
    out.colour = p.colour();
    out.asleep = p.is_asleep();
    out.user_data = p.user_data();
    out.age = p.age();
    out.mass = p.mass();
    out.mach = p.mach();
    put(out.position, p.position());
    put(out.velocity, p.velocity());
    if (p.is_alive()) put(out.acceleration, p.accelerations().total);
    put(out.orientation, p.orientation());
    put(out.angular_velocity, p.angular_velocity());
    call.write(into, out);
  });
}

physim_result physim_world_jerk(const physim_world* world, physim_id id, double jerk[3]) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(jerk, "jerk");
    if (!call.ok()) return;
    const ProjectileView p = of->world()[id_of<ProjectileId>(id)];
    if (!p.is_alive()) return call.fail(PHYSIM_NOT_FOUND, "there is no such projectile", "id");
    put(jerk, p.jerk());
  });
}

physim_result physim_world_set(physim_world* world, physim_id id, const char* path, const char* value) {
  return guarded([&](Call& call) {
    const IeeeMode mode;
    const auto into = call.find(world, "world");
    call.need(path, "path");
    call.need(value, "value");
    if (!call.ok()) return;
    const Projectile p = into->world()[id_of<ProjectileId>(id)];
    if (!p.is_alive()) return call.fail(PHYSIM_NOT_FOUND, "there is no such projectile", "id");
    call.take(set_live(p, path, value));
  });
}

physim_result physim_world_get(const physim_world* world, physim_id id, const char* path, char* into, size_t room,
                               size_t* length) {
  return guarded([&](Call& call) {
    const IeeeMode mode;
    const auto of = call.find(world, "world");
    call.need(path, "path");
    call.need_rows(into, room, "into");
    if (!call.ok()) return;
    const ProjectileView p = of->world()[id_of<ProjectileId>(id)];
    if (!p.is_alive()) return call.fail(PHYSIM_NOT_FOUND, "there is no such projectile", "id");
    const auto node = node_of_shot(path);
    if (!call.take(node, PHYSIM_NOT_FOUND)) return;
    AsShot as(p);
    const std::optional<std::string> text = written(*(*node)->entry, {.scenario = &as.scenario, .shot = &as.shot});
    if (!text) return call.fail(PHYSIM_NOT_FOUND, "has no value here", path);
    call.write_text(*text, into, room, length);
  });
}

physim_result physim_world_predict(const physim_world* world, physim_id id, double time, physim_flight** flight) {
  return guarded([&](Call& call) {
    const auto of = call.find(world, "world");
    call.need(time > 0, "time", "is not above 0");
    call.need(flight, "flight");
    if (!call.ok()) return;
    Flight flown = of->world().predict(id_of<ProjectileId>(id), time);
    if (flown.error()) return call.fail(PHYSIM_REFUSED, *flown.error());
    call.give(flight, std::make_shared<FlightObject>(FlightObject{std::move(flown)}));
  });
}
