#include "report/answer.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;

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

/// What every answer about a shot begins with.
Json begin_answer(const AskedShot& asked) {
  Json out = provenance(asked.scenario);
  out["shot"] = asked.shot().projectile.name;
  return out;
}

// ---------------------------------------------------------------------------------------------------------------- text
constexpr double kDegree = std::numbers::pi / 180;

std::string vector_text(const Vec3d& v) {
  return "(" + as_typed(v.x) + ", " + as_typed(v.y) + ", " + as_typed(v.z) + ")";
}

Table solutions_table(const std::vector<std::pair<std::string, const AimSolution*>>& list) {
  Table table({{"", Align::left},
               {"elevation [deg]"},
               {"azimuth [deg]"},
               {"time [s]"},
               {"speed [m/s]"},
               {"descent [deg]"},
               {"miss [mm]"},
               {"flights"}});
  for (const auto& [name, s] : list)
    table.add_row({name, fixed(s->launch.elevation / kDegree, 5), fixed(s->launch.azimuth / kDegree, 5),
                   fixed(s->time, 4), fixed(s->speed, 2), fixed(s->descent / kDegree, 2), readable(s->miss * 1e3, 3),
                   s->flights > 0 ? std::to_string(s->flights) : ""});
  return table;
}

/// What was scaled, and what came out.
std::vector<std::pair<std::string, std::string>> fitted_figures(const Fit& fit) {
  std::vector<std::pair<std::string, std::string>> out;
  const DragDef& d = fit.projectile.drag;
  const double relative = fit.scale_error / fit.scale;
  const auto add = [&](const char* setting, double value, const std::string& unit) {
    std::string text = significant(value, 6) + unit;
    if (relative > 0) text += " +- " + significant(value * relative, 2);
    out.emplace_back(setting, text);
  };
  constexpr double kPoundPerSquareInch = 0.45359237 / (0.0254 * 0.0254);
  if (d.ballistic_coefficient > 0) {
    add("drag.ballistic_coefficient", d.ballistic_coefficient, " kg/m^2");
    add("", d.ballistic_coefficient / kPoundPerSquareInch, " lb/in^2");
  } else if (!d.bands.empty()) {
    for (const BallisticBand& band : d.bands)
      add("drag.bands", band.ballistic_coefficient, " kg/m^2 above " + significant(band.above, 4) + " m/s");
  } else {
    add("drag.form_factor", d.form_factor, "");
  }
  if (d.k1 > 0) add("drag.k1", d.k1, " kg/s");
  if (d.k2 > 0) add("drag.k2", d.k2, " kg/m");
  if (d.damping < 1) out.emplace_back("drag.damping", significant(d.damping, 6));
  return out;
}

}  // namespace

std::string aim_json(const AskedShot& asked, const Target& target, double tolerance, const Aim& aim) {
  Json out = begin_answer(asked);
  out["target"] = {{"position [m]", vector_json(target.position)},
                   {"velocity [m/s]", vector_json(target.velocity)},
                   {"acceleration [m/s^2]", vector_json(target.acceleration)},
                   {"tolerance [m]", tolerance}};
  out["in_reach"] = aim.in_reach();
  out["explanation"] = aim.explanation();
  if (aim.low) out["low"] = solution_json(*aim.low);
  if (aim.high) out["high"] = solution_json(*aim.high);
  out["nearest"] = solution_json(aim.nearest);
  out["flights"] = aim.flights;
  return json_text(out);
}

std::string fit_json(const AskedShot& asked, bool fits_speed, const Fit& fit) {
  Json out = begin_answer(asked);
  const DragDef& d = fit.projectile.drag;
  out["scale"] = fit.scale;
  out["scale_error"] = fit.scale_error;
  out["drag"] = {{"ballistic_coefficient [kg/m^2]", d.ballistic_coefficient},
                 {"form_factor", d.form_factor},
                 {"k1 [kg/s]", d.k1},
                 {"k2 [kg/m]", d.k2},
                 {"damping", d.damping}};
  if (fits_speed) {
    out["speed [m/s]"] = fit.launch.speed;
    out["speed_error [m/s]"] = fit.muzzle_speed_error;
  }
  out["rms"] = fit.rms;
  out["residuals"] = Json::array();
  for (const FitResidual& r : fit.residuals)
    out["residuals"].push_back(
        {{"measurement", r.measurement}, {"quantity", r.quantity}, {"measured", r.measured}, {"computed", r.computed}});
  out["flights"] = fit.flights;
  return json_text(out);
}

