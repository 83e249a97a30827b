// Compiled once per instruction set, in a namespace of its name.
#include "emit/drawn_lanes.hpp"
#include "emit/particle_job.hpp"
#include "emit/shape_lanes.hpp"
#include "math/philox_lanes.hpp"
#include "math/quat.hpp"

PHYSIM_ISA_BEGIN

namespace {
constexpr std::size_t kWide = kNativeBytes / 8;
using Numbers = Pack<double, int(kWide)>;
using Words = Pack<std::uint64_t, int(kWide)>;
static_assert(kColumn % kWide == 0);

/// Between 0 and 1, as open_unit() has them of words.
PHYSIM_INLINE Numbers units_of(const std::uint32_t* words) {
  constexpr double kFirst = 0x1p52;
  std::uint64_t wide[kWide];
  for (std::size_t lane = 0; lane < kWide; ++lane) wide[lane] = words[lane];
  const Numbers number = from_bits<Numbers>(Words::load(wide) | to_bits(Numbers(kFirst))) - Numbers(kFirst);
  return (number + Numbers(0.5)) * Numbers(0x1p-32);
}

/// The draws of a pack of particles.
struct DrawnWords {
  const std::uint32_t* const* words;
  std::size_t first;
  PHYSIM_INLINE Numbers operator()(Draw what) const { return units_of(words[static_cast<unsigned>(what)] + first); }
};

PHYSIM_INLINE Vec3<Numbers> vector_at(const double* const (&column)[3], std::size_t i) {
  return {Numbers::load(column[0] + i), Numbers::load(column[1] + i), Numbers::load(column[2] + i)};
}
PHYSIM_INLINE void put_vector(const Vec3<Numbers>& v, double* const (&column)[3], std::size_t i) {
  v.x.store(column[0] + i), v.y.store(column[1] + i), v.z.store(column[2] + i);
}

/// factor curve(x); a curve without pieces is 1.
PHYSIM_INLINE void put_scaled(double factor, const CurvePieces& curve, const double* x, double* y) {
  if (curve.count > 0) put_curve<Numbers>(curve, x, y, kColumn);
  for (std::size_t i = 0; i < kColumn; ++i) y[i] = curve.count > 0 ? factor * y[i] : factor;
}
}  // namespace

void draw_words(const WordsJob& job) {
  PHYSIM_ASSERT(job.number != nullptr && job.words[0] != nullptr && job.words[3] != nullptr);
  const std::uint32_t key[2] = {static_cast<std::uint32_t>(job.seed), static_cast<std::uint32_t>(job.seed >> 32)};
  constexpr std::size_t kHere = 2 * kWide;  // two registers hide each other's waiting
  static_assert(kColumn % kHere == 0);
  using Pair = Pack<std::uint64_t, int(kHere)>;
  for (std::size_t i = 0; i < job.count; i += kHere) {
    const Pair number = Pair::load(job.number + i);
    Pair words[4] = {number & Pair(kPhiloxWord), number >> 32, Pair(0), Pair(job.stream_and_index)};
    philox_lanes(words, key);
    for (std::size_t k = 0; k < 4; ++k) {
      std::uint64_t wide[kHere];
      words[k].store(wide);
      for (std::size_t lane = 0; lane < kHere; ++lane) job.words[k][i + lane] = static_cast<std::uint32_t>(wide[lane]);
    }
  }
}

void put_outlets(const OutletJob& job) {
  for (std::size_t i = 0; i < job.count; i += kWide) {
    DrawnWords chance{job.words, i};
    const WayOutOf<Numbers, DrawnWords> way(*job.shape, Numbers::load(job.time + i), Numbers::load(job.of_moment + i),
                                            Numbers::load(job.moment + i), chance);
    const WayOut<Numbers> out = way.out();
    put_vector(out.place, job.place, i);
    put_vector(out.direction, job.direction, i);
  }
}

void put_starts(const StartJob& job) {
  const auto wide = [](const Vec3d& v) PHYSIM_INLINE_LAMBDA {
    return Vec3<Numbers>{Numbers(v.x), Numbers(v.y), Numbers(v.z)};
  };
  const Quatd& q = job.rotation;
  const Quat<Numbers> rotation{Numbers(q.w), Numbers(q.x), Numbers(q.y), Numbers(q.z)};
  const Vec3<Numbers> position = wide(job.position), velocity = wide(job.velocity);
  for (std::size_t i = 0; i < job.count; i += kWide) {
    put_vector(position + rotate(rotation, vector_at(job.place, i)), job.x, i);
    put_vector(rotate(rotation, vector_at(job.direction, i)) * Numbers::load(job.speed + i) + velocity, job.v, i);
  }
}

void put_numbers(const NumberJob& job) {
  double a[kColumn];
  put_scaled(job.value, job.curve, job.x, a);
  if (job.words != nullptr) {
    double b[kColumn];
    put_scaled(job.to, job.to_curve, job.x, b);
    for (std::size_t i = 0; i < kColumn; i += kWide) {
      const Numbers from = Numbers::load(a + i), to = Numbers::load(b + i), u = units_of(job.words + i);
      select(from == to, from, from + u * (to - from)).store(a + i);
    }
  }
  for (std::size_t i = 0; i < kColumn; ++i) job.y[i] = a[i];
}

void put_gradients(const GradientPieces& pieces, const double* x, const ColourColumns& colour) {
  put_gradient<Numbers>(pieces, x, colour, kColumn);
}

void pack_colours(const ColourColumns& colour, std::uint32_t* packed) {
  std::uint32_t all[kColumn] = {};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < kColumn; ++i)
      all[i] = all[i] << 8 | static_cast<std::uint32_t>(static_cast<std::int32_t>(colour.part[k][i] + 0.5));
  for (std::size_t i = 0; i < kColumn; ++i) packed[i] = all[i];
}

void put_parts_of_life(double time, const double* birth, const double* span, double* part) {
  for (std::size_t i = 0; i < kColumn; i += kWide) {
    const Numbers x = (Numbers(time) - Numbers::load(birth + i)) / Numbers::load(span + i);
    select(x < Numbers(0.0), Numbers(0.0), select(x > Numbers(1.0), Numbers(1.0), x)).store(part + i);
  }
}

PHYSIM_ISA_END
