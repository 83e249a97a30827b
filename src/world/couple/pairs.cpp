#include "world/couple/pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "base/assert.hpp"
#include "collide/scene_contact.hpp"
#include "model/pair_contact.hpp"
#include "world/couple/held_forces.hpp"
#include "world/couple/pair_sweep.hpp"
#include "world/couple/pair_touch.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

using collide::Knot;
using collide::Touch;

/// Meetings of one projectile in a step. One that has had more meets nothing more in the step.
constexpr int kMostMeetings = 100;
/// Part of a step within which meetings fall on one moment.
constexpr double kAtOnce = 1e-9;
/// Slower it does not move for having passed on a blow [m/s].
constexpr double kUnmoved = 1e-12;
/// Part of accelerations: less is not pressing [-].
constexpr double kUnpressed = 1e-6;
/// Part of a step: shorter legs of a path say nothing of an acceleration [-].
constexpr double kShort = 1e-3;

class PairStep {
 public:
  PairStep(WorldImpl& world, const SettleContext& context)
      : w_(world), context_(context), s_(world.pairs), all_(world.pairs.colliders) {}

  void run() {
    find_paths();
    sweep_.emplace(all_);
    if (straighten_those_that_lie()) sweep_.emplace(all_);
    sweep_->each([this](std::uint32_t i, std::uint32_t j) { look(i, j, 0); });
    if (queue_.empty()) return;
    swap_rows();
    while (!queue_.empty()) {
      for (const std::vector<Meeting>& group : next_groups())
        if (!is_of_now(group.front()))
          continue;
        else if (group.front().kind == EventKind::hit)
          touch(group);
        else
          pass(group.front());
    }
    take_apart();
    swap_rows();
    forget_what_did_not_happen();
    list_piles();
  }

 private:
  // ------------------------------------------------------------------------------------------- paths
  void find_paths() {
    gather_traces(w_.forced_scratch.chunk);
    for (std::size_t i = 0; i < w_.scratch.chunk_count; ++i) gather_traces(w_.scratch.chunks[i]);
    std::stable_sort(traces_.begin(), traces_.end(), [](const Trace& a, const Trace& b) { return a.slot < b.slot; });
    std::sort(leaving_.begin(), leaving_.end());
    auto next = traces_.begin();
    for (Collider& c : all_) {
      while (next != traces_.end() && next->slot < c.slot) ++next;
      for (; next != traces_.end() && next->slot == c.slot; ++next) c.traces.push_back(*next);
      find_path(c);
    }
  }
  void gather_traces(Chunk& chunk) {
    traces_.insert(traces_.end(), chunk.traces.begin(), chunk.traces.end());
    for (const Change& change : chunk.changes)
      if (change.kind == Change::Kind::remove) leaving_.push_back(change.slot);
  }
  void find_path(Collider& c) {
    const Rows& rows = context_.state->rows[c.cohort];
    const double dt = context_.dt;
    PHYSIM_ASSERT(!c.flies || s_.before[c.cohort].has_value());
    if (!c.flies) {
      c.path = {{0, rows.position(c.row), {}}, {dt, rows.position(c.row), {}}};
    } else if (c.traces.empty()) {
      const Rows& before = *s_.before[c.cohort];
      c.path = {{0, before.position(c.row), before.velocity(c.row)}, {dt, rows.position(c.row), rows.velocity(c.row)}};
      c.ahead = (c.path[1].v - c.path[0].v) * stagger(w_.registry.cohort(c.cohort).key.fidelity);
      for (Knot& k : c.path) k.v += c.ahead;
    } else {
      follow_traces(c, std::binary_search(leaving_.begin(), leaving_.end(), c.slot));
    }
    look_how_far(c);
  }
  void follow_traces(Collider& c, bool leaves) {
    c.path.clear();
    for (const Trace& t : c.traces) c.path.push_back({t.passed, t.state.x, t.state.v});
    c.ahead = c.traces.back().ahead;
    c.is_gone = leaves && c.path.back().time < context_.dt;
    if (c.is_gone || c.path.back().time >= context_.dt) return;
    const Vec3d rests = c.path.back().x;
    c.path.push_back({c.path.back().time, rests, {}});
    c.path.push_back({context_.dt, rests, {}});
  }
  void look_how_far(Collider& c) {
    c.box = {};
    for (std::size_t i = 0; i < c.path.size(); ++i) {
      const Knot& k = c.path[i];
      c.box.take(k.x);
      if (i + 1 < c.path.size()) c.box.take(k.x + k.v * ((c.path[i + 1].time - k.time) / 3));
      if (i > 0) c.box.take(k.x - k.v * ((k.time - c.path[i - 1].time) / 3));
    }
    const double largest = c.box.extent();
    c.spacing = largest * epsilon_of(c);
    c.box.widen(reach(c) * (1 + 1e-9) + 4 * c.spacing);
    const bool is_sound = std::ranges::all_of(c.path, [](const Knot& k) { return std::isfinite(length_squared(k.v)); });
    if (!std::isfinite(largest) || !is_sound || c.path.size() < 2) c.is_gone = true, c.box = {};
  }

