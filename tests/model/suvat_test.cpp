// Motion under constant acceleration, asked any way round.
#include <random>

#include "support.hpp"

namespace physim::model_suvat_test {

using test::near;

constexpr std::optional<double> SuvatGiven::*kGiven[] = {&SuvatGiven::s, &SuvatGiven::u, &SuvatGiven::v, &SuvatGiven::a,
                                                         &SuvatGiven::t};
constexpr double Suvat::*kFound[] = {&Suvat::s, &Suvat::u, &Suvat::v, &Suvat::a, &Suvat::t};

bool has_part(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Every triple of three of five, as their indices.
std::vector<std::array<std::size_t, 3>> triples() {
  std::vector<std::array<std::size_t, 3>> all;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j)
      for (std::size_t k = j + 1; k < 5; ++k) all.push_back({i, j, k});
  return all;
}

SuvatGiven part_of(const Suvat& motion, const std::array<std::size_t, 3>& triple) {
  SuvatGiven given;
  for (const std::size_t i : triple) given.*kGiven[i] = motion.*kFound[i];
  return given;
}

bool is_same(const Suvat& a, const Suvat& b, double tolerance) {
  return std::ranges::all_of(kFound, [&](double Suvat::*q) { return near(a.*q, b.*q, tolerance, tolerance); });
}

void expect_motion(const Suvat& m) {
  const double size = std::abs(m.u) + std::abs(m.v) + std::abs(m.a * m.t);
  EXPECT_TRUE(near(m.v, m.u + m.a * m.t, 0, 1e-12 * size));
  EXPECT_TRUE(near(m.s, m.u * m.t + m.a * m.t * m.t / 2, 0, 1e-12 * size * std::abs(m.t)));
  EXPECT_TRUE(near(m.s, (m.u + m.v) / 2 * m.t, 0, 1e-12 * size * std::abs(m.t)));
}

TEST(Suvat, every_triple_of_a_motion_gives_it_back) {
  std::mt19937_64 random(52);
  std::uniform_real_distribution<double> uniform(-30, 30);
  ASSERT_EQ(triples().size(), 10U);
  int tried = 0;
  while (tried < 500) {
    Suvat m{.u = uniform(random), .a = uniform(random), .t = uniform(random)};
    m.v = m.u + m.a * m.t;
    m.s = m.u * m.t + m.a * m.t * m.t / 2;
    const double least = std::ranges::min({std::abs(m.s), std::abs(m.u), std::abs(m.v), std::abs(m.a), std::abs(m.t),
                                           std::abs(m.u + m.v), std::abs(m.u - m.v)});
    if (least < 0.1) continue;  // what is next to a turning point is looked at below
    ++tried;
    for (const auto& triple : triples()) {
      const auto found = must(suvat(part_of(m, triple)));
      const bool is_two =
          triple == std::array<std::size_t, 3>{0, 1, 3} || triple == std::array<std::size_t, 3>{0, 2, 3};
      EXPECT_EQ(found.size(), is_two ? 2U : 1U);
      EXPECT_TRUE(std::ranges::any_of(found, [&](const Suvat& each) { return is_same(each, m, 1e-8); }));
      for (const Suvat& each : found) {
        expect_motion(each);
        for (const std::size_t i : triple) EXPECT_EQ(each.*kFound[i], m.*kFound[i]) << "what was given stays";
      }
      EXPECT_TRUE(std::ranges::is_sorted(found, {}, &Suvat::t));
    }
  }
}

TEST(Suvat, a_ball_passes_a_height_twice_as_a_flight_does) {
  const auto both = must(suvat({.s = 20, .u = 30, .a = -9.81}));
  ASSERT_EQ(both.size(), 2U);
  ProjectileDef ball;
  Environment vacuum{.gravity = {.model = GravityModel::constant, .acceleration = 9.81}};
  vacuum.atmosphere.model = AirModel::vacuum;
  Fidelity fidelity = Fidelity::simulation();
  fidelity.gravity = GravityModel::constant;
  fidelity.earth = EarthModel::flat;
  const Flight flight = fly(ball, {.velocity = Vec3d{0, 30, 0}}, vacuum, fidelity, {}, {.ground = -1.0});
  for (const Suvat& pass : both) {
    EXPECT_TRUE(near(flight.at(pass.t).position.y, 20, 0, 1e-9));
    EXPECT_TRUE(near(flight.at(pass.t).velocity.y, pass.v, 0, 1e-9));
  }
}

TEST(Suvat, a_turning_point_is_one_motion) {
  const auto apex = must(suvat({.s = 30 * 30 / (2 * 9.81), .u = 30, .a = -9.81}));
  ASSERT_EQ(apex.size(), 1U);
  EXPECT_EQ(apex.front().v, 0);
  EXPECT_TRUE(near(apex.front().t, 30 / 9.81, 1e-15));
  const auto stop = must(suvat({.s = 50, .v = 0, .a = -4}));
  ASSERT_EQ(stop.size(), 2U) << "a car that brakes to a stop, and one that rolls back from there with time";
  EXPECT_EQ(stop.back().u, 20);
  EXPECT_EQ(stop.back().t, 5);
}

TEST(Suvat, a_short_way_does_not_cancel) {
  const auto found = must(suvat({.s = 1e-9, .u = 1e4, .a = 1}));
  EXPECT_TRUE(near(found.back().t, 1e-13, 1e-12));
}

TEST(Suvat, zero_has_no_sign) {
  const auto back = must(suvat({.s = -10, .u = 5, .v = 5}));
  EXPECT_EQ(back.front().a, 0);
  EXPECT_FALSE(std::signbit(back.front().a));
  EXPECT_EQ(back.front().t, -2);
}

TEST(Suvat, says_where_no_motion_is) {
  const struct {
    SuvatGiven given;
    const char* hint;
  } cases[] = {{{.s = 46, .u = 30, .a = -9.81}, "s must be at most 45.8716 m"},
               {{.s = -46, .u = 30, .a = 9.81}, "s must be at least -45.8716 m"},
               {{.s = 46, .v = 30, .a = 9.81}, "s must be at most 45.8716 m"},
               {{.s = -46, .v = 30, .a = -9.81}, "s must be at least -45.8716 m"},
               {{.s = 1, .u = 0, .a = -9.81}, "s must be at most 0 m"},
               {{.s = -1, .u = 0, .a = 9.81}, "s must be at least 0 m"},
               {{.s = 1, .v = 0, .a = 9.81}, "s must be at most 0 m"},
               {{.s = -1, .v = 0, .a = -9.81}, "s must be at least 0 m"},
               {{.s = 1, .u = 0, .a = 0}, "s must be 0"},
               {{.s = 1, .v = 0, .a = 0}, "s must be 0"},
               {{.u = 1, .v = 2, .a = 0}, "a must not be 0"},
               {{.u = 1, .v = 2, .t = 0}, "v must be u, or t not 0"},
               {{.s = 1, .u = 1, .t = 0}, "s must be 0, or t not 0"},
               {{.s = 1, .v = 1, .t = 0}, "s must be 0, or t not 0"},
               {{.s = 1, .a = 1, .t = 0}, "s must be 0, or t not 0"},
               {{.s = 5, .u = 3, .v = -3}, "s must be 0, or v not -u"},
               {{.s = 0, .u = 3, .v = 2}, "s must not be 0, or v be of the size of u"}};
  for (const auto& [given, hint] : cases) {
    const auto found = suvat(given);
    ASSERT_FALSE(found) << hint;
    EXPECT_TRUE(has_part(found.error().message, "no motion has these: ")) << found.error().text();
    EXPECT_EQ(found.error().hint, hint);
  }
}

TEST(Suvat, says_where_any_motion_is) {
  const struct {
    SuvatGiven given;
    const char* hint;
  } cases[] = {
      {{.u = 3, .v = 3, .a = 0}, "give s or t instead of v"},  {{.u = 3, .v = 3, .t = 0}, "give a instead of t"},
      {{.s = 0, .u = 3, .t = 0}, "give a instead of t"},       {{.s = 0, .v = 3, .t = 0}, "give a instead of t"},
      {{.s = 0, .a = 3, .t = 0}, "give u instead of s"},       {{.s = 0, .u = 0, .a = 0}, "give t instead of s"},
      {{.s = 0, .v = 0, .a = 0}, "give t instead of s"},       {{.s = 0, .u = 3, .v = 3}, "give a or t instead of s"},
      {{.s = 0, .u = 3, .v = -3}, "give a or t instead of s"}, {{.s = 0, .u = 0, .v = 0}, "give a or t instead of s"}};
  for (const auto& [given, hint] : cases) {
    const auto found = suvat(given);
    ASSERT_FALSE(found) << hint;
    EXPECT_TRUE(has_part(found.error().message, "any number of motions has these: ")) << found.error().text();
    EXPECT_EQ(found.error().hint, hint);
  }
}

TEST(Suvat, what_follows_though_a_quantity_is_zero) {
  const struct {
    SuvatGiven given;
    Suvat motion;
  } cases[] = {{{.s = 6, .u = 3, .a = 0}, {6, 3, 3, 0, 2}},    {{.s = 6, .v = 3, .a = 0}, {6, 3, 3, 0, 2}},
               {{.u = 3, .a = 2, .t = 0}, {0, 3, 3, 2, 0}},    {{.v = 3, .a = 2, .t = 0}, {0, 3, 3, 2, 0}},
               {{.s = 0, .u = 0, .a = 2}, {0, 0, 0, 2, 0}},    {{.s = 0, .a = 2, .t = 3}, {0, -3, 3, 2, 3}},
               {{.u = 0, .v = 0, .a = 2}, {0, 0, 0, 2, 0}},    {{.s = 0, .u = 0, .t = 3}, {0, 0, 0, 0, 3}},
               {{.u = 4, .v = -4, .t = 2}, {0, 4, -4, -4, 2}}, {{.s = 8, .u = 0, .v = 4}, {8, 0, 4, 1, 4}}};
  for (const auto& [given, motion] : cases) {
    const auto found = must(suvat(given));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(is_same(found.front(), motion, 1e-15));
  }
}

TEST(Suvat, wants_three_numbers) {
  EXPECT_EQ(suvat({}).error().message, "nothing is given");
  EXPECT_EQ(suvat({.s = 1}).error().message, "1 is given: s");
  EXPECT_EQ(suvat({.s = 1, .t = 1}).error().message, "2 are given: s, t");
  EXPECT_EQ(suvat({.s = 1, .u = 1, .v = 1, .a = 1, .t = 1}).error().message, "5 are given: s, u, v, a, t");
  for (const double bad : {test::kNan, test::kInfinity, -test::kInfinity, 1e51, -1e-51})
    EXPECT_EQ(suvat({.u = 1, .a = bad, .t = 1}).error().place, "suvat.a") << bad;
}

}  // namespace physim::model_suvat_test
