#include "report/range_card.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/summary.hpp"

namespace physim::report {
namespace {

struct CardColumn {
  std::string header;
  int decimals;
  bool is_size = false;  // of any order of magnitude, and not of the rounding of others

  [[nodiscard]] std::string text(double figure) const {
    constexpr int kDigits = 4;
    const bool loses_digits = figure < std::pow(10, 1 - decimals) || figure >= 1e9;
    return is_size && loses_digits ? sized(figure, kDigits) : fixed(figure, decimals);
  }
};

/// The figures of a card, in its units; none where a figure has no meaning.
struct CardFigures {
  std::vector<CardColumn> columns;
  std::vector<std::vector<std::optional<double>>> rows;  // only the range where the shot does not reach it

  void add_column(const std::string& what, const ShownUnit& unit) {
    columns.push_back({what + " [" + unit.name + "]", unit.decimals});
  }
};

std::vector<CrossWind> shifts_of(const Card& card) {
  std::vector<CrossWind> shifts = card.winds;
  if (card.without_spin) shifts.push_back({"spin", card.flight, *card.without_spin});
  return shifts;
}

void add_columns(const Card& card, const std::vector<CrossWind>& shifts, CardFigures& out) {
  const CardUnits& u = card.units;
  const auto add_offset = [&](const std::string& what) {
    out.add_column(what, u.drop);
    out.add_column(what, u.angle);
  };
  out.add_column("range", u.range);
  if (has_sight(card.asked->shot().launch))
    add_offset("drop");
  else
    out.add_column("height", {u.range.name, u.range.size, 2});
  add_offset("windage");
  for (const CrossWind& shift : shifts) add_offset(shift.label);
  out.add_column("speed", u.speed);
  out.add_column("mach", {"-", 1, 3});
  out.add_column("energy", u.energy);
  out.columns.back().is_size = true;
  out.add_column("time", {"s", 1, 3});
}

CardFigures figures_of(const Card& card) {
  const CardUnits& u = card.units;
  const std::vector<CrossWind> shifts = shifts_of(card);
  CardFigures out;
  add_columns(card, shifts, out);
  for (const double range : card.ranges) {
    std::vector<std::optional<double>>& row = out.rows.emplace_back(1, range / u.range.size);
    const Result<Sample> s = card.flight.at_range(range);
    if (!s) continue;
    const auto add_offset = [&](double offset) {
      row.emplace_back(offset / u.drop.size);
      row.push_back(range > 0 ? std::optional(std::atan2(offset, range) / u.angle.size) : std::nullopt);
    };
    if (has_sight(card.asked->shot().launch))
      add_offset(s->drop);
    else
      row.emplace_back(s->position.y / u.range.size);
    add_offset(s->windage);
    for (const CrossWind& shift : shifts) {
      const Result<Sample> blown = shift.blown.at_range(range), calm = shift.calm.at_range(range);
      if (blown && calm)
        add_offset(blown->windage - calm->windage);
      else
        row.insert(row.end(), 2, std::nullopt);
    }
    for (const double figure : {s->speed / u.speed.size, s->mach, s->energy / u.energy.size, s->time})
      row.emplace_back(figure);
    PHYSIM_ASSERT(row.size() == out.columns.size());
  }
  return out;
}

/// True if all lengths are whole numbers of a unit.
bool are_whole(const std::vector<double>& lengths, double unit) {
  constexpr double kRounding = 1e-9;
  return std::ranges::all_of(lengths, [&](double length) {
    return std::abs(length / unit - std::round(length / unit)) <= kRounding * std::abs(length / unit);
  });
}

// ------------------------------------------------------------------------------------------------------- the flights
/// With the bore where the main flight had it: a zero is not shot anew for every wind.
Flight fly_again(const Card& card, const Environment& environment, const Fidelity& fidelity) {
  PHYSIM_ASSERT(card.flight.duration() >= 0);
  const Scenario& scenario = card.asked->scenario;
  Launch launch = card.asked->shot().launch;
  if (!launch.velocity) launch.elevation = card.flight.elevation();
  launch.sight.zero_range = 0;
  Until until = scenario.until;
  until.range.reset();  // blown flights may come to the last range later or earlier
  until.time = std::min(until.time, 2 * card.flight.duration());
  return fly(card.asked->shot().projectile, launch, environment, fidelity, scenario.tolerance, until);
}

Result<CrossWind> cross_wind(const Card& card, const AskedWind& wind) {
  const ScenarioShot& shot = card.asked->shot();
  Environment environment = card.asked->scenario.environment;
  environment.wind = {};
  Fidelity fidelity = card.flight.fidelity_in_use().fidelity;
  fidelity.wind = WindModel::constant;
  const Flight calm = fly_again(card, environment, fidelity);
  const double a = shot.launch.azimuth;
  environment.wind.velocity = Vec3d{std::sin(a), 0, -std::cos(a)} * wind.speed;  // from the right
  const Flight blown = fly_again(card, environment, fidelity);
  for (const Flight* flight : {&calm, &blown})
    if (flight->error()) return about(*card.asked, *flight->error());
  return CrossWind{"wind " + wind.label, blown, calm};
}

}  // namespace

Table table_of(const Card& card) {
  const CardFigures figures = figures_of(card);
  std::vector<std::string> headers;
  for (const CardColumn& column : figures.columns) headers.push_back(column.header);
  Table table(std::move(headers));
  for (const auto& figures_of_row : figures.rows) {
    std::vector<std::string> row = {as_typed(*figures_of_row.front())};
    for (std::size_t i = 1; i < figures_of_row.size(); ++i)
      row.push_back(figures_of_row[i] ? figures.columns[i].text(*figures_of_row[i]) : "-");
    const ShownUnit& unit = card.units.range;
    if (row.size() == 1) row.push_back(not_reached(card.flight, *figures_of_row.front(), unit.name, unit.size));
    table.add_row(std::move(row));
  }
  return table;
}

Records records_of(const Card& card) {
  CardFigures figures = figures_of(card);
  std::vector<std::string> headers;
  for (const CardColumn& column : figures.columns) headers.push_back(column.header);
  const std::size_t count = headers.size();
  return {std::move(headers), [rows = std::move(figures.rows), count](const auto& take) {
            for (const auto& row : rows) {
              std::vector<Cell> cells(count);  // empty where there is no figure
              for (std::size_t i = 0; i < row.size(); ++i)
                if (row[i]) cells[i] = *row[i];
              take(cells);
            }
          }};
}

Result<Card> make_card(const AskedShot& asked, const CardWishes& wishes) {
  const ScenarioShot& shot = asked.shot();
  Card card{.asked = &asked, .units = wishes.units, .flight = fly_shot(asked.scenario, shot)};
  if (card.flight.error()) return refusal(asked.scenario, shot, card.flight);
  if (wishes.scenario_ranges || are_whole(asked.scenario.ranges, card.units.range.size))
    card.ranges = asked.scenario.ranges;
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
  for (const AskedWind& wind : wishes.winds) {
    auto flown = cross_wind(card, wind);
    if (!flown) return flown.error();
    card.winds.push_back(*std::move(flown));
  }
  return card;
}

}  // namespace physim::report
