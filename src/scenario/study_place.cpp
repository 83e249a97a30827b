// Places of studies written as people write them.
#include <algorithm>

#include "base/event_table.hpp"
#include "scenario/scenario.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

constexpr const char* kPlaceHint =
    "write it as \"800 m\" (a range), \"apex\", \"height 100 m falling\", \"time 2 s\", \"speed 340 m/s\", \"mach "
    "1\", \"burnout\", with quantities behind a colon: \"apex: y, time\"";

bool is_number_begin(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; }

std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find(' '));
  text = trimmed(text.substr(word.size()));
  return word;
}

/// "height 100 m falling"; a length alone is a range.
Result<EventSpec> event_of(std::string_view text) {
  EventSpec event{.kind = EventKind::range};
  if (text.empty()) return Error{"is no place", "", kPlaceHint};
  for (const Crossing direction : {Crossing::rising, Crossing::falling}) {
    const std::string_view word = name(direction);
    if (!text.ends_with(word)) continue;
    const std::string_view before = text.substr(0, text.size() - word.size()), place = trimmed(before);
    if (place.empty() || place.size() == before.size()) continue;  // "3 mfalling"
    event.direction = direction;
    text = place;
    break;
  }
  if (!is_number_begin(text.front())) {
    const std::string_view word = take_word(text);
    const auto kinds = names_of<EventKind>().first(watchable_kinds());
    const auto known = std::ranges::find(kinds, word);
    if (known == kinds.end())
      return Error{"no place on the way is called " + in_quotes(word), "", suggestion(word, kinds, "they are")};
    event.kind = static_cast<EventKind>(known - kinds.begin());
  }
  const bool has_value = row_of(event.kind).waits_for_value;
  if (!has_value && text.empty()) return event;
  if (!has_value) return Error{in_quotes(text) + " says nothing of " + in_quotes(name(event.kind)), "", "leave it out"};
  if (text.empty() && event.kind == EventKind::ground) return event;
  const auto value = parse_quantity(text, quantity_of_value(event.kind));
  if (!value) return value.error();
  event.value = *value;
  return event;
}

}  // namespace

Result<StudyPlace> parse_study_place(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto event = event_of(trimmed(text.substr(0, colon)));
  if (!event) return event.error();
  StudyPlace place{.event = *event};
  if (colon == text.npos) return place;
  for (std::string_view rest = text.substr(colon + 1);;) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = trimmed(rest.substr(0, comma));
    const auto quantity = value_of<StudyQuantity>(word);
    if (!quantity)
      return Error{"no quantity of a place is called " + in_quotes(word), "",
                   suggestion(word, names_of<StudyQuantity>(), "they are")};
    place.quantities.push_back(*quantity);
    if (comma == rest.npos) return place;
    rest.remove_prefix(comma + 1);
  }
}

std::string place_text(const EventSpec& event) {
  const bool is_plain_ground = event.kind == EventKind::ground && event.value == 0;
  const bool has_value = row_of(event.kind).waits_for_value && !is_plain_ground;
  std::string text = event.kind == EventKind::range ? "" : std::string(name(event.kind));
  if (has_value) text += (text.empty() ? "" : " ") + quantity_text(event.value, quantity_of_value(event.kind));
  const bool is_highest = event.kind == EventKind::apex && event.direction == Crossing::falling;
  const bool says_way = event.direction != Crossing::any && !is_highest;
  return text + (says_way ? " " + std::string(name(event.direction)) : "");
}

}  // namespace physim
