// Values of settings from a document: types, units, ranges and unknown keys are checked here, for all settings alike.
#include "scenario/reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/assert.hpp"
#include "scenario/mistakes.hpp"
#include "scenario/read_values.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim {

Error fault(std::string_view path, const Value& value, const std::string& message, const std::string& hint) {
  return {std::string(path) + ": " + message, value.place.text(), hint};
}

Error wrong_kind(std::string_view path, const Value& value, const std::string& wanted) {
  return fault(path, value, "found " + std::string(kind_of(value)), "expected " + wanted);
}

// ------------------------------------------------------------------------------------------------------------- numbers
namespace {

constexpr std::size_t kMostRanges = 100'000;  // values in output.ranges

Error out_of_range(const Wanted& wanted, const Value& value, double number) {
  if (!std::isfinite(number))
    return fault(wanted.path, value, shown(value) + " is not a finite number", expected(wanted.quantity));
  const std::string unit(si_unit(wanted.quantity));
  std::string hint = "must be " + wanted.range.text();
  if (wanted.range.words.empty() && !unit.empty()) hint += " " + unit;
  if (value.get<std::string>() == nullptr && !unit.empty()) hint += "; a bare number is in " + unit;
  return fault(wanted.path, value, shown(value) + " is out of range", hint);
}

}  // namespace

Status read_number(const Wanted& wanted, const Value& value, double& target) {
  double number = 0;
  if (const auto* integer = value.get<std::int64_t>()) {
    number = static_cast<double>(*integer);
  } else if (const auto* real = value.get<double>()) {
    number = *real;
  } else if (const auto* text = value.get<std::string>()) {
    const Result<double> parsed = parse_quantity(*text, wanted.quantity);
    if (!parsed) return fault(wanted.path, value, parsed.error().message, parsed.error().hint);
    number = *parsed;
  } else {
    const QuantityInfo& quantity = info(wanted.quantity);
    return wrong_kind(wanted.path, value,
                      std::string(quantity.with_article) + " such as " + in_quotes(quantity.example));
  }
  if (!wanted.range.contains(number)) return out_of_range(wanted, value, number);
  target = number;
  return {};
}

namespace {

void read_vector(const Wanted& wanted, const Value& value, Vec3d& target, Mistakes& mistakes) {
  const Array* array = value.get<Array>();
  if (array == nullptr || array->size() != 3) {
    mistakes.take(array == nullptr ? wrong_kind(wanted.path, value, "three components [x, y, z]")
                                   : fault(wanted.path, value, "found " + std::to_string(array->size()) + " components",
                                           "expected three components [x, y, z]"));
    return;
  }
  const std::size_t before = mistakes.count();
  double v[3];
  for (std::size_t i = 0; i < 3; ++i) mistakes.take(read_number(wanted, (*array)[i], v[i]));
  if (mistakes.count() == before) target = {v[0], v[1], v[2]};
}

Status read_integer(const Entry& entry, const Value& value, std::int64_t& target) {
  constexpr double kExact = 9007199254740992.0;  // 2^53: doubles up to here are exact integers
  if (const auto* integer = value.get<std::int64_t>()) {
    target = *integer;
  } else if (const auto* real = value.get<double>(); real && std::floor(*real) == *real && std::abs(*real) <= kExact) {
    target = static_cast<std::int64_t>(*real);
  } else {
    return fault(entry.path, value, shown(value) + " is not a whole number", "expected a whole number such as 1000");
  }
  const auto number = static_cast<double>(target);
  if (!entry.range.contains(number)) return out_of_range({entry.path, Quantity::number, entry.range}, value, number);
  return {};
}

// --------------------------------------------------------------------------------------------------------------- texts
/// UTF-8 without overlong forms, surrogates and values beyond Unicode. Files are checked by their parser, overrides
/// here.
bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i++]);
    if (first < 0x80) continue;
    const int more = first >= 0xC2 && first <= 0xDF   ? 1
                     : (first & 0xF0) == 0xE0         ? 2
                     : first >= 0xF0 && first <= 0xF4 ? 3
                                                      : 0;
    if (more == 0 || text.size() - i < static_cast<std::size_t>(more)) return false;
    std::uint32_t code = first & (0x3FU >> more);
    for (int k = 0; k < more; ++k) {
      const auto next = static_cast<unsigned char>(text[i++]);
      if ((next & 0xC0) != 0x80) return false;
      code = code << 6 | (next & 0x3FU);
    }
    PHYSIM_ASSERT(i <= text.size());
    constexpr std::uint32_t kLeast[] = {0, 0x80, 0x800, 0x10000};
    if (code < kLeast[more] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return false;
  }
  return true;
}

