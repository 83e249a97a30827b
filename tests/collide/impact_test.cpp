// What becomes of projectiles that meet materials: the order of decisions, each law by what it must give, and what
// holds for all of them.
#include <random>

#include "base/hash.hpp"
#include "support.hpp"

namespace physim::collide_impact_test {

using test::kDegree;
using test::near;

/// A .308 bullet that comes down at an angle from the surface.
Impact bullet(double speed, double angle_deg, double thickness = 0) {
  const double angle = angle_deg * kDegree;
  return {.mass = 0.0109,
          .diameter = 0.00782,
          .length = 0.031,
          .nose_length = 1.8,
          .velocity = {speed * std::cos(angle), -speed * std::sin(angle), 0},
          .thickness = thickness};
}
ImpactResult of(const Impact& hit, const Material& material) { return must(impact(hit, material)); }
double angle_of(const Vec3d& v) { return std::asin(v.y / length(v)) / kDegree; }

TEST(Impact, nothing_happens_to_what_does_not_move_towards_the_surface) {
  for (const Vec3d& v : {Vec3d{}, Vec3d{3, 0, 0}, Vec3d{3, 1, 0}}) {
    const ImpactResult r = of({.velocity = v, .spin = {1, 2, 3}}, {});
    EXPECT_EQ(r.kind, ImpactKind::none);
    EXPECT_EQ(r.velocity, v);
    EXPECT_EQ(r.spin, (Vec3d{1, 2, 3}));
    EXPECT_EQ(r.energy, 0);
  }
}

TEST(Impact, a_material_of_which_nothing_is_known_bounces) {
  const ImpactResult r = of(bullet(800, 5), {.restitution = 0.4, .friction = 0});
  EXPECT_EQ(r.kind, ImpactKind::bounced);
  EXPECT_NEAR(r.velocity.y, 0.4 * 800 * std::sin(5 * kDegree), 1e-10);
  EXPECT_NEAR(r.obliquity / kDegree, 85, 1e-12);
  EXPECT_EQ(r.depth, 0);
}

TEST(Impact, obliquity_is_exact_straight_on_and_flat) {
  for (const double off : {0.0, 1e-12, 1e-3, 1.0})
    EXPECT_TRUE(near(of({.velocity = {std::sin(off), -std::cos(off), 0}}, {}).obliquity, off, 1e-14));
  EXPECT_NEAR(of({.velocity = {1, -1e-12, 0}}, {}).obliquity / kDegree, 90, 1e-9);
}

TEST(Impact, a_point_bounces_as_on_the_ground_and_keeps_its_spin) {
  const ImpactResult r =
      of({.velocity = {4, -3, 0}, .spin = {0, 0, 50}}, {.restitution = 0.5, .friction = 0.2, .grip_restitution = 1});
  EXPECT_TRUE(near(r.velocity, {4 - 0.2 * 1.5 * 3, 1.5, 0}, 1e-15));
  EXPECT_EQ(r.spin, (Vec3d{0, 0, 50}));
}

TEST(Impact, a_ball_bounces_with_its_spin) {
  const Impact ball{.mass = 0.058, .diameter = 0.067, .inertia = 2.0 / 3, .velocity = {3, -9, 0}};
  const ImpactResult r = of(ball, {.restitution = 0.7, .friction = 0.9});
  EXPECT_TRUE(near(r.velocity, {3 * 3.0 / 5, 6.3, 0}, 1e-14));
  EXPECT_TRUE(near(r.spin, {0, 0, -3 * 3.0 / 5 / 0.0335}, 1e-14));
  const double before = 0.5 * 0.058 * (9 + 81);
  const double after = 0.5 * 0.058 * (length_squared(r.velocity) + 2.0 / 3 * 0.0335 * 0.0335 * length_squared(r.spin));
  EXPECT_TRUE(near(r.energy, before - after, 1e-12));
}

TEST(Impact, what_comes_in_flat_ricochets_before_anything_else_is_asked) {
  Material soil{.ricochet = {.critical_angle = 18 * kDegree, .restitution = 0.3, .friction = 0.5},
                .penetration = PonceletDef{.strength = 2e7}};
  const ImpactResult flat = of(bullet(700, 17.9), soil);
  EXPECT_EQ(flat.kind, ImpactKind::ricocheted);
  const double sine = std::sin(17.9 * kDegree), cosine = std::cos(17.9 * kDegree);
  EXPECT_TRUE(near(flat.velocity, {700 * (cosine - 0.5 * 1.3 * sine), 700 * 0.3 * sine, 0}, 1e-13));
  EXPECT_EQ(of(bullet(700, 18.1), soil).kind, ImpactKind::stopped);
  soil.penetration = ImpenetrableDef{};
  EXPECT_EQ(of(bullet(700, 18.1), soil).kind, ImpactKind::bounced);
}

// Johnson and Reid 1975: 18 degrees over the root of the specific gravity.
TEST(Impact, round_shot_ricochets_off_water) {
  const double diameter = 0.1, mass = 7850 * 3.14159265358979323846 / 6 * diameter * diameter * diameter;
  const auto shot = [&](double angle_deg) {
    Impact hit = bullet(300, angle_deg);
    hit.mass = mass, hit.diameter = diameter, hit.nose_length = 0.5;
    return of(hit, materials::water());
  };
  const ImpactResult r = shot(5);
  EXPECT_EQ(r.kind, ImpactKind::ricocheted);
  EXPECT_NEAR(angle_of(r.velocity), 5, 1e-10);
  EXPECT_GT(length(r.velocity), 0.7 * 300);
  EXPECT_LT(length(r.velocity), 0.8 * 300);
  EXPECT_EQ(shot(6.3).kind, ImpactKind::ricocheted);
  EXPECT_EQ(shot(6.6).kind, ImpactKind::stopped);
}

TEST(Impact, water_slows_a_ball_and_does_not_stop_it) {
  Impact ball{.mass = 0.5, .diameter = 0.05, .velocity = {0, -100, 0}, .thickness = 0.3};
  const double area = 3.14159265358979323846 / 4 * 0.05 * 0.05;
  const ImpactResult r = of(ball, materials::water());
  EXPECT_EQ(r.kind, ImpactKind::penetrated);
  // Drag coefficient of Birkhoff's pressure on a sphere: 1/2.
  EXPECT_NEAR(-r.velocity.y, 100 * std::exp(-0.5 * 998.2 * 0.5 * area * 0.3 / 0.5), 1e-9);
  ball.thickness = 0;
  const ImpactResult deep = of(ball, materials::water());
  EXPECT_EQ(deep.kind, ImpactKind::stopped);
  EXPECT_NEAR(std::exp(-0.5 * 998.2 * 0.5 * area * deep.depth / 0.5), 0.01, 1e-12) << "where a hundredth is left";
}

TEST(Impact, a_plank_is_gone_through_and_a_beam_is_not) {
  const ImpactResult plank = of(bullet(780, 90, 0.018), materials::fir());
  EXPECT_EQ(plank.kind, ImpactKind::penetrated);
  EXPECT_EQ(plank.depth, 0.018);
  const double area = 3.14159265358979323846 / 4 * 0.00782 * 0.00782, force = 3.94e6 / 2 * 9.80665 * area;
  EXPECT_NEAR(-plank.velocity.y, std::sqrt(780 * 780 - 2 * force * 0.018 / 0.0109), 1e-9);
  EXPECT_NEAR(plank.energy, force * 0.018, 1e-9);
  const ImpactResult slow = of(bullet(50, 90, 0.2), materials::fir());
  EXPECT_EQ(slow.kind, ImpactKind::stopped);
  EXPECT_NEAR(slow.depth, 0.5 * 0.0109 * 2500 / force, 1e-12);
  EXPECT_EQ(slow.velocity, (Vec3d{}));
  EXPECT_NEAR(slow.energy, 0.5 * 0.0109 * 2500, 1e-12);
}

TEST(Impact, what_is_less_deep_than_its_half_is_thrown_back) {
  const Impact ball{.mass = 0.058, .diameter = 0.067, .velocity = {0, -30, 0}};
  const ImpactResult r = of(ball, materials::oak());
  EXPECT_EQ(r.kind, ImpactKind::bounced);
  EXPECT_NEAR(r.velocity.y, 15, 1e-12);
}

TEST(Impact, concrete_stops_a_shot_where_it_stopped_forrestals) {
  const Impact shot{
      .mass = 0.906, .diameter = 0.0269, .nose_length = std::sqrt(1.75), .velocity = {0, -277, 0}, .thickness = 0.6};
  const ImpactResult r = of(shot, materials::concrete(35.2e6));
  EXPECT_EQ(r.kind, ImpactKind::stopped);
  EXPECT_TRUE(near(r.depth, 0.173, 0.04));
}

TEST(Impact, layers_of_soil_add_up) {
  Impact bomb{.mass = 900, .diameter = 0.4, .nose_length = 2, .velocity = {0, -300, 0}};
  const Material soil{.penetration = YoungDef{.s_number = 7}};
  const double depth = of(bomb, soil).depth;
  EXPECT_GT(depth, 5);
  bomb.thickness = 0.3 * depth;
  const ImpactResult behind = of(bomb, soil);
  EXPECT_EQ(behind.kind, ImpactKind::penetrated);
  bomb.velocity = behind.velocity, bomb.thickness = 0;
  EXPECT_TRUE(near(of(bomb, soil).depth, 0.7 * depth, 1e-13));
}

TEST(Impact, armour_is_gone_through_above_its_limit) {
  const double limit = 540.085;  // of the textbook's shot: 1772 ft/s
  Impact shot{.mass = 226.796, .diameter = 0.254, .velocity = {0, -limit * 1.001, 0}, .thickness = 0.400558};
  const ImpactResult through = of(shot, materials::nickel_steel());
  EXPECT_EQ(through.kind, ImpactKind::penetrated);
  EXPECT_NEAR(-through.velocity.y, limit * std::sqrt(1.001 * 1.001 - 1), 0.05);
  shot.velocity.y = -limit * 0.999;
  const ImpactResult held = of(shot, materials::nickel_steel());
  EXPECT_EQ(held.kind, ImpactKind::stopped);
  EXPECT_TRUE(near(held.depth, 0.400558, 0.002));
  // A plug of the plate's own mass is carried along.
  Material plugging = materials::nickel_steel();
  plugging.density = 7850;
  plugging.penetration = DeMarreDef{.plug = 1};
  shot.velocity.y = -800;
  const double plug = 7850 * 3.14159265358979323846 / 4 * 0.254 * 0.254 * 0.400558;
  EXPECT_TRUE(
      near(-of(shot, plugging).velocity.y, 226.796 / (226.796 + plug) * std::sqrt(800 * 800 - limit * limit), 1e-5));
}

TEST(Impact, a_plate_of_a_measured_limit) {
  const Material plate{.penetration = BallisticLimitDef{.speed = 184.5, .a = 0.8, .p = 2.2}};
  const ImpactResult straight = of(bullet(300, 90, 0.012), plate);
  EXPECT_NEAR(-straight.velocity.y, 0.8 * std::pow(std::pow(300, 2.2) - std::pow(184.5, 2.2), 1 / 2.2), 1e-10);
  // Met at 30 degrees from the surface only half of the speed counts.
  EXPECT_EQ(of(bullet(368, 30, 0.024), plate).kind, ImpactKind::stopped);
  EXPECT_EQ(of(bullet(370, 30, 0.024), plate).kind, ImpactKind::penetrated);
  EXPECT_EQ(of(bullet(300, 90), plate).kind, ImpactKind::penetrated) << "whatever its thickness";
}

TEST(Impact, a_rod_goes_through_the_plate_of_its_limit) {
  Impact rod{.mass = 0.098, .diameter = 0.009, .length = 0.09, .velocity = {0, -1500, 0}};
  const double depth = of(rod, materials::rolled_armour()).depth;
  EXPECT_GT(depth, 0.05);
  EXPECT_LT(depth, 0.2);
  rod.thickness = depth * 1.0001;
  EXPECT_EQ(of(rod, materials::rolled_armour()).kind, ImpactKind::stopped);
  rod.thickness = depth * 0.9999;
  EXPECT_EQ(of(rod, materials::rolled_armour()).kind, ImpactKind::penetrated);
  EXPECT_GT(of(rod, materials::aluminium()).velocity.y, -1500);
  EXPECT_LT(of(rod, materials::aluminium()).velocity.y, of(rod, materials::rolled_armour()).velocity.y);
}

TEST(Impact, a_wall_that_moves_is_met_in_its_own_frame) {
  const Material wall{.restitution = 1, .friction = 0};
  EXPECT_TRUE(near(of({.velocity = {0, -2, 0}, .surface_velocity = {0, 10, 0}}, wall).velocity, {0, 22, 0}, 1e-15));
  EXPECT_EQ(of({.velocity = {0, 2, 0}, .surface_velocity = {0, 10, 0}}, wall).kind, ImpactKind::bounced);
  EXPECT_EQ(of({.velocity = {0, -2, 0}, .surface_velocity = {0, -10, 0}}, wall).kind, ImpactKind::none);
  Impact stuck = bullet(300, 90);
  stuck.surface_velocity = {3, -20, 1};
  const ImpactResult r = of(stuck, materials::oak());
  EXPECT_EQ(r.kind, ImpactKind::stopped);
  EXPECT_EQ(r.velocity, stuck.surface_velocity);
}

TEST(Impact, what_leaves_is_spread_by_its_numbers_and_stays_on_its_side) {
  Material soil{.ricochet = {.critical_angle = 20 * kDegree, .restitution = 0.2},
                .spread = {.deflection = 0.2, .yaw = 0.3}};
  Impact hit = bullet(400, 10);
  const ImpactResult first = of(hit, soil);
  EXPECT_EQ(of(hit, soil).velocity, first.velocity);
  double squares = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    hit.projectile = i;
    const ImpactResult r = of(hit, soil);
    EXPECT_GT(r.velocity.y, 0);
    EXPECT_TRUE(near(length(r.velocity), length(first.velocity), 1e-12));
    EXPECT_NEAR(length(r.nose), 1, 1e-12);
    squares += std::pow(std::acos(dot(r.nose, normalized(r.velocity))), 2);
  }
  EXPECT_NEAR(squares / 2000, 2 * 0.3 * 0.3, 0.012) << "two planes";
  soil = materials::fir();
  soil.spread.deflection = 1;
  hit = bullet(700, 8, 0.02);
  for (hit.hit = 0; hit.hit < 500; ++hit.hit) EXPECT_LT(of(hit, soil).velocity.y, 0) << "goes on behind";
}

