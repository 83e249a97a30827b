// fly_batch(): sorts shots into cohorts, flies each cohort with the batch kernel, and gathers what comes back.
#include <algorithm>
#include <array>
#include <deque>
#include <limits>

#include "base/event_table.hpp"
#include "base/ieee_mode.hpp"
#include "flight/flight_record.hpp"
#include "flight/kernels.hpp"
#include "flight/pilot.hpp"
#include "flight/zero.hpp"
#include "model/drag_curves.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"
#include "prepare/grant.hpp"
#include "prepare/launch.hpp"
#include "prepare/watch_list.hpp"

namespace physim {
namespace {

/// Shots that fly together at a time: few enough to stay in the cache between preparing, flying and gathering.
constexpr std::size_t kChunk = 2048;

constexpr unsigned kLaunchNumbers = kLaunchParts.runs().numbers();
static_assert(kLaunchParts.runs().count == 1 && kLaunchParts.runs().run[0].first == 0, "a Body begins with them");

/// Shots whose granted rungs are equal, gathered until there is a chunk of them.
struct ShotGroup {
  Cohort cohort;
  std::optional<double> step;
  std::vector<std::uint32_t> shots;
  Body<double> common{};                            // what all bodies have ...
  PartSet own = PartSet::all();                     // ... but for these parts, the first ones of a Body ...
  std::vector<double> own_numbers;                  // ... which are here
  std::vector<Rotor<double>> rotors;                // of rungs that turn
  std::vector<std::pair<SpinDrift, Vec3d>> drifts;  // of the rung of that name, and where they point
  std::vector<Turn<double>> turned;                 // how they turn at their ends
  std::vector<RawEvent> events;

  void add(std::uint32_t shot, const Body<double>& body) {
    shots.push_back(shot);
    own_numbers.insert(own_numbers.end(), numbers(body), numbers(body) + own_stride());
  }
  [[nodiscard]] Body<double> body(std::size_t i) const {
    PHYSIM_ASSERT(i < shots.size() && own_numbers.size() == shots.size() * own_stride());
    Body<double> b = common;
    std::copy_n(own_numbers.data() + i * own_stride(), own_stride(), numbers(b));
    return b;
  }
  [[nodiscard]] unsigned own_stride() const { return own == kLaunchParts ? kLaunchNumbers : kNumbers<Body>; }
  void clear() {
    shots.clear();
    own_numbers.clear();
    rotors.clear();
    drifts.clear();
    events.clear();
  }
};

/// What is to be flown: shots with a projectile each, or launches of one.
struct ShotList {
  std::span<const Shot> shots;
  const ProjectileDef* one_projectile = nullptr;
  std::span<const Launch> launches;

  [[nodiscard]] std::size_t size() const { return one_projectile ? launches.size() : shots.size(); }
  [[nodiscard]] const ProjectileDef& projectile(std::size_t i) const {
    return one_projectile ? *one_projectile : shots[i].projectile;
  }
  [[nodiscard]] const Launch& launch(std::size_t i) const { return one_projectile ? launches[i] : shots[i].launch; }
};

/// A projectile checked and prepared; each of its shots writes its launch over that of the one before.
struct ShotKind {
  const ProjectileDef* projectile = nullptr;
  Status status;
  ShotGroup* group = nullptr;
  Body<double> body;
  Rotor<double> rotor;  // of rungs that turn
};

/// Orders events by shot; those of one shot already are in order of time. Counting places needs one pass, not a sort.
class ByShot {
 public:
  /// The numbers of the events, in order.
  template <class AnyEvent>
  const std::vector<std::uint32_t>& order(const std::vector<AnyEvent>& events, std::size_t shots) {
    place_.assign(shots + 1, 0);
    for (const AnyEvent& e : events) {
      PHYSIM_ASSERT(e.shot < shots);
      ++place_[e.shot + 1];
    }
    for (std::size_t i = 0; i < shots; ++i) place_[i + 1] += place_[i];
    order_.resize(events.size());
    for (std::uint32_t i = 0; i < events.size(); ++i) order_[place_[events[i].shot]++] = i;
    return order_;
  }

