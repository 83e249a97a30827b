// Where the values of a document stand in its text.
#pragma once

#include <cstddef>
#include <string_view>

#include "scenario/document.hpp"

namespace physim {

/// Offsets of places in a text, which must outlive this. Those that are asked for in order are found in one pass.
class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text) : text_(text) {}

  [[nodiscard]] std::string_view text() const { return text_; }
  /// Places are as TOML counts them: lines, and characters of UTF-8 in them.
  [[nodiscard]] std::size_t offset_of(const Value::Position& position);
  [[nodiscard]] std::size_t begin_of(const Value& value) { return offset_of({value.place.line, value.place.column}); }
  [[nodiscard]] std::size_t end_of(const Value& value) { return offset_of(value.end); }
  /// What the text says of a value, beside its key.
  [[nodiscard]] std::string_view said_of(const Value& value);
  /// Tables in braces are values; others have headers, or keys with dots.
  [[nodiscard]] bool is_inline(const Value& table);

 private:
  std::string_view text_;
  Value::Position last_{1, 1};
  std::size_t at_ = 0;  // offset of the last place
};

}  // namespace physim
