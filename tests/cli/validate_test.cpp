// `physim validate`, as a user runs it.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#ifdef PHYSIM_CLI

namespace cli_validate_test {
namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string text;  // stdout, then stderr
};

/// Runs `physim validate ARGUMENTS`.
Outcome validate(const std::string& arguments) {
  const std::string errors = testing::TempDir() + "/validate_stderr_" + std::to_string(getpid());
  const std::string command = std::string("\"") + PHYSIM_CLI + "\" validate " + arguments + " 2>\"" + errors + "\"";
  Outcome outcome;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer;
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    outcome.text.append(buffer.data(), n);
  outcome.code = WEXITSTATUS(pclose(pipe));
  std::stringstream text;
  text << std::ifstream(errors).rdbuf();
  outcome.text += text.str();
  fs::remove(errors);
  return outcome;
}

/// A folder with one file, gone at the end of the test.
class Folder {
 public:
  Folder(const std::string& file, const std::string& content)
      : path_(fs::path(testing::TempDir()) / ("validate_" + std::to_string(getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
    add(file, content);
  }
  ~Folder() { fs::remove_all(path_); }
  void add(const std::string& file, const std::string& content) const { std::ofstream(path_ / file) << content; }
  [[nodiscard]] std::string option() const { return "--data \"" + path_.string() + "\""; }
  [[nodiscard]] fs::path operator/(const std::string& file) const { return path_ / file; }

 private:
  fs::path path_;
};

bool contains(const Outcome& outcome, const std::string& part) { return outcome.text.find(part) != std::string::npos; }

const std::string kParabola = "# g=9.80665\nv0_m_s,elev_deg,range_m\n";

TEST(Validate, EverySuitePassesAtItsGates) {
  for (const char* suite : {"classic", "analytic", "us76", "gravity", "ballistics", "nesc", "mccoy", "sports"}) {
    const Outcome outcome = validate(suite);
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_TRUE(contains(outcome, "all pass")) << outcome.text;
  }
}

TEST(Validate, JsonHoldsEveryFigureAndASummary) {
  const Outcome outcome = validate("us76 classic --json");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  const auto& results = json.at("results");
  ASSERT_FALSE(results.empty());
  for (const auto& row : results) {
    EXPECT_TRUE(row.at("pass"));
    EXPECT_LE(row.at("error").get<double>(), row.at("gate").get<double>());
    for (const char* key : {"suite", "case", "figure", "expected", "actual"}) EXPECT_TRUE(row.contains(key)) << key;
  }
  EXPECT_EQ(json.at("summary").at("figures"), results.size());
  EXPECT_EQ(json.at("summary").at("missed"), 0);
  EXPECT_EQ(json.at("summary").at("suites").size(), 2u);
}

TEST(Validate, NescTellsWhereEveryCaseEndsAndHowFarOthersLie) {
  const std::string header = "case,nasa_sim,t_s,altitude_m,yaw_deg\n";
  const Folder folder("nasa_sims_final.csv", header + "06,01,30,4963.5,\n06,02,30,4963.4984469165592,0\n");
  folder.add("case06.csv", "t_s,altitude_m\n30,4963.4984469165592\n");
  const Outcome outcome = validate("nesc --json " + folder.option());
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  ASSERT_EQ(json.at("states").size(), 10u);  // judged or not
  for (const char* column : {"t_s", "altitude_m", "latitude_deg", "longitude_deg", "v_north_m_s", "v_east_m_s",
                             "v_down_m_s", "yaw_deg", "pitch_deg", "roll_deg", "p_deg_s", "q_deg_s", "r_deg_s"})
    EXPECT_TRUE(json.at("states")[4].at(column).is_number()) << column;
  EXPECT_NEAR(json.at("beside")[0].at("altitude_m").get<double>(), 0.0015530834408, 1e-6);
  EXPECT_TRUE(json.at("beside")[0].at("yaw_deg").is_null());
  EXPECT_NEAR(json.at("beside")[1].at("yaw_deg").get<double>(), 0, 1e-9);
}

TEST(Validate, McCoyNamesWhatItCannotRead) {
  const Folder folder("converged_6dof.csv", "case,twist,launch,range_m\nm1 charge1 QE45,18 cal,0 rad/s,100\n");
  folder.add("physical_and_published_results.csv",
             "case,quantity,value,unit\nm1,mass,15,kg\nm1,diameter,105,mm\nm1,v0 charge 1,205,parsec\n");
  folder.add("m1_aero.csv", "coef,mach,alpha2_deg2,value\nCD0,0,,0.1\n");
  EXPECT_TRUE(contains(validate("mccoy " + folder.option()), "physical_and_published_results.csv:4"));
  folder.add("m1_aero.csv", "coef,mach,alpha2_deg2,value\nCXX,0,,0.1\n");
  EXPECT_TRUE(contains(validate("mccoy " + folder.option()), "m1_aero.csv:2"));
}

TEST(Validate, AMissedGateIsExitCode1) {
  const Folder folder("vacuum_parabola.csv", kParabola + "10,45,10.198\n");
  const Outcome outcome = validate("analytic " + folder.option());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome, "MISSED")) << outcome.text;
  const auto json = nlohmann::json::parse(validate("analytic --json " + folder.option()).text);
  EXPECT_EQ(json.at("summary").at("pass"), false);
}

