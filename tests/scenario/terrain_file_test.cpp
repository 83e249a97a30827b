// Terrain out of files: SRTM and GeoTIFF that the test writes, in latitude and longitude and in another projection.
#include "physim/scenario.hpp"

#include <bit>
#include <cmath>
#include <functional>

#include "cli/program.hpp"
#include "physim/environment.hpp"
#include "scenario/scenario.hpp"

namespace physim::scenario_terrain_file_test {

constexpr double kDegree = 3.141592653589793 / 180;

std::string in_folder(const std::string& name) {
  static const testing_cli::Folder folder;
  return folder / name;
}

/// A tile of SRTM, 46 to 47 degrees north and 7 to 8 east: 1201 rows from the north on, two bytes each, high one first.
std::string tile(const std::function<int(int row, int column)>& height) {
  constexpr int kPoints = 1201;
  std::string bytes;
  for (int row = 0; row < kPoints; ++row)
    for (int column = 0; column < kPoints; ++column) {
      const int h = height(row, column);
      bytes += static_cast<char>(h >> 8 & 0xff);
      bytes += static_cast<char>(h & 0xff);
    }
  std::string file = in_folder("N46E007.hgt");
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}
constexpr double kTileStep = 1.0 / 1200;  // [degrees]

/// A TIFF of one strip of float32 with the tags of GeoTIFF (OGC 19-008): tag, type, values.
class Tiff {
 public:
  /// `has_alpha`: behind each height stands how opaque the point is, 0 for a point that is not there.
  Tiff(std::uint16_t columns, std::uint16_t rows, std::vector<float> heights, bool has_alpha = false)
      : heights_(std::move(heights)) {
    const std::uint16_t samples = has_alpha ? 2 : 1;
    const std::vector<std::uint16_t> bits(samples, 32), floats(samples, 3);
    shorts(256, {columns}).shorts(257, {rows}).shorts(258, bits).shorts(259, {1}).shorts(262, {1});
    add(273, 4, 1, std::string(4, '\0'));  // where the strip is: filled in at the end
    shorts(277, {samples}).shorts(278, {rows});
    const auto size = static_cast<std::uint32_t>(heights_.size() * sizeof(float));
    add(279, 4, 1, raw(size));
    if (has_alpha) shorts(338, {2});
    shorts(339, floats);
  }
  /// The first point is the middle of a cell at (x, y); columns go by `step` in x and rows by -`step` in y.
  Tiff& lies_at(double x, double y, double step, std::uint16_t model, std::uint16_t key, std::uint16_t epsg) {
    doubles(33550, {step, step, 0}).doubles(33922, {0, 0, 0, x - step / 2, y + step / 2, 0});
    return shorts(34735, {1, 1, 0, 3, 1024, 0, 1, model, 1025, 0, 1, 1, key, 0, 1, epsg});
  }
  /// Its unit, and the number that says that there is nothing.
  Tiff& means(const std::string& unit, const std::string& nothing) {
    text(42112,
         "<GDALMetadata><Item name=\"UNITTYPE\" sample=\"0\" role=\"unittype\">" + unit + "</Item></GDALMetadata>");
    return text(42113, nothing);
  }

  /// It is the mask of the file beside it: of the first band, and all others.
  Tiff& is_mask() { return text(42112, "<GDALMetadata><Item name=\"INTERNAL_MASK_FLAGS_1\">2</Item></GDALMetadata>"); }

  [[nodiscard]] std::string bytes() const {
    std::size_t end = 8 + 2 + entries_.size() * 12 + 4;
    std::string head = "II*" + std::string(1, '\0') + raw(std::uint32_t{8});
    std::string table = raw(static_cast<std::uint16_t>(entries_.size())), rest;
    std::size_t strip = end;
    for (const Entry& entry : entries_) strip += entry.data.size() > 4 ? entry.data.size() : 0;
    for (Entry entry : entries_) {
      if (entry.tag == 273) entry.data = raw(static_cast<std::uint32_t>(strip));
      table += raw(entry.tag) + raw(entry.type) + raw(entry.count);
      if (entry.data.size() <= 4) {
        entry.data.resize(4);
        table += entry.data;
      } else {
        table += raw(static_cast<std::uint32_t>(end));
        rest += entry.data;
        end += entry.data.size();
      }
    }
    std::string all = head + table + raw(std::uint32_t{0}) + rest;
    for (const float h : heights_) all += raw(h);
    return all;
  }

