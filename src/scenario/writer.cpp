#include "scenario/writer.hpp"

#include <algorithm>
#include <cstdio>
#include <tuple>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/document.hpp"
#include "scenario/reader.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

/// Plain: as typed in an override. Whole: within a file. Brief: within a file, without what its reader has anyway.
enum class Style { plain, whole, brief };

std::string toml_string(std::string_view text) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (code < 0x20 || code == 0x7F)
      out += "\\u00", out += kHex[code / 16], out += kHex[code % 16];
    else
      out += c;
  }
  return out + "\"";
}

/// As people write it: between three quotes, line by line. Quotes within are escaped where they would end it.
std::string text_block(std::string_view text) {
  std::string out = "\"\"\"\n";
  for (const char& c : text) {
    const std::string quoted = toml_string({&c, 1});
    out += c == '\n' || c == '\t'                                  ? std::string(1, c)
           : c == '"' && !out.ends_with('"') && &c != &text.back() ? "\""
                                                                   : quoted.substr(1, quoted.size() - 2);
  }
  return out + "\"\"\"";
}

/// Plain text that would not read back as itself is quoted.
std::string text_value(const std::string& text, Style style) {
  if (style == Style::brief && text.find('\n') != text.npos) return text_block(text);
  bool plain = style == Style::plain && !text.empty() && trimmed(text) == text && text[0] != '"' && text[0] != '\'';
  for (const char c : text) plain = plain && static_cast<unsigned char>(c) >= 0x20;
  return plain ? text : toml_string(text);
}

std::string word(std::string_view text, Style style) {
  return style == Style::plain ? std::string(text) : toml_string(text);
}

/// Numbers without a unit need no quotes.
std::string number_value(double value, Quantity quantity, Style style) {
  const std::string text = quantity_text(value, quantity);
  return si_unit(quantity).empty() ? text : word(text, style);
}

template <class List, class Write>
std::string array_value(const List& list, const Write& write) {
  std::string out;
  for (const auto& element : list) out += (out.empty() ? "" : ", ") + write(element);
  return "[" + out + "]";
}

std::string numbers_value(const std::vector<double>& list, Quantity quantity) {
  return array_value(list, [quantity](double x) { return number_value(x, quantity, Style::whole); });
}

std::string vector_value(const Vec3d& v, Quantity quantity) { return numbers_value({v.x, v.y, v.z}, quantity); }

std::string triangle_value(const Triangle& t) {
  return "[" + std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " + std::to_string(t[2]) + "]";
}

std::string points_value(const Points& points) {
  return array_value(points.get(), [&](const auto& point) {
    return "[" + number_value(point.first, points.quantities[0], Style::whole) + ", " +
           number_value(point.second, points.quantities[1], Style::whole) + "]";
  });
}

std::string aero_value(const AeroCoefficient& coefficient) {
  if (coefficient.size() == 1 && coefficient[0].mach == 0 && coefficient[0].angle_squared == 0)
    return number_text(coefficient[0].value);
  const bool angles =
      std::any_of(coefficient.begin(), coefficient.end(), [](const AeroPoint& p) { return p.angle_squared != 0; });
  return array_value(coefficient, [angles](const AeroPoint& p) {
    const std::string angle = angles ? number_text(p.angle_squared / kSquareDegree) + ", " : "";
    return "[" + number_text(p.mach) + ", " + angle + number_text(p.value) + "]";
  });
}

// ------------------------------------------------------------------------------------------ what emitters draw
std::string curve_value(const Curve& curve) {
  return array_value(curve, [](const CurveKey& key) { return numbers_value({key.at, key.value}, Quantity::number); });
}

std::string colour_value(std::uint32_t colour, Style style) {
  char text[10];
  std::snprintf(text, sizeof text, (colour & 0xffU) == 0xffU ? "#%06x" : "#%08x",
                (colour & 0xffU) == 0xffU ? colour >> 8 : colour);
  return word(text, style);
}

std::string gradient_value(const Gradient& gradient) {
  return array_value(gradient, [](const ColourKey& key) {
    return "[" + number_text(key.at) + ", " + colour_value(key.colour, Style::whole) + "]";
  });
}