  /// Steps that move with the velocity at their start leave a projectile where it is as it begins to fall, so that what
  /// lies on another one would leave it for a step. What lies in a pile has the velocity of its row: so it falls from
  /// there. In a pile that nothing holds, steps that move with the velocity at their end are off by as much.
  bool straighten_those_that_lie() {
    const auto is_straight = [this](const Collider& c) {
      if (!c.flies || !c.traces.empty() || c.is_gone) return true;
      const Fidelity& f = w_.registry.cohort(c.cohort).key.fidelity;
      return stagger(f) == 0 && !is_classic(f);
    };
    if (std::ranges::all_of(all_, is_straight)) return false;
    std::set<std::pair<std::uint32_t, std::uint32_t>> touching;
    sweep_->each([&](std::uint32_t i, std::uint32_t j) {
      if (stay_together(all_[i], all_[j])) touching.insert({i, j});
    });
    const std::map<std::uint32_t, std::uint32_t> groups = groups_of(touching);
    std::set<std::uint32_t> held, pressed;  // groups of which one stands or touched something else; that press together
    for (const auto& [i, group] : groups)
      if (!all_[i].flies || !all_[i].traces.empty()) held.insert(group);
    for (const auto& [i, j] : touching)
      if (press(all_[i], all_[j])) pressed.insert(groups.at(i));
    bool any = false;
    for (const auto& [i, group] : groups) {
      Collider& c = all_[i];
      if (is_straight(c)) continue;
      const bool ends_late = stagger(w_.registry.cohort(c.cohort).key.fidelity) > 0;
      if (held.contains(group) ? ends_late : !pressed.contains(group)) continue;
      for (Knot& k : c.path) k.v -= c.ahead;
      c.ahead = {};
      c.path.back().x = c.path.front().x + (c.path.front().v + c.path.back().v) * (0.5 * context_.dt);
      look_how_far(c);
      any = true;
    }
    return any;
  }
  /// Whether two that touch come nearer by what each feels alone.
  [[nodiscard]] bool press(const Collider& a, const Collider& b) const {
    const Knot &on_a = a.path.front(), &on_b = b.path.front();
    const double pull = dot(acceleration(a, 0) - acceleration(b, 0), normal_between(on_a, on_b));
    return pull < -rounding_of_speed(a, b, on_a, on_b) / context_.dt;
  }
  /// Whether two touch when the step begins, and neither part nor approach by the velocities of their rows.
  [[nodiscard]] bool stay_together(const Collider& a, const Collider& b) const {
    if (a.path.size() < 2 || b.path.size() < 2 || !want_each_other(a, b) || passes(a) || passes(b)) return false;
    Knot on_a = a.path.front(), on_b = b.path.front();
    if (a.traces.empty()) on_a.v -= a.ahead;
    if (b.traces.empty()) on_b.v -= b.ahead;
    const double gap = length(on_a.x - on_b.x) - (reach(a) + reach(b)), near = 4 * slack_between(a, b);
    if (gap > near || is_deep(a, b, on_a, on_b)) return false;
    const double speed = dot(on_a.v - on_b.v, normal_between(on_a, on_b));
    return std::abs(speed) <= near / context_.dt + rounding_of_speed(a, b, on_a, on_b);
  }

  /// What the numbers of its row are rounded by [-].
  [[nodiscard]] double epsilon_of(const Collider& c) const { return context_.state->rows[c.cohort].layout().epsilon(); }
  [[nodiscard]] static Knot at(const Collider& c, double time) {
    collide::Leg leg = collide::leg_of(c.path, collide::leg_at(c.path, time));
    leg.placed += 8 * c.spacing;
    return leg.at(time);
  }
  /// Without others that it lies on.
  [[nodiscard]] Vec3d free_acceleration(const Collider& c, double time) const {
    return c.free ? *c.free : acceleration(c, time);
  }
  /// Over the leg of its path: within one, steps of low order may bend to and fro. Of a leg so short that rounding of
  /// its velocities counts, the next one's.
  [[nodiscard]] Vec3d acceleration(const Collider& c, double time) const {
    for (std::size_t i = collide::leg_at(c.path, time); i + 1 < c.path.size(); ++i) {
      const collide::Leg leg = collide::leg_of(c.path, i);
      if (leg.span() > kShort * context_.dt) return (leg.end.v - leg.begin.v) * (1 / leg.span());
    }
    return {};
  }

