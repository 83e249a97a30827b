// The table of formats: each row does what it says, and a row with a function is all that a format needs.
#include "report/format.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "physim/scenario.hpp"
#include "report/kml.hpp"
#include "report/pictures.hpp"

namespace physim::report::report_format_test {

constexpr const char* kRoundShot =
    "physim = 1\n[[shot]]\nname = \"a, b\"\nmass = \"1 kg\"\ndiameter = \"5 cm\"\nspeed = \"100 m/s\"\n"
    "elevation = \"20 deg\"\nfidelity = { preset = \"simulation\", earth = \"ellipsoid\" }\n";
constexpr const char* kWorld =
    "physim = 1\n[world]\nduration = \"1 s\"\n[[shot]]\nname = \"ball\"\nmass = \"1 kg\"\ndiameter = \"5 cm\"\n"
    "speed = \"10 m/s\"\nfidelity = \"game\"\n";

/// A result of each kind.
struct Results {
  FlownScenario flown{.scenario = parse_scenario(kRoundShot, "round.toml").value(), .shots = {}, .checks = {}};
  SampleTimes times;
  Scenario scenario = parse_scenario(kWorld, "world.toml").value();
  std::optional<WorldLog> world;
  Ladder ladder{.shot = "ball"};
  std::optional<ReplayLog> replay;

