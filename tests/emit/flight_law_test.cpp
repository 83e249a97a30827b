// What acts on the flight of particles: each number by age, speed and chance.
#include "emit/flight_law.hpp"

#include <functional>

#include "math/vec3.hpp"
#include "random_emitters.hpp"
#include "support.hpp"

namespace physim::emit_flight_law_test {

const Curve kFalling{{0, 1}, {1, 0}};

/// Halfway through the life of a particle of 4 s.
Vec3d acceleration(const ParticleFlight& def, const FlightState& s = {.x = {1, 2, 3}, .v = {3, 0, -4}},
                   std::uint64_t number = 0, double time = 12) {
  return FlightLaw(def, 5).acceleration({number, 10, 4}, time, s);
}

TEST(FlightLaw, does_nothing_by_itself) {
  EXPECT_FALSE(FlightLaw({}, 1).acts());
  EXPECT_EQ(acceleration({}), Vec3d{});
}

TEST(FlightLaw, acts_where_there_is_one_of_its_numbers) {
  const std::function<void(ParticleFlight&)> rows[] = {
      [](ParticleFlight& f) { f.drag = {1}; },       [](ParticleFlight& f) { f.gravity = {0}; },
      [](ParticleFlight& f) { f.velocity_x = {1}; }, [](ParticleFlight& f) { f.velocity_y = {1}; },
      [](ParticleFlight& f) { f.velocity_z = {1}; }, [](ParticleFlight& f) { f.force_x = {1}; },
      [](ParticleFlight& f) { f.force_y = {1}; },    [](ParticleFlight& f) { f.force_z = {1}; },
      [](ParticleFlight& f) { f.limit = {1}; },      [](ParticleFlight& f) { f.noise = {1}; }};
  for (const auto& row : rows) {
    ParticleFlight def;
    row(def);
    EXPECT_TRUE(FlightLaw(def, 1).acts()) << &row - rows;
  }
}

TEST(FlightLaw, drag_is_linear_and_follows_age_and_speed) {
  EXPECT_EQ(acceleration({.drag = {2}}), (Vec3d{-6, 0, 8}));
  EXPECT_EQ(acceleration({.drag = {2, {}, kFalling}}), (Vec3d{-3, 0, 4}));
  const ParticleFlight square{.drag = {2}, .fast = 10, .drag_by_speed = {{0, 0}, {1, 1}}};
  EXPECT_EQ(acceleration(square), (Vec3d{-3, 0, 4})) << "half of fast";
  EXPECT_EQ(acceleration(square, {.x = {}, .v = {200, 0, 0}}), (Vec3d{-400, 0, 0})) << "held above fast";
}

TEST(FlightLaw, gravity_and_force_are_by_age) {
  const FlightState s{.x = {}, .v = {}, .gravity = {0, -10, 0}, .mass = 0.5};
  EXPECT_EQ(acceleration({.gravity = {3, {}, kFalling}}, s), (Vec3d{0, -5, 0})) << "what is there already is not added";
  EXPECT_EQ(acceleration({.force_x = {1}, .force_y = {2, {}, kFalling}, .force_z = {-1}}, s), (Vec3d{2, 2, -2}));
}

TEST(FlightLaw, a_limit_slows_down_what_is_above_it) {
  EXPECT_EQ(acceleration({.limit = {4}, .limit_rate = 2}), (Vec3d{3, 0, -4} * -(2 * (1 - 0.8))));
  EXPECT_EQ(acceleration({.limit = {5}, .limit_rate = 2}), Vec3d{});
  EXPECT_EQ(acceleration({.limit = {0}, .limit_rate = 2}, {.x = {}, .v = {}}), Vec3d{});
}

TEST(FlightLaw, noise_follows_place_time_age_and_the_seed_of_its_emitter) {
  const ParticleFlight def{.noise = {3, {}, kFalling}, .noise_rate = 0.1};
  const FlightState s{.x = {0.3, 0.4, 0.6}, .v = {}};
  EXPECT_EQ(acceleration(def, s), acceleration(def, s, 99)) << "one field for all";
  EXPECT_NE(acceleration(def, s), FlightLaw(def, 6).acceleration({0, 10, 4}, 12, s));
  EXPECT_NE(acceleration(def, s), (FlightLaw(def, 5).acceleration({0, 10.5, 4}, 12.5, s))) << "it changes with time";
  EXPECT_EQ(acceleration({.noise = {3}}, s) * 0.5, acceleration({.noise = {3, {}, kFalling}}, s));
}

TEST(FlightLaw, numbers_between_two_are_drawn_once_for_each_particle) {
  const ParticleFlight def{.drag = {1, 3}, .force_x = {-1, 1}};
  double sum = 0, product = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const FlightState s{.x = {}, .v = {0, 0, 1}};
    const Vec3d a = acceleration(def, s, i);
    ASSERT_EQ(a, acceleration(def, s, i, 13.5)) << "at any age";
    ASSERT_TRUE(a.z <= -1 && a.z >= -3 && std::abs(a.x) <= 1);
    sum += a.z / 20'000, product += (a.z + 2) * a.x / 20'000;
  }
  EXPECT_NEAR(sum, -2, 0.02);
  EXPECT_NEAR(product, 0, 0.012) << "each for itself";
}

TEST(FlightLaw, ages_end_where_lives_do) {
  const ParticleFlight def{.drag = {1, {}, {{0, 1}, {1, 3}}}};
  const FlightState s{.x = {}, .v = {1, 0, 0}};
  EXPECT_EQ(acceleration(def, s, 0, 9.9).x, -1);
  EXPECT_EQ(acceleration(def, s, 0, 14).x, -3);
  EXPECT_EQ(acceleration(def, s, 0, 1e9).x, -3);
}

