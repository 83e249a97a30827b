// Compiled once per instruction set, in a namespace of its name. Two registers side by side hide each other's waiting.
#include "math/normal_quantile.hpp"
#include "math/philox_lanes.hpp"
#include "math/row_table.hpp"
#include "study/draw_job.hpp"

PHYSIM_ISA_BEGIN

namespace {
constexpr int kLanesDrawn = 2 * kNativeBytes / 8;
constexpr auto kMany = static_cast<std::size_t>(kLanesDrawn);
using Numbers = Pack<double, kLanesDrawn>;
using Words = Pack<std::uint64_t, kLanesDrawn>;
constexpr int kPer = Numbers::kPerRegister;

/// The middle of the cell of (0, 1) that the upper 52 of 64 bits name: their digits become those of a number from 2^52
/// on.
PHYSIM_INLINE Numbers units_of(const Words& bits) {
  constexpr double kFirst = 0x1p52;
  const Numbers digits = from_bits<Numbers>((bits >> 12) | to_bits(Numbers(kFirst))) - Numbers(kFirst);
  return (digits + Numbers(0.5)) * Numbers(0x1p-52);
}

/// Which of the pairs of a pack a lane holds: such that the halves of a register's pairs, taken from every other lane,
/// come out in order.
constexpr std::uint64_t pair_of_lane(int lane) {
  const int within = lane % kPer;
  return static_cast<std::uint64_t>(lane - within + within / 2 + within % 2 * (kPer / 2));
}

/// Stores pairs in order: the two halves of each side by side.
PHYSIM_INLINE void store_pairs(const Numbers& even, const Numbers& odd, double* to) {
#ifdef PHYSIM_HAS_SHUFFLE
  for (int i = 0; i < Numbers::kRegisters; ++i) {
    Pack<double, kPer> half;
    half.r[0] = shuffled<[](int j) { return j % 2 == 0 ? j : kPer + j - 1; }, kPer>(even.r[i], odd.r[i]);
    half.store(to + 2 * i * kPer);
    half.r[0] = shuffled<[](int j) { return j % 2 == 0 ? j + 1 : kPer + j; }, kPer>(even.r[i], odd.r[i]);
    half.store(to + (2 * i + 1) * kPer);
  }
#else
  for (int lane = 0; lane < kLanesDrawn; ++lane) {
    double* pair = to + 2 * pair_of_lane(lane);
    pair[0] = even[lane], pair[1] = odd[lane];
  }
#endif
}
}  // namespace

void draw_units(const UnitsJob& job) {
  PHYSIM_ASSERT(job.pairs == 0 || job.numbers != nullptr);
  std::uint64_t place[kMany];
  for (int lane = 0; lane < kLanesDrawn; ++lane) place[lane] = pair_of_lane(lane);
  const Words lanes = Words::load(place);
  const std::uint32_t key[2] = {static_cast<std::uint32_t>(job.seed), static_cast<std::uint32_t>(job.seed >> 32)};
  for (std::size_t i = 0; i < job.pairs; i += kMany) {
    const Words pair = Words(job.first_pair + i) + lanes;
    Words words[4] = {pair & Words(kPhiloxWord), pair >> 32, Words(job.dimension_and_stream), Words(job.replicate)};
    philox_lanes(words, key);
    const Numbers even = units_of(words[0] | (words[1] << 32)), odd = units_of(words[2] | (words[3] << 32));
    double* to = job.numbers + 2 * i;
    if (job.pairs - i >= kMany) {
      store_pairs(even, odd, to);
      continue;
    }
    double all[2 * kMany];
    store_pairs(even, odd, all);
    for (std::size_t k = 0; k < 2 * (job.pairs - i); ++k) to[k] = all[k];
  }
}

namespace {
/// Numbers of the tails, one behind the other, and where they stand.
struct Tails {
  static constexpr std::size_t kBlock = 1024;  // few enough for the fastest cache
  static_assert(kBlock % kMany == 0);
  double number[kBlock + kMany];  // whole registers are written
  std::uint64_t place[kBlock + kMany];
  std::size_t count = 0;

  PHYSIM_INLINE void add(double p, std::uint64_t at) {
    place[count] = at;
    number[count] = p;
    count += is_in_tail(p) ? 1 : 0;
  }
  PHYSIM_INLINE void add(const Numbers& p, std::uint64_t first) {
#if defined(__AVX512F__)
    const Numbers from_middle = abs(p - Numbers(0.5));
    const __m512i in_order = _mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0);
    for (int i = 0; i < Numbers::kRegisters; ++i) {
      const __mmask8 tail = _mm512_cmp_pd_mask((__m512d)from_middle.r[i], _mm512_set1_pd(kTailFromMiddle), _CMP_GT_OQ);
      const __m512i at = _mm512_add_epi64(in_order, _mm512_set1_epi64(static_cast<long long>(first) + i * kPer));
      _mm512_storeu_pd(number + count, _mm512_maskz_compress_pd(tail, (__m512d)p.r[i]));
      _mm512_storeu_si512(place + count, _mm512_maskz_compress_epi64(tail, at));
      count += static_cast<std::size_t>(__builtin_popcount(tail));
    }
#else
    for (int lane = 0; lane < kLanesDrawn; ++lane) add(p[lane], first + static_cast<std::uint64_t>(lane));
#endif
  }
};

/// Fewer numbers than a pack, filled up with what means nothing.
template <class F>
PHYSIM_INLINE void put_rest(double* numbers, std::size_t count, const F& of) {
  PHYSIM_ASSERT(count < kMany);
  if (count == 0) return;
  double rest[kMany];
  for (std::size_t lane = 0; lane < kMany; ++lane) rest[lane] = lane < count ? numbers[lane] : 0.5;
  of(Numbers::load(rest)).store(rest);
  for (std::size_t lane = 0; lane < count; ++lane) numbers[lane] = rest[lane];
}

/// One number of seven lies in a tail, which takes four times as long: they are gathered first.
void put_normals(double* numbers, std::size_t count, const NormalScale& scale) {
  PHYSIM_ASSERT(count <= Tails::kBlock);
  const Numbers mean(scale.mean), deviation(scale.deviation);
  const auto middle = [&](const Numbers& p)
                          PHYSIM_INLINE_LAMBDA { return mean + deviation * normal_quantile_of_middle(p); };
  const auto tail = [&](const Numbers& p)
                        PHYSIM_INLINE_LAMBDA { return mean + deviation * normal_quantile_of_tail(p); };
  Tails tails;
  std::size_t i = 0;
  for (; i + kMany <= count; i += kMany) {
    const Numbers p = Numbers::load(numbers + i);
    tails.add(p, i);
    middle(p).store(numbers + i);
  }
  for (std::size_t rest = i; rest < count; ++rest) tails.add(numbers[rest], rest);
  put_rest(numbers + i, count - i, middle);
  for (i = 0; i + kMany <= tails.count; i += kMany) tail(Numbers::load(tails.number + i)).store(tails.number + i);
  put_rest(tails.number + i, tails.count - i, tail);
  for (i = 0; i < tails.count; ++i) numbers[tails.place[i]] = tails.number[i];
}
}  // namespace

void draw_normals(double* numbers, std::size_t count, const NormalScale& scale) {
  for (std::size_t i = 0; i < count; i += Tails::kBlock)
    put_normals(numbers + i, count - i < Tails::kBlock ? count - i : Tails::kBlock, scale);
}

PHYSIM_ISA_END
