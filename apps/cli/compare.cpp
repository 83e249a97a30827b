// physim compare: one shot on every rung of the ladder of fidelity, error against cost.

#include <memory>

#include "asked.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "report/ladder_text.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct CompareOptions {
  ScenarioInput input;
  Outputs outputs;
  std::string shot;
};

Status compare(const CompareOptions& options) {
  if (Status status = check(options.outputs, "the scenario", options.input.file); !status) return status;
  const Result<Scenario> scenario = load_scenario(options.input.file, options.input.overrides);
  if (!scenario) return scenario.error();
  const Result<std::size_t> shot = find_shot(*scenario, options.shot);
  if (!shot) return shot.error();
  const Result<Ladder> ladder = climb(*scenario, scenario->shots[*shot], progress_bar("comparing"));
  if (!ladder) return ladder.error();
  const LadderOfShot subject{*scenario, *ladder};
  if (Status status = write(options.outputs, [&](const Format& format) { return content_of(format, subject); });
      !status)
    return status;
  return options.outputs.use_stdout() ? Status() : print(ladder_text(subject, style_of(stdout)));
}

int exit_code_of(const CompareOptions& options) {
  const Status status = compare(options);
  if (!status) print_error(status.error());
  return status ? kExitOk : kExitBadInput;
}

}  // namespace

void add_compare_command(Command& program) {
  Command command = program.add_command("compare", "Fly one shot on every rung of the ladder: error and cost of each");
  auto options = std::make_shared<CompareOptions>();
  add_scenario_options(command, options->input);
  command.add_option("--shot", options->shot, "Which shot; without it the first").type_name("NAME").refuse_empty();
  constexpr Subject kSubjects[] = {Subject::ladder};
  add_output_options(command, options->outputs, "the table", kSubjects);
  command.footer(
      "Every rung starts with the velocity of the reference (dop853, as exact as doubles allow) and flies until the "
      "scenario's end.\n"
      "The error is the distance between the two ends; the cost is the median time of one fly().\n\n"
      "Examples:\n"
      "  physim compare scenarios/308_168gr_g7.toml --plot out/ladder.png\n"
      "  physim compare scenarios/308_168gr_g7.toml --csv - | sort\n");
  command.action([options] { return exit_code_of(*options); });
}

}  // namespace physim::cli