/// One end, or two of them, or a table of ends and curves; `names` of its keys.
std::string ends_value(const std::string (&ends)[2], const std::string (&curves)[2], const std::string_view (&names)[4],
                       Style style, const std::string& plain) {
  constexpr std::string_view kNone = "[]";
  PHYSIM_ASSERT(!ends[0].empty());
  const bool has_curves = curves[0] != kNone || curves[1] != kNone;
  if (!has_curves && ends[1].empty()) return style == Style::plain ? plain : ends[0];
  if (!has_curves) return "[" + ends[0] + ", " + ends[1] + "]";
  std::string out = std::string(names[0]) + " = " + ends[0];
  if (!ends[1].empty()) out += ", " + std::string(names[1]) + " = " + ends[1];
  for (std::size_t i = 0; i < 2; ++i)
    if (curves[i] != kNone) out += ", " + std::string(names[i + 2]) + " = " + curves[i];
  return "{ " + out + " }";
}

std::string drawn_value(const DrawnNumber& x, Quantity quantity, Style style) {
  const std::string to = x.to ? number_value(*x.to, quantity, Style::whole) : "";
  return ends_value({number_value(x.value, quantity, Style::whole), to},
                    {curve_value(x.curve), curve_value(x.to_curve)}, {"value", "to", "curve", "to_curve"}, style,
                    number_value(x.value, quantity, Style::plain));
}

std::string drawn_value(const DrawnColour& x, Style style) {
  const std::string to = x.to ? colour_value(*x.to, Style::whole) : "";
  return ends_value({colour_value(x.colour, Style::whole), to},
                    {gradient_value(x.gradient), gradient_value(x.to_gradient)},
                    {"colour", "to", "gradient", "to_gradient"}, style, colour_value(x.colour, Style::plain));
}

std::optional<std::string> value_text(const Entry& entry, const Scope& scope, Style style);

using Settings = std::vector<std::pair<std::string, std::string>>;  // keys, or paths, with their values

constexpr std::string_view kEmptyTable = "{}";

std::string in_braces(const Settings& keys) {
  std::string out;
  for (const auto& [key, value] : keys) out += (out.empty() ? "" : ", ") + key + " = " + value;
  return out.empty() ? std::string(kEmptyTable) : "{ " + out + " }";
}

/// A table within an array with all that it says; values that are absent are left out, and so are tables of nothing
/// else.
std::string inline_table(const SchemaNode& node, const Scope& scope) {
  Settings keys;
  for (const SchemaNode& child : node.children) {
    const std::optional<std::string> value =
        child.entry ? value_text(*child.entry, scope, Style::whole) : inline_table(child, scope);
    if (value && *value != kEmptyTable) keys.emplace_back(child.name, *value);
  }
  return in_braces(keys);
}

std::string brief_element(const SchemaNode& node, const Scope& outer, const Scope& element);

std::string records_value(const Entry& entry, const Records& records, const Scope& scope, Style style) {
  const SchemaNode* node = find_node(entry.path);
  PHYSIM_ASSERT(node != nullptr);
  PHYSIM_ASSERT(node->is_list_of_tables());
  std::string out;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Scope element = records.element(i);
    out += (i == 0 ? "" : ", ") +
           (style == Style::brief ? brief_element(*node, scope, element) : inline_table(*node, element));
  }
  return "[" + out + "]";
}

/// What is absent is left out of tables, unless that would bring a default back.
std::optional<std::string> absent(const Entry& entry, Style style) {
  if (style == Style::plain) return std::string(entry.none);
  if (style == Style::brief) return toml_string(entry.none);
  Defaults defaults;
  if (value_text(entry, defaults.scope(), Style::plain) == entry.none) return std::nullopt;
  return toml_string(entry.none);
}

