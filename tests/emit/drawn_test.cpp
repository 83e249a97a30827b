// Numbers and colours that emitters draw: constants, between two, curves, between two curves; integrals; gradients.
#include "emit/drawn.hpp"

#include "emit/statistics.hpp"
#include "math/interpolation.hpp"
#include "support.hpp"

namespace physim::emit_drawn_test {

using test::near;
using test::parabola;

double never() {
  ADD_FAILURE() << "nothing is to be drawn here";
  return 0.5;
}

/// Start speeds at a phase of the cycle.
std::vector<double> speeds(const DrawnNumber& speed, double phase, std::size_t count = test::kSamples) {
  const Emission emission({.start = {.speed = speed}}, 11);
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(emission.newborn({.number = i, .phase = phase}).speed);
  return all;
}

TEST(DrawnNumber, a_constant_is_itself_and_draws_nothing) {
  const EmitNumber number({5});
  EXPECT_TRUE(number.is_constant());
  for (const double x : {0.0, 0.3, 1.0}) EXPECT_EQ(number.at(x, never), 5);
}

TEST(DrawnNumber, between_two_constants_it_lies_evenly) {
  auto all = speeds({4, 6.5}, 0.7);
  for (double& x : all) x = (x - 4) / 2.5;
  EXPECT_TRUE(test::evenly(all));
}

TEST(DrawnNumber, a_curve_goes_through_its_keys_and_draws_nothing) {
  const EmitNumber rising({10, {}, {{0.2, 1}, {0.6, 3}, {0.8, 3}, {0.9, -1}}});
  EXPECT_FALSE(rising.is_constant());
  for (const auto& [x, y] : {std::pair{0.0, 10}, {0.2, 10}, {0.6, 30}, {0.7, 30}, {0.8, 30}, {0.9, -10}, {1.0, -10}})
    EXPECT_NEAR(rising.at(x, never), y, 1e-13) << x;
  // Two keys are a straight line, three may be a parabola.
  const EmitNumber line({1, {}, {{0, 2}, {1, 0}}}), arch({1, {}, parabola()});
  for (double x = 0; x <= 1; x += 0.01) {
    EXPECT_NEAR(line.at(x, never), 2 - 2 * x, 1e-15);
    EXPECT_NEAR(arch.at(x, never), 4 * x * (1 - x), 1e-15);
  }
}

TEST(DrawnNumber, curves_are_those_of_interpolation_and_stay_between_their_keys) {
  const Curve keys{{0, 1}, {0.1, 1e-12}, {0.35, 7}, {0.4, 7}, {0.8, 0}, {1, 1e-300}};
  std::vector<double> x, y;
  for (const CurveKey& key : keys) x.push_back(key.at), y.push_back(key.value);
  const PiecewiseCubic cubic = interpolate(x, y, Interpolation::pchip);
  const EmitCurve curve(keys);
  for (int i = 0; i <= 100'000; ++i) {
    const double at = i / 100'000.0, value = curve(at);
    ASSERT_NEAR(value, cubic(at), 1e-15 * 16);
    ASSERT_TRUE(value >= 0 && value <= 7) << at;
  }
}

TEST(DrawnNumber, between_two_curves_it_lies_evenly) {
  for (const double x : {0.25, 0.6}) {
    const double a = 3 * (1 - x), b = -2 * 4 * x * (1 - x);
    auto all = speeds({3, -2.0, {{0, 1}, {1, 0}}, parabola()}, x);
    for (double& speed : all) speed = (speed - a) / (b - a);
    EXPECT_TRUE(test::evenly(all)) << x;
  }
  // Without a curve of its own, the second end has that of the first.
  auto all = speeds({2, 4.0, {{0, 1}, {1, 0}}}, 0.5);
  for (double& speed : all) speed = speed - 1;
  EXPECT_TRUE(test::evenly(all));
}

TEST(DrawnNumber, integrals_are_those_of_quadrature) {
  const EmitNumber number({3, -5.0, {{0.1, 0}, {0.3, 2}, {0.35, 1}, {0.9, 4}}, {{0, 1}, {0.5, -2}, {1, 0}}});
  const auto u = [] { return 0.3; };
  const int n = 200'000;
  double sum = 0, before = number.at(0, u);
  for (int i = 1; i <= n; ++i) {  // Simpson's rule
    const double x = double(i) / n, middle = number.at(x - 0.5 / n, u), after = number.at(x, u);
    sum += (before + 4 * middle + after) / (6 * n);
    before = after;
    ASSERT_TRUE(i % 1000 > 0 || near(number.integral(x, u), sum, 0, 1e-11)) << x;
  }
  EXPECT_NEAR(number.integral(3, u), sum + 2 * number.at(1, u), 1e-11);  // it is held behind its last key
  EXPECT_EQ(EmitNumber({7}).integral(0.25, never), 1.75);
}

TEST(DrawnNumber, ranges_hold_what_can_be_drawn) {
  const NumberRange range = range_of(DrawnNumber{3, -2.0, {{0, -1}, {1, 2}}, parabola()});
  EXPECT_EQ(range.least, -3);
  EXPECT_EQ(range.most, 6);
}

TEST(DrawnNumber, counts_are_rounded_to_the_nearest) {
  EXPECT_EQ(whole_count(2.4999), 2u);
  EXPECT_EQ(whole_count(2.5), 3u);
  EXPECT_EQ(whole_count(0.4999), 0u);
  EXPECT_EQ(whole_count(-3), 0u);
}

TEST(DrawnColour, a_gradient_is_straight_for_each_of_its_parts) {
  const EmitGradient gradient({{0.25, 0x00ff8040}, {0.75, 0xff00c080}});
  EXPECT_EQ(gradient(0).packed(), 0x00ff8040u);
  EXPECT_EQ(gradient(0.25).packed(), 0x00ff8040u);
  EXPECT_EQ(gradient(0.5).packed(), 0x8080a060u);
  EXPECT_EQ(gradient(0.75).packed(), 0xff00c080u);
  EXPECT_EQ(gradient(1).packed(), 0xff00c080u);
  EXPECT_EQ(EmitGradient()(0.5).packed(), 0xffffffffu);
}

TEST(DrawnColour, factors_are_parts_of_255) {
  EXPECT_EQ(times(0xffffffffu, 0x12345678u), 0x12345678u);
  EXPECT_EQ(times(0x80808080u, 0x80ff0001u), 0x40800001u);
  for (std::uint32_t a = 0; a < 256; ++a)
    for (std::uint32_t b = 0; b < 256; ++b) ASSERT_EQ(times(a, b), (2 * a * b + 255) / 510);
}

TEST(DrawnColour, it_lies_between_two_gradients) {
  const EmitColour colour({0xff00ff80, 0x00ff00ff, {{0, 0xffffffff}, {1, 0x00000000}}, {{0, 0xffffffff}}});
  EXPECT_EQ(colour.at(0, [] { return 0.0; }).packed(), 0xff00ff80u);
  EXPECT_EQ(colour.at(0.5, [] { return 0.0; }).packed(), 0x80008040u);
  EXPECT_EQ(colour.at(0.5, [] { return 1.0; }).packed(), 0x00ff00ffu);
  EXPECT_EQ(EmitColour({0x336699ff}).at(0.5, never).packed(), 0x336699ffu);
  EXPECT_TRUE(EmitColour({}).is_white());
}

/// Over 0..1, keys of the curves and gradients below among them.
template <std::size_t N>
std::array<double, N> places() {
  std::array<double, N> x;
  for (std::size_t i = 0; i < N; ++i) x[i] = static_cast<double>(i % 41) / 40;
  return x;
}

template <std::size_t N>
void expect_curve_of_each(const Curve& keys) {
  const EmitCurve curve(keys);
  const std::array<double, N> x = places<N>();
  std::array<double, N> y;
  curve.at_each(x, y);
  for (std::size_t i = 0; i < N; ++i) EXPECT_EQ(y[i], curve(x[i])) << x[i];
}
TEST(EmitCurve, of_many_is_that_of_each_on_all_pieces_and_at_their_ends) {
  for (const Curve& keys :
       {Curve{}, Curve{{0, 3}}, Curve{{0.5, 2}}, Curve{{0, 1}, {1, 0}}, Curve{{0.2, 1}, {0.7, -4}},
        Curve{{0.1, 1}, {0.2, 3}, {0.75, 2}}, Curve{{0, 1}, {0.2, 3}, {0.75, 2}, {0.9, 2}, {1, 7}}}) {
    expect_curve_of_each<41>(keys);  // alone
    expect_curve_of_each<44>(keys);  // in packs
  }
}

/// The parts of a gradient's colour as its documentation says it.
std::array<double, 4> straight(const Gradient& keys, double x) {
  std::size_t i = 0;
  while (i < keys.size() && keys[i].at <= x) ++i;
  const ColourKey &a = keys[i == 0 ? 0 : i - 1], &b = keys[i == keys.size() ? i - 1 : i];
  const double u = b.at > a.at ? (x - a.at) / (b.at - a.at) : 0;
  std::array<double, 4> colour;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto part = [k](std::uint32_t of) { return static_cast<double>(of >> (24 - 8 * k) & 0xff); };
    colour[k] = part(a.colour) + u * (part(b.colour) - part(a.colour));
  }
  return colour;
}
template <std::size_t N>
void expect_straight(const Gradient& keys) {
  const EmitGradient gradient(keys);
  const std::array<double, N> x = places<N>();
  RgbaColumns<N> colour;
  gradient.at_each(x, colour);
  std::array<std::uint32_t, N> packed;
  pack_each(colour, packed);
  for (std::size_t i = 0; i < N; ++i) {
    std::uint32_t rounded = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double part = straight(keys, x[i])[k];
      EXPECT_EQ(colour[k][i], part) << x[i];
      rounded = rounded << 8 | static_cast<std::uint32_t>(std::floor(part + 0.5));
    }
    EXPECT_EQ(packed[i], rounded) << x[i];
  }
}
TEST(DrawnColour, gradients_of_many_are_straight_between_any_keys) {
  for (const Gradient& keys :
       {Gradient{{0.5, 0x12345678}}, Gradient{{0, 0xfff0a0ff}, {1, 0xff280000}}, Gradient{{0.2, 1}, {0.7, 0xff00ff00}},
        Gradient{{0.1, 0xff000000}, {0.2, 0x00ff0000}, {0.75, 0x0000ff00}},
        Gradient{{0, 0xffffffff}, {0.2, 0x80}, {0.75, 0x123456}, {0.9, 0}, {1, 0xabcdef01}}}) {
    expect_straight<41>(keys);
    expect_straight<44>(keys);
  }
}

}  // namespace physim::emit_drawn_test
