// Flights by steps of known rungs are those by the steps of all rungs, to the bit, by every kernel.
#include "flight/known_step.hpp"

#include "plain_bullet.hpp"
#include "support.hpp"

namespace physim::test {
namespace flight_known_step_test {

class KnownStepTest : public testing::TestWithParam<std::string> {
 protected:
  KnownStepTest() { EXPECT_TRUE(use_kernel(GetParam())); }
  ~KnownStepTest() override { use_kernel(""); }
};
INSTANTIATE_TEST_SUITE_P(Kernels, KnownStepTest, testing::ValuesIn(kernels()),
                         [](const auto& kernel) { return kernel.param; });

struct Rung {
  const char* name;
  GravityModel gravity;
  EarthModel earth;
  bool wind;
};
constexpr Rung kRungs[] = {{"small arms, calm", GravityModel::constant, EarthModel::flat, false},
                           {"small arms", GravityModel::constant, EarthModel::flat, true},
                           {"artillery, calm", GravityModel::inverse_square, EarthModel::flat_coriolis, false},
                           {"artillery", GravityModel::inverse_square, EarthModel::flat_coriolis, true}};

Fidelity fidelity_of(const Rung& rung, Integrator integrator = Integrator::tsit5) {
  Fidelity f;
  f.integrator = integrator;
  f.gravity = rung.gravity;
  f.earth = rung.earth;
  f.wind = rung.wind ? WindModel::constant : WindModel::off;
  f.interpolation = Interpolation::cubic;
  return f;
}

Environment windy() {
  Environment e;
  e.altitude = 300;
  e.wind.velocity = {3, 0.5, -7};
  return e;
}

void expect_same(const State<double>& a, const State<double>& b) {
  EXPECT_TRUE(same_bits(a.x, b.x));
  EXPECT_TRUE(same_bits(a.v, b.v));
}

/// A number of a state between two bounds, drawn by its place.
double drawn(int number, int place, double low, double high) {
  const double part = 0.5 + 0.5 * std::sin(12.9898 * (number * 17 + place + 1) + 78.233 * number);
  return low + part * (high - low);
}

/// A step from a drawn state; heights reach far above the first layer of the air.
Flyer<double> drawn_step(const Prepared& p, int number) {
  Flyer<double> flyer;
  flyer.body = p.body;
  Step<double>& s = flyer.step;
  s.t = drawn(number, 0, 0, 20);
  s.h = drawn(number, 1, 1e-3, 2);
  s.t_end = s.t + s.h;
  s.start.x = {drawn(number, 2, -50, 5000), drawn(number, 3, -1000, 20000), drawn(number, 4, -300, 300)};
  s.start.v = {drawn(number, 5, -100, 1200), drawn(number, 6, -500, 500), drawn(number, 7, -50, 50)};
  set_slope(p.cohort.conditions, flyer, 0);
  take_step(p.cohort.conditions, flyer, 1e-9, 1e-9);
  return flyer;
}

TEST_P(KnownStepTest, InterpolatesAsAllRungsToTheBit) {
  for (const Rung& rung : kRungs) {
    SCOPED_TRACE(rung.name);
    EXPECT_EQ(known_step(Prepared(plain_bullet(), {}, windy(), fidelity_of(rung, Integrator::rk43)).cohort.conditions)
                  .interpolate,
              nullptr)
        << "both ends are enough";
    const Prepared p(plain_bullet(), {}, windy(), fidelity_of(rung));
    const KnownStep known = known_step(p.cohort.conditions);
    ASSERT_TRUE(known);
    for (int i = 0; i < 500; ++i) {
      const Flyer<double> flyer = drawn_step(p, i);
      const Step<double>& s = flyer.step;
      State<double> coefficients[kMaxDenseCoefficients], others[kMaxDenseCoefficients];
      known.interpolate(s, coefficients);
      dense_sums(Integrator::tsit5, s, s.h, others);
      for (int k = 0; k < dense_coefficient_count(Integrator::tsit5); ++k) expect_same(coefficients[k], others[k]);

      KeptStep kept;
      keep_slopes(s, kept);
      const Node n0{s.t, s.start, s.slope[0].v}, n1{s.t_end, s.end, s.slope[end_slope(Integrator::tsit5)].v};
      interpolate_kept(kept, n0, n1, coefficients);
      for (int k = 0; k < dense_coefficient_count(Integrator::tsit5); ++k) expect_same(coefficients[k], others[k]);
    }
  }
}

/// A curve that begins above Mach 0 and ends below the speeds that are drawn.
ProjectileDef with_short_curve() {
  ProjectileDef p = plain_bullet();
  p.drag.table = DragTable::custom;
  p.drag.curve = {{0.5, 0.2}, {0.75, 0.3}, {1, 0.5}, {1.25, 0.4}, {1.5, 0.35}};
  return p;
}

/// A flight that may meet things takes the steps of all rungs, and looks at each by itself.
void expect_same_flight(const Flight& a, const Flight& b) {
  EXPECT_EQ(a.outcome(), b.outcome());
  EXPECT_TRUE(same_bits(a.duration(), b.duration()));
  EXPECT_EQ(a.cost().steps, b.cost().steps);
  EXPECT_EQ(a.cost().rejected, b.cost().rejected);
  ASSERT_EQ(a.step_times(), b.step_times());
  for (int i = 0; i <= 200; ++i) {
    const double t = a.duration() * i / 200;
    EXPECT_TRUE(same_bits(a.at(t).position, b.at(t).position));
    EXPECT_TRUE(same_bits(a.at(t).velocity, b.at(t).velocity));
  }
  ASSERT_EQ(a.events().size(), b.events().size());
  for (std::size_t i = 0; i < a.events().size(); ++i) {
    EXPECT_EQ(a.events()[i].kind, b.events()[i].kind);
    EXPECT_TRUE(same_bits(a.events()[i].time, b.events()[i].time));
    EXPECT_TRUE(same_bits(a.events()[i].position, b.events()[i].position));
  }
}

TEST_P(KnownStepTest, FliesAsWhatLooksAtEachStep) {
  Scene far;
  ASSERT_TRUE(far.add({.shape = *far.add_shape(SphereShape{1}), .transform = {.position = {0, -4000, 1e5}}}));
  struct Case {
    const char* name;
    double speed, elevation;
    Until until;
    Tolerance tolerance;
  };
  std::vector<Case> cases{{"flat", 820, 0.01, {.ground = std::nullopt, .range = 1000}, {}},
                          {"up and down", 820, 0.7, {.ground = -1}, {}},
                          {"above the first layer", 1500, 1.4, {.ground = -1}, {}},
                          {"out of steps", 820, 0.7, {.ground = -1}, {.max_steps = 23}},
                          {"out of time", 820, 0.7, {.ground = -1, .time = 3.3}, {}},
                          {"short steps", 820, 0.7, {.ground = -1}, {.max_step = 0.05}},
                          {"slow", 60, 1.5, {.ground = -1}, {}},
                          {"watched", 820, 0.5, {.ground = -1}, {}}};
  cases.back().until.events = {{EventKind::mach, 1},
                               {EventKind::speed, 200},
                               {EventKind::height, 500},
                               {EventKind::height, 500.1}};  // the last two in one step
  for (const Rung& rung : kRungs)
    for (const Integrator integrator : {Integrator::tsit5, Integrator::rk43})
      for (const Interpolation interpolation : {Interpolation::cubic, Interpolation::linear})
        for (const Case& each : cases) {
          SCOPED_TRACE(std::string(rung.name) + ", " + each.name);
          for (const ProjectileDef& p : {plain_bullet(), with_short_curve()}) {
            const Launch launch{.speed = each.speed, .elevation = each.elevation};
            Until beside = each.until;
            beside.scene = &far;
            Fidelity fidelity = fidelity_of(rung, integrator);
            fidelity.interpolation = interpolation;  // linear curves have corners
            expect_same_flight(fly(p, launch, windy(), fidelity, each.tolerance, each.until),
                               fly(p, launch, windy(), fidelity, each.tolerance, beside));
          }
        }
}

TEST_P(KnownStepTest, IsNotForWhatIsSpecial) {
  const Rung& rung = kRungs[1];
  const auto knows = [&](const auto& change) {
    Prepared p(plain_bullet(), {}, windy(), fidelity_of(rung));
    change(p.cohort.conditions);
    return static_cast<bool>(known_step(p.cohort.conditions));
  };
  EXPECT_TRUE(knows([](auto&) {}));
  EXPECT_FALSE(knows([](auto& c) { c.has_motor = true; }));
  EXPECT_FALSE(knows([](auto& c) { c.has_frozen = true; }));
  EXPECT_FALSE(knows([](auto& c) { c.has_own_air = true; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.planar = true; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.wind = WindModel::profile; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.integrator = Integrator::dop853; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.rotation = RotationModel::magnus; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.rotation = RotationModel::rigid_body; }));
  EXPECT_FALSE(knows([](auto& c) { c.fidelity.earth = EarthModel::sphere; }));
}

/// Every rung with each of the integrators that it is known with.
std::vector<std::pair<Rung, Integrator>> known_flights() {
  std::vector<std::pair<Rung, Integrator>> flights;
  for (const Rung& rung : kRungs)
    for (const Integrator integrator : {Integrator::tsit5, Integrator::rk43}) flights.emplace_back(rung, integrator);
  return flights;
}

/// A single flight takes known steps, a batch the steps of all rungs: places, events and work are equal, up through
/// several layers of the air and down again.
TEST_P(KnownStepTest, GivesTheFlightOfABatch) {
  for (const auto& [rung, integrator] : known_flights()) {
    SCOPED_TRACE(rung.name);
    for (const double elevation : {0.01, 0.4, 1.2}) {
      ProjectileDef p = plain_bullet();
      p.drag.ballistic_coefficient = 6000;  // far and high
      Launch launch;
      launch.speed = 900;
      launch.elevation = elevation;
      launch.position.y = 2;
      Until until;
      until.events.push_back({.kind = EventKind::apex});
      const Flight flight = fly(p, launch, windy(), fidelity_of(rung, integrator), {}, until);
      const Launch launches[] = {launch};
      const BatchResult batch = fly_batch(p, launches, windy(), fidelity_of(rung, integrator), {}, until);
      ASSERT_EQ(flight.outcome(), Outcome::landed);
      EXPECT_TRUE(same_bits(flight.end().position, batch.shots[0].position));
      EXPECT_TRUE(same_bits(flight.end().velocity, batch.shots[0].velocity));
      EXPECT_EQ(flight.cost().steps, batch.shots[0].cost.steps);
      EXPECT_EQ(flight.cost().rejected, batch.shots[0].cost.rejected);
      EXPECT_EQ(flight.cost().evaluations, batch.shots[0].cost.evaluations);
    }
  }
}

/// Steps so long that they rise out of the first layer of the air and sink back into it: both ends lie below its top,
/// stages between them above.
TEST_P(KnownStepTest, LooksAtTheAirInsideItsSteps) {
  Scene far;
  ASSERT_TRUE(far.add({.shape = *far.add_shape(SphereShape{1}), .transform = {.position = {0, -4000, 1e5}}}));
  ProjectileDef p = plain_bullet();
  p.drag.ballistic_coefficient = 6000;  // slows down little, which makes its steps long
  for (const auto& [rung, integrator] : known_flights()) {
    SCOPED_TRACE(rung.name);
    const Conditions<double> c = Prepared(p, {}, windy(), fidelity_of(rung, integrator)).cohort.conditions;
    int over = 0;
    for (int i = 0; i < 100; ++i) {
      const Launch launch{.position = {0, 10650, 0}, .speed = 820, .elevation = 0.04 + 1e-4 * i};
      const Tolerance loose{.relative = 1e-2, .absolute = 1e-2};
      Until until{.ground = std::nullopt, .time = 30};
      const Flight flight = fly(p, launch, windy(), fidelity_of(rung, integrator), loose, until);
      until.scene = &far;
      expect_same_flight(flight, fly(p, launch, windy(), fidelity_of(rung, integrator), loose, until));
      const std::vector<double> times = flight.step_times();
      const auto altitude = [&](double time) { return flight.at(time).position.y + c.altitude; };
      for (std::size_t k = 1; k < times.size() && times[k] <= flight.duration(); ++k)
        over += altitude(times[k - 1]) < c.air.base[1] && altitude(times[k]) < c.air.base[1] &&
                altitude(0.5 * (times[k - 1] + times[k])) > c.air.low_top;
    }
    EXPECT_GT(over, 0);
  }
}

/// What meets nothing makes its interpolants when it is asked, what may meet things in its steps, by the functions of
/// all rungs: a scene without things changes nothing anywhere on the path.
TEST_P(KnownStepTest, AnswersInsideItsStepsAsAllRungsDo) {
  const Scene empty;
  for (const auto& [rung, integrator] : known_flights()) {
    SCOPED_TRACE(rung.name);
    Launch launch;
    launch.speed = 850;
    launch.elevation = 0.3;
    launch.position.y = 2;
    Until until;
    until.events.push_back({.kind = EventKind::mach, .value = 1});
    const Flight flight = fly(plain_bullet(), launch, windy(), fidelity_of(rung, integrator), {}, until);
    until.scene = &empty;
    const Flight other = fly(plain_bullet(), launch, windy(), fidelity_of(rung, integrator), {}, until);
    ASSERT_EQ(flight.outcome(), Outcome::landed);
    ASSERT_EQ(flight.step_times(), other.step_times());
    ASSERT_EQ(flight.events().size(), other.events().size());
    for (std::size_t i = 0; i < flight.events().size(); ++i)
      EXPECT_TRUE(same_bits(flight.events()[i].position, other.events()[i].position));
    std::vector<double> times = flight.step_times();
    for (int i = 0; i <= 1000; ++i) times.push_back(flight.duration() * i / 1000.0);
    for (const double time : times) {
      const Sample a = flight.at(time), b = other.at(time);
      ASSERT_TRUE(same_bits(a.position, b.position)) << time;
      ASSERT_TRUE(same_bits(a.velocity, b.velocity)) << time;
      ASSERT_TRUE(same_bits(a.acceleration, b.acceleration)) << time;
    }
  }
}

}  // namespace flight_known_step_test
}  // namespace physim::test
