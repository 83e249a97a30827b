// Studies in the golden hash: what their shards hold to the bit, drawn in each way, for every kernel and several
// numbers of threads.
#include <optional>
#include <span>
#include <vector>

#include "alike.hpp"
#include "base/hash.hpp"
#include "physim/body.hpp"
#include "physim/result.hpp"
#include "physim/study.hpp"
#include "scenes.hpp"

namespace physim::test {
namespace {

/// A rifle's shots at a target, in wind and weather that are not known.
Study rifle(Sampling sampling) {
  Study study;
  study.projectile = presets::rifle_bullet().projectile;
  study.launch = {.speed = 790, .elevation = 0.003};
  study.fidelity = Fidelity::small_arms();
  study.until = {.ground = std::nullopt, .range = 500};
  study.sampling = sampling;
  study.inputs = {{.path = "shot.speed", .distribution = NormalDistribution{790, 3}},
                  {.path = "environment.wind.velocity.z", .distribution = UniformDistribution{-2, 2}},
                  {.path = "environment.atmosphere.temperature", .distribution = TriangularDistribution{280, 288, 300}},
                  {.path = "shot.elevation", .distribution = NormalDistribution{0.003, 0.0002}}};
  study.correlated = {{.inputs = {0, 3}, .matrix = {1, 0.3, 0.3, 1}}};
  study.targets = {{"plate", RectangleTarget{.width = 0.5, .height = 0.5}}, {"circle", CircleTarget{.radius = 0.3}}};
  study.indices = sampling == Sampling::random;
  if (sampling == Sampling::latin_hypercube) study.at = {{.event = {.kind = EventKind::range, .value = 250}}};
  study.shard_shots = 256;
  study.shots = 2048;
  return study;
}

/// What a saved part holds of its shards, without its head, which names the version, and without its check sum.
std::span<const std::byte> sums_in(const std::vector<std::byte>& bytes) {
  const std::string what = "physim study part", version = kVersion;
  const std::size_t head = 4 + what.size() + 4 + 4 + version.size() + 8;  // texts with their lengths, format, hash
  return std::span(bytes).subspan(head, bytes.size() - head - 8);
}

std::uint64_t fly(unsigned threads) {
  Hash hash;
  const auto pool = make_thread_pool(threads);
  for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
    const auto plan = plan_study(rifle(sampling));
    if (!plan) return std::fprintf(stderr, "golden: %s\n", plan.error().text().c_str()), 0;
    const auto part = run_shards(*plan, 0, plan->shards(), pool.get());
    if (!part) return 0;
    hash.add(sums_in(save_part(*part)));
    const auto result = result_of(*plan, *part, plan->shards());
    if (!result) return 0;
    for (const QuantityResult& q : result->quantities) hash.add(q.mean.value, q.mean.error), hash.add(q.deviation);
    for (const HitResult& hit : result->hits) hash.add(hit.low, hit.high);
    hash.add(result->from_aim->mean.value, result->from_aim->mean.error);
  }
  return hash.value();
}

}  // namespace

bool add_studies(std::uint64_t& hash) {
  hash = fly(1);
  if (hash == 0) std::fprintf(stderr, "golden: a study is refused\n");
  const bool same = gives_alike("studies", hash, {1u, 3u}, fly);
  return same && hash != 0;
}

}  // namespace physim::test