std::optional<std::string> value_text(const Entry& entry, const Scope& scope, Style style) {
  using Text = std::optional<std::string>;
  if (entry.is_there != nullptr && !entry.is_there(scope)) return std::nullopt;
  const Quantity quantity = entry.quantity_in(scope);
  return std::visit(Overloaded{
                        [&](const double* value) -> Text { return number_value(*value, quantity, style); },
                        [&](const OptionalNumber& number) -> Text {
                          const std::optional<double> value = number.get();
                          return value ? number_value(*value, quantity, style) : absent(entry, style);
                        },
                        [&](const Vec3d* value) -> Text { return vector_value(*value, quantity); },
                        [&](const std::optional<Vec3d>* value) -> Text {
                          return *value ? vector_value(**value, quantity) : absent(entry, style);
                        },
                        [&](const Integer& value) -> Text { return std::to_string(value.get()); },
                        [&](const OptionalInteger& number) -> Text {
                          const std::optional<std::int64_t> value = number.get();
                          return value ? std::to_string(*value) : absent(entry, style);
                        },
                        [&](const bool* value) -> Text { return *value ? "true" : "false"; },
                        [&](const std::string* value) -> Text { return text_value(*value, style); },
                        [&](const Choice& choice) -> Text {
                          const std::optional<std::size_t> index = choice.get();
                          PHYSIM_ASSERT(!index || *index < choice.names.size());
                          return index ? Text(word(choice.names[*index], style)) : std::nullopt;
                        },
                        [](const Reference&) -> Text { return std::nullopt; },
                        [](const Points& points) -> Text { return points_value(points); },
                        [&](const AeroCoefficient* coefficient) -> Text { return aero_value(*coefficient); },
                        [&](const DrawnNumber* number) -> Text { return drawn_value(*number, quantity, style); },
                        [&](const DrawnColour* colour) -> Text { return drawn_value(*colour, style); },
                        [](const Gradient* gradient) -> Text { return gradient_value(*gradient); },
                        [&](const std::vector<double>* list) -> Text { return numbers_value(*list, quantity); },
                        [&](const std::vector<std::string>* list) -> Text { return array_value(*list, toml_string); },
                        [&](const std::vector<Vec3d>* list) -> Text {
                          return array_value(*list, [&](const Vec3d& v) { return vector_value(v, quantity); });
                        },
                        [](const std::vector<Triangle>* list) -> Text { return array_value(*list, triangle_value); },
                        [&](const Records& records) -> Text { return records_value(entry, records, scope, style); },
                    },
                    entry.slot(scope));
}

bool has_colours(const Scenario& scenario) {
  return std::ranges::any_of(scenario.shots, [](const ScenarioShot& s) { return s.body.colour != BodyDef{}.colour; });
}

/// Settings of worlds are for scenarios that have one, and would make one; those of single flights are for the others.
/// Flights that have nothing to meet know nothing of scenes, and those without colours nothing of these.
bool is_left_out(const SchemaNode& node, const Scenario& scenario) {
  if (scenario.world.given) return node.path == "until" || node.path == "output";
  if (node.path == "world" || std::ranges::count(kWorldLists, node.path) > 0) return true;
  if (std::ranges::count(kSceneLists, node.path) > 0)
    return scenario.materials.empty() && scenario.shapes.empty() && scenario.things.empty();
  if (!node.path.starts_with("shot.body") || node.path == "shot.body") return false;
  return !is_of_flights(node, scenario) || (node.path == "shot.body.colour" && !has_colours(scenario));
}

/// A body but for what the file of a scenario can say.
BodyDef unsaid(BodyDef body, const Scenario& scenario) {
  if (scenario.world.given) return {};
  const BodyDef usual;
  body.colour = usual.colour;
  if (scenario.things.empty()) return body;
  body.restitution = usual.restitution;
  body.friction = usual.friction;
  body.rolling_resistance = usual.rolling_resistance;
  body.combine = usual.combine;
  const std::uint32_t others = body.collision.others;
  body.collision = usual.collision;
  body.collision.others = others;
  return body;
}

using TakeSetting = std::function<void(const std::string& path, const std::string& value)>;

/// All settings of a table. Shots are named one by one; other lists are one value.
void write_table(const SchemaNode& node, const Scope& scope, const std::string& prefix, Style style,
                 const TakeSetting& take) {
  for (const SchemaNode& child : node.children) {
    const std::string path = prefix + child.name;
    if (is_left_out(child, *scope.scenario)) continue;
    if (child.path == "shot") {
      const Records shots = std::get<Records>(child.entry->slot(scope));
      for (std::size_t i = 0; i < shots.size(); ++i) {
        const Scope inner = shots.element(i);
        write_table(child, inner, path + "." + inner.shot->projectile.name + ".", style, take);
      }
    } else if (child.entry == nullptr) {
      write_table(child, scope, path + ".", style, take);
    } else if (const std::optional<std::string> value = value_text(*child.entry, scope, style)) {
      take(path, *value);
    }
  }
}