 private:
  std::vector<std::uint32_t> place_;  // memory for one order after another
  std::vector<std::uint32_t> order_;
};

bool is_by_shot(const std::vector<ShotEvent>& events) {
  return std::is_sorted(events.begin(), events.end(),
                        [](const ShotEvent& a, const ShotEvent& b) { return a.shot < b.shot; });
}

class Batch {
 public:
  Batch(const ShotList& shots, const Environment& environment, const Fidelity& fidelity, const Tolerance& tolerance,
        const Until& until, BatchResult& result)
      : shots_(shots),
        environment_(environment),
        fidelity_(fidelity),
        tolerance_(tolerance),
        until_(until),
        result_(result) {}

  void run() {
    result_.kernel = batch_kernel().name;
    result_.shots.resize(shots_.size());  // each is written once: how it ended, or that it was refused
    result_.attitudes.clear();
    result_.events.clear();
    result_.fidelity_in_use = {};
    result_.error.reset();
    for (const Status& status : {check(environment_), check(tolerance_, fidelity_), check(until_)})
      if (!status) return refuse_all(status.error());
    if (shots_.one_projectile)
      if (const Status status = check(*shots_.one_projectile); !status) return refuse_all(status.error());
    result_.events.reserve(shots_.size());
    for (std::uint32_t i = 0; i < shots_.size(); ++i) prepare(i);
    for (ShotGroup& group : groups_) fly(group);
    order_events();
  }

 private:
  void refuse(std::size_t i, const Error& error) {
    PHYSIM_ASSERT(i < result_.shots.size());
    result_.shots[i] = {};
    if (!result_.error) result_.error = error;
  }
  void refuse_all(const Error& error) {
    for (std::size_t i = 0; i < shots_.size(); ++i) refuse(i, error);
    result_.error = error;  // with no shots, too
  }

  /// Each chunk's are in order; those of several groups lie between each other.
  void order_events() {
    if (is_by_shot(result_.events)) return;
    const std::vector<ShotEvent> unsorted = result_.events;  // copied back, so that the result keeps its memory
    const auto& order = by_shot_.order(unsorted, shots_.size());
    for (std::size_t i = 0; i < order.size(); ++i) result_.events[i] = unsorted[order[i]];
  }

  /// What is known of a shot's projectile.
  ShotKind& kind_of(std::uint32_t i) {
    const ProjectileDef& projectile = shots_.projectile(i);
    if (kind_.projectile == &projectile) return kind_;
    kind_.projectile = &projectile;
    kind_.status = check(projectile);
    if (!kind_.status) return kind_;
    kind_.group = group_of(projectile);
    ShotGroup& group = *kind_.group;
    Cohort& cohort = group.cohort;
    kind_.body = prepare_kind(projectile, cohort.pool, cohort.conditions);
    if (turns(cohort.in_use.fidelity)) kind_.rotor = prepare_rotor_kind(projectile, cohort.pool, cohort.conditions);
    if (steps_by_frames(cohort.in_use.fidelity)) cohort.finish();  // frame_step() looks at its drag
    if (!shots_.one_projectile) return kind_;
    group.common = kind_.body;
    if (differ_by_launch_alone(cohort.conditions)) group.own = kLaunchParts;
    return kind_;
  }

  /// Whether a launch without a rail gives a Body only the first numbers: what else put_launch() sets is not read.
  static bool differ_by_launch_alone(const Conditions<double>& c) {
    return !spins(c.fidelity) && !is_in_repose(c.fidelity) && !c.has_motor &&
           c.fidelity.drag != DragModel::linear_quadratic;
  }

