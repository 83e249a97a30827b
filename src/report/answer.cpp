#include "report/answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "physim/names.hpp"
#include "physim/result.hpp"
#include "physim/units.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"
#include "scenario/suggest.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;
using namespace units;

Json solution_json(const AimSolution& s) {
  return {{"elevation [rad]", s.launch.elevation},
          {"azimuth [rad]", s.launch.azimuth},
          {"time [s]", s.time},
          {"miss [m]", s.miss},
          {"position [m]", vector_json(s.position)},
          {"velocity [m/s]", vector_json(s.velocity)},
          {"speed [m/s]", s.speed},
          {"descent [rad]", s.descent},
          {"flights", s.flights}};
}

std::string vector_text(const Vec3d& v) {
  return "(" + as_typed(v.x) + ", " + as_typed(v.y) + ", " + as_typed(v.z) + ")";
}

Table solutions_table(const std::vector<std::pair<std::string, const AimSolution*>>& list) {
  Table table(
      {"", "elevation [deg]", "azimuth [deg]", "time [s]", "speed [m/s]", "descent [deg]", "miss [mm]", "flights"},
      "l");
  for (const auto& [name, s] : list)
    table.add_row({name, fixed(s->launch.elevation / kDegree, 5), fixed(s->launch.azimuth / kDegree, 5),
                   fixed(s->time, 4), fixed(s->speed, 2), fixed(s->descent / kDegree, 2), readable(s->miss * 1e3, 3),
                   s->flights > 0 ? std::to_string(s->flights) : ""});
  return table;
}

/// The name of what was met.
std::string met_thing(const AimOptions& options, const Event& hit) {
  PHYSIM_ASSERT(options.scene != nullptr);
  const auto thing = options.scene->instance(hit.instance);
  return thing ? thing->name : "";
}

Json hit_json(const AimOptions& options, const Event& hit) {
  return {{"thing", met_thing(options, hit)},
          {"time [s]", hit.time},
          {"position [m]", vector_json(hit.position)},
          {"velocity [m/s]", vector_json(hit.velocity)}};
}

/// What stands in the ways to the target, and in the line to it.
std::string obstacles_text(const AimOptions& options, const Aim& aim) {
  if (options.scene == nullptr) return "";
  Table table({"blocked at [deg]", "azimuth [deg]", "by", "at [s]", "x [m]", "y [m]", "z [m]", "speed [m/s]"}, "rrlr");
  for (const BlockedWay& way : aim.blocked)
    table.add_row({fixed(way.solution.launch.elevation / kDegree, 5), fixed(way.solution.launch.azimuth / kDegree, 5),
                   one_line(met_thing(options, way.hit)), fixed(way.hit.time, 4), fixed(way.hit.position.x, 3),
                   fixed(way.hit.position.y, 3), fixed(way.hit.position.z, 3), fixed(length(way.hit.velocity), 2)});
  std::string text = table.empty() ? "" : "\n" + table.text(2);
  if (aim.sight_ends)
    text += "\n  " + in_quotes(one_line(met_thing(options, *aim.sight_ends))) + " hides the target from the muzzle\n";
  return text;
}

/// "0.462 kg/m^2 +- 0.003"; without the error where that is 0.
std::string with_error(double value, double error, const std::string& unit) {
  return significant(value, 6) + unit + (error > 0 ? " +- " + significant(error, 2) : "");
}

/// What was scaled, and what came out.
Table fitted_table(const Fit& fit, const FitUnits& units, bool fits_speed) {
  Table table({"fitted", "value"}, "ll");
  const DragDef& d = fit.projectile.drag;
  PHYSIM_ASSERT(fit.scale > 0);
  const auto add = [&](const char* setting, double value, const std::string& unit) {
    table.add_row({setting, with_error(value, value * (fit.scale_error / fit.scale), unit)});
  };
  if (d.ballistic_coefficient > 0) {
    add("drag.ballistic_coefficient", d.ballistic_coefficient, " kg/m^2");
    add("", d.ballistic_coefficient / 1_lb_in2, " lb/in^2");
  } else if (!d.bands.empty()) {
    for (const BallisticBand& band : d.bands)
      add("drag.bands", band.ballistic_coefficient, " kg/m^2 above " + significant(band.above, 4) + " m/s");
  } else {
    add("drag.form_factor", d.form_factor, "");
  }
  if (d.k1 > 0) add("drag.k1", d.k1, " kg/s");
  if (d.k2 > 0) add("drag.k2", d.k2, " kg/m");
  if (d.damping < 1) table.add_row({"drag.damping", significant(d.damping, 6)});
  const FitUnit& u = units.speed;
  if (fits_speed)
    table.add_row({"speed", with_error(fit.launch.speed / u.size, fit.muzzle_speed_error / u.size, " " + u.name)});
  return table;
}

