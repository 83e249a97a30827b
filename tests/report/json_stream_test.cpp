// JSON and other texts that are written piece by piece: as a whole tree would be, however many shots there are.
#include "report/json_stream.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include "report/file.hpp"
#include "report/format.hpp"
#include "report/json.hpp"

namespace physim::report::report_json_stream_test {

using Json = nlohmann::ordered_json;

TEST(JsonStream, writes_what_a_tree_would) {
  Json tree = {{"empty list", Json::array()}, {"empty object", Json::object()}, {"bad text", "\xff\"\n"}};
  Json many = Json::array();
  for (int i = 0; i < 1000; ++i) many.push_back({{"i", i}, {"x", {0.1 * i, -0.0, NAN, Json::array()}}});
  tree["many"] = many;
  for (int i = 0; i < 300; ++i) tree["key " + std::to_string(i)] = i;
  const std::string text = whole([&](const Sink& sink) {
    JsonStream out(sink);
    out.object();
    out.list("empty list"), out.close();
    out.object("empty object"), out.close();
    out.add({{"bad text", "\xff\"\n"}});
    out.list("many");
    for (const Json& each : many) {
      if (each["i"] == 500) {  // one of them member by member
        out.object();
        out.add({{"i", 500}});
        out.list("x");
        for (const Json& x : each["x"]) out.push(x);
        out.close(), out.close();
      } else {
        out.push(each);
      }
    }
    out.close();
    for (int i = 0; i < 300; ++i) out.add({{"key " + std::to_string(i), i}});
    out.close();
  });
  EXPECT_EQ(text, json_text(tree));
}

TEST(JsonStream, columns_are_lists) {
  const Records records{{"a", "b", "c"}, [](const auto& take) {
                          for (std::uint64_t i = 0; i < 100; ++i) {
                            const Cell row[] = {std::string_view("x"), 0.5 * static_cast<double>(i), i};
                            take(row);
                          }
                        }};
  const Json json = Json::parse(whole(columns_json(records)));
  EXPECT_EQ(json["a"], Json(std::vector<std::string>(100, "x")));
  std::vector<int> counted(100);
  std::iota(counted.begin(), counted.end(), 0);
  EXPECT_EQ(json["c"], Json(counted));
  EXPECT_EQ(json["b"].at(99), 49.5);
}

/// Flights and a world, each with very many events or samples.
struct Many {
  FlownScenario flown{
      .scenario = parse_scenario("physim = 1\n[[shot]]\nname = \"a\"\nspeed = \"300 m/s\"\nelevation = \"60 deg\"\n"
                                 "fidelity = { preset = \"artillery\", earth = \"ellipsoid\" }\n"
                                 "[[shot]]\nname = \"b\"\nspeed = \"20 m/s\"\nelevation = \"1 rad\"\n"
                                 "fidelity = { earth = \"ellipsoid\" }\n"
                                 "[[expect]]\nquantity = \"range\"\nequals = \"1 m\"\nwithin = \"1 m\"\n",
                                 "two.toml")
                      .value(),
      .shots = {},
      .checks = {}};
  SampleTimes times;
  Scenario scenario = parse_scenario(
                          "physim = 1\n[world]\nduration = \"2 s\"\n[[shot]]\nname = \"ball\"\nposition = [0, 100, 0]\n"
                          "speed = \"10 m/s\"\nfidelity = \"game\"\n"
                          "[[volley]]\nshot = \"ball\"\ncount = 5000\nrate = \"4000 Hz\"\n"
                          "[[shape]]\nsphere = 5\n"
                          "[[thing]]\nshape = \"shape-1\"\nposition = [10, 97, 0]\nsensor = true\n",
                          "many.toml")
                          .value();
  std::optional<WorldLog> world;

  Many() {
    EXPECT_TRUE(fly_all(flown).ok());
    times = sample_times(flown.shots, 0.01).value();
    world = run_world(scenario, {.parts = {true, true, true, true}}).value();
  }
  [[nodiscard]] std::vector<Text> texts() const {
    std::vector<Text> all;
    for (const Format& format : formats()) {
      if (format.is_picture) continue;
      if (can_write(format, Subject::flights)) all.push_back(std::get<Text>(content_of(format, Flights{flown, times})));
      if (can_write(format, Subject::world)) all.push_back(std::get<Text>(content_of(format, *world)));
    }
    return all;
  }
};

TEST(Texts, every_json_is_what_its_tree_would_be) {
  const Many many;
  int of_json = 0;
  for (const Text& text : many.texts()) {
    const std::string all = whole(text);
    const Json tree = Json::parse(all, nullptr, false);
    if (tree.is_discarded()) continue;
    ++of_json;
    EXPECT_TRUE(all == json_text(tree)) << all.substr(0, 400);
  }
  EXPECT_EQ(of_json, 6);  // flights and a world, each as JSON, CZML and GeoJSON
}

TEST(Texts, are_handed_over_in_small_pieces) {
  const Many many;
  int without_rows = 0;
  for (const Text& text : many.texts()) {
    std::size_t largest = 0, all = 0, once = 0;
    text([&](std::string_view piece) { largest = std::max(largest, piece.size()), all += piece.size(); });
    text([&](std::string_view piece) { once += piece.size(); });
    EXPECT_LT(largest, std::size_t{1} << 16);
    if (all < 300)
      ++without_rows;
    else
      EXPECT_GT(all, 3 * largest);
    EXPECT_EQ(once, all) << "a text that is written twice differs";
  }
  EXPECT_EQ(without_rows, 1) << "the hits of flights that meet nothing";
}

TEST(Texts, of_a_file_that_fails_leave_what_was_there) {
  const Text endless = [](const Sink& sink) {
    for (int i = 0; i < 1000; ++i) sink(std::string(1000, 'x'));
  };
  const Status full = write_file("/dev/full", endless);
  ASSERT_FALSE(full.ok());
  EXPECT_NE(full.error().message.find("No space left"), std::string::npos);

  const std::string path = testing::TempDir() + "physim_stream_" + std::to_string(getpid()) + ".txt";
  ASSERT_TRUE(write_file(path, "before").ok());
  bool stood = false;
  ASSERT_TRUE(write_file(path, [&](const Sink& sink) {
                endless(sink);
                std::ifstream old(path);
                stood = std::string(std::istreambuf_iterator<char>(old), {}) == "before";
              }).ok());
  EXPECT_TRUE(stood) << "the old file went before the new one was whole";
  EXPECT_EQ(std::filesystem::file_size(path), 1'000'000u);
  std::filesystem::remove(path);
}

}  // namespace physim::report::report_json_stream_test
