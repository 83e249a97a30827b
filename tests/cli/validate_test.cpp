// `physim validate`, as a user runs it.
#include "cli/program.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_validate_test {

Ran validate(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "validate");
  return physim(arguments);
}
bool contains(const Ran& ran, const std::string& part) { return has(ran.out + ran.err, part); }
/// With the figures of a folder.
Ran validate(std::vector<std::string> arguments, const Folder& data) {
  arguments.insert(arguments.end(), {"--data", data / ""});
  return validate(arguments);
}

const std::string kParabola = "# g=9.80665\nv0_m_s,elev_deg,range_m\n";

TEST(Validate, EverySuitePassesAtItsGates) {
  for (const char* suite : {"classic", "analytic", "us76", "gravity", "ballistics", "nesc", "mccoy", "sports"}) {
    const Ran outcome = validate({suite});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_TRUE(contains(outcome, "all pass")) << outcome.out << outcome.err;
  }
}

TEST(Validate, JsonHoldsEveryFigureAndASummary) {
  const Ran outcome = validate({"us76", "classic", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
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
  const Folder folder;
  folder.write("nasa_sims_final.csv", header + "06,01,30,4963.5,\n06,02,30,4963.4984469165592,0\n");
  folder.write("case06.csv", "t_s,altitude_m\n30,4963.4984469165592\n");
  const Ran outcome = validate({"nesc", "--json"}, folder);
  ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json.at("states").size(), 10u);  // judged or not
  for (const char* column : {"t_s", "altitude_m", "latitude_deg", "longitude_deg", "v_north_m_s", "v_east_m_s",
                             "v_down_m_s", "yaw_deg", "pitch_deg", "roll_deg", "p_deg_s", "q_deg_s", "r_deg_s"})
    EXPECT_TRUE(json.at("states")[4].at(column).is_number()) << column;
  EXPECT_NEAR(json.at("beside")[0].at("altitude_m").get<double>(), 0.0015530834408, 1e-6);
  EXPECT_TRUE(json.at("beside")[0].at("yaw_deg").is_null());
  EXPECT_NEAR(json.at("beside")[1].at("yaw_deg").get<double>(), 0, 1e-9);
}

TEST(Validate, McCoyNamesWhatItCannotRead) {
  const Folder folder;
  folder.write("converged_6dof.csv", "case,twist,launch,range_m\nm1 charge1 QE45,18 cal,0 rad/s,100\n");
  folder.write("physical_and_published_results.csv",
               "case,quantity,value,unit\nm1,mass,15,kg\nm1,diameter,105,mm\nm1,v0 charge 1,205,parsec\n");
  folder.write("m1_aero.csv", "coef,mach,alpha2_deg2,value\nCD0,0,,0.1\n");
  EXPECT_TRUE(contains(validate({"mccoy"}, folder), "physical_and_published_results.csv:4"));
  folder.write("m1_aero.csv", "coef,mach,alpha2_deg2,value\nCXX,0,,0.1\n");
  EXPECT_TRUE(contains(validate({"mccoy"}, folder), "m1_aero.csv:2"));
}

TEST(Validate, AMissedGateIsExitCode1) {
  const Folder folder;
  folder.write("vacuum_parabola.csv", kParabola + "10,45,10.198\n");
  const Ran outcome = validate({"analytic"}, folder);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome, "MISSED")) << outcome.out << outcome.err;
  const auto json = nlohmann::json::parse(validate({"analytic", "--json"}, folder).out);
  EXPECT_EQ(json.at("summary").at("pass"), false);
}

TEST(Validate, DataMayBeTheSuiteFolderOrItsParent) {
  const Folder folder;
  folder.write("vacuum_parabola.csv", kParabola + "10,45,10.197162129779282426\n");
  EXPECT_EQ(validate({"analytic"}, folder).code, 0);
  EXPECT_EQ(validate({}, folder).code, 0);  // the suites that are there
  std::filesystem::create_directories(folder / "analytic");
  std::filesystem::rename(folder / "vacuum_parabola.csv", folder / "analytic/vacuum_parabola.csv");
  EXPECT_EQ(validate({"analytic"}, folder).code, 0);
  EXPECT_EQ(validate({"us76"}, folder).code, 2);
}

TEST(Validate, UnknownColumnsEmptyFieldsAndUnknownCasesAreSkipped) {
  const Folder folder;
  folder.write("vacuum_parabola.csv",
               "# words\nextra,range_m,elev_deg,v0_m_s,apex_m\nx,10.197162129779282426,45,10,\n");
  folder.write("spinning_plates.csv", "t_s,p_deg_s\n0,10\n");
  const Ran outcome = validate({"analytic"}, folder);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome, "skipped: spinning_plates.csv: no case of this name")) << outcome.out << outcome.err;
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
    const Folder folder;
    folder.write("vacuum_parabola.csv", content);
    const Ran outcome = validate({"analytic"}, folder);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(contains(outcome, message)) << outcome.out << outcome.err;
  }
}