  void prepare(std::uint32_t i) {
    ShotKind& kind = kind_of(i);
    if (!kind.status) return refuse(i, kind.status.error());
    const ProjectileDef& projectile = *kind.projectile;
    const Launch& launch = shots_.launch(i);
    if (const auto status = check(launch); !status) return refuse(i, status.error());
    if (const auto status = check(projectile, launch); !status) return refuse(i, status.error());
    double elevation = launch.elevation;
    if (launch.sight.zero_range > 0) {
      const auto found = elevation_of(projectile, launch, environment_, fidelity_);
      if (!found) return refuse(i, found.error());
      elevation = *found;
    }
    ShotGroup* group = kind.group;
    Cohort& cohort = group->cohort;
    const Fidelity& granted = cohort.in_use.fidelity;
    if (!some_accepted_) result_.fidelity_in_use = cohort.in_use;
    some_accepted_ = true;
    if (launch.rail_length > 0 && group->own == kLaunchParts) {
      fly(*group);  // those without a rail
      group->own = PartSet::all();
    }
    Body<double>& body = kind.body;
    put_launch(projectile, launch, elevation, cohort.conditions, body);
    if (const auto status = check_fits(body.launch.x, body.launch.v, granted.precision); !status)
      return refuse(i, status.error());
    jump_in_crosswind(projectile, environment_, cohort.conditions, body);
    if (turns(granted)) put_launch(projectile, launch, elevation, body, cohort.conditions, kind.rotor);
    if (const auto outcome = ends_at_once(cohort.conditions, body, until_)) {
      end_at_once(i, body, *outcome);
      if (!turns(granted)) return;
      const Rotor<double>& rotor = kind.rotor;
      return put_attitude(i, attitude_of(cohort.conditions, body, rotor, 0, body.launch, rotor.launch));
    }
    const bool by_frames = steps_by_frames(granted) && !step_given(granted, tolerance_);
    if (by_frames && frame_step(cohort, body, kind.rotor, until_) < kFrame) return fly_alone(i);
    group->add(i, body);
    if (turns(granted)) group->rotors.push_back(kind.rotor);
    if (drifts(granted))
      group->drifts.emplace_back(prepare_spin_drift(projectile, length(body.launch.v), environment_, granted),
                                 body.plane);
    if (group->shots.size() == kChunk) fly(*group);
  }

  /// Fitting a spline costs more than a flight, so each custom curve is judged once.
  bool overshoots(const DragDef& drag) {
    if (drag.table != DragTable::custom) return false;
    for (const auto& [curve, verdict] : judged_curves_)
      if (curve == drag.curve) return verdict;
    if (judged_curves_.size() == kMostJudgedCurves) judged_curves_.clear();
    return judged_curves_.emplace_back(drag.curve, spline_overshoots(drag)).second;
  }

  /// grant() looks at these of a projectile, so shots that agree in them are granted the same.
  [[nodiscard]] unsigned grant_key(const ProjectileDef& p) {
    const DragDef& d = p.drag;
    return (p.twist == 0 ? 1u : 0) | (p.length <= 0 ? 2u : 0) | (d.k1 == 0 ? 4u : 0) | (d.k2 == 0 ? 8u : 0) |
           (d.damping < 1 ? 16u : 0) | (p.force != Vec3d{} ? 32u : 0) |
           (fidelity_.interpolation == Interpolation::cubic && overshoots(d) ? 64u : 0) |
           (turns(fidelity_) ? rotation_key(p) : 0) | (has_motor(p) ? 512u : 0) | (has_magnus(p) ? 1024u : 0);
  }

  static unsigned rotation_key(const ProjectileDef& p) {
    return (has_inertia(p) ? 128u : 0) | (is_axisymmetric(p) ? 256u : 0) | (p.aero.pitching.empty() ? 0 : 2048u);
  }

  ShotGroup* group_of(const ProjectileDef& projectile) {
    const unsigned key = grant_key(projectile);
    PHYSIM_ASSERT(key < group_by_key_.size());
    ShotGroup*& known = group_by_key_[key];
    if (known) return known;
    const FidelityInUse in_use = grant(fidelity_, projectile, environment_);
    for (ShotGroup& group : groups_)
      if (group.cohort.in_use.fidelity == in_use.fidelity) return known = &group;
    known = &groups_.emplace_back();
    known->cohort.in_use = in_use;
    known->cohort.conditions = prepare_conditions(environment_, in_use.fidelity);
    return known;
  }

  void put_attitude(std::uint32_t i, const Attitude& attitude) {
    result_.attitudes.resize(shots_.size());
    result_.attitudes[i] = {attitude.q_WB, attitude.omega};
  }

  void end_at_once(std::uint32_t i, const Body<double>& body, Outcome outcome) {
    result_.shots[i] = {outcome, 0, body.launch.x, body.launch.v, {}};
    if (outcome != Outcome::landed) return;
    result_.events.push_back(
        {i,
         {.kind = EventKind::ground, .value = *until_.ground, .position = body.launch.x, .velocity = body.launch.v}});
  }

