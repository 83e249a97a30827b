// Cases in JSON: an array of objects, read field by field.
#pragma once

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/assert.hpp"
#include "validation/csv.hpp"
#include "validation/suite.hpp"

namespace physim::validation {

/// Is it a list of `count` numbers?
inline bool is_numbers(const nlohmann::json& list, std::size_t count) {
  const auto is_number = [](const nlohmann::json& v) { return v.is_number(); };
  return list.is_array() && list.size() == count && std::ranges::all_of(list, is_number);
}

/// One file. Errors name the file, the line where a case begins, and the case.
class JsonCases {
 public:
  /// Reads a file; throws DataError.
  explicit JsonCases(const std::filesystem::path& path) : path_(path), text_(text_of(path)) {
    try {
      cases_ = nlohmann::json::parse(text_);
    } catch (const nlohmann::json::parse_error& error) {
      std::string words = error.what();
      if (const auto at = words.find(": ", words.find("column")); at != std::string::npos) words = words.substr(at + 2);
      throw DataError{{.message = "not JSON: " + words, .place = place(std::min(error.byte, text_.size()))}};
    } catch (const nlohmann::json::exception& error) {  // a number beyond all doubles
      throw DataError{{.message = std::string("not JSON: ") + error.what(), .place = path.string()}};
    }
    if (!cases_.is_array()) throw DataError{{.message = "a list of cases was expected", .place = place(0)}};
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (!cases_[i].is_object()) fail(i, "an object was expected");
  }

  [[nodiscard]] const nlohmann::json& cases() const { return cases_; }

  /// "id" of a case, or its number.
  [[nodiscard]] std::string id(std::size_t index) const {
    PHYSIM_ASSERT(index < cases_.size());
    const nlohmann::json& object = cases_[index];
    const std::string stem = path_.stem().string();
    if (object.is_object() && object.contains("id") && object["id"].is_string()) return object["id"];
    return formatted("%s %zu", stem.c_str(), index + 1);
  }

  [[noreturn]] void fail(std::size_t index, const std::string& message) const {
    const auto at = text_.find("\"" + id(index) + "\"");
    throw DataError{
        {.message = "case \"" + id(index) + "\": " + message, .place = place(at == std::string::npos ? 0 : at)}};
  }

  /// Where the figures of a case come from.
  [[nodiscard]] std::string source(std::size_t index) const {
    const nlohmann::json& object = cases_[index];
    if (!object.contains("source")) return {};
    const nlohmann::json& source = object["source"];
    if (source.is_string()) return source;
    std::string text;
    if (source.is_object())
      for (const auto& [key, value] : source.items())
        if (value.is_string()) text = value.get<std::string>() + (text.empty() ? "" : ", " + text);
    return text;
  }

 private:
  /// "file:line" of a character.
  [[nodiscard]] std::string place(std::size_t at) const {
    PHYSIM_ASSERT(at <= text_.size());
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(at);
    return formatted("%s:%td", path_.string().c_str(), 1 + std::count(text_.begin(), end, '\n'));
  }

  std::filesystem::path path_;
  std::string text_;
  nlohmann::json cases_;
};

/// Reads fields of one case; null and missing are the same. Throws DataError where a field has the wrong type.
class CaseReader {
 public:
  CaseReader(const JsonCases& file, std::size_t index) : CaseReader(file, index, file.cases()[index], "") {}
  CaseReader(const JsonCases& file, std::size_t index, const nlohmann::json& object, std::string path)
      : file_(file), index_(index), object_(object.is_null() ? kEmpty : object), path_(std::move(path)) {
    if (!object_.is_object()) fail("an object was expected");
  }

  [[nodiscard]] std::optional<double> number(const char* key) const {
    const nlohmann::json& value = checked(key, &nlohmann::json::is_number, "not a number");
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
  }
  [[nodiscard]] double number_or(const char* key, double otherwise) const { return number(key).value_or(otherwise); }
  [[nodiscard]] double needed(const char* key) const {
    const auto value = number(key);
    if (!value) fail(std::string("\"") + key + "\" is missing");
    return *value;
  }
  /// Empty if the key is missing.
  [[nodiscard]] std::string text(const char* key) const {
    const nlohmann::json& value = checked(key, &nlohmann::json::is_string, "not a text");
    return value.is_null() ? std::string() : value.get<std::string>();
  }
  [[nodiscard]] bool flag(const char* key) const {
    const nlohmann::json& value = checked(key, &nlohmann::json::is_boolean, "neither true nor false");
    return !value.is_null() && value.get<bool>();
  }
  /// Zero if the key is missing.
  [[nodiscard]] Vec3d vector(const char* key) const {
    const nlohmann::json& value = raw(key);
    if (value.is_null()) return {};
    if (!is_numbers(value, 3)) fail(std::string("\"") + key + "\" is not a list of three numbers: " + value.dump());
    return {value[0], value[1], value[2]};
  }

  /// A value, or null.
  [[nodiscard]] const nlohmann::json& raw(const char* key) const {
    const auto at = object_.find(key);
    return at == object_.end() ? kNull : *at;
  }
  /// An object within this one; without fields if the key is missing.
  [[nodiscard]] CaseReader object(const char* key) const {
    return {file_, index_, raw(key), (path_.empty() ? "" : path_ + ".") + key};
  }
  /// A row of a list within this case.
  [[nodiscard]] CaseReader element(const char* list, std::size_t index) const {
    PHYSIM_ASSERT(raw(list).is_array());
    PHYSIM_ASSERT(index < raw(list).size());
    return {file_, index_, raw(list)[index], formatted("%s[%zu]", list, index)};
  }

  [[noreturn]] void fail(const std::string& message) const {
    file_.fail(index_, path_.empty() ? message : "\"" + path_ + "\": " + message);
  }

 private:
  static inline const nlohmann::json kNull, kEmpty = nlohmann::json::object();

  /// A value of a type that `fits`, or null.
  [[nodiscard]] const nlohmann::json& checked(const char* key, bool (nlohmann::json::*fits)() const noexcept,
                                              const char* kind) const {
    const nlohmann::json& value = raw(key);
    if (!value.is_null() && !(value.*fits)()) fail(std::string("\"") + key + "\" is " + kind + ": " + value.dump());
    return value;
  }

  const JsonCases& file_;
  std::size_t index_;
  const nlohmann::json& object_;
  std::string path_;
};

}  // namespace physim::validation