Status read_text(const Entry& entry, const Value& value, std::string& target) {
  if (const auto* text = value.get<std::string>())
    target = *text;
  else if (value.raw != nullptr)
    target = *value.raw;  // --set title=2024
  else
    return fault(entry.path, value, "found " + std::string(kind_of(value)), "expected a text in quotes");
  if (!is_utf8(target)) return fault(entry.path, value, "the text is not UTF-8", "");
  return {};
}

/// Names that files of release 0.1 have.
struct FormerName {
  std::string_view former, name;
};
constexpr FormerName kFormerNames[] = {{"sport_ball", "constant_air"}};

Status read_choice(const Entry& entry, const Value& value, const Choice& choice, Scenario& scenario) {
  PHYSIM_ASSERT(!choice.names.empty());
  const auto* text = value.get<std::string>();
  const auto take = [&](std::string_view name) {
    const auto found = std::ranges::find(choice.names, name);
    if (found == choice.names.end()) return false;
    choice.set(static_cast<std::size_t>(found - choice.names.begin()));
    return true;
  };
  if (text != nullptr && take(*text)) return {};
  for (const FormerName& known : kFormerNames)
    if (text != nullptr && *text == known.former && take(known.name)) {
      const std::string note = std::string(entry.path) + ": " + shown(value) + " is now called \"";
      scenario.notes.push_back(value.place.text() + ": " + note + std::string(known.name) + "\"");
      return {};
    }
  return fault(entry.path, value, "unknown value " + shown(value),
               suggestion(text ? *text : std::string{}, choice.names, "known values"));
}

}  // namespace

// --------------------------------------------------------------------------------------------------------------- lists
Status check_length(std::string_view path, const Value& value, std::size_t length, const Range& range) {
  if (range.contains(static_cast<double>(length))) return {};
  return fault(
      path, value,
      std::to_string(length) + " entries are " + (static_cast<double>(length) < range.low ? "too few" : "too many"),
      "allowed are " + range.text());
}

namespace {

/// Thrust may jump: two points at one time are a step.
bool may_step(const Points& points) { return points.quantities[1] == Quantity::force; }

/// A point comes behind the one before it; `points`: those before.
Status check_order(const Entry& entry, const Value& at, const Points& points, const Points::Pairs& pairs, double next) {
  if (pairs.empty() || next > pairs.back().first) return {};
  const bool is_third = pairs.size() > 1 && pairs[pairs.size() - 2].first == next;
  if (next == pairs.back().first && may_step(points) && !is_third) return {};
  return fault(entry.path, at,
               std::string(points.names[0]) + " " + number_text(next) + " after " + number_text(pairs.back().first),
               may_step(points) ? "they must rise; two points at one time are a step" : "they must rise");
}

/// The list of a value, if its length is allowed; else null, and a mistake is noted.
const Array* list_of(std::string_view path, const Value& value, const Range& length, const std::string& wanted,
                     Mistakes& mistakes) {
  const Array* array = value.get<Array>();
  const Status status =
      array == nullptr ? wrong_kind(path, value, wanted) : check_length(path, value, array->size(), length);
  return mistakes.take(status) ? array : nullptr;
}

}  // namespace

