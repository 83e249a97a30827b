#include "scenario/writer.hpp"

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

/// Plain: as typed in an override. Toml: inside an inline table or array.
enum class Style { plain, toml };

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

/// Plain text that would not read back as itself is quoted.
std::string text_value(const std::string& text, Style style) {
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
  return array_value(list, [quantity](double x) { return number_value(x, quantity, Style::toml); });
}

std::string vector_value(const Vec3d& v, Quantity quantity) { return numbers_value({v.x, v.y, v.z}, quantity); }

std::string points_value(const Points& points) {
  return array_value(points.get(), [&](const auto& point) {
    return "[" + number_value(point.first, points.quantities[0], Style::toml) + ", " +
           number_value(point.second, points.quantities[1], Style::toml) + "]";
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

std::optional<std::string> value_text(const Entry& entry, const Scope& scope, Style style);

constexpr std::string_view kNothing = "{}";

/// A table within an array; values that are absent are left out, and so are tables of nothing else.
std::string inline_table(const SchemaNode& node, const Scope& scope) {
  std::string out;
  for (const SchemaNode& child : node.children) {
    const std::optional<std::string> value =
        child.entry ? value_text(*child.entry, scope, Style::toml) : inline_table(child, scope);
    if (value && *value != kNothing) out += (out.empty() ? "" : ", ") + child.name + " = " + *value;
  }
  return out.empty() ? std::string(kNothing) : "{ " + out + " }";
}

std::string records_value(const Entry& entry, const Records& records) {
  const SchemaNode* node = find_node(entry.path);
  PHYSIM_ASSERT(node != nullptr);
  PHYSIM_ASSERT(node->is_list_of_tables());
  std::string out;
  for (std::size_t i = 0; i < records.size(); ++i)
    out += (i == 0 ? "" : ", ") + inline_table(*node, records.element(i));
  return "[" + out + "]";
}

/// What is absent is left out of tables, unless that would bring a default back.
std::optional<std::string> absent(const Entry& entry, Style style) {
  if (style == Style::plain) return std::string(entry.none);
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
                        [&](const std::vector<double>* list) -> Text { return numbers_value(*list, quantity); },
                        [&](const std::vector<std::string>* list) -> Text { return array_value(*list, toml_string); },
                        [&](const Records& records) -> Text { return records_value(entry, records); },
                    },
                    entry.slot(scope));
}

using Lines = std::vector<std::pair<std::string, std::string>>;

/// Settings of worlds are for scenarios that have one, and would make one; those of single flights are for the others.
bool is_left_out(const SchemaNode& node, const Scenario& scenario) {
  if (!scenario.world.given)
    return node.path == "world" || node.path == "volley" || node.path == "force" || node.path == "shot.body";
  return node.path == "until" || node.path == "output";
}

/// All settings of a table. Shots are named one by one; other lists are one value.
void write_table(const SchemaNode& node, const Scope& scope, const std::string& prefix, Lines& lines) {
  for (const SchemaNode& child : node.children) {
    const std::string path = prefix + child.name;
    if (is_left_out(child, *scope.scenario)) continue;
    if (child.path == "shot") {
      const Records shots = std::get<Records>(child.entry->slot(scope));
      for (std::size_t i = 0; i < shots.size(); ++i) {
        const Scope inner = shots.element(i);
        write_table(child, inner, path + "." + inner.shot->projectile.name + ".", lines);
      }
    } else if (child.entry == nullptr) {
      write_table(child, scope, path + ".", lines);
    } else if (const std::optional<std::string> value = value_text(*child.entry, scope, Style::plain)) {
      lines.emplace_back(path, *value);
    }
  }
}

/// The keys of a table of the file, with the tables in it on one line each.
std::string table_lines(const SchemaNode& node, const Scope& scope) {
  std::string out;
  for (const SchemaNode& child : node.children) {
    if (is_left_out(child, *scope.scenario)) continue;
    const std::optional<std::string> value =
        child.entry ? value_text(*child.entry, scope, Style::toml) : inline_table(child, scope);
    if (value && *value != kNothing && *value != "[]" && *value != "\"\"") out += child.name + " = " + *value + "\n";
  }
  return out;
}

}  // namespace

std::string scenario_text(const Scenario& scenario) {
  const IeeeMode mode;
  Scenario copy = scenario;  // slots are for reading and writing
  std::int64_t format = 1;
  const Scope scope{.format = &format, .scenario = &copy};
  std::string keys, tables;
  for (const SchemaNode& child : schema().children) {
    if (is_left_out(child, copy)) continue;
    if (child.is_list_of_tables()) {
      const Records list = std::get<Records>(child.entry->slot(scope));
      for (std::size_t i = 0; i < list.size(); ++i)
        tables += "\n[[" + child.name + "]]\n" + table_lines(child, list.element(i));
    } else if (child.entry != nullptr) {
      const std::optional<std::string> value = value_text(*child.entry, scope, Style::toml);
      if (value && *value != "\"\"") keys += child.name + " = " + *value + "\n";
    } else if (const std::string lines = table_lines(child, scope); !lines.empty()) {
      tables += "\n[" + child.name + "]\n" + lines;
    }
  }
  return keys + tables;
}

std::optional<std::string> written(const Entry& entry, const Scope& scope) {
  return value_text(entry, scope, Style::plain);
}

std::vector<std::pair<std::string, std::string>> effective_settings(const Scenario& scenario) {
  const IeeeMode mode;
  Scenario copy = scenario;  // slots are for reading and writing
  std::int64_t format = 1;
  const Scope scope{.format = &format, .scenario = &copy};
  Lines lines;
  write_table(schema(), scope, "", lines);
  return lines;
}

}  // namespace physim
