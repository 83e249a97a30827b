// All tables that the projectiles of a cohort look up, side by side in one pool.
//
// What it models: Cd by Mach number for every projectile of a cohort: a constant is a curve of one cell, Cd = 1; the
//   standard functions and curves with points that fit equal cells become rows; other curves are searched (exact, but
//   slower). Beside them the rows of aerodynamic coefficients, the pieces of motors and the grids of balls that spin.
// Source: math/interpolation.hpp for the interpolation; model/drag_curves.hpp, model/motor.hpp, model/magnus.hpp and
//   model/aero_tables.hpp for what is in them.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "math/interpolation.hpp"
#include "model/conditions.hpp"
#include "model/magnus_grid.hpp"
#include "model/motor_table.hpp"
#include "model/rotor.hpp"
#include "physim/projectile.hpp"

namespace physim {

/// Tables of balls that spin, each once.
class MagnusPool {
 public:
  /// Index of a table, which is found again where it is known.
  std::size_t add(const MagnusDef& magnus);

  [[nodiscard]] const std::vector<MagnusGrid>& grids() const { return grids_; }

 private:
  std::vector<MagnusGrid> grids_;
};

/// Where the tables of aerodynamic coefficients lie; fields as in Rotor.
struct AeroPlace {
  Buckets<double> mach;
  double mach_row;
  AngleTable<double> magnus_force;
  AngleTable<double> magnus_moment;
};

/// Drag curves and aerodynamic coefficients as rows of cubic coefficients; motors; balls that spin. Each table stands
/// in it once, and what is in it stays: places hold for good.
class TablePool {
 public:
  /// Adds a curve, or finds it when an equal one is there.
  CurvePart<double> add(const DragDef& drag, Interpolation interpolation);

  /// Rows of anything else; returns the number of the first.
  double add_rows(const std::vector<std::array<double, 4>>& rows);
  /// Where equal coefficients lie already; null where they do not.
  [[nodiscard]] const AeroPlace* find(const AeroDef& aero) const;
  void remember(const AeroDef& aero, const AeroPlace& place) {
    PHYSIM_ASSERT(find(aero) == nullptr);
    aero_.emplace_back(aero, place);
  }

  [[nodiscard]] std::span<const double> rows() const {
    if (alone_ != nullptr) return {alone_->rows.front().data(), 4 * alone_->rows.size()};
    return rows_;
  }
  [[nodiscard]] const std::vector<PiecewiseCubic>& searched() const { return searched_; }
  /// Grows with everything that is added.
  [[nodiscard]] std::size_t size() const;
  /// Points conditions to the tables: once more after every addition and every move.
  void point(Conditions<double>& conditions) const;
  void point(Conditions<float>& conditions);

  MotorPool motors;  // their pieces name curves
  MagnusPool magnus;

 private:
  struct Entry {
    DragTable table;
    std::vector<DragPoint> curve;
    CurvePart<double> place;
  };
  /// Takes the curve that is read where it lies into the rows, before others follow it.
  void settle();
  CurvePart<double> place_of(const DragDef& drag, Interpolation interpolation);
  CurvePart<double> place_of(const UniformCubic& curve);
  template <class S>
  [[nodiscard]] TablePointers<S> pointers(const S* rows) const;

  // A standard curve that is all there is, as in most flights, is read where all flights find it.
  const UniformCubic* alone_ = nullptr;
  DragTable alone_table_ = DragTable::constant;

  std::vector<double> rows_;
  std::vector<float> rows_float_;  // of those that conditions in float asked for
  std::vector<PiecewiseCubic> searched_;
  std::vector<Entry> entries_;
  std::vector<std::pair<AeroDef, AeroPlace>> aero_;
};

}  // namespace physim