void read_points(const Entry& entry, const Value& value, const Points& points, Mistakes& mistakes) {
  const std::string wanted =
      "points [[" + std::string(points.names[0]) + ", " + std::string(points.names[1]) + "], ...]";
  const std::size_t before = mistakes.count();
  const Array* array = list_of(entry.path, value, entry.range, wanted, mistakes);
  if (array == nullptr) return;
  Points::Pairs pairs;
  for (const Value& point : *array) {
    const Array* pair = point.get<Array>();
    if (pair == nullptr || pair->size() != 2) {
      mistakes.take(fault(entry.path, point, "this is no point", "expected " + wanted));
      continue;
    }
    double xy[2] = {};
    bool good[2];
    for (std::size_t i = 0; i < 2; ++i)
      good[i] = mistakes.take(read_number({entry.path, points.quantities[i], points.ranges[i]}, (*pair)[i], xy[i]));
    if (!good[0]) continue;
    mistakes.take(check_order(entry, (*pair)[0], points, pairs, xy[0]));
    pairs.emplace_back(xy[0], xy[1]);
  }
  if (mistakes.count() == before) points.set(pairs);
}

namespace {

/// The point of a list of two or three numbers; the angle in square degrees.
std::optional<AeroPoint> read_aero_point(const Entry& entry, const Value& point, const std::string& wanted,
                                         Mistakes& mistakes) {
  const Wanted plain{entry.path, Quantity::number, {}}, place{entry.path, Quantity::number, {.low = 0}};
  const Array* numbers = point.get<Array>();
  if (numbers == nullptr || numbers->size() < 2 || numbers->size() > 3) {
    mistakes.take(fault(entry.path, point, "this is no point", "expected " + wanted));
    return std::nullopt;
  }
  const std::size_t before = mistakes.count();
  double number[3] = {};
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    const bool last = i + 1 == numbers->size();
    mistakes.take(read_number(last ? plain : place, (*numbers)[i], number[last ? 2 : i]));
  }
  if (mistakes.count() > before) return std::nullopt;
  PHYSIM_ASSERT(number[1] >= 0);  // an angle, and never the value of a point of two numbers
  return AeroPoint{number[0], number[1] * kSquareDegree, number[2]};
}

/// A number, or points at rising Mach numbers.
void read_aero(const Entry& entry, const Value& value, AeroCoefficient& coefficient, Mistakes& mistakes) {
  const std::string wanted = "a number, [[Mach number, value], ...] or [[Mach number, angle^2 in deg^2, value], ...]";
  const Array* array = value.get<Array>();
  if (array == nullptr) {
    double constant = 0;
    if (read_number({entry.path, Quantity::number, {}}, value, constant))
      coefficient = {{0, 0, constant}};
    else
      mistakes.take(fault(entry.path, value, "found " + std::string(kind_of(value)), "expected " + wanted));
    return;
  }
  coefficient.clear();
  for (const Value& point : *array) {
    const auto next = read_aero_point(entry, point, wanted, mistakes);
    if (!next) continue;
    const bool rises =
        coefficient.empty() || next->mach > coefficient.back().mach ||
        (next->mach == coefficient.back().mach && next->angle_squared > coefficient.back().angle_squared);
    if (!rises)
      mistakes.take(
          fault(entry.path, point, "this point comes after a later one", "Mach numbers must rise, and angles at each"));
    coefficient.push_back(*next);
  }
}

Status read_reference(const Entry& entry, const Value& value, const Reference& reference) {
  std::string text;
  if (Status status = read_text(entry, value, text); !status) return status;
  const Status status = reference.follow(text);
  if (status) return {};
  const Error& bad = status.error();
  return Error{std::string(entry.path) + ": " + bad.message, bad.place.empty() ? value.place.text() : bad.place,
               bad.hint};
}

