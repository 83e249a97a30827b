// The list of settings: complete, consistent, and the same through every door.
#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <sstream>

#include "scenario/run_support.hpp"
#include "scenario/schema.hpp"
#include "scenario/suggest.hpp"

namespace physim::scenario_settings_test {

/// One of every list, so that settings of list elements can be reached.
const std::string kOneOfEach = R"(physim = 1
[environment.wind]
profile = [{ at = 0 }]
[[shot]]
drag = { bands = [{ ballistic_coefficient = 100 }] }
magnus = { table = [{ speed = 10, spin = 100, drag = 0.3, lift = 0.2 }] }
[until]
events = [{ kind = "height" }]
[[expect]]
quantity = "drop"
equals = 0
within = 0
)";

/// The same of a world, where flights' own settings would be refused.
const std::string kOneOfEachInAWorld = R"(physim = 1
[world]
pools = [{ name = "a" }]
detail = { rungs = [{ fidelity = "simulation" }, { fidelity = "game" }] }
[[shot]]
[[volley]]
shot = "shot-1"
[[shot]]
name = "other"
)";

std::string part_of(const std::string& path, std::size_t number) {
  std::istringstream parts(path);
  std::string part;
  for (std::size_t i = 0; i <= number; ++i)
    if (!std::getline(parts, part, '.')) return "";
  return part;
}

/// A scene whose shape and material are of the kinds that a setting belongs to, with what these need.
std::string scene_for(const std::string& path) {
  const std::string list = part_of(path, 0), kind = part_of(path, 1);
  const bool deep = !part_of(path, 2).empty();
  const bool in_compound = deep && list == "shape" && kind == "compound";
  const std::string shape = list == "shape" && deep && !in_compound ? kind : "sphere";
  const std::string inside = shape == "hull"   ? "points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]"
                             : shape == "mesh" ? "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]]"
                             : shape == "height_field" ? "columns = 2, rows = 2, heights = [0, 0, 0, 0]"
                             : shape == "box"          ? "half = [1, 1, 1]"
                             : shape == "sphere"       ? "radius = 1"
                                                       : "radius = 1, half_height = 1";
  const std::string material = kind == "young"             ? "young = { s_number = 1 }"
                               : kind == "poncelet"        ? "poncelet = { strength = 1e6, inertia = 1 }"
                               : kind == "lambert"         ? "lambert = 4000"
                               : kind == "ballistic_limit" ? "ballistic_limit = \"300 m/s\""
                                                           : "";
  const std::string compound = "[[shape]]\ncompound = [{ shape = \"shape-1\" }]\n";
  const std::string keys = kind == "keys" ? "keys = [{}]\n" : "";
  return "[[material]]\ndensity = 1000\n" + material + "\n[[shape]]\n" +
         (path == "shape" || path == "shape.kind" ? "" : shape + " = { " + inside + " }\n") +
         (in_compound ? compound : "") + (path == "shape" ? "" : "[[thing]]\nshape = \"shape-1\"\n" + keys) +
         "[[force]]\n";
}

/// An emitter with the list that a setting belongs to.
std::string emitter_for(const std::string& path) {
  const auto is_in = [&path](const std::string& list) { return path.starts_with("emitter." + list + "."); };
  const std::string inside = is_in("motion.keys")   ? "motion = { keys = [{}] }\n"
                             : is_in("bursts")      ? "bursts = [{}]\n"
                             : is_in("gun.barrels") ? "gun = { barrels = [{}] }\n"
                             : is_in("sub")         ? "sub = [{ emitter = \"emitter-1\" }]\n"
                                                    : "";
  return path == "emitter" ? "" : "[[emitter]]\nshot = \"shot-1\"\n" + inside;
}

std::string joint_for(const std::string& path) { return path == "joint" ? "" : "[[joint]]\na = \"other\"\n"; }

bool is_of_worlds(const std::string& path) {
  for (const char* table : {"world", "volley", "force", "emitter", "joint", "material", "shape", "thing", "shot.body"})
    if (path == table || path.starts_with(std::string(table) + ".")) return true;
  return false;
}

