#include "simclient/core/session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/assert.hpp"
#include "simclient/core/thinning.hpp"

namespace physim::client {
namespace {

constexpr std::size_t kMaxTracks = 64;
constexpr std::size_t kMaxTracksOfRun = 24, kMaxTracksOfCrowd = 5;  // of what the scenario fires by itself
constexpr std::size_t kMaxTracksOfSalvo = 8;                        // of a crowd, if its last ones came at once
constexpr double kMostAtOnce = 8.0 / 60;                            // of the screen's time [s]
constexpr double kPaceTime = 0.5;                                   // over which the pace is averaged [s]
constexpr double kInstant = 1e-9;                                   // times nearer than this are the same [s]

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Something that happened between two samples: with the acceleration and the air of the last one.
TrackSample within_step(const Track& track, double time, const Vec3d& position, const Vec3d& velocity) {
  TrackSample at = track.samples.back();
  const double speed = length(at.velocity);
  at.mach = speed > 0 ? at.mach * length(velocity) / speed : 0;
  at.time = time - track.born, at.position = position, at.velocity = velocity;
  return at;
}

/// True if a projectile has zero velocity in this sample and in the one before, at the same place.
bool rests(const Track& track, const TrackSample& now) {
  PHYSIM_ASSERT(!track.samples.empty());
  const auto before = std::find_if(track.samples.rbegin(), track.samples.rend(),
                                   [&](const TrackSample& sample) { return sample.time < now.time; });
  return now.velocity == Vec3d{} && before != track.samples.rend() && before->velocity == Vec3d{} &&
         before->position == now.position;
}

std::uint64_t launches(const Scenario& scenario) {
  std::uint64_t count = scenario.shots.size();
  for (const Volley& volley : scenario.volleys) count += static_cast<std::uint64_t>(volley.count);
  return count;
}

}  // namespace

Scenario open_range() {
  Scenario scenario;
  scenario.title = "Open range";
  scenario.file = "open range";
  return scenario;
}

Scenario with_world(Scenario scenario) {
  if (scenario.world.given) return scenario;
  scenario.world.given = true;
  WorldDef& def = scenario.world.def;
  def.ground.mode = scenario.until.ground ? GroundMode::land : GroundMode::none;
  def.ground.height = scenario.until.ground.value_or(0);
  if (scenario.tolerance.step > 0) def.step = scenario.tolerance.step;
  return scenario;
}

BodyDef body_of(const Scenario& scenario, const ScenarioShot& shot) {
  BodyDef body = shot.body;
  body.cheapest_within = shot.cheapest_within.value_or(0);
  const std::vector<PoolDef>& pools = scenario.world.def.pools;
  for (std::uint32_t i = 0; i < pools.size() && !shot.pool.empty(); ++i)
    if (pools[i].name == shot.pool) body.pool = i;
  if (scenario.world.given) return body;
  if (scenario.until.time < Until{}.time) body.despawn.older = scenario.until.time;
  if (scenario.until.range) body.despawn.farther = *scenario.until.range;
  return body;
}

// ---------------------------------------------------------------------------------------------------------- beginning
Result<Session> Session::create(Scenario scenario, const std::string& recording) {
  Session session;
  session.scenario_ = std::move(scenario);
  if (Status status = session.start(recording); !status) return status.error();
  return session;
}

Result<Session> Session::replay(std::vector<std::byte> recording, const std::string& file) {
  Session session;
  session.scenario_ = open_range();
  session.scenario_.title = "Replay of " + file;
  session.scenario_.file = file;
  session.replayed_ = std::move(recording);
  Result<Replay> replay = Replay::open(session.replayed_);
  if (!replay) return replay.error();
  session.replay_ = std::move(*replay);
  session.most_tracks_of_run_ = kMaxTracksOfRun;
  return session;
}

Status Session::start(const std::string& recording) {
  Scenario played = with_world(scenario_);
  if (!scenario_.world.given) played.shots.clear();          // they wait to be fired by hand
  played.world.def.apex_events |= launches(played) <= 1000;  // what a file asks for may set off others
  most_tracks_of_run_ = launches(played) <= 64 && played.emitters.empty() ? kMaxTracksOfRun : kMaxTracksOfCrowd;
  Result<WorldRun> run = WorldRun::create(std::move(played), recording);
  if (!run) return run.error();
  run_ = std::move(*run);
  tracks_.clear();
  hits_.clear();
  forget_moments();
  target_.reset();
  step_ = fired_ = by_hand_ = 0;
  leftover_ = 0;
  cost_ = {};
  look();
  remember_moment(true);
  return {};
}

Status Session::restart(const std::string& recording) {
  if (!is_replay()) return start(recording);
  target_.reset();
  return begin_replay();
}

Status Session::begin_replay() {
  Result<Replay> again = Replay::open(replayed_);
  if (!again) return again.error();
  replay_ = std::move(*again);
  tracks_.clear();
  hits_.clear();
  step_ = 0;
  leftover_ = 0;
  over_ = false;
  return {};
}

// --------------------------------------------------------------------------------------------------------------- clock
int Session::advance(double real_dt, double patience) {
  if (target_) return seek(patience);
  if (paused_ || over_ || !(real_dt > 0)) return 0;
  const auto start = std::chrono::steady_clock::now();
  const double h = step_length(), asked = real_dt * time_scale_;
  const int most = std::max(1, static_cast<int>(std::lround(kMostAtOnce * time_scale_ / h)));
  leftover_ += asked;
  int steps = 0;
  while (leftover_ > h * (1 - 1e-6) && steps < most && !over_ && seconds_since(start) < patience) {
    take_step();
    leftover_ -= h;
    ++steps;
  }
  if (steps > 0) show_known();
  follow_flights();
  const double dropped = std::max(leftover_ - h, 0.0);  // what the machine could not keep up with
  leftover_ = std::clamp(leftover_, 0.0, h);
  kept_ += (1 - std::min(dropped / asked, 1.0) - kept_) * std::min(real_dt / kPaceTime, 1.0);
  return steps;
}

void Session::take_step() {
  const std::uint64_t before = world().counters().projectile_steps;
  const auto start = std::chrono::steady_clock::now();
  if (replay_) {
    if (!replay_step()) return void(over_ = true);
  } else {
    run_->step();
  }
  const double seconds = seconds_since(start);
  cost_.moved = world().counters().projectile_steps - before;
  if (cost_.moved > 0) {
    const double part = cost_.seconds > 0 ? 0.05 : 1;  // of the average that is new
    cost_.seconds += (seconds - cost_.seconds) * part;
    cost_.projectile_steps += (static_cast<double>(cost_.moved) - cost_.projectile_steps) * part;
  }
  ++step_;
  if (ahead_) return follow_known();
  look();
  if (!replay_) remember_moment(false);
}

/// Call by call, so that launches are seen where they happen; false at the end.
bool Session::replay_step() {
  const std::uint64_t steps = replay_->report().steps;
  double time = world().time();
  while (replay_->next()) {
    if (world().time() < time) forget_after(world().time());  // the recorded session went back
    time = world().time();
    if (replay_->report().steps != steps) return true;
    for (const Event& event : world().events())
      if (event.kind == EventKind::spawned) follow_new({&event.id, 1});
  }
  return false;
}

bool Session::is_moving() const {
  if (target_) return true;
  if (paused_ || over_) return false;
  const physim::Scene* scene = world().scene();
  return cost_.moved > 0 || (scene != nullptr && scene->has_motion()) || is_dusty() ||
         std::ranges::any_of(tracks_, [](const Track& track) { return track.whole && track.is_flying(); });
}

bool Session::is_dusty() const {
  const auto is_new = [now = shown_time()](double time) { return now - time < kDustTime && now >= time; };
  return (!hits_.hits().empty() && is_new(hits_.hits().back().time)) ||
         std::ranges::any_of(
             tracks_, [&](const Track& track) { return track.impact && is_new(track.born + track.impact->time); });
}

void Session::single_step() {
  paused_ = true;
  leftover_ = 0;
  target_.reset();
  if (!over_) take_step();
  show_known();
  follow_flights();
}

// -------------------------------------------------------------------------------------------------------------- firing
Error Session::cannot_change() {
  return {"a replay cannot be changed", "", "load a scenario or restart without a recording"};
}

Result<ProjectileId> Session::fire(const ScenarioShot& shot) {
  if (is_replay()) return cannot_change();
  World& world = run_->world();
  const BodyDef body = body_of(scenario_, shot);
  const Result<ProjectileId> fired = world.spawn(shot.projectile, shot.launch, body);
  if (!fired) return fired;
  const ProjectileId id = *fired;
  begin_change();
  ++by_hand_;
  const bool has_colour = body.colour != kNoColour;
  begin_track(id, shot.projectile.name, has_colour ? body.colour : palette(fired_), true);
  tracks_.back().spin = spin_in_world(shot.launch);
  tracks_.back().shot = std::make_shared<const ScenarioShot>(shot);
  if (!has_colour) world[id].set_colour(tracks_.back().colour);
  remember_moment(true);
  return id;
}

void Session::edited(ProjectileId id) {
  begin_change();
  ++by_hand_;
  if (Track* track = find(id)) {
    track->edited = true;
    track->granted = world()[id].fidelity_in_use();
    add_sample(*track, sample(*track));
  }
  remember_moment(true);
}

Status Session::set_environment(const Environment& environment) {
  if (is_replay()) return cannot_change();
  if (Status status = run_->world().set_environment(0, environment); !status) return status;
  scenario_.environment = environment;
  begin_change();
  remember_moment(true);
  return {};
}

Status Session::set_scene(const Scenario& changed) {
  if (is_replay()) return cannot_change();
  World& world = run_->world();
  if (changed.things.empty()) {
    if (Status status = world.scene() != nullptr ? world.remove_scene() : Status(); !status) return status;
  } else {
    const Result<physim::Scene> scene = scene_of(changed);
    if (!scene) return scene.error();
    if (Status status = world.set_scene(*scene); !status) return status;
  }
  scenario_.materials = changed.materials;
  scenario_.shapes = changed.shapes;
  hits_.change_things(scenario_.things, changed.things);
  scenario_.things = changed.things;
  begin_change();
  forget_moments();
  remember_moment(true);
  return {};
}

Status Session::set_emitters(const std::vector<ScenarioEmitter>& emitters) {
  constexpr double kMost = 1;  // of the machine's clock [s]
  if (is_replay()) return cannot_change();
  if (is_recording()) return Error{"a recording is under way", "emitters", "complete it first: record"};
  Scenario changed = scenario_;
  changed.emitters = emitters;
  Result<Session> again = create(std::move(changed));
  if (!again) return again.error();
  const auto begun = std::chrono::steady_clock::now();
  while (again->step_ < step_ && seconds_since(begun) < kMost) again->take_step();
  again->paused_ = paused_;
  again->time_scale_ = time_scale_;
  *this = std::move(*again);
  return {};
}

Status Session::stop_recording() {
  if (is_replay()) return cannot_change();
  return run_->world().stop_recording();
}

Result<DeterminismCheck> Session::check_determinism(std::uint64_t steps) {
  if (is_replay()) return cannot_change();
  const RunSnapshot now = run_->snapshot();
  std::vector<std::uint64_t> hashes;
  DeterminismCheck check{.steps = steps};
  for (std::uint64_t i = 0; i < steps; ++i) {
    run_->step();
    hashes.push_back(run_->world().hash());
  }
  run_->restore(now);
  for (std::uint64_t i = 0; i < steps; ++i) {
    run_->step();
    check.first = hashes[i];
    check.second = run_->world().hash();
    if (check.differs_at == 0 && check.first != check.second) check.differs_at = i + 1;
  }
  run_->restore(now);
  return check;
}

// ------------------------------------------------------------------------------------------------------------- reading
std::optional<double> Session::ground() const {
  const Ground& ground = world().def().ground;
  return ground.mode == GroundMode::none ? std::nullopt : std::optional(ground.height);
}

const Track* Session::track(ProjectileId id) const {
  const auto found = std::find_if(tracks_.begin(), tracks_.end(), [id](const Track& t) { return t.id == id; });
  return found == tracks_.end() ? nullptr : &*found;
}

Track* Session::find(ProjectileId id) { return const_cast<Track*>(track(id)); }

/// Ahead of the last step by its velocity: exact where no time is left over.
Vec3d Session::shown_position(ProjectileId id) const {
  const BodyState at = world()[id].state();
  Vec3d shown = at.position + at.velocity * leftover_;
  if (const auto height = ground(); height && at.position.y >= *height) shown.y = std::max(shown.y, *height);
  return shown;
}

// -------------------------------------------------------------------------------------------------------------- tracks
TrackSample Session::sample(const Track& track) const {
  return sample_of(world()[track.id], world().time() - track.born);
}

void Session::begin_track(ProjectileId id, const std::string& name, Colour colour, bool by_hand) {
  Track track;
  track.id = id;
  track.name = name;
  track.colour = colour;
  track.by_hand = by_hand;
  const ProjectileDef* what = world()[id].definition();
  track.radius = what ? what->diameter / 2 : 0;
  if (what != nullptr) track.look = look_of(*what);
  for (const ScenarioShot& shot : scenario_.shots)
    if (!by_hand && shot.projectile.name == name) track.spin = spin_in_world(shot.launch);
  track.born = world().time() - world()[id].age();
  track.granted = world()[id].fidelity_in_use();
  if (what != nullptr && !what->motor.thrust.empty())
    track.burnout = what->motor.ignition_delay + burn_time(what->motor);
  if (!by_hand) add_launch(track);
  track.samples.push_back(sample(track));
  add_track(std::move(track));
}

/// In the place of one that has left, or of the oldest, where there are too many.
void Session::add_track(Track track) {
  if (tracks_.size() >= kMaxTracks) {
    auto oldest = std::find_if(tracks_.begin(), tracks_.end(), [](const Track& t) { return !t.is_flying(); });
    if (oldest == tracks_.end()) oldest = tracks_.begin();
    tracks_.erase(oldest);
  }
  track.number = ++fired_;
  if (track.name.empty()) track.name = "shot";
  tracks_.push_back(std::move(track));
}

/// The start of what the run has launched within its last step.
void Session::add_launch(Track& track) const {
  if (is_replay() || !(world()[track.id].age() > kInstant)) return;
  for (const RunEvent& each : run_->events())
    if (each.event.id == track.id && each.event.kind == EventKind::spawned)
      track.samples.push_back({0, each.event.position, each.event.velocity, world()[track.id].accelerations().total,
                               world()[track.id].mach(), world()[track.id].mass(), world()[track.id].jerk()});
}

void Session::look() {
  look_at_hits();
  look_at_events(world().events());
  if (!is_replay()) look_at_wall();
  for (Track& track : tracks_) {
    if (!track.is_flying() || track.whole) continue;
    if (!world()[track.id].is_alive()) {
      track.status = world()[track.id].status();
      continue;
    }
    TrackSample now = sample(track);
    if (rests(track, now)) now.acceleration = {};  // a world does not know it of what lies on other projectiles
    add_later(track, now);
  }
  if (tracks_.size() >= most_tracks_of_run_ || world().size() > 4096) return;
  follow_new(world().ids());
}

double Session::presence_of(const Track& track) const {
  constexpr double kFades = 2;  // [s]
  if (track.by_hand || track.is_flying() || scenario_.emitters.empty()) return 1;
  return std::clamp(1 - (time() - track.end()) / kFades, 0.0, 1.0);
}

/// Begins tracks of new projectiles that the run fired, within the limit of tracks. A salvo of a few projectiles gets
/// all its tracks or keeps to that limit: with a limit of five its sixth projectile would be a speck beside five balls.
void Session::follow_new(std::span<const ProjectileId> ids) {
  std::vector<ProjectileId> fresh;
  std::ranges::copy_if(ids, std::back_inserter(fresh), [this](ProjectileId id) {
    return world()[id].status() == LifeStatus::in_flight && track(id) == nullptr;
  });
  const std::size_t room = most_tracks_of_run_ - std::min(most_tracks_of_run_, tracks_.size());
  if (room == 0 || tracks_.size() + fresh.size() > std::max(most_tracks_of_run_, kMaxTracksOfSalvo))
    fresh.resize(std::min(room, fresh.size()));
  for (const ProjectileId id : fresh) {
    const Colour own = world()[id].colour();
    const ProjectileDef* what = world()[id].definition();
    begin_track(id, what ? what->name : "", own != kNoColour ? own : palette(fired_), false);
  }
}

void Session::look_at_events(std::span<const Event> events) {
  for (const Event& event : events) {
    Track* track = find(event.id);
    if (track == nullptr || track->samples.empty()) continue;
    const TrackSample at = within_step(*track, event.time, event.position, event.velocity);
    const bool ends = event.kind == EventKind::landed;
    if (event.kind == EventKind::apex && !track->apex) track->apex = at;
    if ((ends || event.kind == EventKind::bounced) && !track->impact) track->impact = at;
    if (ends) add_later(*track, at);
  }
}

void Session::look_at_wall() {
  for (const WallHit& hit : run_->hits()) {
    Track* track = find(hit.id);
    if (track == nullptr) continue;
    track->is_at_wall = true;
    if (track->impact) continue;
    track->impact = within_step(*track, hit.time, hit.position, hit.velocity);
    add_later(*track, *track->impact);
  }
}

/// Paths have a corner, or their end, where something was hit.
void Session::look_at_hits() {
  const std::uint64_t known = hits_.count();
  hits_.look_at(world(), world().events());
  const auto& hits = hits_.hits();
  for (std::size_t i = hits.size() - std::min<std::size_t>(hits.size(), hits_.count() - known); i < hits.size(); ++i) {
    Track* track = find(hits[i].id);
    if (track == nullptr || track->samples.empty()) continue;
    const TrackSample at = within_step(*track, hits[i].time, hits[i].position, hits[i].velocity);
    if (is_passed(hits[i])) continue;
    if (!track->impact) track->impact = at;
    add_later(*track, at);
  }
}

std::string Session::title_of(const Hit& hit) const {
  const Track* found = track(hit.id);
  return found != nullptr ? found->title() : hit.shot;
}

Colour Session::colour_of(const Hit& hit) const {
  const Track* found = track(hit.id);
  return found != nullptr ? found->colour : hit.colour;
}

std::string Session::fate_of(const Track& track) const {
  if (track.is_flying()) {
    const bool has_rested = !track.whole && (world()[track.id].is_asleep() || rests(track, track.samples.back()));
    return has_rested ? "at rest" : "in flight";
  }
  const Hit* last = hits_.last_of(track.id);
  const bool has_stopped = last != nullptr && last->outcome == EventKind::stopped;
  if (has_stopped && track.born + track.samples.back().time < last->time + 2 * step_length())
    return "stopped by " + last->thing;
  switch (track.status) {
    case LifeStatus::landed: return "landed";
    case LifeStatus::expired: return track.whole ? "at its end" : "expired";
    case LifeStatus::retired: return track.is_at_wall ? "stopped by the wall" : "taken out";
    case LifeStatus::unknown: return track.impact ? "hit" : "gone";
    case LifeStatus::pending:
    case LifeStatus::in_flight: break;
  }
  return "waits";
}

void Session::clear_tracks() {
  const auto has_left = [this](const Track& known) {
    const Track* shown = track(known.id);
    return shown != nullptr && !shown->is_flying();
  };
  if (ahead_) std::erase_if(ahead_->tracks, has_left);
  std::erase_if(tracks_, [](const Track& track) { return !track.is_flying(); });
}

}  // namespace physim::client