std::string fit_text(std::span<const Measurement> measurements, const FitUnits& units, bool fits_speed,
                     const Fit& fit) {
  const FitUnit& length = units.range;
  Table table({"range [" + length.name + "]", "quantity", "measured", "computed", "off", "unit"}, "rlrrrl");
  for (const FitResidual& r : fit.residuals) {
    PHYSIM_ASSERT(r.measurement < measurements.size());
    const double range = measurements[r.measurement].range;
    const FitUnit& unit = r.quantity == "speed" ? units.speed : r.quantity == "drop" ? units.drop : units.time;
    const auto shown = [&](double figure) { return (unit.is_angle ? std::atan2(figure, range) : figure) / unit.size; };
    table.add_row({as_typed(range / length.size), r.quantity, significant(shown(r.measured), 6),
                   significant(shown(r.computed), 6), significant(shown(r.computed) - shown(r.measured), 2),
                   unit.name});
  }
  return "  drag is " + with_error(fit.scale, fit.scale_error, " of the scenario's") + "\n\n" +
         fitted_table(fit, units, fits_speed).text(2) + "\n" + table.text(2) + "\n  off by " + significant(fit.rms, 3) +
         " of the errors that were given, root mean square; " + std::to_string(fit.flights) + " trajectories flown\n";
}

struct SuvatColumn {
  const char* title;
  std::optional<double> SuvatGiven::*given;
  double Suvat::*found;
};
constexpr std::array<SuvatColumn, 5> kSuvatColumns = {{{"s [m]", &SuvatGiven::s, &Suvat::s},
                                                       {"u [m/s]", &SuvatGiven::u, &Suvat::u},
                                                       {"v [m/s]", &SuvatGiven::v, &Suvat::v},
                                                       {"a [m/s^2]", &SuvatGiven::a, &Suvat::a},
                                                       {"t [s]", &SuvatGiven::t, &Suvat::t}}};

}  // namespace

std::string title_of_shot(const AskedShot& asked) {
  PHYSIM_ASSERT(asked.index < asked.scenario.shots.size());
  return one_line(title_of(asked.scenario)) + ": " + one_line(asked.shot().projectile.name);
}

Answer about_shot(const AskedShot& asked, const Style& style, const std::string& text, Json members) {
  PHYSIM_ASSERT(members.is_object());
  return {style.bold(title_of_shot(asked)) + "\n" + text, [&asked, members = std::move(members)](const Sink& sink) {
            JsonStream out(sink);
            out.object();
            add_provenance(out, asked.scenario);
            out.add({{"shot", asked.shot().projectile.name}});
            out.add(members);
            out.close();
          }};
}

Answer aim_answer(const AskedShot& asked, const Target& t, const AimOptions& options, const Aim& aim,
                  const Style& style) {
  std::string text = "  target at " + vector_text(t.position) + " m";
  if (t.velocity != Vec3d{}) text += ", moving at " + vector_text(t.velocity) + " m/s";
  if (t.acceleration != Vec3d{}) text += ", accelerating by " + vector_text(t.acceleration) + " m/s^2";
  std::vector<std::pair<std::string, const AimSolution*>> list;
  const bool one = aim.low && aim.high && aim.low->time == aim.high->time;
  if (aim.low) list.emplace_back(one ? "only" : "low", &*aim.low);
  if (aim.high && !one) list.emplace_back("high", &*aim.high);
  PHYSIM_ASSERT(aim.in_reach() == !list.empty());
  if (list.empty()) list.emplace_back("nearest", &aim.nearest);
  text += "\n\n" + solutions_table(list).text(2);
  if (!aim.in_reach()) text += "\n  " + style.bad(aim.explanation()) + "\n";
  text += obstacles_text(options, aim);
  text += "\n  " + std::to_string(aim.flights) + " trajectories flown\n";
  Json out = {{"target",
               {{"position [m]", vector_json(t.position)},
                {"velocity [m/s]", vector_json(t.velocity)},
                {"acceleration [m/s^2]", vector_json(t.acceleration)},
                {"tolerance [m]", options.tolerance}}},
              {"in_reach", aim.in_reach()},
              {"explanation", aim.explanation()}};
  if (aim.low) out["low"] = solution_json(*aim.low);
  if (aim.high) out["high"] = solution_json(*aim.high);
  out["nearest"] = solution_json(aim.nearest);
  if (options.scene != nullptr) {
    Json& blocked = out["blocked"] = Json::array();
    for (const BlockedWay& way : aim.blocked) {
      blocked.push_back(solution_json(way.solution));
      blocked.back()["hit"] = hit_json(options, way.hit);
    }
    out["sight_ends"] = aim.sight_ends ? hit_json(options, *aim.sight_ends) : Json();
  }
  out["flights"] = aim.flights;
  return about_shot(asked, style, text, out);
}

