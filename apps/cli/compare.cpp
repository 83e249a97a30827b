// physim compare: one shot on every rung of the ladder of fidelity, error against cost.

#include <memory>

#include "asked.hpp"
#include "outputs.hpp"
#include "report/ladder.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct CompareOptions {
  Question question;
  Outputs outputs;
};

Status compare(const CompareOptions& options) {
  if (Status status = check(options.outputs); !status) return status;
  const Result<AskedShot> asked = ask_without_things(options.question, "a comparison");
  if (!asked) return asked.error();
  const Result<Ladder> ladder = climb(asked->scenario, asked->shot(), progress_bar("comparing"));
  if (!ladder) return ladder.error();
  const LadderOfShot subject{asked->scenario, *ladder};
  if (Status status = write(options.outputs, [&](const Format& format) { return content_of(format, subject); });
      !status)
    return status;
  return options.outputs.use_stdout() ? Status() : print(ladder_text(subject, style_of(stdout)));
}

}  // namespace

void add_compare_command(Command& program) {
  Command command = program.add_command("compare", "Fly one shot on every rung of the ladder: error and cost of each");
  auto options = std::make_shared<CompareOptions>();
  add_question_options(command, options->question, false);
  constexpr Subject kSubjects[] = {Subject::ladder};
  add_output_options(command, options->outputs, "the table", kSubjects);
  command.footer(
      "Every rung starts along the bore of the reference (dop853, as exact as doubles allow) and flies until the "
      "scenario's end.\n"
      "The error is the distance between the two ends; the cost is the median time of one fly().\n\n"
      "Examples:\n"
      "  physim compare scenarios/308_168gr_g7.toml --plot out/ladder.png\n"
      "  physim compare scenarios/308_168gr_g7.toml --csv - | sort\n");
  command.action([options] { return done(compare(*options)); });
}

}  // namespace physim::cli