  // ------------------------------------------------------------------------------------------- who meets whom
  /// Notes the next meeting of two after a moment.
  void look(std::uint32_t i, std::uint32_t j, double from) {
    const Collider &a = all_[i], &b = all_[j];
    if ((!may_move(a) && !may_move(b)) || !want_each_other(a, b)) return;
    if (std::max(a.hits, b.hits) > kMostMeetings) return;
    const double radius = reach(a) + reach(b);
    from = std::max({from, a.since, b.since});
    const double to = std::min(a.path.empty() ? -1 : a.path.back().time, b.path.empty() ? -1 : b.path.back().time);
    if (!(radius > 0) || from > to || a.path.size() < 2 || b.path.size() < 2) return;
    const Knot on_a = at(a, from), on_b = at(b, from);
    const double apart = length(on_a.x - on_b.x);
    const auto note = [&](std::optional<double> time, EventKind kind) {
      if (time) queue_.push({*time, i, j, a.version, b.version, kind});
    };
    if (passes(a) || passes(b)) {
      // Once told, the next meeting is one that rounding does not make of the last one.
      const auto told = inside_.find({i, j});
      const bool is_told = told != inside_.end(), inside = is_told ? told->second : apart < radius;
      const double beyond = is_told ? 1e-12 * radius + 4 * std::max(a.spacing, b.spacing) : 0;
      return inside ? note(first(a, b, radius + beyond, Touch::goes_away, from), EventKind::left)
                    : note(first(a, b, radius - beyond, Touch::comes_near, from), EventKind::entered);
    }
    if (lies_on_.contains({i, j})) return;
    const double slack = slack_between(a, b);
    if (apart > radius + slack) return note(first(a, b, radius, Touch::comes_near, from), EventKind::hit);
    if (apart < radius - slack && met_inside_.contains({i, j})) {
      const auto left = first(a, b, radius + slack, Touch::goes_away, from);
      if (left) note(first(a, b, radius, Touch::comes_near, *left), EventKind::hit);
      return;
    }
    const double speed = dot(on_a.v - on_b.v, on_a.x - on_b.x);
    const double put = 4 * slack / context_.dt;  // so fast it may look that was put beside another one
    if (speed < -(put + rounding_of_speed(a, b, on_a, on_b)) * apart) return note(from, EventKind::hit);
    // They touch, and part or stay: what counts is where they come nearer than that.
    note(first(a, b, std::min(radius, apart) - slack, Touch::comes_near, from), EventKind::hit);
  }
  [[nodiscard]] static std::optional<double> first(const Collider& a, const Collider& b, double distance, Touch touch,
                                                   double from) {
    return collide::first_touch(a.path, b.path, distance, touch, from);
  }
  [[nodiscard]] double rounding_of_speed(const Collider& a, const Collider& b, const Knot& on_a,
                                         const Knot& on_b) const {
    return 8 * std::max(epsilon_of(a), epsilon_of(b)) * (length(on_a.v) + length(on_b.v));
  }

  void look_around(std::uint32_t i, double from) {
    sweep_->each_beside(i, [&](std::uint32_t j) { look(std::min(i, j), std::max(i, j), from); });
  }

  // ------------------------------------------------------------------------------------------- meeting
  void tell(EventKind kind, const Collider& c, const Collider& other, const Knot& now, const Vec3d& normal,
            Reason reason = Reason::none) {
    s_.chunk.events.push_back({.kind = kind,
                               .reason = reason,
                               .id = context_.state->slots.id_of(c.slot),
                               .time = context_.time + now.time,
                               .position = now.x,
                               .velocity = now.v,
                               .normal = normal,
                               .other = context_.state->slots.id_of(other.slot)});
  }
  void pass(const Meeting& m) {
    const Collider &a = all_[m.a], &b = all_[m.b];
    const Knot on_a = at(a, m.time), on_b = at(b, m.time);
    const Vec3d n = normal_between(on_a, on_b);
    tell(m.kind, a, b, on_a, n);
    tell(m.kind, b, a, on_b, -n);
    inside_[{m.a, m.b}] = m.kind == EventKind::entered;
    look(m.a, m.b, m.time);
  }

  /// True if two projectiles still fly the paths on which their meeting was found.
  [[nodiscard]] bool is_of_now(const Meeting& m) const {
    return m.version_a == all_[m.a].version && m.version_b == all_[m.b].version;
  }
  /// Meetings of the next moment. Hits that share a body, or are joined by others that do, are one group.
  [[nodiscard]] std::vector<std::vector<Meeting>> next_groups() {
    PHYSIM_ASSERT(!queue_.empty());
    std::vector<std::vector<Meeting>> groups;
    std::map<std::uint32_t, std::size_t> group_of;  // of a body
    const double at_once = queue_.top().time + kAtOnce * context_.dt;
    for (; !queue_.empty() && queue_.top().time <= at_once; queue_.pop()) {
      const Meeting m = queue_.top();
      if (!is_of_now(m)) continue;
      groups.push_back({m});
      if (m.kind != EventKind::hit) continue;
      const std::size_t last = groups.size() - 1;
      for (const std::uint32_t body : {m.a, m.b}) {
        const std::size_t known = group_of.try_emplace(body, last).first->second;
        if (known == last) continue;
        for (const Meeting& other : std::exchange(groups[known], {})) {
          groups[last].push_back(other);
          group_of[other.a] = group_of[other.b] = last;
        }
      }
    }
    std::erase_if(groups, [](const std::vector<Meeting>& group) { return group.empty(); });
    for (auto& group : groups) std::sort(group.rbegin(), group.rend());  // the first in front
    return groups;
  }

