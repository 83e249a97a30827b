#include "output_answer.hpp"

#include <nlohmann/json.hpp>

#include "output_number.hpp"
#include "output_trajectory.hpp"
#include "physim/version.hpp"

namespace physim::cli {
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

std::string replay_json(const std::string& file, const Replay& player) {
  const ReplayReport& r = player.report();
  Json out = {{"version", kVersion},
              {"recording", file},
              {"made_by", r.made_by},
              {"complete", r.complete},
              {"bytes", r.bytes},
              {"calls", r.calls},
              {"steps", r.steps},
              {"hashes", r.hashes},
              {"restores", r.restores},
              {"time [s]", player.world().time()},
              {"spawned", r.spawned},
              {"projectiles", player.world().size()},
              {"hash", hex(player.world().hash())},
              {"equal", !r.difference},
              {"difference", nullptr}};
  if (r.difference)
    out["difference"] = {{"step", r.difference->step},
                         {"time [s]", r.difference->time},
                         {"call", r.difference->call},
                         {"what", r.difference->what},
                         {"recorded", hex(r.difference->recorded_hash)},
                         {"replayed", hex(r.difference->replayed_hash)},
                         {"byte", r.difference->place}};
  return json_text(out);
}

}  // namespace physim::cli
