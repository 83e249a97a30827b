#include "world/core/joint_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "physim/math.hpp"
#include "world/core/envelope.hpp"

namespace physim {
namespace {

constexpr std::uint32_t kMostRounds = 64;  // of one search for lengths
constexpr std::uint32_t kMostSets = 100;   // of cables that pull and planes that press, beside two for each row
constexpr std::uint32_t kMostTurns = 4;    // of springs, for each round
constexpr std::uint32_t kFewRounds = 4;    // that put lengths right where no effort is left
constexpr double kLeastWork = 1000;        // of a round: that of a small net [-]
constexpr double kTaut = 1e-9;             // a cable that is shorter by less is taut, of its length [-]
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

class Net {
 public:
  Net(std::span<NetBody> bodies, std::span<NetRow> rows, const NetPart& part, const NetEffort& effort)
      : bodies_(bodies), rows_(rows), part_(part), effort_(effort), ends_(bodies.size()), found_(rows.size()) {
    PHYSIM_ASSERT(part.h > 0 && part.step >= part.h);
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      PHYSIM_ASSERT(rows[i].a != rows[i].b && std::max(rows[i].a, rows[i].b) < bodies.size());
      ends_[rows[i].a].push_back({i, 1});
      ends_[rows[i].b].push_back({i, -1});
    }
  }

  NetReport run() {
    const std::vector<NetBody> flown(bodies_.begin(), bodies_.end());
    const bool follows = !effort_.is_spent();
    hold(follows);
    if (!follows || !gains(flown)) return report_;
    std::ranges::copy(flown, bodies_.begin());
    hold(false);
    if (std::ranges::any_of(rows_, &NetRow::is_spring)) calm(flown);
    return report_;
  }
  [[nodiscard]] double work() const { return work_; }

 private:
  struct End {
    std::uint32_t row;
    double sign;
  };
  /// What has been found about a row.
  struct Found {
    Vec3d n0;             // direction from b to a when the step began
    Vec3d n;              // ... where they are now
    Vec3d along;          // of q: n0; of a spring (r0 + r)/(l0 + l), r from b to a
    double turned = 0;    // of a spring: by how much that has changed since q moved its ends [-]
    double l0 = 0;        // distance when the step began [m]
    double l = 0;         // now [m]
    double target = 0;    // of l; of a spring with what q adds to it [m]
    double give = 0;      // of a spring: l that a q gives [1/kg]
    double slack = 0;     // what does not count [m]
    double moved = 0;     // by each q, at most [1/kg]
    double rounding = 0;  // what does not count for each q [1/kg]
    double q = 0;         // impulse times h [kg m]
    double p = 0;         // impulse that turns speeds [N s]
    bool takes_part = false;
    bool is_loose = false;  // of a cable: it stays slack
    bool active = false;
  };

  /// Which sign an impulse of it may have; 0: any.
  [[nodiscard]] static double side(const NetRow& row) {
    return static_cast<double>(row.pushes) - static_cast<double>(row.pulls);
  }
  [[nodiscard]] double size_of(const NetRow& row) const {
    return length(bodies_[row.a].x) + length(bodies_[row.b].x) + std::abs(row.length);
  }
  /// Direction and distance of two places; where they are one, the direction stays. `normal`: the given one.
  static void measure(const NetRow& row, const Vec3d& normal, const Vec3d& between, Vec3d& n, double& l) {
    if (row.has_normal) {
      n = normal;
      l = dot(n, between);
      return;
    }
    l = length(between);
    if (l > 0) n = between * (1 / l);
  }
  void measure_all() {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      measure(rows_[i], rows_[i].normal, bodies_[rows_[i].a].x - bodies_[rows_[i].b].x, found_[i].n, found_[i].l);
  }
  /// At which its ends part.
  [[nodiscard]] double speed_of(const NetRow& row, const Vec3d& n) const {
    const NetBody &a = bodies_[row.a], &b = bodies_[row.b];
    const double speed = dot(n, a.v - b.v);
    return row.normal_rate == Vec3d{} ? speed : speed + dot(row.normal_rate, a.x - b.x);
  }
  void push(const NetRow& row, const Vec3d& n, double q, Vec3d NetBody::*what) const {
    PHYSIM_ASSERT(row.a < bodies_.size() && row.b < bodies_.size());
    NetBody &a = bodies_[row.a], &b = bodies_[row.b];
    a.*what += component_product(a.mobility, n * q);
    b.*what -= component_product(b.mobility, n * q);
  }