 private:
  struct Entry {
    std::uint16_t tag, type;
    std::uint32_t count;
    std::string data;
  };
  template <class T>
  static std::string raw(T value) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    return {bytes.begin(), bytes.end()};
  }
  template <class T>
  Tiff& list(std::uint16_t tag, std::uint16_t type, const std::vector<T>& values) {
    std::string data;
    for (const T& value : values) data += raw(value);
    return add(tag, type, static_cast<std::uint32_t>(values.size()), data);
  }
  Tiff& shorts(std::uint16_t tag, const std::vector<std::uint16_t>& values) { return list(tag, 3, values); }
  Tiff& doubles(std::uint16_t tag, const std::vector<double>& values) { return list(tag, 12, values); }
  Tiff& text(std::uint16_t tag, const std::string& value) {
    return add(tag, 2, static_cast<std::uint32_t>(value.size()) + 1, value + '\0');
  }
  Tiff& add(std::uint16_t tag, std::uint16_t type, std::uint32_t count, std::string data) {
    entries_.push_back({tag, type, count, std::move(data)});
    return *this;
  }

  std::vector<Entry> entries_{};
  std::vector<float> heights_;
};

std::string written(const std::string& name, const std::string& bytes) {
  std::string file = in_folder(name);
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

class TerrainFile : public testing::Test {
 protected:
  void SetUp() override {
    if (!reads_terrain_files()) GTEST_SKIP() << "built without GDAL";
  }
};

TEST(TerrainFiles, AreReadOrTheBuildSaysThatItCannot) {
  const auto read = read_terrain_file(in_folder("none.hgt"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message,
            reads_terrain_files() ? "there is no such file" : "this build reads no terrain from files");
}

TEST_F(TerrainFile, OfSrtmIsReadPointByPoint) {
  const std::string file = tile([](int row, int column) { return row - 2 * column; });
  const auto all = must(read_terrain_file(file));
  ASSERT_EQ(all.columns, 1201u);
  ASSERT_EQ(all.rows, 1201u);
  EXPECT_NEAR(all.latitude, 46 * kDegree, 1e-12);
  EXPECT_NEAR(all.longitude, 7 * kDegree, 1e-12);
  EXPECT_NEAR(all.latitude_step, kTileStep * kDegree, 1e-15);
  EXPECT_NEAR(all.longitude_step, kTileStep * kDegree, 1e-15);
  for (const int row : {0, 1, 700, 1200})
    for (const int column : {0, 5, 1200})
      EXPECT_EQ(all.heights[std::size_t(row) * 1201 + std::size_t(column)], 1200 - row - 2 * column);
}

TEST_F(TerrainFile, IsCutAboutAPlace) {
  const std::string file = tile([](int row, int column) { return row - 2 * column; });
  const auto part = must(read_terrain_file(
      file, {.latitude = 46.25 * kDegree, .longitude = 7.5 * kDegree, .reach = 2000, .every = 4, .geoid = 50}));
  EXPECT_NEAR(part.latitude_step, 4 * kTileStep * kDegree, 1e-15);
  // 2 km are 0.018 degrees of latitude, 21.6 steps, and 0.026 of longitude, 31.2 steps.
  EXPECT_EQ(part.rows, (22 + 22) / 4 + 1u);
  EXPECT_EQ(part.columns, (32 + 32) / 4 + 1u);
  for (std::uint32_t row = 0; row < part.rows; ++row)
    for (std::uint32_t column = 0; column < part.columns; ++column) {
      const double north = (part.latitude + row * part.latitude_step) / kDegree - 46;
      const double east = (part.longitude + column * part.longitude_step) / kDegree - 7;
      const double expected = 1200 * (1 - north) - 2 * 1200 * east + 50;
      ASSERT_NEAR(part.heights[std::size_t{row} * part.columns + column], expected, 1e-6) << row << " " << column;
    }
  EXPECT_NEAR(part.latitude / kDegree + part.rows / 2 * 4 * kTileStep, 46.25, 4 * kTileStep);
}

TEST_F(TerrainFile, WithHolesWantsAHeightForThem) {
  const std::string file = tile([](int row, int column) { return row == 1000 && column == 3 ? -32768 : 7; });
  EXPECT_EQ(read_terrain_file(file).error().message,
            "has points without a height: row 1001, column 4: latitude 46.166667, longitude 7.002500");
  const auto filled = must(read_terrain_file(file, {.geoid = 40, .missing = -2}));
  EXPECT_EQ(filled.heights[200u * 1201 + 3], 38);
  EXPECT_EQ(filled.heights[200u * 1201 + 4], 47);
}

TEST_F(TerrainFile, KnowsFeet) {
  Tiff tiff(3, 2, {1000, 2000, -9, 4000, 5000, 6000});
  tiff.lies_at(10, 50, 0.5, 2, 2048, 4326).means("ft", "-9");
  const auto grid = must(read_terrain_file(written("feet.tif", tiff.bytes()), {.missing = 0}));
  EXPECT_NEAR(grid.latitude, 49.5 * kDegree, 1e-12);
  EXPECT_NEAR(grid.longitude, 10 * kDegree, 1e-12);
  const std::vector<double> expected = {1219.2, 1524, 1828.8, 304.8, 609.6, 0};
  ASSERT_EQ(grid.heights.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(grid.heights[i], expected[i], 1e-9) << i;
}

TEST_F(TerrainFile, KnowsUnits) {
  const auto height = [](const std::string& unit) {
    Tiff tiff(2, 2, {1000, 1000, 1000, 1000});
    tiff.lies_at(10, 50, 0.5, 2, 2048, 4326).means(unit, "-9");
    const auto grid = read_terrain_file(written("unit.tif", tiff.bytes()));
    return grid ? grid->heights[0] : -1;
  };
  const std::pair<const char*, double> units[] = {{"m", 1000},        {"metre", 1000},
                                                  {"dm", 100},        {"cm", 10},
                                                  {"mm", 1},          {"FT", 304.8},
                                                  {"foot", 304.8},    {"us-ft", 1.2e6 / 3937},
                                                  {"fathom", 1828.8}, {"US survey foot", 1.2e6 / 3937},
                                                  {"yd", 914.4}};
  for (const auto& [unit, metres] : units) EXPECT_NEAR(height(unit), metres, 1e-9) << unit;
  Tiff kilometres(2, 2, {1, 1, 1, 1});
  kilometres.lies_at(10, 50, 0.5, 2, 2048, 4326).means("km", "-9");
  EXPECT_EQ(read_terrain_file(written("unit.tif", kilometres.bytes()))->heights[0], 1000);
  Tiff unknown(2, 2, {1, 1, 1, 1});
  unknown.lies_at(10, 50, 0.5, 2, 2048, 4326).means("furlong", "-9");
  EXPECT_EQ(read_terrain_file(written("unit.tif", unknown.bytes())).error().message,
            "its heights are in \"furlong\", which is no unit of length here");
}

/// The file's number for nothing is rounded in the file, written with fewer digits, or left out.
TEST_F(TerrainFile, HasNoHeightWhereThereIsNone) {
  const std::pair<const char*, float> cases[] = {
      {"-9999.9", -9999.9F}, {"-3.4028e+38", -3.4028235e38F}, {"-9", 32767}, {"-9", -32768}, {"-9", 65535}, {"-9", -9}};
  for (const auto& [nothing, there] : cases) {
    Tiff tiff(2, 2, {100, 200, there, 400});
    tiff.lies_at(10, 50, 0.5, 2, 2048, 4326).means("m", nothing);
    const std::string file = written("nothing.tif", tiff.bytes());
    EXPECT_FALSE(read_terrain_file(file)) << nothing;
    const auto grid = must(read_terrain_file(file, {.missing = 3}));
    EXPECT_EQ(grid.heights, (std::vector<double>{3, 400, 100, 200})) << nothing;
  }
}

/// An ASCII grid of Esri in latitude and longitude, with its projection beside it.
std::string text_grid(const std::string& name, const std::string& head, const std::string& rows) {
  written(name + ".prj",
          "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
          "UNIT[\"degree\",0.0174532925199433]]");
  return written(name + ".asc", "ncols 2\nnrows 2\nxllcenter 10\nyllcenter 46\ncellsize 0.5\n" + head + rows);
}

TEST_F(TerrainFile, OfTextWithWholeNumbersHasItsHoles) {
  const std::string nothing = "NODATA_value -9999\n";
  for (const std::string& file :
       {text_grid("nan", nothing, "100 nan\n300 400\n"), text_grid("nan1", nothing, "100.5 nan\n300 400\n"),
        text_grid("hole", nothing, "100 -9999\n300 400\n"), text_grid("bare", "", "100 -9999\n300 400\n")}) {
    const auto grid = read_terrain_file(file);
    ASSERT_FALSE(grid) << file;
    EXPECT_NE(grid.error().message.find("has points without a height: row 1, column 2"), std::string::npos)
        << grid.error().text();
    const auto filled = must(read_terrain_file(file, {.missing = 7}));
    EXPECT_EQ(filled.heights[3], 7) << file;
    EXPECT_EQ(filled.impossible, 0U) << file;
  }
  const auto other = must(read_terrain_file(text_grid("other", "NODATA_value 0\n", "100 -9999\n300 400\n")),
                          "it says what its number for nothing is");
  EXPECT_EQ(other.heights[3], -9999);
}

/// A height that no ground has is replaced, and a note says so; a void that the file declares needs no word.
TEST_F(TerrainFile, WithImpossibleHeightsIsAskedAbout) {
  Tiff tiff(3, 2, {100, 200, -9, 32767, 500, -32768});
  tiff.lies_at(10, 50, 0.5, 2, 2048, 4326).means("m", "-9");
  const std::string file = written("impossible.tif", tiff.bytes());
  const auto grid = must(read_terrain_file(file, {.missing = 3}));
  EXPECT_EQ(grid.heights, (std::vector<double>{3, 500, 3, 100, 200, 3}));
  EXPECT_EQ(grid.impossible, 2u);
  EXPECT_EQ(grid.impossible_height, 32767);
  Tiff peak(2, 2, {100, 200, 300, 32767});
  peak.lies_at(10, 50, 0.5, 2, 2048, 4326).means("m", "-9");
  EXPECT_EQ(read_terrain_file(written("peak.tif", peak.bytes())).error().message,
            "has points with a height of 32767 m, which no ground has: row 2, column 2: latitude 49.500000, longitude "
            "10.500000");

  const std::string text =
      "physim = 1\nenvironment = { earth = { latitude = \"50 deg\", longitude = \"10.5 deg\" } }\n[[shot]]\n"
      "[[thing]]\nshape = \"hill\"\n[[shape]]\nname = \"hill\"\nmesh = { terrain = \"impossible.tif\", missing = 3 }\n";
  const std::string scenario = in_folder("impossible.toml");
  std::ofstream(scenario) << text;
  const auto read = must(load_scenario(scenario));
  const std::string end =
      "shape.mesh.missing: it replaces a height of 32767 m, which no ground has, and 1 more such "
      "heights";
  EXPECT_TRUE(std::ranges::any_of(read.notes, [&](const std::string& note) { return note.ends_with(end); }));
}

TEST_F(TerrainFile, HasNoHeightWhereItsAlphaBandOrMaskHasNothing) {
  Tiff alpha(2, 2, {100, 255, 200, 255, 300, 0, 400, 255}, true);
  alpha.lies_at(10, 50, 0.5, 2, 2048, 4326);
  const auto with_alpha = must(read_terrain_file(written("alpha.tif", alpha.bytes()), {.missing = 3}));
  EXPECT_EQ(with_alpha.heights, (std::vector<double>{3, 400, 100, 200}));
  Tiff heights(2, 2, {100, 200, 300, 400}), mask(2, 2, {255, 0, 255, 255});
  heights.lies_at(10, 50, 0.5, 2, 2048, 4326);
  const std::string file = written("masked.tif", heights.bytes());
  written("masked.tif.msk", mask.is_mask().bytes());  // beside it, as GDAL has it
  const auto masked = must(read_terrain_file(file, {.missing = 3}));
  EXPECT_EQ(masked.heights, (std::vector<double>{300, 400, 100, 3}));
  // Brought from another projection, the hole is still one.
  std::vector<float> flat;
  for (int i = 0; i < 41 * 41; ++i) flat.push_back(12), flat.push_back(i == 20 * 41 + 20 ? 0 : 255);
  Tiff utm(41, 41, flat, true);
  utm.lies_at(499500, 4984944.378 * 0.9996 + 500, 25, 1, 3072, 32632);
  const auto warped = must(read_terrain_file(written("alpha_utm.tif", utm.bytes()), {.missing = 3}));
  EXPECT_LT(warped.heights[warped.rows / 2 * std::size_t{warped.columns} + warped.columns / 2], 12);
}

/// A plane in latitude and longitude of the Tokyo datum (EPSG 4301). By the parameters of its definition (EPSG 1230:
/// dX = -148, dY = 507, dZ = 685 m from Tokyo to WGS 84, accuracy tens of metres) 36 N 138 E lies near 36.00307 N
/// 137.99696 E in WGS 84.
TEST_F(TerrainFile, InAnotherGeographicSystemIsBroughtToWgs84) {
  constexpr int kSide = 41;
  constexpr double kStep = 0.005;
  std::vector<float> heights;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      heights.push_back(static_cast<float>(1000 + 10 * (kSide / 2 - row) + 20 * (column - kSide / 2)));
  Tiff tiff(kSide, kSide, heights);
  tiff.lies_at(138 - kSide / 2 * kStep, 36 + kSide / 2 * kStep, kStep, 2, 2048, 4301);
  const auto grid = must(read_terrain_file(written("tokyo.tif", tiff.bytes()),
                                           {.latitude = 36 * kDegree, .longitude = 138 * kDegree, .reach = 3000}));
  for (std::uint32_t row = 0; row < grid.rows; ++row)
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const double north = (grid.latitude + row * grid.latitude_step) / kDegree - 36.00307;
      const double east = (grid.longitude + column * grid.longitude_step) / kDegree - 137.99696;
      // 30 m are 0.0003 degrees.
      ASSERT_NEAR(grid.heights[std::size_t{row} * grid.columns + column], 1000 + (10 * north + 20 * east) / kStep, 2);
    }
}

TEST_F(TerrainFile, OfTheWholeEarthGoesOnAcrossItsEdge) {
  std::vector<float> heights;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 360; ++column) heights.push_back(static_cast<float>(column));
  Tiff tiff(360, 3, heights);
  tiff.lies_at(-179.5, 1, 1, 2, 2048, 4326);
  const std::string file = written("earth.tif", tiff.bytes());
  for (const double longitude : {180.0, -180.0, 179.9, -179.9}) {
    const auto grid = must(read_terrain_file(file, {.longitude = longitude * kDegree, .reach = 2 * 111e3}));
    ASSERT_GE(grid.columns, 4U);
    for (std::uint32_t i = 0; i < grid.columns; ++i) {
      const double there = (grid.longitude + i * grid.longitude_step) / kDegree + 179.5;
      EXPECT_EQ(grid.heights[i], std::lround(there + 720) % 360) << longitude << ' ' << i;
    }
  }
  const auto all = must(read_terrain_file(file));
  EXPECT_EQ(all.columns, 360U);
}

// On the meridian of 9 degrees, the middle one of UTM's zone 32, northings are 0.9996 times the length of the meridian
// from the equator: 4984944.378 m to 45 degrees of WGS 84 (J. P. Snyder, Map Projections (1987), eq. 3-21).
TEST_F(TerrainFile, InAnotherProjectionIsBroughtToLatitudeAndLongitude) {
  constexpr int kSide = 81;
  constexpr double kStep = 25, kNorthing = 0.9996 * 4984944.378;
  std::vector<float> heights;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      heights.push_back(static_cast<float>((kSide / 2 - row) * 2 + (column - kSide / 2)));
  Tiff tiff(kSide, kSide, heights);
  tiff.lies_at(500000 - kSide / 2 * kStep, kNorthing + kSide / 2 * kStep, kStep, 1, 3072, 32632);
  const std::string file = written("utm.tif", tiff.bytes());
  const auto grid = must(read_terrain_file(file, {.latitude = 45 * kDegree, .longitude = 9 * kDegree, .reach = 700}));
  ASSERT_GT(grid.heights.size(), 400u);
  // Metres of a degree there: by the radii of curvature of the ellipsoid.
  constexpr double kSquare = 0.00669437999014, kAxis = 6378137, kBent = 1 - kSquare / 2;
  const double meridian = kAxis * (1 - kSquare) / (kBent * std::sqrt(kBent)), normal = kAxis / std::sqrt(kBent);
  for (std::uint32_t row = 0; row < grid.rows; ++row)
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const double north = (grid.latitude + row * grid.latitude_step - 45 * kDegree) * meridian * 0.9996;
      const double east = (grid.longitude + column * grid.longitude_step - 9 * kDegree) * normal *
                          std::cos(grid.latitude + row * grid.latitude_step) * 0.9996;
      ASSERT_NEAR(grid.heights[std::size_t{row} * grid.columns + column], north / kStep * 2 + east / kStep, 0.02);
    }
}

