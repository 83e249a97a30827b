// `physim run --kml --czml --geojson`, read back by readers that know nothing of PhySim.
#include <cmath>
#include <map>

#include "cli/program.hpp"
#include "physim/physim.hpp"
#include "report/number.hpp"
#include "scenario/scenario.hpp"

#ifdef PHYSIM_CLI

namespace physim::cli_globe_test {

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
  Environment e{.altitude = 50,
                .atmosphere = {.model = AirModel::vacuum},
                .earth = {.latitude = 53 * kDegree, .longitude = 170 * kDegree, .azimuth = 80 * kDegree}};
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
                                           "lines = document.findall('.//' + k + 'LineString')\n"
                                           "print(lines[0].find(k + 'altitudeMode').text)\n"
                                           "for line in lines:\n"
                                           "  print(line.find(k + 'coordinates').text.replace(',', ' '))\n");
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
    while (std::abs(longitude) == 180) lines >> longitude >> latitude >> height;  // where the path is cut
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
  const Ran world = run_program(PHYSIM_CLI, {"run", folder.write("world.toml", kScenario + std::string("[world]\n")),
                                             "--set", "shot.fidelity.earth=flat", "--czml", folder / "world.czml"});
  EXPECT_EQ(world.code, 2);
  EXPECT_NE(world.err.find("flat Earth"), std::string::npos) << world.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "world.czml"));
}

// --------------------------------------------------------------------------------- files for others: corners and times
/// A ball off a wall at 60 m, east of the antimeridian's west; the wall is passed between two samples.
const char* const kWall = R"(physim = 1
title = "off a wall"
[environment]
earth = { latitude = "-16.8 deg", longitude = "179.9996 deg", azimuth = "90 deg" }
[[shot]]
name = "ball, fast & <loud>"
mass = "0.4 kg"
diameter = "0.1 m"
speed = "90 m/s"
elevation = "12 deg"
position = [0, "1 m", 0]
drag = { table = "constant", coefficient = 0.4 }
body = { collision = { on_hit = "bounce", radius = "5 cm" }, restitution = 0.7 }
fidelity = { preset = "simulation", earth = "ellipsoid" }
[[shape]]
name = "slab"
box = ["1 m", "60 m", "60 m"]
[[thing]]
name = "wall"
shape = "slab"
position = ["60.5 m", 0, 0]
[until]
ground = "-10 m"
)";
/// A motor that burns out in flight, from a rail.
const char* const kRocket = R"(physim = 1
[environment]
earth = { latitude = "45 deg", longitude = "8 deg", azimuth = "30 deg" }
[[shot]]
name = "rocket"
mass = "1 kg"
diameter = "6 cm"
elevation = "80 deg"
rail_length = "2 m"
drag = { table = "constant", coefficient = 0.5 }
motor = { thrust = [[0, 120], [1.337, 120], [1.3371, 0]], propellant_mass = "0.2 kg" }
fidelity = { preset = "simulation", earth = "ellipsoid" }
)";

/// A scenario of one shot, flown in this program.
struct Flown {
  Scenario scenario;
  Flight flight;
  explicit Flown(const std::string& text)
      : scenario(parse_scenario(text, "f.toml").value()), flight(fly_shot(scenario, scenario.shots[0])) {}
  [[nodiscard]] std::string degrees_at(const Vec3d& position) const {
    const Geodetic g = flight.earth_frames().geodetic(position);
    const double per_radian = 180 / 3.14159265358979323846;
    return report::shortest(g.longitude * per_radian) + "," + report::shortest(g.latitude * per_radian) + "," +
           report::shortest(g.height);
  }
  /// Times at which the path has a corner, and where it is then.
  [[nodiscard]] std::map<double, Vec3d> corners() const {
    std::map<double, Vec3d> all;
    for (const Event& e : flight.events())
      if (e.kind == EventKind::hit || e.kind == EventKind::burnout || e.kind == EventKind::rail_exit)
        all.emplace(e.time, e.position);
    return all;
  }
};

std::string written(const std::string& text, const std::string& option, const std::vector<std::string>& more = {}) {
  const Folder folder;
  std::vector<std::string> words = {"run", folder.write("f.toml", text), option, folder / "out"};
  words.insert(words.end(), more.begin(), more.end());
  const Ran ran = run_program(PHYSIM_CLI, words);
  EXPECT_EQ(ran.code, 0) << ran.err;
  return read(folder / "out");
}

