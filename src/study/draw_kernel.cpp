// Compiled once per instruction set, in a namespace of its name. Two registers side by side hide each other's waiting.
#include "math/normal_quantile.hpp"
#include "math/philox_lanes.hpp"
#include "study/draw_job.hpp"

PHYSIM_ISA_BEGIN

namespace {
constexpr int kLanesDrawn = 2 * kNativeBytes / 8;
using Numbers = Pack<double, kLanesDrawn>;
using Words = Pack<std::uint64_t, kLanesDrawn>;

/// The middle of the cell of (0, 1) that the upper 52 of 64 bits name: their digits become those of a number from 2^52
/// on.
PHYSIM_INLINE Numbers units_of(const Words& bits) {
  constexpr double kFirst = 0x1p52;
  const Numbers digits = from_bits<Numbers>((bits >> 12) | to_bits(Numbers(kFirst))) - Numbers(kFirst);
  return (digits + Numbers(0.5)) * Numbers(0x1p-52);
}
}  // namespace

void draw_units(const UnitsJob& job) {
  PHYSIM_ASSERT(job.pairs == 0 || job.numbers != nullptr);
  constexpr auto kPairs = static_cast<std::size_t>(kLanesDrawn);
  std::uint64_t place[kPairs];
  for (std::size_t lane = 0; lane < kPairs; ++lane) place[lane] = lane;
  const Words lanes = Words::load(place);
  const std::uint32_t key[2] = {static_cast<std::uint32_t>(job.seed), static_cast<std::uint32_t>(job.seed >> 32)};
  for (std::size_t i = 0; i < job.pairs; i += kPairs) {
    const Words pair = Words(job.first_pair + i) + lanes;
    Words words[4] = {pair & Words(kPhiloxWord), pair >> 32, Words(job.dimension_and_stream), Words(job.replicate)};
    philox_lanes(words, key);
    double even[kPairs], odd[kPairs];
    units_of(words[0] | (words[1] << 32)).store(even);
    units_of(words[2] | (words[3] << 32)).store(odd);
    const std::size_t left = job.pairs - i, count = left < kPairs ? left : kPairs;
    double* to = job.numbers + 2 * i;
    for (std::size_t lane = 0; lane < count; ++lane) to[2 * lane] = even[lane], to[2 * lane + 1] = odd[lane];
  }
}

namespace {
constexpr auto kMany = static_cast<std::size_t>(kLanesDrawn);
constexpr std::size_t kBlock = 16 * kMany;

/// A pack at a time; the last one may be filled up.
template <class Quantile>
PHYSIM_INLINE void each_pack(const double* from, double* to, std::size_t count, const Quantile& quantile) {
  std::size_t i = 0;
  for (; i + kMany <= count; i += kMany) quantile(Numbers::load(from + i)).store(to + i);
  if (i == count) return;
  double rest[kMany];
  for (std::size_t lane = 0; lane < kMany; ++lane) rest[lane] = i + lane < count ? from[i + lane] : 0.5;
  quantile(Numbers::load(rest)).store(rest);
  for (std::size_t lane = 0; i + lane < count; ++lane) to[i + lane] = rest[lane];
}

/// One number of seven lies in a tail, which takes four times as long: they are gathered first.
void put_quantiles(double* numbers, std::size_t count) {
  PHYSIM_ASSERT(count <= kBlock);
  double tail[kBlock];
  std::uint32_t place[kBlock];
  std::size_t tails = 0;
  for (std::size_t i = 0; i < count; ++i) {
    place[tails] = static_cast<std::uint32_t>(i);
    tail[tails] = numbers[i];
    tails += is_in_tail(numbers[i]) ? 1 : 0;
  }
  each_pack(numbers, numbers, count,
            [](const Numbers& p) PHYSIM_INLINE_LAMBDA { return normal_quantile_of_middle(p); });
  each_pack(tail, tail, tails, [](const Numbers& p) PHYSIM_INLINE_LAMBDA { return normal_quantile_of_tail(p); });
  for (std::size_t i = 0; i < tails; ++i) numbers[place[i]] = tail[i];
}
}  // namespace

void normal_quantiles_of(double* numbers, std::size_t count) {
  for (std::size_t i = 0; i < count; i += kBlock) put_quantiles(numbers + i, count - i < kBlock ? count - i : kBlock);
}

PHYSIM_ISA_END