// Three degrees from that meridian the lines of UTM are turned by 2.7 degrees: corners of the grid are not in the file.
TEST_F(TerrainFile, InATurnedProjectionHasNothingAtTheCorners) {
  Tiff tiff(81, 81, std::vector<float>(81 * 81, 12));
  tiff.lies_at(800000, 5000000, 25, 1, 3072, 32632);
  const std::string file = written("turned.tif", tiff.bytes());
  const auto refused = read_terrain_file(file);
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().message.starts_with("has points without a height: latitude 45."))
      << refused.error().message;
  const auto grid = must(read_terrain_file(file, {.missing = -7}));
  EXPECT_EQ(grid.heights.front(), -7);
  EXPECT_EQ(grid.heights.back(), -7);
  EXPECT_NEAR(grid.heights[grid.rows / 2 * std::size_t{grid.columns} + grid.columns / 2], 12, 1e-9);
}

TEST_F(TerrainFile, ThatMakesNoSenseIsRefused) {
  const std::string file = tile([](int, int) { return 5; });
  const auto refusal = [&](const TerrainCut& cut) { return read_terrain_file(file, cut).error().text(); };
  EXPECT_NE(refusal({.every = 0}).find("every: error: must be at least 1"), std::string::npos);
  EXPECT_NE(refusal({.reach = 0}).find("reach: error: must be above 0 m"), std::string::npos);
  EXPECT_NE(refusal({.reach = std::nan("")}).find("reach"), std::string::npos);
  EXPECT_NE(refusal({.latitude = 2}).find("latitude"), std::string::npos);
  EXPECT_NE(refusal({.geoid = 1e9}).find("geoid"), std::string::npos);
  EXPECT_NE(refusal({.latitude = 10 * kDegree, .reach = 1000}).find("it has latitudes of 46.0"), std::string::npos)
      << refusal({.latitude = 10 * kDegree, .reach = 1000});
  EXPECT_NE(refusal({.latitude = 46.5 * kDegree, .longitude = 7.5 * kDegree, .reach = 1000, .every = 5000})
                .find("two points"),
            std::string::npos);
  EXPECT_NE(read_terrain_file(written("words.tif", "no picture")).error().message.find("it is no terrain"),
            std::string::npos);
  Tiff nowhere(2, 2, {1, 2, 3, 4});
  EXPECT_EQ(read_terrain_file(written("nowhere.tif", nowhere.bytes())).error().message,
            "it does not say where on the Earth it lies");
  Tiff cut(40, 40, std::vector<float>(1600, 3));
  cut.lies_at(10, 50, 0.1, 2, 2048, 4326);
  const std::string half = cut.bytes().substr(0, 2000);
  EXPECT_NE(read_terrain_file(written("half.tif", half)).error().message.find("the file is damaged"),
            std::string::npos);
  Tiff full_of_nan(2, 2, {1, 2, std::nanf(""), 4});
  full_of_nan.lies_at(10, 50, 0.1, 2, 2048, 4326);
  EXPECT_EQ(read_terrain_file(written("nan.tif", full_of_nan.bytes())).error().message,
            "has points without a height: row 2, column 1: latitude 49.900000, longitude 10.000000");
}

