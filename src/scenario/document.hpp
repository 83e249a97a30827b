// A parsed TOML document as a tree that knows where every key and value stands, with overrides put in.
// It keeps toml++ (slow to compile, not copyable with places) out of all other files.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "physim/result.hpp"

namespace physim {

/// Whether two keys are equal. Most keys that are not differ in their first letter.
[[nodiscard]] inline bool is_same_key(std::string_view a, std::string_view b) {
  return a.size() == b.size() && (a.empty() || (a.front() == b.front() && a == b));
}

/// Where a key or value stands; line 0: the source as a whole, such as an override of the command line.
struct Place {
  std::shared_ptr<const std::string> source;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  [[nodiscard]] std::string text() const;  // "file:line:column"
};

struct Value;
struct Member;
using Array = std::vector<Value>;
using Table = std::vector<Member>;  // in the order of the file

/// A date or time: legal TOML that no setting takes. Its copy is not trivial: libstdc++ takes a variant of alternatives
/// that are trivial or its own for one that always has a value, and destroys a copy that memory ran out for.
struct Date {
  Date() = default;
  Date(const Date&) noexcept {}
  Date& operator=(const Date&) noexcept { return *this; }
};

struct Value {
  /// Lines and characters of UTF-8 in them, both from 1.
  struct Position {
    std::uint32_t line = 0, column = 0;
  };

  std::variant<bool, std::int64_t, double, std::string, Date, Array, Table> content;
  Place place;
  Position end;                            // just behind it; of a [table] just behind its header
  std::shared_ptr<const std::string> raw;  // of an override: the text as typed, for settings that take any text

  template <class T>
  [[nodiscard]] const T* get() const {
    return std::get_if<T>(&content);
  }
  template <class T>
  [[nodiscard]] T* get() {
    return std::get_if<T>(&content);
  }
  /// The value of a key; null where this is no table or has no such key.
  [[nodiscard]] const Value* find(std::string_view key) const;
  [[nodiscard]] Value* find(std::string_view key);
};

struct Member {
  std::string key;
  Place key_place;
  Value value;
};

/// A table of a list of tables that is there.
[[nodiscard]] const Value& element(const Value& document, std::string_view list, std::size_t index);
/// Where a path of the library such as "bursts[1].count" leads from a table.
struct PathInFile {
  const Value& nearest;  // the value itself, or the one around it that the file has
  bool is_there = false;
};
/// What is no list stands for a list of one.
[[nodiscard]] PathInFile follow(const Value& table, std::string_view path);
/// Place of what it leads to, or of the table around that.
[[nodiscard]] std::string place_of(const Value& table, std::string_view path);

/// "a number", "a table", ...
[[nodiscard]] std::string_view kind_of(const Value& value);
/// A value as messages show it.
[[nodiscard]] std::string shown(const Value& value);

/// Parses TOML; the result is a table. `file` only names it in errors.
[[nodiscard]] Result<Value> parse_document(std::string_view text, const std::string& file);
/// Parses what stands right of "=" in an override: TOML where it is TOML, otherwise plain text.
[[nodiscard]] Value parse_override_value(std::string_view text, const Place& place);

}  // namespace physim
