// physim aim: the directions with which a shot hits a target.
#include "physim/solve.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "asked.hpp"
#include "physim/names.hpp"
#include "report/summary.hpp"
#include "scenario/world_run.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct AimCommand {
  Question question;
  std::string position, velocity, acceleration;
  std::string range, height, cross;
  std::string tolerance, arc, time, thing;
};

/// What is aimed at: [target] of the scenario, with what the options say instead.
struct Wanted {
  Target target;
  AimOptions options;
};

/// The place of --range, --height and --cross: as the shot's plane of fire lies.
Result<std::optional<Vec3d>> place_by_range(const AimCommand& command, const Launch& launch) {
  const auto range = option_value("--range", command.range, Quantity::length);
  const auto height = option_value("--height", command.height, Quantity::length);
  const auto cross = option_value("--cross", command.cross, Quantity::length);
  for (const auto* each : {&range, &height, &cross})
    if (!*each) return each->error();
  if (!range->has_value()) {
    if (height->has_value() || cross->has_value())
      return Error{.message = "needs a range",
                   .place = height->has_value() ? "--height" : "--cross",
                   .hint = "write --range \"800 m\""};
    return std::optional<Vec3d>();
  }
  const double a = launch.azimuth;
  const double ahead = **range, aside = cross->value_or(0);
  return std::optional<Vec3d>(launch.position + Vec3d{ahead * std::cos(a) - aside * std::sin(a), height->value_or(0),
                                                      ahead * std::sin(a) + aside * std::cos(a)});
}

/// The thing of --thing; without another target its origin is aimed at, as it moves when the shot is fired.
Status want_thing(const AimCommand& command, const AskedShot& asked, const SceneParts& parts, bool is_placed,
                  Wanted& out) {
  if (command.thing.empty()) return {};
  const std::vector<ScenarioThing>& things = asked.scenario.things;
  const auto named = std::ranges::find(things, command.thing, &ScenarioThing::name);
  if (named == things.end()) {
    std::string names;
    for (const ScenarioThing& thing : things) names += (names.empty() ? "\"" : ", \"") + thing.name + "\"";
    return Error{.message = "there is no thing \"" + command.thing + "\"",
                 .place = "--thing",
                 .hint = names.empty() ? "the scenario has none" : "its things are " + names};
  }
  out.options.target_thing = parts.things[static_cast<std::size_t>(named - things.begin())];
  if (is_placed) return {};
  const auto state = parts.scene.state(out.options.target_thing);
  if (!state) return Error{"it is not there", "--thing", ""};
  out.target = {.position = state->position, .velocity = state->velocity};
  return {};
}

Result<Wanted> wanted(const AimCommand& command, const AskedShot& asked, const SceneParts& parts) {
  const ScenarioTarget& given = asked.scenario.target;
  Wanted out;
  out.options = {.arc = given.arc,
                 .tolerance = given.tolerance,
                 .ground = asked.scenario.until.ground,
                 .flight = asked.scenario.tolerance};
  const auto position = option_vector("--target", command.position, Quantity::length);
  const auto velocity = option_vector("--target-velocity", command.velocity, Quantity::speed);
  const auto acceleration = option_vector("--target-acceleration", command.acceleration, Quantity::acceleration);
  for (const auto* each : {&position, &velocity, &acceleration})
    if (!*each) return each->error();
  const auto by_range = place_by_range(command, asked.shot().launch);
  if (!by_range) return by_range.error();
  if (position->has_value() && by_range->has_value())
    return Error{.message = "given together with --range", .place = "--target", .hint = "give one of them"};
  const bool is_placed = position->has_value() || by_range->has_value();
  const auto place = position->has_value() ? *position : by_range->has_value() ? *by_range : given.position;
  if (!place && command.thing.empty())
    return Error{.message = "there is no target",
                 .place = asked.scenario.file,
                 .hint = "write --target \"500 m, 20 m, 0 m\", --range \"500 m\", or a [target] into the scenario"};
  out.target = {place.value_or(Vec3d{}), given.velocity, given.acceleration};
  if (Status status = want_thing(command, asked, parts, is_placed, out); !status) return status.error();
  out.target.velocity = velocity->value_or(out.target.velocity);
  out.target.acceleration = acceleration->value_or(out.target.acceleration);
  const auto tolerance = option_value("--tolerance", command.tolerance, Quantity::length);
  const auto time = option_value("--time", command.time, Quantity::time);
  for (const auto* each : {&tolerance, &time})
    if (!*each) return each->error();
  out.options.tolerance = tolerance->value_or(out.options.tolerance);
  out.options.time = time->value_or(out.options.time);
  if (!command.arc.empty()) {
    const auto arc = value_of<Arc>(command.arc);
    if (!arc)
      return Error{.message = "unknown arc \"" + command.arc + "\"", .place = "--arc", .hint = "low, high or both"};
    out.options.arc = *arc;
  }
  return out;
}