// ------------------------------------------------------------------------------------------------- in scenarios
std::string scenario_with(const std::string& mesh, const std::string& more = "") {
  return "physim = 1\n[environment]\naltitude = \"500 m\"\nearth = { latitude = \"46.5 deg\", longitude = \"7.5 deg\" "
         "}\n"
         "[[shot]]\nvelocity = [0, -100, 0]\nposition = [0, 1000, 0]\n" +
         more + "[[shape]]\nname = \"alps\"\n" + mesh + "\n[[thing]]\nshape = \"alps\"\n";
}

TEST_F(TerrainFile, StandsInScenariosAboutTheirPlace) {
  const std::string terrain = tile([](int row, int) { return 700 + row - 600; });  // falls northwards
  const std::string text = scenario_with("mesh = { terrain = \"N46E007.hgt\", reach = \"3 km\", every = 2 }");
  const auto scenario = must(parse_scenario(text, in_folder("f.toml")));
  const Scene scene = scene_of(scenario).value();
  const SceneHit below = scene.first_hit({{0, 1000, 0}, {0, -1000, 0}, 0, 0, 0});
  ASSERT_TRUE(below);
  EXPECT_NEAR(below.position.y, 700 - 500, 1e-3);
  // A kilometre north: 10.79 rows, and the ellipsoid falls by d^2 / 2R.
  const SceneHit north = scene.first_hit({{1000, 1000, 0}, {1000, -1000, 0}, 0, 0, 0});
  ASSERT_TRUE(north);
  EXPECT_NEAR(north.position.y, 200 - 1000 / 111.17e3 * 1200 - 1e6 / 2 / 6.37e6, 0.03);
  EXPECT_FALSE(scene.first_hit({{4000, 1000, 0}, {4000, -1000, 0}, 0, 0, 0}));
  const std::string again = scenario_text(scenario);
  EXPECT_NE(again.find("terrain = \"N46E007.hgt\""), again.npos) << again;
  EXPECT_EQ(again.find("vertices"), again.npos);
  const auto reread = must(parse_scenario(again, in_folder("f.toml")));
  EXPECT_EQ(std::get<MeshShape>(reread.shapes[0].shape).vertices,
            std::get<MeshShape>(scenario.shapes[0].shape).vertices);
}

