// Generators over batches: who feels what, partners and Newton's third law, zones, user functions.
#include "world/step/force_eval.hpp"

#include <map>
#include <numeric>

#include "model/force_laws.hpp"
#include "support.hpp"
#include "world/step/kind_drag.hpp"

namespace physim::world_force_eval_test {

using test::kNan;
using test::near;
using test::same_bits;

/// A batch with its surroundings: partners are looked up in the batch, then among `outside`.
struct Batch final : Surroundings {
  std::vector<ProjectileId> id;
  std::vector<Vec3d> position, velocity, force;
  std::vector<double> mass, age, drag_rate;
  std::vector<const ProjectileDef*> def;
  std::vector<std::uint8_t> in_zone;
  std::map<std::uint32_t, State<double>> outside;
  double drag_per_speed = 0;  // a stand-in for the drag equation: density times this times u
  double own_drag_per_speed = 0;
  double time = 0;
  ForceScratch scratch;

  static const ProjectileDef& ball() {
    static const ProjectileDef def{.mass = 2, .diameter = 0.5};
    return def;
  }
  void add(std::uint32_t index, const Vec3d& x, const Vec3d& v, double m = 1, double lived = 0) {
    id.push_back({index, 1});
    position.push_back(x);
    velocity.push_back(v);
    mass.push_back(m);
    age.push_back(lived);
    def.push_back(&ball());
    in_zone.push_back(0);
    force.push_back({});
  }
  bool push(const ForceLaw& law, std::span<const std::uint32_t> members, const ForceClock& clock = {}) {
    drag_rate.resize(id.size());
    ForceStage stage{time, id, position, velocity, mass, age, def, in_zone, force, drag_rate};
    return add_force(law, clock, members, *this, stage, scratch);
  }
  bool push(const ForceLaw& law, std::initializer_list<std::uint32_t> members, const ForceClock& clock = {}) {
    return push(law, std::span(members.begin(), members.size()), clock);
  }
  void start_stage() {
    force.assign(id.size(), {});
    in_zone.assign(id.size(), 0);
  }