Result<int> run(const AimCommand& command) {
  const Result<AskedShot> asked = ask(command.question);
  if (!asked) return asked.error();
  warn_of_fidelity(asked->shot(), "an aim");
  const Result<SceneParts> parts = scene_parts(asked->scenario);
  if (!parts) return about(*asked, parts.error());
  Result<Wanted> target = wanted(command, *asked, *parts);
  if (!target) return target.error();
  const ScenarioShot& shot = asked->shot();
  if (!asked->scenario.things.empty()) target->options.scene = &parts->scene;
  target->options.contact = contact_of(shot);
  Launch launch = shot.launch;
  launch.sight = {};
  const Result<Aim> found = aim(shot.projectile, launch, asked->scenario.environment, shot.projectile.fidelity,
                                target->target, target->options);
  if (!found)
    return about(*asked, found.error(),
                 {{"--target", !command.position.empty(), "target.position"},
                  {"--range", !command.range.empty(), "target.position"},
                  {"--target-velocity", !command.velocity.empty(), "target.velocity"},
                  {"--target-acceleration", !command.acceleration.empty(), "target.acceleration"},
                  {"--tolerance", !command.tolerance.empty(), "options.tolerance"},
                  {"--time", !command.time.empty(), "options.time"}});
  Until until{.ground = target->options.ground};
  const bool are_one = found->low && found->high && found->low->time == found->high->time;
  for (const auto& solution : {found->low, are_one ? std::nullopt : found->high}) {
    if (!solution || !has_own_curve(shot.projectile)) continue;
    until.time = std::max(solution->time, 1e-9);
    warn_of_curve(fly(shot.projectile, solution->launch, asked->scenario.environment, shot.projectile.fidelity,
                      target->options.flight, until));
  }
  const Answer answer = aim_answer(*asked, target->target, target->options, *found, style_of(stdout));
  return done(give(command.question, answer), found->in_reach() ? kExitOk : kExitCheckMissed);
}

}  // namespace

void add_aim_command(Command& program) {
  Command command = program.add_command("aim", "Find the elevation and azimuth that hit a target, standing or moving");
  auto options = std::make_shared<AimCommand>();
  add_question_options(command, options->question);
  command.add_option("--target", options->position, "\"X, Y, Z\"",
                     "Where it is when the shot is fired, as \"500 m, 20 m, 0 m\"");
  command.add_option("--range", options->range, "LENGTH",
                     "Instead: this far from the muzzle, ahead in the shot's azimuth");
  command.add_option("--height", options->height, "LENGTH", "... this much above the muzzle");
  command.add_option("--cross", options->cross, "LENGTH", "... this far to the right");
  command.add_option("--target-velocity", options->velocity, "\"X, Y, Z\"",
                     "How the target moves, as \"0 m/s, 0 m/s, 15 m/s\"");
  command.add_option("--target-acceleration", options->acceleration, "\"X, Y, Z\"", "Its constant acceleration");
  command.add_option("--thing", options->thing, "NAME",
                     "The thing that is to be hit, which is in nobody's way; without --target and --range its origin");
  command.add_option("--tolerance", options->tolerance, "LENGTH", "A path that passes so near hits; without it 1 cm");
  command.add_option("--time", options->time, "TIME", "Longest time of flight; without it 600 s");
  command.add_option("--arc", options->arc, "low|high|both",
                     "Which solutions: the shortest time of flight, the longest, or both");
  command.footer(
      "Without --target and --range the [target] of the scenario is aimed at. Elevation, azimuth and sight of the shot "
      "are not read.\n"
      "Ways that a thing of the scenario stands in are told with what they hit, and so is what hides the target.\n"
      "Exit code 0; 1 where the target is out of reach; 2 for bad input.\n\n"
      "Examples:\n"
      "  physim aim scenarios/308_168gr_g7.toml --range \"800 yd\" --height \"-30 m\"\n"
      "  physim aim scenarios/308_168gr_g7.toml --target \"400 m, 0 m, 30 m\" --target-velocity \"0 m/s, 0 m/s, -8 "
      "m/s\"\n"
      "  physim aim scenarios/aim_moving_target.toml --json -\n");
  command.action([options] { return run(*options); });
}

}  // namespace physim::cli
