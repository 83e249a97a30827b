#include "setup.hpp"

#include <algorithm>
#include <list>
#include <unordered_map>

#include "scenario/overrides.hpp"
#include "scenario/reader.hpp"
#include "scenario/schema.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "scenario/writer.hpp"

namespace physim::python {
namespace {

// -------------------------------------------------------------------------------------------------- values from Python
/// Reads a tree of Python's objects as the tree of a file; each value knows the path of its setting.
class PythonReader {
 public:
  [[nodiscard]] Value read(nb::handle object, const SchemaNode* node, const Place& place) {
    if (++depth_ > kMostDeep) fail("is nested too deeply", *place.source, "a list or dict must not hold itself");
    const bool is_table = nb::isinstance<nb::dict>(object);
    Value value{is_table ? table(object, node, *place.source) : content(object, node, place), place, {}, {}};
    --depth_;
    return value;
  }

 private:
  static constexpr int kMostDeep = 100;
  using Content = decltype(Value::content);

  [[nodiscard]] Content table(nb::handle object, const SchemaNode* node, const std::string& path) {
    Table members;
    for (const auto& [key, each] : nb::borrow<nb::dict>(object)) {
      if (!nb::isinstance<nb::str>(key)) fail("a key is no text", path);
      const std::string name = text_of(key, path);
      const SchemaNode* child = node != nullptr ? node->find(name) : nullptr;
      const Place place{std::make_shared<const std::string>(path.empty() ? name : path + "." + name), 0, 0};
      // Apart: g++ 12 destroys parts of an aggregate twice where a later one throws.
      Value value = read(each, child, place);
      members.push_back({name, place, std::move(value)});
    }
    return members;
  }

  [[nodiscard]] Content content(nb::handle object, const SchemaNode* node, const Place& place) {
    PyObject* const o = object.ptr();
    const std::string& path = *place.source;
    if (PyUnicode_Check(o)) return text_of(object, path);
    if (PyFloat_Check(o)) return PyFloat_AsDouble(o);
    if (PyBool_Check(o)) return o == Py_True;
    if (PyLong_Check(o)) return whole(object, path);
    if (object.is_none()) return absent(node, path);
    if (PyList_Check(o) || PyTuple_Check(o)) return list(object, node, place);
    if (nb::hasattr(object, "to") && nb::hasattr(object, "magnitude"))  // a quantity of pint
      return read(in_si(object, node, path), node, place).content;
    if (nb::hasattr(object, "tolist"))
      return read(object.attr("tolist")(), node, place).content;  // of NumPy and pandas
    if (nb::hasattr(object, "__fspath__")) return nb::cast<std::string>(nb::str(object));
    if (nb::hasattr(object, "__float__")) {
      const nb::float_ number(object);
      return static_cast<double>(number);
    }
    const std::string type = nb::cast<std::string>(object.type().attr("__name__"));
    fail("found an object of type " + type, path,
         "expected a number, a text with a unit, a list, a dict or a quantity of pint");
  }

  [[nodiscard]] static std::string text_of(nb::handle object, const std::string& path) {
    Py_ssize_t size = 0;
    const char* const text = PyUnicode_AsUTF8AndSize(object.ptr(), &size);
    if (text == nullptr) {
      PyErr_Clear();
      fail("the text is not UTF-8", path);
    }
    return {text, static_cast<std::size_t>(size)};
  }

  [[nodiscard]] static Content whole(nb::handle object, const std::string& path) {
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(object.ptr(), &overflow);
    if (overflow != 0) fail("the whole number is too large", path);
    return std::int64_t{number};
  }

  /// None stands for the word that a file has for it: "off", "none".
  [[nodiscard]] static Content absent(const SchemaNode* node, const std::string& path) {
    if (node == nullptr || node->entry == nullptr) fail("found None", path, "leave it out, and it has its default");
    return std::string(node->entry->none);
  }

  [[nodiscard]] Content list(nb::handle object, const SchemaNode* node, const Place& place) {
    Array array;
    for (const nb::handle each : object) array.push_back(read(each, node, place));
    return array;
  }