TEST(FlightLaw, the_rate_of_a_velocity_is_its_derivative) {
  const ParticleFlight def{.velocity_x = {5, {}, {{0.1, 0}, {0.4, 1}, {0.9, -1}}},
                           .velocity_y = {2, 4, {{0, 1}, {1, 0}}},
                           .velocity_z = {3}};
  const FlightLaw law(def, 8);
  const InFlight particle{7, 10, 4};
  const double h = 1e-6;
  for (double t = 10.001; t < 14; t += 0.173) {
    const Vec3d slope = (law.added_velocity(particle, t + h) - law.added_velocity(particle, t - h)) * (0.5 / h);
    EXPECT_LT(length(slope - law.velocity_rate(particle, t)), 1e-7) << t;
  }
  EXPECT_EQ(law.velocity_rate(particle, 20), Vec3d{});
}

TEST(FlightLaw, rates_of_drag_by_age_are_those_that_slow_down) {
  constexpr std::size_t kPack = FlightLaw::kPack;
  test::Random r(8);
  for (int round = 0; round < 30; ++round) {
    ParticleFlight def{.drag = test::random_number(r, 0.1, 3)};
    const FlightLaw law(def, 9);
    ASSERT_TRUE(law.is_drag_by_age());
    std::array<std::uint64_t, kPack> number;
    std::array<double, kPack> birth, span, rate;
    for (std::size_t i = 0; i < kPack; ++i)
      number[i] = 7 * i, birth[i] = r.in(9, 13), span[i] = r.in(0.1, 4);  // some are not born, some are dead
    law.drag_rates(particle_kernel(), number.data(), birth.data(), span.data(), 12, rate.data());
    for (std::size_t i = 0; i < kPack; ++i) {
      const Vec3d a = law.acceleration({number[i], birth[i], span[i]}, 12, {.v = {1, -2, 4}});
      EXPECT_EQ(a, (Vec3d{-rate[i], 2 * rate[i], -4 * rate[i]})) << i;
    }
  }
}

TEST(FlightLaw, whatever_acts_beside_drag_by_age_is_told) {
  const auto alone = [](const auto& change) {
    ParticleFlight def{.drag = {1}};
    change(def);
    return FlightLaw(def, 1).is_drag_by_age();
  };
  EXPECT_TRUE(alone([](ParticleFlight&) {}));
  EXPECT_FALSE(alone([](ParticleFlight& f) { f.drag = {0}; }));
  EXPECT_FALSE(alone([](ParticleFlight& f) { f.fast = 30, f.drag_by_speed = {{0, 0.5}, {1, 2}}; }));
  EXPECT_FALSE(alone([](ParticleFlight& f) { f.gravity = {0.5}; }));
  EXPECT_FALSE(alone([](ParticleFlight& f) { f.limit = {9}; }));
  EXPECT_FALSE(alone([](ParticleFlight& f) { f.noise = {1}; }));
  EXPECT_FALSE(alone([](ParticleFlight& f) { f.velocity_y = {1}; }));
  EXPECT_FALSE(alone([](ParticleFlight& f) { f.force_z = {1e-3}; }));
}

TEST(FlightLaw, tells_the_rate_of_its_drag) {
  const auto rate = [](const ParticleFlight& def) {
    double of = -1;
    (void)FlightLaw(def, 5).acceleration({0, 10, 4}, 12, {.x = {}, .v = {3, 0, -4}}, &of);
    return of;
  };
  EXPECT_EQ(rate({.gravity = {3}}), 0);
  EXPECT_EQ(rate({.drag = {2, {}, kFalling}}), 1);
  EXPECT_EQ(rate({.drag = {2}, .limit = {4}, .limit_rate = 10}), 2 + 10 * (1 - 4.0 / 5));
}

TEST(FlightLaw, of_a_pack_is_that_of_each) {
  constexpr std::size_t kPack = FlightLaw::kPack;
  test::Random r(3);
  for (int round = 0; round < 50; ++round) {
    const FlightLaw law(test::random_flight(r), 9);
    FlightPack<kPack> pack;
    for (std::size_t i = 0; i < kPack; ++i) {
      pack.number[i] = (std::uint64_t{1} << 33) * static_cast<std::uint64_t>(r.below(3)) + i;
      pack.birth[i] = r.in(9, 11), pack.span[i] = r.in(0.1, 4), pack.mass[i] = r.in(0.01, 2);
      for (std::size_t axis = 0; axis < 3; ++axis)
        pack.x[axis][i] = r.in(-9, 9), pack.v[axis][i] = r.in(-30, 30), pack.gravity[axis][i] = r.in(-9, 9);
    }
    FlightPack<kPack>::Vectors a;
    pack.time.fill(12);
    FlightPack<kPack>::Column drag_rate;
    law.accelerations(pack, a, drag_rate);
    for (std::size_t i = 0; i < kPack; ++i) {
      const auto vector = [i](const FlightPack<kPack>::Vectors& of) { return Vec3d{of[0][i], of[1][i], of[2][i]}; };
      const FlightState alone{vector(pack.x), vector(pack.v), vector(pack.gravity), pack.mass[i]};
      double rate = -1;
      EXPECT_EQ(vector(a), law.acceleration({pack.number[i], pack.birth[i], pack.span[i]}, 12, alone, &rate)) << i;
      EXPECT_EQ(drag_rate[i], rate) << i;
    }
  }
}

}  // namespace physim::emit_flight_law_test
