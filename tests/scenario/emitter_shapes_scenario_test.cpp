// Emitters of scenario files: meshes, terrain, rain and trails.
#include "base/archive.hpp"
#include "cli/program.hpp"
#include "physim/scenario.hpp"
#include "scenario/revise.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_emitter_shapes_scenario_test {

const std::string kHillScenario = R"(physim = 1
[[shot]]
name = "puff"
body = { use_gravity = false }
fidelity = "arcade"
[[shape]]
name = "hill"
height_field = { columns = 3, rows = 3, spacing_x = "10 m", spacing_z = "5 m", heights = [0, 1, 0, 0, 5, 0, 0, 1, 0] }
[[shape]]
name = "wedge"
mesh = { vertices = [[0, 0, 0], [1, 0, 0], [0, 0, 1], [0, 1, 0]], triangles = [[0, 3, 1], [0, 2, 3]] }
[[emitter]]
name = "dust"
shot = "puff"
from = { shape = "terrain", surface = { of = "hill", along = "smooth", high_x = "10 m", low_z = "2 m" } }
per_second = 200
trail = { points = 12, time = "2 s", distance = "5 cm" }
[[emitter]]
name = "steam"
shot = "puff"
from = { shape = "mesh_edges", surface = "wedge" }
[[emitter]]
name = "more"
shot = "puff"
from = { shape = "mesh", surface = { of = "wedge", scale = 2 } }
[[emitter]]
name = "snow"
shot = "puff"
per_second = 0
rotation = { pitch = "-90 deg" }
start = { lifetime = "inf", speed = "1 m/s" }
rain = { density = 2, size = ["4 m", "5 m", "6 m"], drift = ["1 m/s", 0, 0], shelter = "20 m" }
[world]
duration = "1 s"
[world.ground]
mode = "none"
)";

TEST(EmitterShapesScenario, are_read) {
  const Scenario read = must(parse_scenario(kHillScenario, "f.toml"));
  const EmitSurface& dust = read.emitters[0].def.from.surface;
  EXPECT_EQ(read.emitters[0].def.from.shape, EmitShape::terrain);
  EXPECT_EQ(std::get<HeightFieldShape>(dust.shape.definition()).heights[4], 5);
  EXPECT_EQ(dust.along, EmitAlong::smooth);
  EXPECT_TRUE(dust.high_x == 10 && dust.low_z == 2 && dust.low_x == -kInfinity && dust.high_z == kInfinity);
  EXPECT_EQ(read.emitters[0].def.trail, (TrailDef{12, 2, 0.05}));
  EXPECT_EQ(read.emitters[1].def.from.shape, EmitShape::mesh_edges);
  EXPECT_EQ(read.emitters[2].def.from.surface.scale, 2);
  EXPECT_EQ(read.emitters[1].def.from.surface.shape.content(), read.emitters[2].def.from.surface.shape.content());
  EXPECT_EQ(read.emitters[3].def.rain, (RainDef{2, {4, 5, 6}, {1, 0, 0}, 20}));
}

TEST(EmitterShapesScenario, are_written_as_they_were_read) {
  const Scenario before = parse_scenario(kHillScenario, "f.toml").value();
  const std::string text = scenario_text(before);
  const Scenario after = must(parse_scenario(text, "f.toml"), text);
  EXPECT_TRUE(say_the_same(after, before)) << text;
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(hash_of(after.emitters[i]), hash_of(before.emitters[i])) << text;
}

TEST(EmitterShapesScenario, fly_in_a_run) {
  auto run = must(WorldRun::create(parse_scenario(kHillScenario, "f.toml").value()));
  for (std::uint64_t i = 0; i < run.steps(); ++i) run.step();
  const World& world = run.world();
  const auto ids = world.emitters();
  ASSERT_EQ(ids.size(), 4u);
  EXPECT_EQ(world.emitter_counts(ids[0]).born, 200u);
  EXPECT_GT(world.trails(ids[0], {}).places, 200u);
  EXPECT_NEAR(double(world.particles(ids[3], {})), 240, 50);
}