  [[nodiscard]] static nb::object in_si(nb::handle object, const SchemaNode* node, const std::string& path) {
    if (node == nullptr || node->entry == nullptr) fail("found a quantity where a table stands", path);
    std::string unit(si_unit(node->entry->quantity));
    if (unit.empty()) unit = "dimensionless";
    try {
      return object.attr("to")(unit).attr("magnitude");
    } catch (nb::python_error& error) {
      fail(error.value().is_valid() ? nb::cast<std::string>(nb::str(error.value())) : std::string("wrong dimension"),
           path, "expected " + std::string(info(node->entry->quantity).with_article) + " in " + unit);
    }
  }

  int depth_ = 0;  // an error ends the reader
};

// ------------------------------------------------------------------------------------------------- trees to scenarios
Place place_of_path(const std::string& path) { return {std::make_shared<const std::string>(path), 0, 0}; }

/// Where a path leads.
struct Led {
  Addressed target;
  Place place;
  std::ptrdiff_t depth;  // how many tables it is in
};

struct TextHash : std::hash<std::string_view> {
  using is_transparent = void;
};

/// The view lives as long as the text.
std::string_view view_of(nb::handle text) {
  Py_ssize_t size = 0;
  const char* const begin = PyUnicode_Check(text.ptr()) ? PyUnicode_AsUTF8AndSize(text.ptr(), &size) : nullptr;
  if (begin == nullptr) PyErr_Clear(), fail("a path is no text", "settings");
  return {begin, static_cast<std::size_t>(size)};
}

/// What keys of a dict are: paths of settings, or keywords of Python, which lead to them.
enum class Keys : std::uint8_t { paths, keywords };

/// Each is looked up once, but for paths that name or count an element: they go into `once`.
const Led& led_by(const Value& document, nb::handle key, Keys keys, std::list<Led>& once) {
  using Known = std::unordered_map<std::string, Led, TextHash, std::equal_to<>>;
  static Known known_paths, known_keywords;  // under the interpreter's lock
  Known& known = keys == Keys::paths ? known_paths : known_keywords;
  const std::string_view text = view_of(key);
  if (const auto found = known.find(text); found != known.end()) return found->second;
  std::string path(text);
  if (keys == Keys::keywords)
    path = nb::cast<std::string>(nb::module_::import_("physim._settings").attr("path_of")(key));
  const Place place = place_of_path(path);
  once.push_back({taken(address_in(document, path, place)), place, std::ranges::count(path, '.')});
  return find_node(path) != nullptr ? known.emplace(text, once.back()).first->second : once.back();
}

/// Puts settings into a document: tables before what is in them, whatever the order of the dict.
void put_settings(Value& document, const nb::dict& changes, Keys keys) {
  std::list<Led> once;
  std::vector<std::pair<const Led*, nb::handle>> sorted;
  sorted.reserve(changes.size());
  for (const auto& [key, value] : changes) sorted.emplace_back(&led_by(document, key, keys, once), value);
  std::ranges::stable_sort(sorted, {}, [](const auto& each) { return each.first->depth; });
  for (const auto& [led, value] : sorted)
    taken(put_value(document, led->target, PythonReader().read(value, led->target.node, led->place)));
}

/// One shot with nothing but defaults.
const Value& plain_document() {
  static const Value document = taken(parse_document("physim = 1\n[[shot]]\n", ""));
  return document;
}

/// A shot that says how a world treats it belongs to one, as long as there is nothing that a single flight meets.
void add_world_of_bodies(Value& document) {
  if (document.find("world") != nullptr || document.find("thing") != nullptr) return;
  const Value* shots = document.find("shot");
  const Array* all = shots != nullptr ? shots->get<Array>() : nullptr;
  const auto has_body = [](const Value& shot) { return shot.find("body") != nullptr; };
  if (all == nullptr || std::ranges::none_of(*all, has_body)) return;
  document.get<Table>()->push_back({"world", document.place, Value{Table{}, document.place, {}, {}}});
}

std::string text_of(const Value& value) {
  if (const auto* text = value.get<std::string>()) return *text;
  if (const Array* array = value.get<Array>()) {
    std::string all;
    for (const Value& each : *array) all += (all.empty() ? "" : ", ") + text_of(each);
    return "[" + all + "]";
  }
  if (const Table* table = value.get<Table>()) {
    std::string all;
    for (const Member& member : *table) all += (all.empty() ? "" : ", ") + member.key + ": " + text_of(member.value);
    return "{" + all + "}";
  }
  return shown(value);
}

void add_leaves(const Value& value, const std::string& path, nb::list& into) {
  const Table* table = value.get<Table>();
  const Array* array = value.get<Array>();
  if (table != nullptr) {
    for (const Member& member : *table)
      add_leaves(member.value, path.empty() ? member.key : path + "." + member.key, into);
  } else if (path == "shot" && array != nullptr) {
    for (const Value& each : *array) add_leaves(each, path, into);
  } else {
    into.append(nb::make_tuple(path, text_of(value)));
  }
}

// --------------------------------------------------------------------------------------------------------- functions
template <class Batch>
nb::tuple inputs_of(const Batch& batch) {
  const nb::object time = owned(std::vector<double>(batch.time.begin(), batch.time.end()));
  if constexpr (requires { batch.mass; })
    return nb::make_tuple(time, array_of(batch.position), array_of(std::span<const Vec3d>(batch.velocity)),
                          owned(std::vector<double>(batch.mass.begin(), batch.mass.end())));
  else
    return nb::make_tuple(time, array_of(batch.position));
}

WindFunction wind_of(const Function& function) {
  return WindFunction([function](const WindBatch& batch) {
    function.call([&](const nb::object& f) { copy_rows(f(*inputs_of(batch)), batch.velocity, "wind_field"); });
  });
}

ForceFunction force_of(const Function& function) {
  return ForceFunction([function](const FieldForceBatch& batch) {
    function.call([&](const nb::object& f) { copy_rows(f(*inputs_of(batch)), batch.force, "force_field"); });
  });
}

}  // namespace

Value value_of_python(nb::handle object, const std::string& path) {
  return PythonReader().read(object, path.empty() ? &schema() : find_node(path), place_of_path(path));
}

Value shot_of_settings(const nb::dict& settings) {
  Value document = plain_document();
  for (const auto& [path, value] : settings)
    if (const std::string_view text = view_of(path); !text.starts_with("shot."))
      fail("is no setting of a projectile", std::string(text), "a world has one environment for all of a kind");
  put_settings(document, settings, Keys::paths);
  return element(document, "shot", 0);
}

SetupPtr Setup::make(Value document, const std::string& file, std::optional<Function> wind_field,
                     std::optional<Function> force) {
  auto made = std::make_shared<Setup>();
  Scenario& scenario = made->scenario;
  taken(read_scenario(document, file, Checks::together, scenario));
  if (wind_field) scenario.environment.wind.field = wind_of(*wind_field);
  if (force) scenario.environment.force = force_of(*force);
  if (!scenario.world.given && !scenario.things.empty()) made->scene = taken(scene_of(scenario));
  made->document = std::move(document), made->wind_field = std::move(wind_field), made->force = std::move(force);
  return made;
}

SetupPtr Setup::plain() { return make(plain_document(), ""); }

SetupPtr Setup::with(const Scenario& changed) const {
  return make(taken(parse_document(scenario_text(changed), scenario.file)), scenario.file, wind_field, force);
}

const ScenarioShot& Setup::shot(const std::string& name) const {
  if (name.empty()) return scenario.shots.front();
  std::vector<std::string_view> names;
  for (const ScenarioShot& each : scenario.shots) {
    if (each.projectile.name == name) return each;
    names.push_back(each.projectile.name);
  }
  fail("no shot is named " + in_quotes(name), "shot", suggestion(name, names, "shots"));
}

Until Setup::until(const ScenarioShot& shot) const {
  Until until = scenario.until;
  if (scene) {
    until.scene = &*scene;
    until.contact = contact_of(shot);
  }
  return until;
}

void Setup::raise_kept() const {
  if (wind_field) wind_field->raise_kept();
  if (force) force->raise_kept();
}

// ------------------------------------------------------------------------------------------------------------- module
namespace {

std::optional<Function> function_of(const nb::object& object, const char* name) {
  if (object.is_none()) return std::nullopt;
  if (PyCallable_Check(object.ptr()) == 0) fail("is no function", name);
  return Function(object);
}

nb::object function_in(const std::optional<Function>& function) { return function ? function->get() : nb::none(); }

SetupPtr with_settings(const Setup& setup, const nb::dict& changes, bool by_keyword) {
  Value document = setup.document;
  put_settings(document, changes, by_keyword ? Keys::keywords : Keys::paths);
  add_world_of_bodies(document);
  return Setup::make(std::move(document), setup.scenario.file, setup.wind_field, setup.force);
}

SetupPtr from_settings(const nb::dict& settings, const nb::object& wind_field, const nb::object& force) {
  Value document = plain_document();
  put_settings(document, settings, Keys::keywords);
  add_world_of_bodies(document);
  return Setup::make(std::move(document), "", function_of(wind_field, "wind_field"), function_of(force, "force_field"));
}

/// Texts of uncertain inputs that were given as such, not in the place of numbers.
std::vector<std::string> inputs_given(const Setup& setup) {
  std::vector<std::string> texts;
  const Value* study = setup.document.find("study");
  const Value* inputs = study != nullptr ? study->find("inputs") : nullptr;
  if (inputs == nullptr) return texts;
  if (const auto* text = inputs->get<std::string>()) return {*text};
  for (const Value& each : *inputs->get<Array>()) texts.push_back(*each.get<std::string>());
  return texts;
}

SetupPtr from_text(const std::string& text, const std::string& file, const std::vector<std::string>& overrides,
                   const nb::object& wind_field, const nb::object& force) {
  Value document = taken(parse_document(text, file));
  for (const std::string& each : overrides) taken(apply_override(document, each));
  return Setup::make(std::move(document), file, function_of(wind_field, "wind_field"),
                     function_of(force, "force_field"));
}

nb::list settings_table() {
  nb::list all;
  for (const Entry& entry : entries()) {
    const std::string path(entry.path);
    const SchemaNode* node = find_node(path);
    std::size_t lists = 0;  // tables before it that are lists
    for (std::size_t dot = path.find('.'); dot != path.npos; dot = path.find('.', dot + 1))
      lists += find_node(path.substr(0, dot))->is_list_of_tables() ? 1 : 0;
    nb::dict row;
    row["path"] = path;
    row["in_lists"] = lists;
    row["is_list"] = node->is_list_of_tables();
    row["shorthand"] = entry.shorthand;
    row["required"] = entry.required;
    row["none"] = std::string(entry.none);
    all.append(row);
  }
  std::size_t i = 0;
  for (const Setting& setting : settings()) {
    nb::dict row = nb::cast<nb::dict>(all[i++]);
    row["type"] = setting.type;
    row["unit"] = setting.unit;
    row["default"] = setting.default_value;
    row["range"] = setting.range;
    row["doc"] = setting.doc;
    row["live"] = setting.live;
  }
  return all;
}

}  // namespace

void add_setup(nb::module_& m) {
  nb::class_<Setup>(m, "Setup", "A scenario that was read; it never changes.")
      .def_static(
          "from_tree",
          [](const nb::dict& tree, const std::string& file, const nb::object& wind_field, const nb::object& force) {
            Value document = value_of_python(tree, "");
            add_world_of_bodies(document);
            return Setup::make(std::move(document), file, function_of(wind_field, "wind_field"),
                               function_of(force, "force_field"));
          },
          "tree"_a, "file"_a = "", "wind_field"_a = nb::none(), "force_field"_a = nb::none(),
          "Reads nested dicts of settings.")
      .def_static("from_settings", &from_settings, "settings"_a, "wind_field"_a = nb::none(),
                  "force_field"_a = nb::none(), "Reads settings by keyword, of one shot.")
      .def_static("from_text", &from_text, "text"_a, "file"_a = "text", "overrides"_a = std::vector<std::string>(),
                  "wind_field"_a = nb::none(), "force_field"_a = nb::none(), "Reads the text of a scenario file.")
      .def_static(
          "from_file",
          [](const std::string& file, const std::vector<std::string>& overrides) {
            return from_text(taken(read_scenario_text(file)), file, overrides, nb::none(), nb::none());
          },
          "file"_a, "overrides"_a = std::vector<std::string>(), "Reads a scenario file.")
      .def("with_settings", &with_settings, "changes"_a, "by_keyword"_a = false,
           "A copy with other settings, by path or by keyword.")
      .def(
          "with_functions",
          [](const Setup& setup, const nb::object& wind_field, const nb::object& force) {
            return Setup::make(setup.document, setup.scenario.file, function_of(wind_field, "wind_field"),
                               function_of(force, "force_field"));
          },
          "wind_field"_a.none(), "force_field"_a.none(), "A copy with functions of place and time.")
      .def(
          "only_shot",
          [](const Setup& setup, const std::string& name) {
            Scenario alone = setup.scenario;
            alone.shots = {setup.shot(name)};
            alone.world = {};
            alone.volleys.clear(), alone.emitters.clear(), alone.forces.clear(), alone.joints.clear();
            alone.expect.clear();
            return setup.with(alone);
          },
          "name"_a, "A copy with one shot of it, for single flights.")
      .def(
          "text", [](const Setup& setup) { return scenario_text(setup.scenario); },
          "The settings that differ from their defaults, as the text of a file.")
      .def(
          "given",
          [](const Setup& setup) {
            nb::list all;
            add_leaves(setup.document, "", all);
            return all;
          },
          "Path and text of each setting that was given.")
      .def(
          "settings",
          [](const Setup& setup) {
            nb::dict all;
            for (const auto& [path, value] : effective_settings(setup.scenario)) all[path.c_str()] = value;
            return all;
          },
          "Every setting with its value in SI, by path.")
      .def_prop_ro(
          "file", [](const Setup& setup) { return setup.scenario.file; }, "That it was read from.")
      .def_prop_ro(
          "title", [](const Setup& setup) { return setup.scenario.title; }, "Of the scenario.")
      .def_prop_ro(
          "notes", [](const Setup& setup) { return taken(notes_of(setup.scenario, setup.document)); },
          "Remarks about settings.")
      .def_prop_ro("inputs_given", &inputs_given, "Uncertain inputs, as texts, that stand in its list of them.")
      .def_prop_ro(
          "has_world", [](const Setup& setup) { return setup.scenario.world.given; },
          "Whether its shots fly in a world.")
      .def_prop_ro(
          "shots",
          [](const Setup& setup) {
            std::vector<std::string> names;
            for (const ScenarioShot& shot : setup.scenario.shots) names.push_back(shot.projectile.name);
            return names;
          },
          "Names of its shots.")
      .def_prop_ro(
          "ranges", [](const Setup& setup) { return setup.scenario.ranges; }, "Of its range card.")
      .def_prop_ro(
          "wind_field", [](const Setup& setup) { return function_in(setup.wind_field); }, "A function, or None.")
      .def_prop_ro(
          "force_field", [](const Setup& setup) { return function_in(setup.force); }, "A function, or None.");

  m.def("settings", &settings_table, "The list of settings, a dict each.");
  m.def(
      "parse_quantity",
      [](const std::string& text, const std::string& path) {
        const SchemaNode* node = find_node(path);
        if (node == nullptr || node->entry == nullptr) fail("unknown setting " + in_quotes(path), path);
        Result<double> number = parse_quantity(text, node->entry->quantity);
        if (!number) fail(number.error().message, path, number.error().hint);
        return *number;
      },
      "text"_a, "path"_a, "A text with a unit as a number in SI, by the quantity of a setting.");
  m.def(
      "parse_number",
      [](const std::string& text, const std::string& unit, const std::string& place) {
        Result<double> number = parse_quantity(text, quantity_of_si_unit(unit));
        if (!number) fail(number.error().message, place, number.error().hint);
        return *number;
      },
      "text"_a, "unit"_a, "place"_a, "A text with a unit as a number in SI, by the SI unit of its quantity.");
  m.def(
      "units_of",
      [](const std::string& path) {
        const SchemaNode* node = find_node(path);
        if (node == nullptr || node->entry == nullptr) fail("unknown setting " + in_quotes(path), path);
        return units_of(node->entry->quantity);
      },
      "path"_a, "Units that a setting takes, the one of SI first.");
}

}  // namespace physim::python
