// Numbers and colours that emitters draw: constants, two bounds, or tables with curves over a span.
#include <array>
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
Status read_keys(std::string_view path, const Value& table, KeyNames names, const ReadEnd& end,
                 const ReadCurve& curve) {
  PHYSIM_ASSERT(names.size() == 4);
  if (Status status = check_keys(path, table, names); !status) return status;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Value* value = table.find(names[i]);
    if (value == nullptr) continue;
    if (Status status = i < 2 ? end(*value, i == 1) : curve(*value, i == 3); !status) return status;
  }
  return {};
}

/// The two bounds of a list, or the one value.
template <class ReadEnd>
Status read_ends(std::string_view path, const Value& value, const std::string& wanted, const ReadEnd& end) {
  const Array* array = value.get<Array>();
  if (array == nullptr) return end(value, false);
  if (array->size() != 2)
    return fault(path, value, "found " + std::to_string(array->size()) + " entries", "expected " + wanted);
  if (Status status = end((*array)[0], false); !status) return status;
  return end((*array)[1], true);
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

Status read_drawn(const Wanted& wanted, const Value& value, DrawnNumber& target) {
  DrawnNumber read;
  const auto end = [&](const Value& from, bool is_to) {
    return read_number(wanted, from, is_to ? read.to.emplace() : read.value);
  };
  const auto curve = [&](const Value& from, bool is_to) {
    const Entry entry{{.path = wanted.path, .range = kCurveKeys}};
    const ValueRef points = points_of(is_to ? read.to_curve : read.curve);
    return read_points(entry, from, std::get<Points>(points));
  };
  const Status status = value.get<Table>() != nullptr
                            ? read_keys(wanted.path, value, kNumberKeys, end, curve)
                            : read_ends(wanted.path, value, "a value, or two to draw from: [low, high]", end);
  if (status) target = std::move(read);
  return status;
}

Status read_drawn(std::string_view path, const Value& value, DrawnColour& target) {
  DrawnColour read;
  const auto end = [&](const Value& from, bool is_to) {
    return read_colour(path, from, is_to ? read.to.emplace() : read.colour);
  };
  const auto gradient = [&](const Value& from, bool is_to) {
    return read_gradient(path, from, is_to ? read.to_gradient : read.gradient);
  };
  const Status status = value.get<Table>() != nullptr ? read_keys(path, value, kColourKeys, end, gradient)
                                                      : read_ends(path, value, "a colour, or two to draw from", end);
  if (status) target = std::move(read);
  return status;
}

Status read_gradient(std::string_view path, const Value& value, Gradient& target) {
  const std::string wanted = "colours [[part of the span, \"#rrggbb\"], ...]";
  const Array* array = value.get<Array>();
  if (array == nullptr) return wrong_kind(path, value, wanted);
  if (Status status = check_length(path, value, array->size(), kCurveKeys); !status) return status;
  Gradient read;
  for (const Value& key : *array) {
    const Array* pair = key.get<Array>();
    if (pair == nullptr || pair->size() != 2) return fault(path, key, "this is no key", "expected " + wanted);
    ColourKey next;
    if (Status status = read_number({path, Quantity::number, kFraction}, (*pair)[0], next.at); !status) return status;
    if (Status status = read_colour(path, (*pair)[1], next.colour); !status) return status;
    if (!read.empty() && next.at <= read.back().at)
      return fault(path, (*pair)[0],
                   "part of the span " + number_text(next.at) + " after " + number_text(read.back().at),
                   "they must rise");
    read.push_back(next);
  }
  target = std::move(read);
  return {};
}

}  // namespace physim