/// The law that a setting of a force belongs to, with what it requires; any other where it is of all laws.
std::string law_of(const std::string& path) {
  constexpr std::string_view kForce = "force.";
  const std::size_t dot = path.find('.', kForce.size());
  const std::string law = path.starts_with(kForce) && dot != path.npos ? path.substr(6, dot - 6) : "gravity_force";
  const std::string points = "curve = [{ time = 0, force = 1 }, { time = 2000, force = 1 }]";
  const std::string required = law == "spring"      ? "other = \"other\""
                               : law == "thrust"    ? points
                               : law == "wind_zone" ? "low = [-2, -2, -2], high = [2, 2, 2]"
                                                    : "";
  return law + " = { " + required + " }\n";
}

/// Levels stand in the place of a station.
std::string air_for(const std::string& path) {
  return path.starts_with("environment.atmosphere.profile.") ? "[environment.atmosphere]\nprofile = [{}]\n" : "";
}

Result<Scenario> with_override(const std::string& path, const std::string& value) {
  const std::vector<std::string> overrides = {path + "=" + value};
  return parse_scenario(is_of_worlds(path)
                            ? kOneOfEachInAWorld + emitter_for(path) + joint_for(path) + scene_for(path) + law_of(path)
                            : kOneOfEach + air_for(path),
                        "f.toml", overrides);
}

TEST(Settings, AreDescribed) {
  std::set<std::string> paths;
  for (const Setting& setting : settings()) {
    EXPECT_TRUE(paths.insert(setting.path).second) << setting.path << " is listed twice";
    EXPECT_FALSE(setting.type.empty()) << setting.path;
    EXPECT_FALSE(setting.doc.empty()) << setting.path;
    EXPECT_NE(setting.type == "choice", setting.range.find('|') == std::string::npos) << setting.path;
    EXPECT_NE(find_node(setting.path), nullptr) << setting.path;
  }
  EXPECT_GT(paths.size(), 80U);
}

TEST(Settings, HaveTheDefaultsOfTheLibrary) {
  std::map<std::string, Setting> by_path;
  for (const Setting& setting : settings()) by_path.emplace(setting.path, setting);
  EXPECT_EQ(by_path.at("shot.mass").default_value, "1 kg");
  EXPECT_EQ(by_path.at("shot.mass").unit, "kg");
  EXPECT_EQ(by_path.at("shot.mass").range, "> 0");
  EXPECT_EQ(by_path.at("shot.mass").type, "quantity");
  EXPECT_EQ(by_path.at("shot.drag.table").default_value, "constant");
  EXPECT_EQ(by_path.at("shot.drag.table").type, "choice");
  EXPECT_EQ(by_path.at("shot.force_duration").default_value, "inf s");
  EXPECT_EQ(by_path.at("shot.velocity").default_value, "none");
  EXPECT_EQ(by_path.at("environment.gravity.radius").default_value, "6356766 m");
  EXPECT_EQ(by_path.at("environment.atmosphere.humidity").range, "0 .. 1");
  EXPECT_EQ(by_path.at("environment.wind.velocity").default_value, R"(["0 m/s", "0 m/s", "0 m/s"])");
  EXPECT_EQ(by_path.at("environment.wind.profile").range, "0 .. 100000");
  EXPECT_EQ(by_path.at("until.ground").default_value, "0 m");
  EXPECT_EQ(by_path.at("until.events.value").unit, "of the kind");
  EXPECT_EQ(by_path.at("shot.fidelity.preset").default_value, "");
  EXPECT_EQ(by_path.at("shot.fidelity.integrator").default_value, "adaptive");
  EXPECT_EQ(Fidelity{}, Fidelity::small_arms());
  EXPECT_EQ(by_path.at("shot.sight.zero_in_calm_air").type, "boolean");
  EXPECT_EQ(by_path.at("tolerance.max_steps").default_value, "1000000");
  EXPECT_EQ(by_path.at("shot.drag.curve").type, "points");
}

