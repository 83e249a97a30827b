// Random batches, and what makes two of their results the same.
#pragma once

#include "random_shots.hpp"
#include "support.hpp"

namespace physim::test {

inline bool same_event(const Event& a, const Event& b) {
  return a.kind == b.kind && same_bits(a.value, b.value) && a.direction == b.direction && same_bits(a.time, b.time) &&
         same_bits(a.position, b.position) && same_bits(a.velocity, b.velocity);
}

/// One environment, rungs and ends for a number of random shots.
struct RandomBatch {
  Environment environment;
  Fidelity fidelity;
  Until until;
  Tolerance tolerance;
  std::vector<Shot> shots;
};

inline RandomBatch random_batch(std::uint64_t seed, Integrator integrator, Precision precision, int shots) {
  Random r(seed);
  RandomBatch c{random_environment(r), random_fidelity(r), random_until(r), {}, {}};
  c.fidelity.integrator = integrator;
  c.fidelity.precision = precision;
  const double relative = precision == Precision::float32 ? 1e-5 : 1e-8;
  // A falling body with bands of ballistic coefficients may hang at an edge: stop it soon.
  c.tolerance = {.relative = relative, .absolute = relative, .step = r.in(0.004, 0.05), .max_steps = 5000};
  if (integrator == Integrator::classic && r.one_in(2)) c.tolerance.step = 0;
  if (r.one_in(5)) c.tolerance.max_steps = 20;
  c.shots = random_shots(r, shots);
  return c;
}

inline void expect_same(const BatchResult& one, const BatchResult& other, const std::string& what) {
  ASSERT_EQ(one.shots.size(), other.shots.size()) << what;
  ASSERT_EQ(one.events.size(), other.events.size()) << what;
  EXPECT_EQ(one.error ? one.error->text() : "", other.error ? other.error->text() : "") << what;
  EXPECT_EQ(one.fidelity_in_use.fidelity, other.fidelity_in_use.fidelity) << what;
  for (std::size_t i = 0; i < one.shots.size(); ++i) {
    const ShotResult &a = one.shots[i], &b = other.shots[i];
    EXPECT_EQ(a.outcome, b.outcome) << what << ' ' << i;
    EXPECT_EQ(a.cost.steps, b.cost.steps) << what << ' ' << i;
    EXPECT_EQ(a.cost.rejected, b.cost.rejected) << what << ' ' << i;
    EXPECT_EQ(a.cost.evaluations, b.cost.evaluations) << what << ' ' << i;
    EXPECT_TRUE(same_bits(a.time, b.time) && same_bits(a.position, b.position) && same_bits(a.velocity, b.velocity))
        << what << ' ' << i;
  }
  ASSERT_EQ(one.attitudes.size(), other.attitudes.size()) << what;
  for (std::size_t i = 0; i < one.attitudes.size(); ++i) {
    const ShotAttitude &a = one.attitudes[i], &b = other.attitudes[i];
    EXPECT_EQ(a.orientation, b.orientation) << what << ' ' << i;
    EXPECT_TRUE(same_bits(a.angular_velocity, b.angular_velocity)) << what << ' ' << i;
  }
  for (std::size_t i = 0; i < one.events.size(); ++i) {
    EXPECT_EQ(one.events[i].shot, other.events[i].shot) << what;
    EXPECT_TRUE(same_event(one.events[i].event, other.events[i].event)) << what << ' ' << i;
  }
}

}  // namespace physim::test