/// Cells of RFC 4180.
std::vector<std::vector<std::string>> csv_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = rows.back().back();
    const char c = text[i];
    if (is_quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      cell += '"', ++i;
    else if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      rows.back().emplace_back();
    else if (c == '\n' && !is_quoted)
      rows.emplace_back(1, std::string());
    else
      cell += c;
  }
  rows.pop_back();
  return rows;
}

TEST(FilesForOthers, CsvHasARowAtEveryCornerAndNoBlankBehindACommaOfItsOwn) {
  for (const char* text : {kWall, kRocket}) {
    const Flown flown(text);
    ASSERT_FALSE(flown.corners().empty());
    const auto rows = csv_of(written(text, "--csv", {"--interval", "0.25 s"}));
    EXPECT_EQ(rows[0][1], "t [s]");
    EXPECT_EQ(rows[1][0], flown.scenario.shots[0].projectile.name);
    for (const auto& [time, place] : flown.corners()) {
      const auto row = std::ranges::find_if(rows, [&](const auto& r) { return r[1] == report::shortest(time); });
      ASSERT_NE(row, rows.end()) << time;
      EXPECT_EQ((*row)[2], report::shortest(place.x));
      EXPECT_EQ((*row)[3], report::shortest(place.y));
      EXPECT_EQ((*row)[4], report::shortest(place.z));
    }
    double last = -1;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i].size(), rows[0].size());
      const double time = std::stod(rows[i][1]);
      EXPECT_GE(time, last);
      last = time;
    }
  }
}

TEST(FilesForOthers, CsvTellsHowAHitWasComeToAndLeft) {
  const Flown flown(kWall);
  const auto rows = csv_of(written(kWall, "--csv", {"--interval", "0.25 s"}));
  const auto [time, place] = *flown.corners().begin();
  std::vector<double> across;
  for (const auto& row : rows)
    if (row[1] == report::shortest(time)) across.push_back(std::stod(row[5]));
  ASSERT_EQ(across.size(), 2U) << "before and behind";
  EXPECT_GT(across[0], 50);
  EXPECT_NEAR(across[1], -0.7 * 0.5 * across[0], 1e-9) << "0.5 is that of every material";
}

TEST(FilesForOthers, KmlAndGeoJsonTurnWhereTheFlightDoes) {
  for (const char* text : {kWall, kRocket}) {
    const Flown flown(text);
    const std::string kml = written(text, "--kml", {"--interval", "0.25 s"});
    const std::string path = kml.substr(0, kml.find("<Point>"));
    const json map = json::parse(written(text, "--geojson", {"--interval", "0.25 s"}));
    const json& feature = map.at("features").at(0);
    std::vector<std::pair<double, json>> points;
    const bool is_whole = feature.at("geometry").at("type") == "LineString";
    const json lines =
        is_whole ? json::array({feature.at("geometry").at("coordinates")}) : feature["geometry"]["coordinates"];
    const json times =
        is_whole ? json::array({feature.at("properties").at("times [s]")}) : feature["properties"]["times [s]"];
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (std::size_t k = 0; k < lines[i].size(); ++k) points.emplace_back(times[i][k], lines[i][k]);
    for (const auto& [time, place] : flown.corners()) {
      const std::string wanted = flown.degrees_at(place);
      EXPECT_NE(path.find(wanted + "\n"), std::string::npos) << wanted;
      const auto point = std::ranges::find(points, time, &std::pair<double, json>::first);
      ASSERT_NE(point, points.end()) << time;
      const json& p = point->second;
      EXPECT_EQ(report::shortest(p[0]) + "," + report::shortest(p[1]) + "," + report::shortest(p[2]), wanted);
    }
  }
}

/// Seconds since noon of 1 January 2000, of a time on that day.
double seconds_of(const std::string& utc) {
  EXPECT_EQ(utc.substr(0, 11), "2000-01-01T") << utc;
  EXPECT_EQ(utc.back(), 'Z');
  return (std::stod(utc.substr(11, 2)) - 12) * 3600 + std::stod(utc.substr(14, 2)) * 60 + std::stod(utc.substr(17));
}

