// Flights at thin things and past them: each that is aimed at one is stopped by it, and no other one is.
#include <cstdio>
#include <string>

#include "collide/scene_support.hpp"
#include "hits/hits.hpp"
#include "math/quat.hpp"

namespace physim::test {
namespace {

constexpr int kMostTold = 20;
constexpr double kSpeeds[] = {5, 10, 30, 100, 300, 900, 8000};
constexpr double kRadii[] = {0, 0.01, 0.1, 0.5};
constexpr double kWallSpeed = 50;

/// Two metres square about its origin, across y.
enum class Sheet { mesh, field, box, moving_box };
constexpr Sheet kSheets[] = {Sheet::mesh, Sheet::field, Sheet::box, Sheet::moving_box};
constexpr const char* kSheetNames[] = {"mesh", "height field", "box of 1 mm", "box that moves at 50 m/s"};

ShapeDef shape_of(Sheet sheet) {
  if (sheet == Sheet::mesh) {  // four triangles that meet in the middle
    return MeshShape{.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 0, 0}},
                     .triangles = {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}}};
  }
  if (sheet == Sheet::field) {
    HeightFieldShape field{.columns = 9, .rows = 9, .spacing_x = 0.25, .spacing_z = 0.25};
    field.heights.assign(81, 0);
    return field;
  }
  return BoxShape{{1, 0.0005, 1}};
}

Fidelity closed_form() {
  Fidelity f = Fidelity::game();
  f.motion = Motion::closed_form;
  f.drag = DragModel::off;
  return f;
}
Fidelity rigid_body() {
  Fidelity f = Fidelity::small_arms();
  f.rotation = RotationModel::rigid_body;
  f.body_form = BodyForm::automatic;
  return f;
}

ProjectileDef projectile(const Fidelity& fidelity, Precision precision) {
  ProjectileDef p;
  p.mass = 0.01134;
  p.diameter = 0.00782;
  p.drag.table = DragTable::g7;
  p.drag.ballistic_coefficient = 170;
  p.drag.damping = 0.9;
  p.drag.k1 = 0.001;
  p.drag.k2 = 0.00002;
  p.inertia.moments = {7e-8, 5e-7, 5e-7};
  p.fidelity = fidelity;
  p.fidelity.precision = precision;
  return p;
}

/// A world with one sheet somewhere, and flights at it along its normal.
class Range {
 public:
  Range(Random& r, Sheet sheet, const Fidelity& fidelity, Precision precision)
      : r_(r), sheet_(sheet), def_(projectile(fidelity, precision)) {
    // Gravity pulls along the normal of a sheet that is level; where it is turned there is none.
    is_level_ = r.one_in(2);
    at_.position = random_vector(r, r.one_in(3) ? 0 : r.one_in(2) ? 100 : 1e4);
    // What falls out of the standard atmosphere, which begins there, leaves the world.
    if (std::abs(at_.position.y + 5000) < 50) at_.position.y += 100;
    if (!is_level_) at_.rotation = normalized(random_transform(r, 0).rotation);
    frame_ = r.in(1.0 / 240, 1.0 / 30);
    WorldDef world{
        .environment = {.gravity = {.model = GravityModel::constant, .acceleration = is_level_ ? 9.80665 : 0},
                        .atmosphere = {.model = AirModel::isa}},
        .ground = {.mode = GroundMode::none},
        .step = frame_ / 2};
    world_ = std::move(World::create(world).value());
    Scene scene;
    const Vec3d corner = sheet == Sheet::field ? rotate(at_.rotation, Vec3d{-1, 0, -1}) : Vec3d{};
    InstanceDef thing{.shape = scene.add_shape(shape_of(sheet)).value(),
                      .transform = {.position = at_.position + corner, .rotation = at_.rotation}};
    if (sheet == Sheet::moving_box) thing.motion = SteadyMotion{.velocity = normal() * kWallSpeed};
    if (!scene.add(thing) || !world_.set_scene(scene)) std::puts("no scene");
  }

