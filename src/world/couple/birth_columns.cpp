#include "world/couple/birth_columns.hpp"

#include <algorithm>
#include <cmath>

#include "emit/newborn_pack.hpp"
#include "math/pack.hpp"
#include "math/quat.hpp"
#include "world/step/drive.hpp"

namespace physim {
namespace {

// A register's worth: what is computed of poses stays in registers.
using Wide = Pack<double, kNativeBytes / sizeof(double)>;
constexpr std::size_t kWide = kLanes<Wide>;

/// Lanes behind the last birth repeat it.
NewbornPack drawn(const Emission& emission, const BirthColumns& b, std::size_t first) {
  PHYSIM_ASSERT(b.count > 0 && first < b.count);
  NewbornPack pack;
  pack.count = std::min(NewbornPack::kLanes, b.count - first);
  for (std::size_t i = 0; i < NewbornPack::kLanes; ++i) {
    const std::size_t lane = std::min(first + i, b.count - 1);
    pack.number[i] = b.number[lane], pack.time[i] = b.own_time[lane], pack.phase[i] = b.phase[lane];
    pack.of_moment[i] = b.of_moment[lane], pack.moment[i] = b.moment[lane];
  }
  emission.newborns(pack);
  return pack;
}

/// Poses side by side.
struct WidePose {
  Vec3<Wide> position;
  Quat<Wide> rotation;
  Vec3<Wide> velocity;  // the inherited part
};
/// Poses from a lane on.
WidePose poses(const BirthColumns& b, std::size_t first) {
  const auto each = [&](const auto& number_of) {
    Wide wide;
    for (std::size_t i = 0; i < kWide; ++i)
      wide.set(static_cast<int>(i), number_of(b.pose[std::min(first + i, b.count - 1)]));
    return wide;
  };
  const auto vector = [&](Vec3d Pose::*of) {
    return Vec3<Wide>{each([of](const Pose& p) { return (p.*of).x; }), each([of](const Pose& p) { return (p.*of).y; }),
                      each([of](const Pose& p) { return (p.*of).z; })};
  };
  const auto part = [&](double Quatd::*of) { return each([of](const Pose& p) { return p.rotation.*of; }); };
  return {vector(&Pose::position),
          {part(&Quatd::w), part(&Quatd::x), part(&Quatd::y), part(&Quatd::z)},
          vector(&Pose::velocity) * Wide(b.inherited)};
}

/// Where newborns start, in W.
struct Starts {
  std::array<NewbornPack::Column, 3> x, v;
};
Starts placed_by_one(const Pose& pose, double inherited, const NewbornPack& pack) {
  Starts starts;
  if (pack.count < NewbornPack::kLanes) starts = {};  // unused lanes
  StartJob job{.count = pack.count,
               .position = pose.position,
               .rotation = pose.rotation,
               .velocity = pose.velocity * inherited,
               .speed = pack.speed.data()};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    job.place[axis] = pack.place[axis].data(), job.direction[axis] = pack.direction[axis].data();
    job.x[axis] = starts.x[axis].data(), job.v[axis] = starts.v[axis].data();
  }
  particle_kernel().starts(job);
  return starts;
}
Starts placed(const BirthColumns& b, const NewbornPack& pack, std::size_t first) {
  if (b.one_pose) return placed_by_one(b.pose[0], b.inherited, pack);
  Starts starts{};
  for (std::size_t i = 0; i < pack.count; i += kWide) {
    const auto load = [i](const std::array<NewbornPack::Column, 3>& of) {
      return Vec3<Wide>{Wide::load(of[0].data() + i), Wide::load(of[1].data() + i), Wide::load(of[2].data() + i)};
    };
    const WidePose pose = poses(b, first + i);
    const Vec3<Wide> x = pose.position + rotate(pose.rotation, load(pack.place));
    const Vec3<Wide> v =
        rotate(pose.rotation, load(pack.direction)) * Wide::load(pack.speed.data() + i) + pose.velocity;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      x[axis].store(starts.x[axis].data() + i);
      v[axis].store(starts.v[axis].data() + i);
    }
  }
  return starts;
}

/// Puts them into the numbers of their rows; bits of those that are finite there, and move.
template <class S>
std::uint32_t put(const Starts& starts, std::size_t first, FlownParts<S>& flights) {
  std::array<S, NewbornPack::kLanes> nothing{};  // differences of what is finite
  NewbornPack::Column square{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < NewbornPack::kLanes; ++i) {
      const S x = static_cast<S>(starts.x[axis][i]), v = static_cast<S>(starts.v[axis][i]);
      flights.x[axis][first + i] = x, flights.v[axis][first + i] = v;
      nothing[i] += (x - x) + (v - v);
      square[i] += starts.v[axis][i] * starts.v[axis][i];
    }
  std::uint32_t sound = 0;
  for (std::size_t i = 0; i < NewbornPack::kLanes; ++i) sound |= (nothing[i] == S(0) && square[i] > 0 ? 1u : 0u) << i;
  return sound;
}