/// What a viewer of CZML makes of it: in each interval a polynomial of the degree given through the samples around.
class CzmlPath {
 public:
  CzmlPath(const json& position, const EarthFrames& frames) {
    for (const json& part : position.is_array() ? position : json::array({position})) {
      Part& read = parts_.emplace_back();
      EXPECT_EQ(part.at("interpolationAlgorithm"), "LAGRANGE");
      degree_ = part.at("interpolationDegree");
      const json& numbers = part.at("cartographicDegrees");
      for (std::size_t i = 0; i < numbers.size(); i += 4) {
        read.times.push_back(numbers[i]);
        read.places.push_back(frames.position(
            {numbers[i + 2].get<double>() * kDegree, numbers[i + 1].get<double>() * kDegree, numbers[i + 3]}));
      }
      if (!part.contains("interval")) continue;
      const std::string interval = part.at("interval");
      const std::size_t slash = interval.find('/');
      EXPECT_NEAR(seconds_of(interval.substr(0, slash)), read.times.front(), 1e-11);
      EXPECT_NEAR(seconds_of(interval.substr(slash + 1)), read.times.back(), 1e-11);
    }
  }
  [[nodiscard]] Vec3d at(double time) const {
    for (const Part& part : parts_)
      if (time <= part.times.back()) return part.at(time, degree_);
    return parts_.back().places.back();
  }
  [[nodiscard]] double end() const { return parts_.back().times.back(); }
  [[nodiscard]] std::size_t parts() const { return parts_.size(); }
  [[nodiscard]] bool has(double time) const {
    return std::ranges::any_of(parts_, [&](const Part& p) { return std::ranges::count(p.times, time) > 0; });
  }

 private:
  struct Part {
    std::vector<double> times;
    std::vector<Vec3d> places;
    [[nodiscard]] Vec3d at(double time, std::size_t degree) const {
      const auto next = static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
      const std::size_t count = std::min(degree + 1, times.size()), back = (count - 1) / 2 + 1;
      const std::size_t first = std::min(next < back ? 0 : next - back, times.size() - count);
      Vec3d place;
      for (std::size_t i = first; i < first + count; ++i) {
        double weight = 1;
        for (std::size_t j = first; j < first + count; ++j)
          if (j != i) weight *= (time - times[j]) / (times[i] - times[j]);
        place = place + places[i] * weight;
      }
      return place;
    }
  };
  std::vector<Part> parts_;
  std::size_t degree_ = 1;
};

TEST(FilesForOthers, CzmlShowsTheFlownPathBetweenItsSamples) {
  for (const char* text : {kWall, kRocket, kScenario})
    for (const char* interval : {"0.25 s", "10 s"}) {
      const Flown flown(text);
      const json packets = json::parse(written(text, "--czml", {"--interval", interval}));
      const CzmlPath path(packets.at(1).at("position"), flown.flight.earth_frames());
      const double duration = flown.flight.duration();
      EXPECT_EQ(path.end(), duration);
      for (const auto& [time, place] : flown.corners()) EXPECT_TRUE(path.has(time)) << time;
      double farthest = 0;
      for (int i = 0; i <= 5000; ++i) {
        const double time = duration * i / 5000;
        const Vec3d off = path.at(time) - flown.flight.at(time).position;
        farthest = std::max(farthest, std::hypot(off.x, off.y, off.z));
      }
      EXPECT_LT(farthest, 2e-3) << text << interval;
    }
}

TEST(FilesForOthers, CzmlsClockEndsWhereTheSamplesDo) {
  for (const char* text : {kWall, kRocket, kScenario}) {
    const Flown flown(text);
    const json packets = json::parse(written(text, "--czml"));
    const std::string clock = packets[0].at("clock").at("interval"), there = packets[1].at("availability");
    EXPECT_EQ(clock, there);
    const double end = seconds_of(clock.substr(clock.find('/') + 1));
    EXPECT_NEAR(end, flown.flight.duration(), 1e-11 * (1 + end));
  }
}

