// What is read cannot be written, by whichever name; files are written whole or not at all.
#include "scenario/files_in_use.hpp"

#include "named_files.hpp"
#include "physim/physim.hpp"
#include "scenario/new_file.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_files_in_use_test {

namespace fs = std::filesystem;
using testing_cli::File;
using testing_cli::Folder;
using testing_cli::has;
using testing_cli::read;

TEST(FilesInUse, knows_one_file_by_all_of_its_names) {
  const Folder folder;
  const std::string file = folder.write("a", "1"), other = folder.write("b", "1");
  fs::create_symlink(file, folder / "symbolic");
  fs::create_symlink(folder / "symbolic", folder / "twice");
  fs::create_hard_link(file, folder / "hard");
  fs::create_directory(folder / "sub");
  fs::create_directory_symlink(folder / "sub", folder / "way");
  for (const char* name : {"a", "symbolic", "twice", "hard", "./a", "sub/../a", "way/../a"})
    EXPECT_TRUE(is_same_file(file, folder / name)) << name;
  EXPECT_TRUE(is_same_file(fs::relative(file).string(), file));
  EXPECT_FALSE(is_same_file(file, other)) << "equal content does not make it one file";
  EXPECT_TRUE(is_same_file(folder / "new", folder / "sub/../new")) << "neither is there";
  EXPECT_FALSE(is_same_file(folder / "new", folder / "sub/new"));
  EXPECT_FALSE(is_same_file("", ""));
  EXPECT_FALSE(is_same_file("/dev/null", "/dev/null")) << "which anybody may write to";
}

TEST(FilesInUse, refuses_whichever_comes_second) {
  const Folder folder;
  const std::string file = folder.write("a.toml", "1");
  fs::create_hard_link(file, folder / "a.csv");
  FilesInUse files;
  ASSERT_TRUE(files.add_output(folder / "a.csv", "--csv").ok());
  const Status read_second = begin_reading(file, "scenario");
  EXPECT_EQ(read_second.error().text(), folder / "a.csv" + ": error: --csv cannot write: it is the scenario itself, " +
                                            file + "; name another file with --csv");
  const std::string data = folder.write("d.csv", "1");
  ASSERT_TRUE(begin_reading(data, "table of measurements").ok());
  EXPECT_EQ(files.add_output(data, "--json").error().message,
            "--json cannot write: it is the table of measurements itself, " + data);
  EXPECT_EQ(begin_writing(data).error().message, "cannot write: it is the table of measurements itself, " + data);
  EXPECT_TRUE(begin_writing(folder / "new").ok());
  EXPECT_EQ(files.inputs(), std::vector{data});
}

TEST(FilesInUse, outputs_are_different_files_and_no_directories) {
  const Folder folder;
  FilesInUse files;
  ASSERT_TRUE(files.add_output(folder / "a", "--csv").ok());
  EXPECT_TRUE(has(files.add_output(folder / "./a", "--json").error().message, "--csv and --json cannot both go to "));
  EXPECT_EQ(files.add_output(folder / ".", "--json").error().message, "cannot write: it is a directory");
  ASSERT_TRUE(files.add_output("-", "--json").ok());
  EXPECT_EQ(files.add_output("-", "--kml").error().message, "--json and --kml cannot both go to -");
  ASSERT_TRUE(files.add_output("/dev/null", "--kml").ok());
  EXPECT_TRUE(files.add_output("/dev/null", "--czml").ok());
  EXPECT_TRUE(files.add_output("", "--plot").ok()) << "it was not asked for";
  EXPECT_EQ(files.add_folder(folder.write("file", "1"), "--out").error().message, "it is a file, not a directory");
  EXPECT_TRUE(files.add_folder(folder / "sub", "--out").ok());
  EXPECT_FALSE(files.add_output(folder / "sub", "--hits").ok()) << "which becomes the directory";
}

TEST(FilesInUse, an_output_may_replace_one_kind_of_input) {
  const File file("a.save", "1");
  FilesInUse files;
  ASSERT_TRUE(files.add_output(file, "--save", "save").ok());
  ASSERT_TRUE(begin_reading(file, "save").ok());
  EXPECT_TRUE(begin_writing(file).ok());
  EXPECT_FALSE(begin_reading(file, "scenario").ok());
}

