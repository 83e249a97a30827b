// Things, terrain and notes of scenarios that users reported, with right values by closed forms.
#include <fstream>
#include <numbers>
#include <sstream>

#include "physim/scenario.hpp"
#include "scenario/mesh_text.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"
#include "support.hpp"

namespace physim::scenario_cases_scene_test {

constexpr double kDegree = std::numbers::pi / 180;

std::string written(const std::string& name, const std::string& text) {
  std::string file = testing::TempDir() + name;
  std::ofstream(file) << text;
  return file;
}

/// What a bounce with friction takes is that of its speed less what spin took up: 0.949 J less the work on the spin of
/// a ball with I = 0.6 m r^2, which the impulse along the floor turns by r x J / I.
TEST(CasesOfScenes, a_bounce_tells_what_it_takes_of_speed_and_spin) {
  const auto scenario = parse_scenario(R"(physim = 1
[environment]
gravity = { model = "constant", acceleration = "9.80665 m/s^2" }
[[material]]
name = "floor"
restitution = 0.8
friction = 0.5
grip_restitution = 0.3
[[shape]]
name = "plane"
kind = "plane"
[[thing]]
shape = "plane"
material = "floor"
[[shot]]
mass = "60 g"
diameter = "60 mm"
drag = { coefficient = 1e-9 }
magnus = { lift = 1e-9 }
position = [0, "1.03 m", 0]
velocity = ["5 m/s", 0, "1 m/s"]
spin = { backspin = "100 rad/s", sidespin = "30 rad/s", gyrospin = "20 rad/s" }
fidelity = { preset = "simulation", rotation = "magnus", earth = "flat", gravity = "constant" }
body = { restitution = 1, friction = 1, collision = { on_hit = "bounce", radius = "30 mm", inertia = 0.6 } }
[until]
ground = "off"
time = "0.5 s"
)",
                                       "f.toml");
  ASSERT_TRUE(scenario) << scenario.error().text();
  const SceneParts parts = scene_parts(*scenario).value();
  const Flight flight = fly_shot(*scenario, scenario->shots[0], parts.scene);
  const auto bounces = test::of_kind(flight, EventKind::bounced);
  ASSERT_EQ(bounces.size(), 1u);
  const double fall = std::sqrt(2 * 9.80665), r = 0.03, inertia = 0.6 * 0.06 * r * r;
  const Vec3d before{5, -fall, 1}, after = bounces[0].velocity, change = after - before;
  EXPECT_NEAR(after.y, 0.8 * fall, 1e-7);
  const double bore = std::atan2(1, 5);  // the bore is turned to the right: backspin is about (-sin, 0, cos)
  const Vec3d spin = Vec3d{-std::sin(bore), 0, std::cos(bore)} * 100 + Vec3d{std::cos(bore), 0, std::sin(bore)} * 20;
  const Vec3d turned = spin + Vec3d{-change.z, 0, change.x} * (0.06 * r / inertia);
  const double of_speed = 0.03 * (length_squared(before) - length_squared(after));
  EXPECT_NEAR(of_speed, 0.949, 1e-3);
  EXPECT_NEAR(bounces[0].energy, of_speed + inertia / 2 * (length_squared(spin) - length_squared(turned)), 1e-7);
}

/// A board of 20 mm that stands 500 km from the origin of its file, where numbers of float32 are 31 mm apart. Right: it
/// is as thick as the file says, whichever text format has it.
TEST(CasesOfMeshes, a_board_far_from_the_origin_is_as_thick_as_its_file_says) {
  if (!reads_mesh_files()) GTEST_SKIP() << "this build reads no meshes from files";
  constexpr double kNear = 500000.003, kFar = 500000.023;
  std::ostringstream corners, obj, stl;
  corners.precision(12);
  for (const double x : {kNear, kFar})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) corners << x << ' ' << y << ' ' << z << '\n';
  std::vector<std::string> corner;
  std::istringstream lines(corners.str());
  for (std::string line; std::getline(lines, line);) corner.push_back(line);
  constexpr int kTriangles[][3] = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                                   {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 12\nproperty list uchar int vertex_indices\nend_header\n" +
      corners.str();
  for (const std::string& line : corner) obj << "v " << line << '\n';
  stl << "solid board\n";
  for (const auto& [a, b, c] : kTriangles) {
    obj << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    ply += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
    stl << "facet normal 0 0 0\nouter loop\n";
    for (const int i : {a, b, c}) stl << "vertex " << corner[static_cast<std::size_t>(i)] << '\n';
    stl << "endloop\nendfacet\n";
  }
  stl << "endsolid board\n";
  const std::string files[] = {written("board.obj", obj.str()), written("board.ply", ply),
                               written("board.stl", stl.str())};
  for (const std::string& file : files) {
    const auto mesh = must(read_mesh_file(file));
    Scene scene;
    add_thing(scene, mesh);
    const auto hits = scene.all_hits({{499990, 0.1, 0.2}, {500010, 0.1, 0.2}, 0, 0, 0});
    ASSERT_EQ(hits.size(), 2u) << file;
    EXPECT_NEAR(hits[0].position.x, kNear, 1e-9) << file;
    EXPECT_NEAR(hits[1].position.x, kFar, 1e-9) << file;
  }
}