/// A world of one shot has the files of its flight.
TEST(FilesForOthers, WorldsAreOnGlobesToo) {
  std::string text = kWall;
  text.replace(text.find("[until]"), text.npos, "[world]\nduration = \"2 s\"\n");
  const Flown flown(kWall);
  const Vec3d place = flown.corners().begin()->second;
  const json packets = json::parse(written(text, "--czml", {"--interval", "0.05 s"}));
  ASSERT_EQ(packets.size(), 2U);
  EXPECT_EQ(packets[1].at("name"), flown.scenario.shots[0].projectile.name);
  const CzmlPath path(packets[1].at("position"), flown.flight.earth_frames());
  EXPECT_GE(path.parts(), 2U) << "parted at the wall";
  double farthest = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double time = 1.5 * i / 1000;
    farthest = std::max(farthest, length(path.at(time) - flown.flight.at(time).position));
  }
  EXPECT_LT(farthest, 3e-3);
  const json map = json::parse(written(text, "--geojson", {"--interval", "0.05 s"}));
  std::vector<std::string> marks;
  for (const json& feature : map.at("features")) marks.push_back(feature.at("properties").at("what"));
  EXPECT_EQ(marks[0], "path");
  EXPECT_EQ(marks[1], "launch");
  EXPECT_EQ(std::ranges::count(marks, "hit"), 1);
  EXPECT_EQ(map["features"][0]["geometry"]["type"], "MultiLineString") << "it crosses the antimeridian";
  const auto mark = std::ranges::find(marks, "hit") - marks.begin();
  const json& hit_at = map["features"][static_cast<std::size_t>(mark)]["geometry"]["coordinates"];
  const Geodetic there = flown.flight.earth_frames().geodetic(place);
  EXPECT_NEAR(hit_at[0], there.longitude / kDegree, 1e-10);
  EXPECT_NEAR(hit_at[2], there.height, 1e-5);
  const std::string numbers = report::shortest(hit_at[0]) + "," + report::shortest(hit_at[1]) + ",";
  EXPECT_NE(written(text, "--kml", {"--interval", "0.05 s"}).find("     " + numbers), std::string::npos)
      << "a sample at the hit";
  // Of many, each has its number.
  const json volley = json::parse(
      written(text + "[[volley]]\nname = \"balls\"\nshot = \"ball, fast & <loud>\"\ncount = 3\n", "--czml"));
  ASSERT_EQ(volley.size(), 4U);
  EXPECT_EQ(volley[3].at("id"), "shot/balls 3");
}

TEST(FilesForOthers, HeadersSayWhatHeightsAre) {
  const std::string kml = written(kRocket, "--kml");
  const std::string head = kml.substr(0, kml.find("<Folder>"));
  EXPECT_NE(head.find("above the ellipsoid"), std::string::npos) << head;
  EXPECT_NE(head.find("above the sea"), std::string::npos) << head;
  EXPECT_NE(json::parse(written(kRocket, "--czml"))[0].at("description").get<std::string>().find("above the ellipsoid"),
            std::string::npos);
  EXPECT_NE(json::parse(written(kRocket, "--geojson")).at("description").get<std::string>().find("above the ellipsoid"),
            std::string::npos);
}

/// Names, times and the cut at the antimeridian, by Python's parser of XML; the order of elements is that of the
/// schema of KML 2.2.
TEST(FilesForOthers, KmlFollowsItsSchemaAndNamesPathsAfterTheirShots) {
  const std::string python = "/usr/bin/python3";
  if (run_program(python, {"-c", "import xml.etree.ElementTree"}).code != 0) GTEST_SKIP() << "python3 is missing";
  const Folder folder;
  const std::string reader = folder.write("reader.py", R"py(
import sys, xml.etree.ElementTree as tree
k = '{http://www.opengis.net/kml/2.2}'
order = ['name', 'visibility', 'open', 'address', 'Snippet', 'description', 'LookAt', 'TimeStamp', 'TimeSpan',
         'styleUrl', 'Style', 'StyleMap', 'Region', 'ExtendedData', 'Folder', 'Placemark', 'Point', 'LineString',
         'Polygon', 'MultiGeometry']
inner = {'LineString': ['extrude', 'tessellate', 'altitudeMode', 'coordinates'],
         'Point': ['extrude', 'altitudeMode', 'coordinates'], 'TimeSpan': ['begin', 'end'], 'TimeStamp': ['when'],
         'Polygon': ['extrude', 'tessellate', 'altitudeMode', 'outerBoundaryIs'], 'LinearRing': ['coordinates']}
def check(element):
    tag = element.tag.replace(k, '')
    wanted = inner.get(tag, order if tag in ('Document', 'Folder', 'Placemark') else None)
    if wanted is not None:
        places = [wanted.index(child.tag.replace(k, '')) for child in element]
        assert places == sorted(places), (tag, [child.tag for child in element])
    for child in element: check(child)
root = tree.parse(sys.argv[1]).getroot()
check(root)
for line in root.iter(k + 'coordinates'):
    points = [[float(x) for x in point.split(',')] for point in line.text.split()]
    for a, b in zip(points, points[1:]):
        assert abs(a[0] - b[0]) < 180, (a, b)
    assert all(abs(p[0]) <= 180 for p in points)
for ring in root.iter(k + 'LinearRing'):
    points = ring.find(k + 'coordinates').text.split()
    assert points[0] == points[-1] and len(points) >= 4
for folder in root.iter(k + 'Folder'):
    path, mark = folder.findall(k + 'Placemark')[:2]
    print(folder.find(k + 'name').text)
    print(path.find(k + 'name').text)
    print(path.find(k + 'TimeSpan').find(k + 'end').text)
    print(len(list(path.iter(k + 'LineString'))))
    print(mark.find(k + 'TimeStamp').find(k + 'when').text)
)py");
  const Ran read = run_program(python, {reader, folder.write("wall.kml", written(kWall, "--kml"))});
  ASSERT_EQ(read.code, 0) << read.err;
  const Flown flown(kWall);
  const std::vector<std::string> lines = lines_of(read.out);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], "ball, fast & <loud>");
  EXPECT_EQ(lines[1], "ball, fast & <loud>");
  EXPECT_NEAR(seconds_of(lines[2]), flown.flight.duration(), 1e-11);
  EXPECT_EQ(lines[3], "3") << "out over the antimeridian, and back";
  EXPECT_EQ(lines[4], "2000-01-01T12:00:00Z");
  const Ran far = run_program(python, {reader, folder.write("far.kml", written(kScenario, "--kml"))});
  EXPECT_EQ(far.code, 0) << far.err;
  const std::string study = R"(physim = 1