/// A copy of a scenario with its scope, as slots are for reading and writing.
struct InScope {
  Scenario copy;
  std::int64_t format = 1;
  Scope scope{.format = &format, .scenario = &copy};

  explicit InScope(const Scenario& scenario) : copy(scenario) {}
  InScope(const InScope&) = delete;
};

void each_setting(const Scenario& scenario, Style style, const TakeSetting& take) {
  write_table(schema(), InScope(scenario).scope, "", style, take);
}

Settings all_settings(const Scenario& scenario, Style style) {
  Settings settings;
  each_setting(scenario, style,
               [&](const std::string& path, const std::string& value) { settings.emplace_back(path, value); });
  return settings;
}

// ---------------------------------------------------------------------------------------------------------- in brief
// A file says what its reader does not have anyway. A reader follows what is written: it starts with
// defaults, and has what presets and other settings bring along.

/// What a reader has of an element of a list before its first key; of all around it, what is there.
Scope unread(const Scope& outer, Scope element, Defaults& defaults) {
  Scope usual = defaults.scope(), around = outer;
  const auto forget = [&](auto*& own) {
    using Pointer = std::remove_reference_t<decltype(own)>;
    if (own != std::get<Pointer&>(around.pointers())) own = std::get<Pointer&>(usual.pointers());
  };
  const bool is_own = element.emitter != nullptr && element.emitter != outer.emitter;
  const bool is_gun = is_own && element.emitter->def.gun.rounds_per_minute > 0;
  std::apply([&](auto&... own) { (forget(own), ...); }, element.pointers());
  if (is_gun) element.emitter->def.per_second = {0};  // as a reader completes it
  return element;
}

/// The values of all settings of a table that can be said, and of the tables in it.
void collect(const SchemaNode& node, const Scope& scope, std::vector<std::optional<std::string>>& values) {
  for (const SchemaNode& child : node.children) {
    if (is_left_out(child, *scope.scenario)) continue;
    if (child.entry != nullptr)
      values.push_back(value_text(*child.entry, scope, Style::plain));
    else
      collect(child, scope, values);
  }
}

/// The preset with which the fewest settings of its table are left to be said, where it saves any. The reader has it.
/// Where a body cannot be said, a preset that brings it along is worth more than all it leaves to say.
std::optional<std::string> preset_text(const SchemaNode& node, const Scope& scope, const Scope& reader) {
  const SchemaNode* table = find_node(node.path.substr(0, node.path.rfind('.')));
  PHYSIM_ASSERT(table != nullptr);
  PHYSIM_ASSERT((reader.shot != nullptr) != (reader.material != nullptr));
  std::vector<std::optional<std::string>> wanted, had;
  collect(*table, scope, wanted);
  const auto left_to_say = [&](Scope scope_of_reader) {
    had.clear();
    scope_of_reader.scenario = scope.scenario;
    collect(*table, scope_of_reader, had);
    PHYSIM_ASSERT(had.size() == wanted.size());
    const bool has_body =
        !scope.shot || unsaid(scope_of_reader.shot->body, *scope.scenario) == unsaid(scope.shot->body, *scope.scenario);
    std::size_t count = has_body ? 0 : had.size();
    for (std::size_t i = 0; i < had.size(); ++i) count += had[i] != wanted[i];
    return count;
  };
  const Choice presets = std::get<Choice>(node.entry->slot(reader));
  std::optional<std::size_t> best;
  std::size_t fewest = left_to_say(reader);
  for (std::size_t i = 0; i < presets.names.size(); ++i) {
    ScenarioShot shot = reader.shot ? *reader.shot : ScenarioShot();
    Material material = reader.material ? *reader.material : Material();
    Scope trial = reader;
    if (reader.shot) trial.shot = &shot;
    if (reader.material) trial.material = &material;
    std::get<Choice>(node.entry->slot(trial)).set(i);
    // Whatever resists as oak does may be said by "oak"; that which does not is something else.
    if (reader.material && material.penetration != scope.material->penetration) continue;
    const std::size_t count = left_to_say(trial) + 1;
    if (count < fewest) fewest = count, best = i;
  }
  if (!best) return std::nullopt;
  presets.set(*best);
  return toml_string(presets.names[*best]);
}

