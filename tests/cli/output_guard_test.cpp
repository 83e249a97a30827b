// No output option of any command replaces what the command reads: every option is tried on every kind of input, by
// every name of it. The options come from the help of the program, so that a new one is tried, too.
#include <map>
#include <optional>
#include <set>

#include "named_files.hpp"

namespace physim::cli_output_guard_test {

namespace fs = std::filesystem;
using testing_cli::Folder;
using testing_cli::has;
using testing_cli::lines_of;
using testing_cli::physim;
using testing_cli::Ran;
using testing_cli::read;

// --------------------------------------------------------------------------------------------------------------
// options
/// An option of a command whose value is a file or a directory.
struct FileOption {
  std::string command, name, type;

  /// As its value must end, for those that tell the format by it.
  [[nodiscard]] std::string ending() const {
    const std::size_t dot = type.find('.');
    return dot == type.npos ? "" : type.substr(dot, type.find('|') - dot);
  }
  [[nodiscard]] bool is_folder() const { return type.starts_with("DIR"); }
};

/// What follows the name of an option in help, where that is no file.
const std::set<std::string> kNoFiles = {"TEXT",          "KEY=VALUE", "NAME",  "TIME", "LENGTH", "N",      "RANGES",
                                        "UNITS",         "UNIT",      "SPEED", "K/N",  "PLACE",  "FORMAT", "ANGLE",
                                        "low|high|both", "WIDTH",     "UINT",  "\"X,", "NUMBER"};
/// Options whose file is read. All other files are written.
const std::set<std::string> kInputs = {"run --load", "study --merge", "fit --data", "validate --data"};

std::vector<std::string> commands() {
  std::vector<std::string> names;
  bool is_below = false;
  for (const std::string& line : lines_of(physim({"--help"}).out)) {
    if (is_below && line.starts_with("  ") && line.size() > 2 && line[2] != ' ')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    if (line.starts_with("Subcommands")) is_below = true;
    if (is_below && line.starts_with("Exit codes")) break;
  }
  return names;
}

/// The file options of a command. A type that this test does not know must be put into one of the lists above.
std::vector<FileOption> file_options(const std::string& command) {
  std::vector<FileOption> options;
  for (const std::string& line : lines_of(physim({command, "--help"}).out)) {
    if (!line.starts_with("  -")) continue;
    std::istringstream words(line);
    std::string name, type;
    words >> name >> type;
    const bool has_type = !type.empty() && line.find(name + " " + type) != line.npos;  // flags have none
    type = type.substr(0, type.find(':'));                                             // "N:UINT in [0 - 1024]"
    if (!has_type || name.starts_with("-h") || kNoFiles.count(type) > 0) continue;
    const std::string bare = name.substr(0, name.find(','));
    const bool is_file = type.starts_with("FILE") || type.starts_with("DIR") || type == "CSV";
    EXPECT_TRUE(is_file) << command << " " << name << " takes a " << type << ": is that a file? Tell this test";
    options.push_back({command, bare, type});
  }
  return options;
}

std::vector<FileOption> outputs_of(const std::string& command) {
  std::vector<FileOption> options = file_options(command);
  std::erase_if(options, [](const FileOption& each) { return kInputs.count(each.command + " " + each.name) > 0; });
  return options;
}

// ---------------------------------------------------------------------------------------------------------------
// inputs
/// Where each command finds files of every kind that it reads.
class Inputs {
 public:
  Inputs() {
    shapes_ = test::write_named_files(folder_, "799\n801\n");
    folder_.write("data.csv", "range [m], speed [m/s]\n50, 790\n100, 780\n");
    folder_.write("flat.toml", scenario("[until]\nground = \"off\"\nrange = \"100 m\"\n"));
    folder_.write("world.toml", scenario("[world]\nduration = \"20 ms\"\n"));
    fs::create_directory(folder_ / "figures");
    for (const auto& each : fs::directory_iterator(PHYSIM_DATA_DIR "/validation/us76"))
      if (each.is_regular_file()) fs::copy_file(each.path(), folder_ / "figures/" + each.path().filename().string());
    EXPECT_EQ(physim({"run", path("world.toml"), "--save", path("a.save"), "--record", path("a.rec")}).code, 0);
    EXPECT_EQ(physim({"study", path("flat.toml"), "--shots", "2048", "--resume", path("a.part")}).code, 0);
  }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] const Folder& folder() const { return folder_; }

