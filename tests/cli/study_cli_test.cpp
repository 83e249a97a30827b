// `physim study`, as a user runs it.
#include <sys/stat.h>

#include <cmath>
#include <thread>

#include "cli/program.hpp"
#include "cli/throw_study.hpp"
#include "rifles.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_study_cli_test {

TEST(StudyCli, tells_figures_that_are_known) {
  const File file("throw.toml", throw_study(30000));
  const Ran ran = physim({"study", file, "--json", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  const auto figure = [&](const std::string& name, const char* what = "value") {
    for (const auto& each : json["figures"])
      if (each["name"] == name) return each[what].get<double>();
    ADD_FAILURE() << name << " is missing";
    return 0.0;
  };
  const double mean = (900 + 0.09) / 10, deviation = 2 * 30 * 0.3 / 10;
  EXPECT_NEAR(figure("along.mean [m]"), mean, 4 * figure("along.mean [m]", "error"));
  EXPECT_NEAR(figure("along.deviation [m]"), deviation, 0.04);
  EXPECT_NEAR(figure("hit.near"), 0.6827, 4 * figure("hit.near", "error")) << "within a deviation";
  EXPECT_NEAR(json["inputs"][0]["slope"][1].get<double>(), 6, 1e-4);

  const Ran text = physim({"study", file, "--threads", "1"});
  EXPECT_EQ(text.code, 0);
  EXPECT_TRUE(has(text.out, "32768 shots in 8 shards")) << text.out;
  EXPECT_TRUE(has(text.out, "near"));
}

/// In a vacuum a throw comes down as it went up: at its speed and angle.
TEST(StudyCli, tells_impacts) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(4096)), csv = folder / "figures.csv";
  const std::string asked =
      "study.quantities=[\"right\", \"along\", \"impact_speed\", \"obliquity\", \"impact_energy\"]";
  const Ran ran = physim({"study", file, "--set", asked, "--set", "shot.mass=200 g", "--json", "-", "--csv", csv});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  const auto figure = [&](const std::string& name) {
    for (const auto& each : json["figures"])
      if (each["name"] == name) return each["value"].get<double>();
    ADD_FAILURE() << name << " is missing";
    return 0.0;
  };
  EXPECT_EQ(json["quantities"][3], "obliquity [rad]");
  EXPECT_NEAR(figure("impact_speed.mean [m/s]"), 30, 0.02);
  EXPECT_NEAR(figure("impact_speed.deviation [m/s]"), 0.3, 0.01);
  EXPECT_NEAR(figure("obliquity.mean [rad]"), std::acos(0.0) / 2, 1e-9);
  EXPECT_NEAR(figure("impact_energy.mean [J]"), 0.1 * (900 + 0.09), 0.12);
  for (const char* head : {"impact_speed.mean [m/s],", "obliquity.quantile_0.95 [rad],", "impact_energy.most [J],"})
    EXPECT_TRUE(has(read(csv), head)) << head;
  const Ran text = physim({"study", file, "--set", asked});
  EXPECT_TRUE(has(text.out, "impact_speed [m/s]") && has(text.out, "obliquity [rad]")) << text.out;
  const Ran at_range = physim({"study", file, "--set", asked, "--set", "until.range=50 m"});
  EXPECT_EQ(at_range.code, 2);
  EXPECT_TRUE(has(at_range.err, "quantities[2]") && has(at_range.err, "until.range")) << at_range.err;
}

