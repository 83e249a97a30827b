#include "simclient/core/state_log.hpp"

#include <nlohmann/json.hpp>

#include "physim/names.hpp"

namespace physim::client {
namespace {

using Json = nlohmann::ordered_json;

Json vector(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json shot_state(const Launcher& launcher) {
  const Fidelity& fidelity = launcher.shot().projectile.fidelity;
  const auto setting = launcher.elevation_setting();
  return {{"type", launcher.types()[launcher.type()].name},
          {"elevation_setting", setting ? Json(*setting) : Json()},
          {"elevation", launcher.elevation()},
          {"azimuth", launcher.azimuth()},
          {"speed", launcher.speed()},
          {"motion", name(fidelity.motion)},
          {"drag", name(fidelity.drag)},
          {"gravity", name(fidelity.gravity)}};
}

Json track_state(const Track& track) {
  const TrackSample& s = track.samples.back();
  return {{"number", track.number},
          {"name", track.name},
          {"colour", track.colour},
          {"status", name(track.status)},
          {"time", s.time},
          {"position", vector(s.position)},
          {"velocity", vector(s.velocity)},
          {"acceleration", vector(s.acceleration)},
          {"speed", length(s.velocity)},
          {"mass", track.mass},
          {"mach", s.mach}};
}

}  // namespace

std::string state_line(const Client& client, std::uint64_t frame) {
  Json line = {{"frame", frame},
               {"time", client.session.time()},
               {"step", client.session.step()},
               {"paused", client.session.is_paused()},
               {"alive", client.session.world().size()},
               {"shot", shot_state(client.launcher)},
               {"tracks", Json::array()}};
  for (const Track& track : client.session.tracks()) line["tracks"].push_back(track_state(track));
  if (!client.messages().empty()) line["message"] = client.messages().back().text;
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace physim::client
