// Compiled once per instruction set, in a namespace of its name.
#include <limits>
#include <type_traits>

#include "solve/take_step.hpp"
#include "study/cell_number.hpp"
#include "study/shard_job.hpp"

PHYSIM_ISA_BEGIN

namespace {
constexpr int kLanesAtOnce = 2 * kNativeBytes / 8;  // two registers side by side hide each other's waiting
constexpr auto kMany = static_cast<std::size_t>(kLanesAtOnce);
using Numbers = Pack<double, kLanesAtOnce>;
using Eight = Pack<double, 8>;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// f for a pack of places at a time, then for each that is left; its second argument distinguishes the two.
template <class F>
PHYSIM_INLINE void each_place(std::size_t count, const F& f) {
  std::size_t i = 0;
  for (; i + kMany <= count; i += kMany) f(i, std::type_identity<Numbers>());
  for (; i < count; ++i) f(i, std::type_identity<double>());
}
template <class R>
PHYSIM_INLINE Vec3<R> spread(const Vec3d& v) {
  return {R(v.x), R(v.y), R(v.z)};
}
}  // namespace

void stretch_column(double offset, double factor, const double* from, double* into, std::size_t count) {
  each_place(count, [&]<class R>(std::size_t i, std::type_identity<R>) PHYSIM_INLINE_LAMBDA {
    store_lanes(R(offset) + R(factor) * load_lanes<R>(from + i), into + i);
  });
}

/// left = ahead t + slower t^2 / 2 has a root t that is small where `left` is.
void move_to_plane(const PlaneJob& job) {
  each_place(job.count, [&]<class R>(std::size_t i, std::type_identity<R>) PHYSIM_INLINE_LAMBDA {
    const Vec3<R> f = spread<R>(job.forward), a = spread<R>(job.acceleration);
    const State<R> s{{load_lanes<R>(job.x + i), load_lanes<R>(job.y + i), load_lanes<R>(job.z + i)},
                     {load_lanes<R>(job.vx + i), load_lanes<R>(job.vy + i), load_lanes<R>(job.vz + i)}};
    const R time = load_lanes<R>(job.time + i);
    const R left = R(job.range) - dot(s.x - spread<R>(job.muzzle), f), ahead = dot(s.v, f), slower = dot(a, f);
    const R t = R(2.0) * left / (ahead + sqrt(ahead * ahead + R(2.0) * slower * left));
    const auto arrives = (ahead > R(0.0)) & (abs(t) <= R(job.most_time) * time);
    const State<R> there = moved_steadily(s, a, t);
    store_lanes(select(arrives, there.x.x, R(kNoNumber)), job.x + i);
    store_lanes(select(arrives, there.x.y, s.x.y), job.y + i);
    store_lanes(select(arrives, there.x.z, s.x.z), job.z + i);
    store_lanes(select(arrives, there.v.x, s.v.x), job.vx + i);
    store_lanes(select(arrives, there.v.y, s.v.y), job.vy + i);
    store_lanes(select(arrives, there.v.z, s.v.z), job.vz + i);
    store_lanes(select(arrives, time + t, time), job.time + i);
  });
}

void put_along(const AxisJob& job) {
  each_place(job.count, [&]<class R>(std::size_t i, std::type_identity<R>) PHYSIM_INLINE_LAMBDA {
    const Vec3<R> x{load_lanes<R>(job.x + i), load_lanes<R>(job.y + i), load_lanes<R>(job.z + i)};
    store_lanes(dot(x - spread<R>(job.start), spread<R>(job.axis)), job.along + i);
  });
}

void put_lengths(const double* x, const double* y, const double* z, double* into, std::size_t count) {
  each_place(count, [&]<class R>(std::size_t i, std::type_identity<R>) PHYSIM_INLINE_LAMBDA {
    const R a = load_lanes<R>(x + i), b = load_lanes<R>(y + i), c = load_lanes<R>(z + i);
    store_lanes(sqrt(a * a + b * b + c * c), into + i);
  });
}

void put_distances(const double* right, const double* up, double from_right, double from_up, double* into,
                   std::size_t count) {
  each_place(count, [&]<class R>(std::size_t i, std::type_identity<R>) PHYSIM_INLINE_LAMBDA {
    const R x = load_lanes<R>(right + i) - R(from_right), y = load_lanes<R>(up + i) - R(from_up);
    store_lanes(sqrt(x * x + y * y), into + i);
  });
}