TEST(StudyCli, tables_stand_below_each_other) {
  const Ran ran = physim({"study", Folder().write("throw.toml", throw_study(4096)), "--set", "study.indices=true"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* head : {"right [m]  ", "distance [m]", "target", "input", "Sobol indices", "worst shot"})
    EXPECT_TRUE(has(ran.out, "\n  " + std::string(head))) << head << " in\n" << ran.out;
}

TEST(StudyCli, parts_are_joined_and_gone_on_with) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(30000)), whole = folder / "whole.csv",
                    joined = folder / "j.csv";
  ASSERT_EQ(physim({"study", file, "--csv", whole}).code, 0);
  std::vector<std::string> join = {"study", file, "--csv", joined};
  for (const char* part : {"3/3", "1/3", "2/3"}) {
    const std::string into = folder / std::string(1, part[0]);
    ASSERT_EQ(physim({"study", file, "--shards", part, "--resume", into}).code, 0);
    join.insert(join.end(), {"--merge", into});
  }
  ASSERT_EQ(physim(join).code, 0);
  EXPECT_EQ(read(joined), read(whole));
  EXPECT_FALSE(folder.write("2p", read(folder / "2")).empty());
  ASSERT_EQ(physim({"study", file, "--resume", folder / "2", "--csv", joined}).code, 0);
  EXPECT_EQ(read(joined), read(whole));

  const Ran missing = physim({"study", file, "--merge", folder / "1", "--merge", folder / "3"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_TRUE(has(missing.err, "shards 2 to 4 of 8 are missing")) << missing.err;
  const Ran two_gaps = physim({"study", file, "--merge", folder / "2p"});
  EXPECT_TRUE(has(two_gaps.err, "shards 0 to 1, shards 5 to 7 of 8 are missing")) << two_gaps.err;
  const Ran twice = physim({"study", file, "--merge", folder / "1", "--merge", folder / "1"});
  EXPECT_EQ(twice.code, 2);
  EXPECT_TRUE(has(twice.err, "both parts have shard")) << twice.err;
  const Ran other = physim({"study", file, "--merge", folder / "1", "--vary", "shot.azimuth = +- 1 deg"});
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(has(other.err, "another study") && has(other.err, folder / "1")) << other.err;
  const std::string odd = folder / "odd";
  ASSERT_EQ(physim({"study", file, "--set", "study.seed=2", "--shards", "2/3", "--resume", odd}).code, 0);
  const Ran odd_first = physim({"study", file, "--merge", odd, "--merge", folder / "1", "--merge", folder / "3"});
  EXPECT_TRUE(has(odd_first.err, odd + ": error: the part is of another study")) << odd_first.err;
  EXPECT_FALSE(folder.write("damaged", read(folder / "1").substr(0, 1000)).empty());
  const Ran damaged = physim({"study", file, "--merge", folder / "damaged"});
  EXPECT_EQ(damaged.code, 2);
  EXPECT_TRUE(has(damaged.err, "damaged")) << damaged.err;
}

/// Jobs of an array that are given one file: each adds what it flies, and none takes away what another has flown.
TEST(StudyCli, programs_share_a_file) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(30000)), whole = folder / "whole.csv",
                    shared = folder / "shared", joined = folder / "joined.csv";
  ASSERT_EQ(physim({"study", file, "--csv", whole}).code, 0);
  std::vector<std::thread> jobs;
  std::vector<Ran> ran(4);
  for (std::size_t i = 0; i < ran.size(); ++i)
    jobs.emplace_back([&, i] {
      ran[i] = physim({"study", file, "--shards", std::to_string(i + 1) + "/4", "--resume", shared, "--threads", "1"});
    });
  for (std::thread& job : jobs) job.join();
  for (const Ran& each : ran) EXPECT_EQ(each.code, 0) << each.err;
  ASSERT_EQ(physim({"study", file, "--merge", shared, "--csv", joined}).code, 0) << "no shard is missing";
  EXPECT_EQ(read(joined), read(whole));
  // The same shards flown twice are the same shards.
  const std::string before = read(shared);
  ASSERT_EQ(physim({"study", file, "--shards", "2/4", "--resume", shared}).code, 0);
  EXPECT_EQ(read(shared), before);
  EXPECT_EQ(folder.names().size(), 4U) << "locks and files that are half written are gone";
}

