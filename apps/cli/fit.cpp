// physim fit: the drag of a shot from measured speeds, drops or times.
#include "physim/solve.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <sstream>

#include "asked.hpp"
#include "scenario/files_in_use.hpp"
#include "scenario/measured_column.hpp"
#include "scenario/suggest.hpp"
#include "scenario/text_file.hpp"
#include "scenario/units.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

// ------------------------------------------------------------------------------------------------------ measurements
/// Measurements, where each stands in its file ("data.csv:3"), and the units of its columns.
struct FitData {
  std::vector<Measurement> measurements;
  std::vector<std::string> places;
  FitUnits units;
};

/// What a column holds.
struct DataColumn {
  std::string_view name;
  Quantity quantity;
  std::string unit;  // of the header; empty: SI
};
constexpr std::array<std::string_view, 4> kNames = {"range", "speed", "drop", "time"};
constexpr Quantity kQuantities[] = {Quantity::length, Quantity::speed, Quantity::length, Quantity::time};

/// Reads a table with a header line: "range [yd], speed [ft/s], drop [in], time [s]" in any order, range and at least
/// one other; SI where no unit is given. A drop may be an angle, as a scope shows it. Empty fields are not measured;
/// lines that start with '#' are comments. Errors carry file:line:col.
class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Result<FitData> read() {
    constexpr std::uintmax_t kLargestTable = 64 << 20;  // [bytes]
    const Result<std::string> text = read_text_file(file_, kLargestTable, kMeasurements);
    if (!text) return text.error();
    std::istringstream in(*text);
    std::string line;
    while (std::getline(in, line)) {
      ++line_;
      if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const std::string_view content = trimmed(line);
      if (content.empty() || content.front() == '#') continue;
      const Status status = columns_.empty() ? read_header(line) : read_row(line);
      if (!status) return status.error();
    }
    if (columns_.empty())
      return Error{.message = "there is no header line",
                   .place = file_ + ":1:1",
                   .hint = "write range [m], speed [m/s] above the figures"};
    if (data_.measurements.empty())
      return Error{.message = "there is no figure below the header",
                   .place = file_ + ":" + std::to_string(line_) + ":1"};
    return std::move(data_);
  }

 private:
  [[nodiscard]] std::string place(std::size_t column) const {
    return file_ + ":" + std::to_string(line_) + ":" + std::to_string(column);
  }

  [[nodiscard]] FitUnit* unit_of(std::string_view name) {
    FitUnits& u = data_.units;
    return name == "range" ? &u.range : name == "speed" ? &u.speed : name == "drop" ? &u.drop : &u.time;
  }

  Status read_header(const std::string& line) {
    for (const CsvField& field : csv_fields(line)) {
      const std::size_t bracket = field.text.find('[');
      const std::string name(trimmed(field.text.substr(0, bracket)));
      const auto known = std::find(kNames.begin(), kNames.end(), name);
      if (known == kNames.end())
        return Error{.message = "unknown column " + in_quotes(name),
                     .place = place(field.column),
                     .hint = suggestion(name, kNames, "known columns")};
      DataColumn column{*known, kQuantities[known - kNames.begin()], ""};
      if (bracket != std::string_view::npos) {
        const std::size_t end = field.text.find(']', bracket);
        if (end == std::string_view::npos)
          return Error{
              .message = "the unit has no closing bracket", .place = place(field.column), .hint = "write range [m]"};
        column.unit = std::string(trimmed(field.text.substr(bracket + 1, end - bracket - 1)));
        const std::string unit = "1 " + column.unit;
        Result<double> one = parse_quantity(unit, column.quantity);
        if (const auto angle = parse_quantity(unit, Quantity::angle); angle && name == "drop")
          one = angle, column.quantity = Quantity::angle;
        if (!one) return Error{.message = one.error().message, .place = place(field.column), .hint = one.error().hint};
        *unit_of(name) = {column.unit, *one, column.quantity == Quantity::angle};
      }
      if (std::ranges::count(columns_, column.name, &DataColumn::name) > 0)
        return Error{.message = "two columns are named " + in_quotes(name), .place = place(field.column)};
      columns_.push_back(std::move(column));
    }
    const bool has_range = std::ranges::count(columns_, "range", &DataColumn::name) > 0;
    if (!has_range || columns_.size() < 2)
      return Error{.message = has_range ? "there is a range and nothing else" : "there is no column \"range\"",
                   .place = place(1),
                   .hint = "as in range [yd], speed [ft/s], drop [in]"};
    return {};
  }

  Status read_row(const std::string& line) {
    const std::vector<CsvField> fields = csv_fields(line);
    if (fields.size() != columns_.size())
      return Error{.message = std::to_string(fields.size()) + " fields",
                   .place = place(1),
                   .hint = "the header has " + std::to_string(columns_.size()) + " columns"};
    Measurement m;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const DataColumn& column = columns_[i];
      if (fields[i].text.empty() && column.name != "range") continue;
      const bool has_unit = fields[i].text.find_first_not_of("0123456789+-.eE") != std::string_view::npos;
      std::string text(fields[i].text);
      if (!has_unit && !column.unit.empty()) text += " " + column.unit;
      const Result<double> value = parse_quantity(text, column.quantity);
      if (!value || !std::isfinite(*value))
        return Error{.message = value ? "must be a finite number" : value.error().message,
                     .place = place(fields[i].column),
                     .hint = value ? "" : value.error().hint};
      if (column.name == "range") m.range = *value;
      if (column.name == "speed") m.speed = *value;
      if (column.name == "drop") m.drop = *value;
      if (column.name == "time") m.time = *value;
    }
    if (m.drop && data_.units.drop.is_angle) *m.drop = m.range * std::tan(*m.drop);
    data_.measurements.push_back(m);
    data_.places.push_back(place(1));
    return {};
  }

  std::string file_;
  std::size_t line_ = 0;
  std::vector<DataColumn> columns_;
  FitData data_;
};

