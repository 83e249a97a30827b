// Generators that make no sense are refused with a place and a message.
#include <functional>

#include "support.hpp"
#include "world/step/force_eval.hpp"

namespace physim::world_force_check_test {

using test::kInfinity;
using test::kNan;

const ProjectileId kSomebody{3, 1}, kOther{4, 1};

ForceDef on_somebody(ForceLaw law) { return {std::move(law), {{kSomebody}, {}, 0}}; }

const std::vector<std::pair<const char*, ForceLaw>>& good_laws() {
  static const std::vector<std::pair<const char*, ForceLaw>> laws{
      {"constant", ConstantForce{{1, 2, 3}}},
      {"acceleration", ConstantAcceleration{}},
      {"gravity", GravityForce{}},
      {"drag", LinearQuadraticDragForce{.k1 = 1}},
      {"anchored spring", AnchoredSpring{}},
      {"spring", Spring{kOther}},
      {"bungee", Bungee{kOther}},
      {"anchored bungee", Bungee{.anchor = {0, 5, 0}, .stiffness = 0, .damping = 3}},
      {"buoyancy", Buoyancy{}},
      {"attractor", PointAttractor{.strength = -1}},
      {"wind zone", WindZone{.low = {-1, -kInfinity, -1}, .high = {1, kInfinity, 1}}},
      {"explosion", Explosion{.force = -5}},
      {"thrust", Thrust{.curve = {{0, 5}, {1, -5}}, .direction = {0, 7, 0}}},
      {"custom", CustomForce{[](const ForceBatch&) {}}}};
  return laws;
}

TEST(ForceCheck, good_generators_pass) {
  for (const auto& [what, law] : good_laws()) {
    const Status status = check(on_somebody(law));
    EXPECT_TRUE(status) << what << ": " << status.error().text();
  }
  EXPECT_TRUE(check(ForceDef{.law = GravityForce{}, .target = ForceTarget::everything()}));
  EXPECT_TRUE(check(ForceDef{.law = GravityForce{}, .target = {.kind = {1}}, .delay = 2, .duration = 0.5}));
}

struct BadForce {
  ForceLaw law;
  const char* place;
  const char* message;  // part of it
};

TEST(ForceCheck, bad_laws_are_refused) {
  const Vec3d nan{0, kNan, 0};
  const Vec3d one{1, 1, 1};
  const BadForce bad[] = {{ConstantForce{nan}, "force.force", "finite"},
                          {ConstantAcceleration{nan}, "force.acceleration", "finite"},
                          {GravityForce{{0, -kInfinity, 0}}, "force.gravity", "finite"},
                          {LinearQuadraticDragForce{.k1 = -1}, "force.k1", "zero or positive"},
                          {LinearQuadraticDragForce{.k2 = kNan}, "force.k2", "zero or positive"},
                          {LinearQuadraticDragForce{.wind = nan}, "force.wind", "finite"},
                          {AnchoredSpring{.anchor = nan}, "force.anchor", "finite"},
                          {AnchoredSpring{.stiffness = -1}, "force.stiffness", "zero or positive, not -1"},
                          {AnchoredSpring{.rest_length = -1}, "force.rest_length", "zero or positive"},
                          {AnchoredSpring{.damping = -1}, "force.damping", "zero or positive"},
                          {Spring{}, "force.other", "nobody"},
                          {Spring{kSomebody}, "force.other", "target"},
                          {Spring{.other = kOther, .stiffness = kNan}, "force.stiffness", "zero or positive"},
                          {Spring{.other = kOther, .rest_length = kInfinity}, "force.rest_length", "zero or positive"},
                          {Spring{.other = kOther, .damping = -1}, "force.damping", "zero or positive"},
                          {Bungee{.other = kSomebody}, "force.other", "target"},
                          {Bungee{.anchor = nan}, "force.anchor", "finite"},
                          {Bungee{.stiffness = -2}, "force.stiffness", "zero or positive"},
                          {Buoyancy{.surface = kNan}, "force.surface", "finite"},
                          {Buoyancy{.volume = -1}, "force.volume", "zero or positive"},
                          {Buoyancy{.depth = -1}, "force.depth", "zero or positive"},
                          {Buoyancy{.density = -1}, "force.density", "zero or positive"},
                          {Buoyancy{.damping = -1}, "force.damping", "zero or positive"},
                          {Buoyancy{.gravity = -9.8}, "force.gravity", "zero or positive"},
                          {PointAttractor{.centre = nan}, "force.centre", "finite"},
                          {PointAttractor{.strength = kInfinity}, "force.strength", "finite"},
                          {PointAttractor{.softening = -1}, "force.softening", "zero or positive"},
                          {WindZone{}, "force.low", "below force.high"},
                          {WindZone{.velocity = nan, .high = one}, "force.velocity", "finite"},
                          {WindZone{.low = {0, 2, 0}, .high = one}, "force.low", "below force.high"},
                          {WindZone{.low = nan, .high = one}, "force.low", "below force.high"},
                          {WindZone{.high = one, .density = -1}, "force.density", "zero or positive"},
                          {Explosion{.centre = nan}, "force.centre", "finite"},
                          {Explosion{.force = kNan}, "force.force", "finite"},
                          {Explosion{.radius = 0}, "force.radius", "positive"},
                          {Thrust{}, "force.curve", "two points"},
                          {Thrust{.curve = {{0, 1}}}, "force.curve", "two points"},
                          {Thrust{.curve = {{-1, 1}, {1, 1}}}, "force.curve[0].time", "zero or positive"},
                          {Thrust{.curve = {{0, 1}, {1, kNan}}}, "force.curve[1]", "finite"},
                          {Thrust{.curve = {{0, 1}, {2, 1}, {2, 0}}}, "force.curve[2]", "rise"},
                          {Thrust{.curve = {{0, 1}, {2, 1}}, .direction = nan}, "force.direction", "finite"},
                          {CustomForce{}, "force.function", "empty"}};
  for (const BadForce& b : bad) {
    const Status status = check(on_somebody(b.law));
    ASSERT_FALSE(status) << b.place << ": " << b.message;
    EXPECT_EQ(status.error().place, b.place) << status.error().text();
    EXPECT_NE(status.error().message.find(b.message), std::string::npos) << status.error().text();
  }
}

TEST(ForceCheck, bad_targets_and_times_are_refused) {
  const struct {
    const char* place;
    std::function<void(ForceDef&)> spoil;
  } bad[] = {{"force.target", [](ForceDef& f) { f.target = {}; }},
             {"force.target.ids[1]", [](ForceDef& f) { f.target.ids.push_back({}); }},
             {"force.delay", [](ForceDef& f) { f.delay = -1; }},
             {"force.delay", [](ForceDef& f) { f.delay = kInfinity; }},
             {"force.duration", [](ForceDef& f) { f.duration = -1; }},
             {"force.duration", [](ForceDef& f) { f.duration = 0; }},
             {"force.duration", [](ForceDef& f) { f.duration = kNan; }}};
  for (const auto& b : bad) {
    ForceDef force = on_somebody(GravityForce{});
    b.spoil(force);
    const Status status = check(force);
    ASSERT_FALSE(status) << b.place;
    EXPECT_EQ(status.error().place, b.place) << status.error().text();
  }
}

}  // namespace physim::world_force_check_test