  /// The arguments of a command without outputs.
  [[nodiscard]] std::vector<std::vector<std::string>> calls_of(const std::string& command) const {
    const std::string flat = path("flat.toml"), world = path("world.toml");
    if (command == "run") return {{"run", flat}, {"run", world, "--load", path("a.save")}};
    if (command == "replay") return {{"replay", path("a.rec")}};
    if (command == "fit") return {{"fit", flat, "--data", path("data.csv")}};
    if (command == "aim") return {{"aim", flat, "--range", "50 m"}};
    if (command == "danger-space") return {{"danger-space", flat, "--range", "50 m", "--height", "1 m"}};
    if (command == "study") return {{"study", flat, "--shots", "2048", "--merge", path("a.part"), "--threads", "1"}};
    if (command == "validate") return {{"validate", "us76", "--data", path("figures")}};
    if (command == "compare" || command == "table" || command == "max-range") return {{command, flat}};
    return {};
  }
  /// The names of what a call reads.
  [[nodiscard]] std::vector<std::string> read_by(const std::vector<std::string>& call) const {
    std::vector<std::string> names;
    if (call[0] == "validate") {
      for (const auto& each : fs::directory_iterator(path("figures")))
        if (each.path().extension() == ".csv") return {"figures/" + each.path().filename().string()};
    }
    for (std::size_t i = 1; i < call.size(); ++i)
      if (call[i].starts_with(path(""))) names.push_back(fs::path(call[i]).filename().string());
    if (call[0] == "replay") return names;
    names.insert(names.end(), {"motor.eng", "speeds.csv"});
    if (reads_height_maps()) names.emplace_back("hills.pgm");
    if (reads_mesh_files()) names.insert(names.end(), {"tent.obj", "tent.mtl"});
    return names;
  }

 private:
  [[nodiscard]] std::string scenario(const std::string& own) const {
    return "physim = 1\n" + own + R"([environment]
atmosphere = "constant"
[[shot]]
name = "ball"
mass = "10 g"
diameter = "7.62 mm"
drag = { coefficient = 0.3 }
speed = "800 m/s"
fidelity = { preset = "constant_air", earth = "ellipsoid" }
[[shot]]
name = "rocket"
fidelity = { preset = "simulation", earth = "ellipsoid" }
)" + test::kRocketLines +
           shapes_ + R"([study]
inputs = ["shot.ball.speed = column speed of speeds.csv"]
targets = ["circle 10 cm"]
)";
  }

  Folder folder_;
  std::string shapes_;  // tables that name its files
};

/// All files of a folder with what they say.
std::map<std::string, std::string> contents(const std::string& folder) {
  std::map<std::string, std::string> all;
  for (const auto& each : fs::recursive_directory_iterator(folder))
    all[each.path().string()] = each.is_regular_file() ? read(each.path().string()) : "";
  return all;
}

/// What an option may do on purpose: a study goes on in its part, and a run in its save.
bool is_on_purpose(const FileOption& option, const std::string& input) {
  return option.command == "run" && option.name == "--save" && input == "a.save";
}

/// What a build or a world cannot write at all is refused before anything is read.
bool is_left_out(const Ran& ran) {
  return has(ran.err, "built without HDF5") || has(ran.err, "it is of single flights");
}

std::string words_of(const std::vector<std::string>& call) {
  std::string text;
  for (const std::string& word : call) text += word + " ";
  return text;
}