Answer fit_answer(const AskedShot& asked, std::span<const Measurement> measurements, const FitUnits& units,
                  bool fits_speed, const Fit& fit, const Style& style) {
  const DragDef& d = fit.projectile.drag;
  Json out = {{"scale", fit.scale},
              {"scale_error", fit.scale_error},
              {"drag",
               {{"ballistic_coefficient [kg/m^2]", d.ballistic_coefficient},
                {"form_factor", d.form_factor},
                {"k1 [kg/s]", d.k1},
                {"k2 [kg/m]", d.k2},
                {"damping", d.damping}}}};
  if (fits_speed) {
    out["speed [m/s]"] = fit.launch.speed;
    out["speed_error [m/s]"] = fit.muzzle_speed_error;
  }
  out["rms"] = fit.rms;
  Json residuals = Json::array();
  for (const FitResidual& r : fit.residuals)
    residuals.push_back(
        {{"measurement", r.measurement}, {"quantity", r.quantity}, {"measured", r.measured}, {"computed", r.computed}});
  out["residuals"] = std::move(residuals);
  out["flights"] = fit.flights;
  return about_shot(asked, style, fit_text(measurements, units, fits_speed, fit), out);
}

Answer max_range_answer(const AskedShot& asked, const MaxRange& far, const Style& style) {
  const Vec3d& x = far.position;
  return about_shot(asked, style,
                    "  farthest   " + readable(far.range, 7) + " m along the ground, at an elevation of " +
                        fixed(far.elevation / kDegree, 3) + " deg\n  impact     after " + fixed(far.time, 4) +
                        " s at (" + readable(x.x, 7) + ", " + readable(x.y, 5) + ", " + readable(x.z, 5) + ") m, " +
                        fixed(length(far.velocity), 2) + " m/s\n  " + std::to_string(far.flights) +
                        " trajectories flown\n",
                    {{"elevation [rad]", far.elevation},
                     {"range [m]", far.range},
                     {"time [s]", far.time},
                     {"position [m]", vector_json(x)},
                     {"velocity [m/s]", vector_json(far.velocity)},
                     {"flights", far.flights}});
}

Answer danger_space_answer(const AskedShot& asked, const Flight& flight, double range, double height,
                           const DangerSpace& space, const Style& style) {
  PHYSIM_ASSERT(space.from <= space.to);
  return about_shot(
      asked, style,
      "  a target " + as_typed(height) + " m high at " + as_typed(range) + " m is hit from " + fixed(space.from, 2) +
          " m to " + fixed(space.to, 2) + " m: over " + fixed(space.to - space.from, 2) + " m\n" +
          (space.ends_with_flight ? "  " + style.warn("it ends there") +
                                        " because the flight does: " + std::string(name(flight.outcome())) + "\n"
                                  : ""),
      {{"range [m]", range},
       {"height [m]", height},
       {"from [m]", space.from},
       {"to [m]", space.to},
       {"ends_with_flight", space.ends_with_flight},
       {"outcome", name(flight.outcome())}});
}

Answer suvat_answer(const SuvatGiven& given, std::span<const Suvat> motions) {
  PHYSIM_ASSERT(!motions.empty());
  PHYSIM_ASSERT(motions.size() <= 2);
  std::vector<std::string> titles;
  nlohmann::ordered_json asked = nlohmann::ordered_json::object(), found = nlohmann::ordered_json::array();
  for (const SuvatColumn& column : kSuvatColumns) {
    titles.emplace_back(column.title);
    if (given.*column.given) asked[column.title] = *(given.*column.given);
  }
  Table table(titles);
  for (const Suvat& motion : motions) {
    std::vector<std::string> cells;
    nlohmann::ordered_json& row = found.emplace_back(nlohmann::ordered_json::object());
    for (const SuvatColumn& column : kSuvatColumns) {
      cells.push_back(significant(motion.*column.found, 6));
      row[column.title] = motion.*column.found;
    }
    table.add_row(std::move(cells));
  }
  std::string text = table.text(2);
  if (std::ranges::any_of(motions, [](const Suvat& motion) { return motion.t < 0; }))
    text += "  t < 0: before the start\n";
  return {text,
          as_text(json_text({{"version", kVersion}, {"given", std::move(asked)}, {"motions", std::move(found)}}))};
}

}  // namespace physim::report
