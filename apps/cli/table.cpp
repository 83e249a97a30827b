// physim table: a range card, in metric or customary units, as text, CSV or Markdown.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "asked.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "output_file.hpp"
#include "output_number.hpp"
#include "output_summary.hpp"
#include "output_table.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct TableCommand {
  Question question;
  std::string ranges, units = "metric", angle, format = "text", to = "-";
  std::vector<std::string> winds;
};

/// A unit to show numbers in: value in SI / size.
struct ShownUnit {
  const char* name;
  double size;
  int decimals;
};

/// The units of a card.
struct CardUnits {
  ShownUnit range, drop, speed, energy, angle;
};

constexpr ShownUnit kMil = {"mil", 1e-3, 2};  // a milliradian
constexpr ShownUnit kMoa = {"MOA", 2.908882086657216e-4, 1};
constexpr CardUnits kMetric = {{"m", 1, 0}, {"cm", 0.01, 1}, {"m/s", 1, 1}, {"J", 1, 0}, kMil};
constexpr CardUnits kCustomary = {
    {"yd", 0.9144, 0}, {"in", 0.0254, 1}, {"ft/s", 0.3048, 0}, {"ft lbf", 1.3558179483314004, 0}, kMoa};

/// A flight that tells the windage of one cross wind, against the same in calm air.
struct CrossWind {
  std::string label;
  Flight blown, calm;
};

/// What a card is made from.
struct Card {
  const AskedShot* asked;
  CardUnits units;
  Flight flight;
  std::optional<Flight> without_spin;
  std::vector<CrossWind> winds;
  std::vector<double> ranges;
};

struct CardColumn {
  std::string header;
  std::function<std::string(const Sample& sample, double range)> text;
};

std::string shown(double value, const ShownUnit& unit) { return fixed(value / unit.size, unit.decimals); }
std::string header(const std::string& what, const ShownUnit& unit) { return what + " [" + unit.name + "]"; }

/// The windage of one flight less that of another where they cross a range; nothing where one does not.
std::optional<double> shift(const Flight& flight, const Flight& from, double range) {
  const Result<Sample> a = flight.at_range(range), b = from.at_range(range);
  return a && b ? std::optional(a->windage - b->windage) : std::nullopt;
}

std::vector<CardColumn> columns_of(const Card& card) {
  const CardUnits& u = card.units;
  std::vector<CardColumn> columns;
  const auto add = [&](std::string head, std::function<std::string(const Sample&, double)> text) {
    columns.push_back({std::move(head), std::move(text)});
  };
  const auto angle_of = [u](double offset, double range) {
    return range > 0 ? shown(std::atan2(offset, range), u.angle) : std::string("-");
  };
  const auto add_shift = [&](const std::string& what, const Flight& flight, const Flight& from) {
    add(header(what, u.drop), [u, flight, from](const Sample&, double range) {
      const auto found = shift(flight, from, range);
      return found ? shown(*found, u.drop) : std::string("-");
    });
    add(header(what, u.angle), [angle_of, flight, from](const Sample&, double range) {
      const auto found = shift(flight, from, range);
      return found ? angle_of(*found, range) : std::string("-");
    });
  };
  add(header("range", u.range), [u](const Sample&, double range) { return as_typed(range / u.range.size); });
  add(header("drop", u.drop), [u](const Sample& s, double) { return shown(s.drop, u.drop); });
  add(header("drop", u.angle), [angle_of](const Sample& s, double range) { return angle_of(s.drop, range); });
  add(header("windage", u.drop), [u](const Sample& s, double) { return shown(s.windage, u.drop); });
  add(header("windage", u.angle), [angle_of](const Sample& s, double range) { return angle_of(s.windage, range); });
  for (const CrossWind& wind : card.winds) add_shift(wind.label, wind.blown, wind.calm);
  if (card.without_spin) add_shift("spin", card.flight, *card.without_spin);
  add(header("speed", u.speed), [u](const Sample& s, double) { return shown(s.speed, u.speed); });
  add("mach [-]", [](const Sample& s, double) { return fixed(s.mach, 3); });
  add(header("energy", u.energy), [u](const Sample& s, double) { return shown(s.energy, u.energy); });
  add("time [s]", [](const Sample& s, double) { return fixed(s.time, 3); });
  return columns;
}

/// Rows of text; a range that the shot does not reach says so.
Table table_of(const Card& card) {
  const std::vector<CardColumn> columns = columns_of(card);
  std::vector<Column> heads;
  for (const CardColumn& column : columns) heads.push_back({column.header});
  Table table(heads);
  for (const double range : card.ranges) {
    const Result<Sample> there = card.flight.at_range(range);
    std::vector<std::string> row;
    if (!there) row = {as_typed(range / card.units.range.size), "not reached"};
    for (const CardColumn& column : columns)
      if (there) row.push_back(column.text(*there, range));
    table.add_row(std::move(row));
  }
  return table;
}

std::string csv_of(const Card& card) {
  const std::vector<CardColumn> columns = columns_of(card);
  std::string out;
  for (const CardColumn& column : columns) out += (out.empty() ? "" : ", ") + column.header;
  out += "\n";
  for (const double range : card.ranges) {
    const Result<Sample> there = card.flight.at_range(range);
    std::string row = as_typed(range / card.units.range.size);
    for (std::size_t i = 1; i < columns.size(); ++i) row += ", " + (there ? columns[i].text(*there, range) : "");
    out += row + "\n";
  }
  return out;
}