  /// What drag slows so fast that a frame is too long for it has a step of its own, and no place in a pack.
  void fly_alone(std::uint32_t i) {
    const Flight flight =
        physim::fly(shots_.projectile(i), shots_.launch(i), environment_, fidelity_, tolerance_, until_);
    if (flight.error()) return refuse(i, *flight.error());
    const Sample end = flight.end();
    result_.shots[i] = {flight.outcome(), flight.duration(), end.position, end.velocity, flight.cost()};
    for (const Event& event : flight.events())
      if (!row_of(event.kind).in_flights || asks_for(event.kind)) result_.events.push_back({i, event});
    if (turns(flight.fidelity_in_use().fidelity)) put_attitude(i, {end.orientation, end.angular_velocity});
  }
  [[nodiscard]] bool asks_for(EventKind kind) const {
    return std::ranges::any_of(until_.events, [kind](const EventSpec& spec) { return spec.kind == kind; });
  }

  /// The fixed step of a group: what its first shot and the batch's middle, last, slowest and fastest shots ask for,
  /// where these belong to the group too. Pilot flights aim for less than half of the error allowed, since some shot of
  /// the batch will be worse than they are.
  Status choose_step(ShotGroup& group) {
    const Fidelity& granted = group.cohort.in_use.fidelity;
    group.step = step_given(granted, tolerance_);
    if (!group.step && steps_by_frames(granted)) group.step = kFrame;  // shots that need a shorter one fly alone
    if (group.step) return {};
    double step = std::numeric_limits<double>::infinity();
    PilotStep worst{0, tolerance_.position_error};
    for (const std::size_t i : pilots(group)) {
      const auto found = step_within(shots_.projectile(i), shots_.launch(i), environment_, granted, tolerance_, until_,
                                     0.4 * tolerance_.position_error, step);
      if (!found) return found.error();
      step = std::min(step, found->step);
      if (found->reached > worst.reached) worst = *found;
    }
    PHYSIM_ASSERT(step > 0 && step < std::numeric_limits<double>::infinity());
    group.step = step;
    if (worst.step > 0) result_.fidelity_in_use.notes.push_back(note_of_step(worst, tolerance_.position_error));
    return {};
  }

  std::vector<std::size_t> pilots(const ShotGroup& group) {
    PHYSIM_ASSERT(!group.shots.empty());
    std::size_t slowest = group.shots.front(), fastest = slowest;
    const auto speed = [this](std::size_t i) { return launch_speed(shots_.launch(i)); };
    for (std::size_t i = 0; i < shots_.size(); ++i) {
      if (speed(i) < speed(slowest)) slowest = i;
      if (speed(i) > speed(fastest)) fastest = i;
    }
    std::vector<std::size_t> list{group.shots.front()};
    for (const std::size_t i : {shots_.size() / 2, shots_.size() - 1, slowest, fastest}) {
      const ProjectileDef& projectile = shots_.projectile(i);
      const Launch& launch = shots_.launch(i);
      const bool known = std::find(list.begin(), list.end(), i) != list.end();
      if (!known && check(projectile) && check(launch) && check(projectile, launch) && group_of(projectile) == &group)
        list.push_back(i);
    }
    return list;
  }

  void fly(ShotGroup& group) {
    if (group.shots.empty()) return;
    if (!group.step) {
      if (const auto status = choose_step(group); !status) {
        for (const std::uint32_t i : group.shots) refuse(i, status.error());
        return group.clear();
      }
    }
    group.cohort.finish();
    if (group.cohort.in_use.fidelity.precision == Precision::float32)
      fly_bodies<float>(group, batch_kernel().fly_float);
    else
      fly_bodies<double>(group, batch_kernel().fly_double);
    group.clear();
  }

  template <class S>
  void fly_bodies(ShotGroup& group, void (*kernel)(const BatchJob<S>&)) {
    const std::size_t count = group.shots.size();
    PHYSIM_ASSERT(count <= kChunk && group.own_numbers.size() == count * group.own_stride());
    PHYSIM_ASSERT(group.rotors.size() == (turns(group.cohort.in_use.fidelity) ? count : 0));
    PHYSIM_ASSERT(group.drifts.size() == (drifts(group.cohort.in_use.fidelity) ? count : 0));
    watch_ = prepare_watch(until_, group.cohort.conditions, Watcher::batch);
    const Course<S> course = group.cohort.course<S>(tolerance_, *group.step, watch_);
    group.turned.resize(group.rotors.size());
    const auto emit = [](void* to, const RawEvent& event) { static_cast<ShotGroup*>(to)->events.push_back(event); };
    const NumberRuns own = (group.own & parts_flown(group.cohort.in_use.fidelity, group.cohort.conditions)).runs();
    kernel({&course, group.own_numbers.data(), group.own_stride(), own, &group.common, group.rotors.data(),
            group.shots.data(), count, result_.shots.data(), group.turned.empty() ? nullptr : group.turned.data(), emit,
            &group});
    for (const std::uint32_t i : by_shot_.order(group.events, count)) keep(group, group.events[i]);
    if (drifts(group.cohort.in_use.fidelity)) add_drift(group);
    if (!group.turned.empty()) keep_attitudes(group);
  }

