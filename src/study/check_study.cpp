#include "study/plan.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <string_view>

#include "base/checker.hpp"
#include "study/correlation.hpp"
#include "study/impacts.hpp"
#include "study/paths.hpp"
#include "study/places.hpp"
#include "study/quantities.hpp"
#include "study/sobol.hpp"
#include "study/targets.hpp"

namespace physim {
namespace {

std::string numbered(const char* list, std::size_t i) { return std::string(list) + '[' + std::to_string(i) + ']'; }

Error placed(const Error& error, const std::string& place) {
  return {error.message, error.place.empty() ? place : place + '.' + error.place, error.hint};
}

std::string list_of_paths() {
  std::string text;
  for (const PathRow& row : all_paths()) text += (text.empty() ? "one of " : ", ") + row.path;
  return text;
}

/// A wind by compass has a speed and a side that it comes from, and nothing else beside it.
Status check_compass(const Study& study, const PathRow& row, const std::string& place) {
  if (row.compass == CompassWind::none) return {};
  const auto is_drawn = [&](auto PathRow::*member, auto value) {
    return std::ranges::any_of(study.inputs, [&](const StudyInput& input) {
      const FoundPath path = find_path(input.path);
      return path && (*path.row).*member == value;
    });
  };
  if (is_drawn(&PathRow::weather, &Weather::wind_x) || is_drawn(&PathRow::weather, &Weather::wind_z))
    return Error{"the wind is drawn by compass and by components", place, "draw it in one of the two ways"};
  const Wind& wind = study.environment.wind;
  if (!wind.profile.empty())
    return Error{"a wind by compass is the same everywhere, and the environment has a profile", place,
                 "leave the profile out, or let components be `added` to it"};
  if (wind.velocity.x != 0 || wind.velocity.z != 0) return {};
  if (row.compass == CompassWind::speed && !is_drawn(&PathRow::compass, CompassWind::from))
    return Error{"is the speed of a wind that comes from nowhere", place,
                 "draw environment.wind.from, too, or give environment.wind.velocity"};
  if (row.compass == CompassWind::from && !is_drawn(&PathRow::compass, CompassWind::speed))
    return Error{"is where no wind comes from", place,
                 "draw environment.wind.speed, too, or give environment.wind.velocity"};
  return {};
}

/// A point of a list must be there.
Status check_point(const Study& study, const FoundPath& path, const std::string& place) {
  if (!path.row->is_of_list()) return {};
  Shot shot{study.projectile, study.launch};
  Environment environment = study.environment;
  if (path.point_of(shot, environment)) return {};
  const std::string list = path.row->path.substr(0, path.row->path.find(".N"));
  if (const std::size_t points = path.points(shot, environment))
    return Error{list + " has no point " + std::to_string(path.point), place,
                 points == 1 ? "it has one, with the number 1" : "its points are 1 to " + std::to_string(points)};
  if (list == "shot.drag.curve" && study.projectile.drag.table != DragTable::custom)
    return Error{"the projectile has no drag curve of its own, and so no points of it", place,
                 "draw shot.drag.form_factor, or give a curve and the table 'custom'"};
  return Error{list + " has no points", place, "give the list of which a point is uncertain"};
}

Status check_path(const Study& study, std::size_t i) {
  const StudyInput& input = study.inputs[i];
  const std::string place = numbered("inputs", i) + ".path";
  const FoundPath path = find_path(input.path);
  if (!path) return Error{"no number of a shot is called \"" + input.path + "\"", place, list_of_paths()};
  if (input.path == "shot.elevation" && !input.added && study.launch.sight.zero_range > 0)
    return Error{"an elevation is drawn, and the zero range gives another", place,
                 "let what is drawn be `added` to it (+- without a mean), or leave the zero range out"};
  const Wind& wind = study.environment.wind;
  const bool moves_all = !path.row->is_of_list() && !wind.profile.empty();
  if (path.row->is_wind && (wind.field || (moves_all && !input.added)))
    return Error{"an uncertain wind is the same everywhere, and the environment has a profile", place,
                 "leave the profile out, or let what is drawn be `added` to it"};
  if (const Status status = check_compass(study, *path.row, place); !status) return status;
  if (const Status status = check_point(study, path, place); !status) return status;
  const AirModel asked = study.fidelity.air, there = study.environment.atmosphere.model;  // the simpler one is flown
  const bool has_own_density = asked == AirModel::isa && there == AirModel::isa;
  if (path.row->weather == &Weather::density && has_own_density)
    return Error{"a density is drawn for constant and exponential air, and this is isa", place,
                 "draw temperature, pressure and humidity"};
  const bool is_of_station = path.row->weather == &Weather::temperature || path.row->weather == &Weather::pressure ||
                             path.row->weather == &Weather::humidity;
  if (is_of_station && !study.environment.atmosphere.profile.empty())
    return Error{input.path + " is that of a station, and the environment has air by levels", place,
                 "leave the profile out, or draw something else"};
  for (std::size_t j = 0; j < i; ++j)
    if (study.inputs[j].path == input.path && !study.inputs[j].added && !input.added)
      return Error{input.path + " is drawn by " + numbered("inputs", j) + " already", place,
                   "let one of the two be `added`"};
  return {};
}

void check_inputs(Checker& c, const Study& study, bool of_flights) {
  const std::size_t count = study.inputs.size();
  c.require(count >= 1, "inputs", "are none: nothing is uncertain", "name a number, and how it is distributed");
  c.require(count <= 64, "inputs", "are more than 64");
  const std::size_t dimensions = count * (study.indices ? 2 : 1);
  c.require(study.sampling != Sampling::sobol || dimensions <= kSobolDimensions, "sampling",
            "Sobol's sequence has 64 dimensions here; with indices each input takes two", "draw Latin hypercubes");
  for (std::size_t i = 0; i < count; ++i) {
    if (const Status status = check(study.inputs[i].distribution); !status)
      c.also(placed(status.error(), numbered("inputs", i) + ".distribution"));
    c.require(static_cast<unsigned>(study.inputs[i].drawn_for) <= 1, numbered("inputs", i) + ".drawn_for",
              "is none of the named values");
    c.require(study.inputs[i].drawn_for != DrawnFor::occasion || study.rounds > 1, "rounds",
              "an occasion has one shot, and " + numbered("inputs", i) + " is drawn once for all shots of an occasion",
              "say how many shots an occasion has");
    if (of_flights) c.also(check_path(study, i));
  }
}

void check_sizes(Checker& c, const Study& study) {
  constexpr std::uint64_t kMostShots = std::uint64_t{1} << 50;
  c.named(study.sampling, "sampling");
  c.require(study.shots >= 1 && study.shots <= kMostShots, "shots", "must be from 1 to 2^50");
  c.require(study.shard_shots >= 16 && study.shard_shots <= 65536, "shard_shots", "must be from 16 to 65536");
  c.require(study.rounds >= 1, "rounds", "must be one or more");
  c.require(!study.over_inputs || (*study.over_inputs >= 2 && *study.over_inputs <= 100), "over_inputs",
            "must be from 2 to 100 parts");
  c.require(!study.over_inputs || !study.targets.empty(), "over_inputs", "asks for hits, and there is no target",
            "name one, such as a circle");
  if (!c.status_so_far()) return;
  c.require(
      study.shard_shots % study.rounds == 0, "rounds",
      std::to_string(study.rounds) + " do not divide the " + std::to_string(study.shard_shots) + " shots of a shard",
      "choose shard_shots that are a multiple of them");
  if (study.sampling != Sampling::sobol) return;
  c.require(std::has_single_bit(study.shard_shots), "shard_shots", "must be a power of two for Sobol's sequence");
  c.require(study.rounds == 1, "rounds", "Sobol's sequence knows no occasions", "draw at random or Latin hypercubes");
}

void check_plane(Checker& c, const Study& study) {
  const bool has_plane = study.quantities.empty() || has_plane_axes(study.quantities);  // none: those of the rule
  c.is_number(study.aim.right, "aim.right").is_number(study.aim.up, "aim.up");
  const auto is_thing = [](const StudyTarget& target) { return std::holds_alternative<ThingTarget>(target.shape); };
  c.require(has_plane || std::ranges::all_of(study.targets, is_thing), "targets",
            "lie on a plane: ask for two lengths first");
  for (std::size_t i = 0; i < study.targets.size(); ++i) c.also(check(study.targets[i], numbered("targets", i)));
  std::map<std::string_view, std::size_t> named;
  for (std::size_t i = 0; i < study.targets.size(); ++i) {
    const std::string& name = study.targets[i].name;
    const auto [first, is_new] = named.emplace(name, i);
    c.require(name.empty() || is_new, numbered("targets", i),
              "has the name \"" + name + "\" of " + numbered("targets", first->second), "give it a name of its own");
  }
  for (const std::uint32_t size : study.group_sizes)
    c.require(size >= 2 && size <= 100, "group_sizes", "must be from 2 to 100 shots");
}

/// Impacts need something to be met.
void check_impacts(Checker& c, const Study& study) {
  if (study.scene) return;
  for (std::size_t i = 0; i < study.quantities.size(); ++i) {
    if (!is_of_impact(study.quantities[i])) continue;
    const std::string place = numbered("quantities", i);
    c.require(!study.until.range, place, "is of an impact, and shots end at until.range before they meet anything",
              "leave the range out, let things stand in the way, or ask for the speed there");
    c.require(study.until.ground.has_value(), place, "is of an impact, and there is neither ground nor things",
              "give until.ground");
  }
}

void check_quantities(Checker& c, const Study& study, bool of_flights) {
  for (std::size_t i = 0; i < study.quantities.size(); ++i) {
    c.named(study.quantities[i], numbered("quantities", i));
    const auto before = study.quantities.begin() + static_cast<std::ptrdiff_t>(i);
    c.require(std::find(study.quantities.begin(), before, study.quantities[i]) == before, numbered("quantities", i),
              "is asked for twice");
  }
  if (of_flights) check_impacts(c, study);
  if (!study.until_width) return;
  c.positive(study.until_width->width, "until_width.width");
  const std::size_t usual = study.scene ? 5 : 4;
  const std::size_t quantities = study.quantities.empty() ? usual : study.quantities.size();
  c.require(!study.until_width->target || *study.until_width->target < study.targets.size(), "until_width.target",
            "there is no such target");
  c.require(study.until_width->quantity < quantities, "until_width.quantity", "there is no such quantity");
}

}  // namespace

Status check(const Study& study, bool of_flights, std::vector<Error>* all) {
  Checker c(all);
  check_sizes(c, study);
  check_inputs(c, study, of_flights);
  check_plane(c, study);
  if (c.status_so_far()) c.also(check_things(study, of_flights));
  check_quantities(c, study, of_flights);
  if (c.status_so_far()) c.also(check_places(study, of_flights));
  if (of_flights)
    c.require(!study.launch.velocity, "launch.velocity", "has no numbers of its own in a study",
              "give a speed, an elevation and an azimuth");
  else
    c.require(!study.quantities.empty(), "quantities", "must name the columns that the function fills");
  return c.status();
}

Result<std::vector<InputGroup>> groups_of(const Study& study) {
  std::vector<InputGroup> groups;
  std::vector<bool> taken(study.inputs.size());
  for (std::size_t i = 0; i < study.correlated.size(); ++i) {
    const StudyCorrelation& with = study.correlated[i];
    const std::string place = numbered("correlated", i);
    std::vector<std::string> names;
    for (const std::size_t input : with.inputs) {
      if (input >= study.inputs.size())
        return Error{"there is no input " + std::to_string(input), place + ".inputs", ""};
      if (taken[input]) return Error{study.inputs[input].path + " is correlated twice", place + ".inputs", ""};
      if (study.inputs[input].drawn_for != study.inputs[with.inputs[0]].drawn_for)
        return Error{
            study.inputs[input].path + " is drawn more or less often than " + study.inputs[with.inputs[0]].path,
            place + ".inputs", "correlate what is drawn together"};
      taken[input] = true;
      names.push_back(study.inputs[input].path);
    }
    if (with.inputs.empty()) return Error{"names no inputs", place + ".inputs", ""};
    auto root = correlation_root(with.matrix, names, place + ".matrix");
    if (!root) return root.error();
    groups.push_back({with.inputs, std::move(*root)});
  }
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (!taken[i]) groups.push_back({{i}, {}});
  return groups;
}

}  // namespace physim