/// from, from + step, ... up to and including `to`.
Status fill_steps(const Wanted& wanted, const Value& value, const double (&steps)[3], std::vector<double>& list) {
  constexpr double kSlack = 1e-9;  // of a step, so that 0.1 .. 1 step 0.1 reaches 1
  PHYSIM_ASSERT(list.empty());
  const auto [from, to, step] = steps;
  if (!(step > 0) || to < from) return fault(wanted.path, value, "the steps lead nowhere", "from <= to and step > 0");
  const double count = std::floor((to - from) / step + kSlack) + 1;
  if (!(count <= static_cast<double>(kMostRanges)))
    return fault(wanted.path, value, "too many steps", "at most " + std::to_string(kMostRanges));
  for (int i = 0; i < static_cast<int>(count); ++i) list.push_back(from + i * step);
  if (std::abs(list.back() - to) <= kSlack * step) list.back() = to;  // without what was rounded on the way
  return {};
}

/// { from = "100 m", to = "1000 m", step = "100 m" }
Status read_steps_table(const Wanted& wanted, const Value& value, std::vector<double>& list) {
  static constexpr std::string_view kKeys[] = {"from", "to", "step"};
  double numbers[3];
  for (const Member& member : *value.get<Table>())
    if (std::find(std::begin(kKeys), std::end(kKeys), member.key) == std::end(kKeys))
      return Error{"unknown key " + in_quotes(member.key) + " in [ranges]", member.key_place.text(),
                   suggestion(member.key, kKeys, "known keys")};
  for (std::size_t i = 0; i < 3; ++i) {
    const Value* number = value.find(kKeys[i]);
    if (number == nullptr)
      return fault(wanted.path, value, "missing key " + in_quotes(kKeys[i]), "expected { from, to, step }");
    if (Status status = read_number(wanted, *number, numbers[i]); !status) return status;
  }
  return fill_steps(wanted, value, numbers, list);
}

/// "100 m .. 1000 m step 100 m", or one value.
Status read_steps_text(const Wanted& wanted, const Value& value, std::vector<double>& list) {
  constexpr std::string_view kTo = "..", kStep = "step";
  const std::string& text = *value.get<std::string>();
  const std::size_t to = text.find(kTo), step = text.find(kStep);
  if (to == text.npos) return read_number(wanted, value, list.emplace_back());
  if (step == text.npos || step < to)
    return fault(wanted.path, value, in_quotes(text) + " has no step", "expected \"100 m .. 1000 m step 100 m\"");
  const std::string parts[] = {text.substr(0, to), text.substr(to + kTo.size(), step - to - kTo.size()),
                               text.substr(step + kStep.size())};
  double numbers[3];
  for (std::size_t i = 0; i < 3; ++i) {
    Value piece = value;
    piece.content = parts[i];
    if (Status status = read_number(wanted, piece, numbers[i]); !status) return status;
  }
  return fill_steps(wanted, value, numbers, list);
}

void read_numbers(const Wanted& wanted, const Value& value, std::vector<double>& list, Mistakes& mistakes) {
  list.clear();
  if (value.get<Table>()) {
    mistakes.take(read_steps_table(wanted, value, list));
  } else if (value.get<std::string>()) {
    mistakes.take(read_steps_text(wanted, value, list));
  } else if (const Array* array = list_of(wanted.path, value, {.low = 0, .high = double{kMostRanges}},
                                          "a list such as [\"100 m\", \"200 m\"]", mistakes)) {
    for (const Value& element : *array) mistakes.take(read_number(wanted, element, list.emplace_back()));
  }
}

/// ["a", "b"], or one text alone.
void read_texts(const Entry& entry, const Value& value, std::vector<std::string>& list, Mistakes& mistakes) {
  list.clear();
  if (value.get<std::string>() != nullptr) {
    mistakes.take(read_text(entry, value, list.emplace_back()));
  } else if (const Array* array = list_of(entry.path, value, {}, "a list of texts such as [\"a\", \"b\"]", mistakes)) {
    for (const Value& each : *array) mistakes.take(read_text(entry, each, list.emplace_back()));
  }
}