TEST(Validate, DataMayBeTheSuiteFolderOrItsParent) {
  const Folder folder("vacuum_parabola.csv", kParabola + "10,45,10.197162129779282426\n");
  EXPECT_EQ(validate("analytic " + folder.option()).code, 0);
  EXPECT_EQ(validate(folder.option()).code, 0);  // the suites that are there
  fs::create_directories(folder / "analytic");
  fs::rename(folder / "vacuum_parabola.csv", folder / "analytic/vacuum_parabola.csv");
  EXPECT_EQ(validate("analytic " + folder.option()).code, 0);
  EXPECT_EQ(validate("us76 " + folder.option()).code, 2);
}

TEST(Validate, UnknownColumnsEmptyFieldsAndUnknownCasesAreSkipped) {
  const Folder folder("vacuum_parabola.csv",
                      "# words\nextra,range_m,elev_deg,v0_m_s,apex_m\nx,10.197162129779282426,45,10,\n");
  folder.add("spinning_plates.csv", "t_s,p_deg_s\n0,10\n");
  const Outcome outcome = validate("analytic " + folder.option());
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_TRUE(contains(outcome, "skipped: spinning_plates.csv: no case of this name")) << outcome.text;
}

TEST(Validate, MalformedTablesNameFileAndLine) {
  const struct {
    const char* content;
    const char* message;
  } bad[] = {
      {"v0_m_s,elev_deg,range_m\n10,45,10.2\n10,4x5,10\n",
       "vacuum_parabola.csv:3: error: \"4x5\" in column \"elev_deg\""},
      {"v0_m_s,elev_deg\n10,45,10.2\n", "vacuum_parabola.csv:2: error: 3 fields; the header has 2 columns"},
      {"# nothing\nv0_m_s,range_m\n10,10.2\n", "vacuum_parabola.csv:2: error: no column \"elev_deg\""},
      {"v0_m_s,elev_deg\n,45\n", "vacuum_parabola.csv:2: error: column \"v0_m_s\" needs a number"},
      {"", "vacuum_parabola.csv:1: error: no header line"},
  };
  for (const auto& [content, message] : bad) {
    const Folder folder("vacuum_parabola.csv", content);
    const Outcome outcome = validate("analytic " + folder.option());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(contains(outcome, message)) << outcome.text;
  }
}

TEST(Validate, ScenariosAreJudgedByWhatTheyExpect) {
  const std::string shot = "physim = 1\nsource = \"Galilei\"\n[[shot]]\nspeed = \"10 m/s\"\nfidelity = \"arcade\"\n";
  const auto fall = [](const char* time) {
    return "[[expect]]\nquantity = \"time\"\nequals = \"" + std::string(time) + "\"\nwithin = \"1 us\"\n";
  };
  const Folder folder("lob.toml", shot + "elevation = \"90 deg\"\n" + fall("2.03943243 s"));  // 2 v / g
  const Outcome met = validate("ballistics --all " + folder.option());
  EXPECT_EQ(met.code, 0) << met.text;
  EXPECT_TRUE(contains(met, "lob")) << met.text;
  EXPECT_TRUE(contains(met, "time_s")) << met.text;
  folder.add("lob.toml", shot + "elevation = \"90 deg\"\n" + fall("2.1 s"));
  EXPECT_EQ(validate("ballistics " + folder.option()).code, 1);
  folder.add("lob.toml", shot + fall("2.1 parsec"));
  const Outcome bad = validate("ballistics " + folder.option());
  EXPECT_EQ(bad.code, 2);
  EXPECT_TRUE(contains(bad, "lob.toml:8:")) << bad.text;
}