TEST(Impact, without_a_spread_nothing_is_drawn) {
  Impact hit = bullet(700, 60, 0.02);
  const Vec3d velocity = of(hit, materials::fir()).velocity;
  hit.seed = 5, hit.projectile = 6, hit.hit = 7;
  EXPECT_EQ(of(hit, materials::fir()).velocity, velocity);
  EXPECT_TRUE(near(normalized(velocity), normalized(hit.velocity), 1e-15));
  EXPECT_EQ(of(hit, materials::fir()).nose, (Vec3d{}));
}

/// Impacts and materials of all kinds, by numbers from the generator's bits alone: equal everywhere.
class AnyImpact {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) / 9007199254740992.0);
  }
  Vec3d vector(double size) {
    const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }
  Impact hit() {
    Impact i{.mass = between(0.001, 50), .diameter = between(0.002, 0.3), .length = between(0.01, 1)};
    i.nose_length = between(0, 3), i.inertia = between(0.1, 1);
    i.velocity = vector(1000), i.spin = vector(100), i.surface_velocity = vector(50);
    i.normal = normalized(vector(1));
    i.thickness = random_() % 2 == 0 ? 0 : between(1e-3, 0.5);
    i.seed = random_(), i.projectile = static_cast<std::uint32_t>(random_()), i.hit = random_() % 9;
    return i;
  }
  Material material() {
    Material m{.restitution = between(0, 1), .friction = between(0, 1), .grip_restitution = between(0, 1)};
    m.density = between(500, 9000);
    m.ricochet = {.critical_angle = between(0, 0.5), .restitution = between(0, 1), .friction = between(0, 0.9)};
    m.ricochet.liquid = random_() % 4 == 0;
    switch (random_() % 6) {
      case 0: break;
      case 1: m.penetration = PonceletDef{between(1e6, 1e9), between(0, 1), between(0, 3)}; break;
      case 2: m.penetration = YoungDef{between(0.5, 30), random_() % 2 == 0}; break;
      case 3: m.penetration = DeMarreDef{between(0.5, 2), between(0, 1)}; break;
      case 4: m.penetration = LambertDef{between(1000, 5000)}; break;
      default: m.penetration = BallisticLimitDef{between(10, 900), between(0, 1), between(1, 5)};
    }
    if (random_() % 2 == 0) m.spread = {between(0, 0.3), between(0, 0.3)};
    return m;
  }

 private:
  std::mt19937_64 random_{2024};
};

