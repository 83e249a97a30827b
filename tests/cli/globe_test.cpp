// `physim run --kml --czml --geojson`, read back by readers that know nothing of PhySim.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.hpp"
#include "physim/physim.hpp"

#ifdef PHYSIM_CLI

namespace physim {
namespace cli_globe_test {

using nlohmann::json;

constexpr double kDegree = 3.14159265358979323846 / 180;

/// Over the antimeridian, from Kamchatka's latitude to the east.
const char* const kScenario = R"(physim = 1
title = "over <the> antimeridian & on"
[environment]
altitude = "50 m"
gravity = "wgs84"
atmosphere = "vacuum"
earth = { latitude = "53 deg", longitude = "170 deg", azimuth = "80 deg" }
[[shot]]
name = "lob \u00e4 & b"
speed = "3500 m/s"
elevation = "40 deg"
fidelity = { preset = "simulation", earth = "ellipsoid", gravity = "wgs84", drag = "off" }
)";

/// The same shot through the library.
Flight the_flight() {
  Environment e;
  e.altitude = 50;
  e.atmosphere.model = AirModel::vacuum;
  e.earth = {.latitude = 53 * kDegree, .longitude = 170 * kDegree, .azimuth = 80 * kDegree};
  Fidelity f = Fidelity::simulation();
  f.earth = EarthModel::ellipsoid;
  f.gravity = GravityModel::wgs84;
  f.drag = DragModel::off;
  return fly({}, {.speed = 3500, .elevation = 40 * kDegree}, e, f);
}

using namespace testing_cli;

/// Writes the scenario's flights into a file of a folder.
std::string globe_file(const Folder& folder, const std::string& option) {
  const std::string file = folder / "globe";
  const Ran ran =
      run_program(PHYSIM_CLI, {"run", folder.write("globe.toml", kScenario), "--interval", "10 s", option, file});
  EXPECT_EQ(ran.code, 0) << ran.err;
  return file;
}

json globe_json(const std::string& option) {
  const Folder folder;
  return json::parse(read(globe_file(folder, option)), nullptr, false);
}

TEST(Globe, geojson_is_cut_at_the_antimeridian) {
  const json map = globe_json("--geojson");
  ASSERT_TRUE(map.is_object());
  EXPECT_EQ(map.at("type"), "FeatureCollection");
  const json& path = map.at("features").at(0);
  EXPECT_EQ(path.at("geometry").at("type"), "MultiLineString");
  const json& lines = path.at("geometry").at("coordinates");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].back().at(0), 180);
  EXPECT_EQ(lines[1].front().at(0), -180);
  EXPECT_EQ(lines[0].back().at(1), lines[1].front().at(1));
  const Flight flight = the_flight();
  const EarthFrames frames = flight.earth_frames();
  std::size_t points = 0;
  for (std::size_t part = 0; part < lines.size(); ++part)
    for (std::size_t i = 0; i < lines[part].size(); ++i) {
      const json& p = lines[part][i];
      ASSERT_EQ(p.size(), 3U);
      ++points;
      if (std::abs(p[0].get<double>()) == 180) continue;
      const Geodetic g = frames.geodetic(flight.at(path.at("properties").at("times [s]")[part][i]).position);
      EXPECT_NEAR(p[0], g.longitude / kDegree, 1e-12);
      EXPECT_NEAR(p[1], g.latitude / kDegree, 1e-12);
      EXPECT_NEAR(p[2], g.height, 1e-7);
    }
  EXPECT_EQ(points, std::ceil(flight.duration() / 10) + 1 + 2);
  const json& end = map.at("features").back();
  EXPECT_EQ(end.at("geometry").at("type"), "Point");
  EXPECT_EQ(end.at("properties").at("what"), "landed");
  EXPECT_NEAR(end.at("geometry").at("coordinates").at(2), 50, 1e-7);
}

TEST(Globe, czml_moves_in_time) {
  const json packets = globe_json("--czml");
  ASSERT_EQ(packets.size(), 2U);
  EXPECT_EQ(packets[0].at("id"), "document");
  EXPECT_EQ(packets[0].at("version"), "1.0");
  const json& shot = packets[1];
  EXPECT_EQ(shot.at("position").at("epoch"), "2000-01-01T12:00:00Z");
  const json& numbers = shot.at("position").at("cartographicDegrees");
  ASSERT_EQ(numbers.size() % 4, 0U);
  const Flight flight = the_flight();
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    const Geodetic g = flight.earth_frames().geodetic(flight.at(numbers[i]).position);
    EXPECT_NEAR(numbers[i + 1], g.longitude / kDegree, 1e-12);
    EXPECT_NEAR(numbers[i + 2], g.latitude / kDegree, 1e-12);
    EXPECT_NEAR(numbers[i + 3], g.height, 1e-7);
  }
  EXPECT_EQ(numbers[numbers.size() - 4], flight.duration());
  const int end = 100 + static_cast<int>(std::ceil(flight.duration()) / 60);  // minutes in two digits
  const std::string interval = shot.at("availability");
  EXPECT_EQ(interval.substr(0, 38), "2000-01-01T12:00:00Z/2000-01-01T12:" + std::to_string(end).substr(1) + ":");
}

// Python's own parser of XML; KML's order is longitude, latitude, height.
TEST(Globe, kml_is_read_by_another_program) {
  const std::string python = "/usr/bin/python3";
  if (run_program(python, {"-c", "import xml.etree.ElementTree"}).code != 0) GTEST_SKIP() << "python3 is missing";
  const Folder folder;
  const std::string file = globe_file(folder, "--kml");
  const std::string program = folder.write("reader.py",
                                           "import sys, xml.etree.ElementTree as tree\n"
                                           "k = '{http://www.opengis.net/kml/2.2}'\n"
                                           "document = tree.parse(sys.argv[1]).getroot().find(k + 'Document')\n"
                                           "print(document.find(k + 'name').text)\n"
                                           "line = document.find('.//' + k + 'LineString')\n"
                                           "print(line.find(k + 'altitudeMode').text)\n"
                                           "print(line.find(k + 'coordinates').text.replace(',', ' '))\n");
  const Ran reader = run_program(python, {program, file});
  ASSERT_EQ(reader.code, 0) << reader.err;
  std::istringstream lines(reader.out);
  std::string title, mode;
  std::getline(lines, title);
  std::getline(lines, mode);
  EXPECT_EQ(title, "over <the> antimeridian & on");
  EXPECT_EQ(mode, "absolute");
  const Flight flight = the_flight();
  double longitude = 0, latitude = 0, height = 0, time = 0;
  for (; lines >> longitude >> latitude >> height; time += 10) {
    const Geodetic g = flight.earth_frames().geodetic(flight.at(time).position);
    EXPECT_NEAR(longitude, g.longitude / kDegree, 1e-12);
    EXPECT_NEAR(latitude, g.latitude / kDegree, 1e-12);
    EXPECT_NEAR(height, g.height, 1e-7);
  }
  EXPECT_GT(time, flight.duration());
}

TEST(Globe, a_flat_earth_is_on_no_globe) {
  const Folder folder;
  const Ran refused = run_program(PHYSIM_CLI, {"run", folder.write("globe.toml", kScenario), "--set",
                                               "shot.fidelity.earth=flat", "--kml", folder / "flight.kml"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("flat Earth"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("shot.fidelity.earth=ellipsoid"), std::string::npos) << refused.err;
}

}  // namespace cli_globe_test
}  // namespace physim

#endif  // PHYSIM_CLI
