// physim max-range and physim danger-space.
#include <memory>

#include "asked.hpp"
#include "physim/solve.hpp"
#include "report/summary.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct MaxRangeCommand {
  Question question;
  std::string slope;
};

struct DangerCommand {
  Question question;
  std::string range, height;
  bool terrain = false;
};

Result<int> run(const MaxRangeCommand& command) {
  const auto slope = option_value("--slope", command.slope, Quantity::angle);
  if (!slope) return slope.error();
  const Result<AskedShot> asked = ask_without_things(command.question, "the farthest range");
  if (!asked) return asked.error();
  warn_of_fidelity(asked->shot(), "the farthest range");
  const Scenario& scenario = asked->scenario;
  const ScenarioShot& shot = asked->shot();
  const double ground = scenario.until.ground.value_or(0);
  const auto far = max_range(shot.projectile, shot.launch, scenario.environment, shot.projectile.fidelity, ground,
                             slope->value_or(0));
  if (!far) {
    Error error = far.error();
    if (error.place == "slope") error.hint = "as in \"5 deg\"; a bare number is in radians";
    return about(*asked, std::move(error), {{"--slope", !command.slope.empty(), "slope"}});
  }
  if (has_own_curve(shot.projectile)) {
    Launch launch = shot.launch;
    launch.sight = {};
    launch.elevation = far->elevation;
    warn_of_curve(fly(shot.projectile, launch, scenario.environment, shot.projectile.fidelity, scenario.tolerance,
                      {.ground = ground, .time = std::max(far->time, 1e-9)}));
  }
  return done(give(command.question, max_range_answer(*asked, *far, style_of(stdout))));
}

Result<int> run(const DangerCommand& command) {
  const auto range = option_value("--range", command.range, Quantity::length);
  if (!range) return range.error();
  const auto height = option_value("--height", command.height, Quantity::length);
  if (!height) return height.error();
  const Result<AskedShot> asked = ask(command.question);
  if (!asked) return asked.error();
  const ScenarioShot& shot = asked->shot();
  if (command.terrain && asked->scenario.things.empty())
    return Error{"the scenario has nothing to stand on", "--terrain", "write a [[thing]] into it"};
  const Result<Scene> ground = scene_of(asked->scenario);
  if (!ground) return about(*asked, ground.error());
  Scenario beyond = asked->scenario;
  beyond.until.range.reset();  // the target may be hit on both sides of where the flight is to end
  const Flight flight = fly_shot(beyond, shot);
  if (flight.error()) return refusal(asked->scenario, shot, flight);
  warn_of_curve(flight);
  const auto space = command.terrain ? danger_space(flight, **range, **height, *ground, shot.body.collision.layers)
                                     : danger_space(flight, **range, **height);
  if (!space) return about(*asked, space.error(), {{"--range", true, "range"}, {"--height", true, "height"}});
  return done(give(command.question, danger_space_answer(*asked, flight, **range, **height, *space, style_of(stdout))));
}

}  // namespace

void add_max_range_command(Command& program) {
  Command command = program.add_command("max-range", "Find the elevation that carries a shot farthest");
  auto options = std::make_shared<MaxRangeCommand>();
  add_question_options(command, options->question);
  command.add_option("--slope", options->slope, "ANGLE", "How the ground rises in the direction of fire, as \"5 deg\"");
  command.footer(
      "The ground is that of the scenario (until.ground), under the muzzle; without one it is at height 0. Elevation "
      "and sight\nof the shot, until.time, until.range and until.events are not read.\n\n"
      "Examples:\n"
      "  physim max-range scenarios/308_168gr_g7.toml\n"
      "  physim max-range scenarios/shot_put.toml --slope \"-3 deg\" --json -\n");
  command.action([options] { return run(*options); });
}

void add_danger_space_command(Command& program) {
  Command command = program.add_command(
      "danger-space", "Between which ranges a target of some height is hit, when it is aimed at for one range");
  auto options = std::make_shared<DangerCommand>();
  add_question_options(command, options->question);
  command.add_option("--range", options->range, "LENGTH", "At which the path goes through the target's middle")
      .required();
  command.add_option("--height", options->height, "LENGTH", "Of the target").required();
  command.add_flag("--terrain", options->terrain, "The target stands on the scenario's things, below the path");
  command.footer(
      "Ranges run along the line of sight; the path lies within half the height of where it is at the range, or with "
      "--terrain\nno more than the height above what is below it.\n\n"
      "Example:\n"
      "  physim danger-space scenarios/308_168gr_g7.toml --range \"600 m\" --height \"50 cm\"\n");
  command.action([options] { return run(*options); });
}

}  // namespace physim::cli