TEST(StudyCli, keeps_what_it_flies_in_a_file_alone) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(30000)), pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& place : {std::string("/dev/full"), std::string("/dev/zero"), pipe}) {
    const Ran ran = physim({"study", file, "--resume", place});
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(has(ran.err, place + ": error: this is a ")) << ran.err;
  }
  const Ran merged = physim({"study", file, "--merge", "/dev/zero"});
  EXPECT_EQ(merged.code, 2);
  EXPECT_TRUE(has(merged.err, "/dev/zero: error: this is a device")) << merged.err;
}

TEST(StudyCli, over_range_and_until_a_width) {
  const File file("throw.toml", throw_study(30000));
  const Ran ran = physim(
      {"study", file, "--ranges", "20 m .. 40 m step 20 m", "--target", "wall: rectangle 100 m x 100 m", "--csv", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "\n20,") && has(ran.out, "\n40,") && has(ran.out, "hit.wall.low")) << ran.out;
  const Ran width = physim({"study", file, "--until-width", "5 %", "--shots", "10000000"});
  ASSERT_EQ(width.code, 0) << width.err;
  EXPECT_TRUE(has(width.out, "65536 shots in 16 shards")) << width.out;
  const Ran narrow = physim({"study", file, "--until-width", "0.01 %"});
  EXPECT_EQ(narrow.code, 1) << "not known so well by so few shots";
  EXPECT_TRUE(has(narrow.err, "--until-width is not reached")) << narrow.err;
  const std::vector<std::string> times = {
      "study", file, "--set", "study.quantities=[\"time\", \"speed\"]", "--set", "study.targets=[]", "--until-width"};
  const auto until = [&](const char* given) {
    std::vector<std::string> command = times;
    command.emplace_back(given);
    return physim(command);
  };
  EXPECT_EQ(until("1 s").code, 0) << "the first quantity is a time";
  EXPECT_EQ(until("1 mm").code, 2) << "and no length";
}