/// The text of a setting where a reader would not have its value without it. From then on the reader has it.
std::optional<std::string> news_text(const SchemaNode& node, const Scope& scope, const Scope& reader) {
  const Entry& entry = *node.entry;
  if (entry.starts) return preset_text(node, scope, reader);
  const std::optional<std::string> value = value_text(entry, scope, Style::plain);
  if (!value || (!entry.required && value == value_text(entry, reader, Style::plain))) return std::nullopt;
  const Status read = read_setting(node, reader, parse_override_value(*value, Place{}));
  PHYSIM_ASSERT(read.ok());  // what is written can be read
  return value_text(entry, scope, Style::brief);
}

std::optional<std::string> brief_table(const SchemaNode& node, const Scope& scope, const Scope& reader);

/// The keys of a table, with the tables in it on one line each.
Settings brief_keys(const SchemaNode& node, const Scope& scope, const Scope& reader) {
  Settings keys;
  for (const SchemaNode& child : node.children) {
    if (is_left_out(child, *scope.scenario)) continue;
    const std::optional<std::string> value =
        child.entry ? news_text(child, scope, reader) : brief_table(child, scope, reader);
    if (value) keys.emplace_back(child.name, *value);
  }
  return keys;
}

/// A table on one line; nothing where there is nothing to say, and a bare value where it may stand for the table.
std::optional<std::string> brief_table(const SchemaNode& node, const Scope& scope, const Scope& reader) {
  const Settings keys = brief_keys(node, scope, reader);
  if (keys.empty()) return std::nullopt;
  if (keys.size() == 1 && keys[0].first == node.shorthand) return keys[0].second;
  return in_braces(keys);
}

std::string brief_element(const SchemaNode& node, const Scope& outer, const Scope& element) {
  Defaults defaults;
  return in_braces(brief_keys(node, element, unread(outer, element, defaults)));
}

std::string lines(const Settings& keys) {
  std::string out;
  for (const auto& [key, value] : keys) out += key + " = " + value + "\n";
  return out;
}

/// An element of a list of tables, a line for each key.
std::string element_text(const SchemaNode& node, const Scope& scope, std::size_t index) {
  Defaults defaults;
  const Scope element = std::get<Records>(node.entry->slot(scope)).element(index);
  return lines(brief_keys(node, element, unread(scope, element, defaults)));
}

}  // namespace

std::string scenario_text(const Scenario& scenario) {
  const IeeeMode mode;
  InScope said(scenario);
  Defaults defaults;
  const Scope reader = defaults.scope();
  std::string keys = "physim = " + std::to_string(said.format) + "\n", tables;
  for (const SchemaNode& child : schema().children) {
    if (child.path == "physim" || is_left_out(child, said.copy)) continue;
    if (child.is_list_of_tables()) {
      const Records list = std::get<Records>(child.entry->slot(said.scope));
      for (std::size_t i = 0; i < list.size(); ++i)
        tables += "\n[[" + child.name + "]]\n" + element_text(child, said.scope, i);
    } else if (child.entry != nullptr) {
      if (const auto value = news_text(child, said.scope, reader)) keys += child.name + " = " + *value + "\n";
    } else if (const Settings of_table = brief_keys(child, said.scope, reader);
               !of_table.empty() || child.path == "world") {
      tables += "\n[" + child.name + "]\n" + lines(of_table);
    }
  }
  return keys + tables;
}

std::optional<std::string> written(const Entry& entry, const Scope& scope) {
  return value_text(entry, scope, Style::plain);
}

std::optional<std::string> written_in_file(const Entry& entry, const Scope& scope) {
  return value_text(entry, scope, Style::brief);
}

std::vector<std::string> element_texts(const Scenario& scenario, std::string_view list) {
  const SchemaNode* node = find_node(list);
  PHYSIM_ASSERT(node != nullptr && node->is_list_of_tables());
  InScope said(scenario);
  std::vector<std::string> texts(std::get<Records>(node->entry->slot(said.scope)).size());
  for (std::size_t i = 0; i < texts.size(); ++i) texts[i] = element_text(*node, said.scope, i);
  return texts;
}

void each_setting(const Scenario& scenario, const TakeSetting& take) {
  const IeeeMode mode;
  each_setting(scenario, Style::plain, take);
}

Settings settings_in_file(const Scenario& scenario) { return all_settings(scenario, Style::brief); }

Settings effective_settings(const Scenario& scenario) {
  const IeeeMode mode;
  return all_settings(scenario, Style::plain);
}

}  // namespace physim
