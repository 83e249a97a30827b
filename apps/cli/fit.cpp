// physim fit: the drag of a shot from measured speeds, drops or times.
#include "physim/solve.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>

#include "asked.hpp"
#include "base/assert.hpp"
#include "math/angles.hpp"
#include "scenario/measured_table.hpp"
#include "scenario/suggest.hpp"
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

/// Reads a table of measurements: "range [yd], speed [ft/s], drop [in], time [s]" in any order, range and at least one
/// other. A drop may be an angle, as a scope shows it. Empty fields are not measured. Errors carry file:line:column.
class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Result<FitData> read() {
    const Status status = read_measured_table(
        file_, [this](const MeasuredLine& heads) { return read_header(heads); },
        [this](const MeasuredLine& row) { return read_row(row); });
    if (!status) return status.error();
    if (data_.measurements.empty())
      return Error{.message = "there is no figure below the header", .place = header_place_};
    return std::move(data_);
  }

 private:
  [[nodiscard]] FitUnit& unit_of(std::string_view name) {
    FitUnits& u = data_.units;
    return name == "range" ? u.range : name == "speed" ? u.speed : name == "drop" ? u.drop : u.time;
  }

  Status read_header(const MeasuredLine& heads) {
    header_place_ = heads.place();
    for (std::size_t i = 0; i < heads.fields.size(); ++i)
      if (Status status = read_head(heads, i); !status) return status;
    const bool has_range = std::ranges::count(columns_, "range", &DataColumn::name) > 0;
    if (!has_range || columns_.size() < 2)
      return Error{.message = has_range ? "there is a range and nothing else" : "there is no column \"range\"",
                   .place = heads.place(),
                   .hint = "as in range [yd], speed [ft/s], drop [in]"};
    return {};
  }

  Status read_head(const MeasuredLine& heads, std::size_t i) {
    const auto [name, unit] = head_of(heads.fields[i].text);
    const auto known = std::find(kNames.begin(), kNames.end(), name);
    if (known == kNames.end() && name.find('[') != name.npos)
      return Error{.message = "the unit has no closing bracket", .place = heads.place(i), .hint = "write range [m]"};
    if (known == kNames.end())
      return Error{.message = "unknown column " + in_quotes(name),
                   .place = heads.place(i),
                   .hint = suggestion(name, kNames, "known columns")};
    DataColumn column{*known, kQuantities[known - kNames.begin()], std::string(unit)};
    const std::string one = "1 " + column.unit;
    const bool is_angle = name == "drop" && !unit.empty() && parse_quantity(one, Quantity::angle);
    if (is_angle) column.quantity = Quantity::angle;
    if (Status status = check_head(heads, i, column.quantity); !status) return status;
    if (!unit.empty()) unit_of(name) = {column.unit, *parse_quantity(one, column.quantity), is_angle};
    columns_.push_back(std::move(column));
    return {};
  }

  Status read_row(const MeasuredLine& row) {
    Measurement m;
    std::size_t drop = 0;  // its field
    for (std::size_t i = 0; i < row.fields.size(); ++i) {
      const DataColumn& column = columns_[i];
      const bool is_range = column.name == "range";
      if (row.fields[i].text.empty() && is_range)
        return Error{.message = "the range is empty", .place = row.place(i), .hint = "say where it was measured"};
      if (row.fields[i].text.empty()) continue;
      const Result<double> value = number_in(row, i, column.unit, column.quantity);
      if (!value) return value.error();
      if (is_range) m.range = *value;
      if (column.name == "speed") m.speed = *value;
      if (column.name == "drop") m.drop = *value, drop = i;
      if (column.name == "time") m.time = *value;
    }
    if (m.drop && data_.units.drop.is_angle)
      if (Status status = from_angle(m, row.place(drop)); !status) return status;
    data_.measurements.push_back(m);
    data_.places.push_back(row.place());
    return {};
  }

  /// Makes a length of a drop that is an angle.
  static Status from_angle(Measurement& m, const std::string& place) {
    PHYSIM_ASSERT(m.drop.has_value());
    if (m.range == 0)
      return Error{.message = "an angle at range 0 says nothing of the drop",
                   .place = place,
                   .hint = "leave the field empty, or the row out"};
    if (!(std::abs(*m.drop) < kRightAngle))
      return Error{.message = "the angle of a drop is below 90 deg", .place = place};
    *m.drop = m.range * std::tan(*m.drop);
    return {};
  }

  const std::string& file_;
  std::string header_place_;
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
