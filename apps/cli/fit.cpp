// physim fit: the drag of a shot from measured speeds, drops or times.
#include "physim/fit.hpp"

#include <charconv>
#include <memory>

#include "asked.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "fit_data.hpp"
#include "report/answer.hpp"
#include "scenario/units.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct FitCommand {
  Question question;
  std::string data, speed_error, drop_error, time_error;
  bool muzzle_speed = false;
};

Result<FitOptions> options_of(const FitCommand& command) {
  FitOptions options{.muzzle_speed = command.muzzle_speed};
  const auto read = [](const char* name, const std::string& text, Quantity quantity, double& target) -> Status {
    const auto value = option_value(name, text, quantity);
    if (!value) return value.error();
    if (*value && !(**value > 0)) return Error{.message = "must be positive", .place = name};
    if (*value) target = **value;
    return {};
  };
  if (Status status = read("--speed-error", command.speed_error, Quantity::speed, options.speed_error); !status)
    return status.error();
  if (Status status = read("--drop-error", command.drop_error, Quantity::length, options.drop_error); !status)
    return status.error();
  if (Status status = read("--time-error", command.time_error, Quantity::time, options.time_error); !status)
    return status.error();
  return options;
}

/// An error about measurements[i] has its place in the file.
Error located(const FitCommand& command, const AskedShot& asked, const FitData& data, Error error) {
  constexpr std::string_view kPrefix = "measurements";
  if (!error.place.starts_with(kPrefix)) return about(asked, std::move(error));
  std::size_t index = 0;
  const std::string_view rest = std::string_view(error.place).substr(kPrefix.size());
  const bool has_index =
      rest.starts_with('[') && std::from_chars(rest.data() + 1, rest.data() + rest.size(), index).ec == std::errc{};
  error.place = has_index && index < data.places.size() ? data.places[index] : command.data;
  return error;
}

Result<int> run(const FitCommand& command) {
  const Result<FitOptions> options = options_of(command);
  if (!options) return options.error();
  const Result<AskedShot> asked = ask(command.question);
  if (!asked) return asked.error();
  const Result<FitData> data = read_fit_data(command.data);
  if (!data) return data.error();
  const ScenarioShot& shot = asked->shot();
  const Result<Fit> fit = fit_drag(shot.projectile, shot.launch, asked->scenario.environment, shot.projectile.fidelity,
                                   data->measurements, *options);
  if (!fit) return located(command, *asked, *data, fit.error());
  if (Status status =
          answer(command.question, fit_text(*asked, data->measurements, options->muzzle_speed, *fit, style_of(stdout)),
                 fit_json(*asked, options->muzzle_speed, *fit));
      !status)
    return status.error();
  return kExitOk;
}

}  // namespace

void add_fit_command(Command& program) {
  Command command = program.add_command("fit", "Find the drag of a shot from measured speeds, drops or times");
  auto options = std::make_shared<FitCommand>();
  add_question_options(command, options->question);
  command.add_option("--data", options->data, "Measurements (CSV)").type_name("CSV").required().refuse_empty();
  command.add_flag("--muzzle-speed", options->muzzle_speed, "Fit the muzzle speed, too");
  const auto add = [&](const char* name, std::string& value, const char* type, const char* doc) {
    command.add_option(name, value, doc).type_name(type).refuse_empty();
  };
  add("--speed-error", options->speed_error, "SPEED", "Error of measured speeds; without it 1 m/s");
  add("--drop-error", options->drop_error, "LENGTH", "Error of measured drops; without it 1 cm");
  add("--time-error", options->time_error, "TIME", "Error of measured times; without it 1 ms");
  command.footer(
      "The data has a header with units, and a row for each range; empty fields are not measured:\n"
      "  range [yd], speed [ft/s], drop [in]\n"
      "  100, 2410, \n"
      "  300, 2040, -14.6\n\n"
      "Example:\n"
      "  physim fit scenarios/308_168gr_g7.toml --data chronograph.csv --muzzle-speed\n");
  command.action([options] { return exit_code(run(*options)); });
}

}  // namespace physim::cli