/// Lists that must hold something, and numbers without which their table means nothing: their defaults fit nothing.
bool is_needed(const std::string& path) {
  constexpr std::string_view kNeeded[] = {"shape.hull.points",
                                          "shape.mesh.vertices",
                                          "shape.mesh.triangles",
                                          "shape.height_field.columns",
                                          "shape.height_field.rows",
                                          "shape.height_field.heights",
                                          "material.young.s_number",
                                          "material.ballistic_limit.speed",
                                          "shape"};
  return std::ranges::count(kNeeded, path) > 0;
}

/// Settings with a default of their own; "" are required or say nothing by themselves. A curve of thrust has two points
/// at different times, so the defaults of its points fit no list.
std::vector<Setting> with_default() {
  std::vector<Setting> list;
  for (const Setting& setting : settings())
    if (!setting.default_value.empty() && setting.path != "shot" && !setting.path.starts_with("force.thrust.curve") &&
        !is_needed(setting.path))
      list.push_back(setting);
  return list;
}

// Also proves that every default is in its own range.
TEST(Settings, AcceptTheirOwnDefault) {
  for (const Setting& setting : with_default()) {
    const Result<Scenario> scenario = with_override(setting.path, setting.default_value);
    EXPECT_TRUE(scenario.ok()) << setting.path << "=" << setting.default_value << "\n" << scenario.error().text();
  }
}

TEST(Settings, AreAllReachableByAnOverride) {
  for (const Setting& setting : settings()) {
    const Result<Scenario> scenario = with_override(setting.path, "{ no_such_key = 1 }");
    if (setting.type == "text") continue;  // takes any text
    ASSERT_FALSE(scenario.ok()) << setting.path;
    EXPECT_EQ(scenario.error().place, "--set " + setting.path + "={ no_such_key = 1 }") << setting.path;
  }
}

TEST(Settings, RefuseWhatIsOutOfRange) {
  int checked = 0;
  for (const Setting& setting : settings()) {
    if (setting.type != "quantity" && setting.type != "drawn") continue;
    EXPECT_FALSE(with_override(setting.path, "nan").ok()) << setting.path;
    constexpr std::string_view kTakeInfinity[] = {"shot.force_duration",        "tolerance.max_step",
                                                  "shot.body.despawn.below",    "shot.body.despawn.farther",
                                                  "shot.body.despawn.older",    "world.detail.rungs.within",
                                                  "world.detail.rungs.younger", "force.duration",
                                                  "shot.magnus.decay_time",     "emitter.start.lifetime",
                                                  "emitter.from.surface.low_x", "emitter.from.surface.high_x",
                                                  "emitter.from.surface.low_z", "emitter.from.surface.high_z",
                                                  "emitter.trail.time",         "emitter.flight.limit"};
    const bool takes_infinity = std::ranges::count(kTakeInfinity, setting.path) > 0 ||
                                setting.path == "shape.mesh.reach";  // to the ends of the file
    EXPECT_EQ(with_override(setting.path, "inf").ok(), takes_infinity) << setting.path;
    if (setting.range.empty()) continue;
    EXPECT_FALSE(with_override(setting.path, "-1e7").ok()) << setting.path << " " << setting.range;
    ++checked;
  }
  EXPECT_GT(checked, 30);
}

// -------------------------------------------------------------------------------------------------- effective settings
const std::string kEverything = R"(physim = 1
title = "with \"quotes\", a \\ and\na line break"
source = "7"
[environment]
altitude = "1234.567 ft"
gravity = { model = "constant", acceleration = 9.8123456789 }
earth = { latitude = "-33.3 deg", azimuth = "123.4 deg", rotation_rate = 1e-4 }
[environment.atmosphere]
model = "exponential"
temperature = "15.3 degC"
pressure = "29.53 inHg"
humidity = "37 %"
density = 1.1
sound_speed = 333
station_altitude = 12
scale_height = 7000
[environment.wind]
velocity = ["1 mph", 2e-9, "-0.1 kn"]
by = "range"
interpolation = "step"
profile = [{ at = 0.1, velocity = [0.1, 0, 1e-17] }, { at = "100 yd", velocity = [1, 2, 3] }]
[[shot]]
name = ".308 168 gr"
mass = "168 gr"
diameter = "0.308 in"
length = "1.2 in"
twist = "-11.25 in"
force = [0.1, -0.0, 3]
force_duration = 1.5
position = ["1 in", "1 ft", "1 yd"]
sight = { height = "2.5 in", look_angle = "1 moa", cant = "3 deg", zero_range = "100 yd", zero_in_calm_air = true }
speed = "2650 ft/s"
azimuth = "-0.7 deg"
fidelity = { preset = "artillery", integrator = "rk4", planar = true, original_one_shot_forces = true }
[shot.drag]
table = "custom"
coefficient = 0.3
curve = [[0, 0.1], [0.7, 0.123456789012345678], [3, 1e-5]]
form_factor = 0.98
damping = 0.995
k1 = 1e-12
k2 = 0.3
ballistic_coefficient = "0.218 lb/in^2"
[[shot]]
name = "b"
velocity = [1e9, 1e-9, 0.1]
drag = { table = "g1", bands = [{ above = "2800 ft/s", ballistic_coefficient = "0.447 lb/in^2" },
                                { ballistic_coefficient = 300 }] }
