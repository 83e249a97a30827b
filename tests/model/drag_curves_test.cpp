// Drag curves: the published points, and that the way a curve is stored changes nothing.
#include "model/drag_curves.hpp"

#include "model/table_pool.hpp"

#include "model/drag.hpp"
#include "support.hpp"

namespace physim::model_drag_curves_test {

using test::near;
using test::Prepared;

constexpr Interpolation kAll[] = {Interpolation::linear, Interpolation::pchip, Interpolation::cubic};

/// The Cd that a flight really feels: from the acceleration at 1 m/s per unit of Mach, in air of density 1.
double felt_cd(const DragDef& drag, Interpolation interpolation, double mach) {
  ProjectileDef p;
  p.drag = drag;
  p.drag.ballistic_coefficient = 3.14159265358979323846 / 8;
  Environment e = test::constant_gravity();
  e.atmosphere = {.model = AirModel::constant, .density = 1, .sound_speed = 1};
  Fidelity f = test::vacuum();
  f.gravity = GravityModel::off;
  f.drag = DragModel::equation;
  f.air = AirModel::constant;
  f.interpolation = interpolation;
  const Prepared prepared(p, {}, e, f);
  return -prepared.acceleration(0, {{}, {mach, 0, 0}}).x / (mach * mach);
}

// Sums over all points of a standard function, of drag_tables (tabulated by the US Army BRL):
// a wrong, missing or doubled digit shows.
TEST(DragCurves, standard_functions_have_the_published_points) {
  const struct {
    DragTable table;
    std::size_t points;
    double mach, cd, product;
  } sums[] = {{DragTable::g1, 79, 143.925, 37.0571, 74.8406675}, {DragTable::g2, 85, 158.775, 22.3643, 39.8265675},
              {DragTable::g5, 76, 141.125, 22.6479, 43.8116325}, {DragTable::g6, 79, 144.65, 23.4477, 39.9214075},
              {DragTable::g7, 84, 156.875, 20.0187, 38.62066},   {DragTable::g8, 78, 143.075, 22.0896, 38.52441},
              {DragTable::gi, 81, 146.6, 37.4735, 73.9993575},   {DragTable::gs, 81, 162, 69.8967, 152.525085},
              {DragTable::ra4, 87, 137.775, 38.8415, 68.526145}};
  for (const auto& sum : sums) {
    double mach = 0, cd = 0, product = 0;
    for (const DragPoint& p : drag_points(sum.table)) {
      mach += p.mach;
      cd += p.coefficient;
      product += p.mach * p.coefficient;
    }
    EXPECT_EQ(drag_points(sum.table).size(), sum.points) << name(sum.table);
    EXPECT_NEAR(mach, sum.mach, 1e-9) << name(sum.table);
    EXPECT_NEAR(cd, sum.cd, 1e-9) << name(sum.table);
    EXPECT_NEAR(product, sum.product, 1e-8) << name(sum.table);
  }
  EXPECT_TRUE(drag_points(DragTable::constant).empty());
  EXPECT_TRUE(drag_points(DragTable::sphere).empty());
  EXPECT_TRUE(drag_points(DragTable::custom).empty());
}

TEST(DragCurves, every_standard_function_hits_its_points_with_every_interpolation) {
  for (int table = int(DragTable::g1); table <= int(DragTable::ra4); ++table)
    for (const Interpolation how : kAll) {
      const DragDef drag{.table = static_cast<DragTable>(table)};
      for (const DragPoint& p : drag_points(drag.table)) {
        EXPECT_NEAR(drag_coefficient(drag, how, p.mach), p.coefficient, 1e-15) << table << ' ' << p.mach;
        if (p.mach == 0) continue;
        EXPECT_NEAR(felt_cd(drag, how, p.mach), p.coefficient, 1e-12) << table << ' ' << p.mach;
      }
    }
}

TEST(DragCurves, flights_feel_the_curve_that_is_asked_for) {
  for (int table = int(DragTable::g1); table <= int(DragTable::ra4); ++table)
    for (const Interpolation how : kAll)
      for (double mach = 0.0137; mach < 6; mach += 0.0973) {
        const DragDef drag{.table = static_cast<DragTable>(table)};
        EXPECT_NEAR(felt_cd(drag, how, mach), drag_coefficient(drag, how, mach), 1e-13) << table << ' ' << mach;
      }
}

DragDef odd_curve() {
  return {.table = DragTable::custom,
          .curve = {{0.1, 0.2}, {0.7182818, 0.21}, {0.9314159, 0.4}, {1.0577215, 0.5}, {1.6180339, 0.45}, {3.3, 0.3}}};
}

TEST(DragCurves, points_that_fit_no_grid_are_searched) {
  TablePool pool;
  EXPECT_LT(pool.add(odd_curve(), Interpolation::pchip).curve_row, 0);
  EXPECT_EQ(pool.searched().size(), 1u);
  EXPECT_GE(pool.add({.table = DragTable::g7}, Interpolation::pchip).curve_row, 0);
  ASSERT_TRUE(spline_overshoots(odd_curve()));  // so that a flight is granted pchip where it asks for a spline
  for (const Interpolation how : kAll) {
    const Interpolation granted = how == Interpolation::cubic ? Interpolation::pchip : how;
    for (double mach = 0.01; mach < 4; mach += 0.0371)
      EXPECT_NEAR(felt_cd(odd_curve(), how, mach), drag_coefficient(odd_curve(), granted, mach), 1e-13) << mach;
  }
}

TEST(DragCurves, searched_and_uniform_storage_give_one_curve) {
  // A straight-line curve stays the same when a point of its own is added at an odd place, which fits no grid.
  const DragDef even{.table = DragTable::custom, .curve = {{0.5, 0.2}, {1, 0.5}, {1.5, 0.4}, {3, 0.3}}};
  DragDef odd = even;
  odd.curve.insert(odd.curve.begin() + 3, {2.1415926535, 0.4 - 0.1 * 0.6415926535 / 1.5});
  TablePool pool;
  ASSERT_GE(pool.add(even, Interpolation::linear).curve_row, 0);
  ASSERT_LT(pool.add(odd, Interpolation::linear).curve_row, 0);
  for (double mach = 0.01; mach < 4; mach += 0.0371)
    EXPECT_NEAR(felt_cd(odd, Interpolation::linear, mach), felt_cd(even, Interpolation::linear, mach), 1e-14) << mach;
}

TEST(DragCurves, the_pool_keeps_equal_curves_once_and_different_ones_apart) {
  TablePool pool;
  const auto g7 = pool.add({.table = DragTable::g7}, Interpolation::pchip);
  EXPECT_EQ(pool.add({.table = DragTable::g7, .form_factor = 2}, Interpolation::pchip).curve_row, g7.curve_row);
  EXPECT_NE(pool.add({.table = DragTable::g1}, Interpolation::pchip).curve_row, g7.curve_row);
  // Constants share one curve, Cd = 1: their coefficient is part of the area.
  const auto half = pool.add({.coefficient = 0.5}, Interpolation::pchip);
  EXPECT_EQ(pool.add({.coefficient = 0.25}, Interpolation::pchip).curve_row, half.curve_row);
  DragDef custom = odd_curve();
  const auto first = pool.add(custom, Interpolation::pchip);
  custom.curve[2].coefficient += 0.01;
  EXPECT_NE(pool.add(custom, Interpolation::pchip).curve_row, first.curve_row);
}

// Morrison 2013, figures of sphere_drag/sphere_cd.csv (8 digits).
TEST(SphereDrag, has_the_values_of_morrisons_formula) {
  const double rows[][2] = {{0.01, 2400.1526},
                            {0.1, 240.22116},
                            {1, 24.672932},
                            {10, 3.9675833},
                            {100, 1.0381866},
                            {1000, 0.48405631},
                            {10000, 0.39356443},
                            {100000, 0.42467662},
                            {251188.6431509580, 0.29694093},
                            {316227.7660168379, 0.14025731},
                            {398107.1705534973, 0.087672295},
                            {1e6, 0.14145576}};
  for (const auto& [re, cd] : rows) EXPECT_TRUE(near(sphere_drag_coefficient(re), cd, 2e-7)) << re;
}

TEST(SphereDrag, is_stokes_law_in_creeping_flow_and_held_above_a_million) {
  EXPECT_TRUE(near(sphere_drag_coefficient(1e-4), 24e4, 1e-6));
  EXPECT_EQ(sphere_drag_coefficient(3e6), sphere_drag_coefficient(1e6));
  EXPECT_TRUE(std::isfinite(sphere_drag_coefficient(0)));
}

TEST(DragCurves, what_gives_no_curve_has_no_coefficient) {
  const DragDef g7{.table = DragTable::g7};
  EXPECT_TRUE(std::isnan(drag_coefficient(g7, static_cast<Interpolation>(9), 1)));
  EXPECT_TRUE(std::isnan(drag_coefficient({.table = static_cast<DragTable>(200)}, Interpolation::linear, 1)));
  EXPECT_TRUE(std::isnan(drag_coefficient({.table = DragTable::custom}, Interpolation::linear, 1)));
  const DragDef back{.table = DragTable::custom, .curve = {{1, 0.3}, {0.5, 0.4}}};
  EXPECT_TRUE(std::isnan(drag_coefficient(back, Interpolation::linear, 1)));
  const DragDef nan{.table = DragTable::custom, .curve = {{0, 0.3}, {NAN, 0.4}}};
  EXPECT_TRUE(std::isnan(drag_coefficient(nan, Interpolation::linear, 1)));
}

/// A standard curve alone is read where all find it; with others it moves into their rows, at the same place.
TEST(DragCurves, a_standard_curve_alone_reads_as_among_others) {
  DragDef g7, g1, own;
  g7.table = DragTable::g7;
  g1.table = DragTable::g1;
  own.table = DragTable::custom;
  own.curve = {{0, 0.2}, {0.5, 0.25}, {1, 0.5}, {1.5, 0.4}, {2, 0.3}};
  for (const DragDef& next : {g1, own}) {
    TablePool alone, among;
    const CurvePart<double> place = alone.add(g7, Interpolation::cubic);
    EXPECT_EQ(among.add(g7, Interpolation::cubic), place);
    EXPECT_EQ(alone.rows().data(), among.rows().data());
    const CurvePart<double> other = among.add(next, Interpolation::cubic);
    EXPECT_EQ(other.curve_row, static_cast<double>(alone.rows().size() / 4));
    EXPECT_EQ(among.add(g7, Interpolation::cubic), place);
    EXPECT_EQ(among.add(next, Interpolation::cubic), other);
    EXPECT_GT(among.rows().size(), alone.rows().size());
    EXPECT_EQ(among.size(), among.rows().size());
    EXPECT_TRUE(std::equal(alone.rows().begin(), alone.rows().end(), among.rows().begin()));
  }
}

// Rows of cells are counted by floats, so that a world of hundreds of fine curves once ended at an assert.
TEST(DragCurves, curves_beyond_the_room_for_cells_are_searched) {
  TablePool pool;
  DragDef drag{.table = DragTable::custom};
  int searched = 0;
  for (int i = 0; i < 300; ++i) {
    drag.curve = {{0, 0.2}, {0.001, 0.2 + 1e-4 * i}, {16, 0.3}};  // 16 000 cells
    const auto place = pool.add(drag, Interpolation::linear);
    searched += place.curve_row < 0;
    EXPECT_EQ(pool.add(drag, Interpolation::linear), place) << i;
  }
  EXPECT_EQ(searched, 300 - (1 << 21) / 16000);
  EXPECT_LE(pool.rows().size() / 4, 1U << 21);
}

TEST(DragCurves, curves_are_the_same_where_all_bits_of_their_points_are) {
  const std::vector<DragPoint> one = {{0, 0.2}, {1, 0.4}};
  EXPECT_TRUE(same_points({}, {}));
  EXPECT_TRUE(same_points(one, {{0, 0.2}, {1, 0.4}}));
  EXPECT_FALSE(same_points(one, {}));
  EXPECT_FALSE(same_points(one, {{0, 0.2}}));
  EXPECT_FALSE(same_points(one, {{0, 0.2}, {1, std::nextafter(0.4, 1)}}));
  EXPECT_FALSE(same_points(one, {{-0.0, 0.2}, {1, 0.4}}));
}

}  // namespace physim::model_drag_curves_test