  static bool drifts(const Fidelity& granted) { return granted.rotation == RotationModel::spin_drift; }

  static State<double> shown(const ShotGroup& group, std::size_t i, const State<double>& flown, double time) {
    if (!drifts(group.cohort.in_use.fidelity)) return flown;
    PHYSIM_ASSERT(i < group.drifts.size());
    return with_drift(flown, group.drifts[i].first, group.drifts[i].second, time);
  }

  void keep(const ShotGroup& group, const RawEvent& e) {
    const State<double> s = shown(group, e.shot, e.state, e.time);
    PHYSIM_ASSERT(e.index >= 0 && e.index < watch_.count);
    const EventSpec& spec = watch_.item[e.index].spec;
    const Crossing direction = e.rising ? Crossing::rising : Crossing::falling;
    result_.events.push_back({group.shots[e.shot],
                              {.kind = spec.kind,
                               .direction = direction,
                               .value = spec.value,
                               .time = e.time,
                               .position = s.x,
                               .velocity = s.v}});
  }

  void add_drift(const ShotGroup& group) {
    for (std::size_t i = 0; i < group.shots.size(); ++i) {
      ShotResult& result = result_.shots[group.shots[i]];
      const State<double> s = shown(group, i, {result.position, result.velocity}, result.time);
      result.position = s.x;
      result.velocity = s.v;
    }
  }

  void keep_attitudes(const ShotGroup& group) {
    PHYSIM_ASSERT(group.turned.size() == group.shots.size());
    const Conditions<double>& c = group.cohort.conditions;
    for (std::size_t i = 0; i < group.shots.size(); ++i) {
      const ShotResult& result = result_.shots[group.shots[i]];
      const State<double> end{result.position, result.velocity};
      Body<double> body = group.body(i);
      State<double> start = end;
      if (has_stops(c)) pass_stops(c, result.time, true, start, body);
      put_attitude(group.shots[i], attitude_of(c, body, group.rotors[i], result.time, end, group.turned[i]));
    }
  }

  const ShotList& shots_;
  const Environment& environment_;
  const Fidelity fidelity_;  // a copy: it may lie in the result
  const Tolerance& tolerance_;
  const Until& until_;
  WatchList watch_{};
  std::deque<ShotGroup> groups_;
  static constexpr std::size_t kMostJudgedCurves = 64;
  std::vector<std::pair<std::vector<DragPoint>, bool>> judged_curves_;
  std::array<ShotGroup*, 4096> group_by_key_{};
  ShotKind kind_;
  bool some_accepted_ = false;
  ByShot by_shot_;
  BatchResult& result_;
};

}  // namespace

void fly_batch(std::span<const Shot> shots, const Environment& environment, const Fidelity& fidelity,
               const Tolerance& tolerance, const Until& until, BatchResult& result) {
  const IeeeMode mode;
  const ShotList list{.shots = shots, .one_projectile = nullptr, .launches = {}};
  Batch(list, environment, fidelity, tolerance, until, result).run();
}

void fly_batch(const ProjectileDef& projectile, std::span<const Launch> launches, const Environment& environment,
               const Fidelity& fidelity, const Tolerance& tolerance, const Until& until, BatchResult& result) {
  const IeeeMode mode;
  const ShotList list{.shots = {}, .one_projectile = &projectile, .launches = launches};
  Batch(list, environment, fidelity, tolerance, until, result).run();
}

BatchResult fly_batch(std::span<const Shot> shots, const Environment& environment, const Fidelity& fidelity,
                      const Tolerance& tolerance, const Until& until) {
  BatchResult result;
  fly_batch(shots, environment, fidelity, tolerance, until, result);
  return result;
}

BatchResult fly_batch(const ProjectileDef& projectile, std::span<const Launch> launches, const Environment& environment,
                      const Fidelity& fidelity, const Tolerance& tolerance, const Until& until) {
  BatchResult result;
  fly_batch(projectile, launches, environment, fidelity, tolerance, until, result);
  return result;
}

}  // namespace physim