// ------------------------------------------------------------------------------------------------------- the command
struct FitCommand {
  Question question;
  std::string data, speed_error, drop_error, time_error;
  bool muzzle_speed = false;
};

Result<FitOptions> options_of(const FitCommand& command) {
  FitOptions options{.muzzle_speed = command.muzzle_speed};
  struct Wish {
    const char* name;
    const std::string& text;
    Quantity quantity;
    double& target;
  };
  for (const auto& [name, text, quantity, target] :
       {Wish{"--speed-error", command.speed_error, Quantity::speed, options.speed_error},
        {"--drop-error", command.drop_error, Quantity::length, options.drop_error},
        {"--time-error", command.time_error, Quantity::time, options.time_error}}) {
    const auto value = option_value(name, text, quantity);
    if (!value) return value.error();
    if (*value && !(**value > 0)) return Error{.message = "must be positive", .place = name};
    target = value->value_or(target);
  }
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
  const Result<AskedShot> asked = ask_without_things(command.question, "a fit");
  if (!asked) return asked.error();
  warn_of_fidelity(asked->shot(), "a fit");
  const Result<FitData> data = Reader(command.data).read();
  if (!data) return data.error();
  const ScenarioShot& shot = asked->shot();
  const Result<Fit> fit = fit_drag(shot.projectile, shot.launch, asked->scenario.environment, shot.projectile.fidelity,
                                   data->measurements, *options);
  if (!fit) return located(command, *asked, *data, fit.error());
  const bool fits_speed = options->muzzle_speed;
  return done(
      give(command.question, fit_answer(*asked, data->measurements, data->units, fits_speed, *fit, style_of(stdout))));
}

}  // namespace

void add_fit_command(Command& program) {
  Command command = program.add_command("fit", "Find the drag of a shot from measured speeds, drops or times");
  auto options = std::make_shared<FitCommand>();
  add_question_options(command, options->question);
  command.add_option("--data", options->data, "CSV", "Measurements (CSV)").required();
  command.add_flag("--muzzle-speed", options->muzzle_speed, "Fit the muzzle speed, too");
  command.add_option("--speed-error", options->speed_error, "SPEED", "Error of measured speeds; without it 1 m/s");
  command.add_option("--drop-error", options->drop_error, "LENGTH", "Error of measured drops; without it 1 cm");
  command.add_option("--time-error", options->time_error, "TIME", "Error of measured times; without it 1 ms");
  command.footer(
      "The data has a header with units, and a row for each range; empty fields are not measured; drops may be in mil "
      "or moa:\n"
      "  range [yd], speed [ft/s], drop [in]\n"
      "  100, 2410, \n"
      "  300, 2040, -14.6\n\n"
      "Example:\n"
      "  physim fit scenarios/308_168gr_g7.toml --data chronograph.csv --muzzle-speed\n");
  command.action([options] { return run(*options); });
}

}  // namespace physim::cli
