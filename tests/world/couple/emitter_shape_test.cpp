// Emitters of a world that fire out of meshes and terrain: where, and that saves hold each shape once.
#include "scene_support.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_emitter_shape_test {

/// A grid of triangles over the floor, one side by one, wavy.
MeshShape waves(std::uint32_t side) {
  MeshShape mesh;
  for (std::uint32_t i = 0; i <= side; ++i)
    for (std::uint32_t j = 0; j <= side; ++j) {
      const double x = double(i) / side, z = double(j) / side;
      mesh.vertices.push_back({x, 0.1 * x * z + 0.05 * x * x, z});
    }
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t a = i * (side + 1) + j, b = a + 1, c = a + side + 1, d = c + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({b, d, c});
    }
  return mesh;
}

EmitterDef steam(KindId kind, const SharedShape& shape) {
  return {.kind = kind,
          .position = {5, 2, 1},
          .per_second = {200},
          .from = {.shape = EmitShape::mesh, .surface = {.shape = shape, .along = EmitAlong::smooth}},
          .start = {.lifetime = {0.5}, .speed = {2}}};
}

TEST(EmitterShape, particles_come_out_of_a_mesh_as_it_stands) {
  World world;
  EmitterDef def = steam(kind_of(world, spark()), SharedShape::make(waves(8)).value());
  def.rotation = {0.7071067811865476, 0, 0, 0.7071067811865476};  // its x axis is up
  def.start.speed = {0};
  def.start.gravity = {0};
  def.from.surface.scale = 2;
  const EmitterId id = added(world, def);
  ASSERT_TRUE(world.step(0.25));
  const auto all = alive(world, id);
  ASSERT_GE(all.size(), 49u);
  for (const auto& [number, at] : all) {
    const Vec3d own = rotate(conjugate(def.rotation), at.position - def.position) * 0.5;
    EXPECT_NEAR(own.y, 0.1 * own.x * own.z + 0.05 * own.x * own.x, 2e-3) << number;
    EXPECT_TRUE(own.x >= 0 && own.x <= 1 && own.z >= 0 && own.z <= 1) << number;
  }
}

TEST(EmitterShape, births_do_not_depend_on_frames) {
  std::map<std::uint64_t, BodyState> first;
  for (const int rate : kFrameRates) {
    World world;
    const EmitterId id = added(world, steam(kind_of(world, spark()), SharedShape::make(waves(8)).value()));
    step_to(world, 1, rate);
    const auto all = alive(world, id);
    if (first.empty()) first = all;
    ASSERT_EQ(all.size(), first.size()) << rate;
    for (const auto& [number, at] : all) EXPECT_TRUE(test::near(at.position, first.at(number).position, 1e-12)) << rate;
  }
}

TEST(EmitterShape, a_save_holds_a_shape_once) {
  const MeshShape mesh = waves(40);
  const auto bytes_with = [&](int emitters, bool is_shared) {
    World world;
    const KindId kind = kind_of(world, spark());
    const SharedShape one = SharedShape::make(mesh).value();
    for (int i = 0; i < emitters; ++i) added(world, steam(kind, is_shared ? one : SharedShape::make(mesh).value()));
    return world.save().value().size();
  };
  const std::size_t one = bytes_with(1, true), shape = SharedShape::make(mesh).value().save().size();
  EXPECT_GT(one, shape);
  EXPECT_LT(bytes_with(5, true), one + shape / 2);
  EXPECT_EQ(bytes_with(5, false), bytes_with(5, true));  // by what it is
}

TEST(EmitterShape, saves_and_snapshots_go_on_bit_for_bit) {
  World world;
  const KindId kind = kind_of(world, spark());
  const SharedShape shape = SharedShape::make(waves(10)).value();
  HeightFieldShape hill{3, 3, 1, 1, {0, 0, 0, 0, 1, 0, 0, 0, 0}};
  EmitterDef dust = steam(kind, SharedShape::make(hill).value());
  dust.from.shape = EmitShape::terrain;
  dust.from.surface.low_x = 0.5;
  for (const EmitterDef& def : {steam(kind, shape), steam(kind, shape), dust}) added(world, def);
  step_to(world, 0.3, 60);
  const auto save = must(world.save());
  auto loaded = must(World::load(save));
  const auto ids = loaded.emitters();
  EXPECT_EQ(loaded.emitter(ids[0])->from.surface.shape.content(), loaded.emitter(ids[1])->from.surface.shape.content());
  const Snapshot snapshot = world.snapshot();
  step_to(world, 0.8, 60);
  step_to(loaded, 0.8, 60);
  EXPECT_EQ(loaded.hash(), world.hash());
  EXPECT_EQ(*loaded.save(), *world.save());
  const std::uint64_t then = world.hash();
  ASSERT_TRUE(world.restore(snapshot));
  step_to(world, 0.8, 60);
  EXPECT_EQ(world.hash(), then);
}

TEST(EmitterShape, recordings_replay) {
  std::vector<std::byte> bytes;
  World world;
  ASSERT_TRUE(world.record(record_into(bytes), {.hash_every = 1}));
  const KindId kind = kind_of(world, spark());
  const SharedShape shape = SharedShape::make(waves(10)).value();
  added(world, steam(kind, shape));
  EmitterDef edges = steam(kind, shape);
  edges.from.shape = EmitShape::mesh_edges;
  added(world, edges);
  step_to(world, 0.5, 60);
  const ReplayReport report = replayed(world, bytes);
  EXPECT_GT(report.hashes, 20u);
}

TEST(EmitterShape, the_hash_tells_shapes_apart) {
  const auto hash_with = [](const SharedShape& shape, double scale) {
    World world;
    EmitterDef def = steam(kind_of(world, spark()), shape);
    def.from.surface.scale = scale;
    added(world, def);
    return world.hash();
  };
  const SharedShape one = SharedShape::make(waves(3)).value();
  EXPECT_EQ(hash_with(one, 1), hash_with(SharedShape::make(waves(3)).value(), 1));
  EXPECT_NE(hash_with(one, 1), hash_with(SharedShape::make(waves(4)).value(), 1));
  EXPECT_NE(hash_with(one, 1), hash_with(one, 2));
}

TEST(EmitterShape, a_damaged_shape_in_a_save_is_refused) {
  World world;
  added(world, steam(kind_of(world, spark()), SharedShape::make(waves(3)).value()));
  const auto save = world.save().value();
  for (std::size_t i = 20; i < save.size(); i += 97) {
    auto damaged = save;
    damaged[i] ^= std::byte{0x40};
    EXPECT_FALSE(World::load(damaged)) << i;
  }
}

}  // namespace physim::world_emitter_shape_test