void expect_refused(const Inputs& inputs, std::vector<std::string> call, const FileOption& option,
                    const std::string& value) {
  const auto before = contents(inputs.path("."));
  call.insert(call.end(), {option.name, value});
  const Ran ran = physim(call);
  EXPECT_EQ(ran.code, 2) << words_of(call) << ran.err;
  EXPECT_TRUE(contents(inputs.path(".")) == before) << words_of(call) << "changed files";
  if (is_left_out(ran)) return;
  const std::string why =
      option.is_folder() ? "it is a file, not a directory; name a directory with " : " cannot write: it is the ";
  EXPECT_TRUE(has(ran.err, why)) << words_of(call) << ran.err;
  EXPECT_TRUE(has(ran.err, option.name)) << words_of(call) << ran.err;
}

// ----------------------------------------------------------------------------------------------------------------
// tests
TEST(OutputGuard, knows_every_command) {
  const Inputs inputs;
  const std::vector<std::string> all = commands();
  EXPECT_GE(all.size(), 11u);
  std::size_t outputs = 0;
  for (const std::string& command : all) {
    const std::size_t own = outputs_of(command).size();
    outputs += own;
    EXPECT_TRUE(own == 0 || !inputs.calls_of(command).empty()) << "tell this test how to call " << command;
  }
  EXPECT_GE(outputs, 25u) << "the help is not read as it is written";
}

TEST(OutputGuard, keeps_every_input) {
  const Inputs inputs;
  for (const std::string& command : commands())
    for (const FileOption& option : outputs_of(command))
      for (const auto& call : inputs.calls_of(command))
        for (const std::string& name : inputs.read_by(call)) {
          if (is_on_purpose(option, name)) continue;
          // A picture says its format by its name: it goes there through a link.
          const std::string link = inputs.path("link" + option.ending());
          fs::create_symlink(inputs.path(name), link);
          expect_refused(inputs, call, option, option.ending().empty() ? inputs.path(name) : link);
          fs::remove(link);
        }
}

TEST(OutputGuard, knows_an_input_by_every_name) {
  const Inputs inputs;
  for (const std::string& command : commands())
    for (const FileOption& option : outputs_of(command))
      for (const auto& call : inputs.calls_of(command)) {
        const std::string name = inputs.read_by(call).front(), file = inputs.path(name), end = option.ending();
        fs::create_hard_link(file, inputs.path("hard" + end));
        fs::create_symlink("soft_too" + end, inputs.path("soft" + end));
        fs::create_symlink(file, inputs.path("soft_too" + end));
        std::vector<std::string> paths = {inputs.path("hard" + end), inputs.path("soft" + end),
                                          inputs.path("figures/../soft" + end)};
        for (const std::string& each : {paths[0], paths[1]})
          paths.push_back(fs::path(each).lexically_relative(fs::current_path()).string());
        for (const std::string& path : paths) expect_refused(inputs, call, option, path);
        for (const char* link : {"hard", "soft", "soft_too"}) fs::remove(inputs.path(link + end));
      }
}

TEST(OutputGuard, two_outputs_are_two_files) {
  const Inputs inputs;
  for (const std::string& command : commands()) {
    const std::vector<FileOption> options = outputs_of(command);
    for (std::size_t i = 0; i < options.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        std::vector<std::string> call = inputs.calls_of(command).front();
        call.insert(call.end(),
                    {options[i].name, inputs.path("new.png"), options[k].name, inputs.path("figures/../new.png")});
        const auto before = contents(inputs.path("."));
        const Ran ran = physim(call);
        EXPECT_EQ(ran.code, 2) << words_of(call);
        EXPECT_TRUE(has(ran.err, "cannot both go to ")) << words_of(call) << ran.err;
        EXPECT_TRUE(contents(inputs.path(".")) == before) << words_of(call);
      }
  }
}

TEST(OutputGuard, an_output_is_no_directory) {
  const Inputs inputs;
  fs::create_directory(inputs.path("d.png"));
  for (const std::string& command : commands())
    for (const FileOption& option : outputs_of(command)) {
      if (option.is_folder()) continue;
      std::vector<std::string> call = inputs.calls_of(command).back();
      call.insert(call.end(), {option.name, inputs.path("d.png")});
      const auto before = contents(inputs.path("."));
      const Ran ran = physim(call);
      EXPECT_EQ(ran.code, 2) << words_of(call);
      EXPECT_TRUE(is_left_out(ran) || has(ran.err, "it is a directory")) << words_of(call) << ran.err;
      EXPECT_TRUE(contents(inputs.path(".")) == before) << words_of(call);
    }
}