// ------------------------------------------------------------------------------------------------------- the flights
/// With the bore where the main flight had it: a zero is not shot anew for every wind.
Flight fly_again(const Card& card, const Environment& environment, const Fidelity& fidelity) {
  const Scenario& scenario = card.asked->scenario;
  Launch launch = card.asked->shot().launch;
  if (!launch.velocity) launch.elevation = card.flight.elevation();
  launch.sight.zero_range = 0;
  Until until = scenario.until;
  until.range.reset();  // blown flights may come to the last range later or earlier
  until.time = std::min(until.time, 2 * card.flight.duration());
  return fly(card.asked->shot().projectile, launch, environment, fidelity, scenario.tolerance, until);
}

Result<CrossWind> cross_wind(const Card& card, const std::string& text) {
  const auto speed = option_value("--wind", text, Quantity::speed);
  if (!speed) return speed.error();
  const ScenarioShot& shot = card.asked->shot();
  Environment environment = card.asked->scenario.environment;
  environment.wind = {};
  Fidelity fidelity = card.flight.fidelity_in_use().fidelity;
  fidelity.wind = WindModel::constant;
  const Flight calm = fly_again(card, environment, fidelity);
  const double a = shot.launch.azimuth;
  environment.wind.velocity = Vec3d{std::sin(a), 0, -std::cos(a)} * **speed;  // from the right
  const Flight blown = fly_again(card, environment, fidelity);
  for (const Flight* flight : {&calm, &blown})
    if (flight->error()) return about(*card.asked, *flight->error());
  return CrossWind{"wind " + text, blown, calm};
}

Result<CardUnits> units_of_card(const TableCommand& command) {
  CardUnits units = command.units == "customary" ? kCustomary : kMetric;
  if (command.angle == "mil") units.angle = kMil;
  if (command.angle == "moa") units.angle = kMoa;
  return units;
}

Result<Card> make_card(const TableCommand& command, const AskedShot& asked) {
  const auto units = units_of_card(command);
  if (!units) return units.error();
  const ScenarioShot& shot = asked.shot();
  Card card{.asked = &asked, .units = *units, .flight = fly_shot(asked.scenario, shot)};
  if (card.flight.error()) return refusal(asked.scenario, shot, card.flight);
  // The ranges of a scenario are round in metres.
  if (command.units == "metric" || !command.ranges.empty()) card.ranges = asked.scenario.ranges;
  if (card.ranges.empty()) {
    card.ranges = default_ranges(card.flight.end().range / card.units.range.size);
    for (double& range : card.ranges) range *= card.units.range.size;
  }
  const Fidelity& granted = card.flight.fidelity_in_use().fidelity;
  if (granted.rotation != RotationModel::none) {
    Fidelity still = granted;
    still.rotation = RotationModel::none;
    card.without_spin = fly_again(card, asked.scenario.environment, still);
  }
  for (const std::string& wind : command.winds) {
    auto flown = cross_wind(card, wind);
    if (!flown) return flown.error();
    card.winds.push_back(*std::move(flown));
  }
  return card;
}

Result<int> run(const TableCommand& command) {
  if (Status status = check_writable(command.to); !status) return status.error();
  Question question = command.question;
  if (!command.ranges.empty()) question.input.overrides.push_back("output.ranges=" + command.ranges);
  const Result<AskedShot> asked = ask(question);
  if (!asked) return asked.error();
  const Result<Card> card = make_card(command, *asked);
  if (!card) return card.error();
  if (card->ranges.empty())
    return about(*asked, {.message = "the shot has no range to show", .hint = "give ranges, as --ranges \"100 m\""});
  std::string text = command.format == "csv"        ? csv_of(*card)
                     : command.format == "markdown" ? table_of(*card).markdown()
                                                    : table_of(*card).text();
  if (command.format == "text") text = one_line(title_of(asked->scenario)) + "\n\n" + text;
  if (Status status = write_output(command.to, text); !status) return status.error();
  return kExitOk;
}

}  // namespace

void add_table_command(Command& program) {
  Command command = program.add_command("table", "Print a range card, in metric or customary units");
  auto options = std::make_shared<TableCommand>();
  add_question_options(command, options->question, false);
  command.add_option("--ranges", options->ranges, "Instead of output.ranges, as \"100 yd .. 1000 yd step 100 yd\"")
      .type_name("RANGES")
      .refuse_empty();
  command.add_option("--units", options->units, "metric (m, cm, m/s, J) or customary (yd, in, ft/s, ft lbf)")
      .one_of({"metric", "customary"})
      .type_name("UNITS");
  command.add_option("--angle", options->angle, "mil (milliradians) or moa; without it as the units have it")
      .one_of({"mil", "moa"})
      .type_name("UNIT");
  command
      .add_option("--wind", options->winds,
                  "Columns for a cross wind from the right, as \"10 mph\"; may be given many times")
      .type_name("SPEED")
      .one_value_each()
      .refuse_empty();
  command.add_option("--format", options->format, "text, csv or markdown")
      .one_of({"text", "csv", "markdown"})
      .type_name("FORMAT");
  command.add_option("--to", options->to, "Write it into a file; - is the standard output")
      .type_name("FILE")
      .refuse_empty();
  command.footer(
      "Drop is above the line of sight and windage right of it, with their angles; wind columns are the shift by that "
      "wind alone,\nspin columns that by the projectile's spin.\n\n"
      "Examples:\n"
      "  physim table scenarios/308_168gr_g7.toml --units customary --wind \"10 mph\"\n"
      "  physim table scenarios/308_168gr_g7.toml --ranges \"100 m .. 800 m step 50 m\" --format csv --to card.csv\n");
  command.action([options] { return exit_code(run(*options)); });
}

}  // namespace physim::cli
