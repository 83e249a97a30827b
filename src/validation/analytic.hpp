// What the analytic cases share: the methods that fly them, and a row being compared.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "validation/csv.hpp"
#include "validation/suite.hpp"

namespace physim::validation {

inline constexpr double kStandardGravity = 9.80665;  ///< [m/s^2]
inline constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

/// A way to fly a case, and the error it may have.
struct Method {
  std::string name;
  Fidelity fidelity;
  Tolerance tolerance;
  double relative = 0;  ///< gate: part of the figure [-]
  double floor = 0;     ///< gate: part of the scale that the figure is a component of [-]
};

/// tsit5 and dop853 at tight tolerance, without any effect but constant gravity.
[[nodiscard]] std::vector<Method> integrators();
/// The exact formulas, and the integrators.
[[nodiscard]] std::vector<Method> closed_form_and_integrators();

/// A shot and the place where it flies; the fidelity says what of it counts.
struct ShotInPlace {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Until until;

  [[nodiscard]] Flight fly(const Method& method) const;
};
/// 1 kg, launched from the origin under constant gravity.
[[nodiscard]] ShotInPlace shot_under(double gravity);

/// Compares the columns of one row of a table with what one method gives.
class RowCheck {
 public:
  RowCheck(const CsvFile& file, const CsvRow& row, const Method& method, std::string label, SuiteResult& result);

  /// Why nothing of this row can be computed; empty: it can.
  void blame(std::string problem) { problem_ = std::move(problem); }
  [[nodiscard]] bool sound() const { return problem_.empty(); }
  /// Compares with a column by its relative error; nothing where the row has no value there. A component of a vector is
  /// also allowed rounding of the vector's length, `scale`.
  void compare(const char* column, double actual, double scale = 0);
  /// Compares with a column by its absolute error.
  void compare_within(const char* column, double actual, double gate);

 private:
  void add(const char* column, double actual, const std::function<double(double)>& gate);

  const CsvFile& file_;
  const CsvRow& row_;
  const Method& method_;
  std::string label_;
  std::string problem_;
  SuiteResult& result_;
};

struct Parameter {
  const char* name;
  const char* column;
};
/// "v0=100 elev=45": the inputs of a row.
[[nodiscard]] std::string label_of(const CsvFile& file, const CsvRow& row, std::initializer_list<Parameter> parameters);

/// The first event of a kind.
[[nodiscard]] std::optional<Event> first_event(const Flight& flight, EventKind kind);

using Reader = void (*)(const CsvFile& file, SuiteResult& result);

// Readers of the files, by where the case happens.
void vacuum_parabola(const CsvFile& file, SuiteResult& result);
void linear_drag(const CsvFile& file, SuiteResult& result);
void quadratic_vertical(const CsvFile& file, SuiteResult& result);
void quadratic_2d(const CsvFile& file, SuiteResult& result);
void fall_exponential(const CsvFile& file, SuiteResult& result);
void bouncing_ball(const CsvFile& file, SuiteResult& result);
void coriolis_uniform_g(const CsvFile& file, SuiteResult& result);
void magnus_constant_kappa(const CsvFile& file, SuiteResult& result);
void kepler_orbits(const CsvFile& file, SuiteResult& result);
void newton_gravity_range(const CsvFile& file, SuiteResult& result);
void radial_fall_newton(const CsvFile& file, SuiteResult& result);
void torque_free_body(const CsvFile& file, SuiteResult& result);

}  // namespace physim::validation