/// Files that an option writes beside the one that it names.
TEST(OutputGuard, keeps_inputs_that_stand_where_further_files_go) {
  if (!reads_height_maps()) GTEST_SKIP() << "built without stb";
  const Inputs inputs;
  const auto rename_hills = [&](const std::string& name, const std::string& scenario) {
    fs::copy_file(inputs.path("hills.pgm"), inputs.path(name));
    std::string text = read(inputs.path(scenario));
    text.replace(text.find("hills.pgm"), 9, name);
    return inputs.folder().write(scenario, text);
  };
  const auto expect_kept = [&](const std::vector<std::string>& call, const std::string& why) {
    const auto before = contents(inputs.path("."));
    const Ran ran = physim(call);
    EXPECT_EQ(ran.code, 2) << words_of(call);
    EXPECT_TRUE(has(ran.err, why)) << words_of(call) << ran.err;
    EXPECT_TRUE(contents(inputs.path(".")) == before) << words_of(call);
  };
  fs::copy_file(inputs.path("flat.toml"), inputs.path("speeds.toml"));
  expect_kept({"run", inputs.path("speeds.toml"), "--out", inputs.path(".")},
              "speeds.csv: error: --out cannot write: it is the table of measurements itself");
  const std::string map = rename_hills("flat_ball.png", "flat.toml");
  expect_kept({"run", map, "--out", inputs.path(".")}, "--out cannot write: it is the height map itself");
  const std::string world = rename_hills("world.png", "world.toml");
  expect_kept({"run", world, "--out", inputs.path(".")}, "--out cannot write: it is the height map itself");
  expect_kept({"study", map, "--at", "50 m", "--plot", inputs.path("flat_ball.png")}, "--plot cannot write");
  fs::create_symlink(inputs.path("flat_ball.png"), inputs.path("p-at-1.png"));
  expect_kept({"study", map, "--shots", "2048", "--at", "50 m", "--plot", inputs.path("p.png")},
              "p-at-1.png: error: --plot cannot write: it is the height map itself");
  fs::create_directory(inputs.path("new"));
  expect_kept({"run", map, "--out", inputs.path("new"), "--csv", inputs.path("new/flat.csv")}, "cannot both go to");
  fs::copy_file(inputs.path("world.toml"), inputs.path("w.part"));
  expect_kept({"run", inputs.path("w.part"), "--record", inputs.path("w")}, "--record cannot write");
  expect_kept({"run", inputs.path("world.toml"), "--record", inputs.path("v"), "--events", inputs.path("v.part")},
              "--events and --record cannot both go to ");
}

TEST(OutputGuard, what_is_gone_on_with_may_be_replaced) {
  const Inputs inputs;
  const std::string save = inputs.path("a.save"), world = inputs.path("world.toml"), part = inputs.path("a.part");
  const std::string before = read(save);
  EXPECT_EQ(physim({"run", world, "--load", save, "--steps", "40", "--save", save}).code, 0);
  EXPECT_NE(read(save), before);
  EXPECT_EQ(physim({"run", world, "--load", save, "--steps", "50", "--save", save}).code, 0) << "it is whole";
  const std::vector<std::string> study = {"study", inputs.path("flat.toml"), "--resume", part};
  std::vector<std::string> more = study;
  more.insert(more.end(), {"--shots", "4096"});
  EXPECT_EQ(physim(more).code, 0);
  more.insert(more.end(), {"--merge", part});
  const Ran merged = physim(more);
  EXPECT_EQ(merged.code, 2);
  EXPECT_TRUE(has(merged.err, "--resume cannot write: it is the part to be merged itself")) << merged.err;
}

}  // namespace physim::cli_output_guard_test
