#include "report/range_card.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/summary.hpp"

namespace physim::report {
namespace {

std::string shown(double value, const ShownUnit& unit) { return fixed(value / unit.size, unit.decimals); }
std::string header(const std::string& what, const ShownUnit& unit) { return what + " [" + unit.name + "]"; }

struct CardTexts {
  std::vector<std::string> headers;
  std::vector<std::vector<std::string>> rows;  // only the range where the shot does not reach it
};

CardTexts texts_of(const Card& card) {
  const CardUnits& u = card.units;
  std::vector<CrossWind> shifts = card.winds;
  if (card.without_spin) shifts.push_back({"spin", card.flight, *card.without_spin});
  CardTexts out;
  out.headers = {header("range", u.range), header("drop", u.drop), header("drop", u.angle), header("windage", u.drop),
                 header("windage", u.angle)};
  for (const CrossWind& shift : shifts)
    out.headers.insert(out.headers.end(), {header(shift.label, u.drop), header(shift.label, u.angle)});
  out.headers.insert(out.headers.end(), {header("speed", u.speed), "mach [-]", header("energy", u.energy), "time [s]"});
  for (const double range : card.ranges) {
    std::vector<std::string>& row = out.rows.emplace_back(1, as_typed(range / u.range.size));
    const Result<Sample> s = card.flight.at_range(range);
    if (!s) continue;
    const auto add_offset = [&](double offset) {
      row.push_back(shown(offset, u.drop));
      row.push_back(range > 0 ? shown(std::atan2(offset, range), u.angle) : "-");
    };
    add_offset(s->drop);
    add_offset(s->windage);
    for (const CrossWind& shift : shifts) {
      const Result<Sample> blown = shift.blown.at_range(range), calm = shift.calm.at_range(range);
      if (blown && calm)
        add_offset(blown->windage - calm->windage);
      else
        row.insert(row.end(), 2, "-");
    }
    row.insert(row.end(), {shown(s->speed, u.speed), fixed(s->mach, 3), shown(s->energy, u.energy), fixed(s->time, 3)});
    PHYSIM_ASSERT(row.size() == out.headers.size());
  }
  return out;
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
  CardTexts texts = texts_of(card);
  Table table(std::move(texts.headers));
  for (std::vector<std::string>& row : texts.rows) {
    if (row.size() == 1) row.emplace_back("not reached");
    table.add_row(std::move(row));
  }
  return table;
}

Records records_of(const Card& card) {
  CardTexts texts = texts_of(card);
  const std::size_t count = texts.headers.size();
  return {std::move(texts.headers), [rows = std::move(texts.rows), count](const auto& take) {
            for (const auto& row : rows) {
              std::vector<Cell> cells(row.begin(), row.end());
              cells.resize(count);
              take(cells);
            }
          }};
}

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
