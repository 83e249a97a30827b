// The declared list of settings, and the tree of tables and keys that it spans.
//
// A setting is one Entry: a row (settings/row.hpp) and where its value lives in a Scenario. The rows of public structs
// stand in src/settings, those of files alone in settings_*.cpp. Type and default are read from the field itself.
// Everything else is made from the list.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "base/members.hpp"
#include "physim/names.hpp"
#include "scenario/scenario.hpp"
#include "settings/row.hpp"

namespace physim {

/// The things that settings live in. Settings of list elements read the pointer of their element.
struct Scope {
  std::int64_t* format = nullptr;
  Scenario* scenario = nullptr;
  ScenarioShot* shot = nullptr;
  Expectation* expect = nullptr;
  EventSpec* event = nullptr;
  AirPoint* air_point = nullptr;
  WindPoint* wind_point = nullptr;
  BallisticBand* band = nullptr;
  MagnusPoint* magnus_point = nullptr;
  PoolDef* pool = nullptr;
  DetailRung* rung = nullptr;
  Volley* volley = nullptr;
  ScenarioForce* force = nullptr;
  Thrust::Point* thrust_point = nullptr;
  Material* material = nullptr;
  ScenarioShape* shape = nullptr;
  ScenarioThing* thing = nullptr;
  ScenarioKey* key = nullptr;
  ScenarioEmitter* emitter = nullptr;
  Burst* burst = nullptr;
  Barrel* barrel = nullptr;
  ScenarioSub* sub = nullptr;
  ScenarioJoint* joint = nullptr;
  ScenarioPart* part = nullptr;

  /// All of them, to be found by what they point to.
  [[nodiscard]] auto pointers() {
    return with_members(*this, [](auto&... each) { return std::tie(each...); });
  }
};

/// A number that may be absent.
template <class Number>
struct Optional {
  std::function<std::optional<Number>()> get;
  std::function<void(std::optional<Number>)> set;
};
using OptionalNumber = Optional<double>;
using OptionalInteger = Optional<std::int64_t>;

/// A whole number of any type.
struct Integer {
  std::function<std::int64_t()> get;
  std::function<void(std::int64_t)> set;
};

/// One of several names. Nothing: no name fits what is there (a fidelity that is no preset).
struct Choice {
  std::span<const std::string_view> names;
  std::function<std::optional<std::size_t>()> get;
  std::function<void(std::size_t)> set;
  std::string_view (*doc)(std::size_t) = nullptr;  // of a name, where it is known
};

/// Points of two numbers each; the first ones rise. Both have a name for messages: "Mach number".
struct Points {
  using Pairs = std::vector<std::pair<double, double>>;
  std::string_view names[2];
  Quantity quantities[2];
  std::function<Pairs()> get;
  std::function<void(const Pairs&)> set;
  Range ranges[2] = {{.low = 0}, {.low = 0}};
};

/// A text that stands for what is read where it points to, and is not written again. An error without a place is one
/// of the text.
struct Reference {
  std::function<Status(const std::string&)> follow;
};

/// A list of tables.
struct Records {
  std::function<std::size_t()> size;
  std::function<void(std::size_t)> resize;
  std::function<Scope(std::size_t)> element;
};

/// Indices of the vertices of a mesh.
using Triangle = std::array<std::uint32_t, 3>;

/// Where a setting's value is, and of which type it is.
using ValueRef =
    std::variant<double*, OptionalNumber, Vec3d*, std::optional<Vec3d>*, Integer, OptionalInteger, bool*, std::string*,
                 Reference, Choice, Points, AeroCoefficient*, DrawnNumber*, DrawnColour*, Gradient*,
                 std::vector<double>*, std::vector<std::string>*, std::vector<Vec3d>*, std::vector<Triangle>*, Records>;

/// One setting: a row, and where its value is in a scenario. Its path is the whole one.
struct Entry : SettingRow {
  ValueRef (*slot)(const Scope&) = nullptr;
  Quantity (*quantity_by)(const Scope&) = nullptr;  // where another setting decides the quantity
  std::string_view unit_by = {};                    // by which: "of the kind"
  bool (*is_there)(const Scope&) = nullptr;         // where another setting decides whether there is a value to write

  [[nodiscard]] Quantity quantity_in(const Scope& scope) const { return quantity_by ? quantity_by(scope) : quantity; }
};

/// The list, in the order in which settings are read and shown.
[[nodiscard]] std::span<const Entry> entries();

/// A table or key of the file: "shot.drag" has the children "table", "coefficient", ... and no entry.
struct SchemaNode {
  std::string name;  // last part of the path
  std::string path;
  const Entry* entry = nullptr;       // of keys and of lists of tables
  std::vector<SchemaNode> children;   // of tables and of lists of tables
  std::string shorthand;              // name of the child that may stand for the table
  const SchemaNode* above = nullptr;  // the table that it is in

  [[nodiscard]] const SchemaNode* find(std::string_view child) const;
  /// The child on the way to what is somewhere below.
  [[nodiscard]] const SchemaNode& child_towards(const SchemaNode& below) const {
    const SchemaNode* node = &below;
    while (node->above != this) node = node->above;
    return *node;
  }
  [[nodiscard]] bool is_list_of_tables() const { return entry != nullptr && !children.empty(); }
};

/// The root of the tree; its name and path are empty.
[[nodiscard]] const SchemaNode& schema();
/// The node of a path; null if not found.
[[nodiscard]] const SchemaNode* find_node(std::string_view path);
/// Lists of tables that only a scenario with a [world] has.
inline constexpr std::string_view kWorldLists[] = {"volley", "force", "emitter", "joint"};
/// Lists of tables that say what there is to hit, in a [world] and for single flights.
inline constexpr std::string_view kSceneLists[] = {"material", "shape", "thing"};
/// Whether it, or something in it, says how a shot meets things.
[[nodiscard]] bool is_of_contact(const SchemaNode& node);
/// A setting of a body that single flights have, too: how it meets things, where there are some, and its colour.
[[nodiscard]] bool is_of_flights(const SchemaNode& node, const Scenario& scenario);

/// The paths of all settings.
[[nodiscard]] const std::vector<std::string_view>& setting_paths();

/// An object of each kind with nothing but defaults, to read defaults and types from.
class Defaults {
 public:
  [[nodiscard]] Scope scope() {
    return std::apply([this](auto&... object) { return Scope{&format_, &object...}; }, objects_);
  }

 private:
  std::int64_t format_ = 1;
  std::tuple<Scenario, ScenarioShot, Expectation, EventSpec, AirPoint, WindPoint, BallisticBand, MagnusPoint, PoolDef,
             DetailRung, Volley, ScenarioForce, Thrust::Point, Material, ScenarioShape, ScenarioThing, ScenarioKey,
             ScenarioEmitter, Burst, Barrel, ScenarioSub, ScenarioJoint, ScenarioPart>
      objects_;  // in the order of Scope
};

/// For std::visit.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace physim