  // ------------------------------------------------------------------------------------------- all of it
  /// `follows`: speeds take part in what brings lengths back.
  void hold(bool follows) {
    report_.solved = follows;
    report_.residual = 0;
    follow_step(follows);
    followed_.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) followed_[i] = bodies_[i].x;
    put_right();
    turn_speeds();
  }
  /// True if the bodies have gained energy in the step beyond the work of the field that they fly in, of springs and of
  /// points that are carried: impulses may do so where steps are too long for the net. They are compared with the start
  /// of the step, less what flights of the first order gain by themselves, as their way is not that of their speeds.
  [[nodiscard]] bool gains(const std::vector<NetBody>& flown) const {
    const Balance b = balance(flown);
    return !(b.gained <= kMostGain * b.moved);  // written so that a NaN counts as a gain
  }
  /// Takes the energy that the net gained out of the motion of its bodies about that of their centre of mass.
  void calm(const std::vector<NetBody>& flown) {
    const double gained = balance(flown).gained;
    const bool is_free = std::ranges::none_of(bodies_, [](const NetBody& body) { return body.mobility == Vec3d{}; });
    double energy = 0;  // of that motion [J]
    Vec3d common{};
    for (double Vec3d::*axis : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
      double masses = 0, momentum = 0;
      for (const NetBody& body : bodies_)
        if (const double w = body.mobility.*axis; w > 0) masses += 1 / w, momentum += body.v.*axis / w;
      if (is_free && masses > 0) common.*axis = momentum / masses;
      for (const NetBody& body : bodies_)
        if (const double w = body.mobility.*axis; w > 0) energy += square(body.v.*axis - common.*axis) / (2 * w);
    }
    if (!(gained > 0 && energy > 0)) return;
    const double left = std::sqrt(std::max(1 - gained / energy, 0.0));
    for (NetBody& body : bodies_)
      for (double Vec3d::*axis : {&Vec3d::x, &Vec3d::y, &Vec3d::z})
        if (body.mobility.*axis > 0) body.v.*axis = common.*axis + (body.v.*axis - common.*axis) * left;
  }
  [[nodiscard]] static double square(double x) { return x * x; }