TEST(Validate, ScenariosAreJudgedByWhatTheyExpect) {
  const std::string shot = "physim = 1\nsource = \"Galilei\"\n[[shot]]\nspeed = \"10 m/s\"\nfidelity = \"arcade\"\n";
  const auto fall = [](const char* time) {
    return "[[expect]]\nquantity = \"time\"\nequals = \"" + std::string(time) + "\"\nwithin = \"1 us\"\n";
  };
  const Folder folder;
  folder.write("lob.toml", shot + "elevation = \"90 deg\"\n" + fall("2.03943243 s"));  // 2 v / g
  const Ran met = validate({"ballistics", "--all"}, folder);
  EXPECT_EQ(met.code, 0) << met.out << met.err;
  EXPECT_TRUE(contains(met, "lob")) << met.out << met.err;
  EXPECT_TRUE(contains(met, "time_s")) << met.out << met.err;
  folder.write("lob.toml", shot + "elevation = \"90 deg\"\n" + fall("2.1 s"));
  EXPECT_EQ(validate({"ballistics"}, folder).code, 1);
  folder.write("lob.toml", shot + fall("2.1 parsec"));
  const Ran bad = validate({"ballistics"}, folder);
  EXPECT_EQ(bad.code, 2);
  EXPECT_TRUE(contains(bad, "lob.toml:8:")) << bad.out << bad.err;
}

TEST(Validate, BadArgumentsAreExitCode2) {
  EXPECT_EQ(validate({"clasic"}).code, 2);
  EXPECT_TRUE(contains(validate({"clasic"}), "there are: classic, analytic, us76, gravity, ballistics"));
  EXPECT_EQ(validate({"--data", "/no/such/folder"}).code, 2);
  EXPECT_EQ(validate({"--report", "/no/such/folder/report.md"}).code, 2);
}

const std::string kOriginal = "test,printed_t_s,frame,x,y,z,vx,vy,vz,ax,ay,az,speed,mass,misprints\n";
const std::string kShell = "5,0.8,49,0,3.024244,31.328224,0,13.495668,37,0,-20,0,39.104736,200,";

TEST(Validate, MisprintsAreNamedAndComparedAsWhatShouldStandThere) {
  const Folder folder;
  folder.write("tables.csv",
               kOriginal + kShell +
                   "y=-3.024244 sign lost; vy=-13.495668 sign lost; vz=36.702145 rounded to a whole number\n"
                   "9,0,1,0,0,0,0,0,0,0,0,0,0,0,\n");
  const Ran outcome = validate({"classic"}, folder);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome, "skipped: test 9")) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome, "3 of the published figures are misprints")) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(validate({"classic", "--all"}, folder), "vz by speed frame 49"));
  const auto misprints = nlohmann::json::parse(validate({"classic", "--json"}, folder).out).at("misprints");
  ASSERT_EQ(misprints.size(), 3u);
  EXPECT_EQ(misprints[1].at("figure"), "test 5, vy frame 49");
  EXPECT_EQ(misprints[1].at("printed"), "13.495668");
  EXPECT_EQ(misprints[1].at("instead"), "-13.495668");
  EXPECT_EQ(misprints[1].at("reason"), "sign lost");
}

TEST(Validate, AMisprintThatIsOnNoListIsMissed) {
  const Folder folder;
  folder.write("tables.csv", kOriginal + kShell + "y=-3.024244 sign lost; vz=36.702145 rounded\n");
  const Ran outcome = validate({"classic", "--all"}, folder);
  EXPECT_EQ(outcome.code, 1) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome, "1 MISSED")) << outcome.out << outcome.err;
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
    const Folder folder;
    folder.write("tables.csv", kOriginal + row + "\n");
    const Ran outcome = validate({"classic"}, folder);
    EXPECT_EQ(outcome.code, 2) << message;
    EXPECT_TRUE(contains(outcome, message)) << outcome.out << outcome.err;
  }
  const Folder folder;
  folder.write("tables.csv", "test,frame,x,y,z,vx,vy,vz\n4,0,0,1.5,0,0,1,35\n");
  EXPECT_TRUE(contains(validate({"classic"}, folder), "no column \"ax\""));
}

TEST(Validate, ReportIsWrittenAndSaysHowItWasMade) {
  const Folder folder;
  folder.write("vacuum_parabola.csv", kParabola + "10,45,10.197162129779282426\n");
  ASSERT_EQ(validate({"analytic", "--report", folder / "report.md"}, folder).code, 0);
  const std::string text = read(folder / "report.md");
  for (const char* part : {"Made by `physim validate analytic --data ", "| vacuum_parabola closed_form |",
                           "- `vacuum_parabola.csv`: g=9.80665"})
    EXPECT_TRUE(has(text, part)) << text;
}

}  // namespace physim::testing_cli::cli_validate_test
#endif  // PHYSIM_CLI