std::string error_of(const std::string& rest) {
  const Result<Scenario> read = parse_scenario("physim = 1\n[[shot]]\n[world]\n" + rest, "f.toml");
  return read ? "none" : read.error().text();
}

TEST(EmitterShapesScenario, what_is_wrong_is_said_where_it_stands) {
  const std::string emitter = "[[emitter]]\nshot = \"shot-1\"\n";
  EXPECT_EQ(error_of(emitter + "from = { shape = \"mesh\", surface = \"rock\" }\n"),
            "f.toml:6:36: error: emitter.from.surface.of: no shape is named \"rock\"; write a [[shape]]");
  EXPECT_EQ(error_of(emitter + "from = { shape = \"mesh\" }\n"),
            "f.toml:6:8: error: emitter.from.surface: there is none, and the shape needs one; name a [[shape]] with a "
            "mesh or a height field: surface = \"...\", or a file of a mesh");
  EXPECT_EQ(error_of(emitter + "from = { shape = \"mesh\", surface = { file = \"none.obj\" } }\n"),
            reads_mesh_files()
                ? "f.toml:6:45: error: emitter.from.surface.file: there is no such file"
                : "f.toml:6:45: error: emitter.from.surface.file: this build reads no meshes from files; build it with "
                  "Assimp (libassimp-dev), or write vertices and triangles into the scenario");
  EXPECT_NE(error_of(emitter + "from = { shape = \"mesh\", surface = { of = \"a\", file = \"b.obj\" } }\n")
                .find("given together with file"),
            std::string::npos);
  EXPECT_NE(error_of(emitter + "from = { shape = \"terrain\", surface = { file = \"b.png\" } }\n")
                .find("write a [[shape]] with height_field.file"),
            std::string::npos);
  const std::string ball = "[[shape]]\nname = \"ball\"\nsphere = \"1 m\"\n";
  EXPECT_NE(error_of(ball + emitter + "from = { shape = \"mesh\", surface = \"ball\" }\n")
                .find("is neither a mesh nor a height field"),
            std::string::npos);
  const std::string flat =
      "[[shape]]\nname = \"flat\"\nmesh = { vertices = [[0, 0, 0], [1, 0, 0], [2, 0, 0]], triangles = [[0, 1, 2]] }\n";
  EXPECT_NE(error_of(flat + emitter + "from = { shape = \"mesh\", surface = \"flat\" }\n")
                .find("has no triangle with an area"),
            std::string::npos);
  EXPECT_NE(error_of(emitter + "rain = { density = 1e9 }\n").find("emitter.rain.density: puts 8e+12 particles"),
            std::string::npos);
}

TEST(EmitterShapesScenario, a_mesh_comes_out_of_a_file) {
  if (!reads_mesh_files()) GTEST_SKIP() << "built without Assimp";
  const testing_cli::Folder folder;
  std::ofstream(folder / "cube.obj") << "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\n"
                                        "v -1 1 1\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const std::string emitter =
      "[[emitter]]\nshot = \"shot-1\"\nfrom = { shape = \"mesh\", surface = { file = \"cube.obj\" } }\n";
  const auto read = must(parse_scenario("physim = 1\n[[shot]]\n[world]\n" + emitter + emitter, folder / "f.toml"));
  const SharedShape &one = read.emitters[0].def.from.surface.shape, &two = read.emitters[1].def.from.surface.shape;
  EXPECT_EQ(one.content(), two.content());
  EXPECT_EQ(std::get<MeshShape>(one.definition()).triangles.size(), 12u);
  EXPECT_NE(scenario_text(read).find("file = \"cube.obj\""), std::string::npos);
}

}  // namespace physim::scenario_emitter_shapes_scenario_test