bool all_are_finite(const double* numbers, std::size_t count) {
  auto finite = Numbers(0.0) == Numbers(0.0);
  std::size_t i = 0;
  for (; i + kMany <= count; i += kMany) finite = finite & is_finite(Numbers::load(numbers + i));
  bool rest = true;
  for (; i < count; ++i) rest = rest && is_finite(numbers[i]);
  return rest && all(finite);
}

/// If zeros differ by their sign the first is the least, the last the most, as if each were compared in sequence.
LeastAndMost least_and_most_of(const double* numbers, std::size_t count) {
  PHYSIM_ASSERT(count > 0);
  Eight least(numbers[0]), most = least;
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    const Eight x = Eight::load(numbers + i);
    least = min(least, x), most = max(most, x);
  }
  LeastAndMost of{numbers[0], numbers[0]};
  const auto take_in = [&of](double x) {
    if (x < of.least) of.least = x;
    if (x > of.most) of.most = x;
  };
  for (int lane = 0; lane < 8; ++lane) take_in(least[lane]), take_in(most[lane]);
  for (; i < count; ++i) take_in(numbers[i]);
  for (i = 0; of.least == 0 && i < count; ++i)
    if (numbers[i] == 0) {
      of.least = numbers[i];
      break;
    }
  for (i = count; of.most == 0 && i-- > 0;)
    if (numbers[i] == 0) {
      of.most = numbers[i];
      break;
    }
  return of;
}

namespace {
/// Sums of `kSums` terms over all shots, side by side: each addition waits for the one before.
template <int kSums, class Term>
PHYSIM_INLINE void put_sums(std::size_t count, double* sums, const Term& term) {
  using Four = Pack<double, 4>;
  Four packs[kSums];
  for (Four& sum : packs) sum = Four(0.0);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
    for (int k = 0; k < kSums; ++k) packs[k] += term(k, i, std::type_identity<Four>());
  for (int k = 0; k < kSums; ++k) {
    double lanes[4];
    packs[k].store(lanes);
    for (std::size_t rest = i; rest < count; ++rest) lanes[0] += term(k, rest, std::type_identity<double>());
    sums[k] = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
  }
}
/// put_sums() of three terms at most.
template <class Term>
PHYSIM_INLINE void put_some_sums(std::size_t terms, std::size_t count, double* sums, const Term& term) {
  PHYSIM_ASSERT(terms <= 3);
  if (terms == 3) put_sums<3>(count, sums, term);
  if (terms == 2) put_sums<2>(count, sums, term);
  if (terms == 1) put_sums<1>(count, sums, term);
}

/// A column, and where it is counted from.
struct Deviations {
  const double* numbers;
  double mean;

  template <class R>
  PHYSIM_INLINE R at(std::size_t i) const {
    return load_lanes<R>(numbers + i) - R(mean);
  }
};
}  // namespace

void put_moments(const MomentsJob& job) {
  PHYSIM_ASSERT(job.count > 0);
  const std::size_t columns = job.columns_count;
  for (std::size_t first = 0; first < columns; first += 3)
    put_some_sums(columns - first < 3 ? columns - first : 3, job.count, job.means + first,
                  [&]<class R>(int k, std::size_t i, std::type_identity<R>)
                      PHYSIM_INLINE_LAMBDA { return load_lanes<R>(job.columns[first + unsigned(k)] + i); });
  for (std::size_t i = 0; i < columns; ++i) job.means[i] /= static_cast<double>(job.count);
  Deviations one[3], other[3];
  std::size_t terms = 0, done = 0;
  const auto put = [&] {
    put_some_sums(terms, job.count, job.products + done,
                  [&]<class R>(int k, std::size_t i, std::type_identity<R>)
                      PHYSIM_INLINE_LAMBDA { return one[k].template at<R>(i) * other[k].template at<R>(i); });
    done += terms, terms = 0;
  };
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t j = i; j < columns; ++j) {
      one[terms] = {job.columns[i], job.means[i]}, other[terms] = {job.columns[j], job.means[j]};
      if (++terms == 3) put();
    }
  put();
}