TEST(NumberedMesh, a_ply_that_names_an_axis_twice_is_left_as_it_is) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float z\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_FALSE(numbered_mesh(ply));
}

/// Heights in grads from Paris (EPSG 4807, NTF). Right: 51 grads north and 5 grads east of Paris, at 45.9 and 6.83723
/// degrees of NTF, lie at 45.899984 N 6.836719 E in WGS 84, by the shift of EPSG 1193 (-168, -60, 320 m).
TEST(CasesOfTerrain, grads_from_paris_are_brought_to_wgs84) {
  if (!reads_terrain_files()) GTEST_SKIP() << "built without GDAL";
  constexpr int kSide = 41;
  constexpr double kStep = 0.001;  // [grad]
  std::ostringstream grid;
  grid.precision(12);
  grid << "ncols " << kSide << "\nnrows " << kSide << "\nxllcenter " << 5 - 20 * kStep << "\nyllcenter "
       << 51 - 20 * kStep << "\ncellsize " << kStep << '\n';
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      grid << 1000 + 10 * (20 - row) + 20 * (column - 20) << (column + 1 < kSide ? ' ' : '\n');
  const std::string file = written("paris.asc", grid.str());
  written("paris.prj",
          "GEOGCS[\"NTF (Paris)\",DATUM[\"Nouvelle_Triangulation_Francaise_Paris\",SPHEROID[\"Clarke 1880 (IGN)\","
          "6378249.2,293.4660212936269,AUTHORITY[\"EPSG\",\"7011\"]],AUTHORITY[\"EPSG\",\"6807\"]],"
          "PRIMEM[\"Paris\",2.33722917,AUTHORITY[\"EPSG\",\"8903\"]],UNIT[\"grad\",0.01570796326794897,"
          "AUTHORITY[\"EPSG\",\"9105\"]],AUTHORITY[\"EPSG\",\"4807\"]]");
  constexpr double kNorth = 45.899984087, kEast = 6.836719229;
  const auto terrain =
      must(read_terrain_file(file, {.latitude = kNorth * kDegree, .longitude = kEast * kDegree, .reach = 500}));
  ASSERT_GT(terrain.heights.size(), 16u);
  for (std::uint32_t row = 0; row < terrain.rows; ++row)
    for (std::uint32_t column = 0; column < terrain.columns; ++column) {
      const double north = (terrain.latitude + row * terrain.latitude_step) / kDegree - kNorth;
      const double east = (terrain.longitude + column * terrain.longitude_step) / kDegree - kEast;
      // A step of a thousandth of a grad, 100 m to the north, is 0.0009 degrees and 10 m high.
      EXPECT_NEAR(terrain.heights[std::size_t{row} * terrain.columns + column],
                  1000 + (10 * north + 20 * east) / (0.9 * kStep), 1)
          << row << ' ' << column;
    }
}

/// An aerodynamic jump is flown with spin drift alone; asked for beside rotation "none" it is told with its place.
TEST(CasesOfNotes, a_jump_without_spin_drift_is_told) {
  const auto notes = [](const std::string& rotation) {
    return must(parse_scenario(
                    "physim = 1\n[environment]\nwind = { velocity = [0, 0, 10] }\n[[shot]]\nmass = \"140 gr\"\n"
                    "diameter = \"0.264 in\"\nlength = \"1.35 in\"\ntwist = \"8 in\"\nspeed = \"2710 ft/s\"\n"
                    "drag = { table = \"g7\", ballistic_coefficient = \"0.315 lb/in^2\" }\n"
                    "fidelity = { preset = \"small_arms\", rotation = \"" +
                        rotation + "\", aerodynamic_jump = true }\n",
                    "f.toml"))
        .notes;
  };
  const auto tells = [](const std::vector<std::string>& all) {
    return std::ranges::any_of(all, [](const std::string& note) {
      return note.starts_with("f.toml:11:") &&
             note.find("shot.fidelity.aerodynamic_jump: has no effect") != std::string::npos;
    });
  };
  EXPECT_TRUE(tells(notes("none")));
  EXPECT_FALSE(tells(notes("spin_drift")));
}

}  // namespace physim::scenario_cases_scene_test
