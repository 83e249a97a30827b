// Cases of exterior ballistics in JSON, made ready to fly.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "physim/environment.hpp"
#include "physim/projectile.hpp"

namespace physim::validation {

/// One JSON file: an array of objects. Errors name the file, the line where a case begins, and the case.
class JsonCases {
 public:
  /// Reads a file; throws DataError.
  explicit JsonCases(const std::filesystem::path& path);

  [[nodiscard]] const nlohmann::json& cases() const { return cases_; }
  [[nodiscard]] std::string name() const { return path_.filename().string(); }
  /// "id" of a case, or its number.
  [[nodiscard]] std::string id(std::size_t index) const;
  [[noreturn]] void fail(std::size_t index, const std::string& message) const;
  /// Where the figures of a case come from.
  [[nodiscard]] std::string source(std::size_t index) const;

 private:
  [[nodiscard]] std::string place(std::size_t at) const;  ///< "file:line" of a character

  std::filesystem::path path_;
  std::string text_;
  nlohmann::json cases_;
};

/// Reads fields of one case; null and missing are the same. Throws DataError where a field has the wrong type.
class CaseReader {
 public:
  CaseReader(const JsonCases& file, std::size_t index) : CaseReader(file, index, file.cases()[index], "") {}
  CaseReader(const JsonCases& file, std::size_t index, const nlohmann::json& object, std::string path);

  [[nodiscard]] std::optional<double> number(const char* key) const;
  [[nodiscard]] double number_or(const char* key, double otherwise) const { return number(key).value_or(otherwise); }
  [[nodiscard]] double needed(const char* key) const;
  [[nodiscard]] std::string text(const char* key) const;  ///< empty where there is none
  [[nodiscard]] bool flag(const char* key) const;
  [[nodiscard]] Vec3d vector(const char* key) const;  ///< zero where there is none
  /// A value, or null.
  [[nodiscard]] const nlohmann::json& raw(const char* key) const;
  /// An object within this one; without fields where there is none.
  [[nodiscard]] CaseReader object(const char* key) const;
  /// A row of a list within this case.
  [[nodiscard]] CaseReader element(const char* list, std::size_t index) const;
  [[noreturn]] void fail(const std::string& message) const;

 private:
  /// A value of a type that `fits`, or null.
  [[nodiscard]] const nlohmann::json& checked(const char* key, bool (nlohmann::json::*fits)() const noexcept,
                                              const char* kind) const;

  const JsonCases& file_;
  std::size_t index_;
  const nlohmann::json& object_;
  std::string path_;
};

/// A shot of exterior ballistics.
struct BallisticCase {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Fidelity fidelity;
  double impact_above_aim = 0;       ///< at the zero range [m]
  bool range_is_horizontal = false;  ///< else along the line of sight
};

[[nodiscard]] BallisticCase read_ballistic_case(const CaseReader& reader);
/// Air from "temperature_K", "pressure_Pa", "relative_humidity", "altitude_m".
void read_air(const CaseReader& reader, Environment& environment);

/// A gate: its parts are added up.
struct Gate {
  double absolute = 0;
  double moa = 0;
  double relative = 0;
  [[nodiscard]] double of(double range, double expected) const;
};
/// Reads {"abs_m": ..., "moa": ..., "rel": ...}; nothing where there is no such gate.
[[nodiscard]] std::optional<Gate> read_gate(const CaseReader& gates, const char* key);

}  // namespace physim::validation