  /// Hits at one moment: their impulses are found together, so that their order changes nothing.
  void touch(const std::vector<Meeting>& meetings) {
    PHYSIM_ASSERT(!meetings.empty());
    const double time = meetings.front().time;
    PHYSIM_ASSERT(time >= 0 && time <= context_.dt);
    now_.clear(), touches_.clear();
    for (const Meeting& m : meetings)
      for (const std::uint32_t i : {m.a, m.b}) now_[i] = {at(all_[i], time)};
    for (const Meeting& m : meetings) touches_.push_back(touch_of(m, time));
    find_who_lies_on_those(time);
    if (find_what_passes_on(time)) find_who_lies_on_those(time);
    for (const TouchNow& t : touches_) {
      if (!t.strikes) continue;
      const Reason reason = t.inside ? Reason::inside : Reason::none;
      tell(EventKind::hit, all_[t.a], all_[t.b], now_[t.a].knot, t.n, reason);
      tell(EventKind::hit, all_[t.b], all_[t.a], now_[t.b].knot, -t.n, reason);
    }
    part();
    find_pulls(time);
    for (const TouchNow& t : touches_)
      if (t.lies && dot(moved(t.a) - moved(t.b), t.n) > kUnmoved && !is_held(t)) lies_on_.erase({t.a, t.b});
    std::erase_if(now_, [](const auto& each) { return each.second.is_still(); });
    for (const auto& [i, body] : now_) forget_after(all_[i], time);
    for (const auto& [i, body] : now_) go_on(i, body);
    for (const auto& [i, body] : now_) look_around(i, time);
  }
  /// The motion of a projectile at the moment at hand.
  struct BodyNow {
    Knot knot;
    PairBody moves{};
    Vec3d came{};                 // its spin before
    std::optional<Vec3d> spin{};  // afterwards, if it is another one
    std::optional<Vec3d> pull{};  // of one that lies on others: what is left of its acceleration [m/s^2]
    bool meets = true;            // false: it only lies at those that meet

    /// It passed on what it was given, and nothing of it changed.
    [[nodiscard]] bool is_still() const { return !meets && !spin && length(moves.velocity - knot.v) <= kUnmoved; }
  };
  struct TouchNow {
    std::uint32_t a, b;  // a < b
    Vec3d n;             // from b to a
    PairSurface surface;
    bool nears = true, strikes = false, inside = false, lies = false, deep = false;
  };
  /// A surface that one of those that meet lies at.
  struct WallNow {
    std::uint32_t body;
    PairBody wall;
    Vec3d n;  // towards the body
    PairSurface surface;
  };
  [[nodiscard]] TouchNow touch_of(const Meeting& m, double time) {
    PHYSIM_ASSERT(m.a < m.b && m.b < all_.size());
    Collider &a = all_[m.a], &b = all_[m.b];
    const Knot &on_a = now_[m.a].knot, &on_b = now_[m.b].knot;
    const Vec3d n = normal_between(on_a, on_b);
    const double before = dot(on_a.v - on_b.v, n);
    const double pull = dot(acceleration(a, time) - acceleration(b, time), n);
    const double frame = frame_of_contact(context_.dt);
    PairSurface surface = pair_surface(a.kind->body, b.kind->body);
    ++a.hits, ++b.hits;
    const double rounding = rounding_of_speed(a, b, on_a, on_b) / context_.dt;
    const bool low = pull < -rounding && is_low(surface, before, pull, frame);
    const bool lies = low || std::max(a.hits, b.hits) > kMostMeetings;
    const bool strikes = !lies || is_strike(before, pull, frame);
    if (lies) surface.restitution = 0, lies_on_.insert({m.a, m.b});
    const bool inside = time == 0 && length(on_a.x - on_b.x) < reach(a) + reach(b) - slack_between(a, b);
    const bool deep = is_deep(a, b, on_a, on_b);
    if (deep) met_inside_.insert({m.a, m.b});
    return {.a = m.a,
            .b = m.b,
            .n = n,
            .surface = surface,
            .nears = before < 0,
            .strikes = strikes,
            .inside = inside,
            .lies = lies,
            .deep = deep};
  }

  /// As on the ground: a bounce that would be over within this step does not lift it any more.
  [[nodiscard]] static bool is_low(const PairSurface& surface, double before, double pull, double frame) {
    return pull < 0 && -surface.restitution * before <= -pull * (0.5 * frame);
  }
  /// One that lies does not fall with those that lie on it, if they meet at the same moment.
  void find_who_lies_on_those(double time) {
    const double frame = frame_of_contact(context_.dt);
    const auto pulled = [&](std::uint32_t i) {
      Vec3d pull = acceleration(all_[i], time);
      for (const TouchNow& t : touches_) {
        if (!t.lies || (t.a != i && t.b != i)) continue;
        const Vec3d n = t.a == i ? t.n : -t.n;
        pull -= n * min(dot(pull, n), 0.0);
      }
      return pull;
    };
    for (bool again = true; std::exchange(again, false);)
      for (TouchNow& t : touches_) {
        const double before = dot(now_[t.a].knot.v - now_[t.b].knot.v, t.n);
        if (t.lies || !t.nears) continue;
        const double pull = dot(pulled(t.a) - pulled(t.b), t.n);
        if (!is_low(t.surface, before, pull, frame)) continue;
        t.lies = again = true;
        t.strikes = is_strike(before, pull, frame);
        t.surface.restitution = 0;
        lies_on_.insert({t.a, t.b});
      }
  }