fidelity = { preset = "classic", cheapest_within = "1 mm" }
[tolerance]
relative = 1e-13
absolute = 3e-9
step = "1.7 ms"
position_error = "1 um"
max_step = 0.3
max_steps = 123456789
[until]
ground = "off"
time = "1 h"
range = "1 mi"
events = [{ kind = "mach", value = 1.2, direction = "falling" },
          { kind = "ground", value = "3 ft", terminal = true }, { kind = "apex" }]
[output]
ranges = "100 yd .. 1000 yd step 100 yd"
[[expect]]
shot = "b"
at = { range = "500 yd" }
quantity = "drop"
equals = "-57.1 in"
within = "0.3 in"
published = true
source = "a book = good"
[[expect]]
at = "apex"
quantity = "energy"
equals = "2000 ft lbf"
within = 10
)";

std::vector<std::string> as_overrides(const Scenario& scenario) {
  std::vector<std::string> overrides;
  for (const auto& [path, value] : effective_settings(scenario)) overrides.push_back(path + "=" + value);
  return overrides;
}

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

TEST(EffectiveSettings, ReproduceTheScenarioBitForBit) {
  const Scenario a = parsed(kEverything);
  const Scenario b = parsed(
      "physim = 1\n[[shot]]\nname = \".308 168 gr\"\n[[shot]]\nname = \"b\"\nfidelity = \"game\"\n", as_overrides(a));
  EXPECT_EQ(effective_settings(a), effective_settings(b));  // texts are bit for bit, see Quantities
  EXPECT_EQ(b.title, a.title);
  EXPECT_EQ(b.source, "7");
  EXPECT_TRUE(same_bits(a.tolerance.step, b.tolerance.step));
  EXPECT_TRUE(same_bits(a.environment.earth, b.environment.earth));
  EXPECT_TRUE(same_bits(a.environment.wind.velocity, b.environment.wind.velocity));
  EXPECT_TRUE(same_bits(a.environment.wind.profile.at(1), b.environment.wind.profile.at(1)));
  EXPECT_EQ(a.environment.atmosphere.pressure, b.environment.atmosphere.pressure);
  EXPECT_EQ(a.ranges, b.ranges);
  EXPECT_EQ(b.until.ground, std::nullopt);
  ASSERT_EQ(b.shots.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const ScenarioShot &one = a.shots[i], &two = b.shots[i];
    EXPECT_EQ(one.projectile.fidelity, two.projectile.fidelity);
    EXPECT_EQ(one.cheapest_within, two.cheapest_within);
    EXPECT_TRUE(same_bits(one.projectile.mass, two.projectile.mass));
    EXPECT_TRUE(same_bits(one.projectile.force, two.projectile.force)) << "the sign of zero counts too";
    EXPECT_TRUE(same_bits(one.launch.position, two.launch.position));
    EXPECT_EQ(one.launch.velocity, two.launch.velocity);
    EXPECT_TRUE(same_bits(one.launch.sight.look_angle, two.launch.sight.look_angle));
  }
  EXPECT_TRUE(same_bits(a.shots[0].projectile.drag.curve.at(1), b.shots[0].projectile.drag.curve.at(1)));
  EXPECT_TRUE(same_bits(a.shots[1].projectile.drag.bands.at(0), b.shots[1].projectile.drag.bands.at(0)));
  ASSERT_EQ(b.expect.size(), 2U);
  EXPECT_EQ(b.expect[0].at, ExpectAt::range);
  EXPECT_EQ(b.expect[0].source, "a book = good");
  EXPECT_TRUE(b.expect[0].published);
  EXPECT_FALSE(b.expect[1].published);
  EXPECT_TRUE(same_bits(a.expect[0].equals, b.expect[0].equals));
  EXPECT_EQ(b.expect[1].at, ExpectAt::apex);
}