  Results() {
    EXPECT_TRUE(fly_all(flown).ok());
    times = sample_times(flown.shots, 0.5).value();
    const std::string file =
        testing::TempDir() + "physim_format_" + std::to_string(getpid()) + ".rec";  // tests run at once
    world = run_world(scenario, {.parts = {true, true, true, true}, .record = file}).value();
    const Flight& flight = flown.shots[0].flight;
    ladder.rungs.push_back({{Family::preset, "reference", "", {}}, flight, "", 0, 0, 1e-6});
    replay = play_recording(file, {}).value();
    std::filesystem::remove(file);
  }
  [[nodiscard]] Content content(const Format& format, Subject subject) const {
    const Flights flights{flown, times};
    switch (subject) {
      case Subject::flights: return content_of(format, flights);
      case Subject::world: return content_of(format, *world);
      case Subject::ladder: return content_of(format, LadderOfShot{scenario, ladder});
      case Subject::replay: return content_of(format, *replay);
      case Subject::records: return content_of(format, records_of(flights));
    }
    return as_text("");
  }
};

constexpr Subject kSubjects[] = {Subject::flights, Subject::world, Subject::ladder, Subject::replay, Subject::records};

TEST(Formats, RowsAreComplete) {
  std::set<std::string_view> names;
  for (const Format& format : formats()) {
    EXPECT_TRUE(!format.name.empty() && names.insert(format.name).second) << format.name << " is there twice";
    EXPECT_NE(format.ending.find('.'), std::string_view::npos) << format.name;
    EXPECT_TRUE(format.doc.starts_with("as ")) << format.name;
    EXPECT_TRUE(std::ranges::any_of(kSubjects, [&](Subject s) { return can_write(format, s); })) << format.name;
    const bool shows_worlds = can_write(format, Subject::world);
    const LogParts& parts = format.world_parts;
    EXPECT_TRUE(!shows_worlds || parts.samples || parts.events || parts.paths || parts.hits)
        << format.name << " reads nothing";
  }
}

TEST(Formats, EachWritesEverySubjectThatItCan) {
  const Results results;
  for (const Format& format : formats())
    for (const Subject subject : kSubjects) {
      if (!can_write(format, subject)) continue;
      const Content content = results.content(format, subject);
      const auto* picture = std::get_if<Picture>(&content);
      EXPECT_EQ(picture != nullptr, format.is_picture) << format.name;
      const std::string text = picture != nullptr ? picture->script : whole(std::get<Text>(content));
      EXPECT_GT(text.size(), 20U) << format.name;
      EXPECT_EQ(text.back(), '\n') << format.name;
    }
}

/// A format for this test alone: the numbers of each row, a line each.
Text numbers_text(Records records) {
  return [records = std::move(records)](const Sink& sink) {
    records.rows([&](Row row) {
      for (const Cell& cell : row)
        if (const auto* number = std::get_if<double>(&cell)) sink(std::to_string(*number) + " ");
      sink("\n");
    });
  };
}

TEST(Formats, ARowAndAFunctionAreAllThatAFormatNeeds) {
  constexpr Format kNumbers{.name = "numbers", .ending = ".txt", .doc = "as numbers", .records = numbers_text};
  const Results results;
  for (const Subject subject : kSubjects) {
    ASSERT_TRUE(can_write(kNumbers, subject));
    const std::string text = whole(std::get<Text>(results.content(kNumbers, subject)));
    EXPECT_GT(std::ranges::count(text, '\n'), 0);
    EXPECT_NE(text.find_first_of("0123456789"), std::string::npos);
  }
}

TEST(Formats, EndingsTellTheFormat) {
  EXPECT_EQ((*format_of_file("a/b.csv", Subject::records))->name, "csv");
  EXPECT_EQ((*format_of_file("b.json", Subject::ladder))->name, "json");
  EXPECT_EQ((*format_of_file("b.svg", Subject::flights))->name, "plot");
  EXPECT_EQ((*format_of_file("b.kml", Subject::flights))->name, "kml");
  const auto unable = format_of_file("b.kml", Subject::records);
  ASSERT_FALSE(unable);
  EXPECT_TRUE(unable.error().hint.starts_with("it may end with .csv")) << unable.error().hint;
  EXPECT_EQ(unable.error().hint.find(".kml"), std::string::npos);
}

TEST(Formats, GlobesNeedARoundEarth) {
  const Results results;
  Scenario flat = results.scenario;
  FlownScenario flown{.scenario = flat, .shots = {}, .checks = {}};
  ASSERT_TRUE(fly_all(flown).ok());
  for (const Format& format : formats()) {
    if (format.check == nullptr) continue;
    EXPECT_TRUE(format.check(results.flown).ok()) << format.name;
    EXPECT_FALSE(format.check(flown).ok()) << format.name;
  }
}

TEST(Formats, PicturesMarkWhereFlightsHit) {
  const std::string wall =
      "[[shape]]\nname = \"a\"\nbox = [1, 50, 50]\n[[thing]]\nshape = \"a\"\nposition = [81, 0, 0]\n";
  const std::string text =
      "physim = 1\n[[shot]]\nspeed = 100\nelevation = \"10 deg\"\nfidelity = \"arcade\"\n[[shot]]\nspeed = 10\n";
  FlownScenario flown{.scenario = parse_scenario(text + wall, "wall.toml").value(), .shots = {}, .checks = {}};
  ASSERT_TRUE(fly_all(flown).ok());
  ASSERT_EQ(flown.hits.size(), 1U);
  const std::string script = shots_picture("", flown.shots).script;
  EXPECT_NE(script.find("$shot0hits << EndOfData\n80 "), std::string::npos) << script.substr(0, 500);
  EXPECT_NE(script.find("$shot0hits using 1:2 with points"), std::string::npos);
  EXPECT_EQ(script.find("$shot1hits"), std::string::npos) << "it comes down before";
}

TEST(Formats, PicturesShowWhatWasPublishedAndWhatIsExpected) {
  const std::string text = R"(physim = 1
[[shot]]
name = "ball"
body = { colour = 0xE69F00FF }
speed = 10
fidelity = "arcade"
[[expect]]
at = { time = "0.5 s" }
quantity = "vx"
equals = 25
within = 1
published = true
[[expect]]
shot = "ball"
at = { time = "0.25 s" }
quantity = "ay"
equals = -9
within = 1
[[expect]]
quantity = "x"
equals = 20
within = 1
)";
  FlownScenario flown{.scenario = parse_scenario(text, "ball.toml").value(), .shots = {}, .checks = {}};
  ASSERT_TRUE(fly_all(flown).ok());
  const std::string script = shots_picture("", flown.shots, nullptr, flown.scenario.expect).script;
  const auto has = [&script](const std::string& part) { return script.find(part) != std::string::npos; };
  EXPECT_TRUE(has("$rings5 << EndOfData\n0.5 25\n")) << "column 5 is vx";
  EXPECT_TRUE(has("$rings5 using 1:2 with points pt 6 "));
  EXPECT_TRUE(has("$crosses9 << EndOfData\n0.25 -9\n")) << "column 9 is ay";
  EXPECT_TRUE(has("$crosses9 using 1:2 with points pt 1 "));
  EXPECT_FALSE(has("$crosses2")) << "x is expected at the end, not at a time";
  for (const char* entry : {"'published'", "'expected'", "'computed'", "lc rgb '#E69F00'"}) EXPECT_TRUE(has(entry));
  EXPECT_TRUE(has("set yrange [8.95:26.05]")) << "the ring lies in its panel";
  const std::string plain = shots_picture("", flown.shots).script;
  EXPECT_EQ(plain.find("published"), std::string::npos);
  EXPECT_EQ(plain.find("$rings"), std::string::npos);
}