TEST(FilesInUse, nothing_is_refused_without_a_record) {
  const Folder folder;
  const std::string file = folder.write("a.rec", "1");
  {
    const FilesInUse outer;
    {
      const FilesInUse inner;
      ASSERT_TRUE(load_recording(file).ok());
      EXPECT_EQ(inner.inputs(), std::vector{file});
    }
    EXPECT_EQ(outer.inputs(), std::vector{file}) << "told by what was done inside";
    EXPECT_FALSE(save_recording(file, {}).ok());
    EXPECT_EQ(read(file), "1");
  }
  ASSERT_TRUE(load_recording(file).ok());
  EXPECT_TRUE(save_recording(file, {}).ok()) << "a program saves over what it loaded";
}

// ---------------------------------------------------------------------------------------------------- files of
// scenarios
/// A scenario that names a file of each kind; the table by a study alone.
std::string write_scenario(const Folder& folder) {
  const std::string shapes = test::write_named_files(folder);
  fs::create_directory(folder / "sub");
  return folder.write(
      "s.toml", "physim = 1\n[world]\nduration = \"10 ms\"\n[[shot]]\ndrag = { coefficient = 0.75 }\n" +
                    std::string(test::kRocketLines) + shapes +
                    "[study]\nrounds = 4\ninputs = [\"shot.speed = column speed of sub/../speeds.csv per occasion\", "
                    "\"shot.mass = one of 57 g, 58 g\"]\n");
}

std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(fs::path(file).filename().string());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

TEST(ScenarioFiles, are_all_that_a_scenario_names_and_what_these_name) {
  const Folder folder;
  const auto scenario = must(load_scenario(write_scenario(folder)));
  std::vector<std::string> expected = {"motor.eng", "s.toml", "speeds.csv"};
  if (reads_height_maps()) expected.insert(expected.begin(), "hills.pgm");
  if (reads_mesh_files()) expected.insert(expected.end(), {"tent.mtl", "tent.obj"});
  EXPECT_EQ(names_of(scenario.files), expected);
}

TEST(ScenarioFiles, are_no_place_for_a_recording) {
  const Folder folder;
  const std::string file = write_scenario(folder);
  const Scenario scenario = load_scenario(file).value();
  const std::vector<std::byte> save = WorldRun::create(scenario).value().save().value();
  for (const std::string& input : scenario.files) {
    const std::string before = read(input);
    EXPECT_TRUE(has(WorldRun::create(scenario, input).error().message, "it would replace " + input)) << input;
    EXPECT_FALSE(WorldRun::load(scenario, save, input).ok()) << input;
    EXPECT_EQ(read(input), before) << input;
  }
  fs::copy_file(file, folder / "r.part");
  const Scenario part = load_scenario(folder / "r.part").value();
  EXPECT_FALSE(WorldRun::create(part, folder / "r").ok()) << "whose name until it is complete is taken";
  EXPECT_EQ(read(folder / "r.part"), read(file));
  EXPECT_TRUE(WorldRun::create(scenario, folder / "s.rec").ok());
}

// ------------------------------------------------------------------------------------------------------------ new
// files
TEST(NewFile, is_there_whole_or_not_at_all) {
  const Folder folder;
  const std::string path = folder.write("a", "before");
  {
    NewFile file(path);
    ASSERT_TRUE(file.open().ok());
    ASSERT_TRUE(file.write("after").ok());
    EXPECT_EQ(read(path), "before");
    EXPECT_EQ(read(file.written()), "after");
  }
  EXPECT_EQ(read(path), "before");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a"}) << "what was not completed is gone";
  NewFile file(path);
  ASSERT_TRUE(file.open().ok());
  ASSERT_TRUE(file.write("after").ok());
  ASSERT_TRUE(file.complete().ok());
  EXPECT_EQ(read(path), "after");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
}

TEST(NewFile, takes_nobody_elses_name) {
  const Folder folder;
  const std::string path = folder / "a", taken = folder.write("a.tmp-1", "of somebody");
  NewFile one(path), two(path);
  ASSERT_TRUE(one.open().ok());
  ASSERT_TRUE(two.open().ok());
  EXPECT_NE(one.written(), two.written());
  EXPECT_EQ(read(taken), "of somebody");
}

TEST(NewFile, keeps_links_and_refuses_directories) {
  const Folder folder;
  const std::string path = folder.write("a", "before");
  fs::create_symlink(path, folder / "link");
  NewFile file(folder / "link");
  ASSERT_TRUE(file.open().ok());
  ASSERT_TRUE(file.write("after").ok());
  ASSERT_TRUE(file.complete().ok());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read(path), "after");
  EXPECT_TRUE(has(NewFile(folder / ".").open().error().message, "it is a folder"));
  EXPECT_TRUE(has(NewFile(folder / "no/a").open().error().message, "No such file"));
}

}  // namespace physim::scenario_files_in_use_test
