#include "scenario/text_places.hpp"

#include <algorithm>
#include <tuple>

#include "base/assert.hpp"

namespace physim {

std::size_t TextPlaces::offset_of(const Value::Position& position) {
  if (std::tie(position.line, position.column) < std::tie(last_.line, last_.column)) last_ = {1, 1}, at_ = 0;
  for (; last_.line < position.line; ++last_.line, last_.column = 1)
    at_ = text_.empty() ? 0 : std::min(text_.find('\n', at_), text_.size() - 1) + 1;
  const auto is_inside = [this](std::size_t i) { return i < text_.size() && (text_[i] & 0xC0) == 0x80; };
  for (; last_.column < position.column && at_ < text_.size(); ++last_.column) do
      ++at_;
    while (is_inside(at_));
  PHYSIM_ASSERT(at_ <= text_.size());
  return at_;
}

std::string_view TextPlaces::said_of(const Value& value) {
  const std::size_t begin = begin_of(value), end = end_of(value);
  PHYSIM_ASSERT(begin <= end);
  return text_.substr(begin, end - begin);
}

bool TextPlaces::is_inline(const Value& table) {
  const std::size_t at = begin_of(table);
  return at < text_.size() && text_[at] == '{';
}

}  // namespace physim
