// Documentation that cannot rot: quoted code is in the examples, quoted output is what the program prints, links lead
// somewhere, and every scenario that ships loads, flies and meets its expectations.
#include <cstdio>
#include <memory>
#include <regex>

#include "cli/program.hpp"
#include "report/gnuplot.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim::docs_docs_test {

namespace fs = std::filesystem;
using testing_cli::lines_of;

const fs::path kRoot = PHYSIM_SOURCE_DIR;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path << " cannot be read";
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

std::vector<fs::path> files_with(const char* ending, const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ending) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> all = files_with(".md", kRoot / "docs");
  for (const char* page : {"README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"}) all.push_back(kRoot / page);
  return all;
}

/// A fenced block with the comment that stands before it: "from examples/batch.cpp", "output of physim run ...".
struct Block {
  std::string language, comment, text;
  std::size_t line = 0;
};

std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks;
  std::string comment;
  bool inside = false;
  const auto lines = lines_of(page);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), comment, "", i + 1});
      comment.clear();
    } else if (inside) {
      blocks.back().text += line + "\n";
    } else if (line.starts_with("<!-- ") && line.ends_with(" -->")) {
      comment = line.substr(5, line.size() - 9);
    } else if (!line.empty()) {
      comment.clear();
    }
  }
  return blocks;
}

std::string without_blocks(const std::string& page) {
  static const std::regex kBlock("```[^`]*```|`[^`\n]*`");
  return std::regex_replace(page, kBlock, "");
}

TEST(Docs, QuotedCodeIsInTheFilesItIsQuotedFrom) {
  for (const fs::path& page : pages())
    for (const Block& block : blocks_of(content_of(page))) {
      const std::string where = page.filename().string() + ":" + std::to_string(block.line);
      const bool from_file = block.comment.starts_with("from ");
      EXPECT_TRUE(from_file || block.language != "cpp") << where << ": C++ without <!-- from FILE -->";
      if (!from_file) continue;
      const fs::path source = kRoot / block.comment.substr(5);
      ASSERT_TRUE(fs::exists(source)) << where << ": " << source;
      EXPECT_NE(content_of(source).find(block.text), std::string::npos) << where << ": not verbatim in " << source;
    }
}

#ifdef PHYSIM_CLI
std::string output_of(const std::string& arguments, const fs::path& folder = kRoot) {
  const std::string command = "cd '" + folder.string() + "' && NO_COLOR=1 '" PHYSIM_CLI "' " + arguments + " 2>&1";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string out;
  char part[4096];
  while (pipe && std::fgets(part, sizeof part, pipe.get())) out += part;
  return out;
}

void expect_printed(const std::vector<std::string>& quoted, const std::string& output, const fs::path& page,
                    const Block& block) {
  const auto printed = lines_of(output);
  for (const std::string& line : quoted) {
    const bool is_printed = line == "..." || std::find(printed.begin(), printed.end(), line) != printed.end();
    EXPECT_TRUE(is_printed) << page.filename() << ":" << block.line << ": not printed: " << line;
  }
}

TEST(Docs, QuotedOutputIsWhatTheProgramPrints) {
  for (const fs::path& page : pages())
    for (const Block& block : blocks_of(content_of(page))) {
      if (!block.comment.starts_with("output of physim ")) continue;
      expect_printed(lines_of(block.text), output_of(block.comment.substr(17)), page, block);
    }
}

TEST(Docs, TheListOfSettingsIsTheProgramsOwn) {
  EXPECT_EQ(content_of(kRoot / "docs" / "settings.md"), output_of("list settings --markdown"))
      << "write it anew: ./dev docs";
}

/// Lines of a table whose last columns differ from machine to machine: each quoted line begins a printed one.
TEST(Docs, QuotedBeginningsOfLinesArePrinted) {
  const std::string kind = "beginnings of lines of physim ";
  for (const fs::path& page : pages())
    for (const Block& block : blocks_of(content_of(page))) {
      if (!block.comment.starts_with(kind)) continue;
      const auto printed = lines_of(output_of(block.comment.substr(kind.size())));
      for (const std::string& line : lines_of(block.text))
        EXPECT_TRUE(std::any_of(printed.begin(), printed.end(), [&](const auto& own) { return own.starts_with(line); }))
            << page.filename() << ":" << block.line << ": not printed: " << line;
    }
}

// A page may give a file, <!-- file NAME -->, and commands with what they print: <!-- output --> before "$ physim ...".
TEST(Docs, CommandsPrintWhatStandsBelowThem) {
  const fs::path folder = fs::path(testing::TempDir()) / "physim_docs_commands";
  int commands = 0;
  for (const fs::path& page : pages()) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    fs::create_directory_symlink(kRoot / "scenarios", folder / "scenarios");
    for (const Block& block : blocks_of(content_of(page))) {
      if (block.comment.starts_with("file ")) std::ofstream(folder / block.comment.substr(5)) << block.text;
      if (block.comment != "output") continue;
      auto lines = lines_of(block.text);
      ASSERT_TRUE(!lines.empty() && lines[0].starts_with("$ physim ")) << page << ":" << block.line;
      const std::string printed = output_of(lines[0].substr(9), folder);
      lines.erase(lines.begin());
      expect_printed(lines, printed, page, block);
      ++commands;
    }
  }
  fs::remove_all(folder);
  EXPECT_GT(commands, 3);
}