  /// Tries a few of each speed and radius; how many were wrong.
  long fly(int count) {
    for (int i = 0; i < count; ++i) launch(kSpeeds[r_.below(7)], kRadii[r_.below(4)], i % 2 == 0);
    for (double time = 0; time < 0.8; time += frame_) {
      if (r_.one_in(2))
        static_cast<void>(world_.step(frame_));
      else
        world_.advance(frame_);
    }
    long wrong = 0;
    for (const Shot& shot : shots_) {
      const bool is_stopped = world_[shot.id].status() == LifeStatus::landed;
      if (is_stopped == shot.is_aimed) continue;
      ++wrong;
      std::printf("%s at (%g, %g, %g), frames of %g s: %s at %g m/s, radius %g, from (%g, %g, %g)\n",
                  kSheetNames[static_cast<int>(sheet_)], at_.position.x, at_.position.y, at_.position.z, frame_,
                  shot.is_aimed ? "went through" : "was hit that is not there", shot.speed, shot.radius, shot.from.x,
                  shot.from.y, shot.from.z);
    }
    return wrong;
  }

 private:
  struct Shot {
    ProjectileId id;
    bool is_aimed;
    double speed, radius;
    Vec3d from;  // in the frame of the sheet
  };
  [[nodiscard]] Vec3d normal() const { return rotate(at_.rotation, Vec3d{0, 1, 0}); }

  void launch(double speed, double radius, bool is_aimed) {
    // From above it falls faster; from below it has to get there. A wall that moves comes to meet it, from above.
    const double side = sheet_ == Sheet::moving_box || r_.one_in(2) ? 1 : -1;
    const double reach = is_level_ && side < 0 ? 0.4 * speed * speed / 9.80665 : 3;
    const double far = radius + r_.in(0.05, std::min(2.0, 0.2 * speed + 0.05));
    if (far > reach) return;
    const auto within = [&] { return r_.one_in(5) ? 0 : r_.in(-0.98, 0.98); };
    Vec3d from = is_aimed ? Vec3d{within(), 0, within()} : Vec3d{r_.in(1.02, 2) + radius, 0, within()};
    if (!is_aimed && r_.one_in(2)) from = {-from.x, 0, from.z};
    from.y = side * far;
    BodyDef body{.collision = {.radius = radius}};
    Launch launch{.position = at_.position + rotate(at_.rotation, from), .velocity = normal() * (-side * speed)};
    shots_.push_back({world_.spawn(def_, launch, body).value(), is_aimed, speed, radius, from});
  }

  Random& r_;
  Sheet sheet_;
  ProjectileDef def_;
  Transform at_;
  bool is_level_ = true;
  double frame_ = 0;
  World world_;
  std::vector<Shot> shots_;

 public:
  [[nodiscard]] long aimed() const { return std::ranges::count(shots_, true, &Shot::is_aimed); }
  [[nodiscard]] long beside() const { return static_cast<long>(shots_.size()) - aimed(); }
};

}  // namespace

long wrong_impacts(long count, long seed) {
  struct Rung {
    const char* name;
    Fidelity fidelity;
  };
  const Rung rungs[] = {{"closed_form", closed_form()},
                        {"game", Fidelity::game()},
                        {"constant_air", Fidelity::constant_air()},
                        {"small_arms", Fidelity::small_arms()},
                        {"rigid_body", rigid_body()}};
  constexpr int kFlights = 200;  // of a world
  Random r(static_cast<std::uint64_t>(seed));
  long wrong = 0;
  for (const Rung& rung : rungs)
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      long aimed = 0, beside = 0, wrong_here = 0;
      for (long i = 0; aimed < (count + 9) / 10; ++i) {
        Range range(r, kSheets[i % 4], rung.fidelity, precision);
        wrong_here += range.fly(kFlights);
        aimed += range.aimed(), beside += range.beside();
      }
      std::printf("%-11s %s: %ld flights at thin things, %ld past them, %ld wrong\n", rung.name,
                  precision == Precision::float32 ? "float32" : "float64", aimed, beside, wrong_here);
      wrong += wrong_here;
    }
  return wrong;
}

}  // namespace physim::test
