// Scenarios are read, flown and written in a mode of the library's own: decimal numbers are rounded to nearest too.
#include "processor_mode.hpp"

#include "physim/scenario.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_processor_mode_test {

using test::Bits;

constexpr const char* kScenario = R"(physim = 1
[world]
duration = "1 s"
[environment]
atmosphere = { model = "isa", temperature = "61.7 degF" }
[[shot]]
name = "ball"
mass = "0.1 lb"
diameter = "7.3 cm"
speed = "123.4 ft/s"
elevation = "13.7 deg"
position = ["0.1 m", "0.7 ft", "1e-310 m"]
fidelity = "constant_air"
[[volley]]
name = "many"
shot = "ball"
count = 5
interval = "0.1 s"
spread = { horizontal = "1 deg", speed = "0.3 m/s" }
)";

TEST(ProcessorMode, OfTheCallerChangesNoScenario) {
  const Scenario scenario = *parse_scenario(kScenario, "text");
  test::expect_own_mode({
      {"parse_scenario",
       [&](Bits& bits) {
         const auto read = parse_scenario(kScenario, "text");
         bits << read->shots[0].launch.speed << read->shots[0].launch.elevation << read->shots[0].launch.position;
         bits << read->shots[0].projectile.mass << *read->environment.atmosphere.temperature;
       }},
      {"scenario_text, effective_settings",
       [&](Bits& bits) {
         bits << scenario_text(scenario);
         for (const auto& [path, value] : effective_settings(scenario)) bits << path << value;
       }},
      {"parse_quantity",
       [](Bits& bits) {
         bits << *parse_quantity("0.1 ft", Quantity::length) << *parse_quantity("61.7 degF", Quantity::temperature);
       }},
      {"parse_motor_file",
       [](Bits& bits) {
         const auto motors = parse_motor_file("A8 18 70 3-5 0.0033 0.0165 E\n0.1 0.7\n0.33 9.1\n0.7 0\n", "text");
         for (const ThrustPoint& p : motors->front().motor.thrust) bits << p.time << p.force;
         bits << motors->front().diameter << motors->front().mass;
       }},
      {"fly_shot, measure",
       [&](Bits& bits) {
         const Flight flight = fly_shot(scenario, scenario.shots[0]);
         Expectation expectation{.quantity = "energy"};
         bits << flight << *measure(flight, expectation);
       }},
      {"WorldRun",
       [&](Bits& bits) {
         auto run = WorldRun::create(scenario);
         for (std::uint64_t i = 0; i < run->steps(); ++i) run->step();
         for (const WorldGroup& group : run->groups())
           bits << group.range.mean << group.range.spread() << group.mean_speed << group.position << group.time.mean;
         bits << run->world().hash();
       }},
  });
}

}  // namespace physim::scenario_processor_mode_test
