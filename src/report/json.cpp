#include "report/json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "physim/result.hpp"
#include "report/fidelity_text.hpp"
#include "report/summary.hpp"
#include "scenario/schema.hpp"
#include "scenario/writer.hpp"

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

// ------------------------------------------------------------------------------------------------------------ assumed
/// Defaults that nobody gave and that mattered to a flight: it ends elsewhere where they are a little different.
class Assumed {
 public:
  Assumed(const FlownScenario& flown, std::size_t shot)
      : flown_(flown), scenario_(flown.scenario), shot_(shot), changed_(flown.scenario), end_(flight().end()) {}

  [[nodiscard]] Json list() {
    Json all = Json::array();
    for (const char* table : {"environment", "until", "shot"}) look_into(*find_node(table), all);
    return all;
  }

 private:
  [[nodiscard]] const Flight& flight() const { return flown_.shots[shot_].flight; }

  void look_into(const SchemaNode& node, Json& all) {
    for (const SchemaNode& child : node.children) {
      if (child.entry == nullptr) {
        if (child.path != "shot.fidelity") look_into(child, all);  // what was granted is told
      } else if (!child.is_list_of_tables()) {
        look_at(child, all);
      }
    }
  }

  void look_at(const SchemaNode& node, Json& all) {
    constexpr std::string_view kShot = "shot.";
    const std::string path =
        node.path.starts_with(kShot)
            ? std::string(kShot) + scenario_.shots[shot_].projectile.name + "." + node.path.substr(kShot.size())
            : node.path;
    if (is_given(path)) return;
    changed_.environment = scenario_.environment;
    changed_.until = scenario_.until;
    changed_.shots[shot_] = scenario_.shots[shot_];
    const Scope scope{.scenario = &changed_, .shot = &changed_.shots[shot_]};
    const auto value = written(*node.entry, scope);
    if (value && change(*node.entry, scope) && ends_elsewhere()) all.push_back({{"path", path}, {"value", *value}});
  }

  /// A table, or a value that stands for one, gives all that is in it.
  [[nodiscard]] bool is_given(const std::string& path) const {
    for (std::size_t end = path.find('.'); end != path.npos; end = path.find('.', end + 1))
      if (std::ranges::binary_search(scenario_.given, path.substr(0, end))) return true;
    return std::ranges::binary_search(scenario_.given, path);
  }

  /// A number that is a little different, within its range; itself where there is none.
  static double another(const Entry& entry, double value) {
    constexpr double kPart = 0.01, kLittle = 0.01;
    const double by = value == 0 ? kLittle : kPart * std::abs(value);
    if (entry.range.contains(value + by)) return value + by;
    return entry.range.contains(value - by) ? value - by : value;
  }

  /// Gives a setting another value; false where there is none to be tried.
  static bool change(const Entry& entry, const Scope& scope) {
    const ValueRef at = entry.slot(scope);
    return std::visit(Overloaded{[&](double* x) { return std::isfinite(*x) && (*x = another(entry, *x), true); },
                                 [&](const OptionalNumber& x) {
                                   const std::optional<double> now = x.get();
                                   if (now && !std::isfinite(*now)) return false;
                                   x.set(now ? another(entry, *now) : usual(entry.quantity));
                                   return true;
                                 },
                                 [&](Vec3d* v) {
                                   for (double* x : {&v->x, &v->y, &v->z}) *x = another(entry, *x);
                                   return true;
                                 },
                                 [&](bool* x) { return *x = !*x, true; },
                                 [&](const Choice& choice) {
                                   const std::optional<std::size_t> now = choice.get();
                                   if (!now || choice.names.size() < 2) return false;
                                   choice.set((*now + 1) % choice.names.size());
                                   return true;
                                 },
                                 [](const auto&) { return false; }},
                      at);
  }
  /// What a number may be that is left to something else.
  static double usual(Quantity quantity) {
    if (quantity == Quantity::temperature) return 280;
    return quantity == Quantity::pressure ? 9e4 : 1;
  }

  [[nodiscard]] bool ends_elsewhere() const {
    const ScenarioShot& shot = changed_.shots[shot_];
    const Flight other = flown_.scene ? fly_shot(changed_, shot, *flown_.scene) : fly_shot(changed_, shot);
    if (other.error()) return false;
    constexpr double kRounding = 1e-7;
    const Sample end = other.end();
    const double moved = length(end.position - end_.position), slower = length(end.velocity - end_.velocity);
    return moved > kRounding * (1 + length(end_.position)) || slower > kRounding * (1 + end_.speed) ||
           std::abs(end.time - end_.time) > kRounding * (1 + end_.time);
  }

  const FlownScenario& flown_;
  const Scenario& scenario_;
  std::size_t shot_;
  Scenario changed_;
  Sample end_;
};

}  // namespace

Json assumed_json(const FlownScenario& flown, std::size_t shot) {
  constexpr std::size_t kMostShots = 20;
  constexpr std::int64_t kMostEvaluations = 200'000;  // of a flight that is flown again for each default
  const bool is_long = flown.shots[shot].flight.cost().evaluations > kMostEvaluations;
  return shot < kMostShots && !is_long ? Assumed(flown, shot).list() : Json();
}

void add_checks(JsonStream& out, const std::vector<Check>& checks) {
  out.list("expect");
  for (const Check& check : checks) out.push(check_json(check));
  out.close();
}

Json vector_json(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }

void add_provenance(JsonStream& out, const Scenario& scenario) {
  out.add({{"program", "physim"},
           {"version", kVersion},
           {"scenario", {{"file", scenario.file}, {"title", scenario.title}, {"source", scenario.source}}}});
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
