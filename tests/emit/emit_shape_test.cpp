// Where particles come out: every shape and mode against its closed form, a million samples each.
#include "emit/statistics.hpp"
#include "support.hpp"

namespace physim::emit_emit_shape_test {

using test::evenly;
using test::evenly_together;
using test::kSamples;
using test::near;
using test::newborns;
using test::turn_of;
using Triples = std::vector<std::array<double, 3>>;
using Pairs = std::vector<std::array<double, 2>>;

constexpr double kTurn = 2 * 3.14159265358979323846;

EmitterDef from(const EmitFrom& shape) { return {.from = shape}; }

void expect_unit(const Vec3d& direction) { ASSERT_NEAR(length(direction), 1, 1e-15 * 4); }

/// Evenly in part of a disc between (1 - thickness) and 1.
double disc_part(double s, double thickness) {
  const double least = (1 - thickness) * (1 - thickness);
  return (s * s - least) / (1 - least);
}
double ball_part(double s, double thickness) {
  const double least = (1 - thickness) * (1 - thickness) * (1 - thickness);
  return (s * s * s - least) / (1 - least);
}

TEST(EmitShape, a_point_fires_forwards) {
  for (const Newborn& n : newborns(from({}), 10)) {
    EXPECT_EQ(n.place, Vec3d{});
    EXPECT_EQ(n.direction, (Vec3d{1, 0, 0}));
  }
}

TEST(EmitShape, a_cone_is_a_disc_away_from_its_tip) {
  for (const double thickness : {1.0, 0.3}) {
    const EmitFrom cone{.shape = EmitShape::cone, .radius = 2, .angle = 0.5, .thickness = thickness};
    const Vec3d tip{-2 / std::tan(0.5), 0, 0};
    Pairs parts;
    for (const Newborn& n : newborns(from(cone))) {
      expect_unit(n.direction);
      ASSERT_EQ(n.place.x, 0);
      ASSERT_TRUE(near(n.direction, normalized(n.place - tip), 1e-14));
      parts.push_back({disc_part(length(n.place) / 2, thickness), turn_of(n.place)});
    }
    EXPECT_TRUE(evenly_together(parts)) << thickness;
  }
}

TEST(EmitShape, the_angle_of_a_cone_is_that_of_its_edge) {
  for (const double radius : {0.0, 1.0})
    for (const Newborn& n :
         newborns(from({.shape = EmitShape::cone, .radius = radius, .angle = 0.7, .thickness = 0}), 1000))
      EXPECT_NEAR(std::acos(n.direction.x), 0.7, 1e-12);
}

TEST(EmitShape, a_sphere_fires_away_from_its_middle_evenly) {
  for (const double thickness : {1.0, 0.25}) {
    Triples parts;
    for (const Newborn& n : newborns(from({.shape = EmitShape::sphere, .radius = 3, .thickness = thickness}))) {
      expect_unit(n.direction);
      const double r = length(n.place);
      ASSERT_TRUE(near(n.place, n.direction * r, 1e-14));
      parts.push_back({0.5 + 0.5 * n.direction.x, turn_of(n.direction), ball_part(r / 3, thickness)});
    }
    EXPECT_TRUE(evenly_together(parts)) << thickness;
  }
  for (const Newborn& n : newborns(from({.shape = EmitShape::sphere, .radius = 3, .thickness = 0}), 1000))
    EXPECT_NEAR(length(n.place), 3, 1e-14);
}

TEST(EmitShape, a_hemisphere_is_the_half_that_lies_forwards) {
  Triples parts;
  for (const Newborn& n : newborns(from({.shape = EmitShape::hemisphere, .radius = 0.5}))) {
    expect_unit(n.direction);
    parts.push_back({n.direction.x, turn_of(n.direction), ball_part(length(n.place) / 0.5, 1)});
  }
  EXPECT_TRUE(evenly_together(parts));
}

TEST(EmitShape, a_box_is_filled_evenly) {
  Triples parts;
  for (const Newborn& n : newborns(from({.shape = EmitShape::box, .size = {6, 4, 2}}))) {
    ASSERT_EQ(n.direction, (Vec3d{1, 0, 0}));
    parts.push_back({n.place.x / 6 + 0.5, n.place.y / 4 + 0.5, n.place.z / 2 + 0.5});
  }
  EXPECT_TRUE(evenly_together(parts));
}

TEST(EmitShape, a_thinner_box_is_an_even_shell) {
  // Half of its half height thick: cells of 0.5 m are in the shell or in the hollow.
  constexpr int kX = 12, kY = 8, kZ = 4;
  std::vector<double> counts(kX * kY * kZ), in_shell;
  for (const Newborn& n : newborns(from({.shape = EmitShape::box, .size = {6, 4, 2}, .thickness = 0.5}))) {
    const auto cell = [](double x, int cells) { return std::clamp(int(std::floor(2 * x)) + cells / 2, 0, cells - 1); };
    ++counts[std::size_t((cell(n.place.x, kX) * kY + cell(n.place.y, kY)) * kZ + cell(n.place.z, kZ))];
  }
  for (int x = 0; x < kX; ++x)
    for (int y = 0; y < kY; ++y)
      for (int z = 0; z < kZ; ++z) {
        const bool hollow = x > 0 && x < kX - 1 && y > 0 && y < kY - 1 && z > 0 && z < kZ - 1;
        const double count = counts[std::size_t((x * kY + y) * kZ + z)];
        if (!hollow) in_shell.push_back(count);
        EXPECT_TRUE(!hollow || count == 0) << x << " " << y << " " << z;
      }
  const double each = double(kSamples) / double(in_shell.size());
  EXPECT_TRUE(test::as_expected(in_shell, std::vector<double>(in_shell.size(), each)));
}

TEST(EmitShape, the_surface_of_a_box_is_even_by_area) {
  std::vector<double> counts(6);
  Pairs on_top;
  for (const Newborn& n : newborns(from({.shape = EmitShape::box, .size = {6, 4, 2}, .thickness = 0}))) {
    const Vec3d part{n.place.x / 3, n.place.y / 2, n.place.z};
    std::size_t face = 6;
    for (std::size_t i = 0; i < 3; ++i)
      if (std::abs(part[i]) == 1) face = 2 * i + (part[i] > 0);
    ASSERT_LT(face, 6u);
    ++counts[face];
    if (face == 3) on_top.push_back({0.5 + 0.5 * part.x, 0.5 + 0.5 * part.z});
  }
  const double area = 2 * (4 * 2 + 6 * 2 + 6 * 4), n = double(kSamples);
  EXPECT_TRUE(test::as_expected(
      counts, {n * 8 / area, n * 8 / area, n * 12 / area, n * 12 / area, n * 24 / area, n * 24 / area}));
  EXPECT_TRUE(evenly_together(on_top));
}

TEST(EmitShape, boxes_without_a_body_are_rectangles_and_lines) {
  Pairs parts;
  for (const Newborn& n : newborns(from({.shape = EmitShape::box, .size = {0, 4, 2}, .thickness = 0}))) {
    ASSERT_EQ(n.place.x, 0);
    parts.push_back({n.place.y / 4 + 0.5, n.place.z / 2 + 0.5});
  }
  EXPECT_TRUE(evenly_together(parts));
  std::vector<double> along;
  for (const Newborn& n : newborns(from({.shape = EmitShape::box, .size = {0, 4, 0}, .thickness = 0})))
    along.push_back(n.place.y / 4 + 0.5);
  EXPECT_TRUE(evenly(along));
}

TEST(EmitShape, a_circle_fires_away_from_its_middle_across_the_axis) {
  for (const double thickness : {1.0, 0.5}) {
    Pairs parts;
    for (const Newborn& n : newborns(from({.shape = EmitShape::circle, .radius = 2, .thickness = thickness}))) {
      expect_unit(n.direction);
      ASSERT_EQ(n.direction.x, 0);
      ASSERT_TRUE(near(n.place, n.direction * length(n.place), 1e-14));
      parts.push_back({disc_part(length(n.place) / 2, thickness), turn_of(n.place)});
    }
    EXPECT_TRUE(evenly_together(parts)) << thickness;
  }
}

TEST(EmitShape, a_ring_is_filled_evenly_by_volume) {
  for (const double thickness : {1.0, 0.0}) {
    const double radius = 2, tube = 1.5;
    Triples parts;
    for (const Newborn& n :
         newborns(from({.shape = EmitShape::ring, .radius = radius, .tube = tube, .thickness = thickness}))) {
      expect_unit(n.direction);
      const double outwards = std::hypot(n.place.y, n.place.z) - radius, s = std::hypot(outwards, n.place.x) / tube;
      const Vec3d middle = Vec3d{0, n.place.y, n.place.z} * (radius / (outwards + radius));
      ASSERT_TRUE(near(n.direction * (s * tube), n.place - middle, 0, 1e-14));
      const double p = std::atan2(n.place.x, outwards);
      // The distribution function of p where s is known, for the density 1 + s r/R cos p.
      const double below = (p + s * tube / radius * std::sin(p)) / kTurn + 0.5;
      parts.push_back({turn_of(n.place), below, thickness == 0 ? double(parts.size() % 10) / 10 : s * s});
      ASSERT_TRUE(thickness > 0 || near(s, 1, 1e-14));
    }
    if (thickness == 1) {
      EXPECT_TRUE(evenly_together(parts));
      continue;
    }
    Pairs surface;
    for (const auto& part : parts) surface.push_back({part[0], part[1]});
    EXPECT_TRUE(evenly_together(surface));
  }
}

TEST(EmitShape, a_line_lies_along_z) {
  std::vector<double> along;
  for (const Newborn& n : newborns(from({.shape = EmitShape::line, .length = 7}))) {
    ASSERT_EQ(n.direction, (Vec3d{1, 0, 0}));
    ASSERT_TRUE(n.place.x == 0 && n.place.y == 0);
    along.push_back(n.place.z / 7 + 0.5);
  }
  EXPECT_TRUE(evenly(along));
}

TEST(EmitShape, an_arc_begins_above_and_turns_to_the_right) {
  for (const EmitShape shape :
       {EmitShape::cone, EmitShape::sphere, EmitShape::hemisphere, EmitShape::circle, EmitShape::ring}) {
    std::vector<double> along;
    for (const Newborn& n : newborns(from({.shape = shape, .arc = kTurn / 5}))) along.push_back(turn_of(n.place) * 5);
    EXPECT_TRUE(evenly(along)) << name(shape);
  }
}

TEST(EmitShape, arcs_go_round_or_to_and_fro_by_the_time_of_birth) {
  EmitterDef def = from({.shape = EmitShape::circle, .thickness = 0, .arc = kTurn / 2, .arc_mode = ArcMode::loop});
  def.from.arc_speed = 0.4;
  const auto turn_at = [&def](double time) {
    return turn_of(Emission(def, 1).newborn({.number = 3, .time = time}).place) * 2;
  };
  EXPECT_NEAR(turn_at(1), 0.4, 1e-12);
  EXPECT_NEAR(turn_at(7), 0.8, 1e-12);  // 2.8
  def.from.arc_mode = ArcMode::ping_pong;
  EXPECT_NEAR(turn_at(1), 0.4, 1e-12);
  EXPECT_NEAR(turn_at(4), 0.4, 1e-12);  // 1.6
  EXPECT_NEAR(turn_at(7), 0.8, 1e-12);  // 2.8
  def.from.arc_speed = -0.4;
  def.from.arc_mode = ArcMode::loop;
  EXPECT_NEAR(turn_at(1), 0.6, 1e-12);
}

TEST(EmitShape, those_of_one_moment_are_spread_over_the_arc) {
  EmitterDef def = from({.shape = EmitShape::circle, .thickness = 0, .arc_mode = ArcMode::spread});
  const auto turn_of_one = [&def](std::uint32_t i) {
    return turn_of(Emission(def, 1).newborn({.number = i, .of_moment = i, .moment = 8}).place);
  };
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_NEAR(turn_of_one(i), i / 8.0, 1e-12);
  // Of what has ends, the particles lie in the middle of equal parts.
  def.from.arc = kTurn / 2;
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_NEAR(turn_of_one(i), (i + 0.5) / 16.0, 1e-12);
  def.from.shape = EmitShape::line;
  for (std::uint32_t i = 0; i < 2; ++i)
    EXPECT_DOUBLE_EQ(Emission(def, 1).newborn({.of_moment = i, .moment = 2}).place.z, i == 0 ? -0.25 : 0.25);
}

TEST(EmitShape, randomise_turns_directions_a_part_of_the_way) {
  for (const double part : {1.0, 0.3}) {
    Pairs parts;
    for (const Newborn& n : newborns(from({.randomise = part}))) {
      expect_unit(n.direction);
      const double off = std::atan2(std::hypot(n.direction.y, n.direction.z), n.direction.x);
      parts.push_back({0.5 - 0.5 * std::cos(off / part), turn_of(n.direction)});
    }
    EXPECT_TRUE(evenly_together(parts)) << part;
  }
}

}  // namespace physim::emit_emit_shape_test