void put_cells(const CellJob& job) {
  each_place(job.count, [&]<class R>(std::size_t i, std::type_identity<R>) PHYSIM_INLINE_LAMBDA {
    const BitsOf<R> cell = cell_number((load_lanes<R>(job.numbers + i) - R(job.centre)) * R(job.per_scale));
    store_lanes(cell, job.cells + i);
  });
}

namespace {
constexpr std::size_t kMostShots = 100;  // of a group

/// Spreads of groups side by side: row i holds shot i of each.
template <class R>
PHYSIM_INLINE R spread_of(std::size_t size, const double* right, const double* up) {
  constexpr auto kGroups = static_cast<std::size_t>(kLanes<R>);
  R most(0.0), sum(0.0);
  for (std::size_t i = 0; i < size; ++i) {
    const R x = load_lanes<R>(right + i * kGroups), y = load_lanes<R>(up + i * kGroups);
    sum += x + y;
    for (std::size_t j = 0; j < i; ++j) {
      const R dx = x - load_lanes<R>(right + j * kGroups), dy = y - load_lanes<R>(up + j * kGroups);
      most = max(dx * dx + dy * dy, most);
    }
  }
  return select(is_finite(sum), sqrt(most), R(kNoNumber));
}

/// The shots of eight groups, side by side.
PHYSIM_INLINE void turn_groups(const double* from, std::size_t size, double* rows) {
  for (std::size_t group = 0; group < 8; ++group)
    for (std::size_t i = 0; i < size; ++i) rows[i * 8 + group] = from[group * size + i];
}
}  // namespace

/// Many groups are turned before any of them is looked at: reading rows right after their numbers were written one by
/// one would wait for these.
void put_spreads(const SpreadJob& job) {
  PHYSIM_ASSERT(job.size >= 2 && job.size <= kMostShots);
  constexpr std::size_t kRoom = 16 * kMostShots;
  double right[kRoom], up[kRoom];
  const std::size_t size = job.size, eight = 8 * size, at_once = kRoom / eight * 8;
  std::size_t group = 0;
  while (group + 8 <= job.groups) {
    const std::size_t left = (job.groups - group) / 8 * 8, some = left < at_once ? left : at_once;
    for (std::size_t k = 0; k < some; k += 8) {
      turn_groups(job.right + (group + k) * size, size, right + k * size);
      turn_groups(job.up + (group + k) * size, size, up + k * size);
    }
    for (std::size_t k = 0; k < some; k += 8)
      store_lanes(spread_of<Eight>(size, right + k * size, up + k * size), job.spreads + group + k);
    group += some;
  }
  for (; group < job.groups; ++group)
    store_lanes(spread_of<double>(size, job.right + group * size, job.up + group * size), job.spreads + group);
}

/// In eight lanes: none waits for the largest of the others. Several directions at a time, as registers allow.
void put_reach(ReachJob& job) {
  PHYSIM_ASSERT(job.count > 0);
  constexpr std::size_t kAtOnce = kNativeBytes == 64 ? 8 : 2;
  static_assert(ReachJob::kDirections % kAtOnce == 0);
  for (std::size_t first = 0; first < ReachJob::kDirections; first += kAtOnce) {
    const double *to_right = job.to_right + first, *to_up = job.to_up + first;
    const auto along = [&](std::size_t k, const auto& right, const auto& up) PHYSIM_INLINE_LAMBDA {
      using R = std::decay_t<decltype(right)>;
      return R(to_right[k]) * right + R(to_up[k]) * up;
    };
    Eight most[kAtOnce];
    for (std::size_t k = 0; k < kAtOnce; ++k) most[k] = Eight(along(k, job.right[0], job.up[0]));
    std::size_t i = 1;
    for (; i + 8 <= job.count; i += 8) {
      const Eight right = Eight::load(job.right + i), up = Eight::load(job.up + i);
      for (std::size_t k = 0; k < kAtOnce; ++k) most[k] = max(along(k, right, up), most[k]);
    }
    for (std::size_t k = 0; k < kAtOnce; ++k) {
      double lanes[8];
      most[k].store(lanes);
      for (std::size_t j = i; j < job.count; ++j) lanes[0] = max(along(k, job.right[j], job.up[j]), lanes[0]);
      double farthest = lanes[0];
      for (const double lane : lanes) farthest = max(lane, farthest);
      job.reach[first + k] = farthest;
    }
  }
}

PHYSIM_ISA_END