TEST(StudyCli, a_zeroed_shot_is_held_off_for_what_is_known) {
  // 89.4, 60.2 and 38.3 % with mean wind and drift dialled, and 36.0 % at 600 m without.
  const File file("rifle.toml", "physim = 1\n" + test::creedmoor() + R"([study]
inputs = ["environment.wind.velocity.z = -5 mph +- 2 mph"]
targets = ["plate: rectangle 45 cm x 75 cm"]
shots = 20000
)");
  const Ran ran = physim({"study", file, "--ranges", "600 m .. 1000 m step 200 m", "--csv", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto rows = lines_of(ran.out);
  ASSERT_EQ(rows.size(), 4U) << ran.out;
  const double right[] = {0.894, 0.602, 0.383};
  for (std::size_t i = 0; i < 3; ++i) {
    std::istringstream cells(rows[i + 1]);
    std::string cell;
    for (int column = 0; column < 8; ++column) std::getline(cells, cell, ',');
    EXPECT_NEAR(std::stod(cell), right[i], 0.012) << rows[0] << '\n' << rows[i + 1];
  }
}

TEST(StudyCli, says_what_targets_are_and_flies_any_rounds) {
  const File file("throw.toml", throw_study(6000));
  const Ran ran = physim({"study", file, "--target", "round: circle 10 cm at 0 m, 90 m", "--set", "study.rounds=6"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "near    1 m x 3.6 m")) << ran.out;
  EXPECT_TRUE(has(ran.out, "round   radius 0.1 m")) << ran.out;
  EXPECT_TRUE(has(ran.out, "65472 shots in 16 shards")) << "of 682 occasions: " << ran.out;
}

/// The worst shot of a study, by its number alone.
TEST(StudyCli, flies_a_shot_again) {
  const File file("throw.toml", throw_study(8192));
  const auto json = nlohmann::json::parse(physim({"study", file, "--json", "-"}).out);
  const auto& worst = json["worst"][0];
  const std::string number = std::to_string(worst["shot"].get<std::uint64_t>());
  const Ran ran = physim({"study", file, "--fly", number, "--json", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto again = nlohmann::json::parse(ran.out);
  EXPECT_EQ(again["inputs"][0]["drawn"], worst["draws"][0]);
  EXPECT_EQ(again["quantities"][1]["name"], "along [m]");
  EXPECT_NEAR(std::abs(again["quantities"][1]["value"].get<double>() - 90), worst["distance [m]"].get<double>(), 1e-12);
  EXPECT_EQ(again["hits"][0]["hit"], false);
  EXPECT_TRUE(has(physim({"study", file, "--fly", number}).out, "shot number " + number));
  EXPECT_TRUE(has(physim({"study", file, "--fly", number, "--csv", "-"}).err, "told alone"));
  const Ran beyond = physim({"study", file, "--fly", "8192"});
  EXPECT_EQ(beyond.code, 2);
  EXPECT_TRUE(has(beyond.err, "--fly") && has(beyond.err, "0 to 8191")) << beyond.err;
}

/// Where no terminal is, rate, time left and the figure so far are told line by line.
TEST(StudyCli, logs_how_far_it_has_come) {
  const File file("throw.toml", throw_study(400'000));
  const Ran ran = physim({"study", file, "--log-every", "1 ms", "--threads", "1"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string line = ran.err.substr(0, ran.err.find('\n'));
  for (const char* part : {"study: ", "/98 shards, ", "shots/s, ", " left; near ", " %, 95 % interval "})
    EXPECT_TRUE(has(line, part)) << part << " in " << line;
  const Ran quiet = physim({"study", file, "--shots", "5000"});
  EXPECT_EQ(quiet.err, "") << "nothing is told of what is done at once";
  const Ran bad = physim({"study", file, "--log-every", "0 s"});
  EXPECT_TRUE(has(bad.err, "--log-every") && has(bad.err, "above 0")) << bad.err;
}

/// The ball lands within 1.8 m of 90 m where its speed is within 0.3 m/s of 30 m/s: a deviation.
TEST(StudyCli, over_inputs) {
  const File file("throw.toml", throw_study(40000));
  const Ran ran = physim({"study", file, "--over-inputs", "4", "--json", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  ASSERT_EQ(json["over_inputs"].size(), 1U);
  EXPECT_EQ(json["over_inputs"][0]["path"], "shot.speed");
  const auto& parts = json["over_inputs"][0]["parts"];
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_TRUE(parts[0]["low"].is_null());
  EXPECT_NEAR(parts[0]["high"].get<double>(), -0.67449 * 0.3, 1e-4);
  const double outer = (0.6827 - 0.5) / 2 / 0.25;
  EXPECT_NEAR(parts[1]["hits"][0]["probability"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(parts[3]["hits"][0]["probability"].get<double>(), outer, 0.02);
  const std::string csv = physim({"study", file, "--over-inputs", "4", "--csv", "-"}).out;
  const auto row = [&](const std::string& name) {
    const std::size_t at = csv.find("\nover.1.shot.speed+=." + name + ",");
    return at == std::string::npos ? NAN : std::stod(csv.substr(csv.find(',', at) + 1));
  };
  EXPECT_EQ(row("1.to [m/s]"), parts[0]["high"].get<double>()) << csv;
  EXPECT_EQ(row("4.hit.near"), parts[3]["hits"][0]["probability"].get<double>());
  EXPECT_EQ(row("4.hit.near.low"), parts[3]["hits"][0]["low"].get<double>());
  EXPECT_EQ(row("2.shots"), parts[1]["shots"].get<double>());
  EXPECT_TRUE(std::isnan(row("1.from [m/s]"))) << "it has no end there";
  const Ran text = physim({"study", file, "--set", "study.over_inputs=4"});
  EXPECT_TRUE(has(text.out, "hits over an input") && has(text.out, "shot.speed +=")) << text.out;
}

/// However long it flew, so many shots have the same bits; what was kept is gone on with.
TEST(StudyCli, until_a_time) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(30000)), csv = folder / "time.csv",
                    kept = folder / "kept", again = folder / "again.csv";
  for (const char* sampling : {"random", "sobol"}) {
    const std::string set = std::string("study.sampling=") + sampling;
    const Ran ran = physim({"study", file, "--set", set, "--until-time", "0.2 s", "--csv", csv, "--resume", kept});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const std::size_t at = ran.out.find("--shots ");
    ASSERT_NE(at, std::string::npos) << ran.out;
    const std::string shots = std::to_string(std::stoull(ran.out.substr(at + 8)));
    const Ran fixed = physim({"study", file, "--set", set, "--shots", shots, "--csv", again});
    ASSERT_EQ(fixed.code, 0) << fixed.err;
    EXPECT_EQ(read(again), read(csv)) << sampling;
    const Ran on = physim({"study", file, "--set", set, "--set", "study.until_time=0.2 s", "--resume", kept});
    EXPECT_TRUE(has(on.out, "the time was up")) << on.out;
    EXPECT_GT(std::stoull(on.out.substr(on.out.find("--shots ") + 8)), std::stoull(shots)) << "it goes on";
    ASSERT_EQ(std::remove(kept.c_str()), 0);
  }
  const Ran enough = physim({"study", file, "--until-time", "1 h", "--shots", "4096"});
  EXPECT_TRUE(has(enough.out, "4096 shots") && !has(enough.out, "time was up")) << enough.out;
}

TEST(StudyCli, indices_of_what_does_not_vary_are_none) {
  const Ran ran = physim({"study", Folder().write("throw.toml", throw_study(4096)), "--set", "study.indices=true"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "right  no variance")) << ran.out;
  EXPECT_FALSE(has(ran.out, "nan")) << ran.out;
}

/// The ball has its apex a quarter as high as it flies far, v^2 / 40 of 22.5 m, with a deviation of 2 % of that.
TEST(StudyCli, tells_of_places_on_the_way) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(30000)), csv = folder / "a.csv",
                    kept = folder / "kept";
  const std::vector<std::string> at = {"--at", "apex: y, time", "--at", "45 m", "--at", "90 m", "--at", "10 m rising"};
  const auto study = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"study", file});
    more.insert(more.end(), at.begin(), at.end());
    return more;
  };
  const Ran ran = physim(study({"--json", "-", "--csv", csv, "--resume", kept}));
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  ASSERT_EQ(json["at"].size(), 4U);
  EXPECT_EQ(json["at"][0]["place"], "apex");
  EXPECT_EQ(json["at"][1]["place"], "45 m");
  EXPECT_EQ(json["at"][3]["place"], "10 m rising");
  EXPECT_EQ(json["at"][0]["quantities"], nlohmann::json({"y [m]", "time [s]"}));
  const auto figure = [](const auto& of, const std::string& name) {
    for (const auto& each : of["figures"])
      if (each["name"] == name) return each["value"].template get<double>();
    ADD_FAILURE() << name << " is missing";
    return 0.0;
  };
  EXPECT_NEAR(figure(json["at"][0], "y.mean [m]"), 22.5 * 1.0001, 0.02);
  EXPECT_NEAR(figure(json["at"][0], "y.deviation [m]"), 0.45, 0.01);
  EXPECT_NEAR(figure(json["at"][1], "up.mean [m]"), 22.5, 0.02) << "45 m away it is at its apex";
  EXPECT_NEAR(figure(json["at"][2], "not_arrived"), 16384, 400) << "half of them land before 90 m";
  const std::string rows = read(csv);
  for (const char* head : {"\nat.apex.y.mean [m],", "\nat.45 m.up.quantile_0.5 [m],", "\nat.10 m rising.shots,"})
    EXPECT_TRUE(has(rows, head)) << head;
  const Ran text = physim(study({"--threads", "1"}));
  for (const char* head :
       {"\n  at apex\n", "\n  at 90 m: ", "did not come there", "\n  over range, by the same flights\n"})
    EXPECT_TRUE(has(text.out, head)) << head << " in\n" << text.out;

  const std::string again = folder / "b.csv";
  ASSERT_EQ(physim(study({"--merge", kept, "--csv", again})).code, 0);
  EXPECT_EQ(read(again), rows);
  std::vector<std::string> join = study({"--csv", again});
  for (const char* part : {"2/2", "1/2"}) {
    const std::string into = folder / std::string(1, part[0]);
    ASSERT_EQ(physim(study({"--shards", part, "--resume", into})).code, 0);
    join.insert(join.end(), {"--merge", into});
  }
  ASSERT_EQ(physim(join).code, 0);
  EXPECT_EQ(read(again), rows);
  EXPECT_TRUE(has(physim({"study", file, "--merge", kept}).err, "another study"));

  const auto shot = nlohmann::json::parse(physim(study({"--fly", "77", "--json", "-"})).out);
  const double v = 30 + shot["inputs"][0]["drawn"].get<double>();
  EXPECT_NEAR(shot["at"][0]["quantities"][0]["value"].get<double>(), v * v / 40, 1e-8);
}

TEST(StudyCli, histograms) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(40000, ", \"shot.azimuth = +- 1 deg\""));
  const Ran ran =
      physim({"study", file, "--histograms", "20", "--json", "-", "--csv", folder / "a.csv", "--at", "10 m"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  ASSERT_EQ(json["histograms"].size(), 4U + 2U + 3U) << "quantities, distances, extreme spreads";
  const auto& along = json["histograms"][1];
  EXPECT_EQ(along["name"], "along");
  EXPECT_EQ(along["unit"], "m");
  ASSERT_EQ(along["count"].size(), 20U);
  std::uint64_t all = 0;
  for (const auto& count : along["count"]) all += count.get<std::uint64_t>();
  EXPECT_EQ(all, 40960U);
  EXPECT_EQ(json["at"][0]["histograms"].size(), 9U);
  const std::string csv = read(folder / "a.csv");
  const auto row = [&](const std::string& name) {
    const std::size_t at = csv.find("\n" + name + ",");
    return at == std::string::npos ? NAN : std::stod(csv.substr(csv.find(',', at) + 1));
  };
  EXPECT_EQ(row("histogram.along.7.from [m]"), along["low"][6].get<double>());
  EXPECT_EQ(row("histogram.along.7.to [m]"), along["high"][6].get<double>());
  EXPECT_EQ(row("histogram.along.7.count"), along["count"][6].get<double>());
  EXPECT_GT(row("histogram.extreme_spread.5.10.count"), 0);
  EXPECT_GT(row("at.10 m.histogram.time.10.count"), 0);
  const Ran text = physim({"study", file, "--set", "study.histograms=12"});
  EXPECT_TRUE(has(text.out, "along from [m]") && has(text.out, " ####")) << text.out;
  EXPECT_FALSE(has(physim({"study", file}).out, "along from"));
}

TEST(StudyCli, what_a_table_over_range_leaves_out_is_told) {
  const File file("throw.toml", throw_study(4096));
  for (const std::string given : {"study.aim=1 m, 0 m", "study.quantities=[\"right\", \"up\", \"time\"]"}) {
    const Ran ran = physim({"study", file, "--ranges", "20 m", "--set", given});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(
        has(ran.err, "--set " + given + ": " + given.substr(0, given.find('=')) + ": has no effect with --ranges"))
        << ran.err;
  }
}

TEST(StudyCli, bad_input_says_what_is_wrong) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(30000));
  const auto refusal = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"study", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = physim(arguments);
    EXPECT_EQ(ran.code, 2) << ran.out;
    return ran.err;
  };
  EXPECT_TRUE(has(refusal({"--vary", "shot.sped = +- 1 m/s"}), "shot.sped"));
  EXPECT_TRUE(has(refusal({"--vary", "shot.mass = 1 kg"}), "no distribution"));
  EXPECT_TRUE(has(refusal({"--target", "square 1 m"}), "no target"));
  EXPECT_TRUE(has(refusal({"--range", "1 km"}), "arrived"));
  EXPECT_TRUE(has(refusal({"--shards", "1/2"}), "--resume"));
  EXPECT_TRUE(has(refusal({"--shards", "3/2", "--resume", folder / "x"}), "--shards"));
  EXPECT_TRUE(has(refusal({"--merge", folder / "nothing"}), "there is no such file"));
  EXPECT_TRUE(has(refusal({"--ranges", "20 m", "--resume", folder / "x"}), "--ranges"));
  EXPECT_TRUE(has(refusal({"--until-width", "1 kg"}), "--until-width"));
  EXPECT_TRUE(has(refusal({"--until-width", "5"}), "--until-width: error: an interval of a hit probability"));
  EXPECT_TRUE(has(refusal({"--ranges", "[\"0 m\", \"20 m\"]"}), "--ranges: error: a study is flown to ranges above 0"));
  EXPECT_TRUE(has(refusal({"--until-time", "1 kg"}), "--until-time"));
  EXPECT_TRUE(has(refusal({"--until-time", "-1 s"}), "above 0"));
  EXPECT_TRUE(has(refusal({"--over-inputs", "1"}), "2 to 100"));
  EXPECT_TRUE(has(refusal({"--over-inputs", "1000"}), "2 to 100"));
  EXPECT_TRUE(has(refusal({"--over-inputs", "4", "--set", "study.targets=[]"}), "no target"));
  EXPECT_TRUE(has(refusal({"--over-inputs", "4", "--ranges", "20 m"}), "leave --ranges out"));
  EXPECT_TRUE(has(refusal({"--set", "study.over_inputs=4", "--ranges", "20 m"}), "leave --ranges out"));
  EXPECT_TRUE(has(refusal({"--histograms", "2"}), "3 to 1000"));
  EXPECT_TRUE(has(refusal({"--set", "study.histograms=2"}), "3 to 1000"));
  EXPECT_TRUE(has(refusal({"--histograms", "9", "--ranges", "20 m"}), "leave --ranges out"));
  EXPECT_TRUE(has(refusal({"--set", "study.histograms=9", "--ranges", "20 m"}), "leave --ranges out"));
  EXPECT_TRUE(has(refusal({"--ranges", "20 m", "--range", "20 m"}), "--range: error: given together with --ranges"));
  EXPECT_TRUE(
      has(refusal({"--ranges", "20 m", "--set", "study.indices=true"}), "leave --ranges out, or study.indices"));
  const std::string both = refusal({"--target", "square 1 m", "--target", "circle 1", "--target", "oval 1 m"});
  EXPECT_TRUE(has(both, "square 1 m") && has(both, "oval 1 m")) << both;
  EXPECT_TRUE(has(refusal({"--at", "apxe"}), "study.at[0]"));
  EXPECT_TRUE(has(refusal({"--at", "apex: hight"}), "no quantity of a place"));
  EXPECT_TRUE(has(refusal({"--at", "1 km"}), "0 arrived there"));
  EXPECT_TRUE(has(refusal({"--at", "10 m", "--ranges", "20 m"}), "study.at and --at"));
  EXPECT_TRUE(has(refusal({"--set", "study.until_time=0 s"}), "study.until_time"));
  EXPECT_TRUE(has(refusal({"--until-time", "1 s", "--shards", "1/2", "--resume", folder / "x"}), "--shards"));
  EXPECT_TRUE(has(refusal({"--resume", folder / "no/folder"}), "folder"));
}

constexpr const char* kTwoShots = R"(physim = 1
[environment]
atmosphere = "vacuum"
[[shot]]
name = "s"
speed = "100 m/s +- 1 m/s"
elevation = "30 deg"
rail_length = "1 m"
[[shot]]
name = "t"
speed = "50 m/s"
elevation = { low = "29 deg", high = "31 deg" }
[study]
shots = 4096
)";

/// The file is innocent of what an option says.
TEST(StudyCli, errors_of_options_name_the_option) {
  const Folder folder;
  const std::string file = folder.write("two.toml", kTwoShots);
  const auto refused = [&](const std::string& option, const std::string& value, const std::string& error) {
    expect_complaint(physim({"study", file, option, value}), option + ": error: " + error);
  };
  refused("--shots", "0", "must be from 1 to 2^50");
  refused("--until-width", "0 m", "must be a positive number, not 0");
  refused("--histograms", "2", "must be from 3 to 1000 bars");
  refused("--over-inputs", "1", "must be from 2 to 100 parts");
  refused("--range", "-5 m", "must be a positive number, not -5");
  refused("--ranges", "500 m .. 100 m step 100 m", "output.ranges: the steps lead nowhere");
  refused("--vary", "shot.speed = 100 m/s +- 5 m/s",
          "study.inputs[2].path: shot.speed is drawn by inputs[0] already; let one of the two be `added`");
  refused("--vary", "shot.rail_length = -2 m .. -1 m", "study.inputs[2]: shot.rail_length: must be zero or positive");
  expect_complaint(physim({"study", file, "--shots", "0", "--shards", "1/2", "--resume", folder / "part"}),
                   "--shots: error: ");
  expect_complaint(physim({"table", file, "--ranges", "500 m .. 100 m step 100 m"}),
                   "--ranges: error: output.ranges: ");
  expect_complaint(physim({"table", file, "--set", "output.ranges=5 m .. 1 m step 1 m"}),
                   "--set output.ranges=5 m .. 1 m step 1 m: error: output.ranges: ");
}

TEST(StudyCli, inputs_of_another_shot_have_no_effect) {
  const Folder folder;
  const std::string file = folder.write("two.toml", kTwoShots), mass = "shot.t.mass = 1 kg +- 0.1 kg";
  const Ran other = physim({"study", file, "--vary", mass, "--vary", "shot.s.elevation = +- 1 deg"});
  EXPECT_EQ(other.code, 0);
  EXPECT_EQ(other.err, "warning: --vary \"" + mass + "\": has no effect: the study is of shot \"s\"\n");
  EXPECT_EQ(physim({"study", file, "--shot", "t", "--vary", mass}).err, "");
}

/// Messages about files have the names of files.
TEST(StudyCli, refused_shots_name_the_setting_of_the_file) {
  const Folder folder;
  const std::string file = folder.write("two.toml", kTwoShots);
  const Ran ran = physim({"study", file, "--vary", "shot.rail_length = -2 m .. 1 m"});
  EXPECT_EQ(ran.code, 0);
  for (const std::string& text : {ran.err, ran.out}) {
    EXPECT_TRUE(has(text, "shot.rail_length: must be zero or positive")) << text;
    EXPECT_FALSE(has(text, "error:") || has(text, "launch.")) << text;
  }
  const std::string thrown =
      folder.write("low.toml",
                   "physim = 1\n[[shot]]\nname = \"s\"\nspeed = \"9 m/s\"\nposition = [\"0 m\", \"5 m\", \"0 m\"]\n"
                   "[until]\nground = \"5 m\"\n");
  const Ran landed = physim({"run", thrown});
  EXPECT_TRUE(has(landed.out, "start it at a higher position")) << landed.out;
}

}  // namespace physim::testing_cli::cli_study_cli_test
#endif
