// Closed forms fly on from where they are when what they are evaluated with changes: gravity, wind, drag, rest.
#include "world/world_support.hpp"

namespace physim::world_closed_form_law_test {

constexpr double kG = 9.80665;
constexpr double kStep = 1.0 / 64;

/// What flies by itself, as it is written in books.
struct Law {
  double gravity = kG;  // [m/s^2]
  double rate = 0;      // of the drag [1/s]
  Vec3d wind{};

  [[nodiscard]] BodyState after(const BodyState& start, double t) const {
    const Vec3d g{0, -gravity, 0};
    if (rate == 0) return {start.position + start.velocity * t + g * (0.5 * t * t), start.velocity + g * t};
    const double decay = std::exp(-rate * t);
    const Vec3d last = wind + g * (1 / rate);  // velocity in the end
    const Vec3d more = start.velocity - last;
    return {start.position + last * t + more * ((1 - decay) / rate), last + more * decay};
  }
};

constexpr double kDamping = 0.8, kLinear = 0.3;
constexpr DragModel kDrags[] = {DragModel::off, DragModel::damping, DragModel::linear_quadratic};
double rate_of(DragModel drag) {
  return drag == DragModel::damping ? -std::log(kDamping) : drag == DragModel::linear_quadratic ? kLinear : 0;
}

ProjectileDef seed(DragModel drag, WindModel wind = WindModel::constant) {
  ProjectileDef p = stone();
  p.mass = 2;
  p.drag.damping = kDamping;
  p.drag.k1 = kLinear * p.mass;
  p.fidelity.motion = Motion::closed_form;
  p.fidelity.drag = drag;
  p.fidelity.wind = wind;
  return p;
}

const Launch kThrow{.position = {1, 500, 2}, .velocity = Vec3d{30, 20, -5}};
const BodyState kThrown{kThrow.position, *kThrow.velocity};

void expect_at(const World& world, ProjectileId id, const BodyState& want) {
  const BodyState is = world[id].state();
  EXPECT_LT(length(is.position - want.position), 1e-9 * length(want.position));
  EXPECT_LT(length(is.velocity - want.velocity), 1e-11 * (1 + length(want.velocity)));
}

/// A world that is saved and loaded is the same.
void expect_saved(const World& world) {
  const auto loaded = reloaded(world);
  EXPECT_EQ(loaded.hash(), world.hash());
}

/// Changes something in flight, twice; what it is after the change follows from where it was.
template <class Change>
void expect_pieces(DragModel drag, const Law& first, const Law& then, const Change& change,
                   WindModel wind = WindModel::constant) {
  SCOPED_TRACE(static_cast<int>(drag));
  World world;
  const ProjectileId id = *world.spawn(seed(drag, wind), kThrow);
  run_for(world, 1, kStep);
  const BodyState at_change = first.after(kThrown, 1);
  expect_at(world, id, at_change);
  const BodyState before = world[id].state();
  change(world, id);
  EXPECT_EQ(world[id].state(), before);
  expect_saved(world);
  run_for(world, kStep, kStep);
  expect_at(world, id, then.after(at_change, kStep));
  run_for(world, 1 - kStep, kStep);
  expect_at(world, id, then.after(at_change, 1));
  expect_saved(world);
}

TEST(ClosedFormLaw, goes_on_in_another_environment) {
  for (const DragModel drag : kDrags) {
    const double rate = rate_of(drag);
    for (const Vec3d& wind : {Vec3d{}, Vec3d{8, 0, -3}}) {
      Environment moon{.gravity = {.acceleration = 1.62}, .wind = {.velocity = wind}};
      expect_pieces(drag, {kG, rate, {}}, {1.62, rate, wind},
                    [&](World& world, ProjectileId) { EXPECT_TRUE(world.set_environment(0, moon)); });
    }
  }
}

TEST(ClosedFormLaw, goes_on_where_gravity_ends) {
  for (const DragModel drag : kDrags) {
    const double rate = rate_of(drag);
    Environment none{.gravity = {.model = GravityModel::off}};
    expect_pieces(drag, {kG, rate, {}}, {0, rate, {}},
                  [&](World& world, ProjectileId) { EXPECT_TRUE(world.set_environment(0, none)); });
  }
}

TEST(ClosedFormLaw, goes_on_in_the_wind_of_another_rung) {
  for (const DragModel drag : kDrags) {
    const double rate = rate_of(drag);
    Environment windy{.wind = {.velocity = {8, 0, -3}}};
    const auto change = [&](World& world, ProjectileId id) {
      EXPECT_TRUE(world.set_environment(0, windy));  // it does not feel this one
      EXPECT_TRUE(world[id].set_fidelity(seed(drag).fidelity));
    };
    expect_pieces(drag, {kG, rate, {}}, {kG, rate, windy.wind.velocity}, change, WindModel::off);
  }
}

TEST(ClosedFormLaw, goes_on_with_the_drag_and_gravity_of_another_rung) {
  for (const DragModel from : kDrags) {
    for (const DragModel to : kDrags) {
      Fidelity rung = seed(to).fidelity;
      expect_pieces(from, {kG, rate_of(from), {}}, {kG, rate_of(to), {}},
                    [&](World& world, ProjectileId id) { EXPECT_TRUE(world[id].set_fidelity(rung)); });
      rung.gravity = GravityModel::off;
      expect_pieces(from, {kG, rate_of(from), {}}, {0, rate_of(to), {}},
                    [&](World& world, ProjectileId id) { EXPECT_TRUE(world[id].set_fidelity(rung)); });
    }
  }
}

TEST(ClosedFormLaw, an_environment_that_changes_nothing_of_it_leaves_its_bits) {
  World world, other;
  const ProjectileId id = *world.spawn(seed(DragModel::damping), kThrow);
  other.spawn(seed(DragModel::damping), kThrow);
  Environment thin{.altitude = 3000};
  for (World* w : {&world, &other}) run_for(*w, 0.5, kStep);
  EXPECT_TRUE(world.set_environment(0, thin));
  for (World* w : {&world, &other}) run_for(*w, 0.5, kStep);
  EXPECT_EQ(world[id].state(), other[other.ids()[0]].state());
}

TEST(ClosedFormLaw, starts_anew_where_it_stood_still) {
  for (const DragModel drag : kDrags) {
    const Law law{kG, rate_of(drag), {}};
    for (const bool sleeps : {true, false}) {
      World world;
      const ProjectileId id = *world.spawn(seed(drag), kThrow);
      run_for(world, 1, kStep);
      EXPECT_TRUE(sleeps ? world[id].sleep() : world[id].set_kinematic(true));
      run_for(world, 3, kStep);
      EXPECT_TRUE(sleeps ? world[id].wake() : world[id].set_kinematic(false));
      const BodyState from = world[id].state();
      expect_saved(world);
      run_for(world, 1, kStep);
      expect_at(world, id, law.after(from, 1));
    }
  }
}

}  // namespace physim::world_closed_form_law_test