std::string max_range_json(const AskedShot& asked, const MaxRange& far) {
  Json out = begin_answer(asked);
  out["elevation [rad]"] = far.elevation;
  out["range [m]"] = far.range;
  out["time [s]"] = far.time;
  out["position [m]"] = vector_json(far.position);
  out["velocity [m/s]"] = vector_json(far.velocity);
  out["flights"] = far.flights;
  return json_text(out);
}

std::string danger_space_json(const AskedShot& asked, double range, double height, const DangerSpace& space) {
  Json out = begin_answer(asked);
  out["range [m]"] = range;
  out["height [m]"] = height;
  out["from [m]"] = space.from;
  out["to [m]"] = space.to;
  return json_text(out);
}

std::string answer_heading(const AskedShot& asked, const Style& style) {
  return style.bold(one_line(title_of(asked.scenario)) + ": " + one_line(asked.shot().projectile.name)) + "\n";
}

std::string aim_text(const AskedShot& asked, const Target& t, const Aim& aim, const Style& style) {
  std::string out = answer_heading(asked, style);
  out += "  target at " + vector_text(t.position) + " m";
  if (t.velocity != Vec3d{}) out += ", moving at " + vector_text(t.velocity) + " m/s";
  if (t.acceleration != Vec3d{}) out += ", accelerating by " + vector_text(t.acceleration) + " m/s^2";
  out += "\n\n";
  std::vector<std::pair<std::string, const AimSolution*>> list;
  const bool one = aim.low && aim.high && aim.low->launch.elevation == aim.high->launch.elevation;
  if (aim.low) list.emplace_back(one ? "only" : "low", &*aim.low);
  if (aim.high && !one) list.emplace_back("high", &*aim.high);
  if (list.empty()) list.emplace_back("nearest", &aim.nearest);
  out += solutions_table(list).text(2);
  if (!aim.in_reach()) out += "\n  " + style.bad(aim.explanation()) + "\n";
  return out + "\n  " + std::to_string(aim.flights) + " trajectories flown\n";
}

std::string fit_text(const AskedShot& asked, std::span<const Measurement> measurements, bool fits_speed, const Fit& fit,
                     const Style& style) {
  std::string out = answer_heading(asked, style);
  out += "  drag is " + significant(fit.scale, 6) + " of the scenario's";
  if (fit.scale_error > 0) out += " +- " + significant(fit.scale_error, 2);
  out += "\n\n";
  Table figures({{"fitted", Align::left}, {"value", Align::left}});
  for (const auto& [setting, text] : fitted_figures(fit)) figures.add_row({setting, text});
  if (fits_speed) {
    std::string text = significant(fit.launch.speed, 6) + " m/s";
    if (fit.muzzle_speed_error > 0) text += " +- " + significant(fit.muzzle_speed_error, 2);
    figures.add_row({"speed", text});
  }
  out += figures.text(2) + "\n";
  Table table({{"range [m]"}, {"quantity", Align::left}, {"measured"}, {"computed"}, {"off"}, {"unit", Align::left}});
  for (const FitResidual& r : fit.residuals) {
    const char* unit = r.quantity == "speed" ? "m/s" : r.quantity == "drop" ? "m" : "s";
    table.add_row({as_typed(measurements[r.measurement].range), r.quantity, significant(r.measured, 6),
                   significant(r.computed, 6), significant(r.computed - r.measured, 2), unit});
  }
  return out + table.text(2) + "\n  off by " + significant(fit.rms, 3) +
         " of the errors that were given, root mean square; " + std::to_string(fit.flights) + " trajectories flown\n";
}

std::string max_range_text(const AskedShot& asked, const MaxRange& far, const Style& style) {
  return answer_heading(asked, style) + "  farthest   " + readable(far.range, 7) +
         " m along the ground, at an elevation of " + fixed(far.elevation / kDegree, 3) + " deg\n  impact     after " +
         fixed(far.time, 4) + " s at (" + readable(far.position.x, 7) + ", " + readable(far.position.y, 5) + ", " +
         readable(far.position.z, 5) + ") m, " + fixed(length(far.velocity), 2) + " m/s\n  " +
         std::to_string(far.flights) + " trajectories flown\n";
}

std::string danger_space_text(const AskedShot& asked, double range, double height, const DangerSpace& space,
                              const Style& style) {
  return answer_heading(asked, style) + "  a target " + as_typed(height) + " m high at " + as_typed(range) +
         " m is hit from " + fixed(space.from, 2) + " m to " + fixed(space.to, 2) + " m: over " +
         fixed(space.to - space.from, 2) + " m\n";
}

}  // namespace physim::report