/// [[x, y, z], ...]
void read_vectors(const Wanted& wanted, const Value& value, std::vector<Vec3d>& list, Mistakes& mistakes) {
  list.clear();
  if (const Array* array = list_of(wanted.path, value, wanted.range, "a list of places [[x, y, z], ...]", mistakes))
    for (const Value& each : *array)
      read_vector({wanted.path, wanted.quantity, {}}, each, list.emplace_back(), mistakes);
}

/// [a, b, c]; false if the value is no triangle.
bool read_triangle(const Value& value, Triangle& triangle) {
  const Array* corners = value.get<Array>();
  if (corners == nullptr || corners->size() != 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* index = (*corners)[i].get<std::int64_t>();
    if (index == nullptr || !std::in_range<std::uint32_t>(*index)) return false;
    triangle[i] = static_cast<std::uint32_t>(*index);
  }
  return true;
}

/// [[a, b, c], ...]
void read_triangles(const Entry& entry, const Value& value, std::vector<Triangle>& list, Mistakes& mistakes) {
  const std::string wanted = "triangles [[a, b, c], ...] of numbers of vertices, from 0";
  list.clear();
  if (const Array* array = list_of(entry.path, value, entry.range, wanted, mistakes))
    for (const Value& each : *array)
      if (!read_triangle(each, list.emplace_back()))
        mistakes.take(fault(entry.path, each, "this is no triangle", "expected " + wanted));
}

void read_table_into(const SchemaNode& node, const Scope& scope, const Value& value, Mistakes& mistakes);

void read_records(const SchemaNode& node, const Records& records, const Value& value, Mistakes& mistakes) {
  const Array* array = value.get<Array>();
  if (!mistakes.take(array ? check_length(node.path, value, array->size(), node.entry->range)
                           : wrong_kind(node.path, value, "a list of tables; write [[" + node.path + "]]")))
    return;
  records.resize(0);  // old elements go, so that new ones start from defaults
  records.resize(array->size());
  PHYSIM_ASSERT(records.size() == array->size());
  for (std::size_t i = 0; i < array->size() && !mistakes.is_full(); ++i)
    read_table_into(node, records.element(i), (*array)[i], mistakes);
}

// ------------------------------------------------------------------------------------------------------------ settings
bool is_none(const Entry& entry, const Value& value) {
  const auto* text = value.get<std::string>();
  return text != nullptr && *text == entry.none;
}

template <class Number, class Read>
Status read_optional(const Entry& entry, const Value& value, const Optional<Number>& target, const Read& read) {
  if (is_none(entry, value)) return target.set(std::nullopt), Status();
  Number number = 0;
  if (Status status = read(number); !status) return status;
  return target.set(number), Status();
}
Status read_boolean(const Entry& entry, const Value& value, bool& target) {
  if (value.get<bool>() == nullptr) return wrong_kind(entry.path, value, "true or false");
  return target = *value.get<bool>(), Status();
}

