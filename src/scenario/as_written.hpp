// New values in the manner of what stands in a file: its units, and all of its text that did not change.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/document.hpp"
#include "scenario/schema.hpp"
#include "scenario/units.hpp"

namespace physim {

/// Numbers that users typed with units for settings. A file that holds such a number holds the typed text.
class TypedNumbers {
 public:
  /// All of them in the text of a setting, as "1 m, 2 ft, 0"; bare ones are no news.
  void take(std::string_view path, std::string_view text);
  /// The last text for a setting's key that reads back as this value, bit for bit; empty if there is none.
  [[nodiscard]] std::string find(std::string_view key, double value, Quantity quantity) const;

 private:
  struct Typed {
    std::string key, text;
    bool operator==(const Typed&) const = default;
  };
  std::vector<Typed> all_;
};

/// What stands behind the numbers of a value, blanks included: " gr"; empty if the value has no number with a unit of
/// the quantity.
[[nodiscard]] std::string unit_of(const Value& value, Quantity quantity);

/// The text for a setting's new value, `now`, that is to stand where a document says `old`: numbers keep their units,
/// and what did not change its text, with blanks and comments. The node is that of the setting or its table, `text` is
/// the document's.
[[nodiscard]] std::string in_manner_of(const Value& old, std::string_view text, const std::string& now,
                                       const SchemaNode& node, const TypedNumbers& typed);

/// The text for a new value where there is none: numbers as they were typed, else with the units of `like`, a value of
/// the setting in a file; null: none. Angles are in degrees.
[[nodiscard]] std::string as_typed(const std::string& now, const SchemaNode& node, const TypedNumbers& typed,
                                   const Value* like = nullptr, ReadsAs wanted = ReadsAs::same);

/// A document that was written anew, with numbers as they were typed.
[[nodiscard]] std::string document_as_typed(const std::string& text, const TypedNumbers& typed);

/// Offsets of places in a text, which must outlive this. Those that are asked for in order are found in one pass.
class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text) : text_(text) {}

  [[nodiscard]] std::string_view text() const { return text_; }
  /// Places are as TOML counts them: lines, and characters of UTF-8 in them.
  [[nodiscard]] std::size_t offset_of(const Value::Position& position);
  [[nodiscard]] std::size_t begin_of(const Value& value) { return offset_of({value.place.line, value.place.column}); }
  [[nodiscard]] std::size_t end_of(const Value& value) { return offset_of(value.end); }
  /// The text of a value, beside its key.
  [[nodiscard]] std::string_view said_of(const Value& value);
  /// Tables in braces are values; others have headers, or keys with dots.
  [[nodiscard]] bool is_inline(const Value& table);

 private:
  std::string_view text_;
  Value::Position last_{1, 1};
  std::size_t at_ = 0;  // offset of the last place
};

}  // namespace physim
