// Session: a scenario being played. Its world, its clock, what was fired, and the way back.
//
// The clock is that of the simulation. The screen tells how much time has passed; while the session is paused none
// passes, for anything.
#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physim/world.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"
#include "simclient/core/hits.hpp"
#include "simclient/core/track.hpp"

namespace physim::client {

/// What the last steps cost; of the machine's clock, for display only.
struct StepCost {
  double seconds = 0;           // for one step, averaged over the last ones in which something moved
  double projectile_steps = 0;  // in one of these steps
  std::uint64_t moved = 0;      // projectiles, in the last step

  /// Time for one projectile in a step [s]; nothing before the first has moved.
  [[nodiscard]] std::optional<double> per_projectile_step() const {
    return projectile_steps > 0 ? std::optional(seconds / projectile_steps) : std::nullopt;
  }
};

struct DeterminismCheck {
  std::uint64_t steps = 0;
  std::uint64_t first = 0, second = 0;  // hashes after the steps, and after going back and stepping again
  std::uint64_t differs_at = 0;         // first step whose hashes differ, from 1; 0: none does
  [[nodiscard]] bool passed() const { return differs_at == 0 && first == second; }
};

class Session {
 public:
  /// Plays a scenario. Without a [world], its shots are there to be fired by hand. With a path everything is recorded.
  [[nodiscard]] static Result<Session> create(Scenario scenario, const std::string& recording = "");
  /// Plays a recording; nothing can be changed then.
  [[nodiscard]] static Result<Session> replay(std::vector<std::byte> recording, const std::string& file);

  // ---------------------------------------------------------------------------------------------------------- clock
  /// Time has passed on the screen [s]: takes the steps that fit into it; returns how many. It stops early where they
  /// take longer than `patience` [s of the machine's clock]; what is not simulated by then is dropped.
  int advance(double real_dt, double patience = std::numeric_limits<double>::infinity());
  void set_paused(bool paused) { paused_ = paused; }
  [[nodiscard]] bool is_paused() const { return paused_; }
  /// Pauses, and goes one step on.
  void single_step();
  /// Pauses, and goes one step back; false at the start, or as far back as is remembered.
  bool step_back();
  /// Pauses, and goes back or on to a step, or to the first that is remembered: within the next calls of advance(), as
  /// long as their patience lasts. Steps that were taken before come again to the bit, with what was changed by hand in
  /// them, until something else is changed by hand.
  void go_to(std::uint64_t step);
  /// As go_to(), to a time [s]: what flies is shown between two steps.
  void show_at(double time);
  [[nodiscard]] bool is_seeking() const { return target_.has_value(); }
  /// The first step that can be gone back to.
  [[nodiscard]] std::uint64_t first_step() const;
  /// The last step that is known: the one at hand, where it was not gone back from another.
  [[nodiscard]] std::uint64_t last_step() const { return ahead_ ? ahead_->step : step_; }
  /// Everything as at the start, with nothing fired by hand. With a path the new run is recorded.
  [[nodiscard]] Status restart(const std::string& recording = "");
  [[nodiscard]] double time_scale() const { return time_scale_; }
  void set_time_scale(double scale) { time_scale_ = scale; }
  /// How many seconds of simulation have passed in a second of the screen, lately: time_scale() where all is kept up
  /// with.
  [[nodiscard]] double time_scale_reached() const { return time_scale_ * kept_; }
  [[nodiscard]] double time() const { return world().time(); }
  [[nodiscard]] std::uint64_t step() const { return step_; }
  /// The time that dust of a hit stays in the air [s of the world].
  static constexpr double kDustTime = 0.7;
  /// The next moments look different from this one: the clock runs, and something moved in the last step, moves by
  /// itself or is played.
  [[nodiscard]] bool is_moving() const;
  [[nodiscard]] double step_length() const { return world().def().step; }

  // --------------------------------------------------------------------------------------------------------- firing
  /// Fires a shot now; its settings are bound to it from here on.
  [[nodiscard]] Result<ProjectileId> fire(const ScenarioShot& shot);
  /// Plays a flight that was computed whole, from now on and at any speed: it is read from its dense output, and takes
  /// no part in the world. Nothing changes it, and recordings do not hold it.
  [[nodiscard]] Result<ProjectileId> play(const ScenarioShot& shot, const Flight& flight);
  /// Changes a projectile in flight; `change` is one call of it that says whether it was done.
  template <class Change>
  Status edit(ProjectileId id, const Change& change) {
    if (is_replay()) return cannot_change();
    if (is_whole(id)) return Error{"its flight was computed whole: nothing changes it", "", "fire it into the world"};
    Status status = change(run_->world()[id]);
    if (status) edited(id);
    return status;
  }

