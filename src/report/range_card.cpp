#include "report/range_card.hpp"

#include <algorithm>
#include <cmath>

#include "report/number.hpp"
#include "report/summary.hpp"

namespace physim::report {
namespace {

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

}  // namespace

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

Records records_of(const Card& card) {
  const std::vector<CardColumn> columns = columns_of(card);
  Records records;
  for (const CardColumn& column : columns) records.columns.push_back(column.header);
  records.rows = [&card, columns](const auto& take) {
    for (const double range : card.ranges) {
      const Result<Sample> there = card.flight.at_range(range);
      std::vector<std::string> texts(columns.size());  // a range that the shot does not reach has no figures
      texts[0] = as_typed(range / card.units.range.size);
      for (std::size_t i = 1; i < columns.size(); ++i)
        if (there) texts[i] = columns[i].text(*there, range);
      const std::vector<Cell> row(texts.begin(), texts.end());
      take(row);
    }
  };
  return records;
}

namespace {

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

Result<Card> make_card(const AskedShot& asked, const CardWishes& wishes) {
  const ScenarioShot& shot = asked.shot();
  Card card{.asked = &asked, .units = wishes.units, .flight = fly_shot(asked.scenario, shot)};
  if (card.flight.error()) return refusal(asked.scenario, shot, card.flight);
  if (wishes.scenario_ranges) card.ranges = asked.scenario.ranges;
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