[environment]
atmosphere = "vacuum"
earth = { latitude = "-16.8 deg", longitude = "179.99 deg", azimuth = "90 deg" }
[[shot]]
speed = "102 m/s"
elevation = "45 deg"
fidelity = { preset = "simulation", gravity = "wgs84", earth = "ellipsoid" }
[study]
inputs = ["shot.speed = +- 10 m/s", "shot.azimuth = +- 10 deg"]
shots = 4096
)";
  const Ran map = run_program(PHYSIM_CLI, {"study", folder.write("s.toml", study), "--kml", folder / "s.kml"});
  ASSERT_EQ(map.code, 0) << map.err;
  const Ran rings = run_program(python, {reader, folder / "s.kml"});
  EXPECT_EQ(rings.code, 0) << rings.err;
  const std::string text = testing_cli::read(folder / "s.kml");
  EXPECT_NE(text.find("<MultiGeometry>\n  <Polygon>"), std::string::npos) << "the rings lie on both sides";
}

// ------------------------------------------------------------------------------------------------------ real readers
/// Readers that others use: `./dev readers` installs them into build/readers.
TEST(FilesForOthers, RealReadersReadPathsTimesAndHits) {
  const std::string readers = PHYSIM_SOURCE_DIR "/build/readers", tests = PHYSIM_SOURCE_DIR "/tests/readers/";
  const bool has_node = std::filesystem::exists(readers + "/node_modules/@cesium/engine");
  const bool has_python = std::filesystem::exists(readers + "/venv/bin/python");
  if (!has_node || !has_python)
    GTEST_SKIP() << "@cesium/engine, @tmcw/togeojson, papaparse, d3-dsv or pandas are missing: ./dev readers";
  const Folder folder;
  for (const char* text : {kWall, kRocket}) {
    const Flown flown(text);
    for (const char* option : {"--csv", "--kml", "--czml", "--geojson"})
      folder.write("flight." + std::string(option).substr(2), written(text, option, {"--interval", "0.25 s"}));
    std::string facts;
    for (const auto& [time, place] : flown.corners()) {
      const Geodetic g = flown.flight.earth_frames().geodetic(place);
      facts += report::shortest(time) + " " + report::shortest(g.longitude * (180 / 3.14159265358979323846)) + " " +
               report::shortest(g.latitude * (180 / 3.14159265358979323846)) + " " + report::shortest(g.height) + " " +
               report::shortest(place.x) + " " + report::shortest(place.y) + " " + report::shortest(place.z) + "\n";
    }
    folder.write("corners", facts);
    std::string places;
    for (int i = 0; i <= 500; ++i) {
      const double time = flown.flight.duration() * i / 500;
      const Vec3d x = flown.flight.earth_frames().earth_fixed(flown.flight.at(time).position, {}).position;
      places += report::shortest(time) + " " + report::shortest(x.x) + " " + report::shortest(x.y) + " " +
                report::shortest(x.z) + "\n";
    }
    folder.write("places", places);
    const std::string name = flown.scenario.shots[0].projectile.name;
    const Ran node = run_program("/usr/bin/node", {tests + "readers.mjs", readers, folder / "flight",
                                                   folder / "corners", folder / "places", name});
    EXPECT_EQ(node.code, 0) << node.out << node.err;
    const Ran python =
        run_program(readers + "/venv/bin/python", {tests + "readers.py", folder / "flight", folder / "corners", name});
    EXPECT_EQ(python.code, 0) << python.out << python.err;
  }
}

}  // namespace physim::cli_globe_test
#endif  // PHYSIM_CLI