  // -------------------------------------------------------------------------------------------------------- reading
  [[nodiscard]] const World& world() const { return replay_ ? replay_->world() : run_->world(); }
  [[nodiscard]] const Scenario& scenario() const { return scenario_; }
  [[nodiscard]] std::span<const Track> tracks() const { return tracks_; }
  [[nodiscard]] const Track* track(ProjectileId id) const;
  /// On things of the scene.
  [[nodiscard]] const HitLog& hits() const { return hits_; }
  /// Tracks and hits up to the last step that is known.
  [[nodiscard]] std::span<const Track> known_tracks() const { return ahead_ ? ahead_->tracks : tracks_; }
  [[nodiscard]] bool flies_at_last() const { return ahead_ ? ahead_->flies : world().size() > 0; }
  [[nodiscard]] const HitLog& known_hits() const { return ahead_ ? ahead_->hits : hits_; }
  /// "bullet #3", or its name alone where it is no track.
  [[nodiscard]] std::string title_of(const Hit& hit) const;
  [[nodiscard]] Colour colour_of(const Hit& hit) const;
  /// Opacity of a track, from 0 to 1: one that an emitter fired fades after it left the world [-].
  [[nodiscard]] double presence_of(const Track& track) const;
  /// The state of a projectile in words: "in flight", "at rest", "landed", "stopped by hill".
  [[nodiscard]] std::string fate_of(const Track& track) const;
  [[nodiscard]] std::optional<double> ground() const;
  /// The time of what is shown: the world's, and what is left over since the last step [s].
  [[nodiscard]] double shown_time() const { return world().time() + leftover_; }
  /// Where to draw a projectile of the world between the last two steps.
  [[nodiscard]] Vec3d shown_position(ProjectileId id) const;
  /// A projectile that flies, as it is drawn.
  struct Shown {
    Vec3d position, velocity;
    Accelerations accelerations;
    double mass = 0;  // [kg]
    Quatd attitude;   // flown, or nose along the path, or as a ball spins
    double yaw = 0;   // of its nose to its path, where the attitude is flown [rad]
  };
  [[nodiscard]] Shown shown(const Track& track) const;
  /// In the world, and of the flights that are played.
  [[nodiscard]] std::size_t in_flight() const;
  [[nodiscard]] const StepCost& cost() const { return cost_; }
  [[nodiscard]] bool is_replay() const { return replay_.has_value(); }
  [[nodiscard]] bool is_recording() const { return !is_replay() && run_->world().is_recording(); }
  /// Shots fired and projectiles changed by hand since the start.
  [[nodiscard]] std::uint64_t changes_by_hand() const { return by_hand_; }
  /// Memory of the moments that the session can go back to [bytes].
  [[nodiscard]] std::size_t way_back_memory() const { return moment_memory_; }
  [[nodiscard]] bool is_over() const { return over_; }  // of a replay: its end, or its first difference
  [[nodiscard]] const ReplayReport* replay_report() const { return replay_ ? &replay_->report() : nullptr; }

  // ---------------------------------------------------------------------------------------------------------- tools
  /// Completes a recording and gives the file its name.
  [[nodiscard]] Status stop_recording();
  /// Steps, goes back, steps again, and compares the hashes of every step; then stands where it stood.
  [[nodiscard]] Result<DeterminismCheck> check_determinism(std::uint64_t steps = 60);
  Status set_environment(const Environment& environment);
  /// The materials, shapes and things of a scenario instead of those of this one; what flies, flies on. Going back
  /// ends here.
  Status set_scene(const Scenario& changed);
  /// Emitters instead of those of this scenario: everything from the start, with nothing fired by hand, up to the
  /// moment at hand, or as far as a second of the machine's clock goes. Where they make no sense nothing changes.
  Status set_emitters(const std::vector<ScenarioEmitter>& emitters);
  /// Forgets the tracks of those that have left.
  void clear_tracks();

 private:
  struct Moment {
    std::uint64_t step = 0;
    RunSnapshot run;
    std::size_t memory = 0;  // [bytes]
    bool changed = false;    // by hand, behind its step
  };
  /// The moments after the present one.
  struct Ahead {
    std::vector<Track> tracks;
    HitLog hits;
    std::uint64_t step = 0;
    bool flies = false;  // something did
  };

  Session() = default;
  [[nodiscard]] Status start(const std::string& recording);
  [[nodiscard]] Status begin_replay();
  int seek(double patience);
  void jump_towards(std::uint64_t target);
  void follow_known();
  void end_of_known();
  void show_known();
  void begin_change();
  void thin_moments();
  void take_step();
  bool replay_step();
  void look();
  void follow_new(std::span<const ProjectileId> ids);
  void look_at_events(std::span<const Event> events);
  void look_at_wall();
  void look_at_hits();
  void follow_flights();
  [[nodiscard]] bool is_whole(ProjectileId id) const;
  [[nodiscard]] bool is_dusty() const;
  void begin_track(ProjectileId id, const std::string& name, Colour colour, bool by_hand);
  void add_track(Track track);
  void remember_moment(bool changed);
  void forget_moment(bool first);
  void forget_moments();
  void forget_after(double time);
  void edited(ProjectileId id);
  [[nodiscard]] static Error cannot_change();
  [[nodiscard]] Track* find(ProjectileId id);
  [[nodiscard]] TrackSample sample(const Track& track) const;
  void add_launch(Track& track) const;

  Scenario scenario_;  // as it was loaded
  std::optional<WorldRun> run_;
  std::optional<Replay> replay_;
  std::vector<std::byte> replayed_;  // to start again
  std::vector<Track> tracks_;
  HitLog hits_;
  std::deque<Moment> moments_;
  std::optional<Ahead> ahead_;           // nothing at the last step that was taken
  std::optional<std::uint64_t> target_;  // the step that is gone to
  std::size_t moment_memory_ = 0;        // of all of them [bytes]
  std::size_t most_tracks_of_run_ = 0;
  std::uint64_t step_ = 0, fired_ = 0, by_hand_ = 0;
  double leftover_ = 0;  // of the screen's time, less than a step [s]
  double time_scale_ = 1;
  double kept_ = 1;  // part of the time asked for that was simulated, lately
  bool paused_ = false, over_ = false;
  StepCost cost_;
};

/// The world of a scenario that has none: its ground is where its flights end.
[[nodiscard]] Scenario with_world(Scenario scenario);

/// How a session's world treats a shot: as its body says, and where the scenario has no world until its flights end,
/// by time and range.
[[nodiscard]] BodyDef body_of(const Scenario& scenario, const ScenarioShot& shot);

/// What there is when no scenario was asked for: open ground at height 0 and standard air.
[[nodiscard]] Scenario open_range();

}  // namespace physim::client