/// Commands within the text, `physim ...`, of the page that shows what each test and figure of the thesis is here.
TEST(Docs, CommandsOfTheThesisRun) {
  const fs::path folder = fs::path(testing::TempDir()) / "physim_docs_thesis";
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::create_directory_symlink(kRoot / "scenarios", folder / "scenarios");
  static const std::regex kCommand("`physim ([a-z-]+ [^`]+)`");
  const std::string page = content_of(kRoot / "docs" / "thesis.md");
  int runs = 0, others = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), kCommand), end; match != end; ++match) {
    std::string command = (*match)[1];
    const std::size_t plot = command.find(" --plot ");
    if (plot == std::string::npos) {
      const std::vector<std::string> lines = lines_of(output_of(command + "; echo $?", folder));
      ASSERT_GT(lines.size(), 1U) << command;
      EXPECT_EQ(lines.back(), "0") << command << ": " << lines.front();
      ++others;
      continue;
    }
    ++runs;
    const std::string picture = command.substr(plot + 8);
    if (!report::check_gnuplot()) command.resize(plot);
    const std::vector<std::string> lines = lines_of(output_of(command, folder));
    ASSERT_FALSE(lines.empty()) << command;
    static const std::regex kAllMet(R"(  (\d+) of \1 met)");
    EXPECT_TRUE(std::regex_match(lines.back(), kAllMet)) << command << ": " << lines.back();
    EXPECT_EQ(fs::exists(folder / picture), report::check_gnuplot().ok()) << command;
  }
  EXPECT_EQ(runs, 8) << "six tests, and two as they were expected";
  EXPECT_GT(others, 8) << "what the thesis asked for";
  fs::remove_all(folder);
}
#endif

TEST(Docs, LinksAndPicturesExist) {
  static const std::regex kLink(R"re(\]\(([^)\s]+)\)|src="([^"]+)")re");
  for (const fs::path& page : pages()) {
    const std::string text = without_blocks(content_of(page));
    for (std::sregex_iterator match(text.begin(), text.end(), kLink), end; match != end; ++match) {
      std::string target = (*match)[1].matched ? (*match)[1] : (*match)[2];
      if (target.find("://") != std::string::npos || target.starts_with("#") || target.starts_with("mailto:")) continue;
      target = target.substr(0, target.find('#'));
      EXPECT_TRUE(fs::exists(page.parent_path() / target)) << page << " links to " << target;
    }
  }
}

TEST(Docs, PicturesAreLight) {
  std::uintmax_t total = 0;
  const fs::path folder = kRoot / "docs" / "pictures";
  if (!fs::exists(folder)) GTEST_SKIP() << "no pictures";
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_LT(entry.file_size(), 200'000u) << entry.path();
    total += entry.file_size();
  }
  EXPECT_LT(total, 2'500'000u);
}

/// Runs a scenario that has a [world].
void expect_of_world(const Scenario& scenario) {
  WorldRun run = must(WorldRun::create(scenario));
  for (std::uint64_t step = 0; step < run.steps(); ++step) run.step();
  const std::vector<WorldGroup> groups = run.groups();
  for (const Expectation& expect : scenario.expect)
    for (const WorldGroup& group : groups) {
      if (!expect.shot.empty() && expect.shot != group.name) continue;
      EXPECT_FALSE(expect.source.empty()) << expect.place << ": no source";
      const double value = must(measure(group, expect));
      EXPECT_NEAR(value, expect.equals, expect.within) << expect.place << ": " << group.name << ": " << expect.quantity;
    }
}

TEST(Scenarios, AllMeetTheirExpectations) {
  const auto files = files_with(".toml", kRoot / "scenarios");
  ASSERT_FALSE(files.empty());
  for (const fs::path& file : files) {
    const auto scenario = must(load_scenario(file.string()));
    EXPECT_FALSE(scenario.title.empty()) << file;
    EXPECT_FALSE(scenario.source.empty()) << file;
    EXPECT_FALSE(scenario.expect.empty()) << file << " expects nothing";
    if (scenario.world.given) {
      expect_of_world(scenario);
      continue;
    }
    const SceneParts parts = scene_parts(scenario).value();
    for (const ScenarioShot& shot : scenario.shots) {
      const ProjectileDef& p = shot.projectile;
      const Flight flight = fly_shot(scenario, shot);
      ASSERT_FALSE(flight.error()) << file << ": " << p.name << ": " << flight.error()->text();
      const FlightHits hits = flight_hits(scenario, shot, flight, parts);
      for (const Expectation& expect : scenario.expect) {
        if (!expect.shot.empty() && expect.shot != p.name) continue;
        EXPECT_FALSE(expect.source.empty()) << expect.place << ": no source";
        const double value = must(measure(flight, hits, expect));
        EXPECT_NEAR(value, expect.equals, expect.within) << expect.place << ": " << p.name << ": " << expect.quantity;
      }
    }
  }
}

}  // namespace physim::docs_docs_test
