// Numbers and colours that emitters draw: constants, two bounds, or tables with curves over a span.
#include <charconv>
#include <utility>

#include "base/assert.hpp"
#include "scenario/read_values.hpp"
#include "scenario/settings_parts.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

/// Keys of a table that stands for a value; the first must be there.
using KeyNames = std::span<const std::string_view>;
constexpr std::string_view kNumberKeys[] = {"value", "to", "curve", "to_curve"};
constexpr std::string_view kColourKeys[] = {"colour", "to", "gradient", "to_gradient"};

Status check_keys(std::string_view path, const Value& table, KeyNames names) {
  for (const Member& member : *table.get<Table>())
    if (std::ranges::count(names, member.key) == 0)
      return Error{std::string(path) + ": unknown key " + in_quotes(member.key), member.key_place.text(),
                   suggestion(member.key, names, "known keys")};
  if (table.find(names.front()) != nullptr) return {};
  std::string all;
  for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  return fault(path, table, "missing key " + in_quotes(names.front()), "expected { " + all + " }");
}

/// Reads { value, to, curve, to_curve } by handing each key that exists to the reader of its kind.
template <class ReadEnd, class ReadCurve>
void read_keys(std::string_view path, const Value& table, KeyNames names, const ReadEnd& end, const ReadCurve& curve,
               Mistakes& mistakes) {
  PHYSIM_ASSERT(names.size() == 4);
  mistakes.take(check_keys(path, table, names));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Value* value = table.find(names[i]);
    if (value == nullptr) continue;
    if (i < 2)
      mistakes.take(end(*value, i == 1));
    else
      curve(*value, i == 3);
  }
}

/// The two bounds of a list, or the one value.
template <class ReadEnd>
void read_ends(std::string_view path, const Value& value, const std::string& wanted, const ReadEnd& end,
               Mistakes& mistakes) {
  const Array* array = value.get<Array>();
  if (array != nullptr && array->size() != 2) {
    mistakes.take(fault(path, value, "found " + std::to_string(array->size()) + " entries", "expected " + wanted));
    return;
  }
  mistakes.take(end(array ? (*array)[0] : value, false));
  if (array != nullptr) mistakes.take(end((*array)[1], true));
}

Status read_colour(std::string_view path, const Value& value, std::uint32_t& target) {
  constexpr std::string_view kWanted = "a colour such as \"#ff8000\", with transparency \"#ff800080\"";
  if (const auto* number = value.get<std::int64_t>()) {
    if (!std::in_range<std::uint32_t>(*number))
      return fault(path, value, shown(value) + " is no colour", "expected " + std::string(kWanted));
    return target = static_cast<std::uint32_t>(*number), Status();
  }
  const auto* text = value.get<std::string>();
  if (text == nullptr) return wrong_kind(path, value, std::string(kWanted));
  std::uint32_t colour = 0;
  const char* const end = text->data() + text->size();
  const bool is_long_enough = text->size() == 7 || text->size() == 9;
  const auto read = std::from_chars(text->data() + (text->empty() ? 0 : 1), end, colour, 16);
  if (!is_long_enough || (*text)[0] != '#' || read.ec != std::errc() || read.ptr != end)
    return fault(path, value, shown(value) + " is no colour", "expected " + std::string(kWanted));
  target = text->size() == 7 ? colour << 8 | 0xffU : colour;
  return {};
}

}  // namespace

void read_drawn(const Wanted& wanted, const Value& value, DrawnNumber& target, Mistakes& mistakes) {
  const std::size_t before = mistakes.count();
  DrawnNumber read;
  const auto end = [&](const Value& from, bool is_to) {
    return read_number(wanted, from, is_to ? read.to.emplace() : read.value);
  };
  const auto curve = [&](const Value& from, bool is_to) {
    const Entry entry{{.path = wanted.path, .range = kCurveKeys}};
    const ValueRef points = points_of(is_to ? read.to_curve : read.curve);
    read_points(entry, from, std::get<Points>(points), mistakes);
  };
  if (value.get<Table>() != nullptr)
    read_keys(wanted.path, value, kNumberKeys, end, curve, mistakes);
  else
    read_ends(wanted.path, value, "a value, or two to draw from: [low, high]", end, mistakes);
  if (mistakes.count() == before) target = std::move(read);
}

void read_drawn(std::string_view path, const Value& value, DrawnColour& target, Mistakes& mistakes) {
  const std::size_t before = mistakes.count();
  DrawnColour read;
  const auto end = [&](const Value& from, bool is_to) {
    return read_colour(path, from, is_to ? read.to.emplace() : read.colour);
  };
  const auto gradient = [&](const Value& from, bool is_to) {
    read_gradient(path, from, is_to ? read.to_gradient : read.gradient, mistakes);
  };
  if (value.get<Table>() != nullptr)
    read_keys(path, value, kColourKeys, end, gradient, mistakes);
  else
    read_ends(path, value, "a colour, or two to draw from", end, mistakes);
  if (mistakes.count() == before) target = std::move(read);
}

void read_gradient(std::string_view path, const Value& value, Gradient& target, Mistakes& mistakes) {
  const std::string wanted = "colours [[part of the span, \"#rrggbb\"], ...]";
  const std::size_t before = mistakes.count();
  const Array* array = value.get<Array>();
  if (!mistakes.take(array ? check_length(path, value, array->size(), kCurveKeys) : wrong_kind(path, value, wanted)))
    return;
  Gradient read;
  for (const Value& key : *array) {
    const Array* pair = key.get<Array>();
    if (pair == nullptr || pair->size() != 2) {
      mistakes.take(fault(path, key, "this is no key", "expected " + wanted));
      continue;
    }
    ColourKey next;
    mistakes.take(read_colour(path, (*pair)[1], next.colour));
    if (!mistakes.take(read_number({path, Quantity::number, kFraction}, (*pair)[0], next.at))) continue;
    if (!read.empty() && next.at <= read.back().at)
      mistakes.take(fault(path, (*pair)[0],
                          "part of the span " + number_text(next.at) + " after " + number_text(read.back().at),
                          "they must rise"));
    read.push_back(next);
  }
  if (mistakes.count() == before) target = std::move(read);
}

}  // namespace physim