TEST(Validate, BadArgumentsAreExitCode2) {
  EXPECT_EQ(validate("clasic").code, 2);
  EXPECT_TRUE(contains(validate("clasic"), "there are: classic, analytic, us76, gravity, ballistics"));
  EXPECT_EQ(validate("--data /no/such/folder").code, 2);
  EXPECT_EQ(validate("--report /no/such/folder/report.md").code, 2);
}

const std::string kOriginal = "test,printed_t_s,frame,x,y,z,vx,vy,vz,ax,ay,az,speed,mass,misprints\n";
const std::string kShell = "5,0.8,49,0,3.024244,31.328224,0,13.495668,37,0,-20,0,39.104736,200,";

TEST(Validate, MisprintsAreNamedAndComparedAsWhatShouldStandThere) {
  const Folder folder("tables.csv",
                      kOriginal + kShell +
                          "y=-3.024244 sign lost; vy=-13.495668 sign lost; vz=36.702145 rounded to a whole number\n"
                          "9,0,1,0,0,0,0,0,0,0,0,0,0,0,\n");
  const Outcome outcome = validate("classic " + folder.option());
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_TRUE(contains(outcome, "skipped: test 9")) << outcome.text;
  EXPECT_TRUE(contains(outcome, "3 of the published figures are misprints")) << outcome.text;
  EXPECT_TRUE(contains(validate("classic --all " + folder.option()), "vz by speed frame 49"));
  const auto misprints = nlohmann::json::parse(validate("classic --json " + folder.option()).text).at("misprints");
  ASSERT_EQ(misprints.size(), 3u);
  EXPECT_EQ(misprints[1].at("figure"), "test 5, vy frame 49");
  EXPECT_EQ(misprints[1].at("printed"), "13.495668");
  EXPECT_EQ(misprints[1].at("instead"), "-13.495668");
  EXPECT_EQ(misprints[1].at("reason"), "sign lost");
}

TEST(Validate, AMisprintThatIsOnNoListIsMissed) {
  const Folder folder("tables.csv", kOriginal + kShell + "y=-3.024244 sign lost; vz=36.702145 rounded\n");
  const Outcome outcome = validate("classic --all " + folder.option());
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  EXPECT_TRUE(contains(outcome, "1 MISSED")) << outcome.text;
}

TEST(Validate, ListsOfMisprintsAreChecked) {
  const struct {
    std::string row;
    const char* message;
  } bad[] = {
      {kShell + "z=31.328225 a digit wrong",
       "tables.csv:2: error: column \"z\" is no misprint: it was flown as printed"},
      {kShell + "vy sign lost", "tables.csv:2: error: \"vy sign lost\" is no misprint; as in"},
      {kShell + "vy=-13.495668", "tables.csv:2: error: \"vy=-13.495668\" is no misprint; as in"},
      {kShell + "vy=minus sign lost", "tables.csv:2: error: \"minus\" of a misprint is not a number"},
      {kShell + "w=1 new", "tables.csv:2: error: column \"w\" of a misprint is none of the table"},
      {kShell + "y=1 one; y=2 two", "tables.csv:2: error: column \"y\" is misprinted twice"},
      {"5,0.8,49,0,3.024244,,0,13.495668,37,0,-20,0,39.104736,200,", "column \"z\" needs a number"},
  };
  for (const auto& [row, message] : bad) {
    const Folder folder("tables.csv", kOriginal + row + "\n");
    const Outcome outcome = validate("classic " + folder.option());
    EXPECT_EQ(outcome.code, 2) << message;
    EXPECT_TRUE(contains(outcome, message)) << outcome.text;
  }
  const Folder folder("tables.csv", "test,frame,x,y,z,vx,vy,vz\n4,0,0,1.5,0,0,1,35\n");
  EXPECT_TRUE(contains(validate("classic " + folder.option()), "no column \"ax\""));
}

TEST(Validate, ReportIsWrittenAndSaysHowItWasMade) {
  const Folder folder("vacuum_parabola.csv", kParabola + "10,45,10.197162129779282426\n");
  const std::string report = (folder / "report.md").string();
  ASSERT_EQ(validate("analytic " + folder.option() + " --report \"" + report + "\"").code, 0);
  std::stringstream text;
  text << std::ifstream(report).rdbuf();
  EXPECT_NE(text.str().find("Made by `physim validate analytic --data "), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("| vacuum_parabola closed_form |"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("- `vacuum_parabola.csv`: g=9.80665"), std::string::npos) << text.str();
}

}  // namespace cli_validate_test

#endif  // PHYSIM_CLI
