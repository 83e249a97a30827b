#include "simclient/core/state_log.hpp"

#include <nlohmann/json.hpp>

#include "physim/names.hpp"
#include "report/json.hpp"
#include "simclient/core/timeline.hpp"

namespace physim::client {
namespace {

using Json = nlohmann::ordered_json;
using report::vector_json;

Json shot_state(Client& client) {
  const Launcher& launcher = client.launcher;
  const Fidelity& fidelity = launcher.shot().projectile.fidelity;
  const Fidelity& granted = client.prediction().granted.fidelity;
  const auto setting = launcher.elevation_setting();
  Json original;
  if (launcher.is_original())
    original = {{"motion", name(launcher.original_motion())},
                {"drag", name(launcher.original_drag())},
                {"gravity", name(launcher.original_gravity())}};
  return {{"type", launcher.types()[launcher.type()].name},
          {"elevation_setting", setting ? Json(*setting) : Json()},
          {"elevation", launcher.elevation()},
          {"azimuth", launcher.azimuth()},
          {"speed", launcher.speed()},
          {"motion", name(fidelity.motion)},
          {"drag", name(fidelity.drag)},
          {"gravity", name(fidelity.gravity)},
          {"original", original},
          {"granted",
           {{"motion", name(granted.motion)}, {"drag", name(granted.drag)}, {"gravity", name(granted.gravity)}}}};
}

/// Figures that stand in the panel of a study, at its end or at a place.
Json figures_state(const StudyResult& result) {
  Json state = {{"shots", result.shots},
                {"not_arrived", result.not_arrived},
                {"figures", Json::array()},
                {"hits", Json::array()}};
  for (const QuantityResult& q : result.quantities)
    state["figures"].push_back({{"quantity", name(q.quantity)}, {"mean", q.mean.value}, {"deviation", q.deviation}});
  if (result.from_centre) state["cep"] = result.from_centre->r50;
  for (const HitResult& hit : result.hits)
    state["hits"].push_back(
        {{"target", hit.name}, {"probability", hit.probability.value}, {"low", hit.low}, {"high", hit.high}});
  return state;
}

/// The study at hand, at its end and at each place, and which of them is shown.
Json study_state(const StudyDesk& desk) {
  static constexpr std::string_view kStates[] = {"none", "running", "paused", "done"};
  const StudyRun& run = desk.run;
  Json state = {{"state", kStates[static_cast<int>(run.state())]}, {"dots", run.dots_shown()}};
  if (!run.result()) return state;
  state.update(figures_state(*run.result()));
  state["shown"] = shown_place(desk) ? desk.shown_at : "end";
  state["at"] = Json::array();
  for (std::size_t i = 0; i < run.result()->at.size(); ++i) {
    state["at"].push_back({{"place", place_text(run.plan()->study().at[i].event)}});
    state["at"].back().update(figures_state(run.result()->at[i]));
  }
  return state;
}

/// Where a point is seen in the window.
Json pixel(const Client& client, const Vec3d& point) {
  const auto seen = client.camera.project(point);
  return seen ? Json{seen->x + client.scene_corner.x, seen->y + client.scene_corner.y} : Json();
}

Json track_state(const Client& client, const Track& track) {
  const TrackSample& s = track.samples.back();
  return {{"number", track.number},
          {"name", track.name},
          {"colour", track.colour},
          {"status", name(track.status)},
          {"time", s.time},
          {"position", vector_json(s.position)},
          {"velocity", vector_json(s.velocity)},
          {"acceleration", vector_json(s.acceleration)},
          {"jerk", vector_json(s.jerk)},
          {"speed", length(s.velocity)},
          {"mass", s.mass},
          {"mach", s.mach},
          {"pixel", pixel(client, s.position)}};
}

Json timeline_state(Client& client) {
  const Timeline line = timeline_of(client);
  Json state = {{"begin", line.begin},
                {"end", line.end},
                {"now", line.now},
                {"known", line.known},
                {"from", {client.timeline_from.x, client.timeline_from.y}},
                {"to", {client.timeline_to.x, client.timeline_to.y}},
                {"ticks", Json::array()}};
  constexpr std::size_t kMost = 32;
  for (std::size_t i = 0; i < std::min(line.ticks.size(), kMost); ++i)
    state["ticks"].push_back({{"time", line.ticks[i].time}, {"kind", name(line.ticks[i].kind)}});
  if (client.cursor) state["cursor"] = *client.cursor;
  return state;
}

Json hit_state(const Client& client, const Hit& hit) {
  return {{"time", hit.time},
          {"shot", client.session.title_of(hit)},
          {"thing", hit.thing},
          {"material", hit.material},
          {"what", name(hit.outcome)},
          {"speed", hit.speed()},
          {"speed_after", hit.speed_after()},
          {"obliquity", hit.obliquity},
          {"depth", hit.depth},
          {"position", vector_json(hit.position)},
          {"pixel", pixel(client, hit.position)}};
}

Json thing_state(const Client& client, const ScenarioThing& thing) {
  return {{"name", thing.name},
          {"material", thing.material},
          {"position", vector_json(thing.position)},
          {"pixel", pixel(client, thing.position)}};
}

}  // namespace

std::string state_line(Client& client, std::uint64_t frame) {
  Json line = {{"frame", frame},
               {"time", client.session.time()},
               {"step", client.session.step()},
               {"paused", client.session.is_paused()},
               {"time_scale", client.session.time_scale()},
               {"time_scale_reached", client.session.time_scale_reached()},
               {"quality", name(client.quality.now)},
               {"alive", client.session.world().size()},
               {"subject", client.camera.cover(client.subject())},
               {"shot", shot_state(client)},
               {"tracks", Json::array()}};
  for (const Track& track : client.session.tracks()) line["tracks"].push_back(track_state(client, track));
  if (const auto arrow = client.arrow())
    line["arrow"] = {{"from", pixel(client, arrow->from)}, {"to", pixel(client, arrow->to)}};
  constexpr std::size_t kMostHits = 8, kMostThings = 32;  // the last ones: lines are read as they are written
  const auto& hits = client.session.hits().hits();
  const auto& things = client.session.scenario().things;
  line["hits"] = line["things"] = Json::array();
  for (std::size_t i = hits.size() - std::min(hits.size(), kMostHits); i < hits.size(); ++i)
    line["hits"].push_back(hit_state(client, hits[i]));
  for (std::size_t i = things.size() - std::min(things.size(), kMostThings); i < things.size(); ++i)
    line["things"].push_back(thing_state(client, things[i]));
  line["timeline"] = timeline_state(client);
  if (client.session.is_paused()) line["hash"] = client.session.world().hash();  // it costs as much as a step
  if (client.study.run.state() != StudyRun::State::none) line["study"] = study_state(client.study);
  if (client.filmed) line["filmed"] = *client.filmed;
  static constexpr std::string_view kDialogs[] = {"none", "open", "save", "gallery"};
  if (client.dialog != Dialog::none) line["dialog"] = kDialogs[static_cast<int>(client.dialog)];
  if (client.question) line["question"] = client.question->text;
  if (!client.messages().empty()) line["message"] = client.messages().back().text;
  return report::json_line(line);
}

}  // namespace physim::client