  [[nodiscard]] Partner partner(ProjectileId other) const override {
    for (std::uint32_t row = 0; row < id.size(); ++row)
      if (id[row] == other) return {true, row, {}};
    const auto found = outside.find(other.index);
    if (found == outside.end() || other.generation != 1) return {};
    return {true, kNotInStage, found->second};
  }
  [[nodiscard]] Vec3d drag_equation(std::uint32_t, double density, const Vec3d& u) const override {
    return u * (-density * drag_per_speed);
  }
  [[nodiscard]] OwnDrag own_drag(std::uint32_t row) const override {
    return {velocity[row] * -own_drag_per_speed, own_drag_per_speed};
  }
};

/// Five projectiles with nothing round about them.
Batch crowd() {
  Batch b;
  b.add(11, {0.1, 0.2, 0.3}, {1, 2, 3}, 0.7, 0.1);
  b.add(12, {1.1, -0.1, 0.5}, {-4, 0.5, 2}, 1.3, 0.6);
  b.add(13, {-0.7, 0.05, -0.9}, {0.3, -7, 1}, 2.9, 1.1);
  b.add(14, {0.4, -1.3, 0.6}, {2, 2, -2}, 0.2, 1.6);
  b.add(15, {3, 3, 3}, {0, 0, 0}, 5, 2.1);
  return b;
}

std::vector<std::pair<const char*, ForceLaw>> all_laws() {
  const auto swirl = [](const ForceBatch& batch) {
    for (std::size_t i = 0; i < batch.id.size(); ++i)
      batch.force[i] += cross(batch.position[i], batch.velocity[i]) * (batch.mass[i] * (1 + batch.time));
  };
  return {{"constant", ConstantForce{{1, 2, 3}}},
          {"acceleration", ConstantAcceleration{{3, 2, 1}}},
          {"gravity", GravityForce{}},
          {"drag", LinearQuadraticDragForce{0.1, 0.2, {1, 0, 0}}},
          {"anchored spring", AnchoredSpring{{0, 1, 0}, 3, 0.5, 0.2}},
          {"bungee", Bungee{{}, {0, 1, 0}, 3, 0.5, 0.2}},
          {"buoyancy", Buoyancy{.damping = 1}},
          {"attractor", PointAttractor{{0, 0, 1}, 4, 0.1}},
          {"wind zone", WindZone{{5, 0, 0}, {-1, -1, -1}, {1, 1, 1}, 1.2}},
          {"explosion", Explosion{{0, 0, 0}, 10, 2}},
          {"thrust", Thrust{{{0, 5}, {1, 3}}, {}}},
          {"custom", CustomForce{swirl}}};
}

TEST(ForceEval, acts_on_its_members_alone_and_adds) {
  for (const auto& [what, law] : all_laws()) {
    Batch b = crowd();
    b.drag_per_speed = 0.3;
    b.time = 4;
    EXPECT_TRUE(b.push(law, {0, 1, 2, 3, 4}, {0.5}));
    const std::vector<Vec3d> once = b.force;
    EXPECT_NE(once[0], (Vec3d{})) << what;

    b.start_stage();
    b.push(law, {3, 0}, {0.5});  // in any order, not side by side
    for (const int row : {1, 2, 4}) EXPECT_EQ(b.force[std::size_t(row)], (Vec3d{})) << what;
    for (const std::size_t row : {0, 3}) EXPECT_TRUE(same_bits(b.force[row], once[row])) << what;

    b.in_zone.assign(5, 0);
    b.push(law, {3}, {0.5});
    EXPECT_TRUE(same_bits(b.force[3], once[3] + once[3])) << what;
    b.start_stage();
    EXPECT_TRUE(b.push(law, {})) << what;
    for (const Vec3d& force : b.force) EXPECT_EQ(force, (Vec3d{})) << what;
  }
}

TEST(ForceEval, a_row_that_is_no_number_spoils_no_other) {
  for (const auto& [what, law] : all_laws()) {
    Batch good = crowd(), bad = crowd();
    bad.position[1] = {kNan, kNan, kNan};
    bad.velocity[1] = {kNan, 0, 0};
    for (Batch* b : {&good, &bad}) b->push(law, {0, 1, 2, 3, 4}, {0.5});
    for (const std::size_t row : {0, 2, 3, 4}) EXPECT_TRUE(same_bits(bad.force[row], good.force[row])) << what;
  }
}

TEST(ForceEval, mass_counts_where_it_should) {
  Batch b = crowd();
  b.push(ConstantForce{{1, 2, 3}}, {3});
  EXPECT_EQ(b.force[3], (Vec3d{1, 2, 3}));
  b.push(ConstantAcceleration{{1, 0, 0}}, {4});
  EXPECT_EQ(b.force[4], (Vec3d{5, 0, 0}));
  b.push(GravityForce{}, {4});
  EXPECT_EQ(b.force[4], (Vec3d{5, -5 * 9.80665, 0}));
}

// ---------------------------------------------------------------------------------------------------------- partners
/// Moves the whole batch by the classic fourth-order method; generators act in every stage.
void move(Batch& b, double h, int steps, const std::function<void(Batch&)>& push) {
  const std::size_t n = b.id.size();
  constexpr double kPart[] = {0, 0.5, 0.5, 1}, kWeight[] = {1, 2, 2, 1};
  for (int step = 0; step < steps; ++step) {
    const std::vector<Vec3d> x = b.position, v = b.velocity;
    std::vector<Vec3d> dx(n), dv(n), sum_x(n), sum_v(n);
    for (int stage = 0; stage < 4; ++stage) {
      for (std::size_t i = 0; i < n; ++i) {
        b.position[i] = x[i] + dx[i] * (h * kPart[stage]);
        b.velocity[i] = v[i] + dv[i] * (h * kPart[stage]);
      }
      b.start_stage();
      push(b);
      for (std::size_t i = 0; i < n; ++i) {
        dx[i] = b.velocity[i];
        dv[i] = b.force[i] * (1 / b.mass[i]);
        sum_x[i] += dx[i] * kWeight[stage];
        sum_v[i] += dv[i] * kWeight[stage];
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      b.position[i] = x[i] + sum_x[i] * (h / 6);
      b.velocity[i] = v[i] + sum_v[i] * (h / 6);
    }
  }
}

Vec3d momentum(const Batch& b) {
  Vec3d sum;
  for (std::size_t i = 0; i < b.id.size(); ++i) sum += b.velocity[i] * b.mass[i];
  return sum;
}

TEST(ForceEval, springs_between_projectiles_conserve_momentum_and_energy) {
  const ForceLaw spring = Spring{{12, 1}, 30, 0.8, 0}, rope = Bungee{{14, 1}, {}, 20, 0.3, 0};
  Batch b = crowd();
  const auto energy = [](const Batch& at) {
    double sum = 0;
    for (std::size_t i = 0; i < at.id.size(); ++i) sum += at.mass[i] * length_squared(at.velocity[i]) / 2;
    for (const std::size_t i : {0, 2}) {
      const double stretch = length(at.position[i] - at.position[1]) - 0.8;
      sum += 30 * stretch * stretch / 2;
    }
    const double pull = std::max(length(at.position[4] - at.position[3]) - 0.3, 0.0);
    return sum + 20 * pull * pull / 2;
  };
  const Vec3d momentum_before = momentum(b);
  const double energy_before = energy(b);
  move(b, 0.0002, 10000, [&](Batch& at) {
    at.push(spring, {0, 2});
    at.push(rope, {4});
  });
  EXPECT_TRUE(near(momentum(b), momentum_before, 1e-12));
  EXPECT_TRUE(near(energy(b), energy_before, 1e-8));
}

// Two masses on a spring swing with w^2 = k (1/m1 + 1/m2) about a centre of mass that stays.
TEST(ForceEval, a_pair_swings_with_its_reduced_mass) {
  Batch b;
  b.add(1, {0, 0, 0}, {}, 2);
  b.add(2, {1.5, 0, 0}, {}, 3);
  const double t = 1.3, w = std::sqrt(10 * (1.0 / 2 + 1.0 / 3));
  move(b, t / 1000, 1000, [](Batch& at) { at.push(Spring{{2, 1}, 10, 1, 0}, {0}); });
  EXPECT_TRUE(near(b.position[1].x - b.position[0].x, 1 + 0.5 * std::cos(w * t), 1e-9));
  EXPECT_TRUE(near((2 * b.position[0].x + 3 * b.position[1].x) / 5, 0.9, 1e-12));
}

TEST(ForceEval, a_damped_pair_comes_to_rest_with_its_momentum) {
  Batch b;
  b.add(1, {0, 0, 0}, {3, 0, 0}, 2);
  b.add(2, {1, 0, 0}, {-1, 0, 0}, 3);
  move(b, 0.01, 3000, [](Batch& at) { at.push(Spring{{1, 1}, 20, 1, 4}, {1}); });
  for (const Vec3d& v : b.velocity) EXPECT_TRUE(near(v, {0.6, 0, 0}, 1e-9));
}

TEST(ForceEval, a_partner_outside_the_batch_pulls_and_is_not_pulled) {
  Batch b = crowd();
  b.outside[99] = {{0.1, 5.2, 0.3}, {1, 0, 3}};
  EXPECT_TRUE(b.push(Spring{{99, 1}, 10, 1, 3}, {0}));
  EXPECT_TRUE(near(b.force[0], {0, 10 * 4 - 3 * 2, 0}, 1e-14));
  EXPECT_TRUE(b.push(Bungee{{99, 1}, {}, 10, 1, 3}, {0}));
  EXPECT_TRUE(near(b.force[0], {0, 2 * 34, 0}, 1e-14));
  for (const std::size_t row : {1, 2, 3, 4}) EXPECT_EQ(b.force[row], (Vec3d{}));
}

TEST(ForceEval, a_partner_that_is_gone_ends_the_generator) {
  for (const ForceLaw& law : {ForceLaw(Spring{{99, 1}}), ForceLaw(Bungee{{99, 1}}), ForceLaw(Spring{{11, 2}})}) {
    Batch b = crowd();
    EXPECT_FALSE(b.push(law, {0, 1}));
    EXPECT_FALSE(b.push(law, {})) << "also without members";
    for (const Vec3d& force : b.force) EXPECT_EQ(force, (Vec3d{}));
  }
}

TEST(ForceEval, nobody_has_a_spring_to_itself) {
  Batch with = crowd(), without = crowd();
  with.push(Spring{{12, 1}, 7, 1, 0}, {0, 1, 2});
  without.push(Spring{{12, 1}, 7, 1, 0}, {0, 2});
  for (std::size_t i = 0; i < with.id.size(); ++i) EXPECT_TRUE(same_bits(with.force[i], without.force[i]));
  EXPECT_TRUE(near(with.force[0] + with.force[1] + with.force[2], Vec3d{}, 0, 1e-14));
}

// ------------------------------------------------------------------------------------------- clocks, liquids, zones
TEST(ForceEval, thrust_counts_from_its_start_or_from_each_launch) {
  const Thrust law{{{0, 10}, {1, 20}}, {0, 1, 0}};
  Batch b = crowd();
  b.push(law, {0, 1, 2}, {0.25, false});
  for (const std::size_t row : {0, 1, 2}) EXPECT_TRUE(near(b.force[row], {0, 12.5, 0}, 1e-14));
  b.start_stage();
  b.push(law, {0, 1, 2}, {0.25, true});
  EXPECT_TRUE(near(b.force[0], {0, 11, 0}, 1e-14)) << "age 0.1 s";
  EXPECT_TRUE(near(b.force[1], {0, 16, 0}, 1e-14)) << "age 0.6 s";
  EXPECT_EQ(b.force[2], (Vec3d{})) << "burnt out";
}

TEST(ForceEval, a_liquid_lifts_by_the_projectiles_own_diameter) {
  Batch b = crowd();
  b.push(Buoyancy{}, {3});  // 1.3 m under
  const double volume = 3.14159265358979323846 / 6 * 0.125;
  EXPECT_TRUE(near(b.force[3], {0, 9806.65 * volume, 0}, 1e-14));
}

TEST(ForceEval, the_air_of_a_zone_takes_the_place_of_the_air_around) {
  Batch b = crowd();
  b.drag_per_speed = 0.5;
  b.own_drag_per_speed = 0.3;
  const WindZone zone{{2, 0, 0}, {-1, -1, -1}, {1, 1, 1}, 1.2};
  b.push(zone, {0, 1, 2, 3, 4});
  for (const std::size_t row : {0, 2}) {
    const Vec3d& v = b.velocity[row];
    EXPECT_TRUE(near(b.force[row], (v - zone.velocity) * -0.6 + v * 0.3, 1e-14));
    EXPECT_NEAR(b.drag_rate[row], 0.6 - 0.3, 1e-12);
  }
  for (const std::size_t row : {1, 3, 4}) EXPECT_EQ(b.force[row], (Vec3d{})) << "outside";

  const std::vector<Vec3d> before = b.force;
  b.push(WindZone{{0, 9, 0}, {-1, -2, -1}, {1, 0.1, 1}, 1.2}, {0, 1, 2, 3, 4});
  for (const std::size_t row : {0, 1, 2, 4}) EXPECT_EQ(b.force[row], before[row]) << "the first zone has it";
  EXPECT_NE(b.force[3], (Vec3d{})) << "in the second alone";
}

/// The drag force of a flight through constant air of 15 degrees and 1.225 kg/m^3, on the rung of the drag equation
/// [N].
Vec3d drag_in_flight(const ProjectileDef& projectile, const Vec3d& v) {
  Fidelity fidelity = test::vacuum(Integrator::rk4);
  fidelity.gravity = GravityModel::off;
  fidelity.drag = DragModel::equation;
  fidelity.air = AirModel::constant;
  const test::Prepared p(projectile, {}, {.atmosphere = {.density = 1.225}}, fidelity);
  return p.acceleration(0, {{}, v}) * projectile.mass;
}

TEST(KindDrag, is_the_drag_of_every_flight) {
  ProjectileDef banded = test::bullet_308();
  banded.drag.bands = {{0, 150}, {300, 170}, {600, 180}};
  const ProjectileDef sphere{.mass = 0.05, .diameter = 0.04, .drag = {.table = DragTable::sphere}};
  const ProjectileDef shell{.mass = 43, .diameter = 0.155, .drag = {.table = DragTable::g1, .form_factor = 0.6}};
  const ProjectileDef odd{.drag = {.table = DragTable::custom, .curve = {{0.1, 0.2}, {0.9123, 0.3}, {2.71, 0.25}}}};
  const std::vector<ProjectileDef> all{test::bullet_308(), Batch::ball(), banded, sphere, shell, odd};

  KindDrag made;
  std::vector<std::uint32_t> index;
  for (const ProjectileDef& p : all) index.push_back(made.add(p));
  const KindDrag kinds = std::move(made);  // as worlds move
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const double speed : {0.0, 3.0, 120.0, 333.0, 500.0, 900.0}) {
      const Vec3d v = Vec3d{0.6, -0.64, 0.48} * speed;
      EXPECT_TRUE(near(kinds.force(index[i], all[i].mass, 1.225, v), drag_in_flight(all[i], v), 1e-14)) << i;
    }
}

TEST(KindDrag, is_proportional_to_density_and_to_its_kind) {
  KindDrag kinds;
  const ProjectileDef ball = Batch::ball();  // Cd 1/2
  ProjectileDef halved = ball, dragless = ball;
  halved.drag.form_factor = 0.5;
  dragless.drag.coefficient = 0;
  const std::uint32_t one = kinds.add(ball), half = kinds.add(halved), none = kinds.add(dragless);
  const double area = 3.14159265358979323846 / 4 * 0.25;
  EXPECT_TRUE(near(kinds.force(one, 2, 1.1, {10, 0, 0}), {-0.5 * 1.1 * 100 * 0.5 * area, 0, 0}, 1e-14));
  EXPECT_TRUE(near(kinds.force(half, 2, 2.2, {10, 0, 0}), kinds.force(one, 2, 1.1, {10, 0, 0}), 1e-14));
  EXPECT_EQ(length(kinds.force(none, 2, 1.1, {10, 0, 0})), 0);
  EXPECT_EQ(length(kinds.force(one, 2, 0, {10, 0, 0})), 0);
}

// ----------------------------------------------------------------------------------------------------- user functions
TEST(ForceEval, a_user_function_is_called_once_with_all_its_members) {
  Batch b = crowd();
  b.time = 7;
  b.push(ConstantForce{{1, 1, 1}}, {0, 1, 2, 3, 4});
  int calls = 0;
  const CustomForce law{[&](const ForceBatch& batch) {
    ++calls;
    EXPECT_EQ(batch.time, 7);
    ASSERT_EQ(batch.id.size(), 3u);
    for (const auto size : {batch.position.size(), batch.velocity.size(), batch.mass.size(), batch.force.size()})
      EXPECT_EQ(size, 3u);
    const std::size_t rows[] = {4, 1, 2};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(batch.id[i], b.id[rows[i]]);
      EXPECT_EQ(batch.position[i], b.position[rows[i]]);
      EXPECT_EQ(batch.velocity[i], b.velocity[rows[i]]);
      EXPECT_EQ(batch.mass[i], b.mass[rows[i]]);
      EXPECT_EQ(batch.force[i], (Vec3d{})) << "others' forces are not its matter";
      batch.force[i] = Vec3d{0, batch.mass[i], 0};  // assigning is as good as adding
    }
  }};
  b.push(law, {4, 1, 2});
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(b.force[4], (Vec3d{1, 6, 1}));
  EXPECT_EQ(b.force[2], (Vec3d{1, 3.9, 1}));
  EXPECT_EQ(b.force[0], (Vec3d{1, 1, 1}));
  b.push(law, {});
  EXPECT_EQ(calls, 1) << "nobody to push";
}

