// What the analytic cases share: the methods that fly them, and a row being compared.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "validation/suite.hpp"

namespace physim::validation {

inline constexpr double kStandardGravity = 9.80665;  ///< [m/s^2]

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
  /// `problem`: why nothing of this row can be computed; empty: it can.
  RowCheck(const CsvFile& file, const CsvRow& row, const Method& method, std::string label, std::string problem,
           SuiteResult& result);

  /// Compares with a column by its relative error; nothing where the row has no value there. A component of a vector is
  /// also allowed rounding of the vector's length, `scale`.
  void compare(const char* column, double actual, double scale = 0);
  /// Compares with a column by its absolute error.
  void compare_within(const char* column, double actual, double gate);

 private:
  const CsvFile& file_;
  const CsvRow& row_;
  const Method& method_;
  std::string label_;
  std::string problem_;
  SuiteResult& result_;
};

/// Flies the shot of a row by each method, and hands over each flight to compare with the row.
void fly_row(const CsvFile& file, const CsvRow& row, const std::string& label, const std::vector<Method>& methods,
             const ShotInPlace& shot, SuiteResult& result,
             const std::function<void(RowCheck& check, const Flight& flight)>& compare);

struct Parameter {
  const char* name;
  const char* column;
};
/// "v0=100 elev=45": the inputs of a row.
[[nodiscard]] std::string label_of(const CsvFile& file, const CsvRow& row, std::initializer_list<Parameter> parameters);

/// The apex of a flight; all numbers are NaN if it has no apex.
[[nodiscard]] Sample apex_of(const Flight& flight);

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