TEST_F(TerrainFile, ThatEndsBeforeItsReachHasANote) {
  tile([](int, int) { return 700; });  // 55.6 km north and south of the place, 38.3 km east and west
  const auto notes = [&](const std::string& reach) {
    return must(parse_scenario(
                    scenario_with("mesh = { terrain = \"N46E007.hgt\", every = 50, reach = \"" + reach + "\" }"),
                    in_folder("f.toml")))
        .notes;
  };
  EXPECT_TRUE(notes("30 km").empty());
  EXPECT_TRUE(notes("38 km").empty());
  ASSERT_EQ(notes("50 km").size(), 1U);
  EXPECT_NE(notes("50 km")[0].find("f.toml:10:55: shape.mesh.reach: 50000 m, and on one side the file ends 382"),
            std::string::npos)
      << notes("50 km")[0];
}

TEST_F(TerrainFile, OfScenariosIsRefusedAtItsLine) {
  const auto refusal = [&](const std::string& mesh, const std::string& more = "") {
    const auto scenario = parse_scenario(scenario_with(mesh, more), in_folder("f.toml"));
    return scenario ? "none" : scenario.error().text();
  };
  tile([](int, int) { return 5; });
  EXPECT_NE(
      refusal("mesh = { terrain = \"no.tif\" }").find("f.toml:10:20: error: shape.mesh.terrain: there is no such"),
      std::string::npos)
      << refusal("mesh = { terrain = \"no.tif\" }");
  EXPECT_NE(refusal("mesh = { terrain = \"N46E007.hgt\", file = \"a.obj\" }").find("given together with terrain"),
            std::string::npos);
  EXPECT_NE(refusal("mesh = { terrain = \"N46E007.hgt\", vertices = [[0,0,0]] }").find("given together with vertices"),
            std::string::npos);
  EXPECT_NE(refusal("mesh = { terrain = \"N46E007.hgt\", every = 0 }").find("shape.mesh.every"), std::string::npos);
  EXPECT_NE(refusal("mesh = { terrain = \"N46E007.hgt\", reach = \"3 kg\" }").find("shape.mesh.reach"),
            std::string::npos);
  const std::string round = "fidelity = { earth = \"sphere\" }\n[[shot]]\nvelocity = [0, 9, 0]\n";
  EXPECT_NE(refusal("mesh = { terrain = \"N46E007.hgt\" }", round).find("some shots fly over a sphere"),
            std::string::npos)
      << refusal("mesh = { terrain = \"N46E007.hgt\" }", round);
}

}  // namespace physim::scenario_terrain_file_test
