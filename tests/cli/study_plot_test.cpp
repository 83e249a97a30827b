// Pictures and maps of `physim study`, as a user asks for them.
#include <cmath>

#include "cli/program.hpp"
#include "cli/throw_study.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_study_plot_test {

const std::string kThrow = throw_study(8192, R"(, "shot.azimuth = +- 1 deg")");

bool gnuplot_is_there() { return std::system("gnuplot --version >/dev/null 2>&1") == 0; }

TEST(StudyPlot, shows_impacts_inputs_and_how_figures_settle) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not there";
  const Folder folder;
  const std::string file = folder.write("throw.toml", kThrow), picture = folder / "a.svg";
  const Ran ran = physim({"study", file, "--plot", picture});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string svg = read(picture);
  for (const char* text : {"A throw: ball", "8192 shots, random, seed 1", "the first 4096 shots", "3σ", "on a target",
                           "shot.speed  ± 0.3 m/s", "hits on near [%]", "holds"})
    EXPECT_TRUE(has(svg, text)) << text;
  EXPECT_EQ(physim({"study", file, "--plot", folder / "b.png"}).code, 0);
  const Ran one = physim({"study", file, "--set", "study.targets=[]", "--set", "study.quantities=[\"along\"]", "--plot",
                          folder / "c.svg"});
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_TRUE(has(read(folder / "c.svg"), "mean along [m]"));
}

TEST(StudyPlot, shows_hits_over_range) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not there";
  const Folder folder;
  const std::string file = folder.write("throw.toml", kThrow), picture = folder / "a.svg";
  const Ran ran = physim({"study", file, "--ranges", "20 m .. 60 m step 20 m", "--plot", picture, "--target",
                          "wall: rectangle 100 m x 100 m"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* text : {"A throw: ball", "wall 100 %", "R95", "range [m]"})
    EXPECT_TRUE(has(read(picture), text)) << text;
}

TEST(StudyPlot, shows_hits_over_inputs) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not there";
  const Folder folder;
  const std::string file = folder.write("throw.toml", kThrow), picture = folder / "a.svg";
  const Ran ran = physim({"study", file, "--over-inputs", "10", "--plot", picture});
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* text :
       {"A throw: ball", "shot.speed += [m/s]", "shot.azimuth += [rad]", "near", "equally likely parts"})
    EXPECT_TRUE(has(read(picture), text)) << text;
}

TEST(StudyPlot, shows_places_and_histograms) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not there";
  const Folder folder;
  const std::string file = folder.write("throw.toml", kThrow);
  const Ran ran = physim({"study", file, "--plot", folder / "a.svg", "--at", "apex", "--at", "20 m", "--at", "40 m"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(read(folder / "a.svg"), "along [m]"));
  EXPECT_TRUE(has(read(folder / "a-at-1.svg"), "A throw: ball, at apex"));
  EXPECT_TRUE(has(read(folder / "a-at-3.svg"), "A throw: ball, at 40 m"));
  EXPECT_TRUE(has(read(folder / "a-ranges.svg"), "range [m]"));
  const Ran bars = physim({"study", file, "--plot", folder / "b.svg", "--histograms", "30"});
  ASSERT_EQ(bars.code, 0) << bars.err;
  for (const char* text : {"A throw: ball", "along [m]", "speed [m/s]", "radius.centre [m]", "bars of one width"})
    EXPECT_TRUE(has(read(folder / "b.svg"), text)) << text;
  const Ran both = physim({"study", file, "--plot", folder / "c.svg", "--histograms", "30", "--over-inputs", "4"});
  ASSERT_EQ(both.code, 0) << both.err;
  EXPECT_TRUE(has(read(folder / "c.svg"), "equally likely parts"));
  EXPECT_TRUE(has(read(folder / "c-histograms.svg"), "bars of one width"));
}

TEST(StudyPlot, a_missing_gnuplot_is_named_with_its_package) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", kThrow);
  const Ran ran = physim({"study", file, "--plot", folder / "a.png"}, {"PATH=" + (folder / "empty")});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(has(ran.err, "apt-get install gnuplot-nox")) << ran.err;
}

/// 90 m to the north of the equator: 90 m over the meridian's radius of curvature there, a (1 - e^2) = 6335439 m.
TEST(StudyPlot, maps_lie_where_shots_come_down) {
  const File file("throw.toml", kThrow);
  const Ran ran = physim({"study", file, "--set", "shot.fidelity.earth=ellipsoid", "--set", "study.targets=[]", "--set",
                          "environment.earth.rotation_rate=0", "--kml", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* text : {"<name>A throw: ball</name>", "mean impact", "3 deviations", "zone that holds", "</kml>"})
    EXPECT_TRUE(has(ran.out, text)) << text;
  const std::size_t at = ran.out.find("<coordinates>", ran.out.find("mean impact"));
  ASSERT_NE(at, std::string::npos);
  double longitude = 0, latitude = 0;
  ASSERT_EQ(std::sscanf(ran.out.c_str() + at, "<coordinates>%lf,%lf,0<", &longitude, &latitude), 2);
  EXPECT_NEAR(longitude * 6378137 * 3.14159265358979 / 180, 0, 0.1) << "standard error 0.02 m";
  EXPECT_NEAR(latitude * 6335439 * 3.14159265358979 / 180, 90, 0.2);
}

TEST(StudyPlot, bad_input_says_what_is_wrong) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", kThrow);
  const auto refusal = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"study", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = physim(arguments);
    EXPECT_EQ(ran.code, 2) << ran.out;
    return ran.err;
  };
  EXPECT_TRUE(has(refusal({"--plot", folder / "a.pdf"}), ".png or .svg"));
  EXPECT_TRUE(has(refusal({"--kml", "-"}), "flat Earth"));
  EXPECT_TRUE(has(refusal({"--kml", "-", "--range", "20 m"}), "come down on the ground"));
  EXPECT_TRUE(has(refusal({"--kml", "-", "--ranges", "20 m"}), "--kml"));
  EXPECT_TRUE(has(refusal({"--shards", "1/2", "--resume", folder / "x", "--plot", folder / "a.png"}), "--shards"));
  const std::string quantity = refusal({"--set", "study.quantities=[\"hight\"]"});
  EXPECT_TRUE(has(quantity, "study.quantities[0]") && has(quantity, "right")) << quantity;
}

}  // namespace physim::testing_cli::cli_study_plot_test
#endif