/// A setting that is no list of tables.
void read_value(const Entry& entry, const Scope& scope, const Value& value, const ValueRef& into, Mistakes& all) {
  const Wanted wanted{entry.path, entry.quantity_in(scope), entry.range};
  const Overloaded readers{
      [&](double* target) { all.take(read_number(wanted, value, *target)); },
      [&](const OptionalNumber& target) {
        all.take(read_optional(entry, value, target, [&](double& x) { return read_number(wanted, value, x); }));
      },
      [&](Vec3d* target) { read_vector(wanted, value, *target, all); },
      [&](std::optional<Vec3d>* target) {
        target->reset();
        if (!is_none(entry, value)) read_vector(wanted, value, target->emplace(), all);
      },
      [&](const Integer& target) {
        std::int64_t number = 0;
        if (all.take(read_integer(entry, value, number))) target.set(number);
      },
      [&](const OptionalInteger& target) {
        all.take(read_optional(entry, value, target, [&](std::int64_t& n) { return read_integer(entry, value, n); }));
      },
      [&](bool* target) { all.take(read_boolean(entry, value, *target)); },
      [&](std::string* target) { all.take(read_text(entry, value, *target)); },
      [&](const Choice& choice) { all.take(read_choice(entry, value, choice, *scope.scenario)); },
      [&](const Reference& reference) { all.take(read_reference(entry, value, reference)); },
      [&](const Points& points) { read_points(entry, value, points, all); },
      [&](AeroCoefficient* coefficient) { read_aero(entry, value, *coefficient, all); },
      [&](DrawnNumber* number) { read_drawn(wanted, value, *number, all); },
      [&](DrawnColour* colour) { read_drawn(entry.path, value, *colour, all); },
      [&](Gradient* gradient) { read_gradient(entry.path, value, *gradient, all); },
      [&](std::vector<double>* list) { read_numbers(wanted, value, *list, all); },
      [&](std::vector<std::string>* list) { read_texts(entry, value, *list, all); },
      [&](std::vector<Vec3d>* list) { read_vectors(wanted, value, *list, all); },
      [&](std::vector<Triangle>* list) { read_triangles(entry, value, *list, all); },
      [&](const Records&) { PHYSIM_UNREACHABLE(); },
  };
  std::visit(readers, into);
}

void read_setting_into(const SchemaNode& node, const Scope& scope, const Value& value, Mistakes& mistakes) {
  PHYSIM_ASSERT(node.entry != nullptr);
  const ValueRef into = node.entry->slot(scope);
  if (const auto* records = std::get_if<Records>(&into)) return read_records(node, *records, value, mistakes);
  read_value(*node.entry, scope, value, into, mistakes);
}

}  // namespace

Status read_setting(const SchemaNode& node, const Scope& scope, const Value& value) {
  Mistakes mistakes;
  read_setting_into(node, scope, value, mistakes);
  return mistakes.status();
}

// -------------------------------------------------------------------------------------------------------------- tables
std::string hint_of_key(std::string_view table, std::string_view key) {
  static constexpr std::string_view kWind[] = {"speed", "from", "direction", "angle", "azimuth", "bearing", "heading"};
  if (table != "environment.wind" || std::ranges::find(kWind, key) == std::end(kWind)) return {};
  return "wind is a velocity of x downrange, y up, z right: velocity = [0, 0, \"-5 m/s\"] comes from the right with "
         "5 m/s; only inputs of studies have speed and from";
}