  struct Balance {
    double gained = 0;  // by the bodies, beyond the work done on them and the gain of their flights alone [J]
    double moved = 0;   // that of the motion of the step, before and after it [J]
  };
  [[nodiscard]] Balance balance(const std::vector<NetBody>& flown) const {
    double gained = 0, own = 0, moved = 0;  // [J]
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const NetBody &now = bodies_[i], &then = flown[i];
      const Vec3d way = followed_[i] - then.start, flown_way = then.x - then.start;
      const Vec3d push = (then.v - then.start_velocity) * (1 / part_.h);
      for (double Vec3d::*axis : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
        if (!(now.mobility.*axis > 0)) continue;
        const double mass = 1 / (now.mobility.*axis);
        const double began = square(then.start_velocity.*axis), ended = square(then.v.*axis);
        gained += mass * ((square(now.v.*axis) - began) / 2 - push.*axis * (way.*axis));
        own += mass * ((ended - began) / 2 - push.*axis * (flown_way.*axis));
        moved += mass * (ended + began) / 2;
      }
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Carried carried = carried_by(rows_[i], found_[i]);
      gained -= carried.work;
      moved += carried.energy;
      if (!rows_[i].is_spring()) continue;
      const auto stored = [&](double l) {
        return rows_[i].stiffness / 2 * (l - rows_[i].length) * (l - rows_[i].length);
      };
      gained += stored(found_[i].l) - stored(found_[i].l0);
      moved += stored(found_[i].l0);
    }
    return {gained - std::max(own, 0.0), moved};
  }

  /// What a point that is carried, with directions that turn, gives to the first end of a row.
  struct Carried {
    double work = 0;    // [J]
    double energy = 0;  // of the other end, were it carried along [J]
  };
  [[nodiscard]] Carried carried_by(const NetRow& row, const Found& f) const {
    const NetBody &a = bodies_[row.a], &b = bodies_[row.b];
    const double mobility = std::max(std::max(a.mobility.x, a.mobility.y), a.mobility.z);
    if (!b.is_carried || !(mobility > 0)) return {};
    const Vec3d velocity = (b.x - b.start) * (1 / part_.h);
    const double turned = dot(row.normal_rate, a.x - b.x);  // [m/s]
    const double impulse = f.q / part_.h + f.p;
    const Vec3d along = f.along * (times_of(row) * f.q / part_.h) + f.n * f.p;
    return {dot(along, velocity) - impulse * turned, (length_squared(velocity) + turned * turned) / (2 * mobility)};
  }

  // ------------------------------------------------------------------------------------------- equations
  /// Those of the active rows: how the distance along n changes with an impulse along `pushed`.
  void factor(Vec3d Found::*n, Vec3d Found::*pushed) {
    order_.assign(rows_.size(), 0);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (found_[i].active) order_[i] = count++;
    coefficients_.clear();
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      const Vec3d& w = bodies_[body].mobility;
      if (w == Vec3d{}) continue;
      for (const End& other : ends_[body]) {
        if (!found_[other.row].active) continue;
        const Vec3d moved = component_product(w, found_[other.row].*pushed) * other.sign;
        for (const End& one : ends_[body])
          if (const Found& f = found_[one.row]; f.active)
            coefficients_.push_back({order_[one.row], order_[other.row], one.sign * dot(f.*n, moved)});
      }
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (found_[i].active && pushed == &Found::along) coefficients_.push_back({order_[i], order_[i], found_[i].give});
    equations_.factor(count, coefficients_);
    work_ += std::max(equations_.work(), kLeastWork);
    unknown_.resize(count);
  }
  /// The unknowns of the active rows; f gives their right hand sides.
  template <class F, class G>
  void solve(const F& right_hand_side, const G& take) {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (found_[i].active) unknown_[order_[i]] = right_hand_side(i);
    equations_.solve(unknown_);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (found_[i].active) take(i, unknown_[order_[i]]);
  }

  /// Block pivoting: tries sets of active rows until one fits. `attempt` tries one, `fits(i)` says whether a row that
  /// takes part is rightly active, or rightly not.
  template <class Try, class Fits>
  bool choose(const Try& attempt, const Fits& fits) {
    std::size_t fewest = rows_.size() + 1;
    int patience = 3;
    for (std::size_t set = 0; set < kMostSets + 2 * rows_.size(); ++set) {
      const bool found = attempt();
      misfits_.clear();
      for (std::size_t i = 0; i < rows_.size(); ++i)
        if (found_[i].takes_part && side(rows_[i]) != 0 && !fits(i)) misfits_.push_back(i);
      if (misfits_.empty()) return found;
      if (!effort_.suffices(work_)) return false;
      const bool better = misfits_.size() < fewest;
      if (better) fewest = misfits_.size(), patience = 3;
      if (!better && patience-- <= 0) misfits_.erase(misfits_.begin(), misfits_.end() - 1);
      for (const std::size_t i : misfits_) found_[i].active = !found_[i].active;
    }
    return false;
  }

  /// Rods and springs always; what is as long as it may be, or beyond it.
  [[nodiscard]] static bool is_tight(const NetRow& row, const Found& f) {
    const double sign = side(row);
    return sign == 0 || sign * (f.l - f.target) <= kTaut * std::abs(row.length) + f.slack;
  }

  // ------------------------------------------------------------------------------------------- along the step
  /// What the rows did to their ends from the start of the step to its end.
  void follow_step(bool follows) {
    flown_.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) flown_[i] = bodies_[i].x;
    for (std::size_t i = 0; i < rows_.size(); ++i) begin(rows_[i], found_[i]);
    measure_all();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      Found& f = found_[i];
      f.active = f.takes_part && is_tight(rows_[i], f);
    }
    const auto fits = [this](std::size_t i) {
      const Found& f = found_[i];
      const double sign = side(rows_[i]);
      return f.active ? sign * f.q >= 0 : sign * (f.l - f.target) >= -f.slack;
    };
    if (!follows || !choose([this] { return find_lengths(); }, fits)) {
      report_.solved = false;
      for (std::size_t i = 0; i < rows_.size(); ++i) found_[i].q = 0;
      place();
    }
    report_.is_rough = !report_.solved;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (rows_[i].is_spring() && dot(found_[i].n0, found_[i].n) < 0) report_.is_rough = true;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Found& f = found_[i];
      if (f.q == 0) continue;
      push(rows_[i], f.along, times_of(rows_[i]) * f.q / part_.h, &NetBody::v);
    }
  }

  void begin(const NetRow& row, Found& f) const {
    const NetBody &a = bodies_[row.a], &b = bodies_[row.b];
    f.n0 = {0, 1, 0};
    measure(row, row.start_normal, a.start - b.start, f.n0, f.l0);
    f.n = f.along = f.n0;
    f.slack = 8 * kEpsilon * size_of(row);
    f.moved = length(a.mobility) + length(b.mobility);
    f.rounding = 16 * kEpsilon * f.moved;
    f.q = f.p = 0;
    f.give = 0;
    const bool has_direction = row.has_normal || row.is_spring() || f.l0 > 0;
    f.takes_part = has_direction && (a.mobility != Vec3d{} || b.mobility != Vec3d{});
    f.target = f.l0;
    if (row.only_pushes()) f.target = std::min(f.l0, row.length);
    if (row.is_cable() && !was_taut(row, f)) f.takes_part = false;
    if (!row.is_spring()) return;
    const double k = row.stiffness, c = row.damping;
    const double slope = part_.h * part_.h * k / 4 + part_.h * c / 2;
    PHYSIM_ASSERT(k >= 0 && c >= 0);
    f.takes_part = f.takes_part && slope > 0;
    if (!f.takes_part) return;
    f.give = 1 / slope;
    f.target = f.give * (part_.h * part_.h * k / 2 * (row.length - f.l0 / 2) + part_.h * c / 2 * f.l0);
  }
  [[nodiscard]] bool was_taut(const NetRow& row, const Found& f) const {
    const NetBody &a = bodies_[row.a], &b = bodies_[row.b];
    if (f.l0 < row.length - kTaut * row.length - 4 * (a.spacing + b.spacing)) return false;
    // Ends that part already, as after a blow, come taut now.
    const double rounding = 1e-5 * (length(a.start_velocity) + length(b.start_velocity));
    return row.restitution == 0 || dot(f.n0, a.start_velocity - b.start_velocity) <= rounding;
  }

  /// Bodies where they flew, moved by the rows; springs turn with their ends.
  void place() {
    bool turns = true;
    for (std::uint32_t times = 0; turns && times < kMostTurns; ++times) {
      for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].x = flown_[i];
      for (std::size_t i = 0; i < rows_.size(); ++i)
        if (found_[i].q != 0) push(rows_[i], found_[i].along, found_[i].q, &NetBody::x);
      measure_all();
      turns = false;
      for (std::size_t i = 0; i < rows_.size(); ++i)
        if (rows_[i].is_spring()) turns = turn(rows_[i], found_[i]) || turns;
    }
  }
  /// The mean direction of a spring: with it the work of its impulse is what it has given, to rounding. True if it has
  /// turned.
  bool turn(const NetRow& row, Found& f) const {
    const NetBody &a = bodies_[row.a], &b = bodies_[row.b];
    const double both = f.l0 + f.l;
    const Vec3d along = both > 0 ? (a.start - b.start + a.x - b.x) * (1 / both) : f.n0;
    f.turned = length(along - f.along);
    f.along = along;
    return f.q != 0 && f.turned > 4 * kEpsilon;
  }
  /// In units of q/h, what a row does to speeds along the step: half of a spring's impulse moves its ends.
  [[nodiscard]] static double times_of(const NetRow& row) { return row.is_spring() ? 2 : 1; }
  [[nodiscard]] static double missing(const Found& f) { return f.l + f.give * f.q - f.target; }

  /// q of the active rows, by Newton's method; where a step makes things worse, by less of it.
  bool find_lengths() {
    for (Found& f : found_) f.q = 0;
    place();
    std::vector<double> before(rows_.size()), step(rows_.size());
    double best = kInfinity, most = kInfinity, part = 1;
    for (std::uint32_t round = 0; round < kMostRounds && effort_.suffices(work_); ++round) {
      most = what_is_missing();
      if (most <= 1) return true;
      if (most < best) {
        best = most;
        part = 1;
        ++report_.rounds;
        factor(&Found::n, &Found::along);
        solve([this](std::size_t i) { return -missing(found_[i]); }, [&](std::size_t i, double q) { step[i] = q; });
        for (std::size_t i = 0; i < rows_.size(); ++i) before[i] = found_[i].q;
      } else if ((part /= 2) < kLeastPart) {
        break;
      }
      for (std::size_t i = 0; i < rows_.size(); ++i)
        if (found_[i].active) found_[i].q = before[i] + part * step[i];
      place();
    }
    return most < kNear;
  }
  /// The most that active rows miss, of what does not count.
  [[nodiscard]] double what_is_missing() const {
    double most = 0;
    for (const Found& f : found_)
      if (f.active)
        most = std::max(most, std::max(std::abs(missing(f)), f.moved * f.turned * std::abs(f.q)) /
                                  (f.slack + f.rounding * std::abs(f.q)));
    return most;
  }

  // ------------------------------------------------------------------------------------------- what is wrong
  /// Lengths are put right by the least moves, which give no speed.
  void put_right() {
    for (std::size_t i = 0; i < rows_.size(); ++i) look_whether_taut(rows_[i], found_[i]);
    double most = what_is_wrong();
    for (std::uint32_t round = 0; round < kMostRounds && most > 1; ++round) {
      if (round >= kFewRounds && !effort_.suffices(work_)) break;
      ++report_.rounds;
      const double left = move_by_newton(most);
      if (!(left < most)) break;
      most = left;
    }
    report_.solved = report_.solved && most <= kNear;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (is_wrong(rows_[i], found_[i]))
        report_.residual = std::max(report_.residual, std::abs(found_[i].l - found_[i].target));
  }
  /// A step of Newton's method, or as much of it as makes things better; the most that is wrong after it.
  double move_by_newton(double most) {
    std::vector<Vec3d> before(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) before[i] = bodies_[i].x;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      found_[i].active = is_held(rows_[i]) && is_tight(rows_[i], found_[i]);
    factor(&Found::n, &Found::n);
    std::vector<Vec3d> n(rows_.size());
    std::vector<double> q(rows_.size());
    solve([this](std::size_t i) { return found_[i].target - found_[i].l; },
          [&](std::size_t i, double found) { n[i] = found_[i].n, q[i] = found; });
    double part = 1;
    for (; part >= kLeastPart; part /= 2) {
      for (std::size_t i = 0; i < rows_.size(); ++i) push(rows_[i], n[i], part * q[i], &NetBody::x);
      measure_all();
      const double left = what_is_wrong();
      if (left < most) return left;
      for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].x = before[i];
    }
    measure_all();
    return most;
  }
  /// Its length is kept, and it can be.
  [[nodiscard]] bool is_held(const NetRow& row) const {
    return !row.is_spring() && (bodies_[row.a].mobility != Vec3d{} || bodies_[row.b].mobility != Vec3d{});
  }
  [[nodiscard]] bool is_wrong(const NetRow& row, const Found& f) const {
    return is_held(row) && (side(row) == 0 || side(row) * (f.l - f.target) < 0);
  }
  /// The most that lengths are off, of what does not count.
  [[nodiscard]] double what_is_wrong() const {
    double most = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (is_wrong(rows_[i], found_[i]))
        most = std::max(most, std::abs(found_[i].l - found_[i].target) / found_[i].slack);
    return most;
  }
  void look_whether_taut(NetRow& row, Found& f) {
    const NetBody &a = bodies_[row.a], &b = bodies_[row.b];
    f.slack = 1e-12 * std::abs(row.length) + 4 * (a.spacing + b.spacing) + 8 * kEpsilon * size_of(row);
    f.target = row.length;
    row.came_taut = false;
    f.is_loose = !part_.comes_taut && row.is_cable() && !f.takes_part;
    if (f.is_loose) f.target = kInfinity;
    if (f.is_loose || !row.is_cable() || f.takes_part) return;
    // Just as long as it may be it comes taut if its ends part.
    const double speed = speed_of(row, f.n);
    if (!(f.l > row.length + f.slack) && !(is_stretched(row, f) && speed > 0)) return;
    row.came_taut = true;
    row.speed = std::max(speed, 0.0);
    f.p = row.speed * restitution_of(row, f);
    if (f.p > 0) f.target -= row.restitution * std::max(f.l - row.length, 0.0);
  }
  /// As long as it may be, but for rounding.
  [[nodiscard]] static bool is_stretched(const NetRow& row, const Found& f) {
    return f.l >= row.length - kTaut * row.length - f.slack;
  }
  /// A bounce of a cable that came taut and would be over within this step does not lift it any more.
  [[nodiscard]] double restitution_of(const NetRow& row, const Found& f) const {
    const double before = dot(f.n0, bodies_[row.a].start_velocity - bodies_[row.b].start_velocity);
    const double gained = (row.speed - before) * (part_.step / part_.h);  // in a whole step
    return row.restitution * row.speed > gained / 2 ? row.restitution : 0;
  }

  // ------------------------------------------------------------------------------------------- speeds
  [[nodiscard]] static bool holds(const NetRow& row, const Found& f) {
    if (row.is_cable()) return !f.is_loose && (row.came_taut || is_stretched(row, f));
    return row.is_rod() || (row.only_pushes() && f.l <= row.length + f.slack);
  }

  /// Takes away the speeds at which rows would become longer or shorter than they may be.
  void turn_speeds() {
    std::vector<double> before(rows_.size()), wanted(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      Found& f = found_[i];
      wanted[i] = -f.p;
      f.p = 0;
      before[i] = speed_of(rows_[i], f.n);
      f.takes_part = is_held(rows_[i]) && holds(rows_[i], f);
      f.active = f.takes_part && (side(rows_[i]) == 0 || side(rows_[i]) * (before[i] - wanted[i]) < 0);
    }
    std::vector<Vec3d> flown(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) flown[i] = bodies_[i].v;
    const auto attempt = [&] {
      for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].v = flown[i];
      for (Found& f : found_) f.p = 0;
      factor(&Found::n, &Found::n);
      // Once more for what rounding left.
      for (int twice = 0; twice < 2; ++twice)
        solve([&](std::size_t i) { return wanted[i] - speed_of(rows_[i], found_[i].n); },
              [&](std::size_t i, double p) { found_[i].p += p, push(rows_[i], found_[i].n, p, &NetBody::v); });
      return true;
    };
    const auto fits = [&](std::size_t i) {
      const Found& f = found_[i];
      const double sign = side(rows_[i]);
      const double rounding = 64 * kEpsilon * (length(bodies_[rows_[i].a].v) + length(bodies_[rows_[i].b].v));
      return f.active ? sign * f.p >= 0 : sign * (speed_of(rows_[i], f.n) - wanted[i]) >= -rounding;
    };
    report_.solved = choose(attempt, fits) && report_.solved;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      rows_[i].impulse = -(times_of(rows_[i]) * found_[i].q / part_.h + found_[i].p);
    }
  }

  static constexpr double kLeastPart = 1e-3;  // of a step of Newton's method [-]
  static constexpr double kMostGain = 0.02;   // of the energy of a net's motion, in a step [-]
  static constexpr double kNear = 100;        // times what may be missing: rounding of many rows

  std::span<NetBody> bodies_;
  std::span<NetRow> rows_;
  const NetPart part_;
  const NetEffort& effort_;
  double work_ = 0;                     // of its rounds
  std::vector<std::vector<End>> ends_;  // of rows, by body
  std::vector<Found> found_;
  std::vector<Vec3d> flown_;          // places before the net holds them
  std::vector<Vec3d> followed_;       // ... after what speeds took part in
  std::vector<std::uint32_t> order_;  // of active rows among themselves
  std::vector<Envelope::Coefficient> coefficients_;
  std::vector<double> unknown_;
  std::vector<std::size_t> misfits_;
  Envelope equations_;
  NetReport report_;
};

}  // namespace

NetReport hold_part(std::span<NetBody> bodies, std::span<NetRow> rows, const NetPart& part, NetEffort& effort) {
  Net net(bodies, rows, part, effort);
  const NetReport report = net.run();
  effort.take(net.work(), report.solved);
  return report;
}

}  // namespace physim