TEST(Impact, no_contact_gives_energy_or_leaves_on_the_wrong_side) {
  AnyImpact any;
  int kinds[5] = {};
  for (int i = 0; i < 20000; ++i) {
    const Impact hit = any.hit();
    const Material material = any.material();
    const ImpactResult r = of(hit, material);
    ++kinds[static_cast<int>(r.kind)];
    const double out = dot(r.velocity - hit.surface_velocity, hit.normal);
    const double radius = hit.diameter / 2;
    const auto energy = [&](const Vec3d& v, const Vec3d& spin) {
      return 0.5 * hit.mass *
             (length_squared(v - hit.surface_velocity) + hit.inertia * radius * radius * length_squared(spin));
    };
    const double before = energy(hit.velocity, hit.spin), after = energy(r.velocity, r.spin);
    EXPECT_LE(after, before * (1 + 1e-12));
    EXPECT_TRUE(near(r.energy, before - after, 1e-9, 1e-9 * before));
    const double slack = 1e-9 * length(hit.velocity);
    switch (r.kind) {
      case ImpactKind::none: EXPECT_EQ(r.energy, 0); break;
      case ImpactKind::bounced:
      case ImpactKind::ricocheted: EXPECT_GE(out, -slack); break;
      case ImpactKind::penetrated:
        EXPECT_LE(out, slack);
        EXPECT_EQ(r.depth, hit.thickness);
        break;
      case ImpactKind::stopped: EXPECT_GE(r.depth, radius); break;
    }
  }
  for (const int count : kinds) EXPECT_GT(count, 200);
}

TEST(Impact, thicker_leaves_less_speed) {
  AnyImpact any;
  for (int i = 0; i < 2000; ++i) {
    Impact hit = any.hit();
    Material material = any.material();
    material.spread = {};
    double before = kInfinity;
    for (const double thickness : {0.001, 0.01, 0.1, 1.0, 10.0}) {
      hit.thickness = thickness;
      const ImpactResult r = of(hit, material);
      if (r.kind != ImpactKind::penetrated) break;
      const double speed = length(r.velocity - hit.surface_velocity);
      EXPECT_LE(speed, before * (1 + 1e-12));
      before = speed;
    }
  }
}

TEST(Impact, the_bits_are_the_same_everywhere) {
  AnyImpact any;
  Hash hash;
  for (int i = 0; i < 5000; ++i) {
    const Impact hit = any.hit();
    const ImpactResult r = of(hit, any.material());
    for (const Vec3d& v : {r.velocity, r.spin, r.nose}) hash.add(v.x), hash.add(v.y), hash.add(v.z);
    for (const double x : {r.depth, r.obliquity, r.energy}) hash.add(x);
  }
  EXPECT_EQ(hash.value(), 3930440734917941278u);
}

}  // namespace physim::collide_impact_test
