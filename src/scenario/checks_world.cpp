#include "scenario/checks.hpp"

#include "base/assert.hpp"
#include "model/force_laws.hpp"
#include "scenario/expectation.hpp"
#include "scenario/mistakes.hpp"
#include "scenario/schema.hpp"
#include "scenario/suggest.hpp"
#include "world/core/check.hpp"
#include "world/step/force_eval.hpp"

namespace physim {
namespace {

/// An error of the library about a part of the scenario, as one of the file.
Error in_file(const Error& error, const std::string& path, const Value& where) {
  return {path + (error.place.empty() ? "" : " (" + error.place + ")") + ": " + error.message, where.place.text(),
          error.hint};
}

Error needs_world(const std::string& path, const Value& value) {
  return {path + ": there is no [world] for it", value.place.text(), "write [world], and the shots fly in it"};
}

/// Flights read how a body meets things, where there are some, and its colour; nothing else that is in its tables.
Status check_body_keys(const std::string& path, const Value& table, const Scenario& scenario) {
  const Table* members = table.get<Table>();
  if (members == nullptr) return {};
  for (const Member& member : *members) {
    const std::string key = path + "." + member.key;
    const SchemaNode* node = find_node(key);
    PHYSIM_ASSERT(node != nullptr);  // the reader knows no others
    if (!is_of_flights(*node, scenario)) return needs_world(key, member.value);
    if (Status status = check_body_keys(key, member.value, scenario); !status) return status;
  }
  return {};
}

Status check_absence(const Scenario& scenario, const Value& document) {
  for (const std::string_view key : kWorldLists)
    if (const Value* value = document.find(key)) return needs_world(std::string(key), *value);
  for (std::size_t i = 0; i < scenario.shots.size(); ++i) {
    const Value* body = element(document, "shot", i).find("body");
    if (body == nullptr) continue;
    if (Status status = check_body_keys("shot.body", *body, scenario); !status) return status;
  }
  return {};
}

Status check_unused(const Value& document) {
  if (const Value* until = document.find("until"))
    return Error{"until: not used in a [world]", until->place.text(),
                 "world.duration and shot.body.despawn end things"};
  if (const Value* output = document.find("output"))
    return Error{"output: not used in a [world]", output->place.text(), "ranges are of single flights"};
  return {};
}

Status check_pools(const Scenario& scenario, const ScenarioNames& names, const Value& document) {
  const std::vector<PoolDef>& pools = scenario.world.def.pools;
  for (std::size_t i = 0; i < pools.size(); ++i)
    if (names.pools.find(pools[i].name) != i)
      return Error{"world.pools.name: two pools are named " + in_quotes(pools[i].name),
                   place_of(element(*document.find("world"), "pools", i), "name"), ""};
  for (std::size_t i = 0; i < scenario.shots.size(); ++i) {
    const std::string& pool = scenario.shots[i].pool;
    if (pool.empty() || names.pools.has(pool)) continue;
    return Error{"shot.body.pool: no pool is named " + in_quotes(pool),
                 place_of(*element(document, "shot", i).find("body"), "pool"),
                 pools.empty() ? "write pools = [{ name = \"...\", maximum = 100 }] into [world]"
                               : suggestion(pool, names.pools.all(), "pools")};
  }
  return {};
}

Status check_bodies(const Scenario& scenario, const Value& document) {
  for (std::size_t i = 0; i < scenario.shots.size(); ++i) {
    const Status status = check(scenario.shots[i].body, scenario.world.def, 1);
    if (status) continue;
    const Value& shot = element(document, "shot", i);
    const Value* body = shot.find("body");
    return in_file(status.error(), "shot", body ? *body : shot);
  }
  return {};
}

Status check_volleys(const Scenario& scenario, const ScenarioNames& names, const Value& document) {
  for (std::size_t i = 0; i < scenario.volleys.size(); ++i) {
    const Volley& volley = scenario.volleys[i];
    const Value& table = element(document, "volley", i);
    if (Status status = check_named(names.shots, volley.shot, "shot", "volley.shot", place_of(table, "shot")); !status)
      return status;
    const bool is_taken = names.shots.has(volley.name) && names.is_alone(volley.name);
    if (is_taken || names.volleys.find(volley.name) != i)
      return error_at(table, "volley.name", "another volley or shot is named " + in_quotes(volley.name),
                      "give it a name of its own");
    const Value* rate = table.find("rate");
    const std::string* text = rate ? rate->get<std::string>() : nullptr;
    if (rate && !(text && *text == "none") && table.find("interval"))
      return Error{"volley.rate: given together with interval", rate->place.text(), "give one of them"};
  }
  return {};
}

/// The tables of laws in a [[force]].
std::vector<const Member*> laws_of(const Value& force) {
  PHYSIM_ASSERT(force.get<Table>() != nullptr);
  std::vector<const Member*> laws;
  for (const Member& member : *force.get<Table>())
    if (const SchemaNode* node = find_node("force." + member.key); node && node->entry == nullptr)
      laws.push_back(&member);
  return laws;
}

std::vector<std::string_view> law_names() {
  std::vector<std::string_view> names;
  for (const SchemaNode& node : find_node("force")->children)
    if (node.entry == nullptr) names.push_back(node.name);
  return names;
}

Status check_other(const ScenarioNames& names, const ScenarioForce& force, const Member& law) {
  const std::string path = "force." + law.key + ".other", place = place_of(law.value, "other");
  return check_lone_shot(names, force.other, path, place);
}

Status check_force(const ScenarioNames& names, const ScenarioForce& force, const Value& table) {
  PHYSIM_ASSERT(!force.name.empty());  // given or made up by now
  const std::vector<const Member*> laws = laws_of(table);
  if (laws.empty())
    return Error{"force: it has no law", table.place.text(), suggestion("", law_names(), "give one of")};
  if (laws.size() > 1)
    return Error{"force: it has two laws, " + laws[0]->key + " and " + laws[1]->key, laws[1]->key_place.text(),
                 "write a [[force]] for each"};
  for (const std::string& shot : force.shots)
    if (Status status = check_named(names.shots, shot, "shot", "force.shots", place_of(table, "shots")); !status)
      return status;
  if (!force.other.empty() || needs_other_end(force.law))
    if (Status status = check_other(names, force, *laws[0]); !status) return status;
  ForceDef def{.law = force.law, .target = ForceTarget::everything(), .delay = force.delay, .duration = force.duration};
  if (needs_other_end(def.law)) *other_end_of(def.law) = {1, 1};  // any projectile
  if (const Status status = check(def); !status)
    return in_file(status.error(), "force." + laws[0]->key, laws[0]->value);
  return {};
}

Status check_group_expectation(const ScenarioNames& names, const Expectation& expect, const Value& table) {
  const bool is_counted = (names.shots.has(expect.shot) && names.is_alone(expect.shot)) ||
                          names.volleys.has(expect.shot) || names.emitters.has(expect.shot);
  if (!expect.shot.empty() && !is_counted)
    return error_at(table, "expect.shot", "nothing is counted as " + in_quotes(expect.shot),
                    suggestion(expect.shot, names.groups(), "there are"));
  if (expect.at != ExpectAt::end)
    return error_at(table, "expect.at", "a world is looked at when its run is over", "leave it out");
  const Figure* figure = find_figure(expect.quantity);
  PHYSIM_ASSERT(figure != nullptr);  // the reader knows no others
  if (!expect.thing.empty())
    if (Status status = check_thing_expectation(names, expect, table); !status) return status;
  const bool has_any = !names.emitters.all().empty();
  const bool has_emitter = expect.shot.empty() ? has_any : names.emitters.has(expect.shot);
  if (figure->is_of_emitters && !has_emitter)
    return error_at(table, "expect.quantity", in_quotes(expect.quantity) + " is a figure of emitters",
                    has_any ? "name one as expect.shot" : "there is no [[emitter]]");
  if (!figure->is_of_worlds())
    return error_at(table, "expect.quantity", in_quotes(expect.quantity) + " is a figure of single flights",
                    suggestion(expect.quantity, group_figure_names(), "in a world there are"));
  return {};
}

}  // namespace

Status check_named(const NameIndex& names, const std::string& name, const std::string& kind, const std::string& path,
                   const std::string& place) {
  if (names.has(name)) return {};
  return Error{path + ": no " + kind + " is named " + in_quotes(name), place,
               suggestion(name, names.all(), kind + "s")};
}

Status check_lone_shot(const ScenarioNames& names, const std::string& name, const std::string& path,
                       const std::string& place) {
  if (Status status = check_named(names.shots, name, "shot", path, place); !status) return status;
  if (names.of_volleys.contains(name))
    return Error{path + ": " + in_quotes(name) + " is fired by a volley", place,
                 "name a shot that no volley fires: there is one of it"};
  if (names.is_alone(name)) return {};
  return Error{path + ": " + in_quotes(name) + " is fired by an emitter", place,
               "name a shot that no emitter fires: there is one of it"};
}

void complete_world(Scenario& scenario, const Value& document) {
  scenario.world.given = document.find("world") != nullptr;
  name_each(scenario.volleys, "volley");
  name_each(scenario.joints, "joint");
  name_each(scenario.forces, "force");
  for (std::size_t i = 0; i < scenario.emitters.size(); ++i) {
    EmitterDef& def = scenario.emitters[i].def;
    if (def.name.empty()) def.name = "emitter-" + std::to_string(i + 1);
    const bool is_gun = def.gun.rounds_per_minute > 0;
    if (is_gun && element(document, "emitter", i).find("per_second") == nullptr) def.per_second = {0};
  }
  for (std::size_t i = 0; i < scenario.forces.size(); ++i) {
    ScenarioForce& force = scenario.forces[i];
    // A law without a single number is never read: its first setting makes it.
    for (const Member* law : laws_of(element(document, "force", i))) {
      const Scope scope{.force = &force};
      PHYSIM_ASSERT(law->value.get<Table>() != nullptr);
      if (law->value.get<Table>()->empty()) find_node("force." + law->key)->children.front().entry->slot(scope);
    }
  }
}

void check_world(const Scenario& scenario, const ScenarioNames& names, const Value& document, Mistakes& mistakes) {
  if (!scenario.world.given) {
    mistakes.take(check_absence(scenario, document));
    mistakes.take(check_bodies(scenario, document));
    mistakes.take(check_scene(scenario, document));
    return;
  }
  mistakes.take(check_unused(document));
  if (const Status status = check(scenario.world.def); !status)
    mistakes.take(in_file(status.error(), "world", *document.find("world")));
  mistakes.take(check_pools(scenario, names, document));
  mistakes.take(check_bodies(scenario, document));
  mistakes.take(check_scene(scenario, document));
  mistakes.take(check_volleys(scenario, names, document));
  for (std::size_t i = 0; i < scenario.forces.size() && !mistakes.is_full(); ++i)
    mistakes.take(check_force(names, scenario.forces[i], element(document, "force", i)));
  mistakes.take(check_given_names(scenario.forces, "force", document));
  mistakes.take(check_joints(scenario, names, document));
  mistakes.take(check_emitters(scenario, names, document));
  for (std::size_t i = 0; i < scenario.expect.size() && !mistakes.is_full(); ++i)
    mistakes.take(check_group_expectation(names, scenario.expect[i], element(document, "expect", i)));
}

}  // namespace physim
