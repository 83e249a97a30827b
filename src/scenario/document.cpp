// toml++ in, a tree with places out. The only file that knows toml++.
#include "scenario/document.hpp"

#include <algorithm>
#include <charconv>
#include <tuple>

#include "base/assert.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

// toml++ 3.3 asserts (or, with NDEBUG, lets the compiler assume) that a file holds no "[[[", and other things that only
// hold for good files. Behind these checks it reports an ordinary error, so they are turned off, in debug builds too.
// Without exceptions its functions are noexcept, and memory that runs out would end the program.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#define TOML_EXCEPTIONS 1
#ifdef __clang__  // what it declares unreachable is reached by letters from U+00A1 to U+0499 outside of texts
#pragma clang attribute push(__attribute__((no_sanitize("unreachable"))), apply_to = function)
#endif
#include <toml++/toml.h>
#ifdef __clang__
#pragma clang attribute pop
#endif
#pragma pop_macro("NDEBUG")

namespace physim {
namespace {

using Source = std::shared_ptr<const std::string>;

Place place_of(const toml::source_region& region, const Source& source) {
  return {source, region.begin.line, region.begin.column};
}

Value converted(const toml::node& node, const Source& source);

Table converted_table(const toml::table& table, const Source& source) {
  Table out;
  for (const auto& [key, node] : table)
    out.push_back({std::string(key.str()), place_of(key.source(), source), converted(node, source)});
  // toml++ sorts by name; the first error of a file should be the first in the file.
  std::sort(out.begin(), out.end(), [](const Member& a, const Member& b) {
    return std::tie(a.key_place.line, a.key_place.column, a.key) <
           std::tie(b.key_place.line, b.key_place.column, b.key);
  });
  return out;
}

Array converted_array(const toml::array& array, const Source& source) {
  Array out;
  for (const toml::node& node : array) out.push_back(converted(node, source));
  return out;
}

Value converted(const toml::node& node, const Source& source) {
  Value out;
  out.place = place_of(node.source(), source);
  out.end = {node.source().end.line, node.source().end.column};
  if (const auto* table = node.as_table())
    out.content = converted_table(*table, source);
  else if (const auto* array = node.as_array())
    out.content = converted_array(*array, source);
  else if (const auto* text = node.as_string())
    out.content = text->get();
  else if (const auto* flag = node.as_boolean())
    out.content = flag->get();
  else if (const auto* integer = node.as_integer())
    out.content = integer->get();
  else if (const auto* real = node.as_floating_point())
    out.content = real->get();
  else
    out.content = Date{};
  return out;
}

/// toml++ parses "a.b.c = 1" without a limit of depth, but walks and frees the tree by recursion. Refusing absurd
/// depth beforehand keeps a hostile file from overflowing the stack. Finds the offset of the offence, if any.
std::size_t too_deep_at(std::string_view text) {
  constexpr int kMostDots = 500;
  int dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::string_view("=,[]{}#\n").find(text[i]) != std::string_view::npos) dots = 0;
    if (text[i] == '.' && ++dots > kMostDots) return i;
  }
  return std::string_view::npos;
}

Place place_at(std::string_view text, std::size_t offset, const Source& source) {
  PHYSIM_ASSERT(offset < text.size());
  const std::string_view before = text.substr(0, offset);
  const auto lines = static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {source, lines + 1, static_cast<std::uint32_t>(offset - line_start + 1)};
}

/// "Error while parsing string: encountered end-of-file" becomes "not valid TOML (string): encountered end-of-file".
Error syntax_error(const toml::parse_error& failure, const Source& source) {
  constexpr std::string_view kPrefix = "Error while parsing ";
  std::string_view what = failure.description();
  std::string message = "not valid TOML";
  if (const std::size_t colon = what.find(": "); what.starts_with(kPrefix) && colon != what.npos) {
    message += " (" + std::string(what.substr(kPrefix.size(), colon - kPrefix.size())) + ")";
    what.remove_prefix(colon + 2);
  }
  const bool twice = what.starts_with("cannot redefine");
  return {message + ": " + std::string(what), place_of(failure.source(), source).text(),
          twice ? "a name may stand only once in a table" : ""};
}

}  // namespace

std::string Place::text() const {
  const std::string name = source ? *source : std::string{};
  return line == 0 ? name : name + ":" + std::to_string(line) + ":" + std::to_string(column);
}