namespace {

std::string table_name(const SchemaNode& node) { return node.name.empty() ? "the file" : "[" + node.name + "]"; }

/// The path of the table that has such a key, for keys that stand in the wrong place. Tables of the file are no keys.
const SchemaNode* parent_of_key(const SchemaNode& node, std::string_view key) {
  const SchemaNode* here = node.find(key);
  if (here != nullptr && !(node.path.empty() && !here->children.empty())) return &node;
  for (const SchemaNode& child : node.children)
    if (const SchemaNode* found = parent_of_key(child, key)) return found;
  return nullptr;
}

Error unknown_key(const SchemaNode& node, const Member& member) {
  if (std::string hint = hint_of_key(node.path, member.key); !hint.empty())
    return {"unknown key " + in_quotes(member.key) + " in " + table_name(node), member.key_place.text(), hint};
  std::vector<std::string_view> names;
  for (const SchemaNode& child : node.children) names.push_back(child.name);
  std::string hint = suggestion(member.key, names, "known keys");
  if (nearest(member.key, names).empty())
    if (const SchemaNode* owner = parent_of_key(schema(), member.key))
      hint = in_quotes(member.key) + " belongs " +
             (owner->name.empty() ? "above the first table" : "into [" + owner->path + "]");
  return {"unknown key " + in_quotes(member.key) + " in " + table_name(node), member.key_place.text(), hint};
}

/// True if an unknown key of the table is a misspelling of this one, which has an error of its own.
bool is_misspelt(const SchemaNode& node, const Table& table, const SchemaNode& child) {
  std::vector<std::string_view> names;
  for (const SchemaNode& each : node.children) names.push_back(each.name);
  return std::ranges::any_of(table, [&](const Member& member) {
    return node.find(member.key) == nullptr && nearest(member.key, names) == child.name;
  });
}

void read_child(const SchemaNode& child, const Scope& scope, const Value& value, Mistakes& mistakes) {
  if (child.entry != nullptr) return read_setting_into(child, scope, value, mistakes);
  if (value.get<Table>() != nullptr || child.shorthand.empty()) return read_table_into(child, scope, value, mistakes);
  const SchemaNode* shorthand = child.find(child.shorthand);
  PHYSIM_ASSERT(shorthand != nullptr);
  read_setting_into(*shorthand, scope, value, mistakes);
}

bool is_choice(const SchemaNode& node, const Scope& scope) {
  return node.entry != nullptr && std::holds_alternative<Choice>(node.entry->slot(scope));
}
bool has_all_choices(const SchemaNode& node, const Scope& scope, const Value& table) {
  return std::ranges::none_of(node.children, [&](const SchemaNode& child) {
    return child.entry != nullptr && child.entry->required && table.find(child.name) == nullptr &&
           is_choice(child, scope);
  });
}

void read_table_into(const SchemaNode& node, const Scope& scope, const Value& value, Mistakes& mistakes) {
  const Table* table = value.get<Table>();
  if (table == nullptr) {
    mistakes.take(not_a_table(node, value));
    return;
  }
  // In the order of the list: presets come before what changes them, kinds before their values.
  std::vector<std::pair<const SchemaNode*, const Value*>> given;
  given.reserve(table->size());
  for (const Member& member : *table) {
    if (const SchemaNode* child = node.find(member.key))
      given.emplace_back(child, &member.value);
    else
      mistakes.take(unknown_key(node, member));
  }
  std::ranges::sort(given);
  PHYSIM_ASSERT(std::ranges::adjacent_find(given, {}, [](const auto& each) { return each.first; }) == given.end());
  const auto goes_by_another = [](const SchemaNode& child) {
    return child.entry != nullptr && child.entry->quantity_by != nullptr;
  };
  const bool has_such = std::ranges::any_of(given, [&](const auto& each) { return goes_by_another(*each.first); });
  bool is_sound = !has_such || !mistakes.needs_all() || has_all_choices(node, scope, value);
  for (const auto& [child, found] : given) {
    if (!is_sound && goes_by_another(*child)) continue;  // its unit is not known
    const std::size_t before = mistakes.count();
    read_child(*child, scope, *found, mistakes);
    if (has_such && mistakes.count() > before && is_choice(*child, scope)) is_sound = false;
  }
  for (const SchemaNode& child : node.children)
    if (child.entry != nullptr && child.entry->required && mistakes.needs_all() && value.find(child.name) == nullptr &&
        !is_misspelt(node, *table, child))
      mistakes.take(Error{"missing key " + in_quotes(child.name) + " in " + table_name(node), value.place.text(),
                          std::string(child.entry->doc)});
}

}  // namespace

Error not_a_table(const SchemaNode& node, const Value& value) {
  std::string keys;
  for (const SchemaNode& child : node.children) keys += (keys.empty() ? "" : ", ") + child.name;
  return wrong_kind(node.path, value, "a table with keys out of: " + keys);
}

Status read_table(const SchemaNode& node, const Scope& scope, const Value& value, Checks checks) {
  Mistakes mistakes(checks != Checks::of_each);
  read_table_into(node, scope, value, mistakes);
  return mistakes.status();
}

}  // namespace physim
