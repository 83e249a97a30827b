// Emitters that make no sense are refused, each with its place.
#include <functional>

#include "emit/emission.hpp"
#include "support.hpp"

namespace physim::emit_check_test {

using test::kInfinity;
using test::kNan;
using Change = std::function<void(EmitterDef&)>;
using NumberOf = std::function<DrawnNumber&(EmitterDef&)>;

EmitterDef good() { return {.bursts = {{}}, .gun = {.barrels = {{}}}, .flight = {.limit = {9}}, .subs = {{}}}; }

void expect_refused(const Change& change, const std::string& place) {
  EmitterDef def = good();
  change(def);
  const Status status = check(def);
  ASSERT_FALSE(status) << place;
  EXPECT_EQ(status.error().place, place) << status.error().text();
  EXPECT_FALSE(status.error().message.empty());
}
void expect_taken(const Change& change, const char* what) {
  EmitterDef def = good();
  change(def);
  const Status status = check(def);
  EXPECT_TRUE(status) << what << ": " << status.error().text();
}

TEST(EmitterInput, what_makes_sense_is_taken) {
  expect_taken([](EmitterDef&) {}, "defaults");
  expect_taken([](EmitterDef& d) { d.start.lifetime = {kInfinity}; }, "an infinite lifetime");
  expect_taken([](EmitterDef& d) { d.per_second = {1e9}, d.bursts.clear(); }, "1e9 a second");
  expect_taken([](EmitterDef& d) { d.start.speed = {-5, 5.0, {{0, -1}, {1, 1}}}; }, "backwards");
  expect_taken([](EmitterDef& d) { d.bursts[0].time = 99; }, "a burst behind the end");
  expect_taken([](EmitterDef& d) { d.motion = SteadyMotion{.velocity = {1, 2, 3}}; }, "motion");
  expect_taken([](EmitterDef& d) { d.cycle.prewarm = true; }, "prewarm");
  expect_taken([](EmitterDef& d) { d.from.arc = 6.2832; }, "a whole turn, rounded");
  expect_taken([](EmitterDef& d) { d.cycle.delay = {0, 3.0}; }, "a delay");
  expect_taken([](EmitterDef& d) { d.gun = {.rounds_per_minute = 6000, .recoil_up = {{0, 1}}}; }, "no recoil");
}

TEST(EmitterInput, drawn_numbers_are_looked_at_whole) {
  const std::pair<const char*, NumberOf> numbers[] = {
      {"emitter.cycle.delay", [](EmitterDef& d) -> DrawnNumber& { return d.cycle.delay; }},
      {"emitter.per_second", [](EmitterDef& d) -> DrawnNumber& { return d.per_second; }},
      {"emitter.bursts[0].count", [](EmitterDef& d) -> DrawnNumber& { return d.bursts[0].count; }},
      {"emitter.start.lifetime", [](EmitterDef& d) -> DrawnNumber& { return d.start.lifetime; }},
      {"emitter.start.speed", [](EmitterDef& d) -> DrawnNumber& { return d.start.speed; }},
      {"emitter.start.size", [](EmitterDef& d) -> DrawnNumber& { return d.start.size; }},
      {"emitter.start.size_y", [](EmitterDef& d) -> DrawnNumber& { return d.start.size_y; }},
      {"emitter.start.size_z", [](EmitterDef& d) -> DrawnNumber& { return d.start.size_z; }},
      {"emitter.start.rotation", [](EmitterDef& d) -> DrawnNumber& { return d.start.rotation; }},
      {"emitter.start.rotation_y", [](EmitterDef& d) -> DrawnNumber& { return d.start.rotation_y; }},
      {"emitter.start.rotation_z", [](EmitterDef& d) -> DrawnNumber& { return d.start.rotation_z; }},
      {"emitter.start.gravity", [](EmitterDef& d) -> DrawnNumber& { return d.start.gravity; }},
      {"emitter.life.size", [](EmitterDef& d) -> DrawnNumber& { return d.life.size; }},
      {"emitter.life.turn", [](EmitterDef& d) -> DrawnNumber& { return d.life.turn; }},
      {"emitter.flight.drag", [](EmitterDef& d) -> DrawnNumber& { return d.flight.drag; }},
      {"emitter.flight.gravity", [](EmitterDef& d) -> DrawnNumber& { return d.flight.gravity; }},
      {"emitter.flight.velocity_x", [](EmitterDef& d) -> DrawnNumber& { return d.flight.velocity_x; }},
      {"emitter.flight.velocity_y", [](EmitterDef& d) -> DrawnNumber& { return d.flight.velocity_y; }},
      {"emitter.flight.velocity_z", [](EmitterDef& d) -> DrawnNumber& { return d.flight.velocity_z; }},
      {"emitter.flight.force_x", [](EmitterDef& d) -> DrawnNumber& { return d.flight.force_x; }},
      {"emitter.flight.force_y", [](EmitterDef& d) -> DrawnNumber& { return d.flight.force_y; }},
      {"emitter.flight.force_z", [](EmitterDef& d) -> DrawnNumber& { return d.flight.force_z; }},
      {"emitter.flight.limit", [](EmitterDef& d) -> DrawnNumber& { return d.flight.limit; }},
      {"emitter.flight.noise", [](EmitterDef& d) -> DrawnNumber& { return d.flight.noise; }},
      {"emitter.subs[0].count", [](EmitterDef& d) -> DrawnNumber& { return d.subs[0].count; }}};
  for (const auto& [name, of] : numbers) {
    const std::string place = name;
    const auto& number = of;
    const bool lifetime = place == "emitter.start.lifetime" || place == "emitter.flight.limit";  // may be infinite
    for (const double bad : {kNan, -kInfinity, 1e16}) {
      expect_refused([&](EmitterDef& d) { number(d).value = bad; }, place);
      expect_refused([&](EmitterDef& d) { number(d).to = bad; }, place + ".to");
    }
    expect_refused([&](EmitterDef& d) { number(d).value = kInfinity, number(d).to = 1; }, place);
    if (!lifetime) expect_refused([&](EmitterDef& d) { number(d).value = kInfinity; }, place);
    const auto curve = [&](const Curve& keys, const std::string& at) {
      expect_refused([&](EmitterDef& d) { number(d).curve = keys; }, place + ".curve" + at);
      expect_refused([&](EmitterDef& d) { number(d).to = 1, number(d).to_curve = keys; }, place + ".to_curve" + at);
    };
    curve({{0.5, 1}, {0.4, 1}}, "[1].at");
    curve({{0.5, 1}, {0.5, 1}}, "[1].at");
    curve({{-0.1, 1}}, "[0].at");
    curve({{0, 1}, {1.1, 1}}, "[1].at");
    curve({{kNan, 1}}, "[0].at");
    curve({{0, kNan}}, "[0].value");
    curve({{0, 1}, {1, kInfinity}}, "[1].value");
    curve(Curve(10'001, {0, 1}), "");
    expect_refused([&](EmitterDef& d) { number(d).to_curve = {{0, 1}}; }, place + ".to_curve");
  }
  for (const char* place : {"emitter.cycle.delay", "emitter.per_second", "emitter.bursts[0].count",
                            "emitter.start.size", "emitter.start.size_y", "emitter.start.size_z", "emitter.life.size",
                            "emitter.subs[0].count", "emitter.flight.drag", "emitter.flight.noise"})
    for (const auto& [name, number] : numbers)
      if (std::string_view(name) == place) {
        expect_refused([&](EmitterDef& d) { number(d).value = -1; }, place);
        expect_refused([&](EmitterDef& d) { number(d).curve = {{0, -1}}; }, std::string(place) + ".curve[0].value");
      }
}

TEST(EmitterInput, lifetimes_are_above_0_everywhere) {
  const std::string place = "emitter.start.lifetime";
  for (const double bad : {0.0, -1.0}) expect_refused([=](EmitterDef& d) { d.start.lifetime = {bad}; }, place);
  expect_refused([](EmitterDef& d) { d.start.lifetime.to = 0; }, place + ".to");
  expect_refused([](EmitterDef& d) { d.start.lifetime.curve = {{0, 1}, {0.5, 0}}; }, place);
  expect_refused([](EmitterDef& d) { d.start.lifetime = {1e-200, {}, {{0, 1e-200}}}; }, place);
  expect_refused([](EmitterDef& d) { d.start.lifetime.curve = {{0, -1}}; }, place + ".curve[0].value");
}

TEST(EmitterInput, gradients_rise) {
  const auto at = [](double x, double y) { return Gradient{{x, 0}, {y, 0}}; };
  expect_refused([&](EmitterDef& d) { d.start.colour.gradient = at(0.5, 0.5); }, "emitter.start.colour.gradient[1].at");
  expect_refused([&](EmitterDef& d) { d.life.colour.gradient = at(0, 2); }, "emitter.life.colour.gradient[1].at");
  expect_refused([&](EmitterDef& d) { d.life.colour.to = 0, d.life.colour.to_gradient = at(kNan, 1); },
                 "emitter.life.colour.to_gradient[0].at");
  expect_refused([&](EmitterDef& d) { d.life.colour.to_gradient = at(0, 1); }, "emitter.life.colour.to_gradient");
  expect_refused([&](EmitterDef& d) { d.life.fast = 1, d.life.colour_by_speed = at(1, 0); },
                 "emitter.life.colour_by_speed[1].at");
  expect_refused([](EmitterDef& d) { d.start.colour.gradient.assign(10'001, {}); }, "emitter.start.colour.gradient");
}

TEST(EmitterInput, more_than_1e9_particles_a_second_are_refused) {
  expect_refused([](EmitterDef& d) { d.per_second = {1e12}; }, "emitter.per_second");
  expect_refused([](EmitterDef& d) { d.per_second = {1e3, 1e12}; }, "emitter.per_second");
  expect_refused([](EmitterDef& d) { d.per_second = {1e3, {}, {{0, 1e9}}}; }, "emitter.per_second");
  expect_refused([](EmitterDef& d) { d.per_second = {1e8}, d.cycle.rate = 100; }, "emitter.per_second");
  expect_refused([](EmitterDef& d) { d.bursts[0].count = {1e12}; }, "emitter.bursts[0].count");
  expect_refused([](EmitterDef& d) { d.bursts[0] = {.count = {1e6}, .cycles = 0, .interval = 1e-4}; },
                 "emitter.bursts");
  expect_refused([](EmitterDef& d) { d.bursts[0] = {.count = {0}, .cycles = 0, .interval = 1e-12}; }, "emitter.bursts");
  expect_refused([](EmitterDef& d) { d.bursts[0].count = {1e6}, d.cycle.duration = 1e-4; }, "emitter.bursts");
  expect_refused([](EmitterDef& d) { d.gun.rounds_per_minute = 1e12; }, "emitter.gun.rounds_per_minute");
  expect_refused([](EmitterDef& d) { d.subs[0].count = {1e12}; }, "emitter.subs[0].count");
  expect_refused([](EmitterDef& d) { d.per_second = {0, 1e-9}; }, "emitter.per_second");
}

TEST(EmitterInput, cycles_and_bursts_have_their_ranges) {
  for (const double bad : {0.0, -1.0, 2e9, kInfinity, kNan}) {
    expect_refused([=](EmitterDef& d) { d.cycle.duration = bad; }, "emitter.cycle.duration");
    expect_refused([=](EmitterDef& d) { d.cycle.rate = bad; }, "emitter.cycle.rate");
  }
  expect_refused([](EmitterDef& d) { d.cycle.delay = {2e9}; }, "emitter.cycle.delay");
  expect_refused([](EmitterDef& d) { d.cycle.prewarm = true, d.cycle.looping = false; }, "emitter.cycle.prewarm");
  expect_refused([](EmitterDef& d) { d.cycle.prewarm = true, d.cycle.delay = {1}; }, "emitter.cycle.prewarm");
  expect_refused([](EmitterDef& d) { d.cycle.stop = StopAction(9); }, "emitter.cycle.stop");
  for (const double bad : {-1.0, kInfinity, kNan}) {
    expect_refused([=](EmitterDef& d) { d.bursts[0].time = bad; }, "emitter.bursts[0].time");
    expect_refused([=](EmitterDef& d) { d.bursts[0].interval = bad; }, "emitter.bursts[0].interval");
    expect_refused([=](EmitterDef& d) { d.per_metre = bad; }, "emitter.per_metre");
  }
  expect_refused([](EmitterDef& d) { d.bursts[0].cycles = 0, d.bursts[0].interval = 0; }, "emitter.bursts[0].interval");
  for (const double bad : {-0.1, 1.1, 1e-9, kNan})
    expect_refused([=](EmitterDef& d) { d.bursts[0].probability = bad; }, "emitter.bursts[0].probability");
  expect_refused([](EmitterDef& d) { d.bursts.resize(1001); }, "emitter.bursts");
}

TEST(EmitterInput, guns_have_their_ranges) {
  for (const double bad : {-1.0, kInfinity, kNan}) {
    expect_refused([=](EmitterDef& d) { d.gun.rounds_per_minute = bad; }, "emitter.gun.rounds_per_minute");
    expect_refused([=](EmitterDef& d) { d.gun.burst_pause = bad; }, "emitter.gun.burst_pause");
    expect_refused([=](EmitterDef& d) { d.gun.reload = bad; }, "emitter.gun.reload");
    expect_refused([=](EmitterDef& d) { d.gun.dispersion = bad; }, "emitter.gun.dispersion");
    expect_refused([=](EmitterDef& d) { d.gun.convergence = bad; }, "emitter.gun.convergence");
  }
  for (const double bad : {2.0, -2.0, kNan})
    expect_refused([=](EmitterDef& d) { d.gun.recoil = bad; }, "emitter.gun.recoil");
  expect_refused([](EmitterDef& d) { d.gun.dispersion = 0.4; }, "emitter.gun.dispersion");
  expect_refused([](EmitterDef& d) { d.gun.magazines = 2; }, "emitter.gun.magazine");
  expect_refused([](EmitterDef& d) { d.gun.recoil = 0.1, d.gun.recoil_up = {{0, 1}}; }, "emitter.gun.recoil");
  expect_refused([](EmitterDef& d) { d.gun.recoil_up = {{2, 1}}; }, "emitter.gun.recoil_up[0].at");
  expect_refused([](EmitterDef& d) { d.gun.recoil_right = {{0, kNan}}; }, "emitter.gun.recoil_right[0].value");
  expect_refused([](EmitterDef& d) { d.gun.barrels[0].position.y = kNan; }, "emitter.gun.barrels[0].position");
  expect_refused([](EmitterDef& d) { d.gun.barrels[0].position.x = 60, d.gun.convergence = 50; },
                 "emitter.gun.barrels[0].position");
  expect_refused([](EmitterDef& d) { d.gun.barrels.resize(1001); }, "emitter.gun.barrels");
}

TEST(EmitterInput, shapes_have_their_ranges) {
  expect_refused([](EmitterDef& d) { d.from.shape = EmitShape(99); }, "emitter.from.shape");
  expect_refused([](EmitterDef& d) { d.from.arc_mode = ArcMode(99); }, "emitter.from.arc_mode");
  for (const double bad : {-1.0, kInfinity, kNan}) {
    expect_refused([=](EmitterDef& d) { d.from.radius = bad; }, "emitter.from.radius");
    expect_refused([=](EmitterDef& d) { d.from.tube = bad; }, "emitter.from.tube");
    expect_refused([=](EmitterDef& d) { d.from.length = bad; }, "emitter.from.length");
    expect_refused([=](EmitterDef& d) { d.from.size.z = bad; }, "emitter.from.size");
    expect_refused([=](EmitterDef& d) { d.from.arc = bad; }, "emitter.from.arc");
    expect_refused([=](EmitterDef& d) { d.from.thickness = bad; }, "emitter.from.thickness");
    expect_refused([=](EmitterDef& d) { d.from.randomise = bad; }, "emitter.from.randomise");
    expect_refused([=](EmitterDef& d) { d.from.angle = bad; }, "emitter.from.angle");
  }
  expect_refused([](EmitterDef& d) { d.from.angle = 90 * test::kDegree; }, "emitter.from.angle");
  expect_refused([](EmitterDef& d) { d.from.arc = 360; }, "emitter.from.arc");
  expect_refused([](EmitterDef& d) { d.from.arc_speed = kNan; }, "emitter.from.arc_speed");
  expect_refused([](EmitterDef& d) { d.from.shape = EmitShape::ring, d.from.tube = 2; }, "emitter.from.tube");
}

TEST(EmitterInput, origins_and_launches_are_looked_at) {
  expect_refused([](EmitterDef& d) { d.position.x = kNan; }, "emitter.position");
  expect_refused([](EmitterDef& d) { d.rotation = {0, 0, 0, 0}; }, "emitter.rotation");
  expect_refused([](EmitterDef& d) { d.rotation.w = kNan; }, "emitter.rotation");
  expect_refused([](EmitterDef& d) { d.inherit_velocity = kNan; }, "emitter.inherit_velocity");
  expect_refused([](EmitterDef& d) { d.launch.rail_length = -1; }, "emitter.launch.rail_length");
  expect_refused([](EmitterDef& d) { d.motion = KeyedMotion{}; }, "emitter.motion.keys");
  expect_refused([](EmitterDef& d) { d.motion = SteadyMotion{.velocity = {kNan, 0, 0}}; }, "emitter.motion.velocity");
  expect_refused([](EmitterDef& d) { d.motion = SteadyMotion{}, d.follows = {1, 1}; }, "emitter.motion");
}

TEST(EmitterInput, flights_are_looked_at) {
  const std::string at = "emitter.flight.";
  for (const double bad : {-1.0, kNan, kInfinity}) {
    expect_refused([=](EmitterDef& d) { d.flight.fast = bad; }, at + "fast");
    expect_refused([=](EmitterDef& d) { d.flight.limit_rate = bad; }, at + "limit_rate");
    expect_refused([=](EmitterDef& d) { d.flight.noise_size = bad; }, at + "noise_size");
    expect_refused([=](EmitterDef& d) { d.flight.noise_rate = bad; }, at + "noise_rate");
    expect_refused([=](EmitterDef& d) { d.flight.noise_gain = bad; }, at + "noise_gain");
  }
  expect_refused([](EmitterDef& d) { d.flight.noise_size = 0; }, at + "noise_size");
  expect_refused([](EmitterDef& d) { d.flight.noise_gain = 1.5; }, at + "noise_gain");
  for (const std::uint32_t bad : {0u, 9u})
    expect_refused([=](EmitterDef& d) { d.flight.noise_octaves = bad; }, at + "noise_octaves");
  expect_refused([](EmitterDef& d) { d.flight.drag_by_speed = {{0, 1}}; }, at + "drag_by_speed");
  expect_refused(
      [](EmitterDef& d) {
        d.flight.fast = 1, d.flight.drag_by_speed = {{0, -1}};
      },
      at + "drag_by_speed[0].value");
  expect_refused([](EmitterDef& d) { d.flight.limit = {-1}; }, at + "limit");
  expect_refused([](EmitterDef& d) { d.flight.limit = {kInfinity, {}, {{0, 1}}}; }, at + "limit.curve");
}

TEST(EmitterInput, the_rest_is_looked_at) {
  for (const double bad : {-0.1, 1.1, kNan}) {
    expect_refused([=](EmitterDef& d) { d.start.flipped = bad; }, "emitter.start.flipped");
    expect_refused([=](EmitterDef& d) { d.subs[0].probability = bad; }, "emitter.subs[0].probability");
  }
  expect_refused([](EmitterDef& d) { d.life.fast = kNan; }, "emitter.life.fast");
  expect_refused([](EmitterDef& d) { d.life.size_by_speed = {{0, 1}}; }, "emitter.life.size_by_speed");
  expect_refused([](EmitterDef& d) { d.life.colour_by_speed = {{0, 1}}; }, "emitter.life.colour_by_speed");
  expect_refused(
      [](EmitterDef& d) {
        d.life.fast = 1, d.life.size_by_speed = {{0, -1}};
      },
      "emitter.life.size_by_speed[0].value");
  expect_refused([](EmitterDef& d) { d.maximum = 0; }, "emitter.maximum");
  expect_refused([](EmitterDef& d) { d.when_full = WhenFull(7); }, "emitter.when_full");
  expect_refused([](EmitterDef& d) { d.subs[0].on = SubEvent(99); }, "emitter.subs[0].on");
  expect_refused([](EmitterDef& d) { d.subs[0].axis = SubAxis(99); }, "emitter.subs[0].axis");
  expect_refused([](EmitterDef& d) { d.subs[0].on = SubEvent::age; }, "emitter.subs[0].age");
  expect_refused([](EmitterDef& d) { d.subs[0].age = kNan; }, "emitter.subs[0].age");
  expect_refused([](EmitterDef& d) { d.subs[0].inherit_velocity = kNan; }, "emitter.subs[0].inherit_velocity");
  expect_refused([](EmitterDef& d) { d.subs.resize(1001); }, "emitter.subs");
}

}  // namespace physim::emit_check_test