  /// What lies at those that lie feels the same moment: the weight of a pile goes through to the floor. A blow goes
  /// from one to the next, as in a row of hard balls a little apart; what lay at one that is struck may meet it anew.
  /// True if others take part.
  bool find_what_passes_on(double time) {
    walls_.clear();
    PHYSIM_ASSERT(!touches_.empty() && !now_.empty());
    if (std::ranges::any_of(touches_, [](const TouchNow& t) { return t.strikes; })) {
      std::erase_if(lies_on_, [this](const auto& pair) {
        const auto meets_now = [&](const TouchNow& t) { return std::pair{t.a, t.b} == pair; };
        return (now_.contains(pair.first) || now_.contains(pair.second)) && std::ranges::none_of(touches_, meets_now);
      });
      return false;
    }
    const std::size_t met = touches_.size();
    std::vector<std::uint32_t> asked;
    for (const auto& [i, body] : now_) asked.push_back(i);
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const std::uint32_t i = asked[k];
      if (!may_move(all_[i])) continue;
      find_walls(i);
      sweep_->each_beside(i, [&](std::uint32_t j) {
        const auto is_known = [&](const TouchNow& t) { return (t.a == i && t.b == j) || (t.a == j && t.b == i); };
        if (std::ranges::any_of(touches_, is_known)) return;
        const auto touch = touch_at_rest(std::min(i, j), std::max(i, j), time);
        if (!touch) return;
        touches_.push_back(*touch);
        if (now_.contains(j)) return;
        now_[j] = {.knot = at(all_[j], time), .meets = false};
        asked.push_back(j);
      });
    }
    return touches_.size() > met;
  }
  /// Two that touch and do not part.
  [[nodiscard]] std::optional<TouchNow> touch_at_rest(std::uint32_t i, std::uint32_t j, double time) const {
    const Collider &a = all_[i], &b = all_[j];
    if ((!may_move(a) && !may_move(b)) || !want_each_other(a, b) || passes(a) || passes(b)) return std::nullopt;
    for (const Collider* c : {&a, &b})
      if (c->path.size() < 2 || time < c->since || time > c->path.back().time) return std::nullopt;
    const Knot on_a = at(a, time), on_b = at(b, time);
    const bool lies = lies_on_.contains({i, j});
    const double gap = length(on_a.x - on_b.x) - (reach(a) + reach(b));
    if (gap > 4 * slack_between(a, b) || is_deep(a, b, on_a, on_b)) return std::nullopt;
    const Vec3d n = normal_between(on_a, on_b);
    const double put = 4 * slack_between(a, b) / context_.dt;
    if (dot(on_a.v - on_b.v, n) > put + rounding_of_speed(a, b, on_a, on_b)) return std::nullopt;
    PairSurface surface = pair_surface(a.kind->body, b.kind->body);
    if (lies) surface.restitution = 0;
    return TouchNow{.a = i, .b = j, .n = n, .surface = surface, .lies = lies};
  }
  /// Whether a ball is on its way through a one-way thing.
  [[nodiscard]] bool is_passing(const SceneNearest& near, const CollisionDef& of) const {
    return near.distance < of.radius * (1 - kDeep) && context_.scene->is_one_way(near.instance);
  }
  /// The surfaces that it touches and does not part from.
  void find_walls(std::uint32_t i) {
    PHYSIM_ASSERT(now_.contains(i));
    const Collider& c = all_[i];
    const Knot& now = now_[i].knot;
    const double radius = reach(c), within = radius + 4e-10 + 16 * c.spacing;
    each_surface(i, within, [&](const SceneNearest& near, const Vec3d& u) {
      const double put = (within - radius) / context_.dt;  // so fast it may look that was put beside the surface
      if (dot(now.v - u, near.away) > put + 8 * epsilon_of(c) * (length(now.v) + length(u))) return;
      const PairSurface surface = pair_surface(context_.scene->material(near.material), c.kind->body);
      const Vec3d runs = context_.scene->conveyor_velocity(near.instance, near.away, context_.time + now.time);
      walls_.push_back({i, {.velocity = runs == Vec3d{} ? u : u + runs}, near.away, surface});
    });
  }
  /// Calls f with each surface that one is beside at the moment at hand, and how that moves [m/s].
  template <class F>
  void each_surface(std::uint32_t i, double within, const F& f) const {
    const Knot& now = now_.at(i).knot;
    const CollisionDef& of = all_[i].kind->body.collision;
    if (!context_.scene || of.layers == 0 || !(of.radius > 0)) return;
    const double time = context_.time + now.time;
    const auto add = [&](const SceneNearest& near) {
      if (near.away == Vec3d{} || is_passing(near, of)) return;
      f(near, velocity_at(*context_.scene->state(near.instance, time), near.position));
    };
    SceneByMotion(*context_.scene)
        .each_beside(now.x, within, {.layers = of.layers, .sensors = false, .from_front = true}, time, add);
  }

  /// The impulses that they give each other.
  void part() {
    for (auto& [i, body] : now_) {
      const auto rubs = [i = i](const TouchNow& t) { return (t.a == i || t.b == i) && t.surface.friction > 0; };
      const auto wall_rubs = [i = i](const WallNow& w) { return w.body == i && w.surface.friction > 0; };
      const bool any = std::ranges::any_of(touches_, rubs) || std::ranges::any_of(walls_, wall_rubs);
      body.moves = body_of(all_[i], body.knot, any);
      body.came = body.moves.spin;
    }
    std::vector<PairTouch> touches;
    for (const TouchNow& t : touches_) {
      PHYSIM_ASSERT(may_move(all_[t.a]) || may_move(all_[t.b]));
      if (t.nears && !t.deep) touches.push_back({now_[t.a].moves, now_[t.b].moves, t.n, t.surface});
    }
    for (WallNow& w : walls_) touches.push_back({now_[w.body].moves, w.wall, w.n, w.surface});
    meet(touches);
    // Impulses of balls inside of each other have no common solution: each pair is solved by itself, once.
    for (const TouchNow& t : touches_)
      if (t.nears && t.deep) meet(std::array{PairTouch{now_[t.a].moves, now_[t.b].moves, t.n, t.surface}});
    for (auto& [i, body] : now_)
      if (body.moves.spin != body.came) body.spin = body.moves.spin;
  }
  [[nodiscard]] PairBody body_of(const Collider& c, const Knot& now, bool rubs) {
    const CollisionDef& ball = c.kind->body.collision;
    PairBody body{now.v, {}, c.mobility, ball.radius, 0};
    if (!rubs || !(ball.radius > 0)) return body;
    body.turns = context_.state->extras.turns(c.slot, c.kind->body.frozen_rotation);
    body.spin = component_product(body.turns, spin_of(c, now.time));
    if (may_move(c)) body.turnability = 1 / (ball.inertia * c.kind->flown.mass * ball.radius * ball.radius);
    return body;
  }
  [[nodiscard]] Vec3d spin_of(const Collider& c, double time) {
    if (c.flies) {
      Vec3d spin;
      with_row(c, [&](const SettleContext& context) {
        spin = spin_at(context, s_.chunk, c.row, {.passed = time, .from = last_trace(c, time)});
      });
      return spin;
    }
    const Turning* turning = context_.state->extras.find_turning(c.slot);
    return turning ? turning->angular_velocity : Vec3d{};
  }
  [[nodiscard]] static const Trace* last_trace(const Collider& c, double time) {
    const Trace* last = nullptr;
    for (const Trace& t : c.traces)
      if (t.passed <= time) last = &t;
    return last;
  }
  /// Calls f for the row of one that flies, which is as it was when the step began.
  template <class F>
  void with_row(const Collider& c, const F& f) {
    PHYSIM_ASSERT(c.flies && s_.before[c.cohort].has_value());
    context_.state->rows[c.cohort].put_back(c.row, *s_.before[c.cohort]);
    s_.chunk.cohort = c.cohort;
    if (c.is_roused)
      with_held_forces(w_, context_, context_.state->slots[c.slot], f);
    else if (w_.registry.cohort(c.cohort).key.forced)
      with_taken_step(context_, w_.forced_scratch, c.cohort, c.row, f);
    else
      f(context_);
  }

  // ------------------------------------------------------------------------------------------- what follows
  /// What one told of the rest of its step did not happen.
  void forget_after(const Collider& c, double time) {
    const double end = context_.time + time;
    if (!c.is_new) {
      if (c.flies) cuts_.push_back({c.slot, end});
      return;
    }
    const ProjectileId id = context_.state->slots.id_of(c.slot);
    std::erase_if(s_.chunk.events, [&](const Event& e) { return e.id == id && e.time > end; });
    std::erase_if(s_.chunk.changes, [&](const Change& change) { return change.slot == c.slot; });
  }

  /// Continues the step of a projectile with the velocity behind a meeting.
  void go_on(std::uint32_t i, const BodyNow& body) {
    Collider& c = all_[i];
    if (!may_move(c)) return;
    Knot now = body.knot;
    now.v = body.moves.velocity;
    OnHit on_hit = OnHit::bounce;
    for (const TouchNow& t : touches_) {
      if ((t.a != i && t.b != i) || !t.strikes) continue;
      on_hit = c.kind->body.collision.on_hit;
      if (!ends_flights(on_hit)) tell(EventKind::bounced, c, all_[t.a == i ? t.b : t.a], now, t.a == i ? t.n : -t.n);
    }
    if (!std::exchange(c.is_new, true)) sweep_->note_new(i);
    ++c.version;
    PHYSIM_ASSERT(now.time >= c.since);  // meetings come in order of time
    c.since = now.time;
    if (c.sleeps) rouse(c);
    Parting parting{now.time, last_trace(c, now.time), {now.x, now.v}, body.spin, then(on_hit), {}};
    const bool lies = body.pull && parting.then == Parting::Then::flies_on;
    if (lies) parting.then = Parting::Then::lies, parting.pull = *body.pull;
    const Vec3d free = free_acceleration(c, now.time);
    fly_on(c, parting);
    c.free = lies ? std::optional(free) : std::nullopt;
    look_how_far(c);
  }
  /// Whether one of two that lie on each other goes on lying there.
  [[nodiscard]] bool is_held(const TouchNow& t) const {
    const double time = now_.at(t.a).knot.time;
    const Collider &a = all_[t.a], &b = all_[t.b];
    const double above = dot(free_acceleration(a, time) - acceleration(b, time), t.n);
    const double below = dot(acceleration(a, time) - free_acceleration(b, time), t.n);
    return !lifts_off(dot(moved(t.a) - moved(t.b), t.n), std::min(above, below), frame_of_contact(context_.dt));
  }
  /// What is left of the accelerations of those that go on lying at each other. They press on each other as far as they
  /// would come nearer: two that fall together do not.
  void find_pulls(double time) {
    PHYSIM_ASSERT(!touches_.empty());
    std::map<std::uint32_t, PairBody> bodies;
    const auto body = [&](std::uint32_t i) -> PairBody& {
      const Vec3d free = free_acceleration(all_[i], time);
      return bodies.try_emplace(i, PairBody{free, {}, all_[i].mobility}).first->second;
    };
    std::vector<PairTouch> presses;
    for (const TouchNow& t : touches_) {
      if (!t.lies) continue;
      PairBody &a = body(t.a), &b = body(t.b);
      const double of_a = dot(a.velocity, t.n), of_b = -dot(b.velocity, t.n), pull = min(min(of_a, of_b), of_a + of_b);
      if (pull < 0 && !lifts_off(dot(moved(t.a) - moved(t.b), t.n), pull, frame_of_contact(context_.dt)))
        presses.push_back({a, b, t.n, {}});
    }
    if (presses.empty()) return;
    // At a surface that stands nothing comes nearer; what is at one that moves goes along with it already.
    double most = 0;  // acceleration that presses [m/s^2]
    for (const auto& [i, pulled] : bodies) most = max(most, length(pulled.velocity));
    std::deque<PairBody> surfaces;
    for (auto& [i, pulled] : bodies)
      each_support(i, 0.5 * frame_of_contact(context_.dt) * most, [&, &pulled = pulled](const Vec3d& n, bool moves) {
        presses.push_back({pulled, surfaces.emplace_back(PairBody{moves ? pulled.velocity : Vec3d{}}), n, {}});
      });
    meet(presses);
    for (const auto& [i, pulled] : bodies) {
      const Vec3d free = free_acceleration(all_[i], time);
      if (length(pulled.velocity - free) > kUnpressed * most) now_.at(i).pull = pulled.velocity;
    }
  }
  /// Calls f with the normal of each surface that one is at and does not part from faster than `put` [m/s], the ground
  /// too, and whether it moves.
  template <class F>
  void each_support(std::uint32_t i, double put, const F& f) const {
    const Collider& c = all_[i];
    const Knot& now = now_.at(i).knot;
    const double near_to = kDeep * reach(c) + 16 * c.spacing;
    each_surface(i, reach(c) + near_to, [&](const SceneNearest& near, const Vec3d& u) {
      if (dot(moved(i) - u, near.away) <= put) f(near.away, u != Vec3d{});
    });
    const Ground& ground = context_.def->ground;
    const Conditions<double>& conditions = w_.registry.cohort(c.cohort).conditions;
    if (ground.mode != GroundMode::bounce || height(conditions, now.x) > ground.height + near_to) return;
    const Vec3d up = is_round(conditions.fidelity.earth) ? vertical_at(conditions, now.x) : Vec3d{0, 1, 0};
    if (dot(moved(i), up) <= put) f(up, false);
  }
  /// Its velocity behind the moment at hand.
  [[nodiscard]] Vec3d moved(std::uint32_t i) const {
    const auto found = now_.find(i);
    return found == now_.end() ? Vec3d{} : found->second.moves.velocity;
  }
  /// One that slept takes part from now on: its row is one of those that fly, as it was when the step began.
  void rouse(Collider& c) {
    c.rested = {};
    if (context_.state->slots[c.slot].is(kPiled))
      sweep_->each_beside(static_cast<std::uint32_t>(&c - all_.data()), [&](std::uint32_t j) {
        const double apart = length(c.path.front().x - all_[j].path.front().x) - (reach(c) + reach(all_[j]));
        const bool touches = want_each_other(c, all_[j]) && apart <= 8 * slack_between(c, all_[j]);
        if (all_[j].sleeps && touches) s_.disturbed.push_back(all_[j].slot);
      });
    w_.wake_alone(c.slot, context_.time + c.since);
    const Slot& slot = context_.state->slots[c.slot];
    PHYSIM_ASSERT(c.sleeps && !slot.is(kStill));
    c.cohort = slot.cohort, c.row = slot.row;
    c.sleeps = false, c.flies = c.is_roused = true;
    s_.before.resize(std::max(s_.before.size(), context_.state->rows.size()));
    Rows& rows = context_.state->rows[c.cohort];
    std::optional<Rows>& before = s_.before[c.cohort];
    if (before) {
      before->push_copy(rows, c.row);
    } else {
      rows.swap_positions();  // as swap_rows() did with the others
      before = rows;
    }
  }
  [[nodiscard]] static Parting::Then then(OnHit on_hit) {
    if (on_hit == OnHit::stop) return Parting::Then::stops;
    return on_hit == OnHit::stick ? Parting::Then::sticks : Parting::Then::flies_on;
  }
  void fly_on(Collider& c, const Parting& parting) {
    s_.chunk.traces.clear();
    with_row(c, [&](const SettleContext& context) { settle_after(context, s_.chunk, c.row, parting); });
    c.traces = s_.chunk.traces;
    const auto leaves = [&](const Change& change) {
      return change.slot == c.slot && change.kind == Change::Kind::remove;
    };
    follow_traces(c, std::ranges::any_of(s_.chunk.changes, leaves));
  }

  // ------------------------------------------------------------------------------------------- the end
  /// What lies on another one stays outside of it, and does not press into it.
  void take_apart() {
    std::vector<Knot> end(all_.size());
    std::vector<std::uint32_t> moved;
    for (std::uint32_t i = 0; i < all_.size(); ++i) {
      if (all_[i].is_gone || all_[i].path.empty()) continue;
      end[i] = all_[i].path.back();
    }
    const std::vector<Beside> walls = beside_those_that_lie(end);
    constexpr int kPasses = 200;  // enough for piles of ten
    bool pushes = true;
    for (int turn = 0; turn < kPasses && pushes; ++turn) {
      pushes = false;
      for (const auto& [i, j] : lies_on_) {
        const Collider &a = all_[i], &b = all_[j];
        if (a.is_gone || b.is_gone || !push_apart(a, b, end[i], end[j])) continue;
        moved.push_back(i), moved.push_back(j);
        pushes = true;
      }
      for (const Beside& w : walls) {
        const double deep = reach(all_[w.body]) - dot(end[w.body].x - w.place, w.n);
        if (!(deep > 1e-9 * reach(all_[w.body]))) continue;
        end[w.body].x += w.n * deep;
        end[w.body].v -= w.n * min(dot(end[w.body].v - w.velocity, w.n), 0.0);
      }
    }
    std::sort(moved.begin(), moved.end());
    moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
    for (const std::uint32_t i : moved)
      if (may_move(all_[i])) s_.put.push_back({all_[i].slot, {end[i].x, end[i].v - all_[i].ahead}});
  }
  /// The surfaces beside which those are that lie on others: they are not pushed into them.
  struct Beside {
    std::uint32_t body;
    Vec3d n, place, velocity;
  };
  [[nodiscard]] std::vector<Beside> beside_those_that_lie(const std::vector<Knot>& end) {
    std::vector<Beside> walls;
    if (!context_.scene) return walls;
    std::set<std::uint32_t> bodies;
    for (const auto& [i, j] : lies_on_) bodies.insert(i), bodies.insert(j);
    const double time = context_.time + context_.dt;
    for (const std::uint32_t i : bodies) {
      const Collider& c = all_[i];
      const CollisionDef& of = c.kind->body.collision;
      if (c.is_gone || !may_move(c) || of.layers == 0) continue;
      const auto add = [&](const SceneNearest& near) {
        if (near.away == Vec3d{} || is_passing(near, of)) return;
        const Vec3d u = velocity_at(*context_.scene->state(near.instance, time), near.position);
        walls.push_back({i, near.away, near.position, u});
        if (u != Vec3d{} || context_.scene->conveyor_velocity(near.instance, near.away, time) != Vec3d{})
          carried_.insert(i);
      };
      SceneByMotion(*context_.scene)
          .each_beside(end[i].x, 1.1 * of.radius, {.layers = of.layers, .sensors = false, .from_front = true}, time,
                       add);
    }
    return walls;
  }
  /// Those that lie on each other, in groups. They do not sleep by themselves.
  void list_piles() {
    std::erase_if(lies_on_, [this](const auto& pair) { return all_[pair.first].is_gone || all_[pair.second].is_gone; });
    for (const auto& [i, first] : groups_of(lies_on_))
      s_.piled.push_back({all_[i].slot, first, all_[i].rested, carried_.contains(i)});
    std::ranges::stable_sort(s_.piled, {}, &Piled::pile);
    const auto sleeps_alone = [&](const Change& change) {
      const auto is_it = [&](const Piled& one) { return one.slot == change.slot; };
      return change.kind == Change::Kind::sleep && std::ranges::any_of(s_.piled, is_it);
    };
    std::erase_if(s_.chunk.changes, sleeps_alone);
    std::erase_if(w_.forced_scratch.chunk.changes, sleeps_alone);
    for (std::size_t i = 0; i < w_.scratch.chunk_count; ++i) std::erase_if(w_.scratch.chunks[i].changes, sleeps_alone);
  }

  /// As they were while the step was flown, and back.
  void swap_rows() {
    for (std::size_t c = 0; c < s_.before.size(); ++c)
      if (s_.before[c]) context_.state->rows[c].swap_positions();
  }

  void forget_what_did_not_happen() {
    std::sort(cuts_.begin(), cuts_.end());
    const auto cut_of = [this](std::uint32_t slot) {
      const auto at = std::lower_bound(cuts_.begin(), cuts_.end(), std::pair{slot, -kInfinity});
      return at != cuts_.end() && at->first == slot ? at->second : kInfinity;
    };
    const auto clean = [&](Chunk& chunk) {
      PHYSIM_ASSERT(chunk.strikes.empty());
      std::erase_if(chunk.events, [&](const Event& e) { return e.time > cut_of(e.id.index); });
      std::erase_if(chunk.changes, [&](const Change& change) { return cut_of(change.slot) < kInfinity; });
    };
    clean(w_.forced_scratch.chunk);
    for (std::size_t i = 0; i < w_.scratch.chunk_count; ++i) clean(w_.scratch.chunks[i]);
  }

  WorldImpl& w_;
  const SettleContext& context_;
  PairScratch& s_;
  std::vector<Collider>& all_;
  std::vector<Trace> traces_;
  std::vector<std::uint32_t> leaving_;
  std::optional<PairSweep> sweep_;
  std::priority_queue<Meeting> queue_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> lies_on_;
  std::set<std::uint32_t> carried_;  // of those that lie on others: that lie on what moves, too
  std::set<std::pair<std::uint32_t, std::uint32_t>> met_inside_;    // pairs that met while one was inside of the other
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> inside_;  // of those that pass: what was told last
  std::vector<std::pair<std::uint32_t, double>> cuts_;              // slots, and until when what they told holds
  std::vector<TouchNow> touches_;                                   // of the moment at hand
  std::deque<WallNow> walls_;                                       // at which bodies lie then
  std::map<std::uint32_t, BodyNow> now_;
};

}  // namespace

void meet_pairs(WorldImpl& world, const SettleContext& context) {
  if (world.pairs.used) PairStep(world, context).run();
}

}  // namespace physim