TEST(ForceEval, what_a_user_function_makes_that_is_no_number_hits_one_projectile) {
  Batch b = crowd();
  const CustomForce law{[](const ForceBatch& batch) { batch.force[1] = {0, kNan, 0}; }};
  b.push(law, {0, 2, 3});
  EXPECT_TRUE(std::isnan(b.force[2].y));
  for (const std::size_t row : {0, 1, 3, 4}) EXPECT_EQ(b.force[row], (Vec3d{}));
}

TEST(ForceEval, a_steady_step_gathers_into_the_same_memory) {
  Batch b;
  for (std::uint32_t i = 0; i < 1000; ++i) b.add(i + 1, {double(i), 0, 0}, {});
  const Vec3d* seen = nullptr;
  const CustomForce law{[&](const ForceBatch& batch) { seen = batch.position.data(); }};
  std::vector<std::uint32_t> members(999);
  std::iota(members.begin(), members.end(), 0u);
  std::swap(members[3], members[7]);
  b.push(law, members);
  const Vec3d* first = seen;
  for (int step = 0; step < 5; ++step) {
    members.resize(members.size() - 1);
    b.push(law, members);
    EXPECT_EQ(seen, first);
  }
  std::iota(members.begin(), members.end(), 5u);
  b.push(law, members);
  EXPECT_EQ(seen, b.position.data() + 5) << "rows side by side are not copied at all";
}

}  // namespace physim::world_force_eval_test
