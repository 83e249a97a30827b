#include "report/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "physim/result.hpp"
#include "report/fidelity_text.hpp"
#include "report/summary.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;

Json fidelity_json(const Fidelity& fidelity) {
  Json out;
  for (const auto& [effect, rung] : fidelity_fields(fidelity))
    out[std::string(effect)] = rung == "true" || rung == "false" ? Json(rung == "true") : Json(rung);
  return out;
}

Json check_json(const Check& check) {
  PHYSIM_ASSERT(check.expectation != nullptr);
  PHYSIM_ASSERT(check.value || !check.met);
  const Expectation& expectation = *check.expectation;
  Json out = {{"shot", check.shot},
              {"at", place_text(expectation)},
              {"quantity", expectation.quantity},
              {"unit", unit_of(expectation.quantity)},
              {"value", check.value ? Json(*check.value) : Json()},
              {"equals", expectation.equals},
              {"within", expectation.within},
              {"met", check.met},
              {"source", expectation.source},
              {"place", expectation.place}};
  if (!check.value) out["error"] = check.value.error().message;
  return out;
}

}  // namespace

void add_checks(JsonStream& out, const std::vector<Check>& checks) {
  out.list("expect");
  for (const Check& check : checks) out.push(check_json(check));
  out.close();
}

Json vector_json(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }

void add_provenance(JsonStream& out, const Scenario& scenario, std::span<const std::string> more) {
  std::vector<std::string> notes = scenario.notes;
  notes.insert(notes.end(), more.begin(), more.end());
  out.add({{"program", "physim"},
           {"version", kVersion},
           {"scenario",
            {{"file", scenario.file}, {"title", scenario.title}, {"source", scenario.source}, {"notes", notes}}}});
  out.object("settings");
  each_setting(scenario, [&out](const std::string& path, const std::string& value) { out.add({{path, value}}); });
  out.close();
}

Json flight_json(const Flight& flight, const Fidelity& asked) {
  const FidelityInUse& in_use = flight.fidelity_in_use();
  Json notes = Json::array(), events = Json::array();
  for (const FidelityNote& note : in_use.notes)
    notes.push_back(
        {{"effect", note.effect}, {"asked", note.asked}, {"granted", note.granted}, {"reason", note.reason}});
  PHYSIM_ASSERT(std::ranges::is_sorted(flight.events(), {}, &Event::time));
  for (const Event& event : flight.events())
    events.push_back({{"kind", name(event.kind)},
                      {"value", event.value},
                      {"direction", name(event.direction)},
                      {"time [s]", event.time},
                      {"position [m]", vector_json(event.position)},
                      {"velocity [m/s]", vector_json(event.velocity)}});
  const FlightCost& cost = flight.cost();
  return {{"outcome", name(flight.outcome())},
          {"duration [s]", flight.duration()},
          {"elevation [rad]", flight.elevation()},
          {"fidelity_asked", fidelity_json(asked)},
          {"fidelity_granted", fidelity_json(in_use.fidelity)},
          {"fidelity_notes", std::move(notes)},
          {"notes", curve_notes(flight)},
          {"step [s]", flight.step()},
          {"cost", {{"steps", cost.steps}, {"rejected", cost.rejected}, {"evaluations", cost.evaluations}}},
          {"events", std::move(events)}};
}

std::string json_text(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string json_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace physim::report