/// What their emitter does to them where they start.
template <class S>
void put_pushes(const FlightLaw& law, const BirthColumns& b, const SettleContext& context, FlownParts<S>& flights) {
  static_assert(FlightLaw::kPack == BirthColumns::kLanes);
  PHYSIM_ASSERT(b.count > 0 && b.count <= BirthColumns::kLanes);
  FlightPack<FlightLaw::kPack> pack;
  for (std::size_t i = 0; i < FlightLaw::kPack; ++i) {
    const std::size_t lane = std::min(i, b.count - 1);
    const InFlight particle = in_flight({.number = b.number[lane], .dies = b.dies[lane]}, b.time[lane]);
    pack.number[i] = particle.number, pack.birth[i] = particle.birth, pack.span[i] = particle.span;
    pack.time[i] = context.time + std::clamp(b.time[lane] - context.time, 0.0, context.dt);
    const auto finite = [](S x) { return x - x == S(0) ? static_cast<double>(x) : 0; };  // others are refused
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pack.x[axis][i] = finite(flights.x[axis][lane]);
      pack.v[axis][i] = finite(flights.v[axis][lane]);
    }
  }
  FlightPack<FlightLaw::kPack>::Vectors a;
  FlightPack<FlightLaw::kPack>::Column rate;
  law.accelerations(pack, a, rate);
  for (std::size_t i = 0; i < FlightLaw::kPack; ++i) flights.drag_rate[i] = S(0) + static_cast<S>(rate[i]);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < FlightLaw::kPack; ++i)
      flights.push[axis][i] = S(0) + static_cast<S>(a[axis][i]);  // beside nothing else
}

template <class S>
void fly(const BirthPlan& plan, const SettleContext& context, PartFlights& known, FlownParts<S>& flights) {
  BodyNumbers<S> body;
  for (const std::uint8_t field : context.state->rows[plan.cohort].layout().fields)
    body[field] = static_cast<S>(numbers(*plan.body)[field]);
  known.fly(context, plan.cohort, body, flights);
}

template <class S>
void prepare(const BirthPlan& plan, const SettleContext& context, double end, PartFlights& known, BirthColumns& b,
             FlownParts<S>& flights) {
  std::uint32_t plain = 0, flying = 0;
  flights.count = b.count;
  for (std::size_t first = 0; first < b.count; first += NewbornPack::kLanes) {
    const NewbornPack pack = drawn(*plan.emission, b, first);
    plain |= put(placed(b, pack, first), first, flights) << first;
    for (std::size_t i = first; i < std::min(first + NewbornPack::kLanes, b.count); ++i) {
      const double dies = b.time[i] + pack.lifetime[i - first];
      b.dies[i] = dies > b.time[i] ? dies : std::nextafter(b.time[i], kInfinity);
    }
  }
  for (std::size_t i = 0; i < BirthColumns::kLanes; ++i) {
    const std::size_t lane = std::min(i, b.count - 1);
    const std::uint32_t bit = 1u << i;
    const bool flies = b.time[lane] < end;
    const double age = flies ? context.dt - std::clamp(b.time[lane] - context.time, 0.0, context.dt) : 0;
    b.age[i] = age;
    flights.length[i] = static_cast<S>(age);
    if (flies) flying |= bit;
    if (flies && !(age > 0 && b.dies[lane] > end)) plain &= ~bit;
  }
  if (plan.law) put_pushes(*plan.law, b, context, flights);
  if (flying != 0) fly(plan, context, known, flights);
  for (std::size_t i = 0; i < b.count; ++i) {
    if ((flying >> i & 1) != 0) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      flights.end_x[axis][i] = flights.x[axis][i], flights.end_v[axis][i] = flights.v[axis][i];
  }
  b.plain = plain & (flights.quiet | ~flying);
  if (b.count < BirthColumns::kLanes) b.plain &= (1u << b.count) - 1;
}

}  // namespace

void prepare_births(const BirthPlan& plan, const SettleContext& context, double end, PartFlights& known,
                    BirthColumns& births) {
  PHYSIM_ASSERT(plan.kind != 0 && births.count > 0 && births.count <= BirthColumns::kLanes);
  if (plan.float32)
    prepare(plan, context, end, known, births, std::get<0>(births.flights));
  else
    prepare(plan, context, end, known, births, std::get<1>(births.flights));
}

}  // namespace physim