TEST(Formats, PicturesTellWhereALegendHasNoRoomForAll) {
  const auto script_of = [](int shots) {
    std::string text = kWorld;
    for (int i = 0; i < shots; ++i)
      text +=
          "[[shot]]\nname = \"a shot with a long name, " + std::to_string(i) + "\"\nspeed = 20\nfidelity = \"game\"\n";
    const auto log = run_world(parse_scenario(text, "many.toml").value(), {.parts = {.paths = true}, .record = ""});
    return std::get<Picture>(world_picture(log.value())).script;
  };
  const std::string few = script_of(2), many = script_of(20);
  EXPECT_NE(few.find("set label 'a shot with a long name, 1'"), std::string::npos);
  EXPECT_EQ(few.find("set label '...'"), std::string::npos);
  EXPECT_NE(many.find("set label 'a shot with a long name, 1'"), std::string::npos);
  EXPECT_EQ(many.find("set label 'a shot with a long name, 19'"), std::string::npos);
  EXPECT_NE(many.find("set label '...'"), std::string::npos);
}

TEST(Records, CsvQuotesWhatNeedsIt) {
  const Results results;
  const std::string text = whole(csv_text(records_of(Flights{results.flown, results.times})));
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with("shot,t [s],x [m]"));
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with("\"a, b\",0,0,0,0,")) << line;
}

TEST(Records, CsvDoublesQuotes) {
  const Records records{{"name", "count"}, [](const auto& take) {
                          const Cell row[] = {std::string_view("\"b\"\nc"), std::uint64_t{3}};
                          take(row);
                        }};
  EXPECT_EQ(whole(csv_text(records)), "name,count\n\"\"\"b\"\"\nc\",3\n");
}

constexpr double kOneDegree = 3.14159265358979323846 / 180;

double area_of(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    twice += ring[i].longitude * ring[i + 1].latitude - ring[i + 1].longitude * ring[i].latitude;
  return std::abs(twice) / 2;
}

TEST(FilesForOthers, RingsAreCutAtTheAntimeridian) {
  Ring ring;
  for (int i = 0; i <= 36; ++i) {
    const double angle = i % 36 * 10 * kOneDegree, longitude = 179.5 + 2 * std::cos(angle);
    ring.push_back({longitude > 180 ? longitude - 360 : longitude, 10 + std::sin(angle)});
  }
  const auto parts = cut_at_antimeridian(ring);
  ASSERT_EQ(parts.size(), 2U);
  double area = 0;
  for (const Ring& part : parts) {
    EXPECT_EQ(part.front().longitude, part.back().longitude);
    EXPECT_EQ(part.front().latitude, part.back().latitude);
    for (std::size_t i = 0; i < part.size(); ++i) {
      EXPECT_LE(std::abs(part[i].longitude), 180);
      EXPECT_LT(std::abs(part[i].longitude - part[0].longitude), 180);
    }
    area += area_of(part);
  }
  EXPECT_NEAR(area, 18 * 2 * std::sin(10 * kOneDegree), 1e-9) << "that of the polygon of 36 corners, 2 deg by 1 deg";
  const Ring here = {{1, 1}, {2, 1}, {2, 2}, {1, 1}};
  ASSERT_EQ(cut_at_antimeridian(here).size(), 1U);
  EXPECT_EQ(cut_at_antimeridian(here)[0].size(), 4U);
  Ring polar;  // about the north pole: the cap from 80 deg on
  for (int i = 0; i <= 12; ++i) polar.push_back({i % 12 * 30 > 180 ? i % 12 * 30 - 360.0 : i % 12 * 30, 80});
  double cap = 0;
  for (const Ring& part : cut_at_antimeridian(polar)) cap += area_of(part);
  EXPECT_NEAR(cap, 360 * 10, 1e-9);
}

}  // namespace physim::report::report_format_test