TEST(EffectiveSettings, OfDefaultsReproduceThemToo) {
  const Scenario a = parsed("physim = 1\n[[shot]]\n");
  EXPECT_EQ(effective_settings(parsed(kOneOfEach.substr(0, 10) + "\n[[shot]]\n", as_overrides(a))),
            effective_settings(a));
}

TEST(EffectiveSettings, NameEveryShotAndSetting) {
  const Scenario scenario = parsed(kEverything);
  std::map<std::string, std::string> lines;
  for (const auto& [path, value] : effective_settings(scenario)) EXPECT_TRUE(lines.emplace(path, value).second) << path;
  EXPECT_EQ(lines.at("physim"), "1");
  EXPECT_EQ(lines.at("shot..308 168 gr.drag.table"), "custom");
  EXPECT_EQ(lines.at("shot.b.drag.bands"),
            R"([{ above = "853.44 m/s", ballistic_coefficient = "314.27210209870424 kg/m^2" }, )"
            R"({ above = "0 m/s", ballistic_coefficient = "300 kg/m^2" }])");
  EXPECT_EQ(lines.at("until.ground"), "off");
  EXPECT_EQ(lines.at("shot.b.fidelity.integrator"), "classic");
  EXPECT_EQ(lines.at("source"), "7");
  EXPECT_EQ(lines.at("title"), R"("with \"quotes\", a \\ and\u000Aa line break")");
  for (const Setting& setting : settings()) {
    const bool in_list = setting.path.find("profile.") != std::string::npos || setting.path.starts_with("expect.") ||
                         setting.path.find("bands.") != std::string::npos ||
                         setting.path.find("magnus.table.") != std::string::npos ||
                         setting.path.starts_with("until.events.");
    if (in_list || setting.path == "shot" || setting.path.ends_with("preset") || setting.path == "shot.motor.file" ||
        is_of_worlds(setting.path))
      continue;
    std::string path = setting.path;
    if (path.starts_with("shot.")) path.insert(5, "b.");
    EXPECT_TRUE(lines.contains(path)) << path;
  }
}

// --------------------------------------------------------------------------------------------------------- suggestions
TEST(Suggestions, CountEdits) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("velocty", "velocity"), 1U);    // insert
  EXPECT_EQ(edit_distance("velocityy", "velocity"), 1U);  // delete
  EXPECT_EQ(edit_distance("velosity", "velocity"), 1U);   // replace
  EXPECT_EQ(edit_distance("veloctiy", "velocity"), 1U);   // swap
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(Suggestions, AreNearOrNone) {
  const std::string_view words[] = {"mass", "diameter", "g7", "speed"};
  EXPECT_EQ(nearest("msas", words), "mass");
  EXPECT_EQ(nearest("MASS", words), "mass");
  EXPECT_EQ(nearest("diametre", words), "diameter");
  EXPECT_EQ(nearest("weight", words), "");
  EXPECT_EQ(nearest("g8", words), "");
  EXPECT_EQ(nearest(std::string(1000000, 'x'), words), "");
  EXPECT_EQ(suggestion("x", words, "known keys"), "known keys: mass, diameter, g7, speed");
}

TEST(Suggestions, ShortenLongQuotes) {
  EXPECT_EQ(in_quotes("a\nb"), "\"a b\"");
  const std::string shortened = in_quotes(std::string(59, 'x') + "é" + std::string(100, 'y'));
  EXPECT_EQ(shortened, "\"" + std::string(59, 'x') + "...\"") << "no half characters";
}

}  // namespace physim::scenario_settings_test
