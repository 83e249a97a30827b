// Small helpers that tests of the core share.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

#include "must.hpp"
#include "physim/physim.hpp"
#include "prepare/cohort.hpp"
#include "prepare/conditions.hpp"
#include "prepare/grant.hpp"
#include "prepare/launch.hpp"
#include "prepare/watch_list.hpp"

namespace physim {

/// Adds a thing of this shape to a scene.
inline InstanceId add_thing(Scene& scene, const ShapeDef& shape, InstanceDef thing = {}) {
  thing.shape = must(scene.add_shape(shape));
  return must(scene.add(thing));
}

}  // namespace physim

namespace physim::test {

inline constexpr double kDegree = 3.14159265358979323846 / 180;
using physim::kInfinity;
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// |actual - expected| <= relative |expected| + absolute.
inline testing::AssertionResult near(double actual, double expected, double relative, double absolute = 0) {
  const double gate = relative * std::abs(expected) + absolute;
  if (std::abs(actual - expected) <= gate) return testing::AssertionSuccess();
  return testing::AssertionFailure() << actual << " is not " << expected << ": off by " << actual - expected
                                     << ", allowed " << gate;
}
inline testing::AssertionResult near(const Vec3d& actual, const Vec3d& expected, double relative, double absolute = 0) {
  const double gate = relative * length(expected) + absolute;
  if (length(actual - expected) <= gate) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "(" << actual.x << ", " << actual.y << ", " << actual.z << ") is not ("
                                     << expected.x << ", " << expected.y << ", " << expected.z << "): off by "
                                     << length(actual - expected) << ", allowed " << gate;
}

inline std::vector<Event> of_kind(std::span<const Event> events, EventKind kind) {
  std::vector<Event> found;
  std::ranges::copy_if(events, std::back_inserter(found), [&](const Event& e) { return e.kind == kind; });
  return found;
}
inline std::vector<Event> of_kind(const Flight& flight, EventKind kind) { return of_kind(flight.events(), kind); }

/// Equal bits; NaNs are equal whatever their bits.
inline bool same_bits(double a, double b) { return (a != a && b != b) || to_bits(a) == to_bits(b); }
inline bool same_bits(const Vec3d& a, const Vec3d& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

/// A projectile in an environment, ready for direct calls of the models and the integrators.
struct Prepared {
  Cohort cohort;
  Body<double> body;
  Rotor<double> rotor{};

  Prepared(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
           const Fidelity& fidelity) {
    cohort.in_use = grant(fidelity, projectile, environment);
    cohort.conditions = prepare_conditions(environment, cohort.in_use.fidelity, cohort.profiles);
    body = prepare_body(projectile, launch, launch.elevation, cohort.pool, cohort.conditions);
    if (turns(cohort.in_use.fidelity))
      rotor = prepare_rotor(projectile, launch, launch.elevation, body, cohort.pool, cohort.conditions);
    cohort.finish();
  }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  [[nodiscard]] const Conditions<double>& conditions() const { return cohort.conditions; }
  [[nodiscard]] Vec3d acceleration(double t, const State<double>& s) const {
    return physim::acceleration(cohort.conditions, body, t, s);
  }
};

inline constexpr Integrator kIntegrators[] = {Integrator::classic,
                                              Integrator::explicit_euler,
                                              Integrator::semi_implicit_euler,
                                              Integrator::heun,
                                              Integrator::rk4,
                                              Integrator::rk43,
                                              Integrator::tsit5,
                                              Integrator::dop853};
inline constexpr Integrator kAdaptive[] = {Integrator::rk43, Integrator::tsit5, Integrator::dop853};

/// Force, constant gravity, nothing else: the rung that the other tests change field by field.
inline Fidelity vacuum(Integrator integrator = Integrator::tsit5) {
  return {.integrator = integrator,
          .gravity = GravityModel::constant,
          .drag = DragModel::off,
          .air = AirModel::vacuum,
          .wind = WindModel::off};
}

inline Environment constant_gravity() { return {.gravity = {.model = GravityModel::constant}}; }

/// A .308 bullet of 168 gr with a G7 ballistic coefficient of 0.218 lb/in^2.
inline ProjectileDef bullet_308() {
  return {.name = "308",
          .mass = 0.01088621688,
          .diameter = 0.0078232,
          .length = 0.031,
          .twist = 0.3048,
          .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218 * 703.06957963916}};
}

inline std::string text(Integrator integrator) { return std::string(name(integrator)); }

}  // namespace physim::test
