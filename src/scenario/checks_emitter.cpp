// Checks of [[emitter]]: what it names exists, and its definition makes sense; errors have its line.

#include "base/assert.hpp"
#include "emit/emission.hpp"
#include "scenario/checks.hpp"
#include "scenario/scene_maker.hpp"
#include "scenario/suggest.hpp"

namespace physim {
namespace {

/// An error of the library about an emitter, as one of the file; its settings have the library's paths.
Error in_file(const Error& error, const Value& table) {
  constexpr std::string_view kEmitter = "emitter.", kSubs = "subs", kSub = "sub";
  std::string path = error.place;
  if (path.starts_with(kEmitter)) path.erase(0, kEmitter.size());
  if (path.starts_with(kSubs)) path.replace(0, kSubs.size(), kSub);
  const std::string name = path.empty() ? "emitter" : std::string(kEmitter) + path;
  return {name + ": " + error.message, follow(table, path).nearest.place.text(), error.hint};
}

Status check_gun(const ScenarioNames& names, const ScenarioEmitter& emitter, const Value& table) {
  const bool has_tracer = !emitter.tracer.empty(), fires_tracers = emitter.def.gun.tracer_every > 0;
  if (fires_tracers && !has_tracer)
    return error_at(table, "emitter.gun.tracer_every", "there is no tracer", "name a shot: tracer = \"...\"");
  if (!has_tracer) return {};
  const std::string place = place_of(table, "gun.tracer");
  if (!fires_tracers) return Error{"emitter.gun.tracer: no round is one", place, "say which: tracer_every = 5"};
  return check_named(names.shots, emitter.tracer, "shot", "emitter.gun.tracer", place);
}

Status check_subs(const Scenario& scenario, const ScenarioNames& names, const ScenarioEmitter& emitter,
                  const Value& table) {
  for (std::size_t i = 0; i < emitter.subs.size(); ++i) {
    const ScenarioSub& sub = emitter.subs[i];
    const Value& of_sub = element(table, "sub", i);
    const std::string place = place_of(of_sub, "emitter");
    if (Status status = check_named(names.emitters, sub.emitter, "emitter", "emitter.sub.emitter", place); !status)
      return status;
    if (sub.def.on == SubEvent::apex && !scenario.world.def.apex_events)
      return Error{"emitter.sub.on: no event says when a particle is at its apex", place_of(of_sub, "on"),
                   "write apex_events = true into [world]"};
  }
  return {};
}

/// Where it is: with a shot, on a path, or at rest.
Status check_place(const ScenarioNames& names, const ScenarioEmitter& emitter, const Value& table) {
  const Value* given = table.find("motion");
  const Value empty{.content = Table{}, .place = table.place, .end = {}, .raw = {}};
  const Value& motion = given != nullptr ? *given : empty;
  const EmitterDef& def = emitter.def;
  if (Status status = check_motion("emitter", emitter.motion, def.position, emitter.rotation, table, motion); !status)
    return status;
  if (emitter.follows.empty()) return {};
  const std::string place = place_of(table, "follows");
  if (motion_of(emitter.motion).index() != 0)
    return Error{"emitter.follows: given together with motion", place, "give one of them"};
  return check_lone_shot(names, emitter.follows, "emitter.follows", place);
}

Status check_emitter(const Scenario& scenario, const ScenarioNames& names, const ScenarioEmitter& emitter,
                     const Value& table) {
  const std::string place = place_of(table, "shot");
  if (Status status = check_named(names.shots, emitter.shot, "shot", "emitter.shot", place); !status) return status;
  if (Status status = check_place(names, emitter, table); !status) return status;
  if (Status status = check_gun(names, emitter, table); !status) return status;
  if (Status status = check_subs(scenario, names, emitter, table); !status) return status;
  const Status status = check(def_of(emitter));
  return status ? Status() : Status(in_file(status.error(), table));
}

}  // namespace

Status check_emitters(const Scenario& scenario, const ScenarioNames& names, const Value& document) {
  for (std::size_t i = 0; i < scenario.emitters.size(); ++i) {
    const ScenarioEmitter& emitter = scenario.emitters[i];
    PHYSIM_ASSERT(!emitter.def.name.empty());  // given or made up by now
    const Value& table = element(document, "emitter", i);
    const std::string& name = emitter.def.name;
    const bool is_taken = (names.shots.has(name) && names.is_alone(name)) || names.volleys.has(name);
    if (is_taken || names.emitters.find(name) != i)
      return error_at(table, "emitter.name", "another emitter, volley or shot is named " + in_quotes(name),
                      "give it a name of its own");
    if (Status status = check_emitter(scenario, names, emitter, table); !status) return status;
  }
  const auto order = order_of_emitters(scenario, names.emitters);
  if (order) return {};
  const Value& table = element(document, "emitter", *names.emitters.find(order.error().place));
  return error_at(table, "emitter.sub", order.error().message, order.error().hint);
}

}  // namespace physim
