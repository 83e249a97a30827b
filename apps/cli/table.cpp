// physim table: a range card, in metric or customary units, as text, CSV or Markdown.
#include <memory>

#include "asked.hpp"
#include "outputs.hpp"
#include "report/range_card.hpp"
#include "report/summary.hpp"

namespace physim::cli {
namespace {

struct TableCommand {
  Question question;
  std::string ranges, units = "metric", angle, format = "text", to = "-";
  std::vector<std::string> winds;
};

/// "text", "markdown" and every format that writes records.
std::vector<std::string> card_formats() {
  std::vector<std::string> names = {"text", "markdown"};
  for (const Format& format : formats())
    if (can_write(format, Subject::records)) names.emplace_back(format.name);
  return names;
}

Text text_of(const Card& card, const std::string& format) {
  const Scenario& scenario = card.asked->scenario;
  const std::string stability = stability_text(card.asked->shot(), card.flight, scenario.environment);
  const std::string below = stability.empty() ? "" : "\nStability: " + stability + "\n";
  if (format == "text") return as_text(one_line(title_of(scenario)) + "\n\n" + table_of(card).text() + below);
  for (const Format& each : formats())
    if (each.name == format) return std::get<Text>(content_of(each, records_of(card)));
  return as_text(table_of(card).markdown() + below);
}

Result<CardWishes> wishes_of(const TableCommand& command) {
  const bool is_metric = command.units == "metric";
  CardWishes wishes{.units = is_metric ? kMetric : kCustomary,
                    // The ranges of a scenario may be round in metres alone.
                    .scenario_ranges = is_metric || !command.ranges.empty(),
                    .winds = {}};
  if (command.angle == "mil") wishes.units.angle = kMil;
  if (command.angle == "moa") wishes.units.angle = kMoa;
  for (const std::string& wind : command.winds) {
    const auto speed = option_value("--wind", wind, Quantity::speed);
    if (!speed) return speed.error();
    wishes.winds.push_back({wind, **speed});
  }
  return wishes;
}

Result<int> run(const TableCommand& command) {
  if (Status status = check_output(command.to); !status) return status.error();
  const Result<CardWishes> wishes = wishes_of(command);
  if (!wishes) return wishes.error();
  Question question = command.question;
  question.input.ranges = command.ranges;
  const Result<AskedShot> asked = ask_without_things(question, "a range card");
  if (!asked) return asked.error();
  const Result<Card> card = make_card(*asked, *wishes);
  if (!card) return card.error();
  for (const std::string& note : curve_notes(card->flight)) print_warning(note);
  if (card->ranges.empty())
    return about(*asked, {.message = "the shot has no range to show", .hint = "give ranges, as --ranges \"100 m\""});
  return done(write_output(command.to, text_of(*card, command.format)));
}

}  // namespace

void add_table_command(Command& program) {
  Command command = program.add_command("table", "Print a range card, in metric or customary units");
  auto options = std::make_shared<TableCommand>();
  add_question_options(command, options->question, false);
  command.add_option("--ranges", options->ranges, "RANGES",
                     "Instead of output.ranges, as \"100 yd .. 1000 yd step 100 yd\"");
  command.add_option("--units", options->units, "metric (m, cm, m/s, J) or customary (yd, in, ft/s, ft lbf)")
      .one_of({"metric", "customary"})
      .type_name("UNITS");
  command.add_option("--angle", options->angle, "mil (milliradians) or moa; without it as the units have it")
      .one_of({"mil", "moa"})
      .type_name("UNIT");
  command
      .add_option("--wind", options->winds, "SPEED",
                  "Columns for a cross wind from the right, as \"10 mph\"; may be given many times")
      .one_value_each();
  std::string names;
  for (const std::string& name : card_formats()) names += (names.empty() ? "" : ", ") + name;
  command.add_option("--format", options->format, names.c_str()).one_of(card_formats()).type_name("FORMAT");
  command.add_output("--to", options->to, "FILE", "Write it into a file; - is the standard output");
  command.footer(
      "Drop is above the line of sight and windage right of it, with their angles; wind columns are the shift by that "
      "wind alone,\nspin columns that by the projectile's spin.\n\n"
      "Examples:\n"
      "  physim table scenarios/308_168gr_g7.toml --units customary --wind \"10 mph\"\n"
      "  physim table scenarios/308_168gr_g7.toml --ranges \"100 m .. 800 m step 50 m\" --format csv --to card.csv\n");
  command.action([options] { return run(*options); });
}

}  // namespace physim::cli