const Value* Value::find(std::string_view key) const {
  if (const Table* table = get<Table>())
    for (const Member& member : *table)
      if (is_same_key(member.key, key)) return &member.value;
  return nullptr;
}

Value* Value::find(std::string_view key) { return const_cast<Value*>(std::as_const(*this).find(key)); }

const Value& element(const Value& document, std::string_view list, std::size_t index) {
  const Value* value = document.find(list);
  PHYSIM_ASSERT(value != nullptr);
  const Array* array = value->get<Array>();
  PHYSIM_ASSERT(array != nullptr);
  PHYSIM_ASSERT(index < array->size());
  return (*array)[index];
}

PathInFile follow(const Value& table, std::string_view path) {
  const Value* value = &table;
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('.')), key = part.substr(0, part.find('['));
    path.remove_prefix(std::min(part.size() + 1, path.size()));
    const Value* next = value->find(key);
    if (next == nullptr) return {*value};
    value = next;
    const Array* list = value->get<Array>();
    if (key.size() == part.size() || list == nullptr) continue;
    std::size_t index = list->size();
    std::from_chars(part.data() + key.size() + 1, part.data() + part.size(), index);
    if (index >= list->size()) return {*value};
    value = &(*list)[index];
  }
  return {*value, true};
}

std::string place_of(const Value& table, std::string_view path) { return follow(table, path).nearest.place.text(); }

std::string_view kind_of(const Value& value) {
  static constexpr std::string_view kKinds[] = {"a boolean", "a number", "a number", "a text",
                                                "a date",    "an array", "a table"};
  PHYSIM_ASSERT(value.content.index() < std::size(kKinds));
  return kKinds[value.content.index()];
}

std::string shown(const Value& value) {
  if (const auto* text = value.get<std::string>()) return in_quotes(*text);
  if (const auto* flag = value.get<bool>()) return *flag ? "true" : "false";
  if (const auto* integer = value.get<std::int64_t>()) return std::to_string(*integer);
  if (const auto* real = value.get<double>()) return number_text(*real);
  return std::string(kind_of(value));
}

Result<Value> parse_document(std::string_view text, const std::string& file) {
  const auto source = std::make_shared<const std::string>(file);
  if (const std::size_t offset = too_deep_at(text); offset != std::string_view::npos)
    return Error{"a key of more than 500 parts", place_at(text, offset, source).text(), ""};
  try {
    Value document = converted(toml::parse(text), source);
    PHYSIM_ASSERT(document.get<Table>() != nullptr);
    return document;
  } catch (const toml::parse_error& failure) {
    return syntax_error(failure, source);
  }
}

namespace {

/// Whether a text may be a value of TOML; "170 gr" and "g7" are not. This is found without the parser, which ends the
/// program if memory runs out for the text of an error.
bool may_be_toml(std::string_view text) {
  constexpr std::string_view kBegins = "\"'[{+-0123456789";
  for (const std::string_view word : {"true", "false", "inf", "nan"})
    if (text.starts_with(word)) return true;
  if (text.empty() || kBegins.find(text.front()) == kBegins.npos) return false;
  if (kBegins.find(text.front()) < 4) return true;
  const std::size_t blank = text.find(' ');
  const char unit = blank != text.npos && blank + 1 < text.size() ? text[blank + 1] : '#';
  return unit == '#' || (unit >= '0' && unit <= '9');  // a comment, or the time of a date
}

}  // namespace

Value parse_override_value(std::string_view text, const Place& place) {
  Value out;
  const Result<Value> parsed = may_be_toml(text) ? parse_document("value = " + std::string(text), "")
                                                 : Result<Value>(Error{"is a plain text", "", ""});
  if (parsed && parsed->get<Table>()->size() == 1) {
    out = parsed->get<Table>()->front().value;
    // Places inside an override's text do not help: the whole of it is named.
    const auto set_place = [&place](auto& self, Value& value) -> void {
      value.place = place;
      if (Array* array = value.get<Array>())
        for (Value& element : *array) self(self, element);
      if (Table* table = value.get<Table>())
        for (Member& member : *table) member.key_place = place, self(self, member.value);
    };
    set_place(set_place, out);
  } else {
    out.content = std::string(text);
  }
  out.place = place;
  out.raw = std::make_shared<const std::string>(text);
  return out;
}

}  // namespace physim
